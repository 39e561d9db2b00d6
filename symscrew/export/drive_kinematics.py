"""Kinematics between drives and a tool, as controllers want them: which functions, which axes, which way back.

    drives (coordinates of q)  --assemble, from the last configuration-->  q  --body_poses-->  X Y Z A B C of the tool

Every step is proved to stay on the mode of the one before (`symscrew.export.mode_certificate`).
The functions are those of the mechanism derived with some of its drives as the independent coordinates: then `assemble`
is the forward kinematics, on the branch of its guess. Of more drives than freedoms the others are compared with what q
says. A controller commands as many axes as there are freedoms: a platform that turns about a fixed point of its own has
A, B, C (R = Rz(C) Ry(B) Rx(A)), any other X, Y, Z of its tool first. Back to the drives leads `inverse_kinematics`
where it is a closed form of these axes alone, else Newton's iteration.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.description import longer_name
from symscrew.errors import DescriptionError
from symscrew.export.mode_certificate import ModeCertificate, find_mode_certificate
from symscrew.model import Model, derive

LETTERS = "XYZABC"
TOOLS = ("tool", "tcp", "tip", "E")  # names of points that are taken for the tool, the first that the platform has
NEEDED = ("assemble", "null_space", "body_poses", "platform_jacobian")
MARGINS = ("limb_margins", "actuation_margins")
DEPENDENT = 1e-6  # a direction of unit size whose part beside others is below this adds none: states are exact to 1e-12
FIXED = 1e-9  # of the characteristic length: a point that moves less, per unit of rotation, does not move
SAME = 1e-11  # poses of two functions at consistent states agree to rounding, some 1e-15, or differ by the geometry


@dataclass(frozen=True)
class Pose:
    """The pose that `inverse_kinematics` takes, of the platform's rotation R and displacement t.

    `entries`: "X", "Y", "Z" of R centre + t, and "w", "x", "y", "z" of the quaternion of R; none where there
    is no closed form.
    """

    entries: tuple[str, ...] = ()
    centre: tuple[float, ...] = ()


NO_POSE = Pose()


@dataclass(frozen=True)
class DriveKinematics:
    """What a controller's module is made of.

    Attributes:
        model: named `<name>_drives`, with the functions that it needs and no others.
        drives: labels of the drives, the controller's joints in their order.
        driven: entries of q that they are.
        chosen: those of the drives (places in `drives`) that `assemble` takes as y, in its order.
        scalar: pairs (entry of q, entry of v) of coordinates that are angles or lengths.
        sliding: entries of q that are lengths.
        platform: place of the platform among the bodies of `body_poses`.
        tool: point of the tool in absolute axes at the reference.
        axes: places in LETTERS of the axes that are commanded.
        pose: what `inverse_kinematics` takes, where it is the way back to the drives.
        certificate: what proves that a step stays on its mode.
    """

    model: Model
    drives: tuple[str, ...]
    driven: tuple[int, ...]
    chosen: tuple[int, ...]
    scalar: tuple[tuple[int, int], ...]
    sliding: tuple[int, ...]
    platform: int
    tool: tuple[float, ...]
    axes: tuple[int, ...]
    pose: Pose
    certificate: ModeCertificate

    def values(self, name: str, q: np.ndarray) -> np.ndarray:
        """The first output (states, size) of a function of q, where run-time parameters have their declared values."""
        return at_declared(self.model, name, q)


def find_drive_kinematics(model: Model) -> DriveKinematics:
    """The kinematics between the drives of a model's mechanism and its platform.

    Raises:
        DescriptionError: it has no loops, no drives, drives that do not move all freedoms, or drives of joints that are
            cut where its loops are opened; the text says which.
    """
    whole = derive(model.mechanism, model.effects) if model.selected else model
    system, name = model.system, model.name
    if not model.independent:
        still, open_chain = "that moves, it has no freedom", "with loops; of open chains the controllers have their own"
        raise DescriptionError(f"{name}: expected a mechanism {still if system.cuts else open_chain}")
    if not model.mechanism.platform:
        raise DescriptionError(f"{name}: expected a platform, the body that carries the tool; name it in [mechanism]")
    q_labels, v_labels = [x.label for x in system.tree.q], [x.label for x in system.tree.v]
    drives = tuple(_drive_label(joint, freedom, q_labels) for joint, freedom in system.drives)
    lost = [label for label in drives if label not in q_labels]
    if lost or not drives:
        what = f"{lost[0]} is none" if lost else "there are none"
        raise DescriptionError(f"{name}: expected drives that are coordinates of q ({', '.join(q_labels)}), {what}")
    rates = _drive_rates(whole, drives, v_labels)
    chosen = independent_rows(rates, len(model.independent))
    if len(chosen) < len(model.independent):
        text = f"{len(chosen)} of {len(model.independent)} freedoms; drive more joints"
        raise DescriptionError(f"{name}: the drives {', '.join(drives)} move {text}")
    labels = [drives[k] for k in chosen]
    own = whole if tuple(labels) == whole.independent else derive(model.mechanism, model.effects, independent=labels)
    order = tuple(drives.index(label) for label in own.independent)
    platform = _platform(own)
    point = tool_point(own)
    axes = _axes(own, platform, point)
    known = len(axes) == len(LETTERS) or _orientation_is_constant(own, platform, axes)
    pose = _closed_form(own, platform) if known else NO_POSE
    keep = [f for f in (*NEEDED, *MARGINS, *(["inverse_kinematics"] if pose.entries else [])) if f in own.programs]
    return DriveKinematics(
        model=replace(own.only(keep), name=longer_name(name, "_drives")),
        drives=drives,
        driven=tuple(q_labels.index(label) for label in drives),
        chosen=order,
        scalar=tuple((k, v_labels.index(x)) for k, x in enumerate(q_labels) if x in v_labels),
        sliding=tuple(k for k, x in enumerate(system.tree.q) if x.unit == "m"),
        platform=platform,
        tool=tuple(float(x) for x in point),
        axes=axes,
        pose=pose,
        certificate=find_mode_certificate(own, [q_labels.index(drives[k]) for k in order]),
    )


def _drive_label(joint: str, freedom: int, labels: Sequence[str]) -> str:
    """The label in q of a driven freedom of a joint."""
    return joint if joint in labels else f"{joint}.{freedom}"


def _drive_rates(model: Model, drives: Sequence[str], labels: Sequence[str]) -> np.ndarray:
    """Rates of the drives by those of the independent coordinates at the reference, without units."""
    null = _null_space(model, model.system.reference)
    return np.array([null[labels.index(drive)] for drive in drives])


def at_declared(model: Model, name: str, q: np.ndarray) -> np.ndarray:
    """The first output (states, size) of a function of q, where run-time parameters have their declared values."""
    parameters = (np.array(model.system.parameter_values),) if len(model.programs[name].inputs) > 1 else ()
    outputs, _ = model(name, q, *parameters)
    found: np.ndarray = outputs[0]
    return found


def _null_space(model: Model, q: np.ndarray) -> np.ndarray:
    """(rates, freedoms), the columns of unit size."""
    found = at_declared(model, "null_space", np.array(q)[None])
    null: np.ndarray = found[0].reshape(model.programs["null_space"].outputs[0].shape[::-1]).T
    sized: np.ndarray = null / np.linalg.norm(null, axis=0)
    return sized


def independent_rows(rows: np.ndarray, count: int) -> list[int]:
    """Places of up to `count` rows, the first ones that are independent of those before them."""
    found: list[int] = []
    basis = np.zeros((0, rows.shape[1]))
    largest = max(float(np.linalg.norm(rows, axis=1).max(initial=0.0)), DEPENDENT)
    for k, row in enumerate(rows):
        rest = row - basis.T @ (basis @ row)
        rest = rest - basis.T @ (basis @ rest)
        size = float(np.linalg.norm(rest))
        if size > DEPENDENT * largest and len(found) < count:
            found.append(k)
            basis = np.vstack([basis, rest / size])
    return found


def _platform(model: Model) -> int:
    labels = model.programs["body_poses"].outputs[0].labels
    bodies = [label.rpartition(".")[0] for label in labels[::12]]  # a rotation matrix and a point each
    return bodies.index(str(model.mechanism.platform))


def poses(model: Model, q: np.ndarray, body: int) -> tuple[np.ndarray, np.ndarray]:
    """Rotations (states, 3, 3) and displacements (states, 3) of a body, from the reference."""
    found = at_declared(model, "body_poses", q)
    own = found[:, 12 * body : 12 * body + 12].reshape(-1, 4, 3)
    return own[:, :3].swapaxes(1, 2), own[:, 3]


def _at(model: Model, point: Sequence[object]) -> np.ndarray:
    """A point of the description as numbers, the same on every machine."""
    return np.array([float(model.mechanism.number(x)) for x in point])


def own_points(model: Model) -> dict[str, np.ndarray]:
    """The platform's named points in absolute axes at the reference."""
    points = model.mechanism.points
    return {name: _at(model, p.at) for name, p in points.items() if p.body == model.mechanism.platform}


def tool_point(model: Model) -> np.ndarray:
    """The tool in absolute axes at the reference: a point of the platform with a usual name, else its first, else O."""
    name = tool_name(model)
    return np.zeros(3) if name is None else own_points(model)[name]


def tool_name(model: Model) -> str | None:
    """The point of the platform that is taken for the tool; None where it has no named points."""
    points = own_points(model)
    return next((n for n in (*TOOLS, *points) if n in points), None)


def _twists(model: Model, q: np.ndarray) -> np.ndarray:
    """Angular velocity and velocity of O (6, freedoms) of the platform for unit motions."""
    found = at_declared(model, "platform_jacobian", np.array(q)[None])
    jacobian = found[0].reshape(-1, 6).T
    twists: np.ndarray = jacobian @ _null_space(model, q)
    return twists


def _axes(model: Model, platform: int, tool: np.ndarray) -> tuple[int, ...]:
    """The axes that are commanded."""
    count, length = len(model.independent), float(model.system.length)
    states = np.atleast_2d(model.system.sample_states[0])
    about = _twists(model, model.system.reference)
    fixed = False
    for point in own_points(model).values():
        moves = []
        for q in states:
            rotation, shift = (x[0] for x in poses(model, q[None], platform))
            twist = _twists(model, q)
            at = rotation @ point + shift
            moves.append(np.abs(twist[3:] + np.cross(twist[:3].T, at).T).max() / length)
        fixed = fixed or max(moves) < FIXED
    rotation, shift = (x[0] for x in poses(model, np.array(model.system.reference)[None], platform))
    at = rotation @ tool + shift
    linear = (about[3:] + np.cross(about[:3].T, at).T) / length
    rows = np.vstack([np.zeros_like(linear) if fixed else linear, about[:3]])
    return tuple(independent_rows(rows, count))


def _orientation_is_constant(model: Model, platform: int, axes: Sequence[int]) -> bool:
    """Whether the platform does not turn, so that its axes X, Y, Z say its pose."""
    rotation, _ = poses(model, np.atleast_2d(model.system.sample_states[0]), platform)
    return tuple(axes) == (0, 1, 2) and float(np.abs(rotation - np.eye(3)).max()) < SAME


def _closed_form(model: Model, platform: int) -> Pose:
    """What the pose of `inverse_kinematics` is made of, if it is the displacement of the platform."""
    program = model.programs.get("inverse_kinematics")
    if program is None or program.inputs[0].size != 7:  # three lengths and a quaternion
        return NO_POSE
    q_labels = [x.label for x in model.system.tree.q]
    at = [q_labels.index(label) for label in program.inputs[0].labels]
    turned = program.inputs[0].forms.index("quaternion") if "quaternion" in program.inputs[0].forms else -1
    if turned not in (0, 3):
        return NO_POSE
    q = np.atleast_2d(model.system.sample_states[0])
    rotation, shift = poses(model, q, platform)
    own = q[:, at]
    w, x, y, z = own[:, turned : turned + 4].T
    quaternion = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip
    differs = np.abs(quaternion.transpose(2, 0, 1) - rotation).max()
    lengths_at = at[4:] if turned == 0 else at[:3]
    centre = np.array(model.system.reference)[lengths_at]  # where the platform is not turned and not moved
    wanted = rotation @ centre + shift
    if differs > SAME or np.abs(q[:, lengths_at] - wanted).max() > SAME * float(model.system.length):
        return NO_POSE
    names = ("X", "Y", "Z", "w", "x", "y", "z") if turned else ("w", "x", "y", "z", "X", "Y", "Z")
    return Pose(names, tuple(map(float, centre)))
