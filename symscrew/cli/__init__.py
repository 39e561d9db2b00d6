"""The command line: `parser` has the table of the commands, one file each says what a command takes and does.

    words --parser--> options --<name>_command.run--> text on stdout, files, exit code

Options that several commands share are in `shared_options`; what is computed is in the rooms above.
"""

from symscrew.cli.parser import main

__all__ = ["main"]
