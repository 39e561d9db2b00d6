"""The C of a mechanism's modes, compiled and called."""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.assembly.modes_c import ModesModel, print_modes
from symscrew.runtime import compile_c

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class CompiledModes:
    """The compiled functions; drives [rad, m] in the order of the header."""

    library: ctypes.CDLL
    model: ModesModel

    @property
    def record(self) -> type[ctypes.Structure]:
        """The struct of a mode."""
        drives, width = len(self.model.drives), self.model.equations.width
        double = ctypes.c_double
        fields = [("drives", double * drives), ("pose", double * 12), ("z", double * width), ("error", double)]
        return type("Mode", (ctypes.Structure,), {"_fields_": [*fields, ("certified", ctypes.c_int)]})

    def modes(self, drives: Sequence[float]) -> tuple[int, list[Any]]:
        """(status, modes)."""
        found, count = (self.record * len(self.model.start.zeros))(), ctypes.c_int(0)
        given = (ctypes.c_double * len(drives))(*drives)
        status = self.library[f"{self.model.name}_assembly_modes"](given, found, ctypes.byref(count))
        return int(status), list(found[: count.value])

    def level(self, drives: Sequence[float]) -> tuple[int, list[Any]]:
        """(status, modes turned as in the reference) by the closed form, where there is one."""
        found, count = (self.record * 2)(), ctypes.c_int(0)
        given = (ctypes.c_double * len(drives))(*drives)
        status = self.library[f"{self.model.name}_level_modes"](given, found, ctypes.byref(count))
        return int(status), list(found[: count.value])

    def led(self, mode: Any, drives: Sequence[float]) -> int:
        """The status of leading a mode, which is changed."""
        given = (ctypes.c_double * len(drives))(*drives)
        return int(self.library[f"{self.model.name}_nearest_mode"](ctypes.byref(mode), given))


def compiled_modes(model: ModesModel, directory: Path, flags: Sequence[str] = ()) -> CompiledModes:
    """Compile the files of a folder, with further flags of the compiler; raises CompileError."""
    library = directory / f"lib{model.name}_modes.so"
    compile_c(directory / f"{model.name}_modes.c", library, flags=("-ffp-contract=off", *flags))
    return CompiledModes(ctypes.CDLL(str(library)), model)


def own_compiled_modes(model: ModesModel) -> CompiledModes:
    """The same where nobody asked for files; raises CompileError."""
    with tempfile.TemporaryDirectory() as folder:
        for file, text in print_modes(model).items():
            (Path(folder) / file).write_text(text, encoding="utf-8")
        return compiled_modes(model, Path(folder))
