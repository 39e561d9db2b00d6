"""How limbs share a load, and what redundant limbs change in the drives (section 5.2 of the source paper)."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from symscrew.description import Mechanism
from symscrew.effects import ExternalWrench, Gravity
from symscrew.errors import DescriptionError
from symscrew.functions import NO_DRIVE
from symscrew.model import Model, derive
from symscrew.studies.accuracy.states import States, follows_the_paper, paper_states
from symscrew.studies.demo import SECTION_5

Array = np.ndarray
Table = tuple[Sequence[str], Sequence[Sequence[str]]]


def without_limbs(mechanism: Mechanism, removed: Sequence[str]) -> Mechanism:
    """The mechanism without some limbs: their joints and the bodies that only they hold."""
    joints = {j for name in removed for j in mechanism.limbs[name].joints}
    kept = {name: joint for name, joint in mechanism.joints.items() if name not in joints}
    held = {mechanism.ground} | {body for joint in kept.values() for body in (joint.parent, joint.child)}
    return replace(
        mechanism,
        name=f"{mechanism.name}_without_{'_'.join(removed)}",
        joints=kept,
        bodies={name: body for name, body in mechanism.bodies.items() if name in held},
        points={name: point for name, point in mechanism.points.items() if point.body in held},
        limbs={name: limb for name, limb in mechanism.limbs.items() if name not in removed},
    )


def loaded(mechanism: Mechanism) -> Model:
    """The model under gravity and the load of section 5.2 as an input."""
    return derive(mechanism, (Gravity(), ExternalWrench(SECTION_5.loaded_point)))


def evaluated(model: Model, name: str, states: States, load: Array) -> list[Array]:
    """Outputs of a dynamic function at states under a load."""
    known = states.known()
    given = [
        known[p.name] if p.name in known else np.repeat(load[None], len(states.q), 0)
        for p in model.programs[name].inputs
    ]
    results, status = model(name, *given)
    if np.any(np.asarray(status) > 0):
        raise ArithmeticError(f"singular: the drives do not determine the motion (status {int(np.max(status))})")
    return list(results)


def sharing(model: Model, states: States) -> Table:
    """What each limb carries of the load: vertical force and moment about x at O, means over the motion.

    Differences of reactions with and without the load, so neither weight nor inertia.
    """
    load = np.array(SECTION_5.load)
    mechanism, n = model.mechanism, len(states.q)
    names = [port.name for port in model.programs["joint_reactions"].outputs]
    index = names.index("reactions")
    found = [evaluated(model, "joint_reactions", states, part)[index] for part in (load, 0 * load)]
    change = (found[0] - found[1]).reshape(n, -1, 6)
    joints = list(mechanism.joints)
    rows, totals = [], np.zeros((n, 6))
    point = list(mechanism.points).index(SECTION_5.loaded_point)
    places = model("forward_kinematics", states.q)[0][0].reshape(n, -1, 3)[:, point]
    wrench = np.concatenate([np.repeat(load[None, :3], n, 0), load[3:] + np.cross(places, load[:3])], axis=1)
    for name, limb in mechanism.limbs.items():
        last = mechanism.joints[limb.joints[-1]]
        sign = 1.0 if last.child == mechanism.platform else -1.0
        carried = -sign * change[:, joints.index(last.name)]
        totals += carried
        largest = np.linalg.norm(carried[:, :3], axis=1).max()
        rows.append([name, *_means(carried, wrench), f"{largest:.4g}"])
    rows.append(["sum", *_means(totals, wrench), ""])
    header = ["limb", "vertical force [N]", "share", "moment about x at O [N m]", "share", "largest force [N]"]
    return header, rows


def _means(carried: Array, wrench: Array) -> list[str]:
    result = []
    for k in (2, 3):
        mean, whole = carried[:, k].mean(), wrench[:, k].mean()
        result += [f"{mean:.4g}", f"{100 * mean / whole:.1f} %"]
    return result


def redundancy(model: Model, states: States) -> Table:
    """Peak drives of the whole mechanism, and of those without two of the limbs that do not constrain it."""
    load = np.array(SECTION_5.load)
    mechanism = model.mechanism
    rows = [_peaks("all limbs", model, states, load)]
    spare = [
        name for name, limb in mechanism.limbs.items()
        if "".join(mechanism.joints[j].type for j in limb.joints) in ("UPS", "SPU")
    ]  # fmt: skip
    for removed in itertools.combinations(spare, 2):
        kept = [name for name in spare if name not in removed]
        text = f"only {', '.join(kept)} of the UPS limbs"
        try:
            other = loaded(without_limbs(mechanism, removed))
            if not follows_the_paper(other):
                raise ArithmeticError("does not move as the source paper's")
            if any(NO_DRIVE in note for note in other.programs["inverse_dynamics"].notes):
                raise ArithmeticError(f"singular: freedoms {NO_DRIVE}")
            rows.append(_peaks(text, other, paper_states(other), load))
        except (ArithmeticError, DescriptionError, np.linalg.LinAlgError) as error:
            rows.append([text, "-", "failed", "failed", str(error)[:90]])
    return ["mechanism", "drives", "peak drive, unloaded [N]", "peak drive, loaded [N]", "remark"], rows


def _peaks(text: str, model: Model, states: States, load: Array) -> list[str]:
    peaks = [np.abs(evaluated(model, "inverse_dynamics", states, part)[0]) for part in (0 * load, load)]
    where = int(peaks[1].max(axis=0).argmax())
    label = model.programs["inverse_dynamics"].outputs[0].labels[where]
    return [text, str(peaks[0].shape[1]), *(f"{p.max():.5g}" for p in peaks), f"the largest in {label}"]
