"""A mechanism from an MJCF (MuJoCo) file: bodies, joints, loops, couplings, forces.

Read: hinge, slide, ball and free joints, several in a body; default classes, frames, all orientations, included files,
replicated elements, attached models;
inertial elements and the inertias of boxes, spheres, capsules, cylinders, ellipsoids and meshes, as compiler settings
inertiafromgeom and inertiagrouprange want it; equality connect and weld, of bodies or sites, joint and fixed tendon;
actuators on joints, whose joints are driven. Armature, damping, friction, springs, servos and limits become effects and
limits beside the mechanism. Everything else is in the draft's ledger, or refused by name.

    <worldbody> --mjcf_bodies--> bodies, joints, sites;   <equality> --mjcf_loops, mjcf_couplings--> loops, couplings

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from pathlib import Path

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft
from symscrew.formats.exact_digits import with_exact_digits
from symscrew.formats.import_options import ImportOptions
from symscrew.formats.included_files import expanded
from symscrew.formats.mjcf_actuators import Actuators, actuator_forces
from symscrew.formats.mjcf_bodies import Place, Reading, of_world, read_children, round_geom
from symscrew.formats.mjcf_closing import where_they_close
from symscrew.formats.mjcf_composed import composed
from symscrew.formats.mjcf_cords import Ways, cord
from symscrew.formats.mjcf_couplings import displacements, raw_coupling, read_couplings
from symscrew.formats.mjcf_inertias import OwnInertia
from symscrew.formats.mjcf_keyframes import key_name, keyframe_rates, keyframes
from symscrew.formats.mjcf_loops import Placed, body_ties, idle_equalities, loops
from symscrew.formats.mjcf_masses import settle_masses
from symscrew.formats.mjcf_medium import add_drags, medium
from symscrew.formats.mjcf_rotors import rotors
from symscrew.formats.mjcf_settings import FIXED, ORIENTATIONS
from symscrew.formats.mjcf_transmissions import Transmissions, add_pulleys, tendon_forces, transmissions
from symscrew.formats.mjcf_weights import carry
from symscrew.formats.near_words import note_near_words
from symscrew.formats.open_loops import Closing
from symscrew.formats.rigid_displacements import ZERO, Pose, Real, length, minus, real
from symscrew.formats.safe_xml import Element, attribute, check_attributes, elements, label, number, numbers

# elements of MJCF that are read, that hold no mechanics, and that do but are left out; others are refused by name
SECTIONS = ("compiler", "option", "default", "worldbody", "equality", "actuator", "tendon", "keyframe")
WITHOUT_MECHANICS = ("size", "visual", "statistic", "custom", "asset", "contact", "sensor")
WITH_INFLUENCE = ("deformable", "extension")
PASSIVE_PLUGINS = ("mujoco.sensor.", "mujoco.sdf.")
"""Plugins that make sensors and shapes; of a body that takes its inertia from such a shape the geom is refused."""
WORDS = {
    "mesh": (
        "name", "class", "file", "vertex", "face", "refpos", "refquat", "scale", "inertia", "maxhullvert",
    ),
    "text": ("name", "data"),
}  # fmt: skip
"""Attributes that are read of elements whose others are left out, for those that are nearly one of these."""
PARTS = {"asset": ("mesh", "hfield", "model"), "custom": ("text",), "default": ("default", "mesh", "tendon")}
WORLD = "world"


def read_mjcf(root: Element, path: Path, options: ImportOptions) -> Draft:
    """What a <mujoco> says; raises DescriptionError for what a mechanism cannot hold.

    Args:
        root: the file's root element.
        path: of the file: its name is in the mechanism's `source`, files that it names are looked for in its folder.
        options: what else is accepted.
    """
    root = expanded(root, path, options.folder)
    check_attributes(root, ("model",))
    model = root.get("model") or "mujoco_model"
    texts = {t.get("name"): t.get("data") or "" for c in elements(root, "custom") for t in elements(c, "text")}
    ground = texts.get("symscrew_ground", WORLD)
    result = Draft(model, ground, f"imported from the MJCF {path.name}", texts.get("symscrew_description", ""))

    def prepared(given: Element) -> Element:
        _check_sections(given, result)
        _check_orientations(given)
        return with_exact_digits(given, result.ledger) if options.exact else given

    whole = composed(root, path, result, prepared, within=options.folder)
    root, (chosen, meshes) = whole.root, whole.parts[0]
    _check_names(root)
    if "symscrew_characteristic_length" in texts:
        result.characteristic_length = real(number(texts["symscrew_characteristic_length"], "<custom>, length"))
    ties, around = read_couplings(root, chosen, result.ledger), medium(root) if chosen.passive else None
    pulled = transmissions(root, chosen, ties)
    actuators = Actuators.of(root, chosen, pulled, result)
    reading = Reading(
        chosen,
        {next(iter(tied.first)): tied for tied in ties if tied.screw and not tied.powers[0]},
        actuators.driven(),
        result,
        meshes,
        displaced=displacements(ties),
        parts=whole.parts,
        in_medium=around is not None,
        given=frozenset(e.get("name", "") for tag in ("body", "joint", "freejoint") for e in root.iter(tag)),
        fixed={name.removeprefix(FIXED): own for name, own in texts.items() if name and name.startswith(FIXED) and own},
    )
    _read_bodies(root, reading)
    settle_masses(result, chosen, reading.bare)
    listed = any(True for section in elements(root, "actuator") for _ in elements(section))
    actuated = listed and "actuation" not in chosen.off
    carry(result, reading.carried if chosen.passive else {}, reading.borne, actuated=actuated)
    add_drags(result, around)
    own_pose = _in_own_pose(root, reading)
    _read_forces(reading, own_pose, actuators, pulled)
    placed = Placed(reading.poses, reading.sites, ground, own_pose.poses)
    _add_loops(root, reading, placed, Closing(result.ledger, _extent(result), options.snap), coupled=bool(ties))
    own = {joint: value - reading.displaced.get(joint, ZERO[0]) for joint, value in reading.values.items()}
    result.couplings += [raw_coupling(t, own) for t in ties if next(iter(t.first)) not in reading.made_screws]
    add_pulleys(result, pulled, reading.values, reading.driven)
    idle = idle_equalities(root, chosen)
    if idle:
        result.ledger.passed("equality constraints that are not active", idle)
    result.configurations = _keyframes(root, reading)
    result.starts = keyframes(root, reading.listed, own)
    result.start_rates = keyframe_rates(root, reading.listed)
    platform = texts.get("symscrew_platform")
    parents = {joint.parent for joint in result.joints}
    tips = [body.name for body in result.bodies if body.name not in parents]
    chain = len(tips) == 1 and len(result.joints) == len(result.bodies)
    result.platform = platform if platform in reading.poses else (tips[0] if chain else None)
    return result


def _add_loops(root: Element, reading: Reading, placed: Placed, closing: Closing, *, coupled: bool) -> None:
    """The joints that close loops; where these are open in the file's pose, and no joints are coupled, others move."""
    result, chosen = reading.result, reading.settings
    found = body_ties(root, chosen, placed)
    if not coupled and any(closing.is_open(tie.gap) for tie in found):
        placed = where_they_close(result, found, placed)
        found = body_ties(root, chosen, placed)
        reading.values |= {joint.name: joint.reference[0] for joint in result.joints if joint.name in reading.values}
    result.joints += loops(found, closing, placed, [joint.name for joint in result.joints])


def _read_forces(reading: Reading, own: Reading, actuators: Actuators, pulled: Transmissions) -> None:
    """What tendons and actuators do; `own`: the tree in the file's own configuration."""
    result, chosen = reading.result, reading.settings
    _check_all_found(reading, pulled.pulleys.values())
    sprung = all(own.values[name] == rest for name, rest in reading.rests.items() if name in own.values)
    ways = Ways(result, own.sites, {name: partial(round_geom, *found) for name, found in reading.geoms.items()})
    over = partial(cord, ways=ways, sprung=sprung)
    tendon_forces(result, pulled, reading.rests, chosen.off, cord=over)
    rotors(result, [*actuators.listed, *actuators.idle], pulled, chosen.off)
    inertia = OwnInertia(replace(own.result, effects=result.effects), pulled)
    inertia.enter_springs(result, reading.timed, chosen.off)
    actuator_forces(result, actuators, chosen, reading.sites, inertia=inertia, listed=reading.listed, ways=ways)


def _read_bodies(root: Element, reading: Reading) -> None:
    ground = reading.result.ground
    reading.poses[ground] = Pose()
    for world in elements(root, "worldbody"):
        check_attributes(world, ("name", "childclass"))
        for child in elements(world, "joint", "freejoint", "inertial"):
            raise DescriptionError(
                f"<worldbody>: the world stands still and has no <{child.tag}>; put it into a <body>"
            )
        of_world(reading, world)
        read_children(reading, world, Place(ground, Pose(), world.get("childclass")))


def _in_own_pose(root: Element, reading: Reading) -> Reading:
    """Bodies and joints as the file has them, before couplings displace them or make one joint of two."""
    if not any(reading.displaced.values()) and not reading.made_screws:
        return reading
    given = reading.result
    aside = Draft(given.name, given.ground, given.origin, gravity=given.gravity)
    own = Reading(reading.settings, {}, reading.driven, aside, reading.meshes, parts=reading.parts, given=reading.given)
    _read_bodies(root, own)
    settle_masses(aside, reading.settings, own.bare)
    return own


def _check_sections(root: Element, result: Draft) -> None:
    note_near_words(root, result.ledger, attributes=WORDS, children=PARTS)
    for stray in list(elements(root, "body", "frame")):  # the engine takes the file without them
        result.ledger.changed.append(f"{label(stray)} outside <worldbody>: left out, as MuJoCo leaves it out")
        root.remove(stray)
    for child in elements(root):
        if child.tag in WITHOUT_MECHANICS and len(child):
            if child.tag != "custom":
                result.ledger.passed(f"<{child.tag}>")
        elif child.tag in WITH_INFLUENCE and len(child):
            named = [plugin.get("plugin", "") for plugin in child.iter("plugin")]
            harmless = child.tag == "extension" and all(name.startswith(PASSIVE_PLUGINS) for name in named)
            harmless = harmless or all(part.tag == "skin" for part in elements(child))
            (result.ledger.passed if harmless else result.ledger.lost)(f"<{child.tag}>")
        elif child.tag not in (*SECTIONS, *WITHOUT_MECHANICS) and (len(child) or child.attrib):
            raise DescriptionError(f"<{child.tag}>: this element of MJCF is not supported; remove it")


def _check_orientations(root: Element) -> None:
    """Refuse what says twice how an element is turned, as MuJoCo does; of a class it may be overridden."""
    for element in root.iter():
        given = [key for key in ("quat", *ORIENTATIONS) if key in element.attrib]
        if len(given) > 1:
            raise DescriptionError(f"{label(element)}: expected one orientation, got {' and '.join(given)}")


def _check_names(root: Element) -> None:
    """Refuse names that two elements of a section have, of which a reference could mean either."""
    for section in ("tendon", "equality", "actuator", "keyframe", "asset"):
        seen: set[tuple[str, str]] = set()
        for element in (e for part in elements(root, section) for e in elements(part)):
            one = (element.tag if section == "asset" else section, element.get("name", ""))
            if one[1] and one in seen:
                raise DescriptionError(f"{label(element)}: two elements of <{section}> have this name")
            seen.add(one)


def _check_all_found(reading: Reading, pulleys: Iterable[str]) -> None:
    names = {joint.name for joint in reading.result.joints} | reading.seen | set(pulleys)
    for name in reading.driven:
        if name not in names:
            raise DescriptionError(f"<actuator>: there is no joint {shorten(name)}; {did_you_mean(name, names)}")


def _extent(result: Draft) -> Real:
    """How far the joints' points are apart [m]."""
    points = [joint.point for joint in result.joints]
    return max((length(minus(point, points[0])) for point in points), default=ZERO[0])


def _keyframes(root: Element, reading: Reading) -> dict[str, tuple[Real, ...]]:
    """Name -> qpos of the file's keyframes, as MuJoCo orders coordinates; for people, and for starts of scenes."""
    found: dict[str, tuple[Real, ...]] = {}
    for section in elements(root, "keyframe"):
        for k, key in enumerate(elements(section, "key")):
            for left in sorted({"act", "ctrl", "mpos", "mquat", "time"} & set(key.attrib)):
                reading.result.ledger.passed(f"{left} of keyframes")
            if "qpos" in key.attrib:
                found[key_name(key, k)] = tuple(real(v) for v in numbers(attribute(key, "qpos"), f"{label(key)}, qpos"))
    if found:
        reading.result.ledger.turned("keyframes: configurations", len(found))
    return found
