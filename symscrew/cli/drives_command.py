"""`symscrew drives`: a motion in, tables out: joints, rates, drives, reactions, margins."""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import (
    add_effects,
    add_mechanism,
    add_no_cache,
    check_folder,
    chosen_effects,
    find_mechanism,
    keep_inputs,
    no_matplotlib,
)

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.studies.given_motion import WantedMotion

EXAMPLES = (
    "symscrew drives three_ups_upu_s --motion examples/motions/section_5.toml --out section_5",
    "symscrew drives delta --motion 'platform.x=0.05*sin(2*t)' platform.y=0 'platform.z=0.02*t' --duration 3",
    "symscrew drives delta --motion poses.csv --out tables --json",
)
MOTION = (
    "a file: .toml (expressions or a twist; loads), .csv or .npz (samples over t); or NAME=EXPRESSION in t, several: a "
    "coordinate, platform.x .y .z, .rx .ry .rz, .qw .qx .qy .qz, or POINT.x .y .z"
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew drives`."""
    add_mechanism(command)
    add_motion(command, required=True)
    command.add_argument("--out", metavar="DIR", help="motion.npz (for `symscrew view`), motion.csv, pictures, JSON")
    command.add_argument("--json", action="store_true", help="the numbers as JSON")
    add_effects(command)
    add_no_cache(command)


def add_motion(command: argparse.ArgumentParser, *, required: bool) -> None:
    """A motion by a file or by expressions; `motion_of_options` reads it."""
    command.add_argument("--motion", nargs="+", required=required, metavar="FILE|NAME=EXPR", help=MOTION)
    command.add_argument("--duration", type=float, metavar="S", help="seconds, with expressions")
    command.add_argument("--rate", type=float, metavar="HZ", help="samples per second, with expressions; default: 100")


def run(options: argparse.Namespace) -> int:
    """Read, follow, compute, compare, write; 1 where another method does not give the same."""
    from symscrew.display import Progress, print_text
    from symscrew.studies.given_motion import FILES, drives, study_json, study_text, write_study

    if options.out:
        check_folder(options.out)
        keep_inputs([Path(options.out, name) for name in FILES], [options.mechanism, *options.motion])
    mechanism = find_mechanism(options.mechanism, acting=not options.effects)
    effects = chosen_effects(options, mechanism)
    if options.load:
        raise UsageError("--load: give the wrench in the motion's file, [loads.POINT] with fx ... mz as expressions")
    wanted = motion_of_options(options, mechanism)
    found = drives(mechanism, wanted, effects, progress=Progress())
    if options.json:
        print(json.dumps(study_json(found), indent=1))
    else:
        print_text(study_text(found))
    if options.out:
        missing = no_matplotlib()
        for path in write_study(found, Path(options.out), drawn=not missing):
            print(f"wrote {path}", file=sys.stderr)
        if missing:
            print(f"no pictures: matplotlib {missing}", file=sys.stderr)
    return DONE if found.ok else FAILED


def motion_of_options(options: argparse.Namespace, mechanism: Mechanism) -> WantedMotion:
    """The motion that the options of `add_motion` name."""
    from symscrew.studies.given_motion import load_motion, motion_of

    expressions = dict[str, str]()
    for item in options.motion:
        name, equals, text = item.partition("=")
        if equals and not os.path.isfile(item):  # an expression may be longer than any name of a file
            if name.strip() in expressions:
                raise UsageError(f"--motion: {name.strip()} is given twice")
            expressions[name.strip()] = text
    if expressions and len(expressions) != len(options.motion):
        raise UsageError("--motion: expected one file, or NAME=EXPRESSION for each name")
    if not expressions:
        if len(options.motion) > 1:
            raise UsageError(f"--motion: expected one file, got {len(options.motion)}")
        if options.duration is not None or options.rate is not None:
            raise UsageError("--duration and --rate are for expressions; a file says its own")
        return load_motion(options.motion[0], mechanism)
    if options.duration is None:
        raise UsageError("--duration is missing: how many seconds the motion takes")
    rate = {} if options.rate is None else {"rate": options.rate}
    return motion_of(expressions, mechanism, duration=options.duration, **rate)
