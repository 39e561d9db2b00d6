"""Counts of operations as they stand, in data/operation_counts.json: kind of model -> mechanism -> function -> total.

Counts are deterministic: one that rises is a change of the derivation, and needs a reason. One that falls is
recorded by `PYTHONPATH=.:tests python -m support.operation_counts`, from the repository's root.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path

from benchmarks.mechanisms import chain, platform

from support.model_states import differentiated, model
from support.rod_mechanisms import model as with_rods
from symscrew import catalogue
from symscrew.model import Model, derive
from symscrew.studies.accuracy.growth_study import four_bars

FILE = Path(__file__).parents[1] / "data" / "operation_counts.json"


def in_one_mode(name: str) -> Model:
    return derive(catalogue.load(name), one_mode=True)


def sized(name: str) -> Model:
    """A mechanism of so many joints, limbs or loops, such as "chain 8"."""
    kind, size = name.split()
    return derive({"platform": platform, "chain": chain, "four_bars": four_bars}[kind](int(size)))


SIZED = ("chain 8", "chain 12", "chain 16", "chain 20", "platform 4", "platform 8", "platform 12")
KINDS: dict[str, tuple[Iterable[str], Callable[[str], Model]]] = {
    "plain": (catalogue.names(), model),
    "derivatives": (catalogue.names(), differentiated),
    "one mode": (("delta", "three_ups_upu_s_physical"), in_one_mode),
    "rods": (("hexapod", "rotary_hexapod", "hung_platform", "braced_arm", "turning_hexapod"), with_rods),
    "sized": (SIZED, sized),
}


def recorded(kind: str, name: str) -> dict[str, int]:
    """Function to count of a model."""
    found: dict[str, int] = json.loads(FILE.read_text(encoding="utf-8"))[kind][name]
    return found


def counted(found: Model) -> dict[str, int]:
    return {name: program.operations["total"] for name, program in found.programs.items()}


def rise(kind: str, name: str, found: Model) -> dict[str, tuple[int | None, int]]:
    """Functions whose count is above the recorded one, or that have none: {} if all is well."""
    limits = recorded(kind, name)
    return {f: (limits.get(f), n) for f, n in counted(found).items() if n > limits.get(f, -1)}


if __name__ == "__main__":
    counts = {kind: {name: counted(made(name)) for name in names} for kind, (names, made) in KINDS.items()}
    FILE.write_text(json.dumps(counts, indent=1) + "\n", encoding="utf-8")
