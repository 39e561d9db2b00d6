"""Units of matrices: in another unit of length, every entry changes as its unit says, and nothing else does."""

from __future__ import annotations

from functools import cache

import numpy as np

from symscrew.description import parse_description
from symscrew.model import Model, derive

# A crank of 0.2 and a rod of 0.5 to a slider, all in so many units of length.
TEXT = """
[mechanism]
name = "slider"
platform = "block"
[parameters.L]
value = {length}
unit = "m"
[bodies.crank]
mass = 1
com = [0, 0, 0]
[bodies.rod]
mass = 1
com = [0, 0, 0]
[bodies.block]
mass = 1
com = [0, 0, 0]
[joints.crank_R]
type = "R"
parent = "base"
child = "crank"
point = [0, 0, "L/10"]
axes = [[0, 0, 1]]
driven = true
[joints.rod_R]
type = "R"
parent = "crank"
child = "rod"
point = [0, "0.2*L", 0]
axes = [[0, 0, 1]]
[joints.block_P]
type = "P"
parent = "base"
child = "block"
point = ["0.4*L", 0, 0]
axes = [[1, 0, 0]]
[joints.block_R]
type = "R"
parent = "rod"
child = "block"
point = ["0.4*L", "-0.1*L", 0]
axes = [[0, 0, 1]]
"""
LENGTH = 1000


@cache
def model(length: int) -> Model:
    return derive(parse_description(TEXT.format(length=length)))


def exponent(unit: str) -> int:
    over, _, under = unit.partition("/")
    return (over == "m") - (under == "m")


def test_jacobians_change_as_their_units_say() -> None:
    seen = set()
    for name in ("platform_jacobian", "closure_jacobian", "null_space", "joint_screws"):
        large, small = model(LENGTH), model(1)
        port, *_ = small.programs[name].outputs
        (given,) = small.programs[name].inputs
        q = np.array([0.02 if unit == "m" else 0.1 for unit in given.units])
        factors = np.array([LENGTH if unit == "m" else 1 for unit in given.units])
        (one, *_), (other, *_) = small(name, q), large(name, q * factors)
        powers = np.array([float(LENGTH) ** exponent(unit) for unit in port.units])
        value = np.asarray(one).ravel(order="F")
        assert np.allclose(value * powers, np.asarray(other).ravel(order="F"), rtol=1e-12, atol=1e-9), name
        assert np.abs(value).max() > 0.1
        seen |= {unit for unit, entry in zip(port.units, value, strict=True) if abs(entry) > 1e-3}
    assert {"1", "m/rad"} <= seen
