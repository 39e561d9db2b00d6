"""All configurations with some of Study's parameters zero, exactly, where the whole does not decompose: translations.

    sampled modes --parameters that are zero on one--> equations and these --exact_parts--> components of that set
    a configuration on one --rank of all equations--> no component of more dimensions goes through it

What is zero is read off samples, but not believed: components with it are proved whatever suggested to look there.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.description import Mechanism
from symscrew.mobility.components.all_components import ON, on_part
from symscrew.mobility.components.allowed_time import AllowedTime
from symscrew.mobility.components.closure_parts import NotAlgebraicError
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.exact_parts import exact_parts
from symscrew.mobility.components.mode_sampling import SampledModes, freedoms_at
from symscrew.mobility.components.numerical_decomposition import pose_equations
from symscrew.mobility.components.polynomials import variable
from symscrew.mobility.components.real_configurations import real_configurations, variables_at
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import Network

ZERO = re.compile(r"^[xy][0-3]$")
"""A linear form that is one parameter, whose zero no unit of length changes."""


@dataclass(frozen=True)
class HeldPart:
    """A component of the configurations with such zeros; `on`: how many real ones that were found are on it.

    `whole`: whether at one of these the body has as many freedoms as it has dimensions, so that it is one of all.
    """

    part: Part
    on: int
    whole: bool


@dataclass(frozen=True)
class ZeroParameters:
    """The components of all configurations with these parameters zero; `reason`: why there are none, else empty."""

    zeros: tuple[str, ...]
    parts: tuple[HeldPart, ...]
    field: str
    variables: tuple[str, ...]
    settles: bool
    found: int
    reason: str


def with_zero_parameters(
    mechanism: Mechanism, network: Network, seen: SampledModes, seconds: float
) -> tuple[ZeroParameters, ...]:
    """For every set of parameters that are zero on a sampled mode, in so many seconds of the processor in all."""
    sets = dict.fromkeys(tuple(e for e in mode.equations if ZERO.match(e)) for mode in seen.modes)
    allowed = AllowedTime(seconds)
    found = [_with_zeros(mechanism, network, seen.body, zeros=zeros, seconds=allowed.left) for zeros in sets if zeros]
    return tuple(one for one in found if one is not None)


def _with_zeros(
    mechanism: Mechanism, network: Network, body: str, *, zeros: Sequence[str], seconds: float
) -> ZeroParameters | None:
    """None where the equations are not of the body's pose against the ground."""
    try:
        closure = pose_equations(mechanism, network)
    except NotAlgebraicError:
        return None
    if (closure.base, closure.body) != (network.ground, body):
        return None
    count, places = len(closure.variables), [closure.variables.index(name) for name in zeros]
    held = replace(closure, equations=(*closure.equations, *(variable(k, count) for k in places)))
    exact = exact_parts(held, seconds, local=True)
    settings = tuple(zeros), str(closure.field), closure.variables, closure.settles
    if not exact.complete or exact.reason:
        return ZeroParameters(settings[0], (), *settings[1:], 0, exact.reason)
    q, variety = real_configurations(network), ClosureVariety(network)
    values = variables_at(closure, network, q)
    if values is None:
        values = np.zeros((0, count))
    parts = []
    for part in exact.parts:
        on = np.flatnonzero(on_part(part, values, np.full(len(values), ON)))
        freedoms = [freedoms_at(network, variety, q[k], (closure.base, body)) for k in on]
        whole = any((f.freedoms if closure.settles else f.poses) == part.dimension for f in freedoms)
        parts.append(HeldPart(part, len(on), whole))
    return ZeroParameters(settings[0], tuple(parts), *settings[1:], len(values), "")
