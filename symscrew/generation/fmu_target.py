"""Target "fmu": a functional mock-up unit of FMI 3.0 without binaries, at rest in the reference configuration."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping, Sequence

from symscrew.fmu import archive, at_rest, compare_unit, readme_section, unit_contents
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.runtime import find_compiler


def files(order: Order) -> Mapping[str, bytes]:
    """<name>.fmu."""
    model = order.model
    return {f"{model.name}.fmu": archive(unit_contents(at_rest(model.mechanism, model.effects)))}


def section(order: Order) -> Sequence[str]:
    """How to compile and run the unit."""
    return readme_section(order.model.name, order.model.system.tree.q[0].label)


def compare(case: Case) -> Iterator[Finding]:
    """What is in the unit that has just been made, compiled and run."""
    if find_compiler() is None:
        yield True, "no C compiler here (apt install gcc): FMU neither compiled nor run"
        return
    with zipfile.ZipFile(case.fresh / f"{case.model.name}.fmu") as unit:
        yield from compare_unit({name: unit.read(name) for name in unit.namelist()}, case.model)
