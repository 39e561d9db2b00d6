"""The bill of effects: what each effect of a scene costs and what it changes.

Every effect is left out once, all others staying: the operations, states and time that go with it, and by how
much drives and accelerations change along the scene's own motion. Along the motion means at the same q, v and
inputs: inverse dynamics for the drives at the same accelerations, forward dynamics for the accelerations under
the same drives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from symscrew.description import Mechanism, exact
from symscrew.display import Progress
from symscrew.effects import Acting, Effect, simplifications, type_name
from symscrew.errors import DescriptionError
from symscrew.kinematics import System
from symscrew.model import Model, derive
from symscrew.runtime import CompiledModel, find_compiler, load
from symscrew.studies.timing import nanoseconds_per_state

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from symscrew.scene import Scene

RESULTS = {"inverse_dynamics": "drives", "forward_dynamics": "accelerations"}
BILLED_FUNCTIONS = tuple(RESULTS)
BATCH = 256  # states per call: Python's share vanishes
UNTIMED = "nothing is timed: there is no C compiler here (apt install gcc)"
ROUNDS, WARM = 301, 10  # pairs of calls that count, with and without an effect in turns, and before them not
ZERO = 1e-6  # a result below this part of what leaving an effect out makes of it vanishes
Arrays = Mapping[str, np.ndarray]


@dataclass(frozen=True)
class Item:
    """What one effect costs and changes.

    `operations` and `nanoseconds` per function: what inverse and forward dynamics have more with the effect than
    without it (less, if it simplifies); nanoseconds per state of a batch, reading its inputs included, None where
    nothing was timed. `states`: its own.
    `alone`: operations of the effect's own program, which is the most that it may add, see `alone`; 0 if it simplifies.
    `change`: per result ("drives", "accelerations") the root mean square over the motion of the difference that
    leaving it out makes, divided by that of the result itself (lengths divided by the characteristic length), or
    by the largest such difference where the result itself vanishes, as drives do in a free motion.
    """

    effect: str
    operations: Mapping[str, int]
    states: int
    nanoseconds: Mapping[str, float | None]
    change: Mapping[str, float]
    alone: int = 0


@dataclass(frozen=True)
class Bill:
    """The items of a scene, and its whole cost: operations and nanoseconds of the functions with all effects.

    `notes` are what the effects say of themselves on this mechanism, and why nothing was timed.
    """

    name: str
    mechanism: str
    motion: str
    items: tuple[Item, ...]
    operations: Mapping[str, int]
    nanoseconds: Mapping[str, float | None]
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        counted = ", ".join(f"{name} {count}" for name, count in self.operations.items())
        return f"Bill({self.name}: {len(self.items)} effects on {self.mechanism}, {counted} operations)"

    def values(self) -> dict[str, Any]:
        """Everything as numbers and texts, for JSON."""
        return asdict(self)


def effect_labels(effects: Sequence[Effect]) -> list[str]:
    """A name per effect for tables: its type and what it acts on, numbered where two are alike."""
    parts = ("joint", "point", "body", "start", "end")
    labels = []
    for effect in effects:
        on = [str(getattr(effect, part)) for part in parts if getattr(effect, part, "")]
        labels.append(" ".join([type_name(effect), *on]))
    before = [labels[:k].count(label) for k, label in enumerate(labels)]
    return [f"{label} ({n + 1})" if n else label for label, n in zip(labels, before, strict=True)]


def bill(
    mechanism: Mechanism,
    effects: Sequence[Effect],
    *,
    name: str = "",
    motion: Arrays | None = None,
    motion_text: str = "sample states near the reference configuration",
    timed: bool = True,
    progress: Progress | None = None,
) -> Bill:
    """The bill of some effects on a mechanism.

    Args:
        mechanism: the mechanism.
        effects: all that act.
        name: of the scene.
        motion: arrays (states, entries) of q, v, u, and of x, t, p and the effects' inputs where there are any; by
            default the sample states of the model, with accelerations of their own.
        motion_text: where the motion comes from.
        timed: whether to compile and time; without a C compiler nothing is timed.
        progress: for messages.

    Raises:
        DescriptionError: effects that do not fit the mechanism, or a motion whose states cannot be evaluated.
    """
    progress = progress or Progress(quiet=True)
    with progress.step(f"derive {mechanism.name} with all effects"):
        whole = derive(mechanism, effects)
    known = _with_results(whole, dict(motion) if motion is not None else _samples(whole))
    compiler = find_compiler()
    clock = _Clock(whole, known) if timed and compiler else None
    full = _operations(whole)
    items: list[Item] = []
    labels, sizes = effect_labels(effects), _sizes(whole, known)
    differences: list[dict[str, float]] = []
    for k in progress.bar(range(len(effects)), "effects"):
        rest = [e for i, e in enumerate(effects) if i != k]
        model = derive(mechanism, rest)
        less = _operations(model)
        times = clock.added(model, known) if clock else {}
        items.append(
            Item(
                labels[k],
                {f: full[f] - less[f] for f in BILLED_FUNCTIONS if f in full and f in less},
                len(_states(whole)) - len(_states(model)),
                {f: times.get(f) for f in BILLED_FUNCTIONS if f in full and f in less},
                {},
                alone(whole, k, model),
            )
        )
        differences.append(_differences(whole, model, known))
    for result, size in sizes.items():
        largest = max((d[result] for d in differences if result in d), default=0.0)
        sizes[result] = largest if size < ZERO * largest else size
    items = [replace(item, change=_shares(d, sizes)) for item, d in zip(items, differences, strict=True)]
    own = clock.own() if clock else {}
    notes = [note for effect in whole.effects for note in effect.notes]
    notes += [UNTIMED] if timed and not compiler else []
    measured = {f: own.get(f) for f in full}
    return Bill(name or mechanism.name, mechanism.name, motion_text, tuple(items), full, measured, tuple(notes))


def alone(whole: Model, k: int, rest: Model, *, reactions: bool = False) -> int:
    """Operations that effect k of a model may add at most; `rest` is the model without it.

    To drives and accelerations, or to the `reactions`: to these as many as the reactions to the effect alone take.

    Drives and accelerations are linear in the wrenches that act. So no more is needed than the effect's own program
    standing alone: its force screws and their projection on what the mechanism can do, without the inertial forces
    of its bodies. Of an effect that makes bodies heavier: the same bodies without their own masses, and its mass
    matrix with its projection. Where an effect depends on the reactions: these as well, with what they belong to, as
    many times as they are taken in turn.
    """
    effect, mechanism = whole.effects[k], whole.mechanism
    if effect.simplifies:
        return 0
    if "inertia" in effect.depends_on:
        bodies = {name: replace(body, mass=None, inertia=None) for name, body in mechanism.bodies.items()}
        light = replace(mechanism, bodies=bodies)  # a drag acts at a centre of mass, also of what has none
        program = derive(light, whole.effects)
        count, free = len(program.system.tree.v), len(program.independent) or len(program.system.tree.v)
        moved = program.programs["mass_matrix"].operations["total"] + 2 * free * count * count
        own = _reactions(program) if reactions else _largest(program) + moved
        if "reactions" not in effect.depends_on:
            return own
    else:
        still = next(one for one in simplifications().values() if not one.keeps_motion)
        program = derive(mechanism, (still, effect))
        own = _reactions(program) if reactions else _largest(program)
    acting = Acting(whole.system, whole.effects)
    if "reactions" in effect.depends_on:
        return own + acting.passes * (_reactions(rest) + max(_operations(rest).values(), default=0))
    return own + acting.passes * (_reactions(program) + own) if acting.needs_reactions else own


def _reactions(model: Model) -> int:
    return model.programs["joint_reactions"].operations["total"]


def _largest(model: Model) -> int:
    """Operations of the drives, rates of the tree included where the independent ones are given.

    Without drives: of the forces of the tree and their projection on its motion.
    """
    drives = [model.programs[f] for f in ("inverse_dynamics", "inverse_dynamics_independent") if f in model.programs]
    if drives:
        return max(program.operations["total"] for program in drives)
    free = len(model.independent) or len(model.system.tree.v)
    return model.programs["bias"].operations["total"] + 2 * free * len(model.system.tree.v)


def scene_bill(scene: Scene, *, timed: bool = True, progress: Progress | None = None) -> Bill:
    """The bill of a scene, along the motion that simulating it gives.

    Raises:
        DescriptionError: the scene names no effects.
    """
    from symscrew.simulation import simulate

    progress = progress or Progress(quiet=True)
    if not scene.effects:
        raise DescriptionError(f"{scene.name}: the scene names no effects, so there is no bill; add [[effects]]")
    if any(effect.simplifies for effect in scene.effects):
        model = derive(scene.mechanism, scene.effects)
        if "forward_dynamics" not in model.programs:
            return bill(scene.mechanism, scene.effects, name=scene.name, timed=timed, progress=progress)
    with progress.step(f"simulate {scene.name}"):
        run = simulate(scene)
    known = {"q": run.q, "v": run.v, "u": run.u, "t": run.t[:, None], **run.inputs}
    states = _states(run.model)
    known["x"] = run.x[:, : len(states)]
    values = scene.mechanism.values({name: exact(value) for name, value in scene.parameters.items()})
    chosen = [float(values[p.name]) for p in scene.mechanism.parameters.values() if p.run_time]
    known["p"] = np.repeat(np.array(chosen, dtype=float)[None, :], len(run.t), 0)
    text = f"simulated motion of {run.t[-1]:g} s, {len(run.t)} outputs" + ("" if run.ok else f" ({run.status})")
    return bill(
        scene.mechanism, scene.effects, name=scene.name, motion=known, motion_text=text, timed=timed, progress=progress
    )


# -- along the motion -----------------------------------------------------------------------------------------------


def _states(model: Model) -> list[str]:
    return [s.name for s in Acting(model.system, model.effects).states]


def _operations(model: Model) -> dict[str, int]:
    return {f: model.programs[f].operations["total"] for f in BILLED_FUNCTIONS if f in model.programs}


def _samples(model: Model) -> dict[str, np.ndarray]:
    """The sample states with all inputs that any of the functions has."""
    known: dict[str, np.ndarray] = {}
    for function in BILLED_FUNCTIONS:
        if function in model.programs:
            ports = [p.name for p in model.programs[function].inputs]
            known |= dict(zip(ports, model.test_inputs[function], strict=True))
    return known


def _with_results(model: Model, known: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The motion with accelerations, where forward dynamics gives them and none are given."""
    if "a" not in known and "forward_dynamics" in model.programs:
        known["a"] = _evaluated(model, "forward_dynamics", known)
    if "a" not in known:
        known["a"] = np.zeros_like(known["v"])
    return known


def _evaluated(model: Model, function: str, known: Arrays, labels: Sequence[str] | None = None) -> np.ndarray:
    """The first output of a function along the motion; `labels` are those of the states in `known["x"]`."""
    given = []
    for port in model.programs[function].inputs:
        array = known[port.name] if port.name in known else np.zeros((len(known["q"]), port.size))
        if port.name == "x" and labels is not None:
            array = array[:, [labels.index(label) for label in port.labels]]
        given.append(array)
    return model(function, *given)[0][0]


def _sizes(whole: Model, known: Arrays) -> dict[str, float]:
    """Root mean square of drives and accelerations over the motion."""
    present = [(f, name) for f, name in RESULTS.items() if f in whole.programs]
    return {name: _size(_evaluated(whole, f, known), _scales(whole.system, f)) for f, name in present}


def _differences(whole: Model, model: Model, known: Arrays) -> dict[str, float]:
    """Root mean square of what drives and accelerations change by without an effect."""
    labels = _states(whole)
    result = {}
    for function, name in RESULTS.items():
        if function in whole.programs and function in model.programs:
            less = _evaluated(model, function, known, labels)
            result[name] = _size(_evaluated(whole, function, known) - less, _scales(whole.system, function))
    return result


def _size(values: np.ndarray, scales: np.ndarray) -> float:
    good = np.isfinite(values).all(axis=1)
    return float(np.sqrt(np.mean((values[good] / scales) ** 2))) if good.any() else float("nan")


def _shares(differences: Mapping[str, float], sizes: Mapping[str, float]) -> dict[str, float]:
    return {name: d / sizes[name] if d else 0.0 for name, d in differences.items()}


def _scales(system: System, function: str) -> np.ndarray:
    """What divides the entries of a result so that lengths and angles, forces and torques compare."""
    if function == "forward_dynamics":
        return system.scales
    slides = [Acting(system, ()).slides(joint, k) for joint, k in system.drives]
    return np.array([1.0 if s else system.length for s in slides])


# -- time ---------------------------------------------------------------------------------------------


class _Clock:
    """Times compiled functions side by side: one with all effects, others without one."""

    def __init__(self, whole: Model, known: Arrays) -> None:
        self.whole, self.labels = whole, _states(whole)
        self.known = {k: np.resize(x, (BATCH, x.shape[1])) for k, x in known.items()}
        self.compiled = _compiled(whole)
        self.samples: dict[str, list[float]] = {f: [] for f in self.compiled.functions}

    def added(self, model: Model, known: Arrays) -> dict[str, float]:
        """Median nanoseconds per evaluation that the whole takes longer than a model without an effect."""
        other = _compiled(model)
        result = {}
        for function in self.compiled.functions:
            if function not in other.functions:
                continue
            with_it, without = self._measure(self.compiled, function), self._measure(other, function)
            pairs = []
            for k in range(ROUNDS + WARM):
                first, second = (with_it, without) if k % 2 else (without, with_it)
                a, b = first(), second()
                if k >= WARM:
                    pairs.append((a, b) if k % 2 else (b, a))
            self.samples[function] += [a for a, _ in pairs]
            result[function] = float(np.median([a - b for a, b in pairs]))
        return result

    def own(self) -> dict[str, float]:
        """Median nanoseconds per evaluation with all effects."""
        return {f: float(np.median(s)) for f, s in self.samples.items() if s}

    def _measure(self, compiled: CompiledModel, function: str) -> Callable[[], float]:
        made = compiled[function]
        inputs = {}
        for port in made.inputs:
            array = self.known.get(port.name, np.zeros((BATCH, port.size)))
            if port.name == "x":
                array = array[:, [self.labels.index(label) for label in port.labels]]
            inputs[port.name] = array
        return nanoseconds_per_state(made, inputs)


def _compiled(model: Model) -> CompiledModel:
    chosen = {f: model.programs[f] for f in BILLED_FUNCTIONS if f in model.programs}
    inputs = {f: model.test_inputs[f] for f in chosen}
    return load(replace(model, programs=chosen, test_inputs=inputs), backend="c")


# -- output -------------------------------------------------------------------------------------------


def bill_table(found: Bill) -> tuple[list[str], list[list[str]]]:
    """Header and rows of the bill."""
    header = [
        "effect",
        "operations inverse",
        "forward",
        "at most",
        "states",
        "ns inverse",
        "ns forward",
        "drives",
        "accelerations",
    ]
    rows = [
        [
            item.effect,
            *(_signed(item.operations.get(f)) for f in BILLED_FUNCTIONS),
            f"+{item.alone}",
            str(item.states),
            *(_signed(item.nanoseconds.get(f), 1) for f in BILLED_FUNCTIONS),
            *(_share(item.change, name) for name in ("drives", "accelerations")),
        ]
        for item in found.items
    ]
    totals = [str(found.operations[f]) if f in found.operations else "-" for f in BILLED_FUNCTIONS]
    times = [found.nanoseconds.get(f) for f in BILLED_FUNCTIONS]
    shown = [f"{t:.0f}" if t is not None else "-" for t in times]
    rows.append(["all of it", *totals, "", str(sum(i.states for i in found.items)), *shown, "", ""])
    return header, rows


def _signed(value: float | None, digits: int = 0) -> str:
    return "-" if value is None else f"{value:+.{digits}f}"


def _share(change: Mapping[str, float], name: str) -> str:
    return f"{100 * change[name]:.3g} %" if name in change else "-"


def bill_figure(found: Bill) -> Figure:
    """Bars per effect: operations and nanoseconds that it adds, and what leaving it out changes."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import NullFormatter

    from symscrew.display import COLOURS, curve_style

    names = [item.effect for item in found.items]
    places = np.arange(len(names))
    panels: list[tuple[str, list[tuple[str, list[float]]], bool]] = [
        (
            "added operations",
            [(f.replace("_", " "), [i.operations.get(f, 0) for i in found.items]) for f in BILLED_FUNCTIONS],
            False,
        )
    ]
    if any(v is not None for i in found.items for v in i.nanoseconds.values()):
        times = [(f.replace("_", " "), [i.nanoseconds.get(f) or 0.0 for i in found.items]) for f in BILLED_FUNCTIONS]
        panels.append(("added time  [ns]", times, False))
    kinds = [(n, [100 * i.change.get(n, 0.0) for i in found.items]) for n in ("drives", "accelerations")]
    panels.append(("change without it  [%]", kinds, True))
    with curve_style():
        drawn = Figure(figsize=(2.3 + 2.1 * len(panels), 0.9 + 0.36 * len(names)), layout="constrained")
        axes = drawn.subplots(1, len(panels), sharey=True, squeeze=False)[0]
        for axis, (title, bars, logarithmic) in zip(axes, panels, strict=True):
            for k, (name, values) in enumerate(bars):
                axis.barh(places + (0.2 if k else -0.2), values, 0.36, color=COLOURS[k], label=name)
            axis.set_xlabel(title)
            axis.grid(visible=False, axis="y")
            shown = [v for _, values in bars for v in values if np.isfinite(v) and v > 0]
            if logarithmic and shown:
                axis.set_xscale("log")
                axis.set_xlim(
                    10.0 ** np.floor(np.log10(min(shown)) - 0.05), 10.0 ** np.ceil(np.log10(max(shown)) + 0.05)
                )
                axis.xaxis.set_minor_formatter(NullFormatter())
            axis.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0))
        axes[0].set_yticks(places, names)
        axes[0].invert_yaxis()
    return drawn
