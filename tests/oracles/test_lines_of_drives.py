"""Drives of sliders push along the line through the joint's point: reactions of random arms against method B."""

from __future__ import annotations

import numpy as np
import pytest
from support.further_mechanisms import unit
from support.model_states import body_states
from sympy import Rational

from symscrew.description import Mechanism, MechanismBuilder
from symscrew.model import derive
from symscrew.reference import newton_euler, numeric

AXES = ([1, 2, 2], [2, -2, 1], [0, 3, 4], [3, 4, 0])
DRIVEN = {"R": [0], "P": [0], "C": [0, 1], "E": [0, 1, 2]}


def arm(kind: str, turned_round: bool, seed: int) -> Mechanism:
    """Three driven joints in a row, the second of that kind, or two where it stands on the ground, all lines aside."""
    random = np.random.default_rng(seed)

    def point() -> list[Rational]:
        return [Rational(int(k), 10) for k in random.integers(-20, 21, 3)]

    kinds = [kind, "R"] if seed % 2 else ["R", kind, "P"]
    builder = MechanismBuilder("arm")
    links = ["base", "a", "b", "c"][: len(kinds) + 1]
    for link in links[1:]:
        builder.body(link, mass=2, com=point(), inertia=[[3, 0, 1], [0, 4, 1], [1, 1, 5]])
    for k, made in enumerate(kinds):
        ends = links[k : k + 2][:: -1 if turned_round and made == kind else 1]
        axis = unit(AXES[random.integers(len(AXES))])
        builder.joint(f"J{k}", made, parent=ends[0], child=ends[1], point=point(), axes=[axis], driven=DRIVEN[made])
    return builder.build()


@pytest.mark.parametrize("turned_round", [False, True])
@pytest.mark.parametrize("kind", ["P", "C", "E"])
def test_reactions_leave_the_drives_on_their_lines(kind: str, turned_round: bool) -> None:
    for seed in range(2):
        found = derive(arm(kind, turned_round, seed))
        q, v, a = (x[:2] for x in found.test_inputs["joint_reactions"])
        (u, reactions), status = found("joint_reactions", q, v, a)
        expected = newton_euler(numeric(found.mechanism), body_states(found, q, v, a))
        wanted = np.concatenate([expected.reactions[joint] for joint in found.mechanism.joints], axis=-1)
        assert (status == 0).all()
        assert np.abs(u - expected.drives).max() < 1e-11 * np.abs(expected.drives).max()
        assert np.abs(reactions - wanted).max() < 1e-11 * np.abs(wanted).max()
