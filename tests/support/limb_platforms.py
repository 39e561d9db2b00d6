"""Platforms on three equal limbs whose plane stands on a circle: PRS, RPS, RRS."""

from __future__ import annotations

from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism

LIMBS = {
    # joint points in the limb's radial plane (x outwards, z up) and axes, before turning the limb about z
    "PRS": ([(1, 0), (1, "1/5"), ("1/2", 1)], ["x", "t", None]),
    "RPS": ([(1, 0), None, ("1/2", 1)], ["t", None, None]),
    "RRS": ([(1, 0), ("13/10", "1/2"), ("1/2", 1)], ["t", "t", None]),
}
TURNS = (("1", "0"), ("-1/2", "sqrt(3)/2"), ("-1/2", "-sqrt(3)/2"))


def platform(kind: str) -> Mechanism:
    """Three equal limbs at 120 degrees around z, a platform with mass on top."""
    points, axes = LIMBS[kind]
    builder = MechanismBuilder(f"three_{kind.lower()}", platform="top")
    builder.body("top", mass=3, com=[0, 0, 1], inertia=["1/10", "1/10", "1/5"])
    for k, (c, s) in enumerate(TURNS):
        place = [None if p is None else [f"({p[0]})*({c})", f"({p[0]})*({s})", p[1]] for p in points]
        named = {"x": [[c, s, 0]], "t": [[f"-({s})", c, 0]], None: []}
        builder.limb(
            f"leg{k + 1}",
            kind,
            base="base",
            tip="top",
            points=[p for p in place if p is not None],
            axes=[named[a] for a in axes],
            mass=[1, 1],
            com=[place[0], place[-1]],
            inertia=[["1/100", "1/100", "1/100"]] * 2,
        )
    return builder.build()
