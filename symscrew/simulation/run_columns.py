"""A run by name: its columns over time, and what its joints transmit.

arrays of a run, model --labels--> columns `q.LABEL`, `v.LABEL`, `u.LABEL` ...; wrenches by the joint's name
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.program import Program
from symscrew.results import Columns, JointWrenches

WRENCH = 6  # components of a joint's reaction


def labels_of(model: Model, *, driven: bool) -> dict[str, list[str]]:
    """Labels of the columns of q, v and u; `driven`: whether there are any of u."""
    tree = model.system.tree
    u = next((p.labels for p in model.programs["forward_dynamics"].inputs if p.name == "u"), ())
    return {"q": [c.label for c in tree.q], "v": [c.label for c in tree.v], "u": list(u) if driven else []}


def columns_of(
    name: str, model: Model, t: np.ndarray, parts: Mapping[str, np.ndarray], *, x_labels: Sequence[str]
) -> Columns:
    """Columns of a run from its arrays (n, columns) by name: q, v, u, x, energy, closure_error, energy_balance."""
    tree = model.system.tree
    names = labels_of(model, driven=parts["u"].shape[1] > 0)
    forward = model.programs["forward_dynamics"]
    units = {port.name: port.units for port in forward.inputs}
    units |= {"q": tuple(c.unit for c in tree.q), "v": tuple(c.unit for c in tree.v)}
    found: dict[str, np.ndarray] = {}
    of: dict[str, str] = {}
    for key in ("q", "v", "u"):
        for k, label in enumerate(names[key]):
            found[f"{key}.{label}"], of[f"{key}.{label}"] = parts[key][:, k], units[key][k]
    known = dict(zip(next((p.labels for p in forward.inputs if p.name == "x"), ()), units.get("x", ()), strict=True))
    for k, label in enumerate(x_labels):
        found[f"x.{label}"], of[f"x.{label}"] = parts["x"][:, k], known.get(label, "1")
    for k, label in enumerate(("kinetic", "potential")):
        found[f"energy.{label}"], of[f"energy.{label}"] = parts["energy"][:, k], "J"
    for key, unit in (("closure_error", "1"), ("energy_balance", "J")):
        found[key], of[key] = parts[key], unit
    return Columns(name, t, found, of)


def wrenches_along(model: Model, q: np.ndarray, reactions: np.ndarray | None, parameters: np.ndarray) -> JointWrenches:
    """Recorded reactions (n, 6 joints) by the joint's name.

    Raises:
        DescriptionError: none were recorded.
    """
    if reactions is None:
        raise DescriptionError("expected a scene that records reactions: set reactions = true in [scene]")
    known = {"q": q, "p": np.repeat(parameters[None], len(q), 0)}

    def along(function: str, rows: int) -> np.ndarray:
        program = model.programs[function]
        assert isinstance(program, Program)
        (found,), _ = model(function, *[known[port.name] for port in program.inputs])
        return _matrices(np.asarray(found), rows)

    poses = along("body_poses", 12)
    return JointWrenches(
        model.mechanism, reactions=_matrices(reactions, WRENCH), points=along("joint_points", 3), poses=poses
    )


def _matrices(flat: np.ndarray, rows: int) -> np.ndarray:
    """(n, rows, columns) from columns one after another."""
    return flat if flat.ndim > 2 else np.swapaxes(flat.reshape(len(flat), -1, rows), 1, 2)
