"""Mechanisms of the hard cases. Numbers are given as exact texts; motions with a closed form have it beside them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipj, ellipkinc

import symscrew
from symscrew.description import toml_file
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.model import Model, derive

X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
EXAMPLES = Path(__file__).parents[2] / "examples" / "benchmarks" / "mechanisms"


def changed(text: str, *replacements: tuple[str, str]) -> Mechanism:
    """The mechanism of a TOML text with parts of the text replaced; each part must be there."""
    for old, new in replacements:
        assert old in text, old
        text = text.replace(old, new)
    return toml_file.parse_description(text)


def catalogue_text(name: str) -> str:
    """The TOML text of a catalogue mechanism."""
    return (Path(symscrew.__file__).parent / "catalogue" / f"{name}.toml").read_text()


def benchmark_text(name: str) -> str:
    """The TOML text of a benchmark mechanism."""
    return (EXAMPLES / f"{name}.toml").read_text()


def four_bars(
    count: int = 2,
    *,
    width: str = "1",
    length: str = "1",
    link: str = "1",
    coupler: str = "1",
    crank_inertia: str = "1/12",
) -> Mechanism:
    """`count` four-bars in a row: cranks of `length` [m], couplers of `width`, masses of `link` and `coupler` [kg].

    Cranks stay parallel, so that the angle th from upright obeys J th'' = c sin th with J = (count + 1) link
    length^2 (1/4 + crank_inertia) + count coupler length^2, c = ((count + 1) link/2 + count coupler) g length.
    """
    builder = MechanismBuilder(f"four_bars_{count}")
    inertia = f"({crank_inertia})*({link})*({length})^2"
    other = f"({coupler})*({width})^2/12"
    for k in range(count + 1):
        builder.body(f"crank{k}", mass=link, com=[f"{k}*({width})", f"({length})/2", 0], inertia=[inertia, 0, inertia])
    for k in range(count):
        at = [f"({k} + 1/2)*({width})", length, 0]
        builder.body(f"coupler{k}", mass=coupler, com=at, inertia=[0, other, other])
    for k in range(count + 1):
        builder.joint(
            f"A{k}", "R", parent="base", child=f"crank{k}", point=[f"{k}*({width})", 0, 0], axes=[Z], driven=k == 0
        )
    for k in range(count):
        left, right = [f"{k}*({width})", length, 0], [f"{k + 1}*({width})", length, 0]
        builder.joint(f"B{k}", "R", parent=f"crank{k}", child=f"coupler{k}", point=left, axes=[Z])
        builder.joint(f"C{k}", "R", parent=f"coupler{k}", child=f"crank{k + 1}", point=right, axes=[Z])
    return builder.build()


def swung(inertia: float, moment: float, rate: float, t: np.ndarray) -> np.ndarray:
    """th(t) of inertia th'' = moment sin th with th = 0, th' = rate at 0, turning over (Jacobi's amplitude)."""
    omega = moment / inertia
    energy = rate**2 / 2 + omega
    w, m = np.sqrt((energy + omega) / 2), 2 * omega / (energy + omega)
    _, _, _, amplitude = ellipj(w * t + ellipkinc(-np.pi / 2, m), m)
    return np.asarray(np.pi + 2 * amplitude)


def coupling(bend: str, first: str = "0.02", second: str = "0.05") -> Mechanism:
    """Two shafts that meet at O under the angle `bend` [rad], joined by a massless cross: a universal joint as a loop.

    The first shaft lies along x, axial inertias [kg m^2]. A spherical four-bar: the loop has 3 redundant rows.
    """
    c, s = f"cos({bend})", f"sin({bend})"
    builder = MechanismBuilder("coupling")
    builder.body("driver", mass=1, com=[0, 0, 0], inertia=[first, first, first])
    builder.body("cross")
    builder.body("driven", mass=1, com=[0, 0, 0], inertia=[second, second, second])
    builder.joint("A", "R", parent="base", child="driver", point=[0, 0, 0], axes=[X], driven=True)
    builder.joint("B", "R", parent="driver", child="cross", point=[0, 0, 0], axes=[Z])
    builder.joint("C", "R", parent="cross", child="driven", point=[0, 0, 0], axes=[[f"-{s}", c, 0]])
    builder.joint("D", "R", parent="base", child="driven", point=[0, 0, 0], axes=[[c, s, 0]])
    return builder.build()


def chain(
    name: str,
    *joints: tuple[str, str, str, str, Sequence[Any], Sequence[Any]],
    driven: str = "",
    **bodies: dict[str, Any],
) -> Mechanism:
    """A mechanism of joints (name, type, parent, child, point, axes) and bodies with the builder's keys."""
    builder = MechanismBuilder(name)
    for body, keys in bodies.items():
        builder.body(body, **keys)
    for joint, kind, parent, child, point, axes in joints:
        options = {"axes": list(axes)} if axes else {}
        builder.joint(joint, kind, parent=parent, child=child, point=list(point), driven=joint == driven, **options)
    return builder.build()


def on_the_locus() -> float:
    """The tilt [rad] at which L = R sin(theta), from the geometry of limb 1."""

    def gap(angle: float) -> float:
        x, z = -0.5, 0.3 * np.sqrt(3)
        leg = np.array([np.cos(angle) * x + np.sin(angle) * z + 0.8, -np.sin(angle) * x + np.cos(angle) * z])
        return float(np.linalg.norm(leg) - 0.8 * leg[0] / np.linalg.norm(leg))

    return float(brentq(gap, -0.6, 0.0, xtol=1e-15))


@cache
def reaching() -> Model:
    """Distal rods of 0.6 m, cranks of 0.25 m at x = +-0.375 m: the elbows reach a distance of 1.25 m."""
    builder = MechanismBuilder("reaching", platform="distal_left")
    x, z = "3/8 + 3/20", "1/5"  # crank in the direction (0.6, 0.8); elbows 1.05 m apart
    height = "1/5 + sqrt(9/25 - (21/40)^2)"
    for side, sign in (("left", "-"), ("right", "")):
        builder.body(f"crank_{side}", mass=1, com=[f"{sign}9/20", 0, "1/10"], inertia=["1/100", "1/100", "1/100"])
        builder.body(f"distal_{side}", mass=1, com=[f"{sign}21/80", 0, "2/5"], inertia=["1/50", "1/50", "1/50"])
        builder.joint(
            f"A_{side}",
            "R",
            parent="base",
            child=f"crank_{side}",
            point=[f"{sign}3/8", 0, 0],
            axes=[[0, 1, 0]],
            driven=True,
        )
        builder.joint(
            f"E_{side}",
            "R",
            parent=f"crank_{side}",
            child=f"distal_{side}",
            point=[f"{sign}({x})", 0, z],
            axes=[[0, 1, 0]],
        )
    builder.joint("tip", "R", parent="distal_right", child="distal_left", point=[0, 0, height], axes=[[0, 1, 0]])
    builder.point("tool", body="distal_left", at=[0, 0, height])
    return derive(builder.build(), independent=["A_left", "A_right"])
