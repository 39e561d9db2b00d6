"""Robots from URDF and MJCF files in one call: the mechanism, the effects that the file names, limits and account.

    robot = load_robot("arm.xml")
    model = symscrew.derive(robot.mechanism, robot.effects)

Gravity is the file's, or 9.81 m/s^2 along -z. Limits are no effects unless `stops` asks for them.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from symscrew.description import Mechanism
from symscrew.effects import (
    Effect,
    effect_to_table,
    effects_of_file,
    forces_of_effects,
    stops_of_file,
    system_under,
    type_name,
)
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats import Account, Beside, Imported, ImportOptions, JointLimits, import_file, save_as
from symscrew.mobility import analyse_mobility

Starts = dict[str, Mapping[str, float]]
QUATERNION, TURNING = ("qw", "qx", "qy", "qz"), ("wx", "wy", "wz")


@dataclass(frozen=True)
class Robot:
    """A robot as its file has it.

    Attributes:
        mechanism: bodies, joints, couplings.
        effects: gravity, rotor inertias, friction, springs, servos.
        limits: joint, or freedom of one with several (`hip.0`) -> reach, rate, effort.
        configurations: keyframes by name, coordinates in the file's order.
        account: what became of everything that the file says; `account.lines()` in words.
        starts: keyframes by name, values of coordinates by their labels.
        start_rates: keyframes that are no rest by name, rates by their labels.
    """

    mechanism: Mechanism
    effects: tuple[Effect, ...]
    limits: Mapping[str, JointLimits]
    configurations: Mapping[str, tuple[float, ...]]
    account: Account
    starts: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    start_rates: Mapping[str, Mapping[str, float]] = field(default_factory=dict)

    def named(self, name: str) -> Robot:
        """The same robot under another name."""
        return replace(self, mechanism=replace(self.mechanism, name=name))


def load_robot(
    path: str | Path, options: ImportOptions | None = None, *, without: Collection[str] = (), stops: bool = False
) -> Robot:
    """The robot in a URDF or MJCF file.

    Args:
        path: of the file.
        options: what is accepted beside what is read without asking: `snap`, `repair`, `accept`, `floating`, `exact`.
        without: types of effects to leave out, by their names in a scene.
        stops: whether limits of joints become rigid end stops, for simulation.

    Raises:
        DescriptionError: the file cannot be read, or numbers depend on what would be left out, or `exact` digits make
            another mobility of its loops.
    """
    found = import_file(path, options)
    if options is not None and options.exact:
        _check_verdict(Path(path), options, found)
    return robot_of(found, without=without, stops=stops)


def _check_verdict(path: Path, options: ImportOptions, found: Imported) -> None:
    """Refuse digits as angles where a loop then has another mobility than with the numbers as they are written."""
    made = found.mechanism
    if options.accept or (len(made.joints) < len(made.bodies) and not made.couplings):
        return  # a tree moves as its joints do
    written = import_file(path, replace(options, exact=False)).mechanism
    before, after = (analyse_mobility(mechanism) for mechanism in (written, made))
    if (before.dof, before.overconstraints) != (after.dof, after.overconstraints):
        raise DescriptionError(
            f"{path.name}: with digits taken as angles it has {after.dof} freedoms and {after.overconstraints} "
            f"redundant constraints, with the numbers as they are written {before.dof} and {before.overconstraints}; "
            "correct the file, leave --exact out, or take it with --accept"
        )


def robot_of(found: Imported, *, without: Collection[str] = (), stops: bool = False) -> Robot:
    """An import as a robot; see `load_robot`."""
    made = effects_of_file(found.forces, found.gravity)
    made += _stops(found.limits) if stops else []
    effects = tuple(effect for effect in made if type_name(effect) not in without)
    starts, rates = _as_the_tree_counts(found, effects)
    return Robot(found.mechanism, effects, found.limits, found.configurations, found.account, starts, rates)


def _as_the_tree_counts(found: Imported, effects: tuple[Effect, ...]) -> tuple[Starts, Starts]:
    """Keyframes' coordinates and rates: of a ball that the tree comes to from its child, those of its parent."""
    mechanism, starts, rates = found.mechanism, dict(found.starts), dict(found.start_rates)
    closed = len(mechanism.joints) >= len(mechanism.bodies)
    if not starts or not closed or not any(joint.kind.ball for joint in mechanism.joints.values()):
        return starts, rates
    links = system_under(mechanism, effects).tree.links
    for ball in [link.joint for link in links if link.inverted and link.motion.spherical]:
        turn, speed = ([f"{ball}.{entry}" for entry in entries] for entries in (QUATERNION, TURNING))
        for name, values in starts.items():
            if turn[0] not in values:
                continue
            w, *r = (values[label] for label in turn)
            starts[name] = {**values, **{label: -value for label, value in zip(turn[1:], r, strict=True)}}
            moving = rates.get(name, {})
            if any(label in moving for label in speed):
                back = _turned(w, r, [-moving.get(label, 0.0) for label in speed])
                rates[name] = {**moving, **dict(zip(speed, back, strict=True))}
    return starts, rates


def _turned(w: float, r: Sequence[float], vector: Sequence[float]) -> list[float]:
    """A vector turned by the unit quaternion (w, r): v + 2 w r x v + 2 r x (r x v)."""

    def cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
        return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]

    once = cross(r, vector)
    return [v + 2 * (w * a + b) for v, a, b in zip(vector, once, cross(r, once), strict=True)]


def _stops(limits: Mapping[str, JointLimits]) -> list[Effect]:
    return stops_of_file({joint: (limit.lower, limit.upper) for joint, limit in limits.items()})


def save_robot(
    mechanism: Mechanism,
    path: str | Path,
    effects: Collection[Effect],
    *,
    limits: Mapping[str, JointLimits] | None = None,
    accept: bool = False,
) -> list[str]:
    """Write a mechanism and what acts on it to a URDF or MJCF file, as that file's own words.

    Args:
        mechanism: of the robot.
        path: of the file; its suffix says as what.
        effects: that the file is to have: rotor inertias, viscous and dry friction, springs, servos, gravity.
        limits: joint -> reach, rate, effort.
        accept: leave out what the file does not hold.

    Returns:
        What the file does not hold and was left out, in words.

    Raises:
        DescriptionError: the file does not hold the mechanism, or an effect and that is not accepted.
    """
    forces, field, others = forces_of_effects(mechanism, effects)
    return save_as(mechanism, path, beside=Beside(forces, limits or {}, field, others, accept))


def scene_text(robot: Robot, mechanism: str, start: str | None = None) -> str:
    """The text of a scene with the robot's effects, limits in comments, for the mechanism in the file of this name.

    `start`: the keyframe that it begins at. Of a robot with loops, which keyframes close to few digits only, the driven
    joints are held and the others follow.
    """
    lines = [f"# {robot.mechanism.name}: what acts on it, as its file says. Blocks that are removed do not act."]
    lines += [f"# {line}" for line in robot.account.lines()]
    lines += ["", "[scene]", f'name = "{robot.mechanism.name}_scene"', f'mechanism = "{mechanism}"', "duration = 1"]
    lines += ["rate = 100"]
    if start is not None:
        lines += ["", *_initial(robot, start)]
    elif robot.starts:
        lines += [f"# Keyframes of the file to begin at, with --start: {', '.join(robot.starts)}"]
    for effect in robot.effects:
        lines += ["", *_block(effect_to_table(effect))]
    stops = _stops(robot.limits)
    if stops:
        lines += ["", "# Limits as rigid stops: take the number signs away to have them in simulations."]
    for stop in stops:
        lines += [f"# {line}" for line in _block(effect_to_table(stop))]
    return "\n".join([*lines, ""])


def _initial(robot: Robot, start: str) -> list[str]:
    if start not in robot.starts:
        raise DescriptionError(f"there is no keyframe {shorten(start)}; {did_you_mean(start, robot.starts)}")
    mechanism = robot.mechanism
    effects = tuple(robot.effects)
    tree = system_under(mechanism, effects).tree
    known = {c.label: robot.starts[start][c.label] for c in tree.q if c.label in robot.starts[start]}
    lines = ["[initial]", f"coordinates = {_inline(known)}"]
    rates = robot.start_rates.get(start, {})
    moving = {c.label: rates[c.label] for c in tree.v if c.label in rates}
    if moving:
        lines.append(f"rates = {_inline(moving)}")
    if len(mechanism.joints) >= len(mechanism.bodies) or mechanism.couplings:
        sure = {name for name, joint in mechanism.joints.items() if joint.driven or joint.kind.unconstrained}
        held = [name for name in dict.fromkeys([*known, *moving]) if name.partition(".")[0] in sure]
        lines.append(f"hold = [{', '.join(f'{chr(34)}{name}{chr(34)}' for name in held)}]")
    return lines


def _inline(values: Mapping[str, float]) -> str:
    return "{" + ", ".join(f'"{name}" = {value!r}' for name, value in values.items()) + "}"


def _block(table: Mapping[str, Any]) -> list[str]:
    return ["[[effects]]", *(f"{key} = {_toml(value)}" for key, value in table.items())]


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return repr(value)
