"""The command line: `parser` knows the commands, one file each says what a command does with its options."""

from symscrew.cli.parser import main

__all__ = ["main"]
