"""The functions of points as C, compiled beside the work that goes on by interpreting them.

functions --CasADi's printer, or four points at a time--> C --compile_c, in a thread--> library of the user's cache
    --external--> functions

What was compiled before is taken from the cache within milliseconds: its key is the hash of the C.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import TimeoutError as NotYet
from pathlib import Path

import casadi as ca

from symscrew.optimisation.point_lanes import LANES, printable, printed_lanes
from symscrew.optimisation.sparse import PointFunctions
from symscrew.optimisation.stage_steps import step_library
from symscrew.runtime import CompileError, compile_c

# A Hessian of a spatial mechanism with loops is one function of some 30 000 statements, on which a compiler spends more
# time than the better code is worth: at -O1 it takes a third of the time of -O2 and the functions 1.1 times theirs.
FLAGS = ("-O1",)
COMMON = (1,)  # of the inputs of a point's functions, the problem's numbers are those of all points


class CompiledPoints:
    """The functions of families by name, interpreted until the compiler is done with them."""

    def __init__(self, interpreted: Mapping[str, PointFunctions], counts: Mapping[str, int]) -> None:
        """Start the compiler; `counts` says how many points a family has."""
        self.interpreted = interpreted
        self._compiled: Mapping[str, PointFunctions] | None = None
        self.trouble = ""
        pool = ThreadPoolExecutor(1, thread_name_prefix="compile points")
        self._work: Future[Mapping[str, PointFunctions]] = pool.submit(_compiled, *_printed(interpreted, counts))
        pool.shutdown(wait=False)

    def ready(self, *, wait: float = 0.0) -> bool:
        """Whether they are compiled, or will not be (`trouble` says why); waits at most so many seconds."""
        if self._compiled is not None or self.trouble:
            return True
        try:
            self._compiled = self._work.result(wait)
        except NotYet:
            return False
        except CompileError as error:
            self.trouble = str(error).splitlines()[0]
        return True

    @property
    def functions(self) -> Mapping[str, PointFunctions]:
        """The best there are by now."""
        return self._compiled if self._compiled is not None else self.interpreted


def _printed(
    functions: Mapping[str, PointFunctions], counts: Mapping[str, int]
) -> tuple[str, Mapping[str, Mapping[str, str]]]:
    """One C file of all functions, and their names in it by family and kind."""
    printer = ca.CodeGenerator("points.c")
    lanes: dict[str, tuple[ca.Function, int, tuple[int, ...]]] = {}
    names: dict[str, dict[str, str]] = {}
    for family, kinds in functions.items():
        names[family] = {kind: function.name() for kind, function in kinds.items()}
        for kind, function in kinds.items():
            if counts[family] >= LANES and printable(function):
                names[family][kind] = f"{function.name()}_of_all"
                lanes[names[family][kind]] = function, counts[family], COMMON
            else:
                printer.add(function)
    return str(printer.dump()) + printed_lanes(lanes), names


def _compiled(code: str, names: Mapping[str, Mapping[str, str]]) -> Mapping[str, PointFunctions]:
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        source, library = Path(temporary, "points.c"), Path(temporary, "libpoints.so")
        source.write_text(code, encoding="utf-8")
        compile_c(source, library, flags=FLAGS)
        step_library()  # wanted as soon as these are
        # a library stays mapped when its file is gone
        return {
            family: {kind: ca.external(name, str(library)) for kind, name in kinds.items()}
            for family, kinds in names.items()
        }
