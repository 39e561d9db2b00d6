"""A run of a scene: integrate it, look at it at every output, say what happened.

Scene --prepare--> Model, Plant --initial_state--> q, v --integrate--> History --energy, reactions, errors--> Run
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.effects import Contact, Passed
from symscrew.errors import DescriptionError, expect
from symscrew.functions import REASONS
from symscrew.model import Model
from symscrew.program import Program
from symscrew.results import Columns, JointWrenches
from symscrew.runtime import CompileError, find_compiler
from symscrew.scene import Scene, parameter_values
from symscrew.scene import controller as controller_of
from symscrew.simulation.assembly_mode import AssemblyModes, changed
from symscrew.simulation.initial import initial_state, initial_states, moves
from symscrew.simulation.kept_model import derived_model
from symscrew.simulation.native import NATIVE_METHODS, integrate_natively
from symscrew.simulation.portable import Controller, integrate
from symscrew.simulation.recording import Estimate, History, Instant, State
from symscrew.simulation.run_columns import columns_of, wrenches_along
from symscrew.simulation.run_time_values import mechanism_at_size, mechanism_of
from symscrew.simulation.stability import with_longest_stable_step
from symscrew.simulation.state_programs import Plant, commands, plant
from symscrew.simulation.verdict import estimated, verdict

Progress = Callable[[float], None]
# Of the largest energy: sums over all bodies leave some units in the last place. What is out of balance by less says
# nothing, also where less than that is moved (a pendulum that stands on its head); more than it is looked at.
ENERGY_ROUNDING = 1e-14
ON_NUMPY = "evaluated on NumPy"  # begins the event of a run whose functions no compiler made


@dataclass(frozen=True, repr=False)
class Run:
    """What a run gave: arrays over its n outputs, what it met, and how it ended.

    t (n,), q (n, nq), v (n, nv), u (n, drives), x (n, states; the last is the work of drives and effects where there
    are any), energy (n, 2) kinetic and potential [J], closure_error (n,) largest opening of the loops without units,
    energy_balance (n,) energy - energy at the start - work + what impacts took [J], `losses`: the latter in all by
    the joint's name, `estimate` of its error by another run, `doubts`: what the integrator has no treatment of,
    `verdict`: the status with what was judged, `accurate`: whether that is good, `modes`: names of the assembly mode at
    start and end (`symscrew.simulation.assembly_mode`), reactions (n, 6 joints) or None, `moved`: kinetic and potential
    energy at the end of the step where the motion was fastest, which may lie between two outputs.
    """

    scene: Scene
    model: Model
    t: np.ndarray
    q: np.ndarray
    v: np.ndarray
    u: np.ndarray
    x: np.ndarray
    energy: np.ndarray
    closure_error: np.ndarray
    energy_balance: np.ndarray
    reactions: np.ndarray | None
    crossings: tuple[Crossing, ...]
    events: tuple[str, ...]
    ok: bool
    status: str
    counters: Mapping[str, float] = field(default_factory=dict)
    x_labels: tuple[str, ...] = ()
    backend: str = "c"
    inputs: Mapping[str, np.ndarray] = field(default_factory=dict)
    losses: Mapping[str, float] = field(default_factory=dict)
    estimate: Estimate | None = None
    doubts: tuple[str, ...] = ()
    accurate: bool = True
    verdict: str = ""
    modes: tuple[str, str] = ("", "")
    moved: tuple[float, ...] = ()

    @property
    def mode(self) -> str:
        """Name of the assembly mode that the scene began in and the run stayed on; "" where none was named, or left.

        A motion on which no determinant vanishes keeps its mode; singular ones that are passed are `crossings`.
        """
        return self.scene.initial.mode if self.modes[0] == self.modes[1] and not self.crossings else ""

    def __repr__(self) -> str:
        end = float(self.t[-1]) if len(self.t) else 0.0
        said = self.status if self.accurate else self.verdict.partition(":")[0] or self.status
        return f"<Run {self.scene.name}: {len(self.t)} outputs to t = {end:g} s, {said}>"

    def _repr_html_(self) -> str:
        return self.columns._repr_html_()

    @property
    def columns(self) -> Columns:
        """Columns by name over t: `q.LABEL`, `v.LABEL`, `u.LABEL`, energies, errors; `.pandas()`, `.xarray()`."""
        parts = {"q": self.q, "v": self.v, "u": self.u, "x": self.x, "energy": self.energy}
        parts |= {"closure_error": self.closure_error, "energy_balance": self.energy_balance}
        return columns_of(self.scene.name, self.model, self.t, parts, x_labels=self.x_labels)

    @property
    def wrenches(self) -> JointWrenches:
        """What joints transmit, by the joint's name: `run.wrenches["crank_R"].about_joint().force`.

        Raises:
            DescriptionError: the scene does not record reactions.
        """
        values = np.array(list(parameter_values(self.scene, self.model).values()), dtype=float)
        return wrenches_along(self.model, self.q, self.reactions, values)

    @property
    def unbalanced(self) -> float:
        """Largest energy balance by the largest energy that was moved: kinetic, potential, work or losses."""
        energy = np.concatenate([self.energy, np.array(self.moved[:2]).reshape(-1, 2)])
        moved = np.ptp(energy, axis=0).max(initial=0.0) if len(self.t) else 0.0
        largest = max(float(moved), float(energy[:, 0].max(initial=0.0)), sum(self.losses.values()))
        return float(np.abs(self.energy_balance).max(initial=0.0)) / (largest or 1.0)

    @property
    def energy_error(self) -> float:
        """Largest energy balance by the largest kinetic energy."""
        largest = float(self.energy[:, 0].max(initial=0.0))
        return float(np.abs(self.energy_balance).max(initial=0.0)) / (largest or 1.0)


@dataclass(frozen=True)
class Crossing:
    """A singular configuration that the motion passed: time [s], q, freedoms that open there, the closure's rows."""

    t: float
    q: np.ndarray
    pivot: float
    lost: int
    rows: tuple[str, ...]


def prepare(scene: Scene, *, held: bool = False) -> tuple[Model, Plant]:
    """The model of a scene and its programs.

    `held`: the drives come from outside (a controller in Python) and are held during a step.

    Raises:
        DescriptionError: the effects leave no forward dynamics, or the scene commands what a contact determines.
    """
    model = derived_model(mechanism_at_size(scene), scene.effects)
    if "forward_dynamics" not in model.programs:
        quiet = "with quasi_static drives do not determine accelerations"
        why = next((note for note in model.notes if note in REASONS), quiet)
        raise DescriptionError(f"{scene.name}: nothing to simulate: {why}; inverse dynamics is there all the same")
    contacts = [c for e in scene.effects for c in e.contacts()]
    for contact in contacts:
        if contact.port in scene.inputs:
            raise DescriptionError(f"inputs.{contact.port}: this force follows from its law of contact; leave it out")
    values = np.array(list(parameter_values(scene, model).values()), dtype=float)
    outside = [contact.port for contact in contacts]
    made = controller_of(scene, model, held=held)
    return model, plant(model, made, held=held, parameters=values, outside=outside, watched=True)


def simulate(
    scene: Scene,
    *,
    controller: Controller | None = None,
    backend: str | None = None,
    progress: Progress | None = None,
    prepared: tuple[Model, Plant] | None = None,
) -> Run:
    """The run of a scene.

    Args:
        scene: what to simulate.
        controller: a callable (t [s], q (nq,), v (nv,)) -> u (drives,) [N, N m] in place of the scene's drives, called
            at every evaluation.
        backend: "c" (compiled) or "numpy"; default: "c" where there is a C compiler and the method is one of ours.
        progress: called with the part done, 0 to 1.
        prepared: model and programs of an earlier `prepare(scene)`, to save time.

    Returns:
        The run; `ok` is False where it ended early, with what was computed so far.

    Raises:
        DescriptionError: the scene's start or controller cannot work.
        ValueError: an unknown backend.
    """
    expect(scene, Scene)
    model, programs = prepared or prepare(scene, held=controller is not None)
    q, v = initial_state(scene, model, programs.parameters)
    x = initial_states(scene, model, q, v)
    x = np.concatenate([x, np.zeros(len(programs.x_labels) - len(x))])
    contacts = [c for e in scene.effects for c in e.contacts()]
    history = integrated(
        scene, programs, (q, v, x), contacts=contacts, controller=controller, backend=backend, progress=progress
    )
    if controller is None:
        history = with_longest_stable_step(scene, programs, history, (q, v, x))
    history = replace(history, events=(*told_at_start(scene, model, q, v), *history.events))
    return judged(_observed(scene, model, programs, history))


def judged(run: Run) -> Run:
    """The run with its verdict: a run that stopped is not accurate, one that came to its end is looked at."""
    if not run.ok:
        return replace(run, accurate=False, verdict=run.status)
    opening = float(run.closure_error.max(initial=0.0))
    unbalanced = run.unbalanced
    if unbalanced > run.scene.integrator.tolerance and _still(run):
        unbalanced = 0.0
    accurate, text = verdict(run.scene, run.estimate or Estimate(), opening, unbalanced, doubts=run.doubts)
    return replace(run, accurate=accurate, verdict=text)


def _still(run: Run) -> bool:
    """Whether the energy is out of balance by less than rates as small as the tolerance hold, or than the rounding of
    the energies themselves: of a mechanism that hardly moves, a part of the energies that were moved says nothing."""
    model, balance = run.model, float(np.abs(run.energy_balance).max(initial=0.0))
    if balance <= ENERGY_ROUNDING * float(np.abs(run.energy).max(initial=0.0)):
        return True
    if run.scene.integrator.step is not None or not len(run.t) or not balance > 0.0:
        return False
    units = np.array([model.system.length if c.kind == "length" else 1.0 for c in model.system.tree.v])
    program = model.programs["energy"]
    assert isinstance(program, Program)
    states = sum(port.size for port in program.inputs if port.name == "x")
    known = {name: values[:1] for name, values in run.inputs.items()}
    known |= {"t": run.t[:1, None], "q": run.q[:1], "x": run.x[:1, :states]}
    known["p"] = np.array([list(parameter_values(run.scene, model).values())], dtype=float)
    known["v"] = run.scene.integrator.tolerance * units[None]
    return balance < float(evaluated(model, "energy", known)["energy"][0, 0])


def integrated(
    scene: Scene,
    programs: Plant,
    start: State,
    *,
    contacts: Sequence[Contact],
    controller: Controller | None = None,
    backend: str | None = None,
    progress: Progress | None = None,
) -> History:
    """The samples of a scene from a start on its loops; other arguments as of `simulate`."""
    own = scene.integrator.method in NATIVE_METHODS and controller is None
    chosen = backend or ("c" if find_compiler() else "numpy")
    if chosen not in ("c", "numpy"):
        raise ValueError(f"expected the backend 'c' or 'numpy', got {backend!r}")

    def further(*, compiled: bool) -> History:
        def run(other: Scene, progress: Progress | None = None) -> History:
            return integrate(
                other, programs, start, contacts=contacts, controller=controller, compiled=compiled, progress=progress
            )

        found = run(scene, progress)
        return replace(found, estimate=estimated(scene, programs.system, found, run))

    try:
        if chosen == "c" and own:
            return integrate_natively(scene, programs, start, progress)
        return further(compiled=chosen == "c")
    except CompileError as error:
        if backend is not None:
            raise
        history = further(compiled=False)
        notice = f"{ON_NUMPY}, some hundred times slower than compiled: {one_line(error)}"
        return replace(history, events=(notice, *history.events))


def one_line(error: Exception) -> str:
    """The first line of what a compiler said."""
    return str(error).partition("\n")[0].rstrip(":")


def told_at_start(scene: Scene, model: Model, q: np.ndarray, v: np.ndarray) -> tuple[str, ...]:
    """Events of a run before it begins: what `hold` moved, what a fixed step becomes."""
    return (*moves(scene, model, q, v), *_of_steps(scene))


def _of_steps(scene: Scene) -> tuple[str, ...]:
    """What a fixed step becomes so that outputs fall on ends of steps: an event where it is another one."""
    step, between = scene.integrator.step, 1.0 / scene.rate
    if step is None or step <= between * (1 + 1e-9):
        return ()
    return (
        f"the step of {step:g} s is longer than the {between:g} s between two outputs: steps of {between:g} s are "
        "taken, from output to output; a lower rate leaves longer ones",
    )


def evaluated(model: Model, name: str, known: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Outputs of a function of the model at arrays (n, size) of its inputs, by name."""
    program = model.programs[name]
    assert isinstance(program, Program)
    results, _ = model(name, *[known[port.name] for port in program.inputs])
    return {port.name: result for port, result in zip(program.outputs, results, strict=True)}


def _observed(scene: Scene, model: Model, programs: Plant, history: History) -> Run:
    (run,) = observed(model, [(scene, programs, history)])
    return run


def observed(model: Model, of: Sequence[tuple[Scene, Plant, History]]) -> list[Run]:
    """The runs of these samples; functions are evaluated at the samples of all runs at once.

    `of`: scene, programs and samples of every run of one scene; they differ in starts and parameters.
    """
    if not of:
        return []
    commanded, seen = _evaluated_together(model, of)
    fastest = _moved_together(model, of)
    ends = np.cumsum([0, *(len(history.t) for _, _, history in of)])
    modes: dict[bytes, AssemblyModes] = {}
    runs = []
    for k, (scene, programs, history) in enumerate(of):
        key = programs.parameters.tobytes()
        if key not in modes:
            modes[key] = AssemblyModes(model, programs.parameters)
        own = slice(ends[k], ends[k + 1])
        inputs, looks = ({name: array[own] for name, array in arrays.items()} for arrays in (commanded, seen))
        run = _run(scene, programs, history, inputs, looks=looks, named=modes[key])
        runs.append(replace(run, moved=fastest.get(k, ())))
    return runs


Arrays = dict[str, np.ndarray]


def _evaluated_together(model: Model, of: Sequence[tuple[Scene, Plant, History]]) -> tuple[Arrays, Arrays]:
    """What the scene commands, and energies, openings and reactions, by name, run behind run (n, size)."""
    (scene, programs, _), histories = of[0], [history for _, _, history in of]
    t, q, v, x = (np.concatenate([getattr(history, name) for history in histories]) for name in "tqvx")
    n = len(t)
    effect_states = sum(p.size for p in programs.forward.inputs if p.name == "x")
    values = [np.repeat(plant.parameters[None], len(history.t), 0) for _, plant, history in of]
    known = {"t": t[:, None], "q": q, "v": v, "x": x[:, :effect_states], "p": np.concatenate(values)}
    tables = np.stack([table(t) for table in scene.tables.values()], 1) if scene.tables else np.zeros((n, 0))
    held = [h.u if h.u is not None else np.zeros((len(h.t), 0)) for h in histories]
    tables = np.concatenate([tables, np.concatenate([history.forces for history in histories])], 1)
    found = commands(programs, {**known, "x": x, "u": np.concatenate(held), "s": tables})
    known |= found
    seen = {"energy": evaluated(model, "energy", known)["energy"], "closure": np.zeros(n)}
    if programs.closure is not None:
        residual = evaluated(model, "closure", known)["residual"]
        seen["closure"] = np.abs(residual * programs.rows).max(axis=1, initial=0.0)
    looked = _looked(model)
    if scene.reactions or looked:
        seen["reactions"] = evaluated(model, "forward_dynamics_reactions", known)["reactions"]
    if looked:
        seen["places"] = evaluated(model, "forward_kinematics", known)["positions"]
    return found, seen


def _moved_together(model: Model, of: Sequence[tuple[Scene, Plant, History]]) -> dict[int, tuple[float, ...]]:
    """Number of a run -> kinetic and potential energy [J] where it was fastest, if its energy is judged."""
    at = {
        k: (scene, programs, _one_sample(history, history.fastest))
        for k, (scene, programs, history) in enumerate(of)
        if history.fastest is not None and scene.integrator.step is None
    }
    if not at:
        return {}
    _, seen = _evaluated_together(model, list(at.values()))
    return dict(zip(at, map(tuple, seen["energy"].tolist()), strict=True))


def _one_sample(history: History, at: Instant) -> History:
    """The history with that state alone; what energies do not depend on is zero."""
    u, forces = (None if a is None else np.zeros_like(a[:1]) for a in (history.u, history.contact_forces))
    return replace(history, t=np.array([at.t]), q=at.q[None], v=at.v[None], x=at.x[None], u=u, contact_forces=forces)


def _looked(model: Model) -> bool:
    """Whether an effect says something of the motion that was computed with it."""
    return any(effect.looks_back for effect in model.effects)


def _run(
    scene: Scene, programs: Plant, history: History, inputs: Arrays, *, looks: Arrays, named: AssemblyModes
) -> Run:
    """The run of these samples, with what was evaluated at them."""
    model, n, energy = programs.model, len(history.t), looks["energy"]
    work = history.x[:, -1] if programs.works else np.zeros(n)
    taken = np.array([sum(loss for when, _, loss in history.losses if 0 < when < t) for t in history.t])
    balance = energy.sum(axis=1) - energy[:1].sum(axis=1) - work + taken
    losses: dict[str, float] = {}
    for _, name, loss in history.losses:
        losses[name] = losses.get(name, 0.0) + float(loss)
    modes = (named.name(history.q[0]), named.name(history.q[-1])) if n else ("", "")
    labels = [row.label for cut in model.system.cuts for row in cut.rows]
    crossings = tuple(
        Crossing(c.t, c.q, c.pivot / programs.pivot, c.lost, tuple(labels[k] for k in c.rows))
        for c in history.crossings
    )
    u = inputs.pop("u", np.zeros((n, 0)))
    events = (*history.events, *changed(*modes), *_told(scene, model, looks))
    return Run(
        scene, model, history.t, history.q, history.v, u, history.x, energy, looks["closure"], balance,
        looks.get("reactions") if scene.reactions else None, crossings, events, history.ok, history.status,
        history.counters, programs.x_labels, history.backend, inputs, losses, history.estimate, history.doubts,
        modes=modes,
    )  # fmt: skip


def _told(scene: Scene, model: Model, looks: Arrays) -> tuple[str, ...]:
    """What effects say of the motion that was computed with them: what they leave out, where it counts."""
    n = len(looks["energy"])
    if not _looked(model) or n == 0:
        return ()
    mechanism = mechanism_of(scene, model)
    places, forces = looks["places"].reshape(n, -1, 3), looks["reactions"].reshape(n, -1, 6)[:, :, :3]
    passed = Passed(
        mechanism,
        {name: places[:, k] for k, name in enumerate(mechanism.points)},
        {name: forces[:, k] for k, name in enumerate(mechanism.joints)},
    )
    return tuple(text for effect in model.effects if (text := effect.seen(passed)))
