"""`symscrew workspace`: a sweep over coordinates and parameters, as a folder or one file, and its summary.

options --read_plan--> Plan --sweep (pieces, in parallel)--> Store --> results, summary, maps
                       Plan --run_certificate--> boxes with a proof, summary, picture
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import (
    add_effects,
    add_independent,
    add_mechanism,
    add_no_cache,
    check_folder,
    chosen_effects,
    find_mechanism,
    no_matplotlib,
)
from symscrew.errors import shorten
from symscrew.whole_files import discard, write_text

if TYPE_CHECKING:
    from symscrew.studies.workspace import Plan, Results, Store

EXAMPLES = (
    "symscrew workspace three_ups_upu_s --over tilt=0:20deg:21 azimuth=0:360deg:73 --expect-tilt 10deg --out seed",
    "symscrew workspace ur5 --over elbow=-150deg:150deg:121 --out elbow.csv",
    "symscrew workspace wrist.toml --over R=0.4:0.6:21 --tolerance r=1mm --samples 1000 --out study",
    "symscrew workspace three_ups_upu_s --certify --over tilt=0:10deg azimuth=0:360deg --expect-tilt 10deg --out proof",
)
OVER = (
    "an axis: a parameter or a coordinate, of any joint (limb1_P) or of a body (tilt, azimuth, z, roll ... are the "
    "platform's); numbers in m, mm, rad, deg"
)
LIMIT = (
    "what is allowed of a joint (limb1_P=-50mm:50mm), a drive at rest ('drive limb1_P=-500:500' [N, N m]), "
    "condition, margin or another result"
)
CERTIFY = (
    "prove in boxes what a sweep samples: one configuration, no singularity, no passed limit; N is then how fine boxes "
    "get, (TO - FROM)/(N - 1), and may be left out"
)
FINEST = {1: 257, 2: 65}  # N where none is given, by the number of axes: thousands of boxes at most along an edge ...
FINEST_OF_MORE = 17  # ... and the same in three dimensions and more
TOLERANCE = "a parameter with the standard deviation of its normal distribution"
ROUNDING = 1e-12  # of a tilt in degrees turned into radians twice: a tilt as expected is not missed by this part
PROVED_PART = 1e-8  # of a tilt by which claims are rounded down: the tilt asked for is not missed by it


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew workspace`."""
    add_mechanism(command)
    command.add_argument("--over", nargs="+", metavar="COORD=FROM:TO:N", help=OVER)
    command.add_argument("--out", metavar="DIR|FILE", required=True, help="a new folder, or a file: .npz or .csv")
    command.add_argument("--limit", nargs="+", metavar="RESULT=MIN:MAX", help=LIMIT)
    command.add_argument("--tolerance", nargs="+", metavar="PARAM=SIGMA", help=TOLERANCE)
    command.add_argument("--certify", action="store_true", help=CERTIFY)
    text = "per place, with --tolerance; default 100"
    command.add_argument("--samples", type=int, default=100, metavar="N", help=text)
    command.add_argument("--seed", type=int, default=0, metavar="N", help="of the random numbers; default 0")
    command.add_argument("--expect-tilt", metavar="ANGLE", help="exit 1 unless this tilt is reached in every direction")
    command.add_argument("--stiffness", default="1e6", metavar="K", help="of a drive [N/m]; default 1e6")
    command.add_argument("--mode", default="", metavar="NAME", help="assembly mode (`symscrew assemble` lists them)")
    add_independent(command)
    add_effects(command)
    command.add_argument("--processes", type=int, metavar="N", help="default: one per core")
    text = "cuda, jax, c or casadi; default: the fastest that is there"
    command.add_argument("--engine", default="", metavar="NAME", help=text)
    command.add_argument("--dask", metavar="ADDRESS", help="of a Dask scheduler, to run there: tcp://host:8786")
    command.add_argument("--json", action="store_true", help="the summary as JSON")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, sweep, write, print; 1 if an expected tilt is not reached."""
    from symscrew.display import print_text
    from symscrew.studies.workspace import (
        AZIMUTH,
        TILT,
        all_around,
        around_holes,
        check_drawn,
        held_store,
        prepare_sweep,
        sweep_summary,
        sweep_summary_text,
    )

    out = Path(options.out)
    endings = (".json",) if options.certify else (".npz", ".csv")
    single = out.suffix in endings
    if out.suffix and not single:
        raise UsageError(
            f"--out: expected a folder or a file name that ends in {' or '.join(endings)}, got {shorten(options.out)}"
        )
    if not out.parent.is_dir():
        raise UsageError(f"--out: no folder {shorten(str(out.parent), 200)} to write into")
    check_folder(out.parent if single else out)
    expected = _in_unit(options.expect_tilt, "--expect-tilt", "rad") if options.expect_tilt else None
    if options.certify:
        return run_certificate(options, out, expected)
    folder = out.with_name(f".{out.name}.pieces") if single else out / "pieces"
    if out.is_dir() and not folder.is_dir() and any(out.iterdir()):
        raise UsageError(f"--out: {shorten(options.out)} is not empty and holds no sweep; use another one")
    plan = read_plan(options)
    if expected is not None and not {TILT, AZIMUTH} <= {axis.name for axis in plan.axes}:
        raise UsageError("--expect-tilt needs the axes tilt and azimuth: --over tilt=0:20deg:21 azimuth=0:360deg:73")
    if expected is not None and not all_around(plan):
        raise UsageError("--expect-tilt: expected tilt from 0 and azimuth over a whole turn, azimuth=0:360deg:73")
    made = prepare_sweep(plan)
    check_drawn(plan, made.model.mechanism)
    _tell_far(plan, made.units)
    with held_store(folder, plan) as kept:
        sweep(plan, kept, scheduler=options.dask, processes=options.processes)
        results = around_holes(plan, kept.whole())
        found = sweep_summary(plan, results, made.units, made.engine.text)
        written = _written(out, plan, results, found=found, units=made.units)
        discard(folder)
    if options.json:
        print(json.dumps(found, indent=1))
    else:
        print_text(sweep_summary_text(found))
    print("wrote " + ", ".join(map(str, written)), file=sys.stderr)
    if expected is None:
        return DONE
    every = found["tilt"]["every_direction"]  # None where not even upright is allowed
    return DONE if every is not None and every >= expected * (1 - ROUNDING) else FAILED


def _tell_far(plan: Plan, units: Mapping[str, str]) -> None:
    """Notes on ends of axes that look like another unit's."""
    from symscrew.description import GivenValue, exact

    for axis in plan.axes:
        far = GivenValue(exact(max(axis.low, axis.high, key=abs)), axis.unit)
        if notice := far.notice(units.get(axis.name, ""), axis.name):
            print(f"note: {notice}", file=sys.stderr)


def _written(
    out: Path, plan: Plan, results: Results, *, found: Mapping[str, Any], units: Mapping[str, str]
) -> list[Path]:
    """The one file that was asked for, or arrays, table, summary and maps in a folder."""
    from symscrew.studies.workspace import save_csv, save_npz

    if out.suffix:
        return [(save_npz if out.suffix == ".npz" else save_csv)(out, results)]
    written = [save_npz(out / "workspace.npz", results), save_csv(out / "workspace.csv", results)]
    written.append(write_text(out / "summary.json", json.dumps(found, indent=1) + "\n"))
    picture = _picture(plan, results, units, out / "workspace.png")
    return written if picture is None else [*written, picture]


def read_plan(options: argparse.Namespace) -> Plan:
    """The plan that the options describe; raises UsageError or DescriptionError."""
    from symscrew import catalogue
    from symscrew.studies.workspace import Plan, check_numbers, read_axis, read_limit, read_quantity

    finest = FINEST.get(len(options.over or ()), FINEST_OF_MORE) if options.certify else None
    axes = tuple(read_axis(item, finest) for item in options.over or ())
    tolerances, typed = [], []
    for item in options.tolerance or ():
        name, equals, value = item.partition("=")
        sigma, unit = read_quantity(value, "--tolerance") if equals else (-1.0, "")
        if sigma <= 0:
            raise UsageError(f"--tolerance: expected PARAMETER=standard deviation above 0, got {shorten(item)}")
        tolerances.append((name.strip(), sigma))
        typed.append(("--tolerance", name.strip(), unit))
    limits = [read_limit(item) for item in options.limit or ()]
    typed += [("--limit", limit[0], unit) for limit, unit in limits]
    samples = options.samples if tolerances else 1
    mechanism = find_mechanism(options.mechanism, acting=not options.effects)
    varied = tuple(
        dict.fromkeys(n for n in (*(a.name for a in axes), *(n for n, _ in tolerances)) if n in mechanism.parameters)
    )
    mechanism = catalogue.find(options.mechanism, run_time=varied) if varied else mechanism
    plan = Plan(
        mechanism,
        tuple(chosen_effects(options, mechanism)),
        axes,
        tuple(options.independent) if options.independent else None,
        tuple(tolerances),
        samples,
        options.seed,
        tuple(limit for limit, _ in limits),
        _in_unit(options.stiffness, "--stiffness", "N/m"),
        parameters=varied,
        typed=tuple(typed),
        mode=options.mode,
        engine=options.engine,
    )
    if options.mode and options.certify:
        raise UsageError("--mode: certificates begin in the reference configuration; leave one of both out")
    if options.engine and options.certify:
        raise UsageError("--engine: certificates evaluate bounds in an arithmetic of their own; leave one of both out")
    check_numbers(plan, options.processes, certify=options.certify)
    return plan


def _in_unit(text: str, option: str, wanted: str) -> float:
    """A number in this SI unit; raises UsageError where another one is typed."""
    from symscrew.studies.workspace import read_quantity

    value, unit = read_quantity(text, option)
    if unit not in ("", wanted):
        raise UsageError(f"{option}: expected a number in {wanted} or a unit of its kind, got {shorten(text)}")
    return value


def run_certificate(options: argparse.Namespace, out: Path, expected: float | None) -> int:
    """Prove, write, print; 1 where nothing is proved, the checker refuses it, or an expected tilt is not proved."""
    from symscrew.display import bar_on_terminal, print_text
    from symscrew.studies.certificate import certificate_text, certify, draw_certificate

    if options.dask:
        raise UsageError("--certify runs on this machine: leave out --dask")
    plan = read_plan(options)
    if expected is not None and not {"tilt", "azimuth"} <= {axis.name for axis in plan.axes}:
        raise UsageError("--expect-tilt needs the axes tilt and azimuth: --over tilt=0:20deg azimuth=0:360deg")
    if out.is_dir() and any(out.iterdir()):
        raise UsageError(f"--out: {shorten(options.out)} is not empty; use another one")
    with bar_on_terminal(unit="box") as bar:
        found = certify(plan, bar.update)
    written = []
    if out.suffix:
        written += [found.write(out)] if found.ok else []
    else:
        out.mkdir(exist_ok=True)
        written += [found.write(out / "certificate.json")] if found.ok else []
        written.append(write_text(out / "summary.json", json.dumps(found.summary, indent=1) + "\n"))
        if not no_matplotlib():
            written.append(draw_certificate(found, out / "certificate.png"))
    if options.json:
        print(json.dumps(found.summary, indent=1))
    else:
        print_text(certificate_text(found.summary))
    print("wrote " + ", ".join(map(str, written)) if written else "no file is written", file=sys.stderr)
    tilt = found.summary.get("tilt", {}).get("every_direction", 0.0)  # 0: not even upright is inside of what is proved
    reached = expected is None or (tilt > 0 and tilt >= expected * (1 - PROVED_PART))
    return DONE if found.ok and reached else FAILED


def sweep(plan: Plan, kept: Store, *, scheduler: str | None = None, processes: int | None = None) -> None:
    """Compute the pieces that are missing, with a bar on a terminal, and store each as it is done."""
    from symscrew.display import bar_on_terminal
    from symscrew.studies.workspace import run_locally, run_on_dask

    there = kept.done()
    left = [k for k in range(plan.chunks) if k not in there]
    if there:
        print(f"{len(there)} of {plan.chunks} pieces are there already", file=sys.stderr)
    work = run_on_dask(plan, left, scheduler) if scheduler else run_locally(plan, left, processes)
    with bar_on_terminal(total=plan.chunks, initial=len(there), unit="piece") as bar:
        for number, results in work:
            kept.put(number, results)
            bar.update()


def _picture(plan: Plan, results: Results, units: Mapping[str, str], path: Path) -> Path | None:
    """The maps as a picture, where matplotlib is installed: a sweep is worth having without it."""
    if no_matplotlib():
        return None
    from symscrew.studies.workspace import draw_maps

    return draw_maps(plan, results, units, path)
