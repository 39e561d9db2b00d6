"""One configuration by name: where all coordinates are when some are given.

model, {"limb5_S.qx": 0.05} --assemble--> AssembledConfiguration: .q, ["limb1_P"], .status
model, {"platform.tilt": "5deg"} --inverse kinematics--> the same
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from symscrew import notebook
from symscrew.description import given_value, numeric
from symscrew.errors import DescriptionError, did_you_mean, expect
from symscrew.kinematics import full_name
from symscrew.mobility import inverse_kinematics
from symscrew.model import Model
from symscrew.program import status_texts

Array = np.ndarray


@dataclass(frozen=True, repr=False)
class AssembledConfiguration:
    """Coordinates q (nq,) of a mechanism's tree with their labels and units; `ok` unless the loops do not close."""

    mechanism: str
    q: Array
    labels: tuple[str, ...]
    units: tuple[str, ...]
    code: int
    status: str

    def __repr__(self) -> str:
        return f"AssembledConfiguration({self.mechanism}: {len(self.q)} coordinates, {self.status})"

    @property
    def ok(self) -> bool:
        """Whether the loops are closed."""
        return self.code <= 0

    def __getitem__(self, label: str) -> float:
        """The coordinate of this label [rad, m]. Raises DescriptionError where there is none."""
        if label not in self.labels:
            raise DescriptionError(
                f"expected the label of a coordinate, got {label!r}; {did_you_mean(label, self.labels)}"
            )
        return float(self.q[self.labels.index(label)])

    def _repr_html_(self) -> str:
        rows = [(n, f"{x:.9g}", u) for n, x, u in zip(self.labels, self.q, self.units, strict=True)]
        return notebook.table(repr(self), ("coordinate", "value", "unit"), rows)


def assemble(model: Model, y: Mapping[str, float | str], guess: object = None) -> AssembledConfiguration:
    """The one configuration near a guess in which coordinates have these values.

    Every configuration in which the drives have given values, the assembly modes, is what `symscrew.assembly_modes` and
    the command `symscrew assemble` find. Independent coordinates go through the model's own function; where others are
    named, poses of the platform too, it is `symscrew.inverse_kinematics` that finds them all.

    Args:
        model: whose loops are closed.
        y: name of a coordinate -> its value [rad, m], or text with a unit, "20deg". Independent coordinates that are
            not named stay as in the guess; where others are named, what is not named follows from them.
        guess: q (nq,) nearby, on the same assembly branch, for independent coordinates alone; default: the reference
            configuration.

    Returns:
        The configuration; `ok` is False, with NaN, where the loops do not close from this guess.

    Raises:
        DescriptionError: a name of no coordinate, of one that is not independent beside a guess, or a value that is no
            number or in another unit.
        ValueError: a guess of another size.
    """
    expect(model, Model)
    expect(y, Mapping)
    tree = model.system.tree
    labels = tuple(c.label for c in tree.q)
    start = np.asarray(model.system.reference if guess is None else guess, dtype=float)
    if start.shape != (len(labels),):
        raise ValueError(f"expected a guess of shape ({len(labels)},), got {start.shape}")
    program = model.programs.get("assemble")
    independent = program.inputs[0].labels if program is not None else labels
    y = {label if label in independent else full_name(model.mechanism, label): value for label, value in y.items()}
    others = [label for label in y if label not in independent]
    if others and guess is not None:
        raise DescriptionError(
            f"{others[0]}: expected one of the independent coordinates {', '.join(independent)} beside a guess; "
            f"{did_you_mean(others[0], independent)} (without one any is taken, poses too)"
        )
    if others:
        return _placed(model, y, labels)
    units = {c.label: c.unit for c in tree.q}
    given = {label: _number(value, units[label], label) for label, value in y.items()}
    wanted = np.array([given.get(label, start[labels.index(label)]) for label in independent])
    if program is None:
        q, code = wanted, 0
    else:
        known = {"y": wanted, "guess": start, "p": model.system.parameter_values}
        (found, *_), codes = model("assemble", *[known[port.name] for port in program.inputs])
        q, code = np.asarray(found), int(codes)
    text = status_texts(*model.programs.values())[code]
    return AssembledConfiguration(model.name, q, labels, tuple(c.unit for c in tree.q), code, text)


def _placed(model: Model, at: Mapping[str, float | str], labels: tuple[str, ...]) -> AssembledConfiguration:
    """The configuration by coordinates of any kind."""
    found = inverse_kinematics(model.mechanism, at)
    units = tuple(c.unit for c in model.system.tree.q)
    return AssembledConfiguration(model.name, found.q, labels, units, found.code, "success" if found.ok else found.text)


def _number(value: float | str, unit: str, label: str) -> float:
    if not isinstance(value, str):
        return float(value)
    return float(numeric(given_value(value, where=label).measured_in(unit, label), where=label))
