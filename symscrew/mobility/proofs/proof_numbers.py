"""The mechanism of a proof file in exact numbers, and numbers of the package as numbers of the file.

    Mechanism --described--> generators, joints with points and axes (JSON), read again as the checker reads them
    numbers of an exact field <--> polynomials in the generators

Where the description has numbers in no field that decides zero, they stand in the file as any numbers of an interval
of 50 digits: then what needs no exact zero can still be proved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

import sympy

from symscrew.algebra import CONTEXT, high_precision
from symscrew.description import CoupledTerm, Joint
from symscrew.description import Mechanism as Described
from symscrew.mobility.joint_network import Network
from symscrew.mobility.proofs.proof_checker import BITS, ONE, Mechanism, Number, Numbers
from symscrew.mobility.symbols import (
    Exact,
    ExactSystem,
    Generator,
    NotDecidableError,
    coupled_lengths,
    exact_inverse,
    exact_system,
    generator_itself,
    terms_of,
)

COSINE, ROOT = Fraction(1, 10**54), Fraction(1, 10**80)
"""Half the interval around a cosine of 60 digits, and how far the ends of a root's lie outside of where it can be: the
signs of its polynomial there must be clear of the rounding of intervals with 96 digits."""
TYPED = Fraction(1, 10**50)
"""Half the interval, relative, of a number that no field decides."""


@dataclass(frozen=True)
class ProofNumbers:
    """The description for the file, how the checker reads it, and the exact field (None where there is none)."""

    values: dict[str, Any]
    read: Mechanism
    system: ExactSystem | None
    why: str

    def exact(self, number: Number) -> Exact:
        """A number of the file in the package's field."""
        assert self.system is not None
        generators = self.system.field.generators
        total: Exact = Fraction(0)
        for key, c in number.terms.items():
            term: Exact = c
            for generator, power in zip(generators, key, strict=True):
                for _ in range(power):
                    term = term * generator_itself(generator)
            total = total + term
        return total

    def json(self, number: Exact) -> Any:
        """A number of the field as one of the file."""
        assert self.system is not None
        return encoded(number, self.system.field.generators)

    def value(self, number: Number) -> float:
        """A number of the file as a double."""
        low, high = self.read.numbers.interval(number)
        return (low + high) / (2 << BITS)

    def precise(self, number: Number) -> Any:
        """A number of the file in 60 digits."""
        low, high = self.read.numbers.interval(number)
        return CONTEXT.ldexp(CONTEXT.mpf(low + high), -BITS - 1)


def encoded(number: Exact, generators: list[Generator]) -> Any:
    """ "p/q", or the terms of a polynomial in the generators."""
    if isinstance(number, (int, Fraction)):
        return str(Fraction(number))
    return [[str(c), *key] for key, c in terms_of(number, generators).items()]


def described(mechanism: Described, network: Network, body: str) -> ProofNumbers:
    """The mechanism in its reference configuration, with the body whose freedoms are asked for."""
    why, system = "", None
    try:
        system = exact_system(mechanism)
        coupled_lengths(mechanism, system)  # which may adjoin roots, and numbers are written in all of them
        for e in _coupling_numbers(mechanism):
            system.field.read(e)
        generators = _roots(system.field.generators)
        joints = [_exact_joint(mechanism, joint, system) for joint in mechanism.joints.values()]
        field = system.field
        couplings = _couplings(mechanism, lambda e: encoded(field.read(e), field.generators))
    except NotDecidableError as error:
        why, system = str(error), None
        about = _Intervals()
        written = [_typed_joint(mechanism, joint, network, about) for joint in mechanism.joints.values()]
        _couplings(mechanism, about.typed)  # which finds the generators, in all of which numbers are then written
        generators = about.generators
        joints = [about.completed(joint) for joint in written]
        couplings = _couplings(mechanism, lambda e: about.completed(about.typed(e)))
    values = {
        "name": mechanism.name,
        "ground": mechanism.ground,
        "body": body,
        "generators": generators,
        "joints": joints,
        "limbs": {name: list(limb.joints) for name, limb in mechanism.limbs.items()},
        "drives": [[joint.name, index] for joint in mechanism.joints.values() for index in joint.driven],
    }
    if couplings:
        values["couplings"] = couplings
    return ProofNumbers(values, Mechanism(values), system, why)


def _roots(generators: list[Generator]) -> list[dict[str, Any]]:
    """The generators' polynomials with an interval for each, at the ends of which the signs are shown to differ."""
    ends: list[tuple[Fraction, Fraction]] = []
    for k, generator in enumerate(generators):
        middle = _rational(generator.value)
        around = middle - COSINE, middle + COSINE
        if generator.degree == 2 and not generator.modulus[1]:  # the root of what the generators before leave between
            below = Numbers(_written(generators[:k], ends))
            low, high = below.interval(below.read(encoded(-generator.modulus[0], generators[:k])))
            around = Fraction(isqrt(low << BITS), ONE) - ROOT, Fraction(isqrt(high << BITS) + 1, ONE) + ROOT
        ends.append(around)
    return _written(generators, ends)


def _written(generators: list[Generator], ends: list[tuple[Fraction, Fraction]]) -> list[dict[str, Any]]:
    polynomials = [[encoded(c, generators) for c in g.modulus] for g in generators]
    return [
        {"polynomial": p, "between": [str(low), str(high)]} for p, (low, high) in zip(polynomials, ends, strict=True)
    ]


def _rational(number: Any) -> Fraction:
    sign, mantissa, exponent, _ = CONTEXT.mpf(number)._mpf_
    size = Fraction(int(mantissa) << exponent) if exponent >= 0 else Fraction(int(mantissa), 1 << -exponent)
    return -size if sign else size


def _motions(joint: Joint) -> Iterator[tuple[str, int]]:
    """(letter, first freedom) of each motion that moves."""
    for motion, start in zip(joint.kind.motions, joint.kind.starts, strict=True):
        if not motion.fixed:
            yield "S" if motion.spherical else "H" if motion.helical else "R" if motion.revolute else "P", start


def _exact_joint(mechanism: Described, joint: Joint, system: ExactSystem) -> dict[str, Any]:
    field, generators = system.field, system.field.generators
    turns = any(motion.turns for motion in joint.kind.motions)
    point = [field.read(mechanism.number(c)) for c in joint.point] if turns else [Fraction(0)] * 3
    motions: list[dict[str, Any]] = []
    lengths = coupled_lengths(mechanism, system)
    for kind, start in _motions(joint):
        screw = system.screws[joint.name][start]
        axis = screw[3:] if kind == "P" else screw[:3]
        if (joint.name, start) in lengths:  # coordinates that are coupled are counted along unit axes
            unit = exact_inverse(lengths[joint.name, start])
            axis = tuple(c * unit for c in axis)
        motion = {"kind": kind} if kind == "S" else {"kind": kind, "axis": [encoded(c, generators) for c in axis]}
        if kind == "H" and joint.pitch is not None:
            motion["pitch"] = encoded(field.read(mechanism.number(joint.pitch)), generators)
        motions.append(motion)
    return _joint(joint, [encoded(c, generators) for c in point], motions)


def _joint(joint: Joint, point: list[Any], motions: list[dict[str, Any]]) -> dict[str, Any]:
    return {"name": joint.name, "parent": joint.parent, "child": joint.child, "point": point, "motions": motions}


def _freedom(mechanism: Described, term: CoupledTerm) -> int:
    return mechanism.joints[term.joint].kind.starts[term.motion]


def _at(mechanism: Described, term: CoupledTerm) -> sympy.Expr:
    """Where the coordinate is; 0 for a ratio that does not change, since it is the same everywhere."""
    given = mechanism.joints[term.joint].reference
    placed = len(term.coefficients) > 1 and term.motion < len(given)
    return mechanism.number(given[term.motion]) if placed else sympy.S.Zero


def _coupling_numbers(mechanism: Described) -> Iterator[sympy.Expr]:
    for coupling in mechanism.couplings.values():
        for term in coupling.terms:
            yield _at(mechanism, term)
            yield from (mechanism.number(c) for c in term.coefficients)


def _couplings(mechanism: Described, number: Callable[[sympy.Expr], Any]) -> list[dict[str, Any]]:
    return [
        {
            "name": coupling.name,
            "terms": [
                {
                    "joint": term.joint,
                    "freedom": _freedom(mechanism, term),
                    "at": number(_at(mechanism, term)),
                    "coefficients": [number(mechanism.number(c)) for c in term.coefficients],
                }
                for term in coupling.terms
            ],
        }
        for coupling in mechanism.couplings.values()
    ]


class _Intervals:
    """Numbers that no field decides: each a generator of its own, known to 50 digits."""

    def __init__(self) -> None:
        self.generators: list[dict[str, Any]] = []
        self._places: dict[Any, int] = {}

    def number(self, key: Any, value: Any) -> Any:
        """A rational number as it is, another one as the place of its generator."""
        if isinstance(key, sympy.Basic) and key.is_Rational:
            return str(Fraction(int(key.p), int(key.q)))
        if key not in self._places:
            middle = _rational(value)
            width = TYPED * (1 + abs(middle))
            self._places[key] = len(self.generators)
            self.generators.append({"between": [str(middle - width), str(middle + width)]})
        return self._places[key]

    def typed(self, e: sympy.Expr) -> Any:
        """A number of the description."""
        return self.number(e, high_precision(e))

    def completed(self, values: Any) -> Any:
        """The same with places of generators written as numbers of the file."""
        if isinstance(values, int):
            return [["1", *(int(k == values) for k in range(len(self.generators)))]]
        if isinstance(values, Mapping):
            return {key: self.completed(value) for key, value in values.items()}
        return [self.completed(value) for value in values] if isinstance(values, list) else values


def _typed_joint(mechanism: Described, joint: Joint, network: Network, about: _Intervals) -> dict[str, Any]:
    """The joint with its numbers in 60 digits; axes have unit length, so that few of them are rational."""
    length, edge = network.length, network.edges[joint.name]
    numbers = [mechanism.number(c) for c in joint.point]
    point = [about.number(e, CONTEXT.mpf(edge.point[k] * length)) for k, e in enumerate(numbers)]
    motions: list[dict[str, Any]] = []
    for kind, start in _motions(joint):
        motion: dict[str, Any] = {"kind": kind}
        if kind != "S":
            screw = edge.screws[start]
            axis = screw[3:] if kind == "P" else screw[:3]
            whole = (sympy.Integer(int(c)) if c == int(c) else (joint.name, start, k) for k, c in enumerate(axis))
            motion["axis"] = [about.number(key, c) for key, c in zip(whole, axis, strict=True)]
        if kind == "H" and joint.pitch is not None:
            pitch = mechanism.number(joint.pitch)
            motion["pitch"] = about.number(pitch, CONTEXT.mpf(pitch.evalf(60)._mpf_))
        motions.append(motion)
    return _joint(joint, point, motions)
