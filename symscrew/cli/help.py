"""How the command line speaks: its parser, what it says to bad options, and when a command's file is read.

    words --Parser--> name of a command --CommandFile.add_options--> options --CommandFile.run--> exit code

A command is one file, `<name>_command.py`: its `EXAMPLES`, `add_options` and `run`. The file is imported when somebody
asks for the command, and what the command works with when it runs, so that help and completion never wait for
libraries.
"""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from typing import TYPE_CHECKING, Any, NoReturn, Protocol, cast

from symscrew.errors import did_you_mean

DONE, FAILED = 0, 1  # exit codes of a command; of bad input and interruption see `symscrew.cli.parser`


class UsageError(ValueError):
    """Bad input that the command line itself finds."""


class CommandFile(Protocol):
    """What the file of a command holds."""

    EXAMPLES: tuple[str, ...]
    """Command lines that show what the command is for; shown below its options."""

    def add_options(self, command: argparse.ArgumentParser) -> None:
        """Give the command's parser its options."""

    def run(self, options: argparse.Namespace) -> int:
        """Do it; the exit code."""


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line on stderr and exit code 2, with the nearest names of commands and choices."""

    module: str | None = None
    """The file with the options of this command, while it has not been read."""

    def error(self, message: str) -> NoReturn:
        """End with the message."""
        raise UsageError(
            f"{message.removesuffix('?')}{'? See' if message.endswith('?') else '; see'} {self.prog} --help"
        )

    def add_argument(self, *names: Any, **more: Any) -> argparse.Action:
        """As usual, but an option of several values that is given twice has the values of both."""
        if more.get("nargs") == "+" and "action" not in more and str(names[0]).startswith("-"):
            more["action"] = Gathered
        return super().add_argument(*names, **more)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """As usual, but an option that does not exist is the first thing said, with the nearest that do."""
        for word in sys.argv[1:] if args is None else args:
            option = word.partition("=")[0]
            if word == "--" or (self._subparsers is not None and not word.startswith("-")):
                break
            known = self._option_string_actions
            if option.startswith("--") and not any(name.startswith(option) for name in known):
                self.error(
                    f"unknown option {option[:60]!r}; {did_you_mean(option, [n for n in known if n[:2] == '--'])}"
                )
        return super().parse_known_args(args, namespace)

    def _get_values(self, action: argparse.Action, arg_strings: list[str]) -> Any:
        """As usual, but the end of options is no value of one: argparse would hand on an empty list for it."""
        if action.option_strings and "--" in arg_strings:
            raise argparse.ArgumentError(action, "expected a value, got '--'")
        return super()._get_values(action, arg_strings)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            what = "/".join(action.option_strings) or action.metavar or action.dest
            near = did_you_mean(str(value), [str(c) for c in action.choices])
            raise argparse.ArgumentError(None, f"{what}: unknown {str(value)[:60]!r}; {near}")

    def read_command(self) -> None:
        """Take options, examples and task from the command's file, the first time."""
        if self.module is None:
            return
        found = cast(CommandFile, import_module(self.module))
        self.module = None
        found.add_options(self)
        self.set_defaults(command=found.run)
        self.formatter_class = argparse.RawDescriptionHelpFormatter
        self.epilog = "examples:\n" + "\n".join(f"  {line}" for line in found.EXAMPLES)


class Gathered(argparse.Action):
    """Values of an option, of all the times that it is given; the first ones take the place of the default."""

    def __call__(self, parser: Any, namespace: Any, values: Any, option_string: str | None = None) -> None:
        """Add the values of one time."""
        before = getattr(namespace, self.dest)
        setattr(namespace, self.dest, [*(() if before is self.default else before), *values])


class CommandParsers(dict[str, Parser]):
    """Parsers of commands by name; a command's file is read when its parser is taken out of here."""

    def __getitem__(self, name: str) -> Parser:
        made = super().__getitem__(name)
        made.read_command()
        return made


if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[Parser]
else:
    Subparsers = argparse._SubParsersAction  # which is generic for type checkers only


class CommandsAction(Subparsers):
    """Commands whose files are read when somebody asks for them: argparse, argcomplete or a test.

    argparse parses with, and argcomplete looks into, what this action's mapping of names gives out: there, and not in
    the parser's methods, is the one place that both pass before they look at options.
    """

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.choices = self._name_parser_map = CommandParsers()


def complete(parser: argparse.ArgumentParser) -> None:
    """Answer the shell's question for completions, if argcomplete is installed."""
    try:
        import argcomplete
    except ImportError:
        return
    argcomplete.autocomplete(parser)
