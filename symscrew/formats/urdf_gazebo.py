"""What <gazebo> elements say of the mechanics of a URDF's links and joints; pictures, contacts and plugins say nothing.

    springStiffness, springReference of a joint --> joint spring
    turnGravityOff, gravity, dampingFactor, kinematic of a link --> said: here gravity acts, and nothing damps

Source: https://classic.gazebosim.org/tutorials?tut=ros_urdf.
"""

from __future__ import annotations

from collections.abc import Mapping

from symscrew.formats.draft import Draft, RawEffect
from symscrew.formats.safe_xml import Element, elements, number
from symscrew.formats.urdf_forces import MOVING

YES = ("true", "1")
NO = ("false", "0")


def gazebo_forces(draft: Draft, root: Element, joints: Mapping[str, Element]) -> None:
    """Enter springs of joints; what a link alone has in that simulator is in the ledger."""
    weightless, damped, held = set[str](), set[str](), set[str]()
    for section in elements(root, "gazebo"):
        name = section.get("reference", "")
        said = {child.tag: (child.get("value") or child.text or "").strip() for child in elements(section)}
        if said.get("turnGravityOff") in YES or said.get("gravity") in NO:
            weightless.add(name)
        if _size(said, "dampingFactor", name):
            damped.add(name)
        if said.get("kinematic") in YES:
            held.add(name)
        _spring(draft, name, said, joints)
    for links, what in (
        (weightless, "gravity acts on {}, from which <gazebo> takes it"),
        (damped, "nothing damps {}, to which <gazebo> gives a dampingFactor"),
        (held, "forces move {}, which <gazebo> calls kinematic"),
    ):
        if links:
            listed = sorted(links)
            more = f" and {len(listed) - 3} more links" if len(listed) > 3 else ""
            draft.ledger.changed.append(what.format(", ".join(listed[:3]) + more))


def _spring(draft: Draft, name: str, said: Mapping[str, str], joints: Mapping[str, Element]) -> None:
    stiffness = _size(said, "springStiffness", name)
    if stiffness == 0:
        return
    if name not in joints or joints[name].get("type") not in MOVING:
        draft.ledger.lost("springStiffness in <gazebo>, of no joint with one freedom")
        return
    rest = _size(said, "springReference", name)
    draft.effects.append(RawEffect(name, {"kind": "spring", "stiffness": stiffness, "rest": rest}))
    draft.ledger.turned("springs of joints in <gazebo>")


def _size(said: Mapping[str, str], key: str, name: str) -> float:
    """A number of the section; 0 where it says none."""
    text = said.get(key, "")
    return float(number(text, f"<gazebo reference={name!r}>, {key}")) if text else 0.0
