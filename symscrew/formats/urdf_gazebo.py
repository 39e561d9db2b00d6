"""What <gazebo> and <mujoco> elements say of the mechanics of a URDF: springs are taken, other things are said.

    springStiffness, springReference of a joint --> joint spring
    turnGravityOff, gravity, dampingFactor, kinematic of a link --> said: here gravity acts, and nothing damps
    static of the model, plugins that push bodies, MuJoCo's weights and medium --> said

Source: https://classic.gazebosim.org/tutorials?tut=ros_urdf, and MuJoCo's "URDF extensions".
"""

from __future__ import annotations

from collections.abc import Mapping

from symscrew.errors import shorten
from symscrew.formats.draft import Draft, RawEffect
from symscrew.formats.safe_xml import Element, elements, number
from symscrew.formats.urdf_forces import MOVING

PUSHING = ("liftdrag", "buoyancy", "hydrodynamics")
"""Plugins that push bodies, by their names in small letters without marks; others control, sense or show."""
IN_MUJOCO = ("boundmass", "boundinertia", "settotalmass", "inertiafromgeom", "gravity", "density", "viscosity", "wind")
"""Settings of MuJoCo that change masses and forces; those that mend inertias meet one that is refused here."""
YES = ("true", "1")
NO = ("false", "0")


def gazebo_forces(draft: Draft, root: Element, joints: Mapping[str, Element]) -> None:
    """Enter springs of joints; what a link alone has in that simulator is in the ledger."""
    weightless, damped, held, heavy = set[str](), set[str](), set[str](), set[str]()
    for section in elements(root, "gazebo"):
        name = section.get("reference", "")
        said = {child.tag: (child.get("value") or child.text or "").strip() for child in elements(section)}
        if said.get("turnGravityOff") in YES or said.get("gravity") in NO:
            weightless.add(name)
        if _size(said, "dampingFactor", name):
            damped.add(name)
        if said.get("kinematic") in YES:
            held.add(name)
        if "inertial" in said:
            heavy.add(name)
        if said.get("static") in YES:
            draft.ledger.changed.append("the robot moves, which <gazebo> calls static")
        for plugin in elements(section, "plugin"):
            names = [plugin.get(key, "") for key in ("name", "filename")]
            if any(word in "".join(filter(str.isalpha, name)).lower() for word in PUSHING for name in names):
                draft.ledger.changed.append(f"no forces of the plugin {shorten(names[0])} in <gazebo> act")
        _spring(draft, name, said, joints)
    for links, what in (
        (weightless, "gravity acts on {}, from which <gazebo> takes it"),
        (damped, "nothing damps {}, to which <gazebo> gives a dampingFactor"),
        (held, "forces move {}, which <gazebo> calls kinematic"),
        (heavy, "{} has the inertia of its <link>, not that of <gazebo>"),
    ):
        if links:
            listed = sorted(name or "the robot" for name in links)
            more = f" and {len(listed) - 3} more links" if len(listed) > 3 else ""
            draft.ledger.changed.append(what.format(", ".join(listed[:3]) + more))


def mujoco_settings(draft: Draft, root: Element) -> None:
    """Say which of MuJoCo's own settings in a URDF change its masses and forces and not ours."""
    parts = [part for section in elements(root, "mujoco") for part in elements(section, "compiler", "option")]
    named = [key for part in parts for key in IN_MUJOCO if part.get(key) not in (None, "auto", "0")]
    if named:
        draft.ledger.changed.append(f"MuJoCo's own {', '.join(named)} in <mujoco> is not taken")


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
