"""A picture of any mechanism, in its reference configuration or in poses of its bodies, drawn from its description.

Bodies are bars between their joint points, or plates where three or more of their points lie in a plane; joints are
markers by type, the driven ones filled, their axes lines where the mechanism is an open chain; the base is hatched.
What is farther from the viewer is drawn first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from symscrew.description import JOINT_TYPES, Joint, Mechanism
from symscrew.display.label_places import label_places
from symscrew.display.plots import COLOURS, curve_style, indexed_symbol
from symscrew.display.shape import along, body_points, drawn_points, numbers, plate

Array = np.ndarray
Pose = tuple[Array, Array]
"""Rotation (3, 3) and translation (3,) of a body from the reference configuration, absolute axes."""
STILL: Pose = (np.eye(3), np.zeros(3))

MARKERS = {"R": "o", "P": "s", "H": "h", "C": "p", "U": "D", "S": "o", "E": "^", "fixed": "x", "free": "*"}
OTHER_MARKER = "v"
SIZES = {"R": 5.0, "P": 5.0, "S": 8.0, "U": 6.5}
GROUND, PLATFORM, LINK = "#8a8a8a", COLOURS[0], "#3a3a3a"
OBLIQUE = ((20.0, -62.0), (20.0, -28.0), (20.0, -152.0), (20.0, 28.0))
"""Elevation and azimuth [degrees] of views in which all three axes are seen, none hidden by another; the first of them
that shows no plate by its edge."""
EDGE = 0.17  # sine of the angle between a view and a plate, under which the plate is a line: ten degrees
ALONG = ((0.0, 0.0), (0.0, -90.0), (90.0, -90.0))  # the same, along x, y and z
PARALLEL = 1 - 1e-9  # cosine of two directions that are one: beyond what rounding leaves of unit vectors
SAME, RIM = 0.005, 3.4
"""How near marks of joints are one place, of the mechanism's size; how much larger one under another is [points]."""
HATCH = 0.055  # width of the base's sign, of the mechanism's size
AXIS = 0.16  # length of a joint's axis, of the mechanism's size
NAMED = 6.5  # radius of what the name of an absolute axis takes [points of type]
CLOSE = (2.0, 6.0, 11.0)  # how far such a name is from its arrow's end [points of type]
LETTER = (5.0, 9.5)  # width of a letter and height of a line [points of type], of names at 9 points


@dataclass(frozen=True)
class Camera:
    """A view in perspective: rows of `axes` are right, up and towards the viewer; `distance` from `middle`."""

    axes: Array
    middle: Array
    distance: float

    def __call__(self, points: Array) -> Array:
        """Points (..., 3) on the picture (..., 2)."""
        seen = (points - self.middle) @ self.axes.T
        on_picture: Array = seen[..., :2] * (self.distance / (self.distance - seen[..., 2:]))
        return on_picture

    def depth(self, points: Array) -> float:
        """How near to the viewer points (n, 3) are on average."""
        return float(((points - self.middle) @ self.axes[2]).mean())


def camera(points: Array, elevation: float, azimuth: float) -> Camera:
    """A view on points from a direction [degrees]: azimuth about z from x, elevation above the x-y plane."""
    towards, z = _towards(elevation, azimuth), np.radians(azimuth)
    right = np.array([-np.sin(z), np.cos(z), 0.0])
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    extent = float(np.linalg.norm(np.ptp(points, axis=0))) or 1.0
    return Camera(np.stack([right, np.cross(towards, right), towards]), middle, 3.5 * extent)


def _towards(elevation: float, azimuth: float) -> Array:
    """The unit vector to the viewer."""
    e, z = np.radians(elevation), np.radians(azimuth)
    return np.array([np.cos(e) * np.cos(z), np.cos(e) * np.sin(z), np.sin(e)])


def usual_view(mechanism: Mechanism) -> tuple[float, float]:
    """Elevation and azimuth [degrees]: along the axes of a planar mechanism, else obliquely from the front."""
    turning = [j for j in mechanism.joints.values() if any(motion.turns for motion in j.kind.motions)]
    axes = [numbers(mechanism, j.axes[0]) for j in turning if j.kind.hinge]
    if axes and len(axes) == len(turning):
        for k, seen in enumerate(ALONG):
            if all(abs(axis[k]) > PARALLEL * np.linalg.norm(axis) for axis in axes):
                return seen
    normals = [_normal(found[1]) for p in drawn_points(mechanism).values() if len(p) > 2 and (found := plate(p))]
    shown = [min((abs(float(_towards(*seen) @ normal)) for normal in normals), default=1.0) for seen in OBLIQUE]
    return next((seen for seen, sine in zip(OBLIQUE, shown, strict=True) if sine > EDGE), OBLIQUE[0])


def _normal(corners: Array) -> Array:
    """Unit normal of a plate."""
    sides = corners - corners[0]
    longest: Array = max(np.cross(sides[1], sides[2:]), key=np.linalg.norm)
    normal: Array = longest / np.linalg.norm(longest)
    return normal


@dataclass(frozen=True)
class Sketch:
    """A mechanism as it is drawn: where its bodies are, the view, and how large all of it is [m]."""

    mechanism: Mechanism
    view: Camera
    size: float
    poses: Mapping[str, Pose]

    def moved(self, body: str, places: Array) -> Array:
        """Places (..., 3) of a body in the reference, as it carries them."""
        turn, shift = self.poses.get(body, STILL)
        carried: Array = places @ turn.T + shift
        return carried

    def seen(self, body: str, places: Array) -> Array:
        """The same on the picture (..., 2)."""
        return self.view(self.moved(body, places))

    def joint(self, joint: Joint) -> Array:
        """Where a joint is drawn: at its child's point."""
        return self.seen(joint.child, numbers(self.mechanism, joint.point))


def mechanism_figure(
    mechanism: Mechanism,
    *,
    elevation: float | None = None,
    azimuth: float | None = None,
    width: float = 4.6,
    labels: bool = True,
) -> Figure:
    """The mechanism in its reference configuration, with its named points and absolute axes.

    Seen from `elevation` and `azimuth` [degrees]; by default along the axes where all joints turn about parallel ones.
    """
    return drawn_in(mechanism, {}, elevation=elevation, azimuth=azimuth, width=width, labels=labels)


def drawn_in(
    mechanism: Mechanism,
    poses: Mapping[str, Pose],
    *,
    elevation: float | None = None,
    azimuth: float | None = None,
    width: float = 4.6,
    labels: bool = True,
    behind: Sequence[Mapping[str, Pose]] = (),
) -> Figure:
    """The mechanism with its bodies in poses; `behind`: others, drawn pale under it."""
    points = drawn_points(mechanism)
    every = [Sketch(mechanism, camera(np.zeros((1, 3)), 0, 0), 1.0, given) for given in (*behind, poses)]
    all_of_it = [s.moved(body, p) for s in every for body, p in points.items() if len(p)]
    whole = np.concatenate(all_of_it or [np.zeros((1, 3))])
    usual = usual_view(mechanism)
    view = camera(whole, usual[0] if elevation is None else elevation, usual[1] if azimuth is None else azimuth)
    size = 0.5 * float(np.ptp(whole, axis=0).max()) or 1.0
    with curve_style():
        shape = np.ptp(view(np.concatenate([whole, 0.4 * size * np.eye(3)])), axis=0)
        made = Figure(figsize=(width, width * float(np.clip(shape[1] / shape[0], 0.3, 1.2))))
        FigureCanvasAgg(made)
        axes = made.add_axes((0.0, 0.0, 1.0, 1.0))
        for k, given in enumerate(behind):
            draw_bodies(axes, Sketch(mechanism, view, size, given), fade=0.16 + 0.3 * k / len(behind))
        sketch = Sketch(mechanism, view, size, poses)
        draw_bodies(axes, sketch)
        _frame(axes, view, size)
        draw_joints(axes, sketch)
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.08)
        axes.set_axis_off()
        taken = _axis_names(axes, sketch)
        if labels:
            _labels(axes, sketch, taken)
        handles = _legend(mechanism)
        axes.legend(handles=handles, loc="upper center", ncols=min(4, len(handles)), bbox_to_anchor=(0.5, -0.01))
    return made


# -- bodies ----------------------------------------------------------------------------------------------


def draw_bodies(axes: Axes, sketch: Sketch, *, fade: float = 1.0) -> None:
    """Bodies from far to near; `fade` below 1: pale."""
    mechanism = sketch.mechanism
    bodies = [(name, places) for name, places in drawn_points(mechanism).items() if len(places)]
    if fade == 1.0:
        _base(axes, sketch)
    far_to_near = sorted(bodies, key=lambda item: _depth(sketch, item[0], sketch.moved(*item)))
    for order, (body, places) in enumerate(far_to_near):
        if fade < 1.0 and body == mechanism.ground:
            continue
        for line in _lines(sketch, body, places):
            colour = _colour(mechanism, body)
            if line.filled:
                axes.fill(
                    *line.points.T, facecolor=colour, alpha=0.16 * fade, edgecolor="none", zorder=2 + 0.01 * order
                )
            look: dict[str, Any] = {"solid_capstyle": "round"} if line.style == "-" else {}
            axes.plot(
                *line.points.T, color=colour, linewidth=line.width, linestyle=line.style, alpha=fade,
                zorder=2 + 0.01 * order, **look,
            )  # fmt: skip


@dataclass(frozen=True)
class _Line:
    points: Array
    width: float
    style: Any = "-"
    filled: bool = False


def _lines(sketch: Sketch, body: str, places: Array) -> Iterator[_Line]:
    """A plate where three or more points lie in a plane, else a bar along the points: lines on the picture."""
    flat = plate(places) if len(places) > 2 else None
    bar = _bar(sketch.mechanism, body)
    if flat is None:
        if bar:
            yield _Line(sketch.seen(body, along(places)), bar)
        return
    inside, corners = flat
    yield _Line(sketch.seen(body, np.vstack([corners, corners[:1]])), 1.5, filled=True)
    middle = corners.mean(axis=0)
    for place in places[~inside]:
        yield _Line(sketch.seen(body, np.vstack([middle, place])), 1.5, (0, (4, 1.5)))


def _depth(sketch: Sketch, body: str, places: Array) -> float:
    return -np.inf if body == sketch.mechanism.ground else sketch.view.depth(places)


def _colour(mechanism: Mechanism, body: str) -> str:
    return GROUND if body == mechanism.ground else PLATFORM if body == mechanism.platform else LINK


def _bar(mechanism: Mechanism, body: str) -> float:
    """Width of a body that is a bar [points of type]; 0 for the ground, which is none."""
    if body == mechanism.ground:
        return 0.0
    # the outer part of a sliding pair is drawn thicker than the one that slides in it
    outer = any(j.kind.slider and j.parent == body for j in mechanism.joints.values())
    return 4.6 if outer else 2.2


def _base(axes: Axes, sketch: Sketch) -> None:
    """The sign of what stands still under the joints of the ground, where that is no plate."""
    mechanism = sketch.mechanism
    places = body_points(mechanism)[mechanism.ground]
    own = [numbers(mechanism, j.point) for j in mechanism.joints.values() if mechanism.ground in (j.parent, j.child)]
    if len(places) > 2 and plate(places) is not None:
        return
    width = 2 * HATCH * sketch.size
    for place in own:
        x, y = sketch.view(place)
        top = y - 0.55 * width
        look: dict[str, Any] = {"color": GROUND, "linewidth": 0.9, "zorder": 1.5}
        axes.plot([x - width, x, x + width, x - width], [top, y, top, top], **look)
        for k in range(5):
            left = x - width + (k + 0.4) * width / 2.2
            axes.plot([left, left - 0.3 * width], [top, top - 0.3 * width], **look)


# -- joints ----------------------------------------------------------------------------------------------


def draw_joints(axes: Axes, sketch: Sketch) -> None:
    """A mark by type, driven ones above others that stand at the same place; the axes of an open chain, which its marks
    do not tell."""
    mechanism = sketch.mechanism
    ordered = sorted(mechanism.joints.values(), key=lambda joint: bool(joint.driven))
    places = np.array([sketch.joint(joint) for joint in ordered]).reshape(-1, 2)
    open_chain = len(mechanism.joints) <= len(mechanism.bodies) - (mechanism.ground in mechanism.bodies)
    for k, joint in enumerate(ordered):
        above = int((np.abs(places[k + 1 :] - places[k]).max(axis=1, initial=0.0) < SAME * sketch.size).sum())
        if open_chain and joint.kind.axes == 1:
            axis = numbers(mechanism, joint.axes[0])
            reach = AXIS * 2 * sketch.size * axis / np.linalg.norm(axis)
            ends = sketch.seen(joint.parent, numbers(mechanism, joint.point) + np.array([-reach, reach]))
            axes.plot(*ends.T, color=COLOURS[1], linewidth=0.8, linestyle=(0, (7, 2, 1.5, 2)), zorder=4.2)
        axes.plot(
            *places[k], **_marker(joint.type, above),
            color="black", markerfacecolor=COLOURS[1] if joint.driven else "white", markeredgewidth=0.9,
            linestyle="none", zorder=5,
        )  # fmt: skip


def _frame(axes: Axes, view: Camera, size: float) -> None:
    """The absolute axes at O."""
    start = view(np.zeros(3))
    for axis in np.eye(3):
        end = view(0.36 * size * axis)
        if abs(axis @ view.axes[2]) > PARALLEL:  # it points at the viewer
            continue
        arrow = {"arrowstyle": "-|>,head_width=0.18,head_length=0.4", "color": COLOURS[2], "linewidth": 1.1}
        axes.annotate(
            "", xy=_pair(end), xytext=_pair(start), arrowprops={**arrow, "shrinkA": 0, "shrinkB": 0}, zorder=4
        )
        axes.plot(*end, alpha=0.0)  # an arrow alone does not count for the limits


def _axis_names(axes: Axes, sketch: Sketch) -> Array:
    """Names of the absolute axes, before their arrows where nothing is in the way; their middles [points of type].

    The picture's limits are final.
    """
    view = sketch.view
    shown = [(0.36 * sketch.size * axis, name) for axis, name in zip(np.eye(3), "xyz", strict=True)
             if abs(axis @ view.axes[2]) <= PARALLEL]  # fmt: skip
    ends = _typed(axes, view(np.array([end for end, _ in shown])))
    sizes = np.tile(LETTER, (len(shown), 1))
    middle = _typed(axes, view(np.zeros(3)))
    found = label_places(ends, sizes, bars=_bars(axes, sketch), joints=_joints(axes, sketch), middle=middle, far=CLOSE)
    for (place, name), end, box in zip(shown, ends, found, strict=True):
        axes.annotate(
            f"${name}$", xy=_pair(view(place)), xytext=_pair(box - end), textcoords="offset points",
            color=COLOURS[2], ha="center", va="center", zorder=7,
        )  # fmt: skip
    return found


def _typed(axes: Axes, places: Array) -> Array:
    """Places of the picture (..., 2) in points of type."""
    axes.apply_aspect()
    made: Array = axes.transData.transform(places) * 72 / axes.figure.dpi
    return made


def _bars(axes: Axes, sketch: Sketch) -> list[tuple[Array, Array]]:
    """All lines that are drawn, and the absolute axes, each from one end to the other [points of type]."""
    lines = [_typed(axes, np.asarray(line.get_xydata())) for line in axes.lines]
    start = _typed(axes, sketch.view(np.zeros(3)))
    lines += [np.array([start, _typed(axes, sketch.view(0.36 * sketch.size * e))]) for e in np.eye(3)]
    return [ends for line in lines for ends in pairwise(line)]


def _joints(axes: Axes, sketch: Sketch) -> Array:
    """Places and radii of the joints' marks (n, 3) [points of type]."""
    joints = sketch.mechanism.joints.values()
    return np.array([(*_typed(axes, sketch.joint(j)), SIZES.get(j.type, 6.0) / 2 + 1) for j in joints]).reshape(-1, 3)


def _pair(vector: Array) -> tuple[float, float]:
    return float(vector[0]), float(vector[1])


def _labels(axes: Axes, sketch: Sketch, taken: Array) -> None:
    """Names of the named points, off joints, bars, each other and what is `taken`; the picture's limits are final."""
    mechanism = sketch.mechanism
    at = np.array([sketch.seen(p.body, numbers(mechanism, p.at)) for p in mechanism.points.values()]).reshape(-1, 2)
    if not len(at):
        return
    names = [indexed_symbol(name) for name in mechanism.points]
    wide = [max(1, len(name.replace("$", "").replace("_", "").replace("{", "").replace("}", ""))) for name in names]
    marks = np.vstack([_joints(axes, sketch), *((*middle, NAMED) for middle in taken)])
    sizes = np.array([(LETTER[0] * count, LETTER[1]) for count in wide])
    typed = _typed(axes, at)
    found = label_places(typed, sizes, bars=_bars(axes, sketch), joints=marks, middle=typed.mean(axis=0))
    for name, place, start, box in zip(names, at, typed, found, strict=True):
        axes.plot(*place, marker=".", markersize=4.0, color="black", linestyle="none", zorder=4.5)
        axes.annotate(
            name, xy=_pair(place), xytext=_pair(box - start), textcoords="offset points",
            ha="center", va="center", zorder=7,
        )  # fmt: skip


def _marker(letter: str, above: int = 0) -> dict[str, Any]:
    """How joints of a type are marked, with so many others above; one without a mark of its own as a triangle."""
    return {"marker": MARKERS.get(letter, OTHER_MARKER), "markersize": SIZES.get(letter, 6.0) + RIM * above}


def _legend(mechanism: Mechanism) -> list[Line2D]:
    kinds = dict.fromkeys((j.type, bool(j.driven)) for j in mechanism.joints.values())
    handles = [
        Line2D(
            [], [], **_marker(kind), color="black", linestyle="none",
            markerfacecolor=COLOURS[1] if driven else "white",
            label=f"{JOINT_TYPES[kind].name}{', driven' if driven else ''}",
        )
        for kind, driven in kinds
    ]  # fmt: skip
    if mechanism.platform:
        handles.append(Line2D([], [], color=PLATFORM, linewidth=2, label=mechanism.platform))
    return handles
