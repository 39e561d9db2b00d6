"""Target "numpy": a module of NumPy functions that needs nothing of this package."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType

from symscrew.export import print_numpy
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import compare_values


def files(order: Order) -> Mapping[str, str]:
    """<name>_numpy.py."""
    return print_numpy(order.model)


def compare(case: Case) -> Iterator[Finding]:
    """The module, imported from the file just generated."""
    module = imported(case.fresh / f"{case.model.name}_numpy.py")
    yield compare_values("NumPy module", case.model, case.expected, lambda name, x: getattr(module, name)(*x))


def imported(path: Path) -> ModuleType:
    """A module from a file, without entering it among the imported modules."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
