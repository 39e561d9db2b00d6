"""MJCF files that are made of parts: `<replicate>` of elements and `<attach>` of other models, put in their places.

    <replicate count offset euler sep>   count frames, the k-th turned by k times the angles, and the next one offset
                                         from there in its axes; names get sep and a number
    <attach model body prefix>           the body (or with `frame` what is in that, at its place), or all of the model's
                                         world; names and classes get the prefix; without a model `mjcf_own_parts`

What refers to a name of a part in <equality>, <tendon> and <actuator> is repeated or comes along with it. A model that
is attached keeps its own units and default classes; its options, keyframes and sensors stay behind.

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html, elements replicate and attach.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from copy import copy, deepcopy
from dataclasses import dataclass, replace
from pathlib import Path

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft
from symscrew.formats.included_files import DEEPEST, MOST_FILES, expanded, inside
from symscrew.formats.mesh_inertias import Meshes
from symscrew.formats.mjcf_own_parts import own_part
from symscrew.formats.mjcf_settings import Attributes, Settings, settings
from symscrew.formats.rigid_displacements import CONTEXT, ZERO, Pose, to_quaternion, triple
from symscrew.formats.safe_xml import (
    MAX_ELEMENTS,
    Element,
    attribute,
    check_attributes,
    elements,
    label,
    number,
    numbers,
    read,
)

ATTACHED = "#attached"
"""Tag of what stands for an attached model among bodies, which no file can have: its `part` says which model."""
REFERENCES = (
    "joint", "joint1", "joint2", "jointinparent", "body", "body1", "body2", "site", "site1", "site2", "refsite",
    "slidersite", "cranksite", "sidesite", "geom", "geom1", "geom2", "tendon", "tendon1", "tendon2", "mesh", "hfield",
)  # fmt: skip
REFERRING = ("equality", "tendon", "actuator")
TAKEN = ("worldbody", "asset", "default", "compiler", *REFERRING)
"""Sections of a model that is attached; of its assets only meshes matter, for inertias."""
LEFT = ("keyframe", "option", "custom", "sensor", "contact")
REPLICATE = ("count", "offset", "euler", "sep")
MOST_COPIES = 10_000
"""Of one element: a file of a few lines must not fill the memory; those that people write have some hundred."""
WORLD = "world"


@dataclass(frozen=True)
class Composed:
    """The root element without `<replicate>` and `<attach>`, and units, classes and meshes of every model in it.

    The first is the file's own; an element with the tag `ATTACHED` has the index of its model as `part`.
    """

    root: Element
    parts: tuple[tuple[Settings, Meshes], ...]


def composed(
    root: Element, path: Path, draft: Draft, prepare: Callable[[Element], Element], *, within: Path | None = None
) -> Composed:
    """A <mujoco> with everything in its place; raises DescriptionError.

    `prepare` is what the root of every file goes through before it is used; files are below `within`.
    """
    composition = _Composition(draft, prepare, within)
    made = composition.of(prepare(root), path, ())
    classes = {name: values for chosen, _ in composition.parts for name, values in chosen.defaults.items()}
    return Composed(made, tuple((replace(chosen, defaults=classes), meshes) for chosen, meshes in composition.parts))


@dataclass(frozen=True)
class _Model:
    """A model while parts are attached in it: its root as the file has it, models that it names, its file and those
    in which it is attached, and what its main class is called."""

    given: Element
    models: Mapping[str, Element]
    path: Path
    way: tuple[Path, ...]
    main: str


class _Composition:
    def __init__(self, draft: Draft, prepare: Callable[[Element], Element], within: Path | None) -> None:
        self.draft, self.prepare, self.within = draft, prepare, within
        self.parts: list[tuple[Settings, Meshes]] = []

    def of(self, root: Element, path: Path, way: tuple[Path, ...]) -> Element:
        """The root with everything in its place; its settings are added to the parts."""
        chosen = settings(root, self.draft)
        index = len(self.parts)
        if way:
            main = {f"#{index}" if name == "main" else name: values for name, values in chosen.defaults.items()}
            chosen = replace(chosen, defaults=main)
            _check_masses(chosen, path)
        known = replace(chosen, defaults={"main": {}, **chosen.defaults})
        self.parts.append((chosen, Meshes.of(root, path, known, self.within)))
        if any(True for _ in root.iter("attach")):
            found = (model for section in elements(root, "asset") for model in elements(section, "model"))
            models = {model.get("name") or self._own_name(model, path): model for model in found}
            given, root = root, copy(root)
            whole = _Model(given, models, path, (*way, path.resolve()), f"#{index}" if way else "main")
            root[:] = [self._attached(child, root, whole) for child in root]
        return replicated(root, chosen)  # what is attached inside is repeated, with what refers to it

    def _own_name(self, model: Element, path: Path) -> str:
        """What a model's own file calls it, where the one that takes it gives no name."""
        return read(inside(path.parent, attribute(model, "file"), label(model), self.within)).get("model", "")

    def _attached(self, element: Element, root: Element, whole: _Model) -> Element:
        """An element with the models that are attached below it; what comes along with them is added to the root."""
        if not any(True for _ in element.iter("attach")):
            return element
        made = copy(element)
        made[:] = []
        for child in element:
            if child.tag == "attach":
                made.append(self._part(child, root, whole))
            else:
                made.append(self._attached(child, root, whole))
        return made

    def _part(self, element: Element, root: Element, whole: _Model) -> Element:
        """What stands in the place of an <attach>."""
        check_attributes(element, ("model", "body", "frame", "prefix"))
        if "model" in element.attrib:
            return self._model(element, root, whole)
        wanted, kind = _part_of(element)
        if wanted is None:
            raise DescriptionError("<attach>: without a model, expected a body or a frame of this one")
        part, along = own_part(element, whole.given, wanted, kind, main=whole.main)
        for section in along:
            root.append(section)
        return part

    def _model(self, element: Element, root: Element, whole: _Model) -> Element:
        path, way, models, name = whole.path, whole.way, whole.models, element.attrib["model"]
        if name not in models:
            raise DescriptionError(f"<attach>: there is no <model> {shorten(name)}; {did_you_mean(name, models)}")
        file = inside(path.parent, attribute(models[name], "file"), label(models[name]), self.within)
        if file in way or len(way) > DEEPEST or len(self.parts) >= MOST_FILES:
            raise DescriptionError(f"<attach>: {file.name} attaches itself, or too many models are attached")
        given = expanded(read(file), file, self.within)
        if given.tag != "mujoco":
            raise DescriptionError(f"<attach>: {file.name}: expected the root element <mujoco>")
        for left in sorted({child.tag for child in elements(given, *LEFT)}):
            self.draft.ledger.passed(f"<{left}> of attached models")
        part = len(self.parts)
        child = self.of(_namespaced(self.prepare(given), element.get("prefix", ""), part), file, way)
        place = Element(ATTACHED, {"part": str(part), "childclass": f"#{part}"})
        wanted, kind = _part_of(element)
        for world in elements(child, "worldbody"):
            place.extend(deepcopy(e) for e in elements(world) if wanted is None)
            place.extend(
                deepcopy(e) for e in world.iter(kind) if e.get("name") == f"{element.get('prefix', '')}{wanted}"
            )
        if wanted is not None and not len(place):
            raise DescriptionError(f"<attach>: {file.name} has no {kind} {shorten(wanted)}")
        there = {e.get("name") for e in place.iter()} | {WORLD, None}
        for section in elements(child, *REFERRING):
            kept = copy(section)
            kept[:] = [e for e in elements(section) if wanted is None or _refers_to(e, child, there)]
            root.append(kept)
        return place


def _part_of(element: Element) -> tuple[str | None, str]:
    """Name and kind of the part that an <attach> takes of its model: a body or a frame; no name for all of it."""
    named = [kind for kind in ("body", "frame") if kind in element.attrib]
    if len(named) > 1:
        raise DescriptionError("<attach>: expected a body or a frame of the model, got both")
    return (element.attrib[named[0]], named[0]) if named else (None, "body")


def _check_masses(chosen: Settings, path: Path) -> None:
    if chosen.least_mass or chosen.least_inertia or chosen.balanced or chosen.total_mass > 0:
        raise DescriptionError(
            f"<attach>: {path.name}: boundmass, boundinertia, balanceinertia and settotalmass of an attached model are "
            "not supported; set them in the main one"
        )


def _refers_to(element: Element, root: Element, names: set[str | None]) -> bool:
    """Whether all that an element refers to is there, through tendons too."""
    tendons = {t.get("name"): t for section in elements(root, "tendon") for t in elements(section)}
    for part in element.iter():
        for key in REFERENCES:
            name = part.get(key)
            if key.startswith("tendon") and name in tendons:
                if not _refers_to(tendons[name], root, names):
                    return False
            elif name is not None and name not in names:
                return False
    return True


def _namespaced(root: Element, prefix: str, part: int) -> Element:
    """A model's sections with its names and classes prefixed; what has no class gets the model's own main one."""
    made = copy(root)
    made[:] = [deepcopy(section) for section in elements(root, *TAKEN)]

    def classed(name: str) -> str:
        return f"#{part}" if name == "main" else f"{prefix}{name}"

    for section in made:
        for mesh in elements(section, "mesh"):
            mesh.set("name", mesh.get("name") or Path(mesh.get("file", "")).stem)
        for element in section.iter():
            for key in ("name", *REFERENCES) if element.tag != "model" else ():
                if element.get(key) not in (None, WORLD):
                    element.set(key, f"{prefix}{element.get(key)}")
            for key in ("class", "childclass"):
                if key in element.attrib and section.tag != "default":
                    element.set(key, classed(element.attrib[key]))
        if section.tag == "default":
            for element in section.iter("default"):
                if element is not section and "class" in element.attrib:
                    element.set("class", f"{prefix}{element.attrib['class']}")
        elif section.tag != "worldbody":
            for element in elements(section):
                element.set("class", element.get("class") or f"#{part}")
    return made


def replicated(root: Element, chosen: Settings) -> Element:
    """The root with frames in the place of `<replicate>`, and with what refers to them repeated."""
    if not any(True for _ in root.iter("replicate")):
        return root
    made = copy(root)
    made[:] = [deepcopy(child) for child in root]
    for world in elements(made, "worldbody"):
        _replicate_below(world, made, chosen)
    return made


def _replicate_below(element: Element, root: Element, chosen: Settings) -> None:
    children: list[Element] = []
    for child in list(element):
        _replicate_below(child, root, chosen)
        children += _copies(child, root, chosen) if child.tag == "replicate" else [child]
    element[:] = children


def _copies(element: Element, root: Element, chosen: Settings) -> list[Element]:
    """The frames that a <replicate> stands for."""
    check_attributes(element, REPLICATE)
    count = number(attribute(element, "count"), "<replicate>, count")
    size = sum(1 for _ in element.iter())
    if count != int(count) or not 1 <= count <= MOST_COPIES:
        raise DescriptionError(f"<replicate>: expected a count from 1 to {MOST_COPIES}, got {shorten(str(count))}")
    if count * size > MAX_ELEMENTS:
        raise DescriptionError(
            f"<replicate>: expected at most {MAX_ELEMENTS} elements in all copies, got {int(count)} copies of {size}"
        )
    step = triple(numbers(element.get("offset", "0 0 0"), "<replicate>, offset", 3))
    angles = numbers(element.get("euler", "0 0 0"), "<replicate>, euler", 3)
    names = {e.get("name") for e in element.iter() if e.get("name")}
    suffixes = [f"{element.get('sep', '')}{k:0{len(str(int(count) - 1))}d}" for k in range(int(count))]
    for section in elements(root, *REFERRING):
        section[:] = [repeated for e in list(section) for repeated in _repeated(e, names, suffixes)]
    found, place = [], ZERO
    for k, suffix in enumerate(suffixes):
        turn = chosen.pose({"euler": " ".join(str(k * angle) for angle in angles)}, "<replicate>").rotation
        pose = Pose(turn, place)
        frame = Element("frame", _attributes_of(pose))
        frame.extend(_suffixed(child, names, suffix) for child in element)
        found.append(frame)
        place = pose.point(step)
    return found


def _repeated(element: Element, names: set[str | None], suffixes: list[str]) -> Iterator[Element]:
    """An element of another section once for every copy of what it refers to; names that it has itself join them."""
    if not any(part.get(key) in names for part in element.iter() for key in REFERENCES if part.get(key)):
        yield element
        return
    if element.get("name"):
        names.add(element.get("name"))
    for suffix in suffixes:
        yield _suffixed(element, names, suffix)


def _suffixed(element: Element, names: set[str | None], suffix: str) -> Element:
    made = deepcopy(element)
    for part in made.iter():
        for key in ("name", *REFERENCES):
            if part.get(key) is not None and part.get(key) in names:
                part.set(key, f"{part.get(key)}{suffix}")
    return made


def _attributes_of(pose: Pose) -> dict[str, str]:
    """A pose as the attributes of a frame, with all digits."""
    digits = CONTEXT.dps

    def text(values: object) -> str:
        return " ".join(CONTEXT.nstr(CONTEXT.mpf(value), digits) for value in values)  # type: ignore[attr-defined]

    found: Attributes = {"pos": text(pose.translation), "quat": text(to_quaternion(pose.rotation))}
    return dict(found)
