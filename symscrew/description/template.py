"""A commented description to start from: sensible geometry for a mechanism string such as "3-UPS+UPU+S".

limbs, or the name of an architecture --proposal--> Proposal --described--> TOML text, which loads

Places and axes are those of `limb_layouts`, of named mechanisms those of `architectures`. Where a joint type leaves a
choice of axes, the file says what was chosen and why it may have to change.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import sympy

from symscrew.description import toml_file
from symscrew.description.architectures import Architecture, architecture, meant_by
from symscrew.description.expressions import to_text
from symscrew.description.joints import JointType
from symscrew.description.limb_layouts import (
    HALF,
    H,
    Layout,
    Point,
    R,
    Z,
    all_driven,
    arm,
    b,
    kinds_of,
    l,
    planar,
    r,
    spatial,
    w,
)
from symscrew.description.limb_letters import LimbType, parse_mechanism_string
from symscrew.description.names import check_mechanism_name
from symscrew.errors import DescriptionError
from symscrew.whole_files import created

LINK_MASS, PLATFORM_MASS = 1, 3  # [kg], of a proposal: round numbers that a reader sees are to be changed
VALUES = {
    "parallel": {R: ("0.5", "radius of the base points"), r: ("0.25", "radius of the platform's points"),
                 H: ("0.6", "height of the platform"), b: ("0.15", "how far elbows stand out"),
                 w: ("0.1", "distance between the bars of a parallelogram")},
    "planar": {R: ("0.45", "radius of the base points"), r: ("0.15", "radius of the platform's points"),
               b: ("0.2", "how far elbows stand out")},
    "serial": {l: ("0.3", "length of a link")},
}  # fmt: skip


@dataclass(frozen=True)
class Proposal:
    """A mechanism to be written: limbs with their places, what its parameters are, and what it is called.

    `tips`: the body each limb carries; `hinges`: of further bodies, see `Architecture`.
    """

    kind: str
    limbs: str
    types: tuple[LimbType, ...]
    layouts: tuple[Layout, ...]
    centre: Point
    values: Mapping[sympy.Symbol, tuple[str, str]]
    tips: tuple[str, ...]
    hinges: tuple[tuple[str, Point, Point], ...] = ()
    architecture: Architecture | None = None

    @property
    def platform(self) -> str:
        """The body whose motion matters."""
        return "tool" if self.kind == "serial" else "platform"

    @property
    def used(self) -> list[sympy.Symbol]:
        """The parameters that its places and axes need, and those of its inertias."""
        vectors = [v for y in self.layouts for v in (*y.points, *sum(y.axes, ()))]
        vectors += [v for _, *pair in self.hinges for v in pair]
        found = [s for s in self.values if any(v.has(s) for v in vectors)]
        needed = [l] if self.kind == "serial" else [r, *([H] if self.centre.has(H) else [])]
        needed += [w] if any(limb.parallelograms for limb in self.types) else []
        return found + [s for s in needed if s not in found]


def proposal(limbs: str) -> Proposal:
    """Limbs in letters, or a named architecture, with places and axes.

    Raises:
        DescriptionError: a string that cannot be read.
    """
    named = architecture(limbs)
    types = parse_mechanism_string(named.limbs if named else limbs)
    named = named or meant_by(types)
    if named is not None:
        tips = named.tips or ("platform",) * len(types)
        return Proposal("parallel", limbs, types, tuple(named.layout(types)), named.centre,
                        {**VALUES["parallel"], **named.values}, tips, named.hinges, named)  # fmt: skip
    centre, turning = 0 * Z, [k.hinge or k.slider for t in types for k in kinds_of(t.letters)]
    if len(types) == 1:
        kind, layouts = "serial", [arm(types[0])]
        if "*" not in limbs and not types[0].passive:
            types = (all_driven(types[0]),)
        centre = layouts[0].points[-1] + HALF * HALF * l * sympy.Matrix([1, 0, 0])
    elif all(turning) and all(len(t.letters) <= 3 for t in types):
        kind, layouts = "planar", [planar(t, k, len(types)) for k, t in enumerate(types)]
    else:
        kind, layouts, centre = "parallel", spatial(types), H * Z
    tip = "tool" if kind == "serial" else "platform"
    return Proposal(kind, limbs, tuple(types), tuple(layouts), centre, VALUES[kind], (tip,) * len(types))


def description_text(name: str, limbs: str) -> str:
    """The TOML text of a mechanism with these limbs: it loads, with inertias, drives and comments.

    Args:
        name: of the mechanism, a C identifier.
        limbs: a mechanism string (`limb_letters.parse_mechanism_string`) or the name of an architecture; one limb makes
            a serial arm, whose joints are all driven unless stars say otherwise.

    Raises:
        DescriptionError: a string or a name that cannot be read.
    """
    check_mechanism_name(name, "mechanism.name")
    made = proposal(limbs)
    lines = [*_head(name, made), *_parameters(made), *_platform(made), *_side_bodies(made)]
    for k in range(len(made.types)):
        lines += (_limb_by_joints if made.types[k].parallelograms else _limb)(made, k)
    text = "\n".join([*lines, *_points(made)])
    toml_file.parse_description(text)
    return text + "\n"


def renamed_text(name: str, text: str) -> str:
    """The text of a description with another name of its mechanism: comments and all else as they are.

    Raises:
        DescriptionError: a name that cannot be one.
    """
    check_mechanism_name(name, "mechanism.name")
    head = text.index("[mechanism]")
    changed = re.sub(r'^name\s*=\s*"[^"]*"', f'name = "{name}"', text[head:], count=1, flags=re.M)
    toml_file.parse_description(text[:head] + changed)
    return text[:head] + changed


def write_template(name: str, limbs: str, path: str | Path) -> Path:
    """Write the description of limbs in letters, or of a named architecture, to a new file.

    Raises:
        DescriptionError: a string or name that cannot be read, or a file that is there already.
    """
    return write_new(description_text(name, limbs), path)


def write_new(text: str, path: str | Path) -> Path:
    """Write a description to a new file.

    Raises:
        DescriptionError: no name of a TOML file, or a file that is there already.
    """
    file = Path(path)
    if file.suffix != ".toml":
        raise DescriptionError(f"expected a file name that ends in .toml, got {str(file)!r}")
    try:
        created(file, text)
    except FileExistsError as error:
        raise DescriptionError(f"{file} is there already and is left as it is; use another name or --out") from error
    return file


# -- text -------------------------------------------------------------------------------------------------


def _entry(value: sympy.Expr) -> str:
    text = to_text(value)
    return text if value.is_Integer else f'"{text}"'


def _row(vector: Point) -> str:
    return "[" + ", ".join(_entry(v) for v in vector) + "]"


def _head(name: str, made: Proposal) -> list[str]:
    plain = {"serial": "an arm", "planar": "in the x-y plane", "parallel": "limbs between base and platform"}
    limbs, what, platform = made.limbs, plain[made.kind], made.platform
    if made.architecture is not None:
        limbs, what = made.architecture.limbs, f"the axes of {made.architecture.name}: {made.architecture.says}"
        if made.architecture.name == limbs:
            what = made.architecture.says
    return [
        f"# {name}: {limbs}, {what}. Everything here is a proposal to change.",
        "#",
        "# Units are m, kg, rad; points and axes: absolute axes, reference configuration; gravity is along -z.",
        '# A number may be an expression of the parameters in quotes, "R*cos(2*pi/3)"; it is read exactly.',
        f"# Next: symscrew mobility {name}.toml; symscrew view {name}.toml; symscrew generate {name}.toml --out {name}",
        "",
        "[mechanism]",
        f'name = "{name}"',
        'ground = "base"  # the body that does not move',
        f'platform = "{platform}"  # the body whose motion matters',
        f'description = "{limbs}, {what}"',
        "# characteristic_length = 0.5  # [m], divides lengths where they meet angles; default: from the geometry",
        "",
    ]


def _parameters(made: Proposal) -> list[str]:
    lines = ["# run_time = true makes a parameter an input of the generated functions instead of a number in them."]
    for symbol in made.used:
        value, text = made.values[symbol]
        lines += [f"[parameters.{symbol}]", f'value = "{value}"', 'unit = "m"', f'description = "{text}"', ""]
    return lines


def _platform(made: Proposal) -> list[str]:
    com, body = made.centre, made.platform
    if made.kind == "serial":
        moments = '["0.0005", "0.002", "0.002"]'
        note = "# A rod of 0.15 m along x. mass [kg], com: centre of mass [m], inertia about it [kg m^2]."
        mass = LINK_MASS
    else:
        mass = PLATFORM_MASS
        quarter = f"{PLATFORM_MASS}*r^2/4"
        moments = f'["{quarter}", "{quarter}", "{PLATFORM_MASS}*r^2/2"]'
        note = "# A disc of radius r. mass [kg], com: centre of mass [m], inertia about it [kg m^2]."
    return [note, f"[bodies.{body}]", f"mass = {mass}", f"com = {_row(com)}", f"inertia = {moments}", ""]


def _side_bodies(made: Proposal) -> list[str]:
    """Bodies between limbs and platform, and the hinges by which they carry it."""
    lines = []
    for body, place, axis in made.hinges:
        lines += ["# A side bar: limbs carry it, and the platform turns on it. A rod along y.",
                  f"[bodies.{body}]", f"mass = {LINK_MASS}", f"com = {_row(place)}",
                  f'inertia = ["{LINK_MASS}*r^2/6", "0.0002", "{LINK_MASS}*r^2/6"]', "",
                  f"[joints.{body}_R]", 'type = "R"', f'parent = "{body}"', 'child = "platform"',
                  f"point = {_row(place)}", f"axes = [{_row(axis)}]", ""]  # fmt: skip
    return lines


def _limb(made: Proposal, place: int) -> list[str]:
    limb, layout = made.types[place], made.layouts[place]
    letters, name = limb.letters, "arm" if made.kind == "serial" else f"limb{place + 1}"
    kinds = kinds_of(letters)
    lines = [_drives_in_words(limb, kinds)]
    lines += [f"[limbs.{name}]", f'type = "{limb.marked}"', 'base = "base"', f'tip = "{made.tips[place]}"']
    sliders = [axes for kind, axes in zip(kinds, layout.axes, strict=True) if kind.slider]
    skip = bool(sliders) and not any(sliders)
    places = [p for p, kind in zip(layout.points, kinds, strict=True) if not (skip and kind.slider)]
    lines += ["points = [  # one per joint, base first" + (", a P sits in the middle" if skip else "")]
    lines += [f"  {_row(p)}," for p in places] + ["]"]
    if any(layout.axes):
        lines.append("axes = [  # one list per joint" + (", empty for S or for P along the leg" * (() in layout.axes)))
        lines += [
            f"  [{', '.join(_row(a) for a in axes)}],  # {x}" for x, axes in zip(letters, layout.axes, strict=True)
        ]
        lines.append("]")
    if any(kind.helical for kind in kinds):
        pitches = ", ".join('"0.002"' if kind.helical else '""' for kind in kinds)
        lines.append(f"pitch = [{pitches}]  # [m/rad]")
    if len(letters) > 1:
        lines += _rods(made, layout.points)
    return [*lines, ""]


def _drives_in_words(limb: LimbType, kinds: Sequence[JointType]) -> str:
    drives = "a star marks a driven freedom" if any(limb.driven) else "no drive: put a star after a joint to drive it"
    return f"# {', '.join(kind.name for kind in kinds)}; {drives}."


def _limb_by_joints(made: Proposal, place: int) -> list[str]:
    """A limb with parallelograms, joint by joint: they are loops, and a limb in letters is a chain.

    The first bar of a parallelogram is shifted by half its width against the places of the layout, and the second to
    the other side.
    """
    limb, layout, name = made.types[place], made.layouts[place], f"limb{place + 1}"
    assert layout.across is not None
    shift = w / 2 * layout.across
    kinds, count = kinds_of(limb.letters), len(limb.letters)
    ends = {j for k in limb.parallelograms for j in (k, k + 1)}
    chain = ["base", *(f"{name}_{k + 1}" for k in range(count - 1)), made.tips[place]]
    lines = [
        f"# {', '.join(kind.name for kind in kinds)}, with parallelograms: two bars side by side, each on two hinges."
    ]
    for k in range(count - 1):
        bar = shift if k in limb.parallelograms else 0 * shift
        ends_of_body = [layout.points[j] + bar for j in (k, k + 1)]
        lines += _rod_body(made, chain[k + 1], ends_of_body)
        if k in limb.parallelograms:
            lines += _rod_body(made, f"{chain[k + 1]}b", [layout.points[j] - shift for j in (k, k + 1)])
    for k, kind in enumerate(kinds):
        at = layout.points[k] + (shift if k in ends else 0 * shift)
        lines += _joint(f"{name}_{kind.letter}{k + 1}", (chain[k], chain[k + 1]), at, layout.axes[k])
        lines[-1:] = [f"driven = {list(limb.driven[k])}", ""] if limb.driven[k] else [""]
        if k in ends:
            first = k in limb.parallelograms
            pair = (chain[k], f"{chain[k + 1]}b") if first else (f"{chain[k]}b", chain[k + 1])
            lines += _joint(f"{name}_{kind.letter}{k + 1}b", pair, layout.points[k] - shift, layout.axes[k])
    return lines


def _joint(name: str, bodies: tuple[str, str], at: Point, axes: Sequence[Point]) -> list[str]:
    listed = ", ".join(_row(axis) for axis in axes)
    letter = name.partition("_")[2][0]
    return [f"[joints.{name}]", f'type = "{letter}"', f'parent = "{bodies[0]}"', f'child = "{bodies[1]}"',
            f"point = {_row(at)}", f"axes = [{listed}]", ""]  # fmt: skip


def _rod_body(made: Proposal, name: str, ends: Sequence[Point]) -> list[str]:
    """A body of its own: a slender rod between two places."""
    middle = (HALF * (ends[0] + ends[1])).applyfunc(sympy.expand)
    return [f"[bodies.{name}]", f"mass = {LINK_MASS}", f"com = {_row(middle)}",
            f"inertia = {_moments(made, *ends)}", ""]  # fmt: skip


def _rods(made: Proposal, points: Sequence[Point]) -> list[str]:
    """Mass, centre and inertia of the bodies between the joints: slender rods at the parameters' values."""
    count = len(points) - 1
    lines = ["# Slender rods at the values of the parameters above: change the inertias with the lengths."]
    lines += [f"mass = [{', '.join([str(LINK_MASS)] * count)}]", "com = ["]
    lines += [f"  {_row((HALF * (p + q)).applyfunc(sympy.expand))}," for p, q in pairwise(points)]
    lines += ["]", "inertia = ["]
    lines += [f"  {_moments(made, p, q)}," for p, q in pairwise(points)]
    return [*lines, "]"]


def _moments(made: Proposal, start: Point, end: Point) -> str:
    """Inertia of a rod between two places about its middle, and of a little thickness."""
    values = {symbol: sympy.Rational(value) for symbol, (value, _) in made.values.items()}
    d = (end - start).subs(values).evalf(30)
    moments = LINK_MASS * ((d.dot(d) * sympy.eye(3) - d * d.T) / 12 + sympy.Rational(1, 5000) * sympy.eye(3))
    rows = ["[" + ", ".join(f'"{float(v):.6f}"' for v in moments.row(i)) + "]" for i in range(3)]
    return f"[{', '.join(rows)}]"


def _points(made: Proposal) -> list[str]:
    """Named points: where loads act and what pictures label."""
    if made.kind == "serial":
        named = [("T", "tool", made.layouts[0].points[-1] + HALF * l * sympy.Matrix([1, 0, 0]))]
    else:
        named = [("E", "platform", made.centre)]
        for k, (limb, layout) in enumerate(zip(made.types, made.layouts, strict=True), start=1):
            named.append((f"A{k}", "base", layout.points[0]))
            if len(limb.letters) > 1:
                named.append((f"C{k}", made.tips[k - 1], layout.points[-1]))
    lines = ["# Named points: labels of pictures, and where a load may act (--load NAME)."]
    for name, body, place in named:
        lines += [f"[points.{name}]", f'body = "{body}"', f"at = {_row(place)}", ""]
    return lines
