"""Study "kinematics": joint positions from the known motion of the platform.

The motion is that of section 5 of the source paper, 10 s; every method is given the platform's motion at the
instants that it asks for (its twist to those that integrate, its pose to the closed form), and finds the displacements
of all joints. The paper's own method assumes omega_z = 0, which its least squares (27) hides.
"""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path

import numpy as np
from numpy.polynomial import chebyshev

from symscrew.algebra import Node
from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.functions import TWIST_LABELS, TWIST_UNITS, Motion, function, kinematic_functions, q_port
from symscrew.kinematics import Link, System
from symscrew.model import Model
from symscrew.program import Port, Program, evaluate, lower
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.compiled_loops import caller, compiled, loop_code, one_file, pointer
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.serial_formulas import Chains, least_squares, opened
from symscrew.studies.accuracy.states import Subject, follows_the_paper
from symscrew.studies.demo import SECTION_5

Array = np.ndarray
DURATION = SECTION_5.duration
OUTPUTS = 101  # instants at which displacements are compared, one every 0.1 s
DEGREE = 60  # of the polynomial of omega_z over the whole motion
LONGEST = 0.1  # step of the reference [s]; its method is of order 8
LEAST_SECONDS = 20.0  # of measuring: the finest steps take a second a run, and have three repeats


def study(
    subject: Subject, progress: Progress, *, repeats: int, seconds: float, path: Path | None = None, full: bool = False
) -> Study:
    """Largest errors of all joint displacements against time per simulated second."""
    model, watch = subject.model, Stopwatch()
    if not model.mechanism.limbs or not follows_the_paper(model):
        raise DescriptionError(
            f"--study kinematics: {model.name} has no limbs whose platform moves by omega_x and omega_y, as the motion "
            "of section 5 asks for; use a mechanism such as three_ups_upu_s"
        )
    with progress.step("kinematics: reference"):
        motion = _reference(model)
    own = _own_error(model, motion)
    setups = _numpy_setups(motion)
    left_out: tuple[str, ...] = ()
    if find_compiler():
        setups += _compiled_setups(model, motion, watch, full)
        setups += _closed_form(model, motion, watch)
    else:
        left_out = ("all curves of generated C: there is no C compiler",)
    points = measured(
        setups, repeats=repeats, seconds=max(seconds, LEAST_SECONDS), progress=progress, text="kinematics"
    )
    return Study(
        "kinematics",
        f"Joint positions of {model.name} from the motion of its platform",
        points,
        error_label="largest joint position error [rad, m]",
        cost_label="time per simulated second",
        cost_unit="ms",
        reference=f"Runge-Kutta of order 8 with steps of {LONGEST} s at most on the limbs' serial chains, omega_z "
        "solved with the rates; its difference to closed-form inverse kinematics of its platform's poses",
        reference_error=own,
        preparation=watch.seconds,
        left_out=left_out,
        notes=(
            f"Motion of section 5 of the source paper, {DURATION:g} s; all {motion.exact.shape[1]} displacements at "
            f"{OUTPUTS} instants. S = blockdiag, {6 * len(model.mechanism.limbs)} x {motion.exact.shape[1]}.",
            "Twists and poses of the platform are given to all methods beforehand and not timed.",
            f"Largest omega_z that the limbs demand: {np.abs(motion.twist(_times(1000))[:, 2]).max():.3e} "
            "rad/s; curves with omega_z = 0 do as the paper does and end at what this leaves.",
        ),
    )


@dataclass(frozen=True)
class PlatformMotion:
    """The reference: displacements (outputs, freedoms), the platform's quaternions, omega_z as a polynomial."""

    chains: Chains
    exact: Array
    poses: Array
    spin: Array

    def twist(self, t: Array, *, spin: bool = True) -> Array:
        """(n, 6): the platform's twist at O, with omega_z as the limbs demand it or zero."""
        result = np.zeros((len(t), 6))
        result[:, :2] = SECTION_5.motion.rate(t)
        if spin:
            result[:, 2] = chebyshev.chebval(2 * t / DURATION - 1, self.spin)
        return result


def _reference(model: Model) -> PlatformMotion:
    from scipy.integrate import DOP853

    chains = Chains(model.mechanism)

    def slope(t: float, values: Array) -> tuple[Array, float]:
        state = chains.unflat(values)
        matrix = chains.matrix(state)
        turning = np.tile(np.eye(6)[:, 2:3], (len(matrix) // 6, 1))
        given = np.zeros(6)
        given[:2] = SECTION_5.motion.rate(np.array(t))
        found = np.linalg.lstsq(np.hstack([matrix, -turning]), np.tile(given, len(matrix) // 6), rcond=1e-12)[0]
        return chains.flat_rates(state, found[:-1]), float(found[-1])

    outputs = np.linspace(0, DURATION, OUTPUTS)
    nodes = DURATION / 2 * (1 - np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)))
    times = np.unique(np.concatenate([outputs, nodes]))
    values, t = chains.flat(chains.start()), 0.0
    exact, poses, spins = {}, {}, {}
    last = next(k for k, joints in enumerate(chains.limbs) if len(joints) == 1) if any(
        len(joints) == 1 for joints in chains.limbs) else None  # fmt: skip
    for end in times:
        count = max(1, int(np.ceil((end - t) / LONGEST)))
        h = (end - t) / count
        for _ in range(count if h > 0 else 0):
            k = np.zeros((12, len(values)))
            for stage in range(12):
                k[stage] = slope(t + DOP853.C[stage] * h, values + h * (DOP853.A[stage, :stage] @ k[:stage]))[0]
            values = chains.flat(chains.unflat(values + h * (DOP853.B @ k)))
            t += h
        t = float(end)
        spins[t] = slope(t, values)[1]
        state = chains.unflat(values)
        exact[t] = chains.displacements(state)
        poses[t] = state[chains.limbs[last][0]] if last is not None else np.zeros(4)
    fitted = chebyshev.chebfit(2 * nodes / DURATION - 1, [spins[float(x)] for x in nodes], DEGREE)
    return PlatformMotion(
        chains, np.array([exact[float(x)] for x in outputs]), np.array([poses[float(x)] for x in outputs]), fitted
    )


def _own_error(model: Model, motion: PlatformMotion) -> float | None:
    if "inverse_kinematics" not in model.programs:
        return None
    (q,), _ = model("inverse_kinematics", motion.poses)
    return float(np.abs(model("joint_displacements", q)[0][0] - motion.exact).max())


def _times(steps: int) -> Array:
    return np.linspace(0, DURATION, steps + 1)


def _steps(h: float) -> tuple[int, int]:
    """Steps of the whole motion, and how many there are between two outputs."""
    every = max(1, round(DURATION / (OUTPUTS - 1) / h))
    return every * (OUTPUTS - 1), every


def _numpy_setups(motion: PlatformMotion) -> list[Setup]:
    """The paper's method as the paper runs it: limbs as serial chains in NumPy, a least squares problem a step."""
    return [_numpy_setup(motion, h) for h in (1e-1, 1e-2, 1e-3)]


def _numpy_setup(motion: PlatformMotion, h: float) -> Setup:
    chains, (steps, every) = motion.chains, _steps(h)
    twists = motion.twist(_times(steps), spin=False)
    found: list[Array] = []

    def run() -> float:
        found.clear()
        start = time.thread_time()
        state = chains.start()
        for n in range(steps + 1):
            if n % every == 0:
                found.append(chains.displacements(state))
            if n < steps:
                state = chains.moved(state, least_squares(chains.matrix(state), twists[n]), h)
        return time.thread_time() - start

    def error() -> float:
        return float(np.abs(np.array(found) - motion.exact).max())

    curve = "forward Euler, least squares, omega_z = 0: NumPy (the paper's)"
    return Setup(curve, f"dt = {h:g} s", run, error, DURATION, {"dt": h})


@dataclass(frozen=True)
class _Method:
    """A curve of generated C: what it integrates, of which order, with projection or not, with omega_z or not."""

    curve: str
    closed: bool
    order: int
    spin: bool
    steps: tuple[float, ...]


def _methods(full: bool) -> list[_Method]:
    fine = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5)
    coarse = (1e-1, 5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3) + ((5e-4, 2e-4) if full else ())
    return [
        _Method("forward Euler, least squares, omega_z = 0: C (the paper's)", False, 1, False, fine),
        _Method("forward Euler, least squares: C", False, 1, True, fine),
        _Method("forward Euler, least squares, projection: C", True, 1, True, fine[:-1] if not full else fine),
        _Method("Runge-Kutta 4, least squares: C", False, 4, True, coarse),
        _Method("Runge-Kutta 4, least squares, projection: C", True, 4, True, coarse),
    ]


def _compiled_setups(model: Model, motion: PlatformMotion, watch: Stopwatch, full: bool) -> list[Setup]:
    chain_system = watch("derive", System, opened(model.mechanism))
    libraries = {
        closed: _library(model, model.system if closed else chain_system, closed, watch) for closed in (False, True)
    }
    return [
        _compiled_setup(method, h, libraries[method.closed], motion)
        for method in _methods(full)
        for h in method.steps
        # steps that are longer than an output's interval are shortened to it: that curve has the point already
        if method.order == 1 or _steps(h)[1] * h >= 0.99 * DURATION / (OUTPUTS - 1)
    ]


def _compiled_setup(method: _Method, h: float, loop: _Loop, motion: PlatformMotion) -> Setup:
    steps, every = _steps(h)
    times = _times(steps if method.order == 1 else 2 * steps)  # order 4 also asks in the middle of a step
    twists = np.ascontiguousarray(motion.twist(times, spin=method.spin))
    start = np.ascontiguousarray(loop.system.reference)
    outputs = np.zeros((OUTPUTS, len(start)))
    length = DURATION / steps

    def run() -> float:
        begin = time.thread_time()
        failed = loop.library.integrate(
            ctypes.c_long(steps), ctypes.c_double(length), ctypes.c_int(method.order), pointer(start), pointer(twists),
            ctypes.c_long(every), pointer(outputs),
        )  # fmt: skip
        taken = time.thread_time() - begin
        if failed:
            raise ArithmeticError("the projection failed")
        return taken

    def error() -> float:
        return float(np.abs(evaluate(loop.displacements, [outputs])[0][0] - motion.exact).max())

    return Setup(method.curve, f"dt = {h:g} s", run, error, DURATION, {"dt": h})


@dataclass(frozen=True)
class _Loop:
    """The compiled loop on a system's tree, the system, and the function that makes displacements of its q."""

    library: ctypes.CDLL
    system: System
    displacements: Program


def _library(model: Model, system: System, closed: bool, watch: Stopwatch) -> _Loop:
    """The compiled loop on a system's tree."""
    functions = {f.name: f for f in kinematic_functions(system, Motion(system))}
    labels = functions["joint_rates"].outputs[0].labels
    limbs = [
        [k for k, label in enumerate(labels) if label.split(".")[0] in limb.joints]
        for limb in model.mechanism.limbs.values()
    ]
    rates = watch("derive", least_squares_program, system, functions["joint_screws"].results[0], labels, limbs)
    programs = {"least_squares": rates}
    if closed:
        found = model.programs["close_position"]
        assert isinstance(found, Program)
        programs["close_position"] = found
    text = watch("print", one_file, replace(model, system=system), programs)
    adapters = [
        f"#define rates_at {model.name}_least_squares",
        "static inline int closed_at(const double *q, double *next)",
        "{",
        "    double residual[1];",
        f"    return {model.name}_close_position(q, next, residual);",
        "}",
    ]
    kernel = resources.files("symscrew.studies.accuracy").joinpath("kernels/kinematics.c").read_text(encoding="utf-8")
    head = ["#include <math.h>", "#include <string.h>", *_layout(system, labels), f"#define PROJECTED {int(closed)}"]
    whole = "\n".join([*head, text, *(adapters if closed else adapters[:1]), kernel])
    library = watch("compile", compiled, whole)
    return _Loop(library, system, lower(functions["joint_displacements"]))


def _layout(system: System, labels: tuple[str, ...]) -> list[str]:
    """Where coordinates of the tree take their rates from."""

    def first(link: Link) -> int:
        label = system.tree.v[link.v.start].label
        return labels.index(label if label in labels else label.replace(".w", "."))

    links = system.tree.links[1:]
    spheres = [(li.q.start, first(li)) for li in links if li.motion.spherical]
    plain = [(li.q.start, first(li)) for li in links if li.motion.single]
    rows = [("PLAIN", plain), ("SPHERES", spheres)]
    lines = [f"#define NQ {len(system.tree.q)}", f"#define NW {len(labels)}"]
    lines += [f"#define PLAIN_COUNT {len(plain)}", f"#define SPHERE_COUNT {len(spheres)}"]
    for name, pairs in rows:
        body = ", ".join(f"{{{a}, {b}}}" for a, b in pairs) or "{0, 0}"
        lines.append(f"static const int {name}[{max(len(pairs), 1)}][2] = {{{body}}};")
    return lines


def least_squares_program(
    system: System, screws: tuple[Node, ...], labels: tuple[str, ...], limbs: list[list[int]]
) -> Program:
    """w = (S^T S)^-1 S^T V limb by limb, eq. (27): S is block-diagonal, and so is S^T S; by L D L^T.

    Inputs q (of the system's tree) and the platform's twist (6) at O, output the rates of all joints.
    """
    tape = system.tape
    units = zip(TWIST_LABELS, TWIST_UNITS, strict=True)
    twist = tuple(tape.symbol(f"platform_{label}", unit, "component of the platform's twist") for label, unit in units)
    rates: list[Node] = [tape.zero] * len(labels)
    for own in limbs:
        columns = [screws[6 * k : 6 * k + 6] for k in own]
        gram = [[_dot(tape.zero, a, b) for b in columns] for a in columns]
        right = [_dot(tape.zero, a, twist) for a in columns]
        for k, value in zip(own, _solved(gram, right), strict=True):
            rates[k] = value
    given = Port("twist", (6,), TWIST_UNITS, TWIST_LABELS, "the platform's twist (omega ; v_O)")
    port = Port("rates", (len(labels),), ("1/s",) * len(labels), labels, "rates of all joints")
    text = "Joint rates by least squares from the platform's twist, eq. (27)."
    inputs = [(q_port(system), system.inputs.q), (given, twist)]
    return lower(function(system, "least_squares", text, inputs=inputs, outputs=[(port, rates)]))


def _dot(zero: Node, a: tuple[Node, ...], b: tuple[Node, ...]) -> Node:
    total = zero
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def _solved(gram: list[list[Node]], right: list[Node]) -> list[Node]:
    """Solution of a symmetric positive definite system: L D L^T without pivots."""
    n = len(right)
    lower_factor: list[list[Node]] = [[right[0]] * n for _ in range(n)]
    diagonal: list[Node] = []
    inverse: list[Node] = []
    for j in range(n):
        pivot = gram[j][j]
        for k in range(j):
            pivot = pivot - lower_factor[j][k] * lower_factor[j][k] * diagonal[k]
        diagonal.append(pivot)
        inverse.append(1 / pivot)
        for i in range(j + 1, n):
            entry = gram[i][j]
            for k in range(j):
                entry = entry - lower_factor[i][k] * lower_factor[j][k] * diagonal[k]
            lower_factor[i][j] = entry * inverse[j]
    forward: list[Node] = []
    for i in range(n):
        value = right[i]
        for k in range(i):
            value = value - lower_factor[i][k] * forward[k]
        forward.append(value)
    result: list[Node] = [value * d for value, d in zip(forward, inverse, strict=True)]
    for i in reversed(range(n)):
        for k in range(i + 1, n):
            result[i] = result[i] - lower_factor[k][i] * result[k]
    return result


def _closed_form(model: Model, motion: PlatformMotion, watch: Stopwatch) -> list[Setup]:
    """Joint displacements of a pose by closed-form inverse kinematics, evaluated 10 and 1000 times a second."""
    first, second = (model.programs.get(name) for name in ("inverse_kinematics", "joint_displacements"))
    if not isinstance(first, Program) or not isinstance(second, Program):
        return []
    name = model.name
    text = watch("print", one_file, model, {"inverse_kinematics": first, "joint_displacements": second})
    size = first.outputs[0].size
    text += f"""
static int {name}_positions(const double *pose, double *displacements)
{{
    double q[{size}];
    const int status = {name}_inverse_kinematics(pose, q);
    return status | {name}_joint_displacements(q, displacements);
}}
"""
    text += loop_code(f"{name}_positions", first.inputs, second.outputs, "double")
    library = watch("compile", compiled, text)
    setups = []
    for copies in (1, 100):
        poses = np.ascontiguousarray(np.tile(motion.poses, (copies, 1)))
        found = np.zeros((len(poses), second.outputs[0].size))
        run: Callable[[], float] = caller(library, f"{name}_positions", [poses], [found])

        def error(found: Array = found) -> float:
            return float(np.abs(found[:OUTPUTS] - motion.exact).max())

        rate = copies * (OUTPUTS - 1) / DURATION
        share = len(poses) / rate
        setups.append(Setup("closed form of the pose: C", f"{rate:g} evaluations/s", run, error, share))
    return setups
