"""What each command does with its options; the parser is in `symscrew.cli.parser`."""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symscrew.cli.help import FAILED, UsageError

if TYPE_CHECKING:
    from symscrew.description import Mechanism
    from symscrew.effects import Effect
    from symscrew.model import Model


def list_mechanisms(options: argparse.Namespace) -> int:
    """`symscrew list`."""
    from symscrew import catalogue
    from symscrew.display import show

    found = [catalogue.load(name) for name in catalogue.names()]
    rows = [
        {
            "name": m.name,
            "bodies": len(m.bodies) - (m.ground in m.bodies),
            "joints": len(m.joints),
            "driven": sum(len(j.driven) for j in m.joints.values()),
            "description": m.description,
            "source": m.source,
        }
        for m in found
    ]
    if options.json:
        print(json.dumps(rows, indent=1, ensure_ascii=False))
    else:
        header = ("name", "bodies", "joints", "driven", "description")
        show(header, [[str(row[key]) for key in header] for row in rows])
    return 0


def run_demo(options: argparse.Namespace) -> int:
    """`symscrew demo`."""
    from symscrew.display import Progress

    directory = _writable(options.out) if options.out else None
    if directory:
        _need_matplotlib()
    from symscrew.studies.demo import demo_facts, demo_summary, demo_values, run, write_figures

    progress = Progress()
    result = run(progress=progress)
    written = write_figures(result, directory, progress) if directory else []
    if options.json:
        print(json.dumps(demo_values(result), indent=1))
    else:
        print(demo_facts(result))
        print()
        print(demo_summary(result))
        if directory:
            print(f"Written to {directory}: " + ", ".join(path.name for path in written))
        else:
            print("No files were written; `symscrew demo --out DIR` draws figures 7, 8, 9 and 11 into DIR.")
    print(f"done in {progress.elapsed:.1f} s", file=sys.stderr)
    return 0 if result.agrees else FAILED


def start_description(options: argparse.Namespace) -> int:
    """`symscrew new`."""
    from symscrew.description import write_template

    print(write_template(options.name, options.limbs, options.out or f"{options.name}.toml"))
    return 0


def generate_code(options: argparse.Namespace) -> int:
    """`symscrew generate`."""
    from symscrew.display import Progress, show
    from symscrew.generation import TARGETS, USUAL, generate, printable, with_brought

    single = options.precision == "single"
    targets = [t for t in TARGETS if t in (options.target or (["c"] if single else USUAL))]
    if options.embedded and "c" not in with_brought(targets):
        raise UsageError("--embedded measures C; add it to --target")
    possible = printable(options.precision)
    doubles = [t for t in targets if t not in possible]
    if single and doubles:
        raise UsageError(f"--precision single: {doubles[0]} is double only; expected {' or '.join(possible)}")
    progress = Progress()
    model = _chosen_functions(options, _derived(options, progress))
    measured = []
    for core in dict.fromkeys(options.embedded):
        from symscrew.verification import measure

        with progress.step(f"measure on {core}"):
            measured.append(measure(model, core, options.precision))
    with progress.step(f"write {', '.join(targets)} to {options.out}"):
        files = generate(
            model, options.out, targets, precision=options.precision, measured=measured, hashes_only=options.hashes_only
        )
    print(f"{model.name}: {len(model.programs)} functions, {len(files)} files in {options.out}")
    rows = [[name, str(p.operations["total"])] for name, p in model.programs.items()]
    show(("function", "operations"), rows)
    for note in model.notes:
        print(f"note: {note}")
    return 0


def _chosen_functions(options: argparse.Namespace, model: Model) -> Model:
    """The model with the functions that the options name, or all."""
    from symscrew.errors import did_you_mean

    for name in options.functions or ():
        if name not in model.programs:
            raise UsageError(f"--functions: no {name!r} in {model.name}; {did_you_mean(name, model.programs)}")
    return model.only(options.functions) if options.functions else model


def _derived(options: argparse.Namespace, progress: object) -> Model:
    """The model of the mechanism and effects that the options name; all bad input ends here."""
    from symscrew import catalogue
    from symscrew.display import Progress
    from symscrew.model import derive

    assert isinstance(progress, Progress)
    with progress.step(f"read {options.mechanism}"):
        mechanism = catalogue.find(options.mechanism)
        effects = _chosen_effects(options, mechanism)
    with progress.step(f"derive {mechanism.name}"):
        return derive(
            mechanism,
            effects,
            independent=options.independent,
            length=options.length,
            derivatives=options.derivatives,
            regressor=options.regressor,
            one_mode=options.one_mode,
        )


def _chosen_effects(options: argparse.Namespace, mechanism: Mechanism) -> list[Effect]:
    from symscrew.effects import Gravity
    from symscrew.errors import did_you_mean

    effects: list[Effect] = []
    if getattr(options, "effects", None):
        from symscrew.effects import load_effects

        if options.load or options.gravity or options.no_gravity:
            raise UsageError("--effects: the file says all that acts; leave --gravity, --no-gravity and --load out")
        return list(load_effects(options.effects))
    if not options.no_gravity:
        gravity = Gravity(tuple(options.gravity)) if options.gravity else Gravity()
        try:
            _ = gravity.exact
        except ValueError as error:
            raise UsageError(str(error)) from error
        effects.append(gravity)
    for point in dict.fromkeys(options.load):
        from symscrew.effects import ExternalWrench

        if point not in mechanism.points:
            raise UsageError(f"--load: no point {point!r} in {mechanism.name}; {did_you_mean(point, mechanism.points)}")
        effects.append(ExternalWrench(point))
    return effects


def check_output(options: argparse.Namespace) -> int:
    """`symscrew check`."""
    from symscrew.display import Progress
    from symscrew.verification import check

    progress = Progress()
    with progress.step(f"check {options.directory}"):
        result = check(options.directory)
    if options.json:
        print(json.dumps({"ok": result.ok, "lines": result.lines}, indent=1, ensure_ascii=False))
    else:
        print("\n".join(result.lines))
        print("all checks passed" if result.ok else "FAILED")
    return 0 if result.ok else FAILED


def bill_of_effects(options: argparse.Namespace) -> int:
    """`symscrew cost`."""
    if options.plot:
        _need_matplotlib()
    from symscrew.studies import run

    return run(options)


def study_accuracy(options: argparse.Namespace) -> int:
    """`symscrew accuracy`."""
    from symscrew.cli.accuracy_command import run

    return run(options)


def report_mobility(options: argparse.Namespace) -> int:
    """`symscrew mobility`."""
    from symscrew.cli.mobility_command import run

    return run(options)


def convert_description(options: argparse.Namespace) -> int:
    """`symscrew convert`."""
    from symscrew import catalogue
    from symscrew.formats import WRITERS, save_as

    path = Path(options.out)
    if path.suffix not in WRITERS:
        raise UsageError(f"--out: expected a name that ends in {', '.join(WRITERS)}, got {options.out!r}")
    mechanism = catalogue.find(options.mechanism)
    _writable(str(path.parent))
    save_as(mechanism, path)
    print(path)
    for note in mechanism.source.split("; ")[1:] if mechanism.source.startswith("imported from") else ():
        print(f"note: {note}", file=sys.stderr)
    return 0


def simulate_scene(options: argparse.Namespace) -> int:
    """`symscrew simulate`."""
    from symscrew.cli.simulate_command import run

    return run(options)


def pack_unit(options: argparse.Namespace) -> int:
    """`symscrew fmu`."""
    from symscrew.cli.fmu_command import run

    return run(options)


def optimise_trajectory(options: argparse.Namespace) -> int:
    """`symscrew optimise`."""
    from symscrew.cli.optimise_command import run

    return run(options)


def draw_mechanism(options: argparse.Namespace) -> int:
    """`symscrew draw`."""
    from symscrew import catalogue

    path = Path(options.out)
    if path.suffix != ".png":
        raise UsageError(f"--out: expected a file name that ends in .png, got {options.out!r}")
    mechanism = catalogue.find(options.mechanism)
    _writable(str(path.parent))
    _need_matplotlib()
    from symscrew.display import mechanism_figure, save_figure

    print(save_figure(mechanism_figure(mechanism), path, tight=True))
    return 0


def report_mechanism(options: argparse.Namespace) -> int:
    """`symscrew report`."""
    _need_matplotlib()
    from symscrew.cli.report_command import run

    return run(options, _chosen_effects)


def map_workspace(options: argparse.Namespace) -> int:
    """`symscrew workspace`."""
    from symscrew.cli.workspace_command import run

    return run(options, _chosen_effects)


def view_mechanism(options: argparse.Namespace) -> int:
    """`symscrew view`."""
    from symscrew.display import Progress, open_page, read, write_page
    from symscrew.model import derive

    if options.out and Path(options.out).suffix != ".html":
        raise UsageError(f"--out: expected a file name that ends in .html, got {options.out!r}")
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism, motion = read(options.mechanism)
        effects = _chosen_effects(options, mechanism)
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism, effects, independent=options.independent)
    if options.out is None:
        print(open_page(model, motion))
    else:
        _writable(str(Path(options.out).parent))
        print(write_page(model, options.out, motion))
    return 0


def run_benchmark(options: argparse.Namespace) -> int:
    """`symscrew benchmark`."""
    from symscrew.cli.benchmark_command import run

    return run(options)


def measure_embedded(options: argparse.Namespace) -> int:
    """`symscrew embedded`."""
    from symscrew.cli.embedded_command import run

    return run(options)


def report_installation(options: argparse.Namespace) -> int:
    """`symscrew doctor`."""
    from symscrew.display import installation, show

    rows = installation()
    if options.json:
        keys = ("part", "found", "for", "to get it")
        print(json.dumps([dict(zip(keys, row, strict=True)) for row in rows], indent=1))
        return 0
    show(("part", "found", "for", "to get it"), rows)
    return 0


def _writable(directory: str) -> Path:
    """The directory, made if it is not there, in which a file can be created."""
    path = Path(directory)
    if "\0" in directory:
        raise UsageError("--out: a path must not contain a null character")
    path.mkdir(parents=True, exist_ok=True)
    if not os.access(path, os.W_OK | os.X_OK):
        raise UsageError(f"{directory}: no permission to write here")
    return path


def _need_matplotlib() -> None:
    import importlib.util

    if importlib.util.find_spec("matplotlib") is None:
        raise UsageError('figures need matplotlib, which is not installed: pip install "symscrew[plot]"')
