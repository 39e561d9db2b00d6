"""`symscrew workspace`."""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from pathlib import Path

from tqdm import tqdm

from symscrew import catalogue
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.studies.workspace import (
    AZIMUTH,
    MOST_CASES,
    TILT,
    Plan,
    Results,
    Store,
    prepare,
    read_axis,
    read_limit,
    read_number,
    run_locally,
    run_on_dask,
    save_csv,
    save_npz,
    summary,
    summary_text,
)
from symscrew.whole_files import replaced

FAILED = 1


def run(options: argparse.Namespace, chosen) -> int:  # type: ignore[no-untyped-def]
    """Read, sweep, write; `chosen(options, mechanism)` are the effects. 1 if an expected tilt is not reached."""
    out = Path(options.out)
    single = out.suffix in (".npz", ".csv")
    if out.suffix and not single:
        raise DescriptionError(
            f"--out: expected a folder or a file name that ends in .npz or .csv, got {shorten(options.out)}"
        )
    if not out.parent.is_dir():
        raise DescriptionError(f"--out: no folder {shorten(str(out.parent), 200)} to write into")
    expected = read_number(options.expect_tilt, "--expect-tilt") if options.expect_tilt else None
    plan = read_plan(options, chosen)
    if expected is not None and not {TILT, AZIMUTH} <= {axis.name for axis in plan.axes}:
        raise DescriptionError(
            "--expect-tilt needs the axes tilt and azimuth: --over tilt=0:20deg:21 azimuth=0:360deg:73"
        )
    made = prepare(plan)
    folder = out.with_name(f".{out.name}.pieces") if single else out / "pieces"
    if out.is_dir() and not folder.is_dir() and any(out.iterdir()):
        raise DescriptionError(f"--out: {shorten(options.out)} is not empty and holds no sweep; use another one")
    kept = Store(folder, plan)
    sweep(plan, kept, scheduler=options.dask, processes=options.processes)
    results = kept.whole()
    found = summary(plan, results, made.units)
    if single:
        written = [(save_npz if out.suffix == ".npz" else save_csv)(out, results)]
    else:
        written = [save_npz(out / "workspace.npz", results), save_csv(out / "workspace.csv", results)]
        content = json.dumps(found, indent=1) + "\n"
        written.append(replaced(out / "summary.json", lambda part: part.write_text(content, encoding="utf-8")))
        if picture := _picture(plan, results, made.units, out / "workspace.png"):
            written.append(picture)
    shutil.rmtree(folder)
    print(json.dumps(found, indent=1) if options.json else summary_text(found))
    print("wrote " + ", ".join(map(str, written)), file=sys.stderr)
    if expected is None:
        return 0
    return 0 if found["tilt"]["every_direction"] >= expected * (1 - 1e-12) else FAILED


def read_plan(options: argparse.Namespace, chosen) -> Plan:  # type: ignore[no-untyped-def]
    """The plan that the options describe; raises DescriptionError."""
    axes = tuple(read_axis(item) for item in options.over or ())
    tolerances = []
    for item in options.tolerance or ():
        name, equals, value = item.partition("=")
        sigma = read_number(value, "--tolerance") if equals else -1.0
        if sigma <= 0:
            raise DescriptionError(f"--tolerance: expected PARAMETER=standard deviation above 0, got {shorten(item)}")
        tolerances.append((name.strip(), sigma))
    samples = options.samples if tolerances else 1
    if not 1 <= samples <= 1_000_000:
        raise DescriptionError(f"--samples: expected a number from 1 to 1000000, got {samples}")
    mechanism = catalogue.find(options.mechanism)
    for name, _ in tolerances:
        if name not in mechanism.parameters:
            raise DescriptionError(f"--tolerance: no parameter {name!r}; {did_you_mean(name, mechanism.parameters)}")
    varied = tuple(
        dict.fromkeys(n for n in (*(a.name for a in axes), *(n for n, _ in tolerances)) if n in mechanism.parameters)
    )
    mechanism = catalogue.find(options.mechanism, run_time=varied) if varied else mechanism
    plan = Plan(
        mechanism,
        tuple(chosen(options, mechanism)),
        axes,
        tuple(options.independent) if options.independent else None,
        tuple(tolerances),
        samples,
        options.seed,
        tuple(read_limit(item) for item in options.limit or ()),
        read_number(options.stiffness, "--stiffness"),
        parameters=varied,
    )
    if not axes and not tolerances:
        raise DescriptionError(
            "nothing to sweep: give --over COORDINATE=from:to:count, or --tolerance PARAMETER=deviation"
        )
    if plan.count > MOST_CASES:
        raise DescriptionError(f"{plan.count} cases; at most {MOST_CASES // 10**6} million are computed in one sweep")
    return plan


def sweep(plan: Plan, kept: Store, *, scheduler: str | None = None, processes: int | None = None) -> None:
    """Compute the pieces that are missing, with a bar on a terminal, and store each as it is done."""
    there = kept.done()
    left = [k for k in range(plan.chunks) if k not in there]
    if there:
        print(f"{len(there)} of {plan.chunks} pieces are there already", file=sys.stderr)
    work = run_on_dask(plan, left, scheduler) if scheduler else run_locally(plan, left, processes)
    with tqdm(total=plan.chunks, initial=len(there), unit="piece", disable=not sys.stderr.isatty(), leave=False) as bar:
        for number, results in work:
            kept.put(number, results)
            bar.update()


def _picture(plan: Plan, results: Results, units, path: Path) -> Path | None:  # type: ignore[no-untyped-def]
    import importlib.util

    if importlib.util.find_spec("matplotlib") is None:
        return None
    from symscrew.studies.workspace import draw_maps

    return draw_maps(plan, results, units, path)
