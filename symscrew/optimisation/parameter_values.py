"""The mechanism of a problem, with its values of parameters looked at: those that are given, and the ends of a design.

problem --parameters that are chosen or given become inputs--> Mechanism --numbers put in--> an error, or nothing

A model is derived for the values of its description. Where a problem's make the mechanism of another size it is derived
for them: what lengths are divided by, and what pivots are held against, are those of the values it was derived for.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from symscrew.description import Mechanism, characteristic_length, check_values_of, exact, followed
from symscrew.effects import Acting
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.optimisation.problem import TrajectoryProblem

SIZES = 4.0  # times larger or smaller from where on it is derived anew, as a run of a scene is


def described(problem: TrajectoryProblem) -> Mechanism:
    """The problem's mechanism with the parameters that it chooses or gives as inputs.

    Raises:
        DescriptionError: there is no such parameter, or a body cannot have the inertia that values give it.
    """
    mechanism = problem.mechanism
    chosen = {*problem.design, *problem.parameters}
    for name in chosen:
        if name not in mechanism.parameters:
            raise DescriptionError(f"design: no parameter {name!r}; {did_you_mean(name, mechanism.parameters)}")
    parameters = {n: replace(p, run_time=p.run_time or n in chosen) for n, p in mechanism.parameters.items()}
    made = replace(mechanism, parameters=parameters)
    check_parameters(problem, made)
    return _at(made, problem.parameters) if _another_size(problem, made) else made


def check_parameters(problem: TrajectoryProblem, mechanism: Mechanism) -> None:
    """Refuse values, and ends of ranges of a design, at which a body has an inertia that is none.

    `mechanism`: the problem's with these parameters as inputs.
    """
    check_values_of(_at(mechanism, problem.parameters))
    for name, ends in problem.design.items():
        for end in filter(math.isfinite, ends):
            try:
                check_values_of(_at(mechanism, {**problem.parameters, name: end}))
            except DescriptionError as error:
                raise DescriptionError(f"design.{name}: the range reaches {end:g}: {error}") from error


def check_effects(problem: TrajectoryProblem, mechanism: Mechanism, acting: Acting) -> None:
    """Refuse values that an effect has no use for."""
    if problem.parameters:
        acting.check_values(mechanism.values({name: exact(value) for name, value in problem.parameters.items()}))


def _at(mechanism: Mechanism, values: Mapping[str, float]) -> Mechanism:
    given = {name: exact(float(value)) for name, value in values.items()}
    return replace(mechanism, parameters=followed(mechanism.parameters, given))


def _another_size(problem: TrajectoryProblem, mechanism: Mechanism) -> bool:
    if not problem.parameters:
        return False
    try:
        small, large = sorted(characteristic_length(m) for m in (mechanism, _at(mechanism, problem.parameters)))
    except TypeError:  # a place that is no real number: the guess says so
        return False
    return small > 0.0 and large / small > SIZES
