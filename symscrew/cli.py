"""The command line: `symscrew list | demo | generate | check | mobility | convert | simulate | optimise | view | doctor`.

Results go to stdout, progress and errors to stderr. Exit code 0: done; 1: a check failed or a function
reported an error; 2: the input cannot be used, said in one line, and nothing has been written.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from symscrew import __version__

if TYPE_CHECKING:
    from symscrew.effects import Effect
    from symscrew.mechanism import Mechanism
    from symscrew.model import Model

FAILED, BAD_INPUT, INTERRUPTED = 1, 2, 130
TARGETS = ("c", "casadi", "numpy", "external", "markdown")
USUAL = ("c", "casadi", "numpy")


class UsageError(ValueError):
    """Bad input that the command line itself finds."""


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line on stderr and exit code 2."""

    def error(self, message: str) -> NoReturn:
        """End with the message."""
        raise UsageError(f"{message}; see {self.prog} --help")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    try:
        options = parser().parse_args(arguments)
        return int(options.command(options) or 0)
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED)
    except BrokenPipeError:
        # whoever reads our output has gone; what is still buffered must not raise again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILED
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return _fail(f"{where}{error.strerror or error}", BAD_INPUT)
    except ValueError as error:
        if not _is_input_error(error):
            raise
        return _fail(error, BAD_INPUT)
    except (ArithmeticError, RuntimeError) as error:
        if not _is_failure(error):
            raise
        return _fail(error, FAILED)


def _is_input_error(error: Exception) -> bool:
    """Errors that are the input's fault; any other is a defect of ours and keeps its traceback."""
    from symscrew.errors import DescriptionError

    if isinstance(error, (UsageError, DescriptionError)):
        return True
    from symscrew.manifest import OutputError

    return isinstance(error, OutputError)


def _is_failure(error: Exception) -> bool:
    from symscrew.compiled import CompileError, EvaluationError

    return isinstance(error, (CompileError, EvaluationError))


def _fail(message: object, code: int) -> int:
    from symscrew.console import one_line

    print(f"symscrew: error: {one_line(message)}", file=sys.stderr)
    return code


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = Parser(prog="symscrew", description="Symbolic models of mechanisms on screw theory, with code export.")
    top.add_argument("--version", action="version", version=f"symscrew {__version__}")
    top.set_defaults(command=_help(top))
    commands = top.add_subparsers(title="commands", metavar="COMMAND")

    found = _command(commands, "list", list_mechanisms, "the mechanisms that come with the package")
    found.add_argument("--json", action="store_true", help="as JSON")

    demo = _command(commands, "demo", run_demo, "the whole job on the source paper's mechanism")
    demo.add_argument("--out", metavar="DIR", help="write figures and a summary here; nothing is written without it")
    demo.add_argument("--json", action="store_true", help="numbers as JSON instead of the tables")

    generate = _command(commands, "generate", generate_code, "C, CasADi and NumPy functions of a mechanism")
    _mechanism(generate)
    generate.add_argument("--out", metavar="DIR", required=True, help="a new, empty or earlier generated directory")
    text = "default: c casadi numpy; external: C for casadi.external, with derivatives; markdown: formulas to read"
    generate.add_argument("--target", nargs="+", choices=TARGETS, help=text)
    generate.add_argument(
        "--precision", choices=("double", "single"), default="double", help="single: C of type float, no other target"
    )
    _effects(generate)
    generate.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")
    generate.add_argument("--length", metavar="METRES", help="characteristic length for norms of mixed quantities")
    generate.add_argument("--derivatives", action="store_true", help="also derivatives and the linearisation")
    generate.add_argument("--regressor", action="store_true", help="also regressors of the inertial parameters")

    check = _command(commands, "check", check_output, "is generated output up to date, clean and right?")
    check.add_argument("directory", metavar="DIR", help="generated output, or a directory of such")
    check.add_argument("--json", action="store_true", help="as JSON")

    mobility = _command(commands, "mobility", report_mobility, "constraints and freedoms by reciprocal screws")
    _mechanism(mobility)
    mobility.add_argument(
        "--at", nargs="+", action="extend", default=[], metavar="KEY=VALUE",
        help="a parameter, or a joint coordinate (joint or joint.i) [rad, m]",
    )  # fmt: skip
    mobility.add_argument("--body", metavar="NAME", help="whose freedoms; default: the platform")
    mobility.add_argument("--expect", type=int, metavar="N", help="exit 1 unless the finite mobility is N, verified")
    mobility.add_argument("--json", action="store_true", help="as JSON")
    mobility.add_argument("--out", metavar="FILE", help="write the report: .md, .html or .tex")

    cost = _command(commands, "cost", bill_of_effects, "what each effect of a scene costs, and what it changes")
    cost.add_argument("scene", metavar="SCENE", help="a scene file")
    cost.add_argument("--json", action="store_true", help="as JSON")
    cost.add_argument("--plot", metavar="FILE.png", help="the bill as a picture")
    cost.add_argument("--no-timing", action="store_true", help="count only: nothing is compiled")

    accuracy = _command(commands, "accuracy", study_accuracy, "what accuracy costs in time: methods side by side")
    accuracy.add_argument("mechanism", metavar="NAME|SCENE", help="a name of `symscrew list`, or a scene file")
    text = "which study; default: all of a mechanism, forward of a scene (growth: cost over the number of loops)"
    accuracy.add_argument("--study", metavar="STUDY", help=text)
    accuracy.add_argument("--out", metavar="DIR", required=True, help="for JSON, Markdown table and plots")
    accuracy.add_argument("--full", action="store_true", help="more repeats and smaller steps: takes longer")

    convert = _command(commands, "convert", convert_description, "a mechanism as TOML, URDF or MJCF")
    _mechanism(convert)
    convert.add_argument("--out", metavar="FILE", required=True, help="a new file: .toml, .urdf, .xml or .mjcf (MJCF)")

    run = _command(commands, "simulate", simulate_scene, "the motion of a scene: loops closed, energy balanced")
    run.add_argument("scene", metavar="SCENE", help="a TOML file with mechanism, effects, start, drives, integrator")
    run.add_argument("--out", metavar="FILE", help="the run: .npz (everything) or .csv")
    run.add_argument("--plot", metavar="FILE.png", help="a picture of the run")
    run.add_argument("--emit-c", metavar="DIR", help="write the loop for real time: one step of fixed size in C99")
    run.add_argument("--json", action="store_true", help="numbers of the run as JSON")

    best = _command(commands, "optimise", optimise_trajectory, "the best motion between conditions, within bounds")
    best.add_argument("problem", metavar="PROBLEM.toml", help="mechanism or scene, conditions, bounds, objectives")
    best.add_argument("--out", metavar="FILE", required=True, help="the motion: .npz (everything) or .csv (a table)")
    best.add_argument("--plot", metavar="FILE.png", help="a picture of the motion")
    best.add_argument("--rate", type=float, metavar="HZ", help="samples per second in the file; default: 501 in all")
    best.add_argument("--json", action="store_true", help="the outcome as JSON")

    picture = _command(commands, "draw", draw_mechanism, "a picture of a mechanism in its reference configuration")
    _mechanism(picture)
    picture.add_argument("--out", metavar="FILE.png", required=True, help="the picture")

    view = _command(commands, "view", view_mechanism, "a page with the mechanism in 3-D: to turn, move and play")
    view.add_argument("mechanism", metavar="NAME|FILE|RUN.npz", help="a mechanism, or a recorded motion to play")
    view.add_argument("--out", metavar="FILE.html", help="the page; without it the page is opened in the browser")
    _gravity(view)
    view.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")
    from symscrew.embedded.command import add_options

    add_options(_command(commands, "embedded", measure_embedded, "what functions cost on a microcontroller, emulated"))
    _command(commands, "doctor", report_installation, "what is installed, and what each part is for")
    return top


def _help(top: argparse.ArgumentParser):  # type: ignore[no-untyped-def]
    def command(_: argparse.Namespace) -> int:
        top.error("expected a command")

    return command


def _command(commands, name: str, function, text: str) -> argparse.ArgumentParser:  # type: ignore[no-untyped-def]
    made = commands.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}.")
    made.set_defaults(command=function)
    return made


def _mechanism(command: argparse.ArgumentParser) -> None:
    text = "a name of `symscrew list`, or a .toml, .urdf or .xml (MJCF) file"
    command.add_argument("mechanism", metavar="NAME|FILE", help=text)


def _gravity(command: argparse.ArgumentParser) -> None:
    gravity = command.add_mutually_exclusive_group()
    gravity.add_argument("--no-gravity", action="store_true", help="no gravity (default: 9.81 m/s^2 along -z)")
    gravity.add_argument("--gravity", nargs=3, metavar=("GX", "GY", "GZ"), help="acceleration of free fall [m/s^2]")
    command.set_defaults(load=[])


def _effects(command: argparse.ArgumentParser) -> None:
    _gravity(command)
    command.add_argument(
        "--load", action="append", default=[], metavar="POINT", help="force and moment at a named point as an input"
    )
    command.add_argument("--effects", metavar="FILE", help="the effects of a TOML file ([[effects]]), and no others")


def list_mechanisms(options: argparse.Namespace) -> int:
    """`symscrew list`."""
    from symscrew import catalogue
    from symscrew.console import table

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
        print(table(header, [[str(row[key]) for key in header] for row in rows]))
    return 0


def run_demo(options: argparse.Namespace) -> int:
    """`symscrew demo`."""
    from symscrew.console import Progress

    directory = _writable(options.out) if options.out else None
    if directory:
        _need_matplotlib()
    from symscrew.demo import report
    from symscrew.demo.study import run

    progress = Progress()
    result = run(progress=progress)
    written = report.write(result, directory, progress) if directory else []
    if options.json:
        print(json.dumps(report.values(result), indent=1))
    else:
        print(report.facts(result))
        print()
        print(report.summary(result))
        if directory:
            print(f"Written to {directory}: " + ", ".join(path.name for path in written))
        else:
            print("No files were written; `symscrew demo --out DIR` draws figures 7, 8, 9 and 11 into DIR.")
    print(f"done in {progress.elapsed:.1f} s", file=sys.stderr)
    return 0 if result.agrees else FAILED


def generate_code(options: argparse.Namespace) -> int:
    """`symscrew generate`."""
    from symscrew.console import Progress, table
    from symscrew.generation import SINGLE_TARGETS, generate

    single = options.precision == "single"
    targets = [t for t in TARGETS if t in (options.target or (["c"] if single else USUAL))]
    doubles = [t for t in targets if t not in SINGLE_TARGETS]
    if single and doubles:
        raise UsageError(f"--precision single: {doubles[0]} is double only; expected {' or '.join(SINGLE_TARGETS)}")
    progress = Progress()
    model = _derived(options, progress)
    with progress.step(f"write {', '.join(targets)} to {options.out}"):
        files = generate(model, options.out, targets, precision=options.precision)
    print(f"{model.name}: {len(model.programs)} functions, {len(files)} files in {options.out}")
    rows = [[name, str(p.operations["total"])] for name, p in model.programs.items()]
    print(table(("function", "operations"), rows))
    for note in model.notes:
        print(f"note: {note}")
    return 0


def _derived(options: argparse.Namespace, progress: object) -> Model:
    """The model of the mechanism and effects that the options name; all bad input ends here."""
    from symscrew import catalogue
    from symscrew.console import Progress
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
        )


def _chosen_effects(options: argparse.Namespace, mechanism: Mechanism) -> list[Effect]:
    from symscrew.effects import Gravity
    from symscrew.errors import did_you_mean

    effects: list[Effect] = []
    if getattr(options, "effects", None):
        from symscrew.effects.registry import load_effects

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
    from symscrew.console import Progress
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
    from symscrew.cost import run

    return run(options)


def study_accuracy(options: argparse.Namespace) -> int:
    """`symscrew accuracy`."""
    from symscrew.accuracy.command import run

    return run(options)


def report_mobility(options: argparse.Namespace) -> int:
    """`symscrew mobility`."""
    from symscrew.mobility.command import run

    return run(options)


def convert_description(options: argparse.Namespace) -> int:
    """`symscrew convert`."""
    from symscrew import catalogue, interchange

    path = Path(options.out)
    if path.suffix not in interchange.WRITERS:
        raise UsageError(f"--out: expected a name that ends in {', '.join(interchange.WRITERS)}, got {options.out!r}")
    mechanism = catalogue.find(options.mechanism)
    _writable(str(path.parent))
    interchange.save(mechanism, path)
    print(path)
    for note in mechanism.source.split("; ")[1:] if mechanism.source.startswith("imported from") else ():
        print(f"note: {note}", file=sys.stderr)
    return 0


def simulate_scene(options: argparse.Namespace) -> int:
    """`symscrew simulate`."""
    from symscrew.simulation.command import run

    return run(options)


def optimise_trajectory(options: argparse.Namespace) -> int:
    """`symscrew optimise`."""
    from symscrew.optimisation.command import run

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
    from symscrew.drawing import mechanism_figure
    from symscrew.plots import save

    print(save(mechanism_figure(mechanism), path, tight=True))
    return 0


def view_mechanism(options: argparse.Namespace) -> int:
    """`symscrew view`."""
    from symscrew.console import Progress
    from symscrew.model import derive
    from symscrew.view import open_page, read, write_page

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


def measure_embedded(options: argparse.Namespace) -> int:
    """`symscrew embedded`."""
    from symscrew.embedded.command import run

    return run(options)


def report_installation(_: argparse.Namespace) -> int:
    """`symscrew doctor`."""
    from symscrew.console import installation, table

    print(table(("part", "found", "for"), installation()))
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


if __name__ == "__main__":
    sys.exit(main())
