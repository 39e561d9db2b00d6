"""Where functions were undefined on a solver's way: its warnings, counted and named by equation.

solver's lines on the standard error --output, row, column--> labels of constraints and unknowns --> counts
"""

from __future__ import annotations

import re
import sys
import threading
from collections import Counter
from collections.abc import Sequence
from types import TracebackType

from symscrew.errors import DescriptionError

# What CasADi says of a function with an entry that is not finite; only the first such entry is named.
LINE = re.compile(r"WARNING\(.*failed: (?:NaN|Inf) detected for output (\w+), at .*?\(row (\d+), col (\d+)\)")
# What CasADi says of Ctrl-C, before the error that Python raises says so itself.
INTERRUPTED = 'WARNING("KeyboardInterruptException")'
# Outputs of the functions of a nonlinear program -> what they are, by rows (constraints) or not (the cost).
OF_CONSTRAINTS = ("g", "jac_g_x")


class SolverWarnings:
    """The standard error inside a `with`: a solver's warnings are counted, everything else goes where it went.

    `solver` shows them only where `heard`: the standard error belongs to all threads, so that others than the main
    one, and consoles of a process without one, leave it alone.
    """

    def __init__(self, labels: Sequence[str]) -> None:
        """`labels` of the program's constraints, in order."""
        self.heard = sys.stderr is not None and threading.current_thread() is threading.main_thread()
        self._labels, self._begun = labels, ""
        self._counts: Counter[str] = Counter()

    @property
    def counts(self) -> dict[str, int]:
        """Equation -> evaluations of which it was the first entry that was not finite, the most frequent first."""
        return dict(self._counts.most_common())

    def __enter__(self) -> SolverWarnings:
        self._before = sys.stderr
        if self.heard:
            sys.stderr = self
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if self.heard:
            sys.stderr = self._before
            if self._begun:
                self._take(self._begun)
        if isinstance(error, RuntimeError):  # CasADi's: a solver without a library of its own, say
            lines = [line for line in str(error).splitlines() if not line.startswith(("Error in", "."))]
            raise DescriptionError(f"solver: it fails: {(lines or [str(error)])[0].strip()}") from error

    def write(self, text: str) -> int:
        """Take what a solver or anybody writes; lines may come in pieces."""
        *lines, self._begun = (self._begun + text).split("\n")
        for line in lines:
            self._take(f"{line}\n")
        return len(text)

    def flush(self) -> None:
        """Hand on what was handed on."""
        self._before.flush()

    def _take(self, line: str) -> None:
        found = LINE.search(line)
        if INTERRUPTED in line:
            return
        if found is None:
            self._before.write(line)
        else:
            self._counts[self._equation(found[1], int(found[2]))] += 1

    def _equation(self, output: str, row: int) -> str:
        if output in OF_CONSTRAINTS and row < len(self._labels):
            return self._labels[row].split(", row")[0]
        return "second derivatives" if "hess" in output else "cost"
