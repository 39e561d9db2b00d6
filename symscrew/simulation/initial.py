"""Where a run begins: the scene's coordinates and rates put in, everything else assembled.

reference configuration --strides to the given coordinates, Newton's method--> q;    J v = 0, given rates --> v

A start is a generator that asks for what it needs of the mechanism at some state (`At`, `Bias`, `Moved`) and goes on
with the answer: many starts ask side by side and are answered at once, in the same numbers as one. Beside a singular
configuration what follows from the given values is found with 60 digits (`fine_start`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from symscrew import assembly
from symscrew.effects import Acting
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.kinematics import System, full_name, nearest_names, typable_names
from symscrew.mobility import inverse_kinematics
from symscrew.model import Model
from symscrew.scene import Scene, parameter_values
from symscrew.simulation.asked_closure import Asking, At, Bias, Closure, Moved, Question
from symscrew.simulation.fine_start import BEFORE, LOST, FineStart, leading, left_free, nearly_free
from symscrew.simulation.named_rates import rate_rows
from symscrew.simulation.run_time_values import check_frames, check_values, values_in
from symscrew.simulation.start_branch import leaves_every_branch

# Intermediate targets on the way from the reference configuration; more where fewer fail. Long strides may lead to
# another assembly branch, which nothing here would notice: hence eight also where Newton's method would manage one.
STRIDES = (8, 32, 128)
CLOSED = 1e-13  # opening of the loops, and miss of given values, at which Newton's steps end: what rounding leaves
# Where steps no longer move anything the state is taken if the loops are closed to STALLED and the given values are
# met to FOLLOWED (without units): given values that the loops contradict miss by more, and are refused.
STALLED, FOLLOWED = 1e-12, 1e-10
MOST_STEPS, LARGEST_STEP = 40, 0.5  # of Newton's method; larger steps [1, rad] are shortened, so that they do not jump
# Parts of the largest singular value below which rates are left alone: in singular configurations the closure does not
# determine them. Newton's method steps over such places; rates at the start are to keep more of what was given.
STEP_RANK, RATE_RANK = 1e-10, LOST
ALONG = 1e-4  # farthest that a way's continuation may be from what Newton's method found: a root of `STALLED`, and more
STILL = 1e-9  # of a motion without units: a coordinate that moves by less is at a dead point; rounding leaves 1e-15
SMALLEST = 1e-12  # of a row of given rates: a coordinate that nothing moves stays a row of zeros, and contradicts

State = tuple[np.ndarray, np.ndarray]


def initial_state(scene: Scene, model: Model, parameters: np.ndarray) -> State:
    """Configuration (nq,) [rad, m] and rates (nv,) [rad/s, m/s] that close all loops and have the scene's values.

    `parameters`: values of the run-time parameters (np,).

    Raises:
        DescriptionError: an unknown label, loops that cannot be closed with these values, rates that contradict
            each other.
    """
    (found,) = initial_states_together(model, [(scene, parameters)])
    if isinstance(found, DescriptionError):
        raise found
    return found


def initial_states_together(model: Model, of: Sequence[tuple[Scene, np.ndarray]]) -> list[State | DescriptionError]:
    """`initial_state` of every scene with its parameters; where there is none, the error that says why."""
    closure = Closure(model)
    asking = {k: _begun(scene, model, closure, parameters) for k, (scene, parameters) in enumerate(of)}
    found: list[State | DescriptionError] = [DescriptionError("")] * len(of)
    answers: dict[int, Any] = dict.fromkeys(asking)
    while asking:
        questions: dict[int, Question] = {}
        for k, work in list(asking.items()):
            try:
                questions[k] = work.send(answers[k])
            except StopIteration as end:
                found[k] = end.value
                del asking[k]
            except DescriptionError as error:
                found[k] = error
                del asking[k]
        answers = dict(closure.answers(questions, [parameters for _, parameters in of]))
    return found


def _begun(scene: Scene, model: Model, closure: Closure, parameters: np.ndarray) -> Asking[State]:
    system = model.system
    reference = system.reference
    if len(parameters):
        reference = system.reference_at(parameters)
        check_frames(model, parameters, *(yield At(reference)))
    known = {c.label: k for k, c in enumerate(system.tree.q)}
    hold = scene.initial.hold
    in_mode, others = scene.initial.mode, any(label not in known for label in scene.initial.coordinates)
    if in_mode or (hold is None and others):
        _told_apart(scene, model)
        placed = _in_mode(scene, model) if in_mode else _by_names(scene, model)
        opened, jacobian = yield At(placed)
        residual, _ = closure.of_coordinates(opened, jacobian)
        if np.abs(residual).max(initial=0.0) > FOLLOWED:  # what effects constrain, the mechanism alone does not know
            raise DescriptionError(
                f"initial.coordinates: {_shown(scene.initial.coordinates)}: there the wheels of 'ideal_rolling' are "
                f"{np.abs(residual).max():.3g} off their ground (lengths divided by {system.length:g} m); expected a "
                "pose where they touch, or coordinates of the tree, the others of which are found"
            )
        placed, jacobian, fine = yield from _as_it_is(closure, placed, jacobian, parameters)
        return placed, (yield from _rates(closure, placed, jacobian, scene, fine=fine))
    target = _unit_quaternions(system, dict(_labelled(scene.initial.coordinates, known, "initial.coordinates")))
    q = None
    if hold is None:
        for strides in STRIDES:
            q = yield from _followed(reference, closure, target, strides)
            if q is not None:
                break
        else:
            q = yield from _of_more(reference, closure, target)
            if q is not None:
                q, jacobian, fine = yield from _as_it_is(closure, q, (yield At(q))[1], parameters)
                return q, (yield from _rates(closure, q, jacobian, scene, fine=fine))
    else:
        q = yield from _nearest(reference, closure, target, [k for label, k in known.items() if label in hold])
    if q is None:
        opened = np.array(reference)
        opened[list(target)] = list(target.values())
        residual, _ = yield At(opened)
        gap = np.abs(residual).max(initial=0.0)
        cure = "check the values, or give only independent coordinates: the others are assembled"
        _, jacobian = yield At(reference)
        if hold is None and (dead := _at_dead_points(closure, jacobian, target)):
            cure = f"no motion from there changes {', '.join(dead)} at first, a dead point: give others, and it follows"
        raise DescriptionError(
            "initial.coordinates: the loops of "
            f"{model.name} cannot be closed with {_shown(scene.initial.coordinates)}: they stay open by {gap:.3g} "
            f"(lengths divided by {system.length:g} m) with the others as in the reference; {cure}"
        )
    fine = None
    _, jacobian = yield At(q)
    free = nearly_free(_rows(closure, jacobian, target))
    if hold is None and len(free):
        fine = FineStart(system, parameters, closure.rows, closure.units)
        step = fine.step(q, (yield from _continued(reference, closure, target, q)))
        q = yield Moved(q, free.T @ (free @ step) * closure.units)
        q = fine.coordinates(q, target, closure.of_places)
        _, jacobian = yield At(q)
    return q, (yield from _rates(closure, q, jacobian, scene, fine=fine))


def _rows(closure: Closure, jacobian: np.ndarray, given: Iterable[int]) -> np.ndarray:
    """Rows of given coordinates and of the loops' closure, without units."""
    plain = dict(closure.system.tree.plain)
    return np.concatenate([np.eye(len(closure.units))[[plain[k] for k in given if k in plain]], jacobian])


def _at_dead_points(closure: Closure, jacobian: np.ndarray, target: Mapping[int, float]) -> list[str]:
    """Labels of coordinates that are to be elsewhere, and that no motion from the reference changes at first.

    None where the others that are given leave no motion: these contradict them.
    """
    system, free = closure.system, left_free(jacobian)
    at = {k: column for k, column in system.tree.plain if k in target and target[k] != system.reference[k]}
    dead = [k for k, column in at.items() if np.abs(free[:, column]).max(initial=0.0) < STILL]
    others = [k for k in target if k not in dead]
    return [system.tree.q[k].label for k in dead if len(left_free(_rows(closure, jacobian, others)))]


def _told_apart(scene: Scene, model: Model) -> None:
    """Refuse coordinates with the name of a parameter, where what places the mechanism takes both by name."""
    both = [label for label in scene.initial.coordinates if label in model.mechanism.parameters]
    if both:
        raise DescriptionError(
            f"initial.coordinates: {both[0]} is a parameter of {model.name}, too; expected names that only one of them "
            "has, where coordinates of bodies or of cut joints are given, or a mode: rename the joint or the parameter"
        )


def _in_mode(scene: Scene, model: Model) -> np.ndarray:
    """The configuration of the named assembly mode, where the given coordinates have their values."""
    given = {**scene.parameters, **scene.initial.coordinates}
    return assembly.configuration_in_mode(model.system, scene.initial.mode, given, "initial.mode")


def _by_names(scene: Scene, model: Model) -> np.ndarray:
    """The configuration where coordinates that are not all of the tree have their values: passive joints, poses."""
    mechanism, values = model.mechanism, scene.initial.coordinates
    known = [*(c.label for c in model.system.tree.q), *typable_names(mechanism)]
    for label in values:
        if full_name(mechanism, label) not in known:
            raise DescriptionError(f"initial.coordinates: there is no {label!r}; {nearest_names(label, known)}")
    found = inverse_kinematics(mechanism, {**scene.parameters, **values})
    if not found.ok:
        raise DescriptionError(f"initial.coordinates: {_shown(values)}: {found.text}")
    return found.q


def moves(scene: Scene, model: Model, q: np.ndarray, v: np.ndarray) -> tuple[str, ...]:
    """What `hold` let the start change: an event for each given value that is another now."""
    if scene.initial.hold is None:
        return ()
    tree, found = model.system.tree, []
    for what, given, coordinates, values in (
        ("", scene.initial.coordinates, tree.q, q),
        (" (rate)", scene.initial.rates, tree.v, v),
    ):
        at = {c.label: float(x) for c, x in zip(coordinates, values, strict=True)}
        found += [
            f"t = 0 s: {label}{what} put from {value:.12g} to {at[label]:.12g} to close the loops"
            for label, value in given.items()
            if abs(at[label] - value) > 1e-12 * max(1.0, abs(value))
        ]
    return tuple(found)


def initial_states(scene: Scene, model: Model, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Values of the states at the start (states,): those of the effects, then those of the controller.

    Raises:
        DescriptionError: the scene's run-time parameters are none that the mechanism or an effect can have.
    """
    system, acting = model.system, Acting(model.system, model.effects)
    check_values(scene, model, acting)
    states, numbers = acting.states, values_in(scene, model)
    effects = [state.starting(numbers) for state in states]
    carried = {k: state.carried for k, state in enumerate(states) if state.carried is not None}
    if carried:
        chosen = np.array([list(parameter_values(scene, model).values())], dtype=float)
        given = system.numeric(
            list(carried.values()), (system.inputs.q, q[None]), (system.inputs.v, v[None]), parameters=chosen
        )
        for k, value in zip(carried, given[0], strict=True):
            effects[k] += float(value)
    return np.array([*effects, *(value for _, value in scene.states.values())], dtype=float)


def _labelled(values: Mapping[str, float], known: Mapping[str, int], where: str) -> Iterator[tuple[int, float]]:
    for label, value in values.items():
        if label not in known:
            raise DescriptionError(f"{where}: there is no {label!r}; {did_you_mean(label, known)}")
        if not np.isfinite(value):
            raise DescriptionError(f"{where}: expected a finite number for {label}, got {value!r}")
        yield known[label], value


def _shown(values: Mapping[str, float]) -> str:
    return ", ".join(f"{k} = {v:.12g}" for k, v in values.items()) or "the reference configuration"


def _unit_quaternions(system: System, given: Mapping[int, float]) -> dict[int, float]:
    """The given coordinates with quaternions of unit length; all four entries of one are given, or none."""
    target = dict(given)
    for link in system.tree.links[1:]:
        if not link.motion.spherical:
            continue
        named = [k for k in range(link.q.start, link.q.stop) if k in target]
        if not named:
            continue
        values = np.array([target.get(k, 0.0) for k in range(link.q.start, link.q.stop)])
        label = link.joint
        if len(named) < 4:
            raise DescriptionError(f"initial.coordinates: the quaternion of {label} has four entries, got {len(named)}")
        if abs(np.linalg.norm(values) - 1) > 1e-6:
            raise DescriptionError(
                f"initial.coordinates: expected a unit quaternion of {label}, got one of length "
                f"{np.linalg.norm(values):g}"
            )
        target |= dict(zip(range(link.q.start, link.q.stop), values / np.linalg.norm(values), strict=True))
    return target


def _followed(
    reference: np.ndarray, closure: Closure, target: dict[int, float], strides: int
) -> Asking[np.ndarray | None]:
    """Newton's method from the reference to the target, in strides."""
    system = closure.system
    q = np.array(reference)
    start = {k: q[k] for k in target}
    strides = strides if any(abs(target[k] - start[k]) > 1e-14 for k in target) else 1
    for stride in range(1, strides + 1):
        part = stride / strides
        wanted = {k: start[k] + part * (target[k] - start[k]) for k in target}
        found = yield from _solved(system, closure, q, wanted)
        if found is None:
            return None
        q = found
    return q


def _of_more(reference: np.ndarray, closure: Closure, target: dict[int, float]) -> Asking[np.ndarray | None]:
    """From more values than there are freedoms, which fit together at their end only: some are followed, if not all
    are given, and the others are there."""
    system, columns = closure.system, dict(closure.system.tree.plain)
    q = np.array([target.get(k, place) for k, place in enumerate(reference)])
    if len(target) < len(q):
        _, jacobian = yield At(reference)
        some = leading(jacobian, [columns[k] for k in target if k in columns])
        if len(some) < len(left_free(jacobian)):
            return None
        followed = {k: value for k, value in target.items() if columns.get(k) in some}
        for strides in STRIDES:
            found = yield from _followed(reference, closure, followed, strides)
            if found is not None:
                break
        else:
            return None
        q = found
    return (yield from _solved(system, closure, q, target))


def _as_it_is(
    closure: Closure, q: np.ndarray, jacobian: np.ndarray, parameters: np.ndarray
) -> Asking[tuple[np.ndarray, np.ndarray, FineStart | None]]:
    """A configuration that is known to rounding, its rows, and, beside a singular one, its loops with 60 digits."""
    held = {k: float(q[k]) for k, column in closure.system.tree.plain if column in leading(jacobian)}
    if not len(nearly_free(_rows(closure, jacobian, held))):
        return q, jacobian, None
    fine = FineStart(closure.system, parameters, closure.rows, closure.units)
    q = fine.coordinates(q, held, closure.of_places)
    return q, (yield At(q))[1], fine


def _continued(
    reference: np.ndarray, closure: Closure, target: dict[int, float], found: np.ndarray
) -> Asking[np.ndarray]:
    """Where the way from the reference leads, by a polynomial through places before its end.

    Of two solutions that almost meet there it is near that of the same branch; `found` where it leads nowhere near.
    """
    total, q = np.zeros(len(found)), np.array(reference)
    for part, weight in reversed(BEFORE):
        wanted = {k: reference[k] + (1 - part) * (value - reference[k]) for k, value in target.items()}
        if part == BEFORE[-1][0]:
            for strides in STRIDES:
                before = yield from _followed(reference, closure, wanted, strides)
                if before is not None:
                    break
        else:
            before = yield from _solved(closure.system, closure, q, wanted)
        if before is None:
            return found
        q, total = before, total + weight * before
    return total if np.abs(total - found).max(initial=0.0) < ALONG else found


def _nearest(
    reference: np.ndarray, closure: Closure, given: dict[int, float], held: list[int]
) -> Asking[np.ndarray | None]:
    """By Newton's method from the given values, of which those at `held` are kept."""
    system = closure.system
    start = np.array(reference)
    plain = [k for k in given if system.tree.q[k].kind != "quaternion"]
    start[plain] = [given[k] for k in plain]
    start = _turned(system, start, given)
    kept = {k: value for k, value in given.items() if k in held}
    found = yield from _solved(system, closure, start, kept)
    if found is not None:
        sure = [k for k in kept if k in plain]
        found[sure] = [kept[k] for k in sure]  # to the last bit
    return found


def _solved(system: System, closure: Closure, q: np.ndarray, wanted: Mapping[int, float]) -> Asking[np.ndarray | None]:
    """Newton's method by least squares onto the closed loops with the wanted coordinates; None where it fails."""
    moved = _turned(system, q, wanted)
    plain = {k: value for k, value in wanted.items() if system.tree.q[k].kind != "quaternion"}
    column = dict(system.tree.plain)
    held = [k for in_q, in_v in system.tree.spheres if in_q in wanted for k in range(in_v, in_v + 3)]
    pick = np.zeros((len(plain) + len(held), len(closure.units)))
    for i, k in enumerate(plain):
        pick[i, column[k]] = 1.0
    for i, k in enumerate(held):
        pick[len(plain) + i, k] = 1.0
    for _ in range(MOST_STEPS):
        residual, jacobian = closure.of_coordinates(*(yield At(moved)))
        away = [(value - moved[k]) / closure.units[column[k]] for k, value in plain.items()] + [0.0] * len(held)
        right = np.concatenate([away, -residual])
        if np.abs(residual).max(initial=0) < CLOSED and np.abs(away).max(initial=0) < CLOSED:
            return moved
        step = np.linalg.lstsq(np.concatenate([pick, jacobian]), right, rcond=STEP_RANK)[0]
        size = np.abs(step).max(initial=0)
        if size < 1e-15:  # nothing moves any more
            good = np.abs(residual).max(initial=0) < STALLED and np.abs(away).max(initial=0) < FOLLOWED
            return moved if good else None
        step *= min(1.0, LARGEST_STEP / size) * closure.units
        moved = yield Moved(moved, step)
    return None


def _turned(system: System, q: np.ndarray, wanted: Mapping[int, float]) -> np.ndarray:
    """q with the wanted quaternions put in."""
    moved = np.array(q)
    for link in system.tree.links[1:]:
        if link.motion.spherical and link.q.start in wanted:
            value = np.array([wanted[k] for k in range(link.q.start, link.q.stop)])
            moved[link.q] = value / np.linalg.norm(value)
    return moved


def _rates(
    closure: Closure, q: np.ndarray, jacobian: np.ndarray, scene: Scene, *, fine: FineStart | None = None
) -> Asking[np.ndarray]:
    n, rates, hold = len(closure.units), scene.initial.rates, scene.initial.hold
    if not rates:
        return np.zeros(n)
    tree = {c.label: k for k, c in enumerate(closure.system.tree.v)}
    if hold is not None or all(label in tree for label in rates):
        given = dict(_labelled(rates, tree, "initial.rates"))
        scales = closure.units[list(given)]
        rows = np.eye(n)[list(given)]
    else:  # the size of a row is that of its coordinate: lengths by the mechanism's, angles as they are
        rows = rate_rows(closure.model, q, rates, scene.parameters) * closure.units
        scales = np.maximum(np.abs(rows).max(axis=1), SMALLEST)
        rows /= scales[:, None]
    values, start = np.array(list(rates.values())) / scales, np.zeros(n)
    kept = [k for k, label in enumerate(rates) if hold is None or label in hold]
    if hold is not None:
        start[list(given)] = values
    values = values[kept]
    matrix = np.concatenate([rows[kept], jacobian])
    right = np.concatenate([values, np.zeros(len(jacobian))])
    v = start + np.linalg.lstsq(matrix, right - matrix @ start, rcond=RATE_RANK)[0]
    v += np.linalg.lstsq(matrix, right - matrix @ v, rcond=RATE_RANK)[0]
    if fine is not None:
        v = fine.rates(rows[kept], values, v)
    if np.abs(matrix @ v - right).max(initial=0) > 1e-9 * max(1.0, np.abs(values).max(initial=0)):
        raise DescriptionError(
            f"initial.rates: the loops do not allow {_shown(scene.initial.rates)} in this configuration; check the "
            "values, or give only the rates of independent coordinates"
        )
    bias = (yield Bias(q, v * closure.units)) if len(jacobian) else None
    if bias is not None and leaves_every_branch(jacobian, bias, v):
        raise DescriptionError(
            f"initial.rates: the loops lose rank in this configuration, where branches of the motion meet, and "
            f"{_shown(scene.initial.rates)} with the smallest rates of all others belongs to none of them; give the "
            "rates of further joints, as they are on the branch that is meant"
        )
    return np.asarray(v * closure.units)
