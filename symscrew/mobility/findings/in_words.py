"""A mobility result in words: headings and lines, formulas between dollar signs.

Mobility --sections--> [(heading, lines)] --documents--> text, Markdown, HTML, LaTeX
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import sympy

from symscrew.mobility.field_counts import as_lines as counts_in_words
from symscrew.mobility.findings.at_rest import resting_lines
from symscrew.mobility.findings.counts_typeset import TWIST, WRENCH, in_latex
from symscrew.mobility.findings.places import place_lines
from symscrew.mobility.findings.planar_drives import lines_of_drives
from symscrew.mobility.findings.typeset import inline, presentable, say_more, vanishing
from symscrew.mobility.finite import lone_pairs, named_spins
from symscrew.mobility.motions import branch_lines
from symscrew.mobility.screw_text import describe_twist, describe_wrench
from symscrew.mobility.singularities import as_lines
from symscrew.mobility.symbols import conditions
from symscrew.mobility.withheld import WITHDRAWN

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility, Near
    from symscrew.mobility.instantaneous import LimbMobility
    from symscrew.mobility.symbols import Locus

MOST_CHANGES = 4
"""Joints named as farthest from special geometry: a line; all are in the JSON."""
NOT_TRIED = "What was not tried"


def sections(found: Mobility) -> list[tuple[str, list[str]]]:
    """(heading, lines) of the whole report in words; formulas between dollar signs."""
    result = [("Mobility", _summary(found))]
    if lines := place_lines(found):
        result.append(("Configuration", lines))
    result += _limbs(found)
    motion_type = found.platform.motion_type
    lines = [f"{_count(found.platform.dof, 'freedom')}, type {motion_type}{_meaning(motion_type)}"]
    lines += [describe_twist(t) for t in found.platform.freedoms.basis]
    of_platform = found.symbolic is not None and found.platform.body == found.mechanism.platform
    if found.symbolic is not None and of_platform and say_more(found.symbolic.freedoms):
        lines.append(f"in symbols {in_latex(TWIST)}: {inline(found.symbolic.freedoms)}")
    if found.without_symbols:
        lines.append(found.without_symbols)
    result.append((f"Freedoms of {found.platform.body}", lines))
    if found.branches is not None:
        result.append(
            (
                "Branches through the configuration",
                [*branch_lines(found.branches, found.network), *resting_lines(found)],
            )
        )
    elif "branches" in found.withdrawn:
        result.append(("Branches through the configuration", [WITHDRAWN["branches"]]))
    if not found.limbs and found.network.chords and (lines := _motions(found)):
        result.append(("Motions of the loops in symbols", lines))
    if lines := [*_loci(found.loci), *lines_of_drives(found)]:
        result.append(("Where it degenerates", lines))
    if lines := as_lines(found.singularities, found.mechanism.limbs):
        result.append(("How far from singularities (0 at one)", lines))
    result.append(("In the field's words", [in_latex(line) for line in counts_in_words(found.counts)]))
    if found.redundant.count:
        result.append(("Redundant constraints", _redundant(found)))
    if found.near is not None:
        result.append(("To type for the special geometry, lengths in m", _instead(found.near)))
    if found.nearly_parallel:
        result.append(("Almost parallel", list(found.nearly_parallel)))
    if found.not_tried:
        result.append((NOT_TRIED, list(found.not_tried)))
    result.append(("How it was decided", [found.method, *found.finite.evidence]))
    return result


def _limbs(found: Mobility) -> list[tuple[str, list[str]]]:
    """A section for all limbs with the same constraints; what differs away from the reference is said of each."""
    symbolic = {limb.name: limb for limb in found.symbolic.limbs} if found.symbolic else {}
    alike: dict[tuple[str, ...], list[tuple[LimbMobility, list[str]]]] = {}
    for limb in found.limbs:
        lines = [f"{_count(len(limb.screws), 'joint freedom')}, {_count(len(limb.constraints.basis), 'constraint')}"]
        lines += [describe_wrench(w) for w in limb.constraints.basis]
        if limb.name in symbolic and say_more(symbolic[limb.name].constraints):
            lines.append(f"in symbols {in_latex(WRENCH)}: {inline(symbolic[limb.name].constraints)}")
        further = _displaced(found, limb.name)
        alike.setdefault((*lines, str(len(further))), []).append((limb, further))
    result = []
    for (*lines, _), same in alike.items():
        likewise, own = False, list[str]()
        for facts in zip(*(further for _, further in same), strict=True):
            by_place = {
                _renamed(fact, {joint: f"\0{k}\0" for k, joint in enumerate(limb.joints)})
                for (limb, _), fact in zip(same, facts, strict=True)
            }
            if len(by_place) == 1:
                own.append(facts[0])
                likewise |= len(set(facts)) > 1
            else:
                own += [f"{limb.name}: {fact}" for (limb, _), fact in zip(same, facts, strict=True)]
        said = f"Joints are those of {same[0][0].name}; likewise the others with their own"
        title = f"Limb{'s' * (len(same) > 1)} {', '.join(limb.name for limb, _ in same)}"
        result.append((title, [*lines, *own, *([said] * likewise)]))
    return result


def _renamed(text: str, names: Mapping[str, str]) -> str:
    """The text with whole names replaced, of joints by their places in a limb."""
    return re.sub(r"\w+", lambda word: names.get(word[0], word[0]), text)


def _count(number: int, what: str) -> str:
    return f"{number or 'no'} {what}{'' if number == 1 else 's'}"


def _meaning(motion_type: str) -> str:
    """What a letter says that not everybody uses."""
    return ", H being a screw motion of a pitch other than 0" if "H" in motion_type else ""


def key_figures(found: Mobility) -> list[tuple[str, str]]:
    """(what, value) for the table at the head of a report."""
    finite = found.finite
    branches = "smooth" if finite.branches is None else ", ".join(map(str, finite.branches)) or "isolated"
    figures = [
        ("configuration", found.configuration),
        ("instantaneous mobility", str(found.dof)),
        ("finite mobility", "not decided" if finite.dof is None else f"{finite.dof} ({finite.judgement})"),
        ("branches", branches),
        ("Kutzbach-Gruebler", str(found.kutzbach)),
        ("redundant constraints", str(found.overconstraints)),
        (f"freedoms of {found.platform.body}", f"{found.platform.dof} ({found.platform.motion_type})"),
        ("internal freedoms", str(found.internal_freedoms)),
    ]
    if found.dof_drives_locked is not None:
        figures.append(("with drives locked", str(found.dof_drives_locked)))
    return [*figures, ("ranks", "exact" if found.decisions.exact else "certified numeric")]


def _summary(found: Mobility) -> list[str]:
    finite = found.finite
    lines = [f"{_count(found.dof, 'instantaneous freedom')}; Kutzbach-Gruebler counts {found.kutzbach}"]
    if found.overconstraints:
        couplings = len(found.network.ties)
        equations = f"{6 * len(found.network.chords) + couplings} " + (
            "equations of loops and couplings" if couplings else "closure equations"
        )
        lines.append(
            f"The count is {found.overconstraints} too low, because {found.overconstraints} of the "
            f"{equations} follow from the others"
        )
    if found.internal_freedoms:
        lines.append(f"{_count(found.internal_freedoms, 'freedom')} with {found.platform.body} at rest (internal)")
    if spins := named_spins(found.network):
        lines.append("Passive spins about the lines between " + ", ".join(f"{a} and {b}" for a, b in spins))
    if alone := [pair for pair in lone_pairs(found.network) if pair not in spins]:
        lines.append("Links that move alone between their joints: " + ", ".join(f"{a} and {b}" for a, b in alone))
    if found.dof and not found.platform.dof and finite.dof:
        lines.append(
            f"{found.platform.body} is at rest for an instant while the mechanism moves (a dead point for it), "
            "or it does not move at all; --body shows another body"
        )
    if finite.smooth:
        lines.append(f"Finite mobility {finite.dof}, {finite.judgement}: a smooth point of the configuration space")
    elif finite.dof is None:
        lines.append("A singular point of the configuration space; the finite mobility is not decided")
    elif not finite.branches:
        lines.append(
            f"No finite mobility, {finite.judgement}: the configuration is isolated, its freedoms are infinitesimal "
            "(shaky)"
        )
    else:
        lines.append(
            f"Finite mobility {finite.dof}, {finite.judgement}: a singular point ({finite.kind}); "
            "dimensions of the branches through it: " + ", ".join(map(str, finite.branches))
        )
    if found.taken is not None:
        typed, size = found.taken.typed, found.taken.distance
        lines.append(
            f"That is special geometry within {size:.1e} m of the one typed, taken as meant (tolerance "
            f"{found.taken.tolerance:g} m). As typed: {_count(typed.dof, 'instantaneous freedom')}, finite mobility "
            f"{'undecided' if typed.finite.dof is None else typed.finite.dof}, {typed.finite.judgement}"
        )
    if found.near is not None:
        lines += _near(found, found.near)
    if found.nearly_singular:
        lines.append(found.nearly_singular)
    lines += found.nearly_special
    if found.dof_drives_locked is not None:
        locked = f"{_count(found.dof_drives_locked, 'freedom').capitalize()} left with all drives locked"
        spun = found.dof_drives_locked and found.dof_drives_locked == len(named_spins(found.network))
        lines.append(locked + (", passive" if spun else ""))
    return lines


def _near(found: Mobility, near: Near) -> list[str]:
    """Both verdicts, how far apart, and which joints differ."""
    meant, first = near.meant, near.changes[:MOST_CHANGES]
    finite = meant.finite
    facts = [f"mobility {finite.dof} ({meant.dof} instantaneous, {meant.overconstraints} redundant constraints; "
             f"{finite.judgement})"]  # fmt: skip
    if finite.branches:
        facts.append("branches of dimension " + ", ".join(map(str, finite.branches)) + " through it")
    special, typed = meant.platform.motion_type, found.platform.motion_type
    if special != typed:
        facts.append(f"type {special} of {meant.platform.body} (as typed {typed})")
    if meant.dof_drives_locked != found.dof_drives_locked:
        left = f"{_count(meant.dof_drives_locked or 0, 'freedom')} left with all drives locked"
        facts.append(f"{left} (as typed {found.dof_drives_locked})")
    return [
        f"That is as typed. Within {near.distance:.1e} m of a special geometry with " + ", ".join(facts),
        "Largest changes to it: " + ", ".join(f"{name} {size:.1e} m" for name, size in first)
        + f"; --tolerance {_above(near.distance)} takes it as meant, the numbers to type for it stand below",
    ]  # fmt: skip


def _above(distance: float) -> str:
    """A round length above the distance."""
    return f"1e{int(np.floor(np.log10(distance))) + 1}"


def _instead(near: Near) -> list[str]:
    """What to type for every joint."""
    lines = []
    for name, (point, axes, pitch) in near.places().items():
        turned = "".join(f", axis ({', '.join(axis)})" for axis in axes)
        screwed = "" if pitch is None else f", pitch {pitch}"
        lines.append(f"{name}: point ({', '.join(point)}){turned}{screwed}")
    return lines


def _displaced(found: Mobility, limb: str) -> list[str]:
    """The constraints of a limb with symbols for its own joints, or the sentence why not."""
    pose = found.limb_poses.get(limb)
    if pose is None or isinstance(pose, str):
        return [f"away from the reference configuration: {pose}"] if pose else []
    names = ", ".join(f"${sympy.latex(s)}$ of {joint}" for s, joint in zip(pose.displacements, pose.of, strict=True))
    known = {limb.name: limb.constraints for limb in found.symbolic.limbs} if found.symbolic else {}
    screws = f" {in_latex(WRENCH)}: {inline(pose.constraints)}"
    if pose.constraints == known.get(limb) and not say_more(pose.constraints):
        screws = ": the same"
    lines = [f"displaced by {names}, in axes that move with {pose.carried_by}{screws}"]
    lines += [f"{locus.meaning} where {_zero(locus)}" for locus in conditions(pose.loci)]
    if pose.further:
        places = [f"{joint} at {_displacement(x, turns=str(s).startswith('theta'))}"
                  for (s, x), joint in zip(pose.further.items(), pose.of, strict=True)]  # fmt: skip
        beside = "also at " if any(locus.kind == "limb" for locus in pose.loci) else "at "
        lines.append(
            f"the screws of the limb become dependent {beside}{', '.join(places)}, "
            "where several conditions hold at once (found by looking)"
        )
    return lines


def _displacement(value: float, *, turns: bool) -> str:
    shown = round(float(np.degrees(value)) if turns else 1000 * value, 9) + 0.0  # what was looked for in doubles
    return f"{shown:.4g} {'deg' if turns else 'mm'}"


def _motions(found: Mobility) -> list[str]:
    """Joint rates of a mechanism without limbs, or the sentence why not."""
    loops = found.loops
    if isinstance(loops, str):
        return [loops]
    lines = []
    for rates in loops.rates:
        moving = [(joint, presentable(rate)) for joint, rate in zip(loops.joints, rates, strict=True) if rate != 0]
        lines.append("rates " + ", ".join(f"{joint} ${sympy.latex(rate)}$" for joint, rate in moving))
        if resting := [joint for joint, rate in zip(loops.joints, rates, strict=True) if rate == 0]:
            lines.append(f"at rest in it: {', '.join(resting)}")
    if loops.freedoms:
        lines.append(f"{loops.body} moves by {in_latex(TWIST)}: {inline(loops.freedoms)}")
    return lines


def _redundant(found: Mobility) -> list[str]:
    joints = ", ".join(found.redundant.statically_indeterminate)
    return [
        f"The reactions of {joints} are not unique",
        "One change for each redundant constraint:",
        *found.redundant.cure,
    ]


def _zero(locus: Locus) -> str:
    return f"${sympy.latex(vanishing(locus.expression))} = 0$" if locus.expression != 0 else "always"


def _loci(loci: Sequence[Locus]) -> list[str]:
    """A line for each condition and what it means, with all limbs or sets of drives of which it says the same."""
    alike: dict[tuple[str, str], list[Locus]] = {}
    for locus in loci:
        alike.setdefault((_zero(locus), locus.meaning.replace(locus.where, "{}")), []).append(locus)
    lines = []
    for (zero, meaning), group in alike.items():
        first = group[0]
        said = first.meaning if len(group) == 1 else meaning.format("one of these sets")
        lines.append(f"{zero} ({_names([locus.where for locus in group])}): {said}")
    return lines


def _names(names: Sequence[str]) -> str:
    return ("; " if any(" " in name for name in names) else ", ").join(names)
