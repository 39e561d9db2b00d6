"""`<attach>` without `model`: a body or frame of the model itself once more, with what refers to it.

    <attach body="leg" prefix="left_">   the body as it stands above, below it; names in it get the prefix

Joints and equalities, tendons and actuators that name nothing but what is copied come along, under prefixed names. What
has no class of its own keeps the one that it had where it stands.

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#body-attach; the engine reads from top to bottom, so
that what is attached stands above.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import deepcopy

from symscrew.errors import DescriptionError, shorten
from symscrew.formats.safe_xml import Element, elements, label

KINDS = {
    **dict.fromkeys(("joint", "joint1", "joint2", "jointinparent"), "joint"),
    **dict.fromkeys(("body", "body1", "body2"), "body"),
    **dict.fromkeys(("site", "site1", "site2", "refsite", "slidersite", "cranksite", "sidesite"), "site"),
    **dict.fromkeys(("geom", "geom1", "geom2"), "geom"),
    **dict.fromkeys(("tendon", "tendon1", "tendon2"), "tendon"),
}
"""Attribute that refers to a name -> of what kind that is."""
OF_KIND = {"freejoint": "joint", "fixed": "tendon", "spatial": "tendon"}
"""Tag -> kind of its name, where these differ."""
Names = set[tuple[str, str]]


def own_part(attach: Element, root: Element, wanted: str, kind: str, *, main: str) -> tuple[Element, list[Element]]:
    """(the part, copies of sections with what refers to it) of an <attach> without a model.

    Args:
        attach: the element.
        root: of the model as the file has it.
        wanted: name of the part.
        kind: "body" or "frame".
        main: what the model's main class is called.

    Raises:
        DescriptionError: it does not stand above, it has the <attach> in it, or a tendon goes out of it.
    """
    found = next(
        (pair for world in elements(root, "worldbody") for pair in _above(world, attach, None)
         if pair[0].tag == kind and pair[0].get("name") == wanted), None,
    )  # fmt: skip
    if found is None or any(inner is attach for inner in found[0].iter()):
        raise DescriptionError(
            f"<attach>: expected a {kind} of the model itself that ends above this element, got {shorten(wanted)}"
        )
    element, inherited = found
    if any(True for _ in element.iter("attach")):
        raise DescriptionError(f"<attach>: the {kind} {shorten(wanted)} has an <attach> in it; put what it names there")
    names = {(OF_KIND.get(e.tag, e.tag), e.attrib["name"]) for e in element.iter() if "name" in e.attrib}
    prefix = attach.get("prefix", "")
    part = _renamed(element, names, prefix)
    part.set("childclass", element.get("childclass") or inherited or main)
    sections = []
    for section in elements(root, "tendon", "equality", "actuator"):  # tendons first: others refer to them
        kept = Element(section.tag, section.attrib)
        for child in elements(section):
            refers = [(KINDS[key], e.attrib[key]) in names for e in child.iter() for key in KINDS if key in e.attrib]
            if not all(refers) and any(refers) and section.tag == "tendon":
                raise DescriptionError(f"<attach>: {label(child)} goes out of the {kind} {shorten(wanted)}")
            if refers and all(refers):
                if "name" in child.attrib:
                    names.add((OF_KIND.get(child.tag, section.tag), child.attrib["name"]))
                kept.append(_renamed(child, names, prefix))
        sections.append(kept)
    return part, sections


def _above(element: Element, attach: Element, inherited: str | None) -> Iterator[tuple[Element, str | None]]:
    """Bodies and frames before an element, in the order of the file, each with the class that it inherits."""
    for child in element:
        if child is attach:
            return
        if child.tag in ("body", "frame"):
            yield child, inherited
            yield from _above(child, attach, child.get("childclass") or inherited)
            if any(inner is attach for inner in child.iter()):
                return


def _renamed(element: Element, names: Names, prefix: str) -> Element:
    """A copy with the prefix before its names, and before those that it refers to."""
    made = deepcopy(element)
    for part in made.iter():
        for key in KINDS:
            if (KINDS[key], part.get(key, "")) in names:
                part.set(key, f"{prefix}{part.attrib[key]}")
        if "name" in part.attrib:
            part.set("name", f"{prefix}{part.attrib['name']}")
    return made
