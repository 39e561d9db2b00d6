"""Study "momentum": rates of the momentum screws by differences, by the complex step, and analytically.

    first order   (M(t + h) - M(t)) / h                                        the source paper's way
    central       (M(t + h) - M(t - h)) / 2h
    Richardson    (8 (M(t + h/2) - M(t - h/2)) - (M(t + h) - M(t - h))) / 6h
    complex step  Im M(q + i h q_dot, v + i h a) / h,  h = 1e-30
    analytic      momentum_rates(q, v, a)

The states at the neighbouring instants are given to the differences and cost nothing; rates are timed, and become
drives by the same linear map for all. Reference: central differences in 60 digits with h = 1e-20.
"""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.program import Program, evaluate
from symscrew.reference import newton_euler
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.compiled_loops import caller, compiled, loop_code, one_file, pointer
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.states import States, Subject, body_states_of
from symscrew.studies.accuracy.typed_code import COMPLEX, as_floats, in_digits, only, typed_function
from symscrew.studies.platform_motion import coordinate_rates

Array = np.ndarray
STEPS = 10.0 ** -np.arange(0.5, 12.01, 0.5)  # h [s]: from too coarse to nothing but rounding, two a decade
FORMULAS = {
    "first-order difference": ((0.0, -1.0), (1.0, 1.0)),
    "central difference": ((-1.0, -0.5), (1.0, 0.5)),
    "Richardson": ((-1.0, 1 / 6), (-0.5, -8 / 6), (0.5, 8 / 6), (1.0, -1 / 6)),
}
CALLS = 20  # passes over all states per measurement: some milliseconds, which the clock sees
CHOSEN = 21  # of the subject's states: the reference in 60 digits is slow
DIFFERENCE = """
int difference(size_t count, size_t evaluations, const double *weights, const double *q, const double *v, double *rates)
{
    int worst = 0;
    for (size_t i = 0; i < count; ++i) {
        double *rate = rates + i * SIZE;
        for (size_t k = 0; k < evaluations; ++k) {
            double screws[SIZE];
            worst |= MOMENTUM(q + (i * evaluations + k) * NQ, v + (i * evaluations + k) * NV, screws);
            for (size_t j = 0; j < SIZE; ++j) {
                rate[j] = k == 0 ? weights[0] * screws[j] : rate[j] + weights[k] * screws[j];
            }
        }
    }
    return worst;
}
"""
COMPLEX_STEP = """
int complex_step(size_t count, const double *q, const double *q_dot, const double *v, const double *a, double *rates)
{
    for (size_t i = 0; i < count; ++i) {
        double complex place[NQ], rate[NV], screws[SIZE];
        for (size_t k = 0; k < NQ; ++k) {
            place[k] = q[i * NQ + k] + 1e-30 * I * q_dot[i * NQ + k];
        }
        for (size_t k = 0; k < NV; ++k) {
            rate[k] = v[i * NV + k] + 1e-30 * I * a[i * NV + k];
        }
        momentum_complex(place, rate, screws);
        for (size_t k = 0; k < SIZE; ++k) {
            rates[i * SIZE + k] = 1e30 * cimag(screws[k]);
        }
    }
    return 0;
}
"""


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Errors of the drive forces against the time for all rates of momentum screws of a state."""
    model, watch = subject.model, Stopwatch()
    needed = ("momentum_screws", "momentum_rates", "inverse_dynamics", "body_twists", "drive_rates")
    missing = [name for name in needed if name not in model.programs]
    if missing or model.system.parameters:
        reason = f"it has no {missing[0]}" if missing else "it has run-time parameters"
        raise DescriptionError(f"--study momentum: {model.name} cannot be studied, {reason}")
    states = _chosen(subject.states)
    with progress.step("momentum: reference in 60 digits"):
        exact = reference_rates(model, states)
    to_drives = drive_map(model, states)
    drives = np.einsum("nij,nj->ni", to_drives, exact)
    setups: list[Setup] = []

    def error_of(rates: Array) -> float:
        change = np.einsum("nij,nj->ni", to_drives, rates[: len(states.q)] - exact)
        return float(np.abs(change).max())

    left_out: tuple[str, ...] = ()
    if find_compiler():
        setups += _compiled_setups(model, states, error_of, watch)
    else:
        left_out = ("all curves of generated C: there is no C compiler",)
    setups += _numpy_setups(model, states, error_of)
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="momentum")
    largest = float(np.abs(drives + _gravity_part(model, states, exact, to_drives)).max())
    return Study(
        "momentum",
        f"Rates of the momentum screws of {model.name}",
        points,
        error_label="largest error of the drive forces [N]"
        if _forces(model)
        else "largest error of the drives [N or N m]",
        cost_label="time for the rates of all momentum screws of a state",
        cost_unit="ns",
        reference="central differences of the same momentum screws in 60 digits, h = 1e-20 (truncation below 1e-35); "
        "the stated difference is that of the resulting drives to Newton-Euler with accelerations in maximal "
        "coordinates",
        reference_error=_check(model, states, exact, to_drives),
        preparation=watch.seconds,
        left_out=left_out,
        notes=(
            f"States: {len(states.q)} of {subject.states.text}; largest drive {largest:.4g}.",
            "Neighbouring states are given to the differences, and not timed. Steps h in seconds.",
        ),
    )


def _chosen(states: States) -> States:
    pick = np.linspace(0, len(states.q) - 1, min(CHOSEN, len(states.q))).astype(int)
    return States(states.q[pick], states.v[pick], states.a[pick], states.text)


def _forces(model: Model) -> bool:
    return all(unit == "N" for unit in model.programs["inverse_dynamics"].outputs[0].units)


def _screws(model: Model) -> Program:
    program = model.programs["momentum_screws"]
    assert isinstance(program, Program)
    return only(program, ("momenta",))


def momenta_of(model: Model, q: Array, v: Array) -> Array:
    """Momentum screws of all bodies (n, 6 bodies)."""
    found: Array = evaluate(_screws(model), [q, v])[0][0]
    return found


def _second(model: Model, q: Array, v: Array, a: Array) -> Array:
    """Second time derivative of q: that of q_dot = B(q) v, which is bilinear in q and v."""
    turning = coordinate_rates(model, coordinate_rates(model, q, v), v) * _turning(model)
    second: Array = coordinate_rates(model, q, a) + turning
    return second


def _turning(model: Model) -> Array:
    """1 for entries of quaternions, whose rates depend on q; 0 for the others."""
    mask = np.zeros(len(model.system.reference))
    for link in model.system.tree.links[1:]:
        if link.q.stop - link.q.start == 4:
            mask[link.q] = 1.0
    return mask


def neighbour(model: Model, states: States, h: float) -> tuple[Array, Array]:
    """q and v at a time h away: the motion to second order in q and first in v, with unit quaternions."""
    q = states.q + h * coordinate_rates(model, states.q, states.v)
    q = q + 0.5 * h * h * _second(model, states.q, states.v, states.a)
    for link in model.system.tree.links[1:]:
        if link.q.stop - link.q.start == 4:
            q[:, link.q] /= np.linalg.norm(q[:, link.q], axis=1, keepdims=True)
    return q, states.v + h * states.a


def reference_rates(model: Model, states: States) -> Array:
    """Rates of the momentum screws (n, 6 bodies), differentiated in 60 digits."""
    import mpmath

    context, program = mpmath.mp.clone(), _screws(model)
    context.dps = 60
    h = context.mpf(10) ** -20
    rows = []
    for q, v, a in zip(states.q, states.v, states.a, strict=True):
        q_dot = coordinate_rates(model, q, v)
        sides = [
            in_digits(
                program,
                [
                    [context.mpf(x) + s * h * context.mpf(y) for x, y in zip(q, q_dot, strict=True)],
                    [context.mpf(x) + s * h * context.mpf(y) for x, y in zip(v, a, strict=True)],
                ],
            )[0]
            for s in (1, -1)
        ]
        rows.append(as_floats([[(x - y) / (2 * h) for x, y in zip(*sides, strict=True)]])[0])
    return np.array(rows)


def drive_map(model: Model, states: States) -> Array:
    """u = map (dM/dt - force screws), (n, drives, 6 bodies): by virtual power on the admissible motions.

    Sum over bodies of twist o (dM/dt - F) = sum of drive rates u for every admissible motion; among all solutions
    that of least norm, as `inverse_dynamics` has it.
    """
    n, nv = states.v.shape
    names = [label.split(".")[0] for label in model.programs["momentum_rates"].outputs[0].labels[::6]]
    bodies = [name for name in model.mechanism.bodies if name != model.mechanism.ground]
    own = [bodies.index(name) for name in names]
    twists = np.empty((n, len(own), 6, nv))
    rates = []
    for k in range(nv):
        unit = np.zeros((n, nv))
        unit[:, k] = 1.0
        found = model("body_twists", states.q, unit)[0][0].reshape(n, -1, 6)
        twists[..., k] = found[:, own]
        rates.append(model("drive_rates", states.q, unit)[0][0])
    basis = np.repeat(np.eye(nv)[None], n, 0)
    if "null_space" in model.programs:
        basis = np.moveaxis(model("null_space", states.q)[0][0].reshape(n, -1, nv), 1, 2)
    paired = np.concatenate([twists[:, :, 3:], twists[:, :, :3]], axis=2).reshape(n, -1, nv) @ basis
    driven = np.stack(rates, axis=2) @ basis
    return np.linalg.pinv(np.swapaxes(driven, 1, 2), rcond=1e-10) @ np.swapaxes(paired, 1, 2)


def drives_of(model: Model, states: States) -> Array:
    """Drives (n, drives) by the generated inverse dynamics."""
    program = model.programs["inverse_dynamics"]
    known = {"q": states.q, "v": states.v, "a": states.a}
    n = len(states.q)
    tests = model.test_inputs["inverse_dynamics"]
    arrays = [
        known[p.name] if p.name in known else np.repeat(t[:1], n, 0) for p, t in zip(program.inputs, tests, strict=True)
    ]
    found: Array = model("inverse_dynamics", *arrays)[0][0]
    return found


def _gravity_part(model: Model, states: States, exact: Array, to_drives: Array) -> Array:
    """What forces other than inertia add to the drives."""
    part: Array = drives_of(model, states) - np.einsum("nij,nj->ni", to_drives, exact)
    return part


def _check(model: Model, states: States, exact: Array, to_drives: Array) -> float:
    """Drives by the reference's rates less those of Newton-Euler without gravity [N]."""
    other = newton_euler(model.mechanism, body_states_of(model, states), gravity=(0.0, 0.0, 0.0)).drives
    return float(np.abs(np.einsum("nij,nj->ni", to_drives, exact) - other).max())


def _neighbours(model: Model, states: States, h: float, places: tuple[float, ...]) -> tuple[Array, Array]:
    """States at several instants, those of one state one after the other: (n evaluations, nq), (n evaluations, nv)."""
    pairs = [neighbour(model, states, h * place) for place in places]
    q, v = (np.stack([pair[k] for pair in pairs], axis=1) for k in (0, 1))
    return q.reshape(-1, q.shape[-1]), v.reshape(-1, v.shape[-1])


def _compiled_setups(model: Model, states: States, error_of: Callable[[Array], float], watch: Stopwatch) -> list[Setup]:
    screws, rates = _screws(model), model.programs["momentum_rates"]
    assert isinstance(rates, Program)
    size, nq, nv = screws.outputs[0].size, states.q.shape[1], states.v.shape[1]
    head = f"#define SIZE {size}\n#define NQ {nq}\n#define NV {nv}\n#define MOMENTUM {model.name}_momentum_screws\n"
    text = watch("print", one_file, model, {"momentum_screws": screws, "momentum_rates": rates})
    text += loop_code(f"{model.name}_momentum_rates", rates.inputs, rates.outputs, "double")
    library = watch("compile", compiled, head + text + DIFFERENCE)
    turned = "#include <complex.h>\n#include <stddef.h>\n" + head + typed_function(screws, "momentum_complex", COMPLEX)
    complex_library = watch("compile", compiled, turned + COMPLEX_STEP)

    def tiled(array: Array) -> Array:
        return np.ascontiguousarray(np.tile(array, (CALLS, 1)))

    count = CALLS * len(states.q)
    results = np.zeros((count, size))
    setups: list[Setup] = []

    def timed(function: Callable[..., int], *arguments: Any) -> float:
        start = time.thread_time()
        worst = function(*arguments)
        taken = time.thread_time() - start
        if worst > 0:
            raise ArithmeticError(f"status {worst}")
        return taken

    for curve, formula in FORMULAS.items():
        places, factors = (tuple(part) for part in zip(*formula, strict=True))
        for h in STEPS:
            weights = np.array(factors) / h
            q, v = (tiled(x) for x in _neighbours(model, states, h, places))

            def run(given: tuple[Array, ...] = (weights, q, v, results)) -> float:  # this round's, not the last's
                return timed(
                    library.difference, ctypes.c_size_t(count), ctypes.c_size_t(len(given[0])), *map(pointer, given)
                )  # fmt: skip

            facts = {"h": float(h), "operations": len(places) * (screws.operations["total"] + 2 * size)}
            setups.append(Setup(curve, f"h = {h:.1e} s", run, lambda: error_of(results), count, facts))
    q, v, a = (tiled(x) for x in (states.q, states.v, states.a))
    q_dot = tiled(coordinate_rates(model, states.q, states.v))
    arrays = (q, q_dot, v, a, results)
    setups.append(
        Setup(
            "complex step", "h = 1e-30 s",
            lambda: timed(complex_library.complex_step, ctypes.c_size_t(count), *map(pointer, arrays)),
            lambda: error_of(results), count,
        )
    )  # fmt: skip
    analytic = caller(library, f"{model.name}_momentum_rates", [q, v, a], [results])
    facts = {"operations": rates.operations["total"]}
    setups.append(Setup("analytic", "momentum_rates", analytic, lambda: error_of(results), count, facts))
    return setups


def _numpy_setups(model: Model, states: States, error_of: Callable[[Array], float]) -> list[Setup]:
    """One state at a time on NumPy, as a script has it."""
    one = States(states.q[:1], states.v[:1], states.a[:1], states.text)
    program = _screws(model)

    def screws(q: Array, v: Array) -> Array:
        found: Array = evaluate(program, [q, v])[0][0]
        return found

    def difference(h: float) -> Setup:
        before, after = neighbour(model, states, 0.0), neighbour(model, states, h)
        one_before, one_after = neighbour(model, one, 0.0), neighbour(model, one, h)

        def run() -> float:
            start = time.thread_time()
            _ = (screws(*one_after) - screws(*one_before)) / h
            return time.thread_time() - start

        def error() -> float:
            return error_of((screws(*after) - screws(*before)) / h)

        return Setup("first-order difference, NumPy", f"h = {h:.1e} s", run, error, 1.0, {"h": h})

    def run_analytic() -> float:
        start = time.thread_time()
        model("momentum_rates", one.q, one.v, one.a)
        return time.thread_time() - start

    def error_analytic() -> float:
        return error_of(model("momentum_rates", states.q, states.v, states.a)[0][0])

    analytic = Setup("analytic, NumPy", "momentum_rates", run_analytic, error_analytic)
    return [*map(difference, (1e-1, 1e-3, 1e-5, 1e-7, 1e-9)), analytic]
