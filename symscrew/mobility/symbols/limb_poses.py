"""Limbs away from the reference configuration: constraints in the displacements of the limb's own joints.

    S_k(q) = Ad(exp(S_1 q_1) ... exp(S_(k-1) q_(k-1))) S_k --reciprocal--> constraints (f ; m) of q_2 ... q_(n-1)

The screws of a serial chain depend on its own coordinates only.
The first joint carries the whole limb, and the last nothing, so neither displacement matters in axes that move with
the first joint: for the seed's UPU limb the second angle, the slider and the fourth angle are left, and eqs. (11)
to (18) hold with symbols for all of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import sympy
from sympy.simplify.fu import TR10i

from symscrew.algebra import IDENTITY, Matrix, add, cross, transform
from symscrew.algebra import product as matrix_product
from symscrew.description import Joint, Mechanism, Motion, Parameter
from symscrew.mobility.symbols.exact_screws import unmeasured_plane
from symscrew.mobility.symbols.further_losses import place_of_loss
from symscrew.mobility.symbols.generators import Generators, NotPolynomialError, Poly
from symscrew.mobility.symbols.loci_at_points import Shape, limb_loses, reference_screws, true_loci
from symscrew.mobility.symbols.locus import Locus
from symscrew.mobility.symbols.loop_motions import FormulaTooLargeError, motions_by_minors
from symscrew.mobility.symbols.polynomial_screws import SymbolicScrews, Vector, expressions_of

LARGEST_SHOWN = 12
"""Terms of a component of a wrench: a line. Where one is longer, fewer displacements get symbols, and at last none; a
longer locus is left out. The result says both."""
MOST_SYMBOLS = 3
"""Displacements that are given symbols: all that a limb of five freedoms has between its first and its last joint. Of
more, and where the result is too long, those nearest to the tip stay in the reference, and the result says so."""

NONE_FOUND = "its screws may become dependent where several conditions hold at once; no such place was found by looking"


@dataclass(frozen=True)
class LimbPose:
    """Constraints (f ; m) of a limb with its own joints displaced by `displacements` from the reference.

    `of`: joint and index of each displacement; the axes move with the limb's first joint `carried_by`.
    `further`: a place beside the loci at which the screws are dependent, where one was found by looking; empty where it
    is known that there is none. `not_tried`: joints that have no symbol, and loci that are too long to be shown, and
    that none was found, a sentence each.
    """

    name: str
    displacements: tuple[sympy.Symbol, ...]
    of: tuple[str, ...]
    carried_by: str
    constraints: tuple[Vector, ...]
    loci: tuple[Locus, ...]
    not_tried: tuple[str, ...] = ()
    further: Mapping[sympy.Symbol, float] = field(default_factory=dict)


@dataclass(frozen=True)
class _Freedom:
    """An elementary motion in the order from base to tip; `sense` -1 where the joint is passed from child to parent."""

    joint: Joint
    index: int
    motion: Motion
    sense: int


def limb_pose(mechanism: Mechanism, name: str) -> LimbPose | str:
    """The constraints of a limb in its own displacements, or a sentence why they are not given."""
    chain = _chain(mechanism, name)
    if sum(f.motion.freedom for f in chain) >= 6:
        return "six joint freedoms: it constrains nothing unless they become dependent"
    inner = chain[1:-1]
    if any(f.motion.spherical for f in inner):
        return "a spherical joint inside the limb has no angles to be symbols"
    if not inner:
        return "no displacement inside the limb: its constraints keep their form and move with its first joint"
    if rounded := rounded_axis([f.joint for f in inner], mechanism):
        return rounded
    if unmeasured := unmeasured_plane([f.joint for f in inner], mechanism.number):
        return unmeasured
    reason = f"more than {MOST_SYMBOLS} symbols"
    for count in range(min(len(inner), MOST_SYMBOLS), 0, -1):
        symbols = _symbols(mechanism, inner[:count])
        try:
            found = _posed(mechanism, name, chain, symbols)
        except NotPolynomialError as error:
            return f"no symbols: {error}"
        except FormulaTooLargeError as error:
            reason = str(error)
            continue
        resting = ", ".join(f.joint.name for f in inner[count:])
        left_out = (f"{name}: {resting} stays in the reference configuration, without a symbol: {reason}",)
        return replace(found, not_tried=(*(left_out if resting else ()), *found.not_tried))
    return f"the closed form is not of reasonable size: {reason}"


def _chain(mechanism: Mechanism, name: str) -> list[_Freedom]:
    body = mechanism.ground
    chain: list[_Freedom] = []
    for joint_name in mechanism.limbs[name].joints:
        joint = mechanism.joints[joint_name]
        motions = list(enumerate(joint.kind.motions))
        forward = joint.parent == body
        if not forward:
            motions.reverse()
        body = joint.child if forward else joint.parent
        chain += [_Freedom(joint, k, motion, 1 if forward else -1) for k, motion in motions]
    return chain


def rounded_axis(joints: Iterable[Joint], mechanism: Mechanism) -> str:
    """Why there is no exact unit screw of an axis whose length is one only to rounding; empty where all have it."""
    for joint in joints:
        for axis in joint.axes:
            square = sum(mechanism.number(c) ** 2 for c in axis)
            if square.is_Rational and square != 1:
                return (
                    f"no symbols: an axis of {joint.name} has unit length only to {abs(float(square - 1)):.0e}, "
                    "so no exact rotation about it; write it as a direction over its length"
                )
    return ""


def _symbols(mechanism: Mechanism, inner: Sequence[_Freedom]) -> list[sympy.Symbol]:
    symbols = []
    for k, freedom in enumerate(inner, start=2):
        name = f"{'d' if freedom.motion.prismatic else 'theta'}_{k}"
        while name in mechanism.parameters:
            name += "_"
        symbols.append(sympy.Symbol(name, real=True))
    return symbols


def _posed(mechanism: Mechanism, name: str, chain: list[_Freedom], symbols: list[sympy.Symbol]) -> LimbPose:
    extra = {s.name: Parameter(s.name, sympy.Integer(0)) for s in symbols}
    widened = replace(mechanism, parameters={**mechanism.parameters, **extra})
    joints = [mechanism.joints[j] for j in mechanism.limbs[name].joints]
    needed = [e for joint in joints for e in expressions_of(joint)]
    displaced = chain[1 : 1 + len(symbols)]
    for freedom, symbol in zip(displaced, symbols, strict=True):
        needed += [symbol] if freedom.motion.prismatic else [sympy.sin(symbol), sympy.cos(symbol)]
        if freedom.motion.helical:
            raise NotPolynomialError("a helical joint has its angle both as such and in sines")
    work = SymbolicScrews(widened, Generators(widened, needed))
    screws = _displaced_screws(work, chain, symbols)
    solved = motions_by_minors(work, [[*screw[3:], *screw[:3]] for screw in screws], 6)
    wrenches, dependent = solved.vectors, solved.dependent
    _check_size(wrenches)
    parts = work.ring.factors(dependent)
    shown = [part for part in parts if len(part.terms()) <= LARGEST_SHOWN]
    not_tried = [
        f"{name}: a locus of {len(part.terms())} terms, where its screws become dependent, is not shown"
        for part in parts
        if part not in shown
    ]
    loci = [
        Locus("limb", name, _read(work, part, symbols), "the screws of the limb become dependent") for part in shown
    ]
    for wrench in wrenches:
        for half, other, kind, meaning in (
            (wrench[:3], wrench[3:], "couple", "the constraint force becomes a couple"),
            (wrench[3:], wrench[:3], "through O", "the constraint is a force through O"),
        ):
            if any(half) and any(other):
                parts = work.ring.factors(work.ring.common_factor(half))
                loci += [Locus(kind, name, _read(work, part, symbols), meaning) for part in parts]
    places = [(f.joint.name, f.index, f.sense, symbol) for f, symbol in zip(displaced, symbols, strict=True)]
    first = chain[0]
    found = true_loci(Shape(mechanism, places), loci)
    said = [locus for locus in found if locus.kind == "limb"]
    further = None
    # a factor that is zero where rank is kept is one of the rows that were chosen, and others take their place there
    if not solved.all_listed or len(said) < len(work.ring.factors(dependent)):
        further = _further(mechanism, chain, symbols, said)
        further = further if further and limb_loses(mechanism, name, places, further) else None
        not_tried += [] if further else [f"{name}: {NONE_FOUND}"]
    return LimbPose(
        name,
        tuple(symbols),
        tuple(f"{f.joint.name}.{f.index}" if len(f.joint.kind.motions) > 1 else f.joint.name
              for f in displaced),
        first.joint.name,
        tuple(tuple(_read(work, c, symbols) for c in wrench) for wrench in wrenches),
        found,
        tuple(not_tried),
        further or {},
    )  # fmt: skip


def _further(
    mechanism: Mechanism, chain: Sequence[_Freedom], symbols: Sequence[sympy.Symbol], loci: Sequence[Locus]
) -> Mapping[sympy.Symbol, float] | None:
    screws, size = reference_screws(mechanism)
    starts = [0]
    for freedom in chain:
        starts.append(starts[-1] + freedom.motion.freedom)
    rows = [screws[f.joint.name][f.joint.kind.starts[f.index] + k] for f in chain for k in range(f.motion.freedom)]
    displaced = [(starts[k], float(f.sense), symbol) for k, (f, symbol) in
                 enumerate(zip(chain[1:], symbols, strict=False), start=1)]  # fmt: skip
    values = {p.symbol: p.value for p in mechanism.parameters.values()}
    return place_of_loss(np.array(rows), displaced, [locus.expression.xreplace(values) for locus in loci], size)


def _read(work: SymbolicScrews, poly: Poly, symbols: Sequence[sympy.Symbol]) -> sympy.Expr:
    """The polynomial ordered by the displacements, their coefficients factored; sines of sums of angles as such."""
    generators = [g for s in symbols for g in (s, sympy.sin(s), sympy.cos(s))]
    expression = sympy.expand(work.ring.expression(work.ring.shortest(poly)))
    collected = sympy.collect(expression, generators, sympy.factor)
    turning = [s for s in symbols if expression.has(sympy.sin(s)) or expression.has(sympy.cos(s))]
    if len(turning) < 2:
        return collected
    return min(collected, TR10i(collected), TR10i(expression), key=sympy.count_ops)


def _check_size(wrenches: list[list[Poly]]) -> None:
    longest = max((len(c.terms()) for wrench in wrenches for c in wrench if c), default=0)
    if longest > LARGEST_SHOWN:
        raise FormulaTooLargeError(f"a component has {longest} terms")


def _displaced_screws(work: SymbolicScrews, chain: list[_Freedom], symbols: list[sympy.Symbol]) -> list[list[Poly]]:
    """Polynomial screws of the chain with the inner freedoms displaced."""
    scalars = work.scalars()
    rotation: Matrix = IDENTITY
    translation: Any = (0, 0, 0)
    result: list[list[Poly]] = []
    amounts = [None, *symbols, *[None] * (len(chain) - 1 - len(symbols))]
    for freedom, amount in zip(chain, amounts, strict=True):
        start = freedom.joint.kind.starts[freedom.index]
        own = work.unit_screws(freedom.joint)[start : start + freedom.motion.freedom]
        for screw in own:
            angular = transform(rotation, screw[:3])
            linear = add(transform(rotation, screw[3:]), cross(translation, angular))
            result.append(scalars.cleared([*angular, *linear])[0])
        if amount is None:
            continue
        signed = scalars.read(freedom.sense * amount)
        if freedom.motion.prismatic:
            step, moved = IDENTITY, tuple(signed * c for c in own[0][3:])
        else:
            sine = scalars.read(freedom.sense * sympy.sin(amount))
            versine = 1 - scalars.read(sympy.cos(amount))
            step = _rotation(own[0][:3], sine, versine)
            point = tuple(scalars.read(c) for c in freedom.joint.point)
            turned = transform(step, point)
            moved = tuple(a - b for a, b in zip(point, turned, strict=True))
        translation = add(translation, transform(rotation, moved))
        rotation = matrix_product(rotation, step)
    return result


def _rotation(axis: Any, sine: Any, versine: Any) -> Matrix:
    x, y, z = axis
    hat = ((0, -1 * z, y), (z, 0, -1 * x), (-1 * y, x, 0))
    square = matrix_product(hat, hat)
    rows = [tuple((1 if i == j else 0) + sine * hat[i][j] + versine * square[i][j] for j in range(3)) for i in range(3)]
    return (rows[0], rows[1], rows[2])
