"""The components of a configuration space in words and as JSON values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from symscrew.mobility.components.algebra_program import ALGEBRA_PROGRAM
from symscrew.mobility.components.all_components import ConfigurationSpace
from symscrew.mobility.components.component_parts import Part
from symscrew.mobility.components.mode_sampling import SampledMode, SampledModes
from symscrew.mobility.components.modes_of_poses import Motion, PoseMode, PoseModes
from symscrew.mobility.components.numerical_decomposition import NumericalComponent, NumericalSpace
from symscrew.mobility.components.over_joints import OverJoints
from symscrew.mobility.components.zero_parameters import ZeroParameters

MOST_SHOWN = 6
"""Equations of a component in words; all are in the JSON."""
LONGEST_SHOWN = 60
"""Letters of an equation that is shown; a longer one says nothing to a reader."""
UNCHECKED = "which no proof file rechecks"
"""Of exact algebra, Singular's or factors of one equation: the checker of proof files knows of no Groebner bases."""
ALONE = "irreducible in its dimension, while lower ones within it are not excluded"
"""A part whose section is that of one component, and of which no more is known."""
CERTIFIED = "a regular configuration of it is certified by intervals, with exactly this dimension"
"""Of a sampled mode: it is there, and as large as said; that it is one, and that there are no others, is sampled."""
WHOLE = "a component of all configurations: at one of these, by the rank in doubles, no more moves"
"""Of a component of configurations with zero parameters."""
UNREAL = "; no real configuration was found about which it has this dimension: its real points may have less"
"""Of a component that may be complex but for points where others meet."""
UNSETTLED = (
    "Not all joints are among the variables: components are of the body's poses, those that differ only in the limbs "
    "are one, motions of limbs with the body at rest are not listed, and what is listed may be beyond a limb's reach"
)
"""What components leave open whose variables do not fix the displacements of all joints."""


def space_lines(found: ConfigurationSpace) -> list[str]:
    """A line for each component, and what is proved."""
    count = len(found.parts)
    judged = "proved: minimal primes" if found.proved else f"a union of these, proved; {found.reason};"
    kinds = f"{count} component{'s' * (count != 1)}"
    lines = [
        f"{kinds} of the {found.subject}, {_extent(found)} ({judged} over {found.field} by exact algebra, "
        f"{UNCHECKED}); degrees in {_variables(found.variables)}; over the complex numbers"
    ]
    smooth = found.smooth or found.on
    lines += [
        _line(part, f"{on} of {found.found}") + ("" if real or not part.dimension else UNREAL)
        for part, on, real in zip(found.parts, found.on, smooth, strict=True)
    ]
    if not found.settles:
        lines.append(UNSETTLED)
    return [
        *lines,
        f"Looked at by another route: all of {found.found} real configurations from random starts lie on these",
    ]


def _extent(found: ConfigurationSpace) -> str:
    """Which components the list has."""
    if not found.resting:
        return "all of them"
    angles = " or ".join(f"{joint} at {angle:.6g} rad" for joint, angle in found.resting)
    return f"all but such as would hold {angles} from the reference"


def _variables(names: tuple[str, ...]) -> str:
    study = " and Study's parameters x, y" if "x0" in names else ""
    others = [n for n in names if n[0] not in "xy" or "_" in n]
    shown = ", ".join(others[:4]) + (" ..." if len(others) > 4 else "")
    return f"{shown}{study}" if others else "Study's parameters x, y"


def _line(part: Part, on: str) -> str:
    where = "through the reference" if part.through else "elsewhere"
    if part.multiplicity:
        where += ", smooth there" if part.multiplicity == 1 else f", of multiplicity {part.multiplicity} there"
    divided = "" if part.irreducible else f", {ALONE}" if part.irreducible_in_its_dimension else ", not divided further"
    short = [e for e in part.equations if len(e) <= LONGEST_SHOWN]
    shown = "; ".join(f"{e} = 0" for e in short[:MOST_SHOWN])
    more = max(len(part.equations), len(part.polynomials)) - min(len(short), MOST_SHOWN)
    equations = shown + (f"; and {more} more" if shown and more else f"{more} equations" if more else "")
    held = "".join(f", {joint} at {angle:.6g} rad all over it" for joint, angle in part.held)
    size = f"dimension {part.dimension}, degree {part.degree}, {where}{divided}{held}"
    return f"{size}, {on} real configurations{': ' if equations else ''}{equations}"


def space_values(found: ConfigurationSpace) -> dict[str, Any]:
    """The same as JSON values."""
    parts = [
        {"dimension": p.dimension, "degree": p.degree, "through_reference": p.through, "irreducible": p.irreducible,
         "irreducible_in_its_dimension": p.irreducible or p.irreducible_in_its_dimension,
         "multiplicity_at_reference": p.multiplicity or None,
         "held": [{"joint": j, "angle": a} for j, a in p.held],
         "real_configurations": on, "real_dimension_seen": bool(real),
         "equations": [f"{e} = 0" for e in p.equations]}
        for p, on, real in zip(found.parts, found.on, found.smooth or found.on, strict=True)
    ]  # fmt: skip
    return {
        "decided": True, "subject": found.subject, "variables": list(found.variables), "field": found.field,
        "proved": found.proved, "proved_by": f"exact algebra, {UNCHECKED}", "not_done": found.reason,
        "all_but_with_a_joint_held_at": [{"joint": j, "angle": a} for j, a in found.resting],
        "all_joints_settled": found.settles, "not_settled": "" if found.settles else UNSETTLED,
        "real_configurations": found.found, "components": parts,
    }  # fmt: skip


def mode_lines(found: SampledModes) -> list[str]:
    """A line for each sampled mode."""
    count = len(found.modes)
    head = (
        f"{count} operation mode{'s' * (count != 1)} of {found.body}, sampled: {found.found} configurations from "
        "random starts; Study's parameters x, y with lengths in sizes of the mechanism; others may be missing"
    )
    return [head, *(_mode(mode, found) for mode in found.modes)]


def _mode(mode: SampledMode, found: SampledModes) -> str:
    places = {True: "through the reference", False: "elsewhere", None: "not known whether through the reference"}
    where = places[mode.through]
    shown = "; ".join(f"{e} = 0" for e in mode.equations) or "no linear equation"
    text = f"dimension {mode.dimension} ({mode.poses} of the poses), {where}, {mode.count} of {found.found}: {shown}"
    text += f"; {mode.quadrics} quadrics" if mode.quadrics > 1 else ""
    return f"{text}; {CERTIFIED}" if mode.certified else text


def mode_values(found: SampledModes) -> dict[str, Any]:
    """The same as JSON values."""
    modes = [
        {"dimension": m.dimension, "dimension_of_poses": m.poses, "through_reference": m.through,
         "linear_equations": [f"{e} = 0" for e in m.equations], "quadrics": m.quadrics, "configurations": m.count,
         "certified_at_a_configuration": m.certified}
        for m in found.modes
    ]  # fmt: skip
    return {"body": found.body, "judgement": "sampled", "configurations": found.found, "modes": modes}


def pose_lines(found: PoseModes) -> list[str]:
    """A line for each mode by exact algebra, those that were not seen, and what was sampled beside them."""
    count = len(found.modes)
    head = (
        f"{count} operation mode{'s' * (count != 1)} of {found.body} against {found.base}, with an axis that stays "
        f"parallel: sets of poses by exact algebra, irreducible over {found.field}, proved, {UNCHECKED}; degrees in "
        "Study's parameters x, y; that the poses are reached is by the rank at a witness"
    )
    lines = [head, *(_pose_mode(mode, found) for mode in found.modes)]
    for part in found.unseen:
        equations = "; ".join(f"{e} = 0" for e in part.equations[:MOST_SHOWN] if len(e) <= LONGEST_SHOWN)
        lines.append(f"no motion of dimension {part.dimension} was seen on the poses {equations}")
    beside, *modes = mode_lines(found.others)
    return [*lines, f"All other configurations are beside these. {beside}", *modes]


def _pose_mode(mode: PoseMode, found: PoseModes) -> str:
    witness = mode.motion
    more = f", of {witness.freedoms} freedoms of the joints" if witness.freedoms > mode.part.dimension else ""
    return (
        f"{_line(mode.part, f'{mode.count} of {found.found}')}; {found.body} {witness.system.motion_type}, "
        f"{witness.system}{_about(witness)}; at the witness, closed to {witness.residual:.0e}, the rank "
        f"{'in 60 digits ' if witness.exact else ''}leaves {mode.part.dimension}{more}"
    )


def _about(motion: Motion) -> str:
    """The axis about which the body turns, and whether it is upside down."""
    if motion.axis is None:
        return ""
    name = "Schoenflies motion" if motion.system.type == "1R3T" else "turning"
    against = {1: "", -1: ", the body the other way up", 0: ", about another line of the body than in the reference"}
    return f", {name} about ({', '.join(f'{c + 0.0:.6g}' for c in motion.axis.round(9))}){against[motion.upright]}"


def pose_values(found: PoseModes) -> dict[str, Any]:
    """The same as JSON values; displacements of a witness in rad and in sizes of the mechanism."""
    modes = [
        {"dimension": m.part.dimension, "degree": m.part.degree, "through_reference": m.part.through,
         "equations": [f"{e} = 0" for e in m.part.equations], "real_configurations": m.count,
         "platform": {"type": m.motion.system.type, "motion_type": m.motion.system.motion_type,
                      "class": m.motion.system.name,
                      "axis": None if m.motion.axis is None else m.motion.axis.round(12).tolist(),
                      "upright": m.motion.upright},
         "witness": {"displacements": m.motion.q.tolist(), "closed_to": m.motion.residual,
                     "in_60_digits": m.motion.exact, "freedoms": m.motion.freedoms}}
        for m in found.modes
    ]  # fmt: skip
    return {
        "base": found.base, "field": found.field,
        "proved_by": f"exact algebra, {UNCHECKED}; reached by ranks in doubles",
        "modes": modes, "unseen": [[f"{e} = 0" for e in part.equations] for part in found.unseen],
        **{f"beside_{name}": value for name, value in mode_values(found.others).items()},
    }  # fmt: skip


def zero_lines(found: Sequence[ZeroParameters]) -> list[str]:
    """A line for each set of parameters that are zero, and one for each component with them."""
    lines = list[str]()
    for one in found:
        zeros = f"configurations with {' = '.join([*one.zeros, '0'])}"
        if one.reason:
            lines.append(f"{zeros}: not decided: {one.reason}")
            continue
        count = len(one.parts)
        lines.append(
            f"all {zeros}: {count} component{'s' * (count != 1)} (proved: minimal primes over {one.field} by exact "
            f"algebra, {UNCHECKED}); degrees in {_variables(one.variables)}; over the complex numbers"
        )
        for held in one.parts:
            rank = WHOLE if held.whole else "whether it is a component of all configurations is not known"
            lines.append(f"{_line(held.part, f'{held.on} of {one.found}')}; {rank}")
    return lines


def zero_values(found: Sequence[ZeroParameters]) -> list[dict[str, Any]]:
    """The same as JSON values."""
    return [
        {"zero": list(one.zeros), "decided": not one.reason, "why": one.reason, "field": one.field,
         "proved_by": f"exact algebra, {UNCHECKED}", "all_joints_settled": one.settles,
         "components": [
             {"dimension": h.part.dimension, "degree": h.part.degree, "through_reference": h.part.through,
              "irreducible": h.part.irreducible, "real_configurations": h.on, "component_of_all": h.whole,
              "equations": [f"{e} = 0" for e in h.part.equations]}
             for h in one.parts]}
        for one in found
    ]  # fmt: skip


def numerical_lines(spaces: Sequence[NumericalSpace]) -> list[str]:
    """A line for each component by numerical decomposition, and what it rests on."""
    return [line for space in spaces for line in _numerical_space(space)]


def _numerical_space(found: NumericalSpace) -> list[str]:
    count = len(found.components)
    head = (
        f"numerical: {count} component{'s' * (count != 1)} of the {found.subject} that real configurations are on, "
        f"irreducible over the complex numbers; degrees by the trace test in {_variables(found.variables)}; "
        f"others may be missing{f'; {found.reason}' if found.reason else ''}"
    )
    lines = [head, *(_numerical(part, found) for part in found.components)]
    if found.isolated:
        lines.append(f"{found.isolated} isolated configurations with no freedom, where the equations are regular")
    if found.unplaced:
        lines.append(f"{found.unplaced} of {found.found} real configurations on none: singular, or not followed")
    lines += [line for over in found.over for line in _over_joints(over)]
    return lines if found.settles else [*lines, UNSETTLED]


def _numerical(part: NumericalComponent, found: NumericalSpace) -> str:
    where = {True: "through the reference", False: "elsewhere", None: "not known whether through the reference"}
    several = f"one component or up to {part.sets}, " if part.sets > 1 else ""
    number = f"degree {part.degree}" if part.closed else f"{several}not all points found, {part.degree} so far"
    of = " of combinations of the equations, all of which are" if found.combined else ", the equations are"
    proof = (
        f"{part.certified} of {part.degree} points on a random section certified (Krawczyk) as regular zeros{of} "
        f"below {part.residual:.0e} there" if part.certified else "no point certified"
    )  # fmt: skip
    trace = f"; trace {part.trace:.0e}{' in 60 digits' if part.fine else ''}" if part.closed else ""
    joined = f"; all joined again in {part.loops} loop{'s' * (part.loops != 1)}" if part.loops else ""
    size = f"dimension {part.dimension}, {number}, {where[part.through]}"
    if part.rank is not None:
        size += f", all over it the equations have rank {part.rank} only, a condition for which was added (deflated)"
    return f"{size}, {part.on} of {found.found} real configurations; {proof}{trace}{joined}"


def _over_joints(found: OverJoints) -> list[str]:
    """The components over given joint angles, and what says that they are all."""
    count = len(found.parts)
    head = (
        f"over given {', '.join(found.joints)}: {count} component{'s' * (count != 1)} of dimension {found.dimension} "
        f"on which these vary freely, {found.total} poses over the complex numbers for generic values (counted by "
        f"{ALGEBRA_PROGRAM} modulo {found.primes} primes, all simple{_beside(found)})"
    )
    if found.reason:
        return [f"{head}; not decided: {found.reason}, so that there may be further components"]
    left = "their factors leave no other division" if found.irreducible else (
        f"the factors' degrees leave {', '.join(map(str, found.sums[1:-1])) or 'no'} poses of a component"
    )  # fmt: skip
    joined = f"{found.quiet} further loops joined no other; {left}" if count > 1 else "and joined by loops"
    lines = [f"{head}; all were found, {joined}"]
    for part in found.parts:
        where = "through the reference" if part.through else "not through the reference, or it is singular"
        lines.append(
            f"dimension {found.dimension}, {part.poses} poses over each place, {where}, {part.on} real configurations"
            f"; {part.certified} certified (Krawczyk), all equations below {part.residual:.0e} there"
        )
    return lines


def _beside(found: OverJoints) -> str:
    """Which poses are not among those that were counted."""
    sets = [" = ".join([*equations, "0"]) for equations in found.beside]
    return f", those with {' or '.join(sets)} left out" if sets else ""


def _over_values(found: OverJoints) -> dict[str, Any]:
    return {
        "joints": list(found.joints), "dimension": found.dimension, "poses": found.total, "primes": found.primes,
        "poses_of_one_component": list(found.sums), "factors_leave_no_other_division": found.irreducible,
        "all_poses_found": not found.reason, "not_done": found.reason, "loops_without_news": found.quiet,
        "left_out": [[f"{e} = 0" for e in equations] for equations in found.beside],
        "components": [
            {"poses": p.poses, "through_reference": p.through, "real_configurations": p.on,
             "certified_points": p.certified, "largest_equation": p.residual}
            for p in found.parts],
    }  # fmt: skip


def numerical_values(spaces: Sequence[NumericalSpace]) -> list[dict[str, Any]]:
    """The same as JSON values, one for each set of loops that share no joint with others."""
    return [
        {"judgement": "numerical", "subject": s.subject, "variables": list(s.variables), "field": s.field,
         "all_points_found": s.closed, "not_done": s.reason, "real_configurations": s.found,
         "isolated_configurations": s.isolated, "unplaced_configurations": s.unplaced,
         "all_joints_settled": s.settles, "certified_of_combinations": s.combined,
         "components": [
             {"dimension": c.dimension, "degree": c.degree, "all_points_found": c.closed,
              "through_reference": c.through, "real_configurations": c.on, "certified_points": c.certified,
              "largest_equation": c.residual if c.certified else None, "trace": c.trace if c.closed else None,
              "trace_in_60_digits": c.fine, "at_most_components": c.sets, "loops_that_join_again": c.loops,
              "deflated_to_rank": c.rank}
             for c in s.components],
         "over_joints": [_over_values(over) for over in s.over]}
        for s in spaces
    ]  # fmt: skip
