"""Phases followed by forward simulation, one after the other, and links looked at in the tree's own coordinates.

At a link the rates behind are found again without the projected equations of motion: from the mass matrix M of the
spanning tree, all directions N that the loops leave free, and the rates of the hit freedoms,

    minimise  |v_behind - v_before|^2_M  over v_behind = N y_dot  with  rate_i behind = -e_i rate_i before,

which is Gauss's principle for impacts (of a mass that is caught: with the momentum of what moved before).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from symscrew.dynamics import mass_matrix
from symscrew.functions import function
from symscrew.optimisation.casadi_graph import numeric_function
from symscrew.optimisation.followed_motion import Stepper, settled
from symscrew.optimisation.joined_plan import JoinedPlan, Passed
from symscrew.optimisation.joined_problem import Link
from symscrew.optimisation.mesh_errors import MOST_GROWTH
from symscrew.optimisation.plan_verdict import NOT_REPLAYED, REPLAYED
from symscrew.optimisation.result import Trajectory
from symscrew.program import Port, lower

# Of rates behind a link found again [y_dot times the duration]: what constraints to 1e-8, scaled, leave of them.
AGREED = 1e-6


def passed(first: Trajectory, second: Trajectory, link: Link) -> Passed:
    """What a link does to the rates, against its own computation in the tree's coordinates."""
    end, start = first.sampled(np.ones(1)), second.sampled(np.zeros(1))
    q, before, behind = end.q[0], end.y_dot[0], start.y_dot[0]
    expected, lost = _behind(first, second, link, q=q, before=before)
    size = np.concatenate([(expected - behind) * second.duration, start.y[0] - end.y[0]])
    layout = first.model.equations.layout
    apart = np.abs(start.q[0] - q)[list(layout.z)]
    return Passed(before, behind, float(np.abs([*size, *apart]).max(initial=0.0)), lost)


def _behind(
    first: Trajectory, second: Trajectory, link: Link, *, q: np.ndarray, before: np.ndarray
) -> tuple[np.ndarray, float]:
    """y_dot behind a link, and the energy that it takes."""
    free = _directions(second, q)
    after_mass = free.T @ _mass(second, q) @ free
    before_mass = free.T @ _mass(first, q) @ free
    momentum = (before_mass if link.catches else after_mass) @ before
    hits = _hits(second, q, tuple(link.impact))
    wanted = -np.array(list(link.impact.values())) * (hits @ before)
    d, n = len(before), len(hits)
    system = np.block([[after_mass, hits.T], [hits, np.zeros((n, n))]])
    found = np.linalg.lstsq(system, np.concatenate([momentum, wanted]), rcond=None)[0][:d]
    energy = before @ (before_mass if link.catches else after_mass) @ before - found @ after_mass @ found
    return found, float(energy / 2)


def _mass(plan: Trajectory, q: np.ndarray) -> np.ndarray:
    """The tree's mass matrix with what effects add: (nv, nv)."""
    equations, system = plan.model.equations, plan.model.system
    rows = mass_matrix(system, equations.acting.added_inertia)
    n = len(rows)
    entries = [entry for row in rows for entry in row]
    inputs = [(Port("q", (len(q),), ("1",) * len(q), (), "q"), system.inputs.q)]
    outputs = [(Port("mass_matrix", (n * n,), ("1",) * (n * n), (), "mass matrix"), entries)]
    program = lower(function(system, "link_mass", "", inputs=inputs, outputs=outputs))
    return np.array(numeric_function(program)(*_given(plan, q))).reshape(n, n)


def _directions(plan: Trajectory, q: np.ndarray) -> np.ndarray:
    """Rates of the tree by y_dot: (nv, d)."""
    layout, d = plan.model.equations.layout, plan.model.d
    made = numeric_function(plan.model.equations.motion)
    y, z = np.repeat(q[None, list(layout.y)], d, 0), np.repeat(q[None, list(layout.z)], d, 0)
    return np.array(made(*plan.kinematics.columns(y, z, np.eye(d), np.zeros((d, d))))[0])


def _hits(plan: Trajectory, q: np.ndarray, labels: tuple[str, ...]) -> np.ndarray:
    """Rates of joints' freedoms by y_dot: (labels, d)."""
    if not labels:
        return np.zeros((0, plan.model.d))
    program = plan.model.equations.tree_function("joint_rates")
    made, known = numeric_function(program), plan.model.joint_labels
    rows = []
    for column in _directions(plan, q).T:
        given = {"q": q, "v": column, "p": plan.parameter_values}
        rows.append(np.array(made(*[given[port.name] for port in program.inputs])).ravel())
    every = np.array(rows).T
    own = plan.model.equations.labels
    return np.array([every[known.index(n)] if n in known else np.eye(plan.model.d)[own.index(n)] for n in labels])


def _given(plan: Trajectory, q: np.ndarray) -> list[np.ndarray]:
    return [q, plan.parameter_values] if len(plan.parameter_values) else [q]


def linked(plan: JoinedPlan) -> JoinedPlan:
    """The plan with its links looked at, and phases replayed one from the end of the other."""
    links: list[Passed | None] = []
    reasons: list[str] = []
    for k, link in enumerate(plan.problem.links):
        found = None if link is None else passed(plan.parts[k], plan.parts[k + 1], link)
        links.append(found)
        if found is not None and not found.off <= AGREED:
            reasons.append(
                f"phases {k + 1} and {k + 2} do not fit: the next one starts {found.off:.1e} off the balance of "
                "momentum between them"
            )
    if reasons:
        return replace(
            plan, ok=False, status=f"not confirmed: {reasons[0]}", reasons=tuple(reasons), links=tuple(links)
        )
    plan = replace(plan, links=tuple(links))
    accuracy = plan.parts[0].problem.accuracy
    if accuracy is None or None in plan.problem.links:
        return plan
    if not all(part.model.equations.accelerates for part in plan.parts):
        return replace(plan, notes=(*plan.notes, NOT_REPLAYED))
    error = _chain(plan)
    plan = replace(plan, end_error=error)
    growth = float(np.prod([max(1.0, part.errors.growth) for part in plan.parts]))
    allowed = REPLAYED * accuracy[0] * len(plan.parts) * min(growth, MOST_GROWTH)
    if error <= allowed or growth > MOST_GROWTH:  # then no motion repeats itself without feedback
        return plan
    text = f"replayed from phase to phase it ends {error:.1e} off the plan"
    return replace(plan, ok=False, status=f"not confirmed: {text}", reasons=(text,))


def _chain(plan: JoinedPlan) -> float:
    """How far the last phase ends off when every phase starts where the replay of the one before ended."""
    state, error = None, 0.0
    for k, part in enumerate(plan.parts):
        stepper = Stepper(part)
        states, change, _ = settled(stepper, state)
        end = states[-1]
        planned = part.blocks(np.ones(1))
        entries = [e.q for e in part.model.equations.loops.entries]
        off = np.abs(end[entries] - planned["y"][0]).max(initial=0.0)
        rates = stepper.rates(states[-1:])[0]
        error = max(float(off), float(np.abs(rates * part.duration - planned["y_1"][0]).max(initial=0.0))) + change
        if k < len(plan.problem.links):
            link, later = plan.problem.links[k], plan.parts[k + 1]
            assert link is not None
            state = _handed(part, later, link, (end, rates, stepper))
    return error


def _handed(
    first: Trajectory, second: Trajectory, link: Link, at: tuple[np.ndarray, np.ndarray, Stepper]
) -> np.ndarray:
    """The state (q, v, x) behind a link of a replay that ended at a state."""
    end, rates, stepper = at
    q, x = end[: stepper.nq], end[stepper.nq + stepper.nv :]
    moved = rates if link.is_smooth else _behind(first, second, link, q=q, before=rates)[0]
    v = _directions(second, q) @ moved
    start = second.arrays["x"][0]
    states = [x[first.model.states.index(n)] if n in first.model.states else start[j]
              for j, n in enumerate(second.model.states)]  # fmt: skip
    return np.concatenate([q, v, np.array(states)])
