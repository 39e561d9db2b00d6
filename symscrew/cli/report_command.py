"""`symscrew report`: one document on a mechanism, with what studies found.

mechanism, effects --derive--> model --compile, time--> calls, times --document--> .html or .md
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from symscrew.cli.drives_command import add_motion, motion_of_options
from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import (
    add_effects,
    add_mechanism,
    add_no_cache,
    chosen_effects,
    find_mechanism,
    need_matplotlib,
)
from symscrew.errors import shorten
from symscrew.whole_files import destination

EXAMPLES = (
    "symscrew report three_ups_upu_s --out seed.html",
    "symscrew report wrist.toml --out wrist.md --scene scene.toml --accuracy study",
    "symscrew report delta --out delta.html --motion 'platform.z=-0.05*sin(t)' platform.x=0 platform.y=0 --duration 6",
    "symscrew report three_ups_upu_s --out seed.html --over tilt=0:20deg:11 azimuth=0:360deg:25",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew report`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="FILE", required=True, help="the report: .html (one file) or .md")
    add_effects(command)
    command.add_argument("--accuracy", metavar="DIR", help="results of `symscrew accuracy` to include")
    command.add_argument("--scene", metavar="SCENE", help="a scene whose bill of effects to include")
    add_motion(command, required=False)
    command.add_argument("--over", nargs="+", metavar="NAME=FROM:TO:COUNT", help="a map of the workspace to include")
    command.add_argument("--no-timing", action="store_true", help="count only: no function is timed")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, derive, measure, write."""
    need_matplotlib()
    from symscrew.display import Progress
    from symscrew.model import derive
    from symscrew.reporting import document, write_document
    from symscrew.runtime import load
    from symscrew.scene import load_scene
    from symscrew.studies import Times, scene_bill, time_every_function
    from symscrew.studies.workspace import calls_of, workspace

    path = destination(options.out, (".html", ".md"), "--out")
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism = find_mechanism(options.mechanism, acting=not options.effects)
        effects = chosen_effects(options, mechanism)
        scene = load_scene(options.scene) if options.scene else None
    if scene is not None and scene.mechanism.name != mechanism.name:
        raise UsageError(f"--scene: is about {scene.mechanism.name}, but the report about {mechanism.name}")
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism, effects)
    along = None
    if options.motion:
        from symscrew.studies.given_motion import drives

        along = drives(mechanism, motion_of_options(options, mechanism), effects, progress=progress)
    sweep = workspace(mechanism, _axes(options.over), effects=effects) if options.over else None
    call, measured = None, None
    if not options.no_timing:
        with progress.step("compile"):
            compiled = load(model)
        call, measured = calls_of(compiled), dict[str, Times]()
        if compiled.backend == "c":  # without a compiler there is nothing whose time is worth a line
            with progress.step("time"):
                measured = time_every_function(model, compiled)
    bill = scene_bill(scene, timed=not options.no_timing, progress=progress) if scene is not None else None
    accuracy = Path(options.accuracy) if options.accuracy else None
    made = document(
        model, call=call, times=measured, accuracy=accuracy, bill=bill, motion=along, sweep=sweep, progress=progress
    )
    for file in write_document(made, path):
        print(file)
    return DONE


def _axes(texts: Sequence[str]) -> dict[str, str]:
    """Axis -> values, of `--over`."""
    found = dict[str, str]()
    for text in texts:
        name, equals, values = text.partition("=")
        if not equals or name in found:
            raise UsageError(f"--over: expected NAME=FROM:TO:COUNT, each name once, got {shorten(text)}")
        found[name] = values
    return found
