"""Whether a scene's run-time parameters are such that the mechanism and its effects can have them.

scene's values --followed--> mechanism's numbers --inertias, what effects require--> an error that names the number

A model is derived, and looked at, for the values of its description; a run has others. Where they make the mechanism
of another size it is derived for them: what lengths are divided by, and what pivots of the closure are held against,
are those of the values that it was derived for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import sympy

from symscrew.description import Mechanism, characteristic_length, check_values_of, exact, followed
from symscrew.effects import Acting
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.scene import Scene

SIZES = 4.0
"""Times by which a mechanism is larger or smaller than its description from where on it is derived anew. Nearer, one
derivation and one library serve all values; at 10 times every step is taken with care, at 100 the closure has no pivot
left that counts, and at 1000 times its rounding is above what a run asks for. Single lengths may differ by any factor:
a crank of 1e-5 of the description's moves as that of its own description."""


def mechanism_at_size(scene: Scene) -> Mechanism:
    """The mechanism to derive for a run: the scene's, or with the run's values where they make it of another size."""
    if not scene.parameters:
        return scene.mechanism
    chosen = _with(scene.mechanism, scene)
    return chosen if _ratio(chosen, scene.mechanism) > SIZES else scene.mechanism


def far_in_size(scene: Scene, model: Model) -> str:
    """A sentence where the scene's values make the mechanism of another size than what the model was derived for."""
    chosen = mechanism_of(scene, model) if scene.parameters else model.mechanism
    if _ratio(chosen, model.mechanism) <= SIZES:
        return ""
    length, derived = characteristic_length(chosen), model.system.length
    return (
        f"the parameters make {model.name} {length / derived:.3g} times as large as what it was derived for "
        f"({length:.3g} m beside {derived:.3g} m); give the description, or the scene, values near these"
    )


def _ratio(one: Mechanism, other: Mechanism) -> float:
    """Times by which the larger one is larger, at least 1; 1 where one of them has no size."""
    try:
        with np.errstate(over="ignore"):
            small, large = sorted(characteristic_length(mechanism) for mechanism in (one, other))
    except TypeError:  # a place that is no real number, of which the run says that it has no accelerations
        return 1.0
    return large / small if small > 0.0 else 1.0


def values_in(scene: Scene, model: Model) -> dict[sympy.Symbol, sympy.Expr]:
    """Every parameter of the mechanism -> its value in the scene, for expressions of them."""
    return {model.mechanism.parameters[name].symbol: value for name, value in _by_name(scene, model).items()}


def check_values(scene: Scene, model: Model, acting: Acting) -> None:
    """Refuse run-time parameters that leave a body no possible inertia, or that an effect has no use for.

    Raises:
        DescriptionError: names the body or effect, what was expected, what came.
    """
    if not scene.parameters:  # those of the description were looked at when the model was derived
        return
    mechanism, chosen = model.mechanism, mechanism_of(scene, model)
    check_values_of(chosen)
    for effect in model.effects:
        chosen = effect.transform(chosen)
        for now, derived in zip(effect.rolled(chosen), effect.rolled(mechanism), strict=True):
            if now.inside != derived.inside:
                raise DescriptionError(
                    f"ideal rolling of {now.name}: circle: expected a radius of the sign that it has in the "
                    "description; a wheel rolls within a circle or on it by design"
                )
    acting.check_values(_by_name(scene, model))


def mechanism_of(scene: Scene, model: Model) -> Mechanism:
    """The mechanism of a run: that of the model, with the scene's values of its parameters."""
    return _with(model.mechanism, scene)


def _with(mechanism: Mechanism, scene: Scene) -> Mechanism:
    given = {name: exact(value) for name, value in scene.parameters.items()}
    return replace(mechanism, parameters=followed(mechanism.parameters, given))


def check_frames(model: Model, parameters: np.ndarray, *values: np.ndarray) -> None:
    """Refuse run-time parameters (np,) at which the closure in the reference configuration, `values`, is no number: its
    frames stand on a direction that vanishes there, which at the description's values it does not.

    Raises:
        DescriptionError: names the parameters.
    """
    if not all(np.isfinite(array).all() for array in values):
        names = [p.name for p in model.mechanism.parameters.values() if p.run_time]
        shown = ", ".join(f"{name} = {value:.12g}" for name, value in zip(names, parameters, strict=True))
        raise DescriptionError(
            f"parameters: at {shown} a direction vanishes that the frames of {model.name} stand on at the "
            "description's values; give the description these values"
        )


def _by_name(scene: Scene, model: Model) -> Mapping[str, sympy.Expr]:
    return model.mechanism.values({name: exact(value) for name, value in scene.parameters.items()})
