"""What a motion needs: joints, rates, drives, powers, reactions and margins over time, judged by another method.

motion --following--> q, v, a --generated functions--> everything over time --Newton-Euler--> verdict
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from symscrew import notebook
from symscrew.description import Mechanism
from symscrew.display import Progress
from symscrew.effects import Effect, ExternalWrench, Gravity, given_effects
from symscrew.errors import DescriptionError, did_you_mean, expect
from symscrew.functions import WRENCH_LABELS
from symscrew.model import Model, derive
from symscrew.program import Program
from symscrew.reference import newton_euler
from symscrew.results import Columns, JointWrenches
from symscrew.runtime import CompiledModel, load
from symscrew.studies.given_motion.following import Followed, follow
from symscrew.studies.given_motion.wanted_motion import DEFAULT_RATE, WantedMotion, load_motion, motion_of
from symscrew.studies.platform_motion import Motion, body_states

Array = np.ndarray
USED = (
    *("acceleration", "assemble", "body_poses", "body_twist_rates", "body_twists", "close_position", "closure"),
    *("constraint_margin", "drive_rates", "actuation_margins", "joint_displacements", "joint_points", "joint_rates"),
    *("joint_reactions", "limb_margins", "null_space", "platform_jacobian"),
)
"""The functions that a study calls: only these are compiled."""
MARGINS = {"limb_margins": "limb", "constraint_margin": "constraint", "actuation_margins": "actuation"}
REST = 1e-3  # of the reactions: a drive that carries less is held against that
INSIDE = 1e-9  # of the largest: internal loads of which a state has fewer are exact zeros
AGREED = 1e-8
"""Largest difference of drives and reactions between momentum screws and Newton-Euler, by the largest of each: rounding
leaves 1e-12 in well-posed states and grows with their condition; a term that one of them lacks leaves far more."""
UNKNOWN = 0.5
"""Of the largest acceleration: where two polynomials through samples differ by more, even its sign is not known."""


@dataclass(frozen=True, repr=False)
class DriveStudy:
    """A motion and what it needs: t (n,) [s], q (n, nq), v, a (n, nv), u (n, drives), reactions (n, 6, joints).

    `displacements`, `rates` (n, freedoms) of all joints with their `labels` and `units`; `drive_rates` (n, drives);
    `margins`: by name (n,). `difference`: of drives and reactions from those of Newton-Euler, None where these do not
    know an effect; `followed`: how well the motion was followed; `wanted`: what was asked for.
    """

    model: Model
    wanted: WantedMotion
    followed: Followed
    u: Array
    wrench_table: Array
    displacements: Array
    rates: Array
    drive_rates: Array
    margins: Mapping[str, Array]
    points: Array
    poses: Array
    difference: float | None
    labels: Mapping[str, tuple[str, ...]]
    units: Mapping[str, tuple[str, ...]]

    def __repr__(self) -> str:
        largest = f", drives up to {np.abs(self.u).max():.6g}" if self.u.size else ""
        return f"DriveStudy({self.model.name}: {len(self.t)} states to {self.t[-1]:g} s{largest}, {self.status})"

    @property
    def t(self) -> Array:
        """Times (n,) [s]."""
        return self.wanted.t

    @property
    def q(self) -> Array:
        """Configurations (n, nq)."""
        return self.followed.q

    @property
    def v(self) -> Array:
        """Rates (n, nv)."""
        return self.followed.v

    @property
    def a(self) -> Array:
        """Accelerations (n, nv)."""
        return self.followed.a

    @property
    def reactions(self) -> Array:
        """(n, 6 joints), the columns of the joints one after another, as files and the viewer take them."""
        flat: Array = np.swapaxes(self.wrench_table, 1, 2).reshape(len(self.t), -1)
        return flat

    @property
    def ok(self) -> bool:
        """Whether another method, where there is one, gave the same, for accelerations that are known."""
        return self.agree and self.wanted.uncertain <= UNKNOWN

    @property
    def agree(self) -> bool:
        """Whether another method, where there is one, gave the same."""
        return self.difference is None or self.difference <= AGREED

    @property
    def status(self) -> str:
        """The verdict in a sentence."""
        if self.wanted.uncertain > UNKNOWN:
            return "THE SAMPLES DO NOT TELL ACCELERATIONS: smooth them, or take them more often and evenly"
        if self.difference is None:
            return "not compared with another method: it does not know all of these effects"
        word = "agree" if self.agree else "DO NOT AGREE"
        return f"momentum screws and Newton-Euler {word}: {self.difference:.1e}"

    @property
    def powers(self) -> Array:
        """Power of every drive (n, drives) [W], positive where it drives."""
        power: Array = self.u * self.drive_rates
        return power

    @cached_property
    def wrenches(self) -> JointWrenches:
        """What joints transmit, by the joint's name."""
        return JointWrenches(self.model.mechanism, reactions=self.wrench_table, points=self.points, poses=self.poses)

    @cached_property
    def columns(self) -> Columns:
        """Everything by name: `joint.LABEL`, `rate.LABEL`, `u.LABEL`, `power.LABEL`, `reactions.JOINT.fx`, ..."""
        found: dict[str, Array] = {}
        units: dict[str, str] = {}
        tree = self.model.system.tree
        groups: list[tuple[str, Sequence[str], Sequence[str], Array]] = [
            ("q", [c.label for c in tree.q], [c.unit for c in tree.q], self.q),
            ("v", [c.label for c in tree.v], [c.unit for c in tree.v], self.v),
            ("a", [c.label for c in tree.v], [f"{c.unit}^2" for c in tree.v], self.a),
            ("joint", self.labels["joint"], self.units["joint"], self.displacements),
            ("rate", self.labels["joint"], self.units["rate"], self.rates),
            ("u", self.labels["u"], self.units["u"], self.u),
            ("power", self.labels["u"], ["W"] * len(self.labels["u"]), self.powers),
        ]
        joints = [f"{j}.{c}" for j in self.model.mechanism.joints for c in WRENCH_LABELS]
        wrench_units = [unit for _ in self.model.mechanism.joints for unit in (*("N",) * 3, *("N m",) * 3)]
        groups.append(("reactions", joints, wrench_units, self.reactions))
        for prefix, labels, of, values in groups:
            for k, (label, unit) in enumerate(zip(labels, of, strict=True)):
                found[f"{prefix}.{label}"], units[f"{prefix}.{label}"] = values[:, k], unit
        for name, values in self.margins.items():
            found[f"margins.{name}"], units[f"margins.{name}"] = values, "1"
        return Columns(self.model.name, self.t, found, units)

    def _repr_html_(self) -> str:
        rows = [
            (label, unit, f"{np.abs(self.u[:, k]).max():.6g}", f"{np.abs(self.drive_rates[:, k]).max():.6g}",
             f"{np.abs(self.powers[:, k]).max():.6g}")
            for k, (label, unit) in enumerate(zip(self.labels["u"], self.units["u"], strict=True))
        ]  # fmt: skip
        return notebook.table(repr(self), ("drive", "unit", "largest", "largest rate", "largest power [W]"), rows)


def drives(
    mechanism: Mechanism,
    motion: WantedMotion | str | Path | Mapping[str, str],
    effects: Sequence[Effect] = (Gravity(),),
    *,
    duration: float = 0.0,
    rate: float = DEFAULT_RATE,
    backend: str | None = None,
    progress: Progress | None = None,
) -> DriveStudy:
    """What a motion needs of a mechanism's drives and joints.

    Args:
        mechanism: what moves.
        motion: how: a file (.toml, .csv, .npz), or expressions in t by name: {"platform.z": "0.1*sin(t)"}.
        effects: what acts besides the motion's own loads.
        duration: of a motion by expressions [s].
        rate: its samples per second.
        backend: as of `symscrew.load`.
        progress: for messages.

    Returns:
        Tables and wrenches over time; `ok` where Newton-Euler gives the same.

    Raises:
        DescriptionError: a motion that the mechanism cannot make, or names that it does not have.
        EvaluationError: a configuration in which a function fails.
    """
    expect(mechanism, Mechanism)
    shown = progress or Progress(quiet=True)
    if isinstance(motion, WantedMotion):
        wanted = motion
    elif isinstance(motion, Mapping):
        wanted = motion_of(motion, mechanism, duration=duration, rate=rate)
    else:
        wanted = load_motion(motion, mechanism)
    for point in wanted.loads:
        if point not in mechanism.points:
            raise DescriptionError(
                f"loads: no point {point!r} in {mechanism.name}; {did_you_mean(point, mechanism.points)}"
            )
    acting = (*given_effects(effects), *(ExternalWrench(point) for point in wanted.loads))
    with shown.step(f"derive {mechanism.name}"):
        model = derive(mechanism, acting)
    if "joint_reactions" not in model.programs:
        raise DescriptionError(f"{mechanism.name}: expected a mechanism with masses, whose drives can be computed")
    _check_inputs(model, wanted)
    with shown.step("print and compile its functions"):
        functions = load(model.only(USED), backend=backend)
    with shown.step(f"follow {len(wanted.t)} states"):
        followed = follow(model, functions, wanted, steps=lambda s: shown.bar(s, "  motion"))
    with shown.step("drives, reactions, margins"):
        return _study(model, functions, wanted, followed)


def _check_inputs(model: Model, wanted: WantedMotion) -> None:
    """Refuse effects that read what a motion does not tell: their own states, forces that a simulation determines."""
    given = {"q", "v", "a", "t", "p", *(f"load_{point}" for point in wanted.loads)}
    unknown = [port for port in model.programs["joint_reactions"].inputs if port.name not in given]
    if unknown:
        names = ", ".join(label for port in unknown for label in (port.labels if port.name == "x" else (port.name,)))
        raise DescriptionError(
            f"effects: {names} {'follows' if len(unknown) == 1 else 'follow'} from no motion; expected effects without "
            "states and inputs of their own; simulate a scene with these, or give a ball's spring the key 'nearest'"
        )


def _study(model: Model, functions: CompiledModel, wanted: WantedMotion, followed: Followed) -> DriveStudy:
    known: dict[str, Array] = {"q": followed.q, "v": followed.v, "a": followed.a, "t": wanted.t[:, None]}
    known |= {f"load_{point}": wrench for point, wrench in wanted.loads.items()}
    known["p"] = np.repeat(model.system.parameter_values[None], len(wanted.t), 0)
    called: dict[str, tuple[Array, ...]] = {}
    for name in USED:
        if name in functions.functions and all(port.name in known for port in functions[name].inputs):
            found = functions[name](*[known[port.name] for port in functions[name].inputs])
            called[name] = tuple(map(np.asarray, found)) if isinstance(found, tuple) else (np.asarray(found),)
    program = model.programs["joint_reactions"]
    assert isinstance(program, Program)
    has_drives = len(called["joint_reactions"]) > 1
    ports = {"u": program.outputs[0] if has_drives else None}
    u = called["joint_reactions"][0] if has_drives else np.zeros((len(wanted.t), 0))
    joint, rate = (model.programs[name].outputs[0] for name in ("joint_displacements", "joint_rates"))
    margins: dict[str, Array] = {}
    for name, kind in MARGINS.items():
        if name in called:
            labels = model.programs[name].outputs[0].labels
            margins |= {f"{kind}.{label}": called[name][0][:, k] for k, label in enumerate(labels)}
    drive_rates = called["drive_rates"][0] if "drive_rates" in called else np.zeros_like(u)
    return DriveStudy(
        model, wanted, followed, u, called["joint_reactions"][-1], called["joint_displacements"][0],
        called["joint_rates"][0], drive_rates, margins, called["joint_points"][0], called["body_poses"][0],
        _difference(
            model, functions, wanted, followed, u=u, reactions=called["joint_reactions"][-1],
            points=called["joint_points"][0],
        ),
        {"joint": joint.labels, "u": ports["u"].labels if ports["u"] else ()},
        {"joint": joint.units, "rate": rate.units, "u": ports["u"].units if ports["u"] else ()},
    )  # fmt: skip


def _difference(
    model: Model,
    functions: CompiledModel,
    wanted: WantedMotion,
    followed: Followed,
    *,
    u: Array,
    reactions: Array,
    points: Array,
) -> float | None:
    """Difference from Newton-Euler by the largest drive, force and moment; None for effects it does not know.

    Of an overconstrained mechanism internal loads are left out of the difference, for nothing determines them; instead
    the reactions must have no part along them, which makes them those of least norm.
    """
    gravity = [e for e in model.effects if isinstance(e, Gravity)]
    others = [e for e in model.effects if not isinstance(e, Gravity) and getattr(e, "point", None) not in wanted.loads]
    if others or len(gravity) > 1 or model.mechanism.couplings:
        return None
    motion = Motion(wanted.t, followed.q, followed.v, followed.a, np.zeros((len(wanted.t), 6)), 0.0, 0.0)
    states = body_states(model, functions, motion)
    loads: dict[str, Array] = {}
    for name, wrench in wanted.loads.items():
        point = model.mechanism.points[name]
        at = np.array([float(model.mechanism.number(c)) for c in point.at])
        if point.body == model.mechanism.ground:
            continue
        state = states[point.body]
        here = state.rotation @ at + state.translation
        moment = np.cross(here, wrench[:, :3]) + wrench[:, 3:]
        loads[point.body] = loads.get(point.body, 0.0) + np.concatenate([wrench[:, :3], moment], axis=1)
    fall = [float(x) for x in gravity[0].exact] if gravity else (0.0, 0.0, 0.0)
    other = newton_euler(model.mechanism, states, gravity=fall, loads=loads)
    expected = np.stack([other.reactions[name] for name in model.mechanism.joints], axis=-1)
    length = model.system.length  # so that moments that are rounding are held against the forces that make it
    force = float(np.abs(expected[:, :3]).max(initial=0.0))
    moment = max(float(np.abs(expected[:, 3:]).max(initial=0.0)), force * length)
    off, share = reactions - expected, np.zeros_like(reactions)
    if other.reaction_redundancy.any():
        loads_inside = np.stack([other.null_wrenches[name] for name in model.mechanism.joints], axis=-2)
        off, share = _without_internal(off, reactions, loads_inside, points=points, length=length)
    slides = np.array([unit == "N" for unit in model.programs["joint_reactions"].outputs[0].units[: u.shape[1]]])
    drive_scale = np.where(slides, max(force, moment / length), moment) if u.shape[1] else 1.0
    offs = [
        (u - other.drives) / np.maximum(np.abs(other.drives).max(axis=0), REST * drive_scale) if u.shape[1] else u,
        *(part[:, :3] / (force or 1.0) for part in (off, share)),
        *(part[:, 3:] / (moment or 1.0) for part in (off, share)),
    ]
    return max(float(np.abs(part).max(initial=0.0)) for part in offs)


def _without_internal(
    off: Array, reactions: Array, inside: Array, *, points: Array, length: float
) -> tuple[Array, Array]:
    """(a difference without its part along internal loads, the reactions' part along them), about the joints' points.

    Wrenches (f ; m_O) (n, 6, joints), internal loads (n, 6, joints, k); norms have moments divided by the length.
    """

    def flat(wrenches: Array) -> Array:
        """About the joints' points: (n, 6 joints, k)."""
        f, m = wrenches[:, :3], wrenches[:, 3:]
        about = m - np.cross(points[..., None], f, axis=1)
        return np.concatenate([f, about / length], axis=1).reshape(len(wrenches), -1, wrenches.shape[-1])

    basis = flat(inside)
    back = np.linalg.pinv(basis, rcond=INSIDE)

    def shaped(vectors: Array) -> Array:
        made = vectors.reshape(len(off), 6, -1)
        return np.concatenate([made[:, :3], made[:, 3:] * length], axis=1)

    left, own = flat(off[..., None]), flat(reactions[..., None])
    return shaped(left - basis @ (back @ left)), shaped(basis @ (back @ own))
