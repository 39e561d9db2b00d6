"""Loops of a URDF, which is a tree: in the forms that people have found.

    <loop> of URDF+, <loop_joint>, <gazebo><joint>, <drake:ball_constraint>, robot.yaml beside robot.urdf (Gepetto)
    --> joints that close loops

- URDF+: `<loop name type><predecessor link><origin/></predecessor><successor link><origin/></successor><axis/></loop>`.
- SDF, inside `<gazebo>`: `<joint type><parent>link</parent><child>link</child><pose/><axis><xyz/></axis></joint>`, with
  the links where they are: its frame is the child's, displaced by `pose`, or that of the link `relative_to`. A screw's
  `screw_thread_pitch` is m per turn, its `thread_pitch` rad per m, with the other sign.
- Drake: `<drake:ball_constraint>` with two bodies and a point in each.
- Gepetto: `closed_loop` pairs of frames, `type` 3d (a ball) or 6d (fixed) for each, `name_mot` the driven joints,
  `joint_name` with `joint_type` SPHERICAL, FIXED or UJOINT_XY for joints that the URDF holds otherwise.
Sources: https://github.com/Gepetto/example-parallel-robots, http://sdformat.org/spec?elem=joint,
https://drake.mit.edu/doxygen_cxx/group__multibody__parsing.html.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from pathlib import Path

from symscrew.description import JOINT_TYPES
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.assembled import assembled
from symscrew.formats.closed_pose import Side, Tree, closed_displacements
from symscrew.formats.contradictory_loops import Contradiction
from symscrew.formats.draft import Draft, RawJoint
from symscrew.formats.file_names import fresh
from symscrew.formats.open_loops import CLOSED, Closing, explained_by_digits
from symscrew.formats.rigid_displacements import (
    CONTEXT,
    UNITS,
    ZERO,
    Pose,
    Real,
    Triple,
    about,
    length,
    minus,
    product,
    real,
    triple,
    unit,
)
from symscrew.formats.safe_xml import Element, elements, label, number, numbers
from symscrew.formats.urdf_forces import DYNAMICS
from symscrew.whole_files import only_file

TYPES = {
    "fixed": "fixed", "revolute": "R", "continuous": "R", "prismatic": "P", "planar": "E", "spherical": "S",
    "ball": "S", "cylindrical": "C", "universal": "U", "screw": "H",
}  # fmt: skip
DRAKE = "{http://drake.mit.edu}"
"""Namespace of Drake's own elements."""
SIDES = ("predecessor", "successor", "parent", "child", "link1", "link2")
KINDS = {"3d": "S", "6d": "fixed"}
MODEL = "__model__"
"""SDF's name of the model's own frame, which is that of a URDF's root link."""
MOST_BYTES = 100_000
"""Of a robot.yaml: those that people publish have some thousand."""
_TOKEN = re.compile(r"""\s*(?:#[^\n]*|"([^"\n]*)"|'([^'\n]*)'|([\[\],])|([^\s\[\],#"']+))""")
_KEY = re.compile(r"^([A-Za-z_]+):", re.MULTILINE)


@dataclass(frozen=True)
class FoundLoops:
    """The joints that close loops, and the driven joints where the file beside says so."""

    joints: list[RawJoint]
    driven: frozenset[str] | None = None


def is_loop(joint: Element) -> bool:
    """Whether a <joint> among those of the tree is one of a loop: two sides with their own origins."""
    return any(True for _ in elements(joint, "predecessor", "successor"))


def loops(root: Element, path: Path, draft: Draft, *, poses: Mapping[str, Pose], closing: Closing) -> FoundLoops:
    """The joints that close loops; raises DescriptionError for what is not supported or does not close."""
    found = []
    in_gazebo = [joint for section in elements(root, "gazebo") for joint in elements(section, "joint")]
    for element in _elements(root):
        missing = [name for name in _named(element) if name not in poses] if element in in_gazebo else []
        if missing:
            draft.ledger.lost(f"{label(element)} in <gazebo>: there is no link {', '.join(map(shorten, missing))}")
            continue
        sides = list(_sides(element, poses))
        if len(sides) != 2:
            raise DescriptionError(f"{label(element)}: expected the two links of a loop, each with its origin")
        kind = element.get("type", "fixed")
        if kind not in TYPES:
            raise DescriptionError(f"{label(element)}: loops of type {shorten(kind)}; {did_you_mean(kind, TYPES)}")
        axes = _axes(element, poses, sides[0][1])
        slack = explained_by_digits(_places(element))
        made = _joined(element.get("name") or "loop", TYPES[kind], sides, axes=axes, closing=closing, slack=slack)
        found.append(replace(made, pitch=_pitch(element)) if JOINT_TYPES[made.type].helical else made)
        _forces_left_out(draft, element)
    found += [_ball_constraint(element, poses, closing) for element in root.iter(f"{DRAKE}ball_constraint")]
    beside = path.with_suffix(".yaml")
    driven = None
    if beside.is_file():
        given = _lists(beside)
        _change_types(draft, given)
        found += _gepetto(draft, given, poses, closing)
        if "name_mot" in given:
            wanted = {str(name) for name in given["name_mot"]}
            driven = frozenset(joint.name for joint in draft.joints if joint.name in wanted)
    taken = [joint.name for joint in draft.joints]
    named = []
    for joint in found:
        named.append(replace(joint, name=fresh(joint.name, taken)))
        taken.append(named[-1].name)
    return FoundLoops(named, driven)


def _elements(root: Element) -> Iterator[Element]:
    yield from elements(root, "loop", "loop_joint")
    yield from (joint for joint in elements(root, "joint") if is_loop(joint))
    for section in elements(root, "gazebo"):
        yield from (joint for joint in elements(section, "joint") if list(elements(joint, "parent", "child")))


def _sides(element: Element, poses: Mapping[str, Pose]) -> Iterator[tuple[str, Pose]]:
    """(link, pose of the joint's frame as it has it) for both links."""
    sides = list(elements(element, *SIDES))
    whole = _frame(element, poses) if sides and all(not side.get("link") for side in sides) else None
    for side in sides:
        link = _known(element, side.get("link") or (side.text or "").strip(), poses)
        origins = list(elements(side, "origin"))
        own = poses[link] @ (_origin(origins[0]) if origins else _attributes(side))
        yield link, own if whole is None else whole


def _named(element: Element) -> list[str]:
    """The links that an SDF's joint names."""
    return [(side.text or "").strip() for side in elements(element, "parent", "child")]


def _known(element: Element, link: str, poses: Mapping[str, Pose]) -> str:
    if link not in poses:
        raise DescriptionError(f"{label(element)}: there is no link {shorten(link)}; {did_you_mean(link, poses)}")
    return link


def _frame(element: Element, poses: Mapping[str, Pose]) -> Pose:
    """The frame of an SDF's joint, which both links have where they are."""
    child = next(((side.text or "").strip() for side in elements(element, "child")), "")
    for pose in elements(element, "pose"):
        where = f"{label(element)}, pose"
        if pose.get("degrees", "false") != "false" or pose.get("rotation_format", "euler_rpy") != "euler_rpy":
            raise DescriptionError(f"{where}: expected x y z roll pitch yaw in m and rad")
        values = (pose.text or "").split()
        six = numbers(" ".join(values or ["0"] * 6), where, 6)
        own = _displacement(triple(six[3:]), triple(six[:3]))
        return poses[_known(element, pose.get("relative_to") or child, poses)] @ own
    return poses[_known(element, child, poses)]


def _ball_constraint(element: Element, poses: Mapping[str, Pose], closing: Closing) -> RawJoint:
    """Drake's: a point of one body at a point of the other."""
    sides = []
    for one, point in (("body_A", "p_AP"), ("body_B", "p_BQ")):
        where = f"<drake:ball_constraint>, {point}"
        body = next((e.get("name", "") for e in element.iter(f"{DRAKE}ball_constraint_{one}")), "")
        at = next((e.get("value", "") for e in element.iter(f"{DRAKE}ball_constraint_{point}")), "")
        place = triple(numbers(at, where, 3))
        sides.append((_known(element, body, poses), poses[_known(element, body, poses)] @ Pose(UNITS, place)))
    return _joined("ball_constraint", "S", sides, axes=[], closing=closing)


def _origin(origin: Element) -> Pose:
    return _attributes(origin)


def _attributes(element: Element) -> Pose:
    where = label(element)
    turn = triple(numbers(element.get("rpy", "0 0 0"), f"{where}, rpy", 3))
    return _displacement(turn, triple(numbers(element.get("xyz", "0 0 0"), f"{where}, xyz", 3)))


def _displacement(turn: Triple, place: Triple) -> Pose:
    """By roll, pitch and yaw about fixed axes, and a place."""
    (roll, pitch, yaw), (x, y, z) = turn, UNITS
    return Pose(product(about(z, yaw), product(about(y, pitch), about(x, roll))), place)


def _axes(element: Element, poses: Mapping[str, Pose], frame: Pose) -> list[Triple]:
    """The axes in the joint's frame: `<axis xyz>` of URDF, `<axis><xyz>` of SDF, where another frame may be named."""
    found = []
    for axis in elements(element, "axis", "axis2"):
        given = next(elements(axis, "xyz"), None)
        text = axis.get("xyz") or ("" if given is None else given.text or "")
        direction = unit(triple(numbers(text, f"{label(element)}, axis", 3)), f"{label(element)}, axis")
        named = "" if given is None else given.get("expressed_in", "")
        old = next(((flag.text or "").strip() for flag in elements(axis, "use_parent_model_frame")), "")
        if named == MODEL or old in ("1", "true"):
            direction = frame.inverse().direction(direction)
        elif named and named != element.get("name"):
            direction = frame.inverse().direction(poses[_known(element, named, poses)].direction(direction))
        found.append(direction)
    return found


def _pitch(element: Element) -> Real:
    """The way of a screw per angle [m/rad], as SDF says it since 1.10 or before; 1 rad/m where it does not."""
    said = {part.tag: (part.text or "").strip() for part in elements(element, "screw_thread_pitch", "thread_pitch")}
    values = {tag: real(number(text, f"{label(element)}, {tag}")) for tag, text in said.items()}
    for tag, value in values.items():
        if value == 0:
            raise DescriptionError(f"{label(element)}: expected a {tag} that is not 0")
    if "screw_thread_pitch" in values:
        return values["screw_thread_pitch"] / (2 * CONTEXT.pi)
    return real(-1) / values["thread_pitch"] if "thread_pitch" in values else real(-1)


def _forces_left_out(draft: Draft, element: Element) -> None:
    """What a joint that closes a loop says of damping, friction and springs, in URDF's attributes or SDF's elements."""
    for dynamics in element.iter("dynamics"):
        said = {key: value for key, value in dynamics.attrib.items() if key in DYNAMICS}
        said |= {child.tag: (child.text or "0").strip() for child in elements(dynamics) if child.tag in DYNAMICS}
        for key, text in said.items():
            if key != "spring_reference" and number(text, f"{label(element)}, {key}") != 0:
                draft.ledger.lost(f"{key} of a joint that closes a loop")


def _places(element: Element) -> Iterator[list[Decimal]]:
    """The origins of both sides of a loop as they are written, where they are."""
    for side in elements(element, *SIDES):
        for origin in (side, *elements(side, "origin")):
            if "xyz" in origin.attrib:
                yield numbers(origin.attrib["xyz"], f"{label(element)}, xyz", 3)


def _joined(
    name: str,
    kind: str,
    sides: Sequence[tuple[str, Pose]],
    *,
    axes: Sequence[Triple],
    closing: Closing,
    slack: Real | int = 0,
) -> RawJoint:
    """The joint between the frames of two links, which must be one where its type says so.

    `slack`: how far their places may be apart by their digits [m].
    """
    (parent, one), (child, other) = sides
    place = other.translation
    count, joint = JOINT_TYPES[kind].axes, JOINT_TYPES[kind]
    if not joint.slides:
        place = closing.middle(f"loop {name!r}", one.translation, other.translation, slack)
    if len(axes) < count:
        axes = [*axes, *UNITS[: count - len(axes)]]
    found = tuple(one.direction(axis) for axis in axes[:count])
    if not joint.freedom:
        turned = max(length(minus(a, b)) for a, b in zip(one.rotation, other.rotation, strict=True))
        closing.accept(f"loop {name!r}", turned)
    elif count == 1:
        closing.accept(f"loop {name!r}, axis", length(minus(found[0], other.direction(axes[0]))))
    return RawJoint(name, kind, parent, child, place, found)


def _lists(path: Path) -> dict[str, list[object]]:
    """The lists of a file `key: [...]`, nested at most twice, of words; anything else of YAML is refused."""
    try:
        text = only_file(path).read_bytes()[: MOST_BYTES + 1].decode("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise DescriptionError(f"{path.name}: the file beside the URDF cannot be read") from error
    if len(text) > MOST_BYTES:
        raise DescriptionError(f"{path.name}: the file beside the URDF has more than {MOST_BYTES} bytes")
    starts = [*_KEY.finditer(text)]
    found: dict[str, list[object]] = {}
    for start, following in zip(starts, [*starts[1:], None], strict=True):
        part = text[start.end() : following.start() if following else len(text)]
        found[start.group(1)] = _list(part, f"{path.name}, {start.group(1)}")
    return found


def _list(text: str, where: str) -> list[object]:
    stack: list[list[object]] = [[]]
    for token in _TOKEN.finditer(text):
        double, single, mark, word = token.groups()
        if mark == "[":
            if len(stack) > 3:
                raise DescriptionError(f"{where}: expected a list of words or of pairs of them")
            stack[-1].append([])
            stack.append(stack[-1][-1])  # type: ignore[arg-type]
        elif mark == "]":
            if len(stack) < 2:
                raise DescriptionError(f"{where}: a bracket closes that none has opened")
            stack.pop()
        elif mark != ",":
            value = double if double is not None else single if single is not None else word
            if value is not None:
                stack[-1].append(value)
    inner = stack[0][0] if len(stack[0]) == 1 else None
    return inner if isinstance(inner, list) else stack[0]


def _gepetto(
    draft: Draft, given: Mapping[str, list[object]], poses: Mapping[str, Pose], closing: Closing
) -> list[RawJoint]:
    """The loops of the file beside, whose frames need not meet in the URDF's own pose: the joints are moved there."""
    pairs, kinds = given.get("closed_loop", []), given.get("type", [])
    children = {joint.name: joint.child for joint in draft.joints}
    sides: list[tuple[Side, Side, bool]] = []
    for k, pair in enumerate(pairs):
        kind = str(kinds[k]).lower() if k < len(kinds) else "6d"
        if not isinstance(pair, list) or len(pair) != 2 or kind not in KINDS:
            raise DescriptionError(f"closed_loop: expected two frames and the type 3d or 6d, got {shorten(pair)}")
        ends: list[Side] = []
        for frame in map(str, pair):
            link = children.get(frame, frame)
            if link not in poses:
                known = [*children, *poses]
                raise DescriptionError(f"closed_loop: there is no frame {shorten(frame)}; {did_you_mean(frame, known)}")
            ends.append((link, poses[link]))
        sides.append((ends[0], ends[1], kind == "6d"))
    if any(_gap(side) > CLOSED for side in sides):
        tree = Tree.of(draft, sides)
        q, gap = closed_displacements(tree)
        before = replace(draft, joints=list(draft.joints))
        against = Contradiction.of(before, sides) if closing.is_open(gap) else None
        cure = against.cure(closing.loosen) if against else None
        if cure is not None:
            draft.joints, sides = list(cure.joints), list(cure.loops)
            only = "" if closing.loosen else ", and with nothing else that such a file may mean"
            draft.ledger.changed.append(f"loops that close in no pose: {cure.full} they do{only}")
            tree = Tree.of(draft, sides)
            q, gap = closed_displacements(tree)
        why = against.said if against else None
        moved = assembled(draft, tree, q)
        sides = [((a, moved[a] @ one), (b, moved[b] @ other), turning) for (a, one), (b, other), turning in sides]
        worst = max(range(len(sides)), key=lambda k: _gap(sides[k]))
        closing.check(f"loop 'closing_{worst + 1}'", _gap(sides[worst]), why)
    return [
        _joined(f"closing_{k}", KINDS["6d" if turning else "3d"], (one, other), axes=[], closing=closing)
        for k, (one, other, turning) in enumerate(sides, start=1)
    ]


def _gap(side: tuple[Side, Side, bool]) -> Real:
    """How far two frames are apart [m, and rad where their turning counts]."""
    (_, one), (_, other), turning = side
    turned = [length(minus(a, b)) for a, b in zip(one.rotation, other.rotation, strict=True)] if turning else []
    return max(length(minus(one.translation, other.translation)), *turned, ZERO[0])


def _change_types(draft: Draft, given: Mapping[str, list[object]]) -> None:
    """Joints of the tree that the file beside says to be balls or universal joints."""
    names, kinds = given.get("joint_name", []), given.get("joint_type", [])
    wanted = dict(zip(map(str, names), map(str, kinds), strict=False))
    for k, joint in enumerate(draft.joints):
        kind = wanted.get(joint.name)
        if kind is None:
            continue
        if kind == "SPHERICAL":
            draft.joints[k] = replace(joint, type="S", axes=(), driven=())
        elif kind == "FIXED":
            draft.joints[k] = replace(joint, type="fixed", axes=(), driven=())
        elif kind.startswith("UJOINT_") and len(kind) == 9 and set(kind[7:]) <= set("XYZ"):
            turn = draft.frames[joint.name]
            axes = tuple(turn.direction(UNITS["XYZ".index(letter)]) for letter in kind[7:])
            draft.joints[k] = replace(joint, type="U", axes=axes, driven=())
        else:
            raise DescriptionError(f"joint_type: expected SPHERICAL, FIXED or UJOINT_XY, got {shorten(kind)}")
        draft.ledger.changed.append(f"joint {joint.name}: {kind}, as the file beside the URDF says")
