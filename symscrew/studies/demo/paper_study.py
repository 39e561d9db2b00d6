"""The main job on the source paper's mechanism: mobility, motion, drives by two methods, reactions, statics.

    description --derive--> model --C compiler--> functions
    scene + functions --> motion --> drives A (momentum screws), reactions; drives B (Newton-Euler)

`study_paper` computes, `symscrew.studies.demo.paper_figures` shows.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew import catalogue
from symscrew.description import Mechanism
from symscrew.display import Progress
from symscrew.effects import ExternalWrench, Gravity
from symscrew.mobility import Mobility, analyse_mobility
from symscrew.model import Model, derive
from symscrew.reference import newton_euler
from symscrew.runtime import CompiledFunction, CompiledModel, load
from symscrew.studies.demo.paper_motion import SECTION_5, Scene
from symscrew.studies.platform_motion import Motion, body_states, integrate
from symscrew.studies.timing import nanoseconds_per_state

Array = np.ndarray

SEED = ("three_ups_upu_s", "three_ups_upu_s_physical")
LIMIT = 1e-9
"""Largest relative difference between both methods that the demo accepts; rounding leaves less, a term that one of them
lacks leaves more. Above it the command ends with exit code 1."""

TIMED = ("inverse_dynamics", "joint_reactions", "velocity", "mass_matrix")
USED = (
    *("acceleration", "assemble", "body_poses", "body_twist_rates", "body_twists", "closure", "joint_displacements"),
    *("joint_rates", "joint_screws", "null_space", "platform_jacobian", *TIMED),
)
"""The functions that the demo and its figures call: only these are compiled."""
TIMED_STATES = 4000  # per call, of the motion's 10 001: Python's share of a call is a few ns per state
REPEATS, LEAST_REPEATS = 51, 3  # of a call; fewer where one takes long, but as many as make a median
TIMING_BUDGET = 0.4e9  # ns per function: the demo is to end in a few seconds


@dataclass(frozen=True)
class Timing:
    """A function of the model: operations, and nanoseconds per state in a batch (median)."""

    operations: int
    nanoseconds: float


@dataclass(frozen=True)
class Case:
    """What was computed for one mechanism.

    `drives` (n, drives) are those of method A, `drives_b` of method B; `reactions` (n, 6, joints) are wrenches
    (f ; m_O) from parent on child; the differences are relative to the largest value of each drive, and to the
    largest force or moment of all reactions. Times in seconds.
    """

    mechanism: Mechanism
    model: Model
    functions: CompiledModel
    motion: Motion
    drives: Array
    drives_b: Array
    reactions: Array
    drive_difference: float
    reaction_difference: float
    timings: dict[str, Timing]
    derive_time: float
    compile_time: float

    def __repr__(self) -> str:
        methods = f"methods differ by {max(self.drive_difference, self.reaction_difference):.1e}"
        return f"Case({self.mechanism.name}: {len(self.motion.t)} states, {methods})"

    @property
    def agrees(self) -> bool:
        """Whether both methods agree."""
        return max(self.drive_difference, self.reaction_difference) <= LIMIT


@dataclass(frozen=True)
class Assumption:
    """What assuming omega_z = 0 hides: residual (m,) of eq. (27) at instants t (m,), and with the true one."""

    t: Array
    residual: Array
    exact_residual: float
    shape: tuple[int, int]


@dataclass(frozen=True)
class Statics:
    """Drives [N or N m] at rest in the reference configuration under gravity and the scene's load."""

    labels: tuple[str, ...]
    drives: Array


@dataclass(frozen=True)
class Demo:
    """All results of the demo."""

    scene: Scene
    mobility: Mobility
    cases: tuple[Case, ...]
    assumption: Assumption
    statics: Statics

    def __repr__(self) -> str:
        return f"Demo({', '.join(map(repr, self.cases))})"

    @property
    def agrees(self) -> bool:
        """Whether the methods agree in all cases."""
        return all(case.agrees for case in self.cases)


def study_paper(
    names: Sequence[str] = SEED,
    scene: Scene = SECTION_5,
    *,
    progress: Progress | None = None,
    backend: str | None = None,
) -> Demo:
    """Compute the demo; `backend` as in `symscrew.runtime.compiled.load`.

    The motion depends on the geometry alone: it is integrated with the first mechanism and must close the
    loops of the others.
    """
    shown = progress or Progress(quiet=True)
    with shown.step("mobility by reciprocal screws"):
        mobility = analyse_mobility(catalogue.find(names[0]))
    cases: list[Case] = []
    for name in names:
        motion = cases[0].motion if cases else None
        cases.append(study(catalogue.find(name), scene, motion, progress=shown, backend=backend))
    with shown.step("residual of the assumption omega_z = 0"):
        assumption = assume_no_spin(cases[0])
    with shown.step("statics under the load of section 5.2"):
        statics = at_rest(cases[0].mechanism, scene)
    return Demo(scene, mobility, tuple(cases), assumption, statics)


def study(
    mechanism: Mechanism, scene: Scene, motion: Motion | None, *, progress: Progress, backend: str | None
) -> Case:
    """Motion, drives by both methods, reactions and times of one mechanism."""
    start = time.perf_counter()
    with progress.step(f"{mechanism.name}: derive the model"):
        model = derive(mechanism)
    derived = time.perf_counter()
    with progress.step(f"{mechanism.name}: print and compile its functions"):
        functions = load(model.only(USED), backend=backend)
    compiled = time.perf_counter()
    if motion is None:
        with progress.step(f"{mechanism.name}: {scene.steps} steps of the motion"):
            motion = integrate(model, functions, scene.motion, scene.time, steps=lambda s: progress.bar(s, "  motion"))
    check_closed(functions, motion)
    state = (motion.q, motion.v, motion.a)
    with progress.step(f"{mechanism.name}: drives and reactions by momentum screws (A)"):
        drives = np.asarray(functions.inverse_dynamics(*state))
        reactions = np.asarray(functions.joint_reactions(*state)[1])  # type: ignore[index]
    with progress.step(f"{mechanism.name}: drives and reactions by Newton-Euler (B)"):
        other = newton_euler(mechanism, body_states(model, functions, motion))
        expected = np.stack([other.reactions[name] for name in mechanism.joints], axis=-1)
    with progress.step(f"{mechanism.name}: time the functions"):
        timings = {name: timed(model, functions[name], state) for name in TIMED}
    return Case(
        mechanism, model, functions, motion, drives, other.drives, reactions,
        float((np.abs(drives - other.drives).max(axis=0) / np.abs(other.drives).max(axis=0)).max()),
        max(relative(reactions[:, half], expected[:, half]) for half in (slice(0, 3), slice(3, 6))),
        timings, derived - start, compiled - derived,
    )  # fmt: skip


def check_closed(functions: CompiledModel, motion: Motion) -> None:
    """Raise ValueError if the motion does not close the loops of these functions."""
    opening = float(np.abs(np.asarray(functions.closure(motion.q))).max())
    if not opening < LIMIT:
        raise ValueError(f"the motion must close the loops of {functions.name}: they are open by {opening:.2e}")


def relative(got: Array, expected: Array) -> float:
    """Largest difference relative to the largest expected magnitude."""
    return float(np.abs(got - expected).max() / np.abs(expected).max())


def timed(model: Model, function: CompiledFunction, state: tuple[Array, Array, Array]) -> Timing:
    """Median time per state of calls with many states at once, so that Python's share vanishes."""
    known = {name: array[:TIMED_STATES] for name, array in zip(("q", "v", "a"), state, strict=True)}
    known["y_dot"] = np.zeros((len(known["q"]), model.programs["null_space"].outputs[0].shape[1]))
    measure = nanoseconds_per_state(function, known)
    laps: list[float] = []
    while len(laps) < LEAST_REPEATS or (len(laps) < REPEATS and sum(laps) * len(known["q"]) < TIMING_BUDGET):
        laps.append(measure())
    return Timing(model.programs[function.name].operations["total"], statistics.median(laps))


def assume_no_spin(case: Case, every: int = 10) -> Assumption:
    """Least squares S w = V of eq. (27) with the platform's omega_z set to zero.

    S = blockdiag of the limbs' screw matrices; V stacks the platform's twist once per limb. The residual is
    the norm |S w - V| as the paper takes it, without units.
    """
    motion, limbs = case.motion, case.mechanism.limbs.values()
    screws = np.asarray(case.functions.joint_screws(motion.q[::every]))
    labels = [label.rsplit(".", 1)[0] for label in case.functions["joint_screws"].outputs[0].labels[::6]]
    columns = [[k for k, label in enumerate(labels) if label.split(".")[0] in limb.joints] for limb in limbs]
    twist = motion.twist[::every]
    assumed = twist.copy()
    assumed[:, 2] = 0.0

    def residual(wanted: Array) -> Array:
        total = np.zeros(len(wanted))
        for own in columns:
            matrix = screws[:, :, own]
            rest = wanted - (matrix @ (np.linalg.pinv(matrix) @ wanted[..., None]))[..., 0]
            total += (rest**2).sum(axis=-1)
        return np.sqrt(total)

    shape = (6 * len(columns), sum(len(own) for own in columns))
    return Assumption(motion.t[::every], residual(assumed), float(residual(twist).max()), shape)


def at_rest(mechanism: Mechanism, scene: Scene) -> Statics:
    """Drives that hold the mechanism in its reference configuration under gravity and the scene's load."""
    model = derive(mechanism, (Gravity(), ExternalWrench(scene.loaded_point)))
    functions = load(model.only(("inverse_dynamics",)), backend="casadi")
    rest = np.zeros(len(model.system.tree.v))
    u = functions.inverse_dynamics(model.system.reference, rest, rest, np.array(scene.load))
    return Statics(functions["inverse_dynamics"].outputs[0].labels, np.asarray(u))
