"""Loops of two joints between the same two bodies: the limb of the cut joint has no link of its own."""

from __future__ import annotations

import numpy as np

from symscrew import MechanismBuilder
from symscrew.model import derive


def test_rows_are_the_rates_of_what_is_open() -> None:
    builder = MechanismBuilder("twice")
    for name, com in (("a", [0, 0, 1]), ("b", [1, 0, 1])):
        builder.body(name, mass=1, com=com, inertia=[1, 1, 1])
    builder.joint("A", "R", parent="base", child="a", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    builder.joint("B", "S", parent="a", child="b", point=[1, 0, 0])
    builder.joint("C", "S", parent="a", child="b", point=[2, 0, 0])
    model = derive(builder.build()).only(["closure", "closure_jacobian", "joint_rates"])
    (q,), (rows, columns) = model.test_inputs["closure_jacobian"], model.programs["closure_jacobian"].outputs[0].shape
    v, step = np.random.default_rng(1).uniform(-1, 1, (len(q), columns)), 1e-6
    moved = model("joint_rates", q, v)[0][0][:, :columns]  # of the tree's joints, in the parent's axes
    ahead, back = (model("closure", model.system.advance(q, sign * step * moved))[0][0] for sign in (1, -1))
    jacobian = model("closure_jacobian", q)[0][0].reshape(len(q), columns, rows)
    np.testing.assert_allclose(np.einsum("scr,sc->sr", jacobian, v), (ahead - back) / (2 * step), atol=1e-8)
