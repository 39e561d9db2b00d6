"""States at which functions are compared: along the source paper's motion, or about the reference configuration."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.functions import TWIST_LABELS
from symscrew.model import Model
from symscrew.reference import BodyState
from symscrew.runtime import load
from symscrew.scene import Scene
from symscrew.studies.demo import SECTION_5
from symscrew.studies.platform_motion import integrate, moving_bodies

Array = np.ndarray
INSTANTS = 201  # states of the paper's motion of 10 s that are studied, every 0.05 s
MOTION_STEPS = 2000  # of the integration that they are taken from, which is projected on the closure afterwards
REACH = 0.15  # of random configurations: rad, or of the characteristic length


@dataclass(frozen=True)
class States:
    """Consistent states (n, nq), (n, nv), (n, nv), and where they come from."""

    q: Array
    v: Array
    a: Array
    text: str
    t: Array | None = None

    def known(self) -> dict[str, Array]:
        """By the names of ports."""
        return {"q": self.q, "v": self.v, "a": self.a}


class _Evaluated:
    """The functions of a model on NumPy with the call of compiled ones."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.functions = model.programs

    def __getattr__(self, name: str) -> Callable[..., Array]:
        program = self.model.programs[name]

        def call(*arguments: Array) -> Array:
            results, status = self.model(name, *arguments)
            if np.any(np.asarray(status) > 0):
                raise DescriptionError(f"{self.model.name}.{name}: a state of the study cannot be evaluated")
            shape = program.outputs[0].shape
            value = results[0]
            if len(shape) < 2:
                return value
            return np.moveaxis(value.reshape(*value.shape[:-1], *reversed(shape)), -1, -2)

        return call


def follows_the_paper(model: Model) -> bool:
    """Whether the platform's omega_x and omega_y determine the motion, as in section 5 of the source paper."""
    if model.mechanism.platform is None or "null_space" not in model.programs or model.system.parameters:
        return False
    basis = _Evaluated(model).null_space(model.system.reference)
    if basis.shape[-1] != 2:
        return False
    rows = [TWIST_LABELS.index(c) for c in SECTION_5.motion.components]
    select = _Evaluated(model).platform_jacobian(model.system.reference)[rows] @ basis
    return bool(np.linalg.cond(select) < 1e3)


def paper_states(model: Model, count: int = INSTANTS) -> States:
    """`count` states of the motion of section 5 (10 s), from the reference configuration, integrated and closed."""
    needed = ("null_space", "platform_jacobian", "assemble", "closure", "acceleration", "body_twist_rates")
    some = {name: model.programs[name] for name in needed if name in model.programs}
    functions = load(replace(model, programs=some, test_inputs={n: model.test_inputs[n] for n in some}))
    steps = -(-MOTION_STEPS // (count - 1)) * (count - 1)
    time = np.linspace(0.0, SECTION_5.duration, steps + 1)
    found = integrate(model, functions, SECTION_5.motion, time)
    every = steps // (count - 1)
    text = f"{count} instants of the motion of section 5 of the source paper, 10 s"
    return States(found.q[::every], found.v[::every], found.a[::every], text, time[::every])


def random_states(model: Model, count: int, seed: int = 11) -> States:
    """Random consistent states about the reference configuration; rates and accelerations of order one."""
    random, system, made = np.random.default_rng(seed), model.system, _Evaluated(model)
    units = system.scales
    step = REACH * random.uniform(-1, 1, (count, len(units))) * units
    q = system.advance(np.repeat(system.reference[None], count, 0), step)
    extra = [np.repeat(system.parameter_values[None], count, 0)] if system.parameters else []
    free = model.programs.get("null_space")
    if "assemble" in model.programs and free is not None:
        labels = [c.label for c in system.tree.q]
        chosen = [labels.index(label) for label in model.programs["assemble"].inputs[0].labels]
        guess = np.repeat(system.reference[None], count, 0)
        (q,), status = model("assemble", q[:, chosen], guess, *extra)
        q = q[np.asarray(status) == 0]
        if len(q) < 2:
            raise DescriptionError(f"{model.name}: no random configuration near the reference closes the loops")
        extra = [e[: len(q)] for e in extra]
        size = free.outputs[0].shape[1]
        v = made.velocity(q, *extra, random.uniform(-1, 1, (len(q), size))) if not extra else _ordered(
            model, "velocity", {"q": q, "y_dot": random.uniform(-1, 1, (len(q), size)), "p": extra[0]})  # fmt: skip
        known = {"q": q, "v": v, "y_ddot": random.uniform(-1, 1, (len(q), size)), **({"p": extra[0]} if extra else {})}
        a = _ordered(model, "acceleration", known)
    else:
        v, a = (random.uniform(-1, 1, (count, len(units))) * units for _ in range(2))
    return States(q, v, a, f"{len(q)} random states about the reference configuration")


def _ordered(model: Model, name: str, known: Mapping[str, Array]) -> Array:
    (value, *_), status = model(name, *[known[p.name] for p in model.programs[name].inputs])
    if np.any(np.asarray(status) > 0):
        raise DescriptionError(f"{model.name}.{name}: a random state cannot be evaluated")
    return value


class Subject:
    """What the studies are about: a model, in a scene where there is one; its states are made once."""

    def __init__(self, model: Model, scene: Scene | None = None) -> None:
        self.model, self.scene = model, scene

    @cached_property
    def states(self) -> States:
        """Along the source paper's motion where the mechanism follows it, else random ones."""
        return paper_states(self.model) if follows_the_paper(self.model) else random_states(self.model, INSTANTS)


def inputs_of(model: Model, function: str, states: States) -> list[Array]:
    """Arrays (n, size) for every input of a function; those that are not of the state repeat the test inputs."""
    n, known = len(states.q), states.known()
    if model.system.parameters:
        known["p"] = np.repeat(model.system.parameter_values[None], n, 0)
    arrays = []
    for port, test in zip(model.programs[function].inputs, model.test_inputs[function], strict=True):
        arrays.append(known[port.name] if port.name in known else np.resize(test, (n, test.shape[1])))
    return arrays


def body_states_of(model: Model, states: States) -> dict[str, BodyState]:
    """States of all moving bodies, as method B takes them."""
    made, motion = _Evaluated(model), states
    poses = made.body_poses(motion.q)
    twists, rates = made.body_twists(motion.q, motion.v), made.body_twist_rates(motion.q, motion.v, motion.a)
    return {
        name: BodyState(
            poses[:, :9, k].reshape(-1, 3, 3).transpose(0, 2, 1), poses[:, 9:, k], twists[:, :, k], rates[:, :, k]
        )
        for k, name in enumerate(moving_bodies(model))
    }
