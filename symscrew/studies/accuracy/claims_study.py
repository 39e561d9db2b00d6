"""Study "claims": what the source paper says of its method, measured.

- Momentum screws need no accelerations and are cheaper than Newton-Euler: both as generated code in absolute axes, from
  the same states, to the wrench on every body; errors of the drives that follow.
- The impulse form (36)-(38) over a step against the differential form (35): mean drives over a step.
- The load of section 5.2 is shared by four limbs and the S limb; two UPS limbs are more than mobility needs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from symscrew.algebra import add, cross, scale, transform
from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.functions import (
    WRENCH_LABELS,
    WRENCH_UNITS,
    Motion,
    a_port,
    acceleration_at,
    columns_port,
    function,
    mass_properties,
    moving_bodies,
    q_port,
    v_port,
)
from symscrew.kinematics import System
from symscrew.model import Model
from symscrew.program import Program, lower
from symscrew.reference import newton_euler
from symscrew.runtime import find_compiler
from symscrew.studies.accuracy.compiled_loops import caller, compiled, loop_code, one_file
from symscrew.studies.accuracy.load_sharing import Table, loaded, redundancy, sharing
from symscrew.studies.accuracy.measuring import Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.momentum_study import drive_map, drives_of, momenta_of, neighbour, reference_rates
from symscrew.studies.accuracy.states import States, Subject, body_states_of, follows_the_paper
from symscrew.studies.accuracy.typed_code import only
from symscrew.studies.demo import SECTION_5

Array = np.ndarray
COUNT, CALLS = 21, 20  # instants of the motion, and passes over them per measurement: some milliseconds
STEPS = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4)  # h [s], two a decade: an order shows as a slope
AMPLITUDE = 0.1  # of the independent coordinates, in their units
INSTANT, OVER_STEP = "rates at an instant", "mean drives over a step"


def study(subject: Subject, progress: Progress, *, repeats: int, seconds: float) -> Study:
    """Errors of drives against time for the wrenches on all bodies, and tables of the load."""
    model, watch = subject.model, Stopwatch()
    if find_compiler() is None:
        raise DescriptionError("--study claims: its times are of generated C, and there is no C compiler")
    needed = ("momentum_rates", "assemble", "acceleration", "drive_rates", "inverse_dynamics")
    missing = [name for name in needed if name not in model.programs]
    if missing or model.system.parameters:
        raise DescriptionError(f"--study claims: {model.name} has no {', '.join(missing) or 'fixed parameters'}")
    states = smooth_motion(model, np.linspace(0.0, 2 * np.pi, COUNT))
    to_drives, exact = drive_map(model, states), reference_rates(model, states)
    programs = {
        "momentum_screws": only(_program(model, "momentum_screws"), ("momenta",)),
        "momentum_rates": _program(model, "momentum_rates"),
        "newton_euler": watch("derive", newton_euler_program, model.system),
    }
    timed = _timed(model, programs, states, watch)
    setups = _at_an_instant(model, states, programs, timed, to_drives=to_drives, exact=exact)
    setups += _over_a_step(model, states, programs, timed)
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="claims")
    tables = {"Operations to the wrenches on all bodies": _operations(model, programs)}
    left_out: tuple[str, ...] = ()
    if follows_the_paper(model) and SECTION_5.loaded_point in model.mechanism.points:
        with progress.step("claims: how the load is shared"):
            under_load = loaded(model.mechanism)
            tables["How limbs share the load of section 5.2, means over the motion"] = sharing(
                under_load, subject.states
            )
            tables["Peak drives with and without the additional limbs"] = redundancy(under_load, subject.states)
    else:
        left_out = ("sharing of the load of section 5.2: it belongs to the source paper's motion and platform",)
    other = newton_euler(model.mechanism, body_states_of(model, states), gravity=(0.0, 0.0, 0.0)).drives
    own = float(np.abs(np.einsum("nij,nj->ni", to_drives, exact) - other).max())
    return Study(
        "claims",
        f"Claims of the source paper on {model.name}",
        points,
        error_label="largest error of the drives [N]",
        cost_label="time for all bodies of a state or step",
        cost_unit="ns",
        reference="momentum screws differentiated in 60 digits; its difference to Newton-Euler in maximal coordinates. "
        "Mean drives over a step: Gauss' rule of 8 points on the analytic drives",
        reference_error=own,
        preparation=watch.seconds,
        left_out=left_out,
        notes=(
            f"Motion: independent coordinates {AMPLITUDE:g} sin t, {AMPLITUDE:g} (1 - cos t), ... about the reference, "
            f"closed exactly; {COUNT} instants. States are given to all methods and not timed.",
            "Differences and the impulse form need one evaluation of the momentum screws a step: that at its start is "
            "known from the step before.",
        ),
        tables=tables,
    )


def smooth_motion(model: Model, t: Array) -> States:
    """Exact states of a smooth motion of the independent coordinates, closed by `assemble`."""
    names = list(model.programs["assemble"].inputs[0].labels)
    labels = [c.label for c in model.system.tree.q]
    start = model.system.reference[[labels.index(name) for name in names]]
    phases = np.arange(len(names)) % 2 * np.pi / 2
    y = AMPLITUDE * (np.sin(t[:, None] - phases) + np.sin(phases))
    y_dot, y_ddot = AMPLITUDE * np.cos(t[:, None] - phases), -AMPLITUDE * np.sin(t[:, None] - phases)
    guess = np.repeat(model.system.reference[None], len(t), 0)
    (q,), status = model("assemble", start + y, guess)
    if np.any(np.asarray(status) > 0):
        raise DescriptionError(f"{model.name}: the loops do not close along the motion of this study")
    v = model("velocity", q, y_dot)[0][0]
    return States(q, v, model("acceleration", q, v, y_ddot)[0][0], "a smooth motion", t)


def newton_euler_program(system: System) -> Program:
    """Wrenches (f ; m_O) on all bodies by accelerations: m a_C, J alpha + omega x J omega about C, moved to O."""
    motion, values, names = Motion(system), [], []
    for name in moving_bodies(system):
        body = mass_properties(system, name)
        if body is None:
            continue
        own = motion.body(name)
        force = scale(body.mass, acceleration_at(own, body.com))
        spin = transform(body.inertia, own.twist.angular)
        moment = add(transform(body.inertia, own.rate.angular), cross(own.twist.angular, spin))
        values += [*force, *add(cross(body.com, force), moment)]
        names.append(name)
    port = columns_port("wrenches", names, WRENCH_LABELS, WRENCH_UNITS, description="wrench on every body")
    inputs = [(q_port(system), system.inputs.q), (v_port(system), system.inputs.v), (a_port(system), system.inputs.a)]
    return lower(
        function(system, "newton_euler", "Newton-Euler with accelerations.", inputs=inputs, outputs=[(port, values)])
    )


def _program(model: Model, name: str) -> Program:
    program = model.programs[name]
    assert isinstance(program, Program)
    return program


Timed = dict[str, tuple[Callable[[], float], Array]]


def _timed(model: Model, programs: dict[str, Program], states: States, watch: Stopwatch) -> Timed:
    """A run over all states (many times) per function, and its results."""
    text = watch("print", one_file, model, programs)
    text += "".join(loop_code(f"{model.name}_{n}", p.inputs, p.outputs, "double") for n, p in programs.items())
    library = watch("compile", compiled, text)
    found: Timed = {}
    for name, program in programs.items():
        given = [np.ascontiguousarray(np.tile(states.known()[p.name], (CALLS, 1))) for p in program.inputs]
        results = np.zeros((len(given[0]), program.outputs[0].size))
        found[name] = (caller(library, f"{model.name}_{name}", given, [results]), results)
    return found


def _at_an_instant(
    model: Model,
    states: States,
    programs: Mapping[str, Program],
    timed: Timed,
    *,
    to_drives: Array,
    exact: Array,
) -> list[Setup]:
    """Rates of the momentum screws three ways; their drives against those of the `exact` rates."""
    count = len(states.q)

    def error_of(rates: Array) -> float:
        return float(np.abs(np.einsum("nij,nj->ni", to_drives, rates[:count] - exact)).max())

    setups = []
    for curve, name in (("Newton-Euler with accelerations", "newton_euler"),
                        ("momentum screws, analytic rates", "momentum_rates")):  # fmt: skip
        run, results = timed[name]
        facts = {"operations": programs[name].operations["total"], "panel": INSTANT}
        setups.append(Setup(f"{INSTANT}, {curve}", name, run, partial(error_of, results), CALLS * count, facts))
    run, _ = timed["momentum_screws"]
    size = programs["momentum_screws"].outputs[0].size
    facts = {"operations": programs["momentum_screws"].operations["total"] + 2 * size, "panel": INSTANT}
    before = momenta_of(model, states.q, states.v)
    for h in STEPS:
        after = momenta_of(model, *neighbour(model, states, h))
        rates = (after - before) / h
        name = f"{INSTANT}, momentum screws, first-order difference (the paper's)"
        setups.append(Setup(name, f"h = {h:g} s", run, partial(error_of, rates), CALLS * count, {**facts, "h": h}))
    return setups


def _over_a_step(model: Model, states: States, programs: Mapping[str, Program], timed: Timed) -> list[Setup]:
    """Mean drives over a step by the momentum at its ends, and by the rates at its start or middle."""
    assert states.t is not None
    count, (nodes, weights) = len(states.q), np.polynomial.legendre.leggauss(8)
    cost = {"impulse form": "momentum_screws", "start": "momentum_rates", "middle": "momentum_rates"}
    curves = {
        "impulse form, eqs. (36)-(38)": "impulse form",
        "differential form, start of the step": "start",
        "differential form, middle of the step": "middle",
    }
    setups = []
    for h in STEPS:
        parts = [smooth_motion(model, states.t + h * (1 + node) / 2) for node in nodes]
        mean = sum(w / 2 * drives_of(model, part) for w, part in zip(weights, parts, strict=True))
        middle, end = smooth_motion(model, states.t + h / 2), smooth_motion(model, states.t + h)
        to_drives = drive_map(model, middle)
        rate = model("momentum_rates", middle.q, middle.v, middle.a)[0][0]
        gained = (momenta_of(model, end.q, end.v) - momenta_of(model, states.q, states.v)) / h
        impulse = drives_of(model, middle) + np.einsum("nij,nj->ni", to_drives, gained - rate)
        found = {"impulse form": impulse, "start": drives_of(model, states), "middle": drives_of(model, middle)}
        for curve, kind in curves.items():
            error = float(np.abs(found[kind] - mean).max())
            name = cost[kind]
            extra = 2 * programs[name].outputs[0].size if kind == "impulse form" else 0
            facts = {"operations": programs[name].operations["total"] + extra, "h": h, "panel": OVER_STEP}
            run = timed[name][0]
            known = partial(float, error)  # the same at every run
            setups.append(Setup(f"{OVER_STEP}, {curve}", f"h = {h:g} s", run, known, CALLS * count, facts))
    return setups


def _operations(model: Model, programs: dict[str, Program]) -> Table:
    kinds = ("add", "mul", "div", "sqrt", "trig", "total")
    rows = [[name, *(str(p.operations[k]) for k in kinds)] for name, p in programs.items()]
    whole = model.programs["inverse_dynamics"]
    rows.append(["inverse_dynamics (body axes, drives included)", *(str(whole.operations[k]) for k in kinds)])
    return ["function", *kinds], rows
