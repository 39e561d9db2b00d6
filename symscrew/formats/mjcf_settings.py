"""Settings of an MJCF file: compiler, option, default classes; and which attributes are read.

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html. Whatever is not in the tables below is
refused by name, so that nothing that changes the mechanics is passed over.
"""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from dataclasses import dataclass, field
from decimal import Decimal

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft
from symscrew.formats.mjcf_gains import OWN, alike, as_general, filled
from symscrew.formats.rigid_displacements import (
    CONTEXT,
    UNITS,
    Pose,
    Real,
    Rotation,
    Triple,
    about,
    cross,
    dot,
    from_quaternion,
    length,
    minus,
    product,
    real,
    scaled,
    snapped,
    transposed,
    triple,
    unit,
)
from symscrew.formats.safe_xml import Element, check_attributes, elements, label, number, numbers

ORIENTATIONS = ("axisangle", "xyaxes", "zaxis", "euler")
FIXED = "symscrew_fixed_"
"""Before a body's name: the custom text with the name of the joint that fixes it, for which MJCF has no element."""
PLACE = ("pos", "quat", *ORIENTATIONS)
UNSEEN = ("adhesion", "castshadow", "surfacevel")
"""Attributes of geoms that are about contacts and pictures, and that few files have: the account says so."""
READ: dict[str, tuple[str, ...]] = {
    "body": ("name", "childclass", "mocap", "gravcomp", "user", "sleep", "simple", "fuse", *PLACE),
    "frame": ("name", "childclass", *PLACE),
    "inertial": ("mass", "diaginertia", "fullinertia", *PLACE),
    "joint": (
        "name", "class", "type", "group", "pos", "axis", "springdamper", "solreflimit", "solimplimit",
        "solreffriction", "solimpfriction", "stiffness", "range", "limited", "actuatorfrcrange",
        "actuatorfrclimited", "actuatorgravcomp", "margin", "ref", "springref", "armature", "damping",
        "frictionloss", "user",
    ),
    "freejoint": ("name", "group", "align"),
    "geom": (
        "name", "class", "type", "contype", "conaffinity", "condim", "group", "priority", "size", "material",
        "friction", "mass", "density", "shellinertia", "solmix", "solref", "solimp", "margin", "gap", "fromto",
        "hfield", "mesh", "fitscale", "rgba", "fluidshape", "fluidcoef", "user", *UNSEEN, *PLACE,
    ),
    "site": ("name", "class", "type", "group", "material", "size", "fromto", "mesh", "rgba", "user", *PLACE),
    "connect": ("name", "class", "active", "solref", "solimp", "body1", "body2", "anchor", "site1", "site2"),
    "weld": (
        "name", "class", "active", "solref", "solimp", "body1", "body2", "relpose", "anchor", "site1", "site2",
        "torquescale",
    ),
    "couple": ("name", "class", "active", "solref", "solimp", "joint1", "joint2", "polycoef"),
    "tie": ("name", "class", "active", "solref", "solimp", "tendon1", "tendon2", "polycoef"),
    "equality": ("class", "active", "solref", "solimp"),
}  # fmt: skip
# attributes of <compiler>: with the values that are supported; that must be zero; that do not change the mechanics
COMPILER = {
    "angle": ("degree", "radian"), "coordinate": ("local",), "inertiafromgeom": ("false", "true", "auto"),
    "balanceinertia": ("false", "true"), "alignfree": ("false",),
}  # fmt: skip
COMPILER_MASSES = ("boundmass", "boundinertia", "settotalmass")
COMPILER_FREE = (
    "autolimits", "strippath", "meshdir", "texturedir", "assetdir", "discardvisual", "usethread", "fusestatic",
    "convexhull", "saveinertial", "savecanonical", "savecompiled", "fitaabb", "exactmeshinertia", "conflict",
)  # fmt: skip
CHECKED_DEFAULTS = ("joint", "geom", "site", "equality")
OTHER_DEFAULTS = ("tendon", "mesh")
ACTUATORS = (
    "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "general", "dcmotor", "adhesion",
)  # fmt: skip
ACTS = ("gravity", "spring", "damper", "frictionloss", "limit", "equality", "actuation", "constraint", "passive")
"""Flags of <option> that take a part of the mechanics away."""
IMPLIED = {"constraint": ("equality", "frictionloss", "limit"), "passive": ("spring", "damper")}
"""Those that take several away; the second one is of older engines."""
PASSIVE = frozenset({"spring", "damper"})
"""Where both are off, the engine leaves out the medium and what carries weights, too."""
IDLE_FLAGS = (
    "contact", "clampctrl", "diagexact", "ipc", "speculative", "warmstart", "filterparent", "refsafe", "sensor",
    "midphase", "eulerdamp", "autoreset", "nativeccd", "island", "override", "energy", "fwdinv", "invdiscrete",
    "multiccd", "sleep",
)  # fmt: skip
"""Flags that say how an engine computes, or what no mechanism here has."""
ALREADY_THERE = CONTEXT.mpf(10) ** -20
"""Sine of the angle to z below which a direction is z, or -z: it has no normal to turn about that 50 digits know."""
ACTUATOR = "actuator"
"""Under which a class holds its one actuator."""
GAINS_OF = {tag: f"{ACTUATOR} like {tag}" for tag in OWN}
"""Kind -> under which a class holds the actuator, its own or one from outside, that gives gains to this kind."""
Attributes = Mapping[str, str]


@dataclass(frozen=True)
class Settings:
    """What the file says before its bodies: units, default classes, how inertias are found.

    `off`: flags of the options by which a force does not act; `idle_groups`: of actuators that are left out;
    `fuses`: bodies without joints become parts of what carries them;
    `exact_meshes`: what older engines have in place of inertia="exact" of every mesh.
    """

    degrees: bool = True
    sequence: str = "xyz"
    from_geoms: str = "auto"
    groups: tuple[int, int] = (0, 5)
    defaults: Mapping[str, Mapping[str, Attributes]] = field(default_factory=dict)
    assets: str = "."
    auto_limits: bool = True
    fits_boxes: bool = False
    fuses: bool = False
    exact_meshes: bool = False
    least_mass: Real = 0
    least_inertia: Real = 0
    balanced: bool = False
    total_mass: Real = 0
    off: frozenset[str] = frozenset()
    idle_groups: frozenset[int] = frozenset()

    @property
    def passive(self) -> bool:
        """Whether forces act that no actuator and no constraint makes."""
        return not self.off >= PASSIVE

    def merged(self, element: Element, kind: str, inherited: str | None) -> dict[str, str]:
        """The attributes of an element over those of its class (its own, its body's, or the main one)."""
        check_attributes(element, READ[kind])
        return _over(self.defaults[self._class_of(element, inherited)].get(kind, {}), element.attrib)

    def _class_of(self, element: Element, inherited: str | None) -> str:
        name = element.get("class") or inherited or "main"
        if name not in self.defaults:
            raise DescriptionError(
                f"{label(element)}: no default class {shorten(name)}; {did_you_mean(name, self.defaults)}"
            )
        return name

    def actuator(self, element: Element) -> dict[str, str]:
        """The attributes of an actuator over those of its class, as those of a general one (`mjcf_gains`)."""
        name = self._class_of(element, None)
        return _actuator(self.defaults[name], element)

    def with_defaults(self, element: Element, kind: str) -> Element:
        """An element, a tendon or a mesh, with the attributes of its class; none of them is refused."""
        whole = copy(element)
        whole.attrib = _over(self.defaults.get(element.get("class") or "main", {}).get(kind, {}), element.attrib)
        return whole

    def angle(self, value: Decimal) -> Real:
        """An angle of the file [rad]; whole degrees that have round sines give these."""
        return real(value) * CONTEXT.pi / 180 if self.degrees else real(value)

    def pose(self, attributes: Attributes, where: str) -> Pose:
        """The pose that pos, quat, axisangle, xyaxes, zaxis and euler give."""
        place = triple(numbers(attributes.get("pos", "0 0 0"), f"{where}, pos", 3))
        given = [key for key in ORIENTATIONS if key in attributes]
        if len(given) > 1:
            raise DescriptionError(f"{where}: expected one orientation, got {' and '.join(given)}")
        return Pose(self._rotation(attributes, given[0] if given else "quat", where), place)

    def _rotation(self, attributes: Attributes, key: str, where: str) -> Rotation:
        if key not in attributes:
            return UNITS
        where, text = f"{where}, {key}", attributes[key]
        if key == "quat":
            return from_quaternion([real(v) for v in numbers(text, where, 4)], where)
        if key == "axisangle":
            *axis, angle = numbers(text, where, 4)
            return about(unit(triple(axis), where), self.angle(angle))
        if key == "zaxis":
            return turn_to(triple(numbers(text, where, 3)), where)
        if key == "xyaxes":
            given = numbers(text, where, 6)
            x_axis = unit(triple(given[:3]), where)
            y_given = triple(given[3:])
            y_axis = unit(minus(y_given, scaled(x_axis, dot(x_axis, y_given))), where)
            return snapped(transposed((x_axis, y_axis, cross(x_axis, y_axis))))
        rotation = UNITS
        for letter, angle in zip(self.sequence, numbers(text, where, 3), strict=True):
            turn = about(UNITS["xyz".index(letter.lower())], self.angle(angle))
            rotation = product(rotation, turn) if letter.islower() else product(turn, rotation)
        return rotation


def turn_to(direction: Triple, where: str) -> Rotation:
    """The shortest rotation that takes z to a direction (about x where it is -z)."""
    goal = unit(direction, where)
    normal = cross(UNITS[2], goal)
    if length(normal) < ALREADY_THERE:
        return UNITS if goal[2] > 0 else about(UNITS[0], CONTEXT.pi)
    sine = length(normal)  # it may be as small as rounding: `unit` would refuse it
    return about(scaled(normal, 1 / sine), CONTEXT.atan2(sine, goal[2]))


def settings(root: Element, draft: Draft) -> Settings:
    """Settings of a <mujoco>; what of them a mechanism does not hold goes to the draft. Raises DescriptionError."""
    given: dict[str, str] = {}
    for compiler in elements(root, "compiler"):
        _check_compiler(compiler)
        given |= compiler.attrib
    sequence = given.get("eulerseq", "xyz")
    if len(sequence) != 3 or any(letter not in "xyzXYZ" for letter in sequence):
        raise DescriptionError(f"<compiler>: expected an eulerseq of three of xyzXYZ, got {shorten(sequence)}")
    first, last = (int(n) for n in numbers(given.get("inertiagrouprange", "0 5"), "<compiler>, inertiagrouprange", 2))
    found: dict[str, dict[str, dict[str, str]]] = {"main": {}}
    for default in elements(root, "default"):
        _read_defaults(default, found, None)
    off, groups = _options(root, draft)
    return Settings(
        degrees=given.get("angle", "degree") == "degree",
        sequence=sequence,
        from_geoms=given.get("inertiafromgeom", "auto"),
        groups=(first, last),
        defaults=found,
        assets=given.get("meshdir") or given.get("assetdir") or ".",
        auto_limits=given.get("autolimits", "true") == "true",
        fits_boxes=given.get("fitaabb", "false") == "true",
        fuses=given.get("fusestatic", "false") == "true",
        exact_meshes=given.get("exactmeshinertia", "false") == "true",
        least_mass=real(given.get("boundmass", "0")),
        least_inertia=real(given.get("boundinertia", "0")),
        balanced=given.get("balanceinertia", "false") == "true",
        total_mass=real(given.get("settotalmass", "-1")),
        off=off,
        idle_groups=groups,
    )


def _check_compiler(compiler: Element) -> None:
    known = (*COMPILER, *COMPILER_MASSES, *COMPILER_FREE, "eulerseq", "inertiagrouprange")
    check_attributes(compiler, known)
    for key, value in compiler.attrib.items():
        if key in COMPILER and value not in COMPILER[key]:
            raise DescriptionError(f"<compiler>: {key}={shorten(value)} is not supported; {' or '.join(COMPILER[key])}")
        if key in COMPILER_MASSES:
            number(value, f"<compiler>, {key}")
    for child in elements(compiler):
        if child.tag != "lengthrange":
            raise DescriptionError(f"<compiler>: the element <{child.tag}> is not supported")


def _read_defaults(default: Element, found: dict[str, dict[str, dict[str, str]]], above: str | None) -> None:
    """Enter a class and those inside it, each with what it inherits."""
    name = default.get("class") or ("main" if above is None else None)
    if name is None:
        raise DescriptionError("<default>: a default inside another needs a class")
    if above is None and name != "main":
        raise DescriptionError(
            f"<default class={shorten(name)}>: the outermost default is of the class 'main'; put {shorten(name)} inside"
        )
    if name in found and above is not None:
        raise DescriptionError(f"<default>: there are two classes {shorten(name)}; each needs a name of its own")
    values = {kind: dict(attributes) for kind, attributes in found[above or "main"].items()}
    for child in elements(default):
        if child.tag in CHECKED_DEFAULTS:
            check_attributes(child, READ[child.tag], f"<default class={shorten(name)}>, <{child.tag}>")
        if child.tag in (*CHECKED_DEFAULTS, *OTHER_DEFAULTS):
            values[child.tag] = _over(values.get(child.tag, {}), child.attrib)
        elif child.tag in ACTUATORS:
            values[ACTUATOR] = _actuator(values, child)
    held = values.get(ACTUATOR, {})
    values |= {key: held for tag, key in GAINS_OF.items() if alike(held, tag)}
    found[name] = values
    for child in elements(default, "default"):
        _read_defaults(child, found, name)


def _actuator(values: Mapping[str, Attributes], element: Element) -> dict[str, str]:
    """An actuator of a class or with one: `values`, kind of element -> attributes, are what it has from there."""
    outer = values.get(GAINS_OF.get(element.tag, ""), {})
    return as_general(values.get(ACTUATOR, {}), element.tag, element.attrib, outer)


def _over(base: Attributes, own: Attributes) -> dict[str, str]:
    """Attributes over those of a class; an own orientation of whatever form is in the place of the class's."""
    turned = [key for key in ("quat", *ORIENTATIONS) if key in own]
    kept = {key: value for key, value in base.items() if not turned or key not in ("quat", *ORIENTATIONS)}
    return {**kept, **own, **filled(kept, own)}


def _options(root: Element, draft: Draft) -> tuple[frozenset[str], frozenset[int]]:
    """Flags that are off and groups of actuators that are; the draft gets what the options do to the mechanics.

    The medium is in `mjcf_medium`.
    """
    flags: dict[str, str] = {}
    groups: frozenset[int] = frozenset()
    for option in elements(root, "option"):
        if "gravity" in option.attrib:
            x, y, z = map(str, numbers(option.attrib["gravity"], "<option>, gravity", 3))
            draft.gravity = (x, y, z)
        listed = numbers(option.get("actuatorgroupdisable", ""), "<option>, actuatorgroupdisable")
        groups = frozenset(map(int, listed)) if "actuatorgroupdisable" in option.attrib else groups
        for flag in elements(option, "flag"):
            check_attributes(flag, (*ACTS, *IDLE_FLAGS), "<flag>")
            flags |= flag.attrib
    for key, value in flags.items():
        if value not in ("enable", "disable"):
            raise DescriptionError(f"<flag>: expected {key}='enable' or 'disable', got {shorten(value)}")
    named = [key for key in ACTS if flags.get(key) == "disable"]
    off = frozenset(one for key in named for one in (key, *IMPLIED.get(key, ())))
    if "gravity" in off:
        draft.gravity = ("0", "0", "0")
    if draft.gravity is not None and numbers(" ".join(draft.gravity), "") == numbers("0 0 -9.81", ""):
        draft.gravity = None
    if draft.gravity is not None:
        draft.ledger.turned("gravity")
    return off, groups
