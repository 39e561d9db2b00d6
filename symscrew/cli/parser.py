"""The command line: the table of its commands, and how each of them ends.

    words --parser--> options --run of the command's file--> exit code

Results go to stdout, progress and errors to stderr. Exit code 0: done; 1: a check failed or a function
reported an error; 2: the input cannot be used, said in one line, and nothing has been written.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from symscrew import __version__
from symscrew.cli.help import DONE, FAILED, CommandsAction, Parser, UsageError, complete
from symscrew.errors import shorten
from symscrew.garbage import none_at_the_end

BAD_INPUT, INTERRUPTED = 2, 130  # exit codes; 130 is what shells give to a command that Ctrl-C ended

COMMANDS = {
    "list": ("list_command", "the mechanisms that come with the package"),
    "demo": ("demo_command", "the whole job on the source paper's mechanism"),
    "new": ("new_command", "a commented description to start from, with sensible geometry"),
    "generate": ("generate_command", "C, CasADi and NumPy functions of a mechanism"),
    "check": ("check_command", "is generated output up to date, clean and right?"),
    "assemble": ("assemble_command", "every assembly mode for given drives, certified"),
    "mobility": ("mobility_command", "constraints and freedoms by reciprocal screws"),
    "formulas": ("formulas_command", "formulas for a paper: screws, limbs, wrenches, inverse kinematics"),
    "drives": ("drives_command", "a motion in, tables out: drives, rates, reactions, margins"),
    "cost": ("cost_command", "what each effect of a scene costs, and what it changes"),
    "accuracy": ("accuracy_command", "what accuracy costs in time: methods side by side"),
    "convert": ("convert_command", "a mechanism as TOML, URDF or MJCF"),
    "simulate": ("simulate_command", "the motion of a scene: loops closed, energy balanced"),
    "fmu": ("fmu_command", "a scene as functional mock-up unit (FMI 2.0 or 3.0)"),
    "optimise": ("optimise_command", "the best motion between conditions, within bounds"),
    "draw": ("draw_command", "a picture of a mechanism in its reference configuration"),
    "report": ("report_command", "one document on a mechanism, to read or to print"),
    "workspace": ("workspace_command", "maps over coordinates and parameters, tolerances"),
    "view": ("view_command", "a page with the mechanism in 3-D: to turn, move and play"),
    "benchmark": ("benchmark_command", "time of functions, beside other libraries"),
    "embedded": ("embedded_command", "what functions cost on a microcontroller, emulated"),
    "cache": ("cache_command", "what is kept between runs: libraries, models, outcomes"),
    "doctor": ("doctor_command", "what is installed, and what each part is for"),
}
"""Command -> its file in this folder, and what the help says it is, in the order of the help.

A further command is a file with `EXAMPLES`, `add_options` and `run` (`symscrew.cli.help.CommandFile`), and a line here.
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns the exit code."""
    none_at_the_end()
    _open_streams()
    try:
        made = parser()
        if "_ARGCOMPLETE" in os.environ:
            complete(made)
        _refuse_empty(sys.argv[1:] if arguments is None else arguments)
        options = made.parse_args(arguments)
        if not hasattr(options, "command"):
            made.error("expected a command")
        return _run(options)
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED)
    except BrokenPipeError:
        # whoever reads our output, `head` say, has what it wanted; what is still buffered must not raise again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
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


def _open_streams() -> None:
    """Let streams that were closed for the command lead nowhere.

    Python has None for them, and print takes the standard output for an error stream that is None; the next file to be
    opened would get their number, and lines of libraries in it.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode, encoding="utf-8"))  # noqa: SIM115  # as long as the process


def _refuse_empty(arguments: Sequence[str]) -> None:
    """Raises UsageError for a text without letters, as a shell makes of a variable that is not set: nobody means it."""
    for before, argument in zip(["symscrew", *arguments], arguments, strict=False):
        option, equals, value = argument.partition("=")
        if not argument.strip() or (option.startswith("--") and equals and not value.strip()):
            where = option if equals else before
            raise UsageError(f"expected a value after {shorten(where)}, got an empty text")


def _run(options: argparse.Namespace) -> int:
    """The command's exit code, without the user's cache where that was asked for."""
    if not getattr(options, "no_cache", False):
        return int(options.command(options) or 0)
    from symscrew.runtime import without_cache

    with without_cache():
        return int(options.command(options) or 0)


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
    """All commands; the file of one is read when its options are asked for."""
    top = Parser(prog="symscrew", description="Symbolic models of mechanisms on screw theory, with code export.")
    top.add_argument("--version", action="version", version=f"symscrew {__version__}")
    commands = top.add_subparsers(title="commands", metavar="COMMAND", action=CommandsAction)
    for name, (file, purpose) in COMMANDS.items():
        made = commands.add_parser(name, help=purpose, description=f"{purpose[0].upper()}{purpose[1:]}.")
        made.module = f"symscrew.cli.{file}"
    return top


if __name__ == "__main__":
    sys.exit(main())
