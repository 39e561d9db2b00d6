"""Mechanisms typed by hand as bare dataclasses, without builder, file or catalogue."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy

from symscrew.description.mechanism import Body, Joint, Mechanism, Point

Numbers = Sequence[Any]


def vector(values: Numbers) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    x, y, z = (exact(value) for value in values)
    return (x, y, z)


def exact(value: Any) -> sympy.Expr:
    """An integer, expression or the decimal that is typed, e.g. 0.1, exactly."""
    return sympy.Rational(str(value)) if isinstance(value, float) else sympy.Integer(0) + value


def body(name: str, mass: Any, com: Numbers, rows: Sequence[Numbers]) -> Body:
    a, b, c = (vector(row) for row in rows)
    return Body(name, mass=exact(mass), com=vector(com), inertia=(a, b, c))


def joint(
    name: str,
    kind: str,
    parent: str,
    child: str,
    point: Numbers,
    *axes: Numbers,
    driven: tuple[int, ...] = (),
    pitch: Any = None,
) -> Joint:
    return Joint(name, kind, parent, child, vector(point), tuple(vector(a) for a in axes), pitch, driven)


def mechanism(name: str, bodies: Iterable[Body], joints: Iterable[Joint], *points: Point) -> Mechanism:
    listed = [Body("ground"), *bodies]
    return Mechanism(
        name,
        "ground",
        {b.name: b for b in listed},
        {j.name: j for j in joints},
        {p.name: p for p in points},
    )


def diagonal(a: Any, b: Any, c: Any) -> list[list[Any]]:
    return [[a, 0, 0], [0, b, 0], [0, 0, c]]


def pendulum(length: Any, mass: Any, inertia: Any) -> Mechanism:
    """A rod about the x axis through O, hanging along -z, centre of mass at its middle, driven."""
    rod = body("rod", mass, (0, 0, -length / 2), diagonal(inertia, inertia, inertia / 10))
    pivot = joint("pivot", "R", "ground", "rod", (0, 0, 0), (1, 0, 0), driven=(0,))
    return mechanism("pendulum", [rod], [pivot])


def slider_crank(crank: Any, rod: Any, masses: Numbers, inertias: Numbers) -> Mechanism:
    """Crank about z at O, coupler, slider along x; stretched along x in the reference configuration.

    Centres of mass in the middle of crank and coupler, and at the slider's pin.
    """
    bodies = [
        body("crank", masses[0], (crank / 2, 0, 0), diagonal(inertias[0], inertias[0], inertias[0])),
        body("coupler", masses[1], (crank + rod / 2, 0, 0), diagonal(inertias[1], inertias[1], inertias[1])),
        body("slider", masses[2], (crank + rod, 0, 0), diagonal(1, 1, 1)),
    ]
    z, x = (0, 0, 1), (1, 0, 0)
    joints = [
        joint("main", "R", "ground", "crank", (0, 0, 0), z, driven=(0,)),
        joint("crank_pin", "R", "crank", "coupler", (crank, 0, 0), z),
        joint("wrist_pin", "R", "coupler", "slider", (crank + rod, 0, 0), z),
        joint("guide", "P", "ground", "slider", (crank + rod, 0, 0), x),
    ]
    return mechanism("slider_crank", bodies, joints)


def seed() -> Mechanism:
    """The paper's 3UPS-UPU-S (Tables 1 to 3, all exact)."""
    R, r, L = sympy.Rational(4, 5), sympy.Rational(1, 2), sympy.Rational(3, 5)
    H = L * sympy.sqrt(3) / 2
    E = sympy.Matrix([0, 0, H])
    bodies = [body("platform", 2.87, list(E), diagonal(68.7, 68.7, 92.1))]
    joints = []
    outward = [(-1, 0), (0, -1), (1, 0), (0, 1)]
    for i, (ox, oy) in enumerate(outward, start=1):
        radial, tangent = sympy.Matrix([ox, oy, 0]), sympy.Matrix([-oy, ox, 0])
        base, top = R * radial, r * radial + E
        along = (top - base) / L
        across = along.cross(tangent)
        frame = sympy.Matrix.hstack(along, tangent, across)
        spread = sympy.diag(exact(0.0556), exact(1.14), exact(1.16))
        inertia = (frame * spread * frame.T).applyfunc(sympy.simplify).tolist()
        bodies += [
            body(f"lower{i}", 1.42, list(base + along * L / 4), inertia),
            body(f"upper{i}", 1.42, list(top - along * L / 4), inertia),
        ]
        middle = list(base + along * L / 2)
        first, second = list(radial), list(tangent)
        joints += [
            joint(f"A{i}", "U", "ground", f"lower{i}", list(base), first, second),
            joint(f"B{i}", "P", f"lower{i}", f"upper{i}", middle, list(along), driven=(0,)),
        ]
        if i == 1:
            joints.append(joint("C1", "U", "upper1", "platform", list(top), list(across), second))
        else:
            joints.append(joint(f"C{i}", "S", f"upper{i}", "platform", list(top)))
    joints.append(joint("A5", "S", "ground", "platform", (0, 0, 0)))
    return mechanism("seed", bodies, joints, Point("E", "platform", vector(list(E))))


def tilted(a: float, b: float, c: float) -> list[list[float]]:
    """An inertia with products of inertia, admissible when a, b, c are similar."""
    return [[a, 0.02, -0.01], [0.02, b, 0.015], [-0.01, 0.015, c]]


def spatial_loop() -> Mechanism:
    """R-C-C-C in a loop, axes in general directions: one freedom, not overconstrained."""
    bodies = [
        body("crank", 1.5, (0.2, 0.1, 0.3), tilted(0.3, 0.35, 0.4)),
        body("coupler", 2, (0.7, 0.5, 0.4), tilted(0.5, 0.4, 0.35)),
        body("rocker", 0.8, (0.9, 0.1, 0.6), tilted(0.2, 0.25, 0.3)),
    ]
    third = sympy.Rational(1, 3)
    joints = [
        joint("a", "R", "ground", "crank", (0, 0, 0), (third, 2 * third, 2 * third), driven=(0,)),
        joint("b", "C", "crank", "coupler", (0.5, 0.2, 0.1), (0, 0.6, 0.8)),
        joint("c", "C", "coupler", "rocker", (1, 0.7, 0.3), (0.8, 0, -0.6)),
        joint("d", "C", "ground", "rocker", (0.9, -0.4, 0.5), (-2 * third, third, 2 * third)),
    ]
    return mechanism("spatial_loop", bodies, joints)


def mixed_loop() -> Mechanism:
    """A loop of E-U-S-P with three freedoms and five drives, a fixed, a massless and a free body.

    The ground is a child once; the free body hangs on a moving one.
    """
    bodies = [
        body("slab", 3, (0.1, 0.2, 0), tilted(0.3, 0.35, 0.4)),
        body("arm", 1, (0.4, 0.1, 0.4), tilted(0.2, 0.25, 0.3)),
        body("weight", 0.5, (0.5, 0.1, 0.6), tilted(0.1, 0.12, 0.14)),
        Body("pin"),
        body("fly", 0.7, (0, 2, 1), tilted(0.1, 0.12, 0.14)),
    ]
    joints = [
        joint("table", "E", "ground", "slab", (0, 0, 0), (0, 0.6, 0.8), driven=(0, 1, 2)),
        joint("tilt", "U", "slab", "arm", (0.2, 0.2, 0.1), (0.6, 0.8, 0), (0, 0, 1), driven=(0, 1)),
        joint("glue", "fixed", "arm", "weight", (0.5, 0, 0.5)),
        joint("ball", "S", "arm", "pin", (0.8, 0, 0.8)),
        joint("rail", "P", "pin", "ground", (0.8, 0, 0.8), (1, 0, 0)),
        joint("loose", "free", "slab", "fly", (0, 1.8, 1), driven=(0, 1, 2, 3, 4, 5)),
    ]
    return mechanism("mixed_loop", bodies, joints)
