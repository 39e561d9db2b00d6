"""Limbs by letters: `"UPS"`, `"UP*S"`, and mechanism strings such as `"3UPS-UPU-S"`.

A letter is a joint type, in order from base to tip: R revolute, P prismatic, H helical, C cylindrical,
U universal, S spherical, E planar. Stars after a letter mark its driven freedoms, the first freedom
first: `"UP*S"` drives the slider.

Without a star the rule is: the first P is driven; in a limb without P the first joint, when it is an R or
H (a motor on the base); a limb with neither (`"S"`, `"SS"`, `"UU"`) is passive. A tilde before a limb makes it passive:
`"3-UPS+~UP"`. In mechanism strings `Pa` is a parallelogram of four hinges: `"3-RRPaR"`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from symscrew.description.joints import JOINT_TYPES
from symscrew.errors import DescriptionError, did_you_mean, shorten

LETTERS = tuple(name for name in JOINT_TYPES if len(name) == 1)
OPTIONS = (
    "points", "axes", "joints", "bodies", "driven", "pitch", "reference", "mass", "com", "inertia",
    "tip_point",
)  # fmt: skip
OTHER_LETTERS = {
    "B": ("S", "ball"),
    "G": ("S", "ball"),
    "K": ("U", "Cardan"),
    "T": ("U", "Hooke"),
    "L": ("P", "linear"),
    "D": ("P", "sliding"),
    "Z": ("C", "cylindrical"),
    "F": ("E", "planar"),
}
"""Letters that other texts use for a joint, ours, and a name."""
MAX_JOINTS = 30
"""Joints of a limb: six are enough to reach every pose; a longer text is refused as not meant to be a limb."""
MAX_COUNT = 100
"""Limbs of a mechanism string; beyond it the text is refused before anything is made of it."""

PARALLELOGRAM = "Pa"
_LIMB = re.compile(r"~?(?:[A-Za-z]\**)+", re.ASCII)


@dataclass(frozen=True)
class LimbType:
    """The letters of a limb from base to tip, and for each joint the indices of its driven freedoms.

    `parallelograms`: where two hinges, an R and the next, are the ends of one bar of a parallelogram, whose other bar
    is beside it. `passive`: whether it was said to have no drive.
    """

    letters: str
    driven: tuple[tuple[int, ...], ...]
    parallelograms: tuple[int, ...] = ()
    passive: bool = False

    @property
    def marked(self) -> str:
        """The letters with a star for each driven freedom, or the tilde of a passive limb.

        >>> parse_limb_string("UPS").marked, parse_limb_string("~UP").marked
        ('UP*S', '~UP')
        """
        return "~" * self.passive + "".join(
            letter + "*" * len(d) for letter, d in zip(self.letters, self.driven, strict=True)
        )

    @property
    def freedom(self) -> int:
        """Sum of the freedoms of the joints."""
        return sum(JOINT_TYPES[letter].freedom for letter in self.letters)


def parse_limb_string(text: str, *, where: str = "limb") -> LimbType:
    """The limb that `text` stands for, with its driven joint by the rule of this module if none is marked.

    Raises:
        DescriptionError: empty, unknown letter, too many stars or joints.
    """
    if not isinstance(text, str) or not _LIMB.fullmatch(text):
        raise DescriptionError(
            f"{where}: expected the letters of the joints from base to tip such as 'UPS' or 'UP*S', got "
            f"{shorten(text)}; letters are {', '.join(LETTERS)}, a star marks a driven joint"
        )
    if PARALLELOGRAM in text:
        raise DescriptionError(
            f"{where}: {PARALLELOGRAM} in {shorten(text)} is a parallelogram, a loop in the limb; write its joints one "
            f"by one, as `symscrew new NAME --limbs 3-RR{PARALLELOGRAM}R` does"
        )
    passive, joints = text[0] == "~", re.findall(r"([A-Za-z])(\**)", text)
    if passive and "*" in text:
        raise DescriptionError(
            f"{where}: {shorten(text)} is passive by its tilde and driven by its star; leave one out"
        )
    if len(joints) > MAX_JOINTS:
        raise DescriptionError(f"{where}: a limb of {len(joints)} joints; at most {MAX_JOINTS} are allowed")
    for letter, stars in joints:
        if letter not in LETTERS:
            upper = letter.upper()
            cure = f"write {upper!r}" if upper in LETTERS else "known: " + ", ".join(LETTERS)
            if upper in OTHER_LETTERS:
                cure = "did you mean {!r} ({} joint)?".format(*OTHER_LETTERS[upper]) + f" {cure}"
            raise DescriptionError(f"{where}: unknown joint letter {letter!r} in {shorten(text)}; {cure}")
        freedom = JOINT_TYPES[letter].freedom
        if len(stars) > freedom:
            raise DescriptionError(
                f"{where}: {len(stars)} stars after {letter!r} in {shorten(text)}, but this joint has "
                f"{freedom} freedom{'s' * (freedom > 1)}"
            )
    letters = "".join(letter for letter, _ in joints)
    driven = tuple(tuple(range(len(stars))) for _, stars in joints)
    driven = driven if any(driven) or passive else _default_drive(letters)
    return LimbType(letters, driven, passive=passive)


def _with_parallelograms(text: str, where: str) -> LimbType:
    """A limb of a mechanism string: `Pa` becomes the two hinges of one of its bars."""
    plain = re.sub(PARALLELOGRAM, "RR", text)
    if PARALLELOGRAM + "*" in text:
        raise DescriptionError(f"{where}: a parallelogram has no drive of its own, got {shorten(text)}")
    limb = parse_limb_string(plain, where=where)
    tokens = re.findall(f"{PARALLELOGRAM}|[A-Za-z]", text)
    found, place = [], 0
    for token in tokens:
        found += [place] if token == PARALLELOGRAM else []
        place += len(token)
    if found and tokens[0] == PARALLELOGRAM and "*" not in text:
        limb = replace(limb, driven=((),) * len(limb.letters))
    return replace(limb, parallelograms=tuple(found))


def parse_mechanism_string(text: str) -> tuple[LimbType, ...]:
    """The limbs of a mechanism string, counts expanded, in order.

    Limbs are joined by `-` or `+`; a number before a limb repeats it, with or without a dash between.

    >>> [limb.marked for limb in parse_mechanism_string("2-UPS+RRR-S")]
    ['UP*S', 'UP*S', 'R*RR', 'S']
    """
    where = "mechanism string"
    if not isinstance(text, str) or not text.strip() or len(text) > 500:
        raise DescriptionError(f"{where}: expected limbs such as '3UPS-UPU-S' or '6-UPS', got {shorten(text)}")
    limbs: list[LimbType] = []
    count: int | None = None
    for part in re.split(r"[-+]", text):
        match = re.fullmatch(r"\s*(\d{0,9})\s*([~A-Za-z*]*)\s*", part, re.ASCII)
        if match is None or not part.strip():
            raise DescriptionError(
                f"{where}: cannot read {shorten(part)} in {shorten(text)}; expected a count and letters, "
                "such as '3UPS', between dashes or plus signs"
            )
        digits, letters = match.groups()
        if digits:
            if count is not None:
                raise DescriptionError(f"{where}: two counts in a row in {shorten(text)}; expected one per limb")
            count = int(digits)
            if not 1 <= count <= MAX_COUNT:
                raise DescriptionError(f"{where}: expected a count from 1 to {MAX_COUNT}, got {count}")
        if letters:
            limbs += [_with_parallelograms(letters, where)] * (count or 1)
            count = None
    if count is not None:
        raise DescriptionError(f"{where}: the count {count} at the end of {shorten(text)} has no limb after it")
    if len(limbs) > MAX_COUNT:
        raise DescriptionError(f"{where}: {len(limbs)} limbs; at most {MAX_COUNT} are allowed")
    return tuple(limbs)


def _default_drive(letters: str) -> tuple[tuple[int, ...], ...]:
    kinds = [JOINT_TYPES[letter] for letter in letters]
    sliders = [k for k, kind in enumerate(kinds) if kind.slider]
    if sliders:
        chosen = sliders[0]
    elif kinds[0].freedom == len(kinds[0].turning) == 1:
        chosen = 0
    else:
        chosen = -1
    return tuple((0,) if k == chosen else () for k in range(len(letters)))


@dataclass(frozen=True)
class LimbPlan:
    """What a limb makes: its joints (keywords of `MechanismBuilder.joint`) and the bodies between them."""

    joints: tuple[dict[str, Any], ...]
    bodies: tuple[dict[str, Any], ...]


def plan_limb(name: str, type: str, *, base: str, tip: str, **options: Any) -> LimbPlan:
    """The joints and bodies of a limb from body `base` to body `tip`.

    Options (all but `points` may be left out; lists have one entry per joint or per body, base first):
        points: one point per joint, or one per joint other than P: each P then sits in the middle of
            its two neighbours.
        axes: list of axes per joint; empty for S, and for a P that slides along the line joining its
            neighbours' points.
        joints, bodies: names; by default `<limb>_<letter><k>` and `<limb>_<k>`, k from 1.
        driven: True (the marked or default drive), False (passive) or a list of joint indices from 0.
        pitch, reference: per joint; empty or "" where there is none.
        mass, com, inertia: per body; all left out for bodies without inertia.
        tip_point: where the last joint's centre is on the tip body, when that is known independently.

    Raises:
        DescriptionError: says which option does not fit the letters.
    """
    where = f"limbs.{name}"
    limb = parse_limb_string(type, where=f"{where}.type")
    count = len(limb.letters)
    for key in options:
        if key not in OPTIONS:
            raise DescriptionError(f"{where}: unknown key {key!r}; {did_you_mean(key, OPTIONS)}")
    points = _points(limb.letters, options.get("points"), where)
    axes = _per_joint(options.get("axes"), count, f"{where}.axes", limb.letters)
    names = _per_joint(options.get("joints"), count, f"{where}.joints", limb.letters)
    driven = _driven(limb, options.get("driven", True), where)
    bodies = _bodies(name, count - 1, options, where)
    chain = [base, *(body["name"] for body in bodies), tip]
    made = []
    for k, letter in enumerate(limb.letters):
        joint: dict[str, Any] = {
            "name": names[k] if options.get("joints") is not None else f"{name}_{letter}{k + 1}",
            "type": letter,
            "parent": chain[k],
            "child": chain[k + 1],
            "point": points[k],
            "axes": _axes(limb.letters, k, axes[k], points=points, where=where),
            "driven": list(driven[k]),
        }
        for key in ("pitch", "reference"):
            value = _per_joint(options.get(key), count, f"{where}.{key}", limb.letters)[k]
            if value is not None and value != "" and value != []:
                joint[key] = value
        made.append(joint)
    if options.get("tip_point") is not None:
        made[-1]["child_point"] = options["tip_point"]
    return LimbPlan(tuple(made), tuple(bodies))


@dataclass(frozen=True)
class Between:
    """A point or direction that follows from two others: `start` and `end` as they were given."""

    start: Any
    end: Any


def _sequence(value: Any, where: str, expected: str) -> Sequence[Any]:
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise DescriptionError(f"{where}: expected {expected}, got {shorten(value)}")
    return value


def _per_joint(value: Any, count: int, where: str, letters: str) -> Sequence[Any]:
    if value is None:
        return [None] * count
    listed = _sequence(value, where, f"a list with one entry per joint of {letters}")
    if len(listed) != count:
        raise DescriptionError(
            f"{where}: expected one entry per joint of {letters}, that is {count}, got {len(listed)}"
        )
    return listed


def _points(letters: str, value: Any, where: str) -> list[Any]:
    others = [k for k, letter in enumerate(letters) if not JOINT_TYPES[letter].slider]
    expected = f"one point per joint of {letters} ({len(letters)}) or one per joint other than P ({len(others)})"
    if value is None:
        raise DescriptionError(f"{where}: the key 'points' is missing; give {expected}")
    given = list(_sequence(value, f"{where}.points", "a list of points"))
    if len(given) == len(letters):
        return given
    if len(given) != len(others) or not others:
        raise DescriptionError(f"{where}.points: expected {expected}, got {len(given)}")
    placed = dict(zip(others, given, strict=True))
    points: list[Any] = []
    for k in range(len(letters)):
        before = [j for j in others if j <= k]
        after = [j for j in others if j >= k]
        if k in placed or not before or not after:
            points.append(placed[(before[-1:] or after[:1])[0]])
        else:
            points.append(Between(placed[before[-1]], placed[after[0]]))
    return points


def _axes(letters: str, k: int, given: Any, *, points: list[Any], where: str) -> Any:
    """The axes of joint k as given; the line between its neighbours' points for a P without any."""
    needed = JOINT_TYPES[letters[k]].axes
    if given is None or (not isinstance(given, str) and isinstance(given, Sequence) and len(given) == 0):
        if needed == 0:
            return []
        sliders = [JOINT_TYPES[letter].slider for letter in letters[max(k - 1, 0) : k + 2]]
        if sliders == [False, True, False]:  # between two joints that say where it slides
            return [Between(points[k - 1], points[k + 1])]
        raise DescriptionError(
            f"{where}.axes: joint {k + 1} of {letters} ({letters[k]}) needs {needed} "
            f"ax{'e' if needed > 1 else 'i'}s; none is given and none follows from the points"
        )
    if needed == 1 and isinstance(given, Sequence) and len(given) == 3 and not _nested(given):
        return [given]
    return given


def _nested(value: Sequence[Any]) -> bool:
    return any(isinstance(entry, list | tuple) for entry in value)


def _driven(limb: LimbType, value: Any, where: str) -> tuple[tuple[int, ...], ...]:
    if value is True or value is None:
        return limb.driven
    if value is False:
        return ((),) * len(limb.letters)
    listed = _sequence(value, f"{where}.driven", "true, false or a list of joint indices from 0")
    for index in listed:
        if isinstance(index, bool) or not isinstance(index, int) or not 0 <= index < len(limb.letters):
            raise DescriptionError(
                f"{where}.driven: expected indices of joints from 0 to {len(limb.letters) - 1}, got {shorten(index)}"
            )
    return tuple((0,) if k in listed else () for k in range(len(limb.letters)))


def _bodies(limb: str, count: int, options: dict[str, Any], where: str) -> list[dict[str, Any]]:
    names = options.get("bodies")
    if names is None:
        names = [f"{limb}_{k + 1}" for k in range(count)]
    bodies: list[dict[str, Any]] = [{"name": name} for name in _per_body(names, count, f"{where}.bodies")]
    for key in ("mass", "com", "inertia"):
        if options.get(key) is not None:
            for body, value in zip(bodies, _per_body(options[key], count, f"{where}.{key}"), strict=True):
                body[key] = value
    return bodies


def _per_body(value: Any, count: int, where: str) -> Sequence[Any]:
    listed = _sequence(value, where, f"a list with one entry per body of the limb ({count})")
    if len(listed) != count:
        raise DescriptionError(f"{where}: expected one entry per body of the limb ({count}), got {len(listed)}")
    return listed
