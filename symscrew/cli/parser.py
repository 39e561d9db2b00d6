"""The command line: its commands and options. What they do is in `symscrew.cli.commands`.

Results go to stdout, progress and errors to stderr. Exit code 0: done; 1: a check failed or a function
reported an error; 2: the input cannot be used, said in one line, and nothing has been written.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from symscrew import __version__
from symscrew.cli import commands
from symscrew.cli.help import FAILED, LIMIT, OVER, TOLERANCE, Parser, UsageError, complete
from symscrew.generation import TARGETS

BAD_INPUT, INTERRUPTED = 2, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    try:
        made = parser()
        if "_ARGCOMPLETE" in os.environ:
            complete(made)
        options = made.parse_args(arguments)
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
    from symscrew.export import OutputError

    return isinstance(error, OutputError)


def _is_failure(error: Exception) -> bool:
    from symscrew.runtime import CompileError, EvaluationError

    return isinstance(error, (CompileError, EvaluationError))


def _fail(message: object, code: int) -> int:
    from symscrew.display import colours, one_line

    label = "\033[1;31merror:\033[0m" if colours(sys.stderr) else "error:"
    print(f"symscrew: {label} {one_line(message)}", file=sys.stderr)
    return code


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = Parser(prog="symscrew", description="Symbolic models of mechanisms on screw theory, with code export.")
    top.add_argument("--version", action="version", version=f"symscrew {__version__}")
    top.set_defaults(command=_help(top))
    verbs = top.add_subparsers(title="commands", metavar="COMMAND")

    found = _command(verbs, "list", commands.list_mechanisms, "the mechanisms that come with the package")
    found.add_argument("--json", action="store_true", help="as JSON")

    demo = _command(verbs, "demo", commands.run_demo, "the whole job on the source paper's mechanism")
    demo.add_argument("--out", metavar="DIR", help="write figures and a summary here; nothing is written without it")
    demo.add_argument("--json", action="store_true", help="numbers as JSON instead of the tables")

    new = _command(
        verbs, "new", commands.start_description, "a commented description to start from, with sensible geometry"
    )
    new.add_argument("name", metavar="NAME", help="of the mechanism: letters, digits, underscores")
    new.add_argument("--limbs", metavar="LIMBS", required=True, help="such as 3-UPS+UPU+S, 3-RRR or RRRRRR (an arm)")
    new.add_argument("--out", metavar="FILE.toml", help="default: NAME.toml; a file that exists is left as it is")

    generate = _command(verbs, "generate", commands.generate_code, "C, CasADi and NumPy functions of a mechanism")
    _mechanism(generate)
    generate.add_argument("--out", metavar="DIR", required=True, help="a new, empty or earlier generated directory")
    text = "default: c casadi numpy; external: C for casadi.external, with derivatives; fmu: FMI 3.0, sources only"
    generate.add_argument("--target", nargs="+", choices=TARGETS, help=text)
    generate.add_argument(
        "--precision", choices=("double", "single"), default="double", help="single: C of type float, no other target"
    )
    generate.add_argument(
        "--embedded", nargs="+", choices=("m4f", "m7"), default=[], metavar="CORE",
        help="measure the C on m4f or m7 in QEMU: flash, stack and instructions go into the header and ops.json",
    )  # fmt: skip
    _effects(generate)
    generate.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")
    generate.add_argument("--length", metavar="METRES", help="characteristic length for norms of mixed quantities")
    generate.add_argument("--derivatives", action="store_true", help="also derivatives and the linearisation")
    generate.add_argument("--regressor", action="store_true", help="also regressors of the inertial parameters")
    text = "code for the operation mode of the reference configuration only, where coordinates may follow from others"
    generate.add_argument("--one-mode", action="store_true", help=text)
    text = "write header, counts, manifest and description, of all other files the hashes: enough for symscrew check"
    generate.add_argument("--hashes-only", action="store_true", help=text)
    text = "these functions only; default: all, which README.md of the output describes"
    generate.add_argument("--functions", nargs="+", metavar="NAME", help=text)

    check = _command(verbs, "check", commands.check_output, "is generated output up to date, clean and right?")
    check.add_argument("directory", metavar="DIR", help="generated output, or a directory of such")
    check.add_argument("--json", action="store_true", help="as JSON")

    mobility = _command(verbs, "mobility", commands.report_mobility, "constraints and freedoms by reciprocal screws")
    _mechanism(mobility)
    mobility.add_argument(
        "--at", nargs="+", action="extend", default=[], metavar="KEY=VALUE",
        help="a parameter, or a joint coordinate (joint or joint.i) [rad, m]",
    )  # fmt: skip
    mobility.add_argument("--body", metavar="NAME", help="whose freedoms; default: the platform")
    mobility.add_argument("--expect", type=int, metavar="N", help="exit 1 unless the finite mobility is N, verified")
    mobility.add_argument("--json", action="store_true", help="as JSON")
    mobility.add_argument("--out", metavar="FILE", help="write the report: .md, .html or .tex")

    cost = _command(verbs, "cost", commands.bill_of_effects, "what each effect of a scene costs, and what it changes")
    cost.add_argument("scene", metavar="SCENE", help="a scene file")
    cost.add_argument("--json", action="store_true", help="as JSON")
    cost.add_argument("--plot", metavar="FILE.png", help="the bill as a picture")
    cost.add_argument("--no-timing", action="store_true", help="count only: nothing is compiled")

    accuracy = _command(verbs, "accuracy", commands.study_accuracy, "what accuracy costs in time: methods side by side")
    text = "a name of `symscrew list`, a scene file, or a folder of benchmark problems"
    accuracy.add_argument("mechanism", metavar="NAME|SCENE|FOLDER", help=text)
    text = (
        "kinematics, momentum, forward, precision, effects, claims or all of these; growth (over the number of loops), "
        "problems, transcription; default: all of a mechanism, forward of a scene"
    )
    accuracy.add_argument("--study", metavar="STUDY", help=text)
    accuracy.add_argument("--problems", metavar="DIR", help="also the benchmark problems of a folder, a row for each")
    accuracy.add_argument("--out", metavar="DIR", required=True, help="for JSON, Markdown table and plots")
    accuracy.add_argument("--full", action="store_true", help="more repeats and smaller steps: takes longer")

    convert = _command(verbs, "convert", commands.convert_description, "a mechanism as TOML, URDF or MJCF")
    _mechanism(convert)
    convert.add_argument("--out", metavar="FILE", required=True, help="a new file: .toml, .urdf, .xml or .mjcf (MJCF)")

    run = _command(verbs, "simulate", commands.simulate_scene, "the motion of a scene: loops closed, energy balanced")
    run.add_argument("scene", metavar="SCENE", help="a TOML file with mechanism, effects, start, drives, integrator")
    run.add_argument("--out", metavar="FILE", help="the run: .npz (everything) or .csv")
    run.add_argument("--plot", metavar="FILE.png", help="a picture of the run")
    run.add_argument("--emit-c", metavar="DIR", help="write the loop for real time: one step of fixed size in C99")
    run.add_argument("--json", action="store_true", help="numbers of the run as JSON")

    unit = _command(verbs, "fmu", commands.pack_unit, "a scene as functional mock-up unit (FMI 2.0 or 3.0)")
    unit.add_argument("scene", metavar="SCENE|NAME", help="a scene file, or a mechanism under its weight")
    unit.add_argument("--out", metavar="FILE.fmu", required=True, help="the unit, C sources inside")
    unit.add_argument("--fmi", type=int, choices=(2, 3), default=3, help="version of the standard; default: 3")

    best = _command(
        verbs, "optimise", commands.optimise_trajectory, "the best motion between conditions, within bounds"
    )
    best.add_argument("problem", metavar="PROBLEM.toml", help="mechanism or scene, conditions, bounds, objectives")
    best.add_argument("--out", metavar="FILE", required=True, help="the motion: .npz (everything) or .csv (a table)")
    best.add_argument("--plot", metavar="FILE.png", help="a picture of the motion")
    best.add_argument("--rate", type=float, metavar="HZ", help="samples per second in the file; default: 501 in all")
    best.add_argument("--json", action="store_true", help="the outcome as JSON")

    picture = _command(
        verbs, "draw", commands.draw_mechanism, "a picture of a mechanism in its reference configuration"
    )
    _mechanism(picture)
    picture.add_argument("--out", metavar="FILE.png", required=True, help="the picture")

    report = _command(verbs, "report", commands.report_mechanism, "one document on a mechanism, to read or to print")
    _mechanism(report)
    report.add_argument("--out", metavar="FILE", required=True, help="the report: .html (one file) or .md")
    _effects(report)
    report.add_argument("--accuracy", metavar="DIR", help="results of `symscrew accuracy` to include")
    report.add_argument("--scene", metavar="SCENE", help="a scene whose bill of effects to include")
    report.add_argument("--no-timing", action="store_true", help="count only: no function is timed")

    maps = _command(verbs, "workspace", commands.map_workspace, "maps over coordinates and parameters, tolerances")
    _mechanism(maps)
    maps.add_argument("--over", nargs="+", action="extend", metavar="COORD=FROM:TO:N", help=OVER)
    maps.add_argument("--out", metavar="DIR|FILE", required=True, help="a new folder, or a file: .npz or .csv")
    maps.add_argument("--limit", nargs="+", action="extend", metavar="RESULT=MIN:MAX", help=LIMIT)
    maps.add_argument("--tolerance", nargs="+", action="extend", metavar="PARAM=SIGMA", help=TOLERANCE)
    maps.add_argument("--samples", type=int, default=100, metavar="N", help="per place, with --tolerance; default 100")
    maps.add_argument("--seed", type=int, default=0, metavar="N", help="of the random numbers; default 0")
    maps.add_argument("--expect-tilt", metavar="ANGLE", help="exit 1 unless this tilt is reached in every direction")
    maps.add_argument("--stiffness", default="1e6", metavar="K", help="of a drive [N/m]; default 1e6")
    maps.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")
    _effects(maps)
    maps.add_argument("--processes", type=int, metavar="N", help="default: one per core")
    maps.add_argument("--dask", metavar="ADDRESS", help="of a Dask scheduler, to run there: tcp://host:8786")
    maps.add_argument("--json", action="store_true", help="the summary as JSON")

    view = _command(verbs, "view", commands.view_mechanism, "a page with the mechanism in 3-D: to turn, move and play")
    view.add_argument("mechanism", metavar="NAME|FILE|RUN.npz", help="a mechanism, or a recorded motion to play")
    view.add_argument("--out", metavar="FILE.html", help="the page; without it the page is opened in the browser")
    _gravity(view)
    view.add_argument("--independent", nargs="+", metavar="LABEL", help="coordinates of q to take as independent")
    _benchmark_options(
        _command(verbs, "benchmark", commands.run_benchmark, "time of functions, beside other libraries")
    )
    _embedded_options(
        _command(verbs, "embedded", commands.measure_embedded, "what functions cost on a microcontroller, emulated")
    )
    doctor = _command(verbs, "doctor", commands.report_installation, "what is installed, and what each part is for")
    doctor.add_argument("--json", action="store_true", help="as JSON")
    return top


def _benchmark_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew benchmark`."""
    command.add_argument("mechanism", metavar="NAME|FILE", help="a name of `symscrew list`, or a description file")
    command.add_argument("--function", nargs="+", metavar="NAME", help="default: dynamics, reactions, mass matrix")
    command.add_argument("--against", nargs="+", choices=("pinocchio", "mujoco"), default=[], help="other libraries")
    command.add_argument("--repeats", type=int, default=25, help="interleaved repeats (default: 25)")
    command.add_argument("--throughput", action="store_true", help="also batches of 1, 8, 1000 and 1000000 states")
    command.add_argument("--run-time", action="store_true", help="also code that reads all parameters at run time")
    command.add_argument("--plot", metavar="FILE.png", help="medians and quartiles as a picture")
    command.add_argument("--json", action="store_true", help="numbers as JSON instead of the tables")


def _embedded_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew embedded`."""
    command.add_argument("mechanism", metavar="NAME|FILE", help="a name of `symscrew list`, or a description file")
    command.add_argument("--core", nargs="+", choices=("m4f", "m7"), default=["m4f", "m7"], help="default: both")
    command.add_argument("--precision", choices=("single", "double"), help="default: single on m4f, double on m7")
    command.add_argument("--function", nargs="+", metavar="NAME", help="default: dynamics and assembly; all: every one")
    command.add_argument("--out", metavar="FILE.json", help="also write the numbers here")
    command.add_argument("--json", action="store_true", help="numbers as JSON instead of the table")


def _help(top: argparse.ArgumentParser):  # type: ignore[no-untyped-def]
    def command(_: argparse.Namespace) -> int:
        top.error("expected a command")

    return command


def _command(verbs, name: str, function, text: str) -> Parser:  # type: ignore[no-untyped-def]
    made = verbs.add_parser(name, help=text, description=f"{text[0].upper()}{text[1:]}.")
    made.set_defaults(command=function)
    made.add_examples(name)
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


if __name__ == "__main__":
    sys.exit(main())
