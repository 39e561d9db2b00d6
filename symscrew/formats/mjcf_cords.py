"""Tendons in space of an MJCF: straight from site to site, a spring and damper over points; written as that again.

    <spatial stiffness damping springlength> over sites <--> {"kind": "cord", start, through, end, ...}

One that is led around geoms or by pulleys, and its dry friction and armature, no effect here has. Source:
https://mujoco.readthedocs.io/en/stable/XMLreference.html#tendon-spatial.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any
from xml.etree.ElementTree import SubElement

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft
from symscrew.formats.rigid_displacements import Pose, length, minus, real
from symscrew.formats.safe_xml import Element, attribute, decimals, elements, label, numbers

HELD = ("stiffness", "damping")
Sites = Mapping[str, tuple[str, Pose]]


def cord(draft: Draft, tendon: Element, forces: Sequence[str], *, sites: Sites, sprung: bool) -> None:
    """Enter what a tendon in space does.

    Args:
        draft: with the sites as points.
        tendon: with the attributes of its class.
        forces: attributes of it that act.
        sites: name -> (body, pose) in the file's own pose.
        sprung: whether joints are there where their springs rest, which says how long a tendon is without springlength.
    """
    where = label(tendon)
    straight = all(part.tag == "site" for part in elements(tendon))
    for key in forces:
        if not straight:
            draft.ledger.lost(f"{key} of a tendon in space, around geoms or by pulleys")
        elif key not in HELD:
            draft.ledger.lost(f"{key} of a tendon in space")
        elif any(numbers(tendon.attrib[key], f"{where}, {key}")[1:]):
            draft.ledger.lost(f"powers of {key} of a tendon above the first")
    kept = {key: float(numbers(tendon.attrib[key], where)[0]) for key in forces if key in HELD and straight}
    if not kept:
        return
    names = [attribute(part, "site") for part in elements(tendon)]
    for name in names:
        if name not in sites:
            raise DescriptionError(f"{where}: there is no site {shorten(name)}; {did_you_mean(name, sites)}")
    if len(names) < 2:
        raise DescriptionError(f"{where}: expected at least two sites, got {len(names)}")
    if len({sites[name][0] for name in names}) == 1:
        draft.ledger.passed("tendons in space within one body")
        return
    table: dict[str, Any] = {"start": names[0], "end": names[-1], "through": names[1:-1], **kept}
    if "stiffness" in kept:
        ends = [real(v) for v in numbers(tendon.get("springlength", "-1"), f"{where}, springlength")]
        if ends[0] == -1 and not sprung:
            draft.ledger.lost("stiffness of a tendon in space that has its length where joints with springref rest")
            return
        if ends[0] == -1:
            places = [sites[name][1].translation for name in names]
            ends = [sum((length(minus(b, a)) for a, b in pairwise(places)), start=real(0))]
        table["length"] = float(ends[-1])
        if ends[0] != ends[-1]:
            table["shortest"] = float(ends[0])
    draft.cords.append(table)
    draft.ledger.turned("tendon in space: a spring and damper over its sites")


def add_cord(root: Element, force: Mapping[str, Any]) -> None:
    """Write a cord into an MJCF; its points are sites there."""
    section = root.find("tendon")
    section = SubElement(root, "tendon") if section is None else section
    made = SubElement(section, "spatial")
    for key in HELD:
        if force.get(key):
            made.set(key, decimals([force[key]]))
    if force.get("stiffness"):
        upper = force.get("length", 0.0)
        made.set("springlength", decimals([force.get("shortest", upper), upper]))
    for name in (force["start"], *force.get("through", ()), force["end"]):
        SubElement(made, "site", site=str(name))
