"""The medium of an MJCF file: what its density, viscosity and wind do to every body, as drag of the body's inertia box.

    <option density viscosity wind> and a body's moments I, mass m --> a table `drag`: sides of the box, its axes

A homogeneous box has I_x = m (b^2 + c^2)/12 and so on, hence sides a^2 = 6 (I_y + I_z - I_x)/m. Geoms with a fluidshape
of their own have another model, which is left out. Source:
https://mujoco.readthedocs.io/en/stable/computation/fluid.html, inertia model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from symscrew.formats.draft import Draft, RawBody
from symscrew.formats.rigid_displacements import (
    CONTEXT,
    Real,
    Rotation,
    exact,
    product,
    real,
    transposed,
    triple,
)
from symscrew.formats.safe_xml import Element, elements, numbers

QUANTITIES = {"density": "0", "viscosity": "0", "wind": "0 0 0"}
THIN = real("1e-15")
"""The least square of a side [m^2], as in MuJoCo: that of a body which is a line or a point."""
ALIKE = real("1e-9")
"""Of the largest moment: two that differ by less have no axes of their own that files' digits tell."""


def medium(root: Element) -> dict[str, list[Real]] | None:
    """What the options say of the medium; None where it does nothing."""
    found = {key: [real(v) for v in text.split()] for key, text in QUANTITIES.items()}
    for option in elements(root, "option"):
        for key, text in QUANTITIES.items():
            if key in option.attrib:
                count = len(text.split())
                found[key] = [real(v) for v in numbers(option.attrib[key], f"<option>, {key}", count)]
    return found if found["density"][0] != 0 or found["viscosity"][0] != 0 else None


def add_drags(draft: Draft, given: Mapping[str, list[Real]] | None) -> None:
    """A drag for every body with mass, where there is a medium."""
    if given is None:
        return
    common: dict[str, Any] = {key: float(given[key][0]) for key in ("density", "viscosity") if given[key][0] != 0}
    if any(given["wind"]):
        common["wind"] = [float(v) for v in given["wind"]]
    for body in draft.bodies:
        if body.mass is None or body.inertia is None or body.mass == 0:
            continue
        axes, moments = _principal(body, body.inertia)
        if body.axes is None and _alike(moments):
            draft.ledger.changed.append(
                f"medium, {body.name}: two of its principal moments are equal, about axes that the file does not give; "
                "its drag is that of a box whose sides there may be turned against the engine's"
            )
        total = sum(moments, start=real(0))
        sides = [float(CONTEXT.sqrt(max(THIN, (total - 2 * moment) * 6 / body.mass))) for moment in moments]
        columns = [[float(exact(c)) for c in column] for column in transposed(axes)]
        draft.drags[body.name] = {"sides": sides, "axes": columns, **common}
    if draft.drags:
        draft.ledger.turned("medium: drag of bodies", len(draft.drags))


def _alike(moments: Sequence[Real]) -> bool:
    """Whether two of three moments are equal, so that axes across them are anybody's choice, of a cube all three."""
    low, middle, high = sorted(moments)
    return bool(min(middle - low, high - middle) < ALIKE * high)


def _principal(body: RawBody, inertia: Rotation) -> tuple[Rotation, tuple[Real, Real, Real]]:
    """Principal axes as columns, and the moments about them; the file's own axes where it gives them."""
    if body.axes is not None:
        x, y, z = product(transposed(body.axes), product(inertia, body.axes))
        return body.axes, (x[0], y[1], z[2])
    values, vectors = CONTEXT.eigsy(CONTEXT.matrix([list(row) for row in inertia]))
    rows = [triple([vectors[i, j] for j in range(3)]) for i in range(3)]
    return (rows[0], rows[1], rows[2]), (values[0], values[1], values[2])
