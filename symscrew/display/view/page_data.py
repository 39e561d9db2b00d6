"""What the page must know of a mechanism: outlines, joints, limbs, coordinates, and a recorded motion.

Everything is plain data (lists, numbers, texts) in absolute axes in the reference configuration; the poses of
the bodies and all screws are computed in the page by the model's own functions.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from typing import Any

import numpy as np

from symscrew.description import Joint, Mechanism
from symscrew.display.shape import along, drawn_points, numbers, plate
from symscrew.display.view.motion_file import RecordedMotion
from symscrew.display.view.reaches import Reach, joint_limits
from symscrew.display.view.run_time_shape import Outline, tunable
from symscrew.functions import THRESHOLD, joint_freedom_labels, moving_bodies
from symscrew.model import Model

Array = np.ndarray

FUNCTIONS = (
    "body_poses", "joint_screws", "joint_points", "closure", "closure_jacobian", "platform_jacobian", "velocity",
    "acceleration", "body_twists", "momentum_screws", "energy", "joint_reactions", "joint_displacements", "assemble",
    "limb_margins", "constraint_margin", "actuation_margins", "outline",
)  # fmt: skip
MARGINS = {"limb_margins": "limb", "constraint_margin": "constraint", "actuation_margins": "actuation"}
ALL_DRIVES = "all drives"
SINGULAR = 1e-9  # a margin below it in the reference is 0 there, as in maps: nothing can be compared with it
MAX_FRAMES = 1500  # of a motion in the page: 25 s at 60 a second; of more some are chosen, unless all are asked for
MAX_VALUES = 400_000  # of a motion in the page: 4 MB of text; mechanisms with many joints have fewer frames


def functions_of(model: Model) -> tuple[str, ...]:
    """Names of the model's functions that the page calls."""
    return tuple(name for name in FUNCTIONS if name in model.programs)


def page_scene(
    model: Model,
    motion: RecordedMotion | None = None,
    limits: Mapping[str, Reach] | None = None,
    *,
    pictures: Mapping[str, Array] | None = None,
    modes: Mapping[str, Array] | None = None,
) -> dict[str, Any]:
    """The page's data for a model, with a recorded motion if there is one, and limits of joints beside its end stops.

    `pictures`: body -> triangles (n, 3, 3) [m] in absolute axes in the reference configuration, drawn for its outline.
    `modes`: configurations (nq,) by name of assembly modes, between which one can choose.

    Raises:
        DescriptionError: the motion does not belong to this model.
    """
    mechanism, system = model.mechanism, model.system
    bodies = [mechanism.ground, *moving_bodies(system)]
    index = {name: k for k, name in enumerate(bodies)}
    points = drawn_points(mechanism)
    platform = mechanism.platform or bodies[-1]
    shape = Outline(model) if model.system.parameters else None
    return {
        "name": mechanism.name,
        "description": mechanism.description,
        "notes": list(model.notes),
        "effects": [repr(effect) for effect in model.effects],
        "length": system.length,
        "threshold": THRESHOLD,
        "platform": index[platform],
        "platform_named": mechanism.platform is not None,
        "bodies": [_body(mechanism, name, points[name], shape) | _picture(pictures or {}, name) for name in bodies],
        "joints": _joints(model, index, shape),
        "points": [
            {
                "name": p.name,
                "body": index[p.body],
                "at": numbers(mechanism, p.at).tolist(),
                "outline": shape and shape.at(p.at),
            }
            for p in mechanism.points.values()
        ],
        "limits": joint_limits(model, limits or {}),
        "modes": [{"name": name, "q": q.tolist()} for name, q in (modes or {}).items()],
        "tunable": tunable(model),
        "limbs": _limbs(mechanism),
        "drives": _drives(model),
        "independent": _independent(model),
        "quaternions": [link.q.start for link in system.tree.links[1:] if link.q.stop - link.q.start == 4],
        "q_labels": [c.label for c in system.tree.q],
        "v_kinds": [c.kind for c in system.tree.v],
        "reference": system.reference.tolist(),
        "parameters": system.parameter_values.tolist(),
        "margins": _margins(model),
        "functions": {
            name: {
                "inputs": [[port.name, port.size] for port in model.programs[name].inputs],
                "outputs": {port.name: list(port.labels) for port in model.programs[name].outputs},
            }
            for name in functions_of(model)
        },
        "motion": None if motion is None else _motion(model, motion),
    }


def _picture(pictures: Mapping[str, Array], name: str) -> dict[str, str]:
    """Corners of a body's triangles, if there are any: singles, little-endian, in Base64."""
    if name not in pictures:
        return {}
    return {"picture": base64.b64encode(pictures[name].astype("<f4").tobytes()).decode("ascii")}


def _body(mechanism: Mechanism, name: str, places: Array, shape: Outline | None) -> dict[str, Any]:
    """Outline of a body: a plate with struts to what lies outside its plane, or a bar; and its mass."""
    flat = plate(places) if len(places) > 2 else None
    made: dict[str, Any] = {"name": name, "plate": [], "struts": [], "bar": [], "mass": None, "com": None}
    if flat is not None:
        inside, corners = flat
        made["plate"] = corners.tolist()
        made["struts"] = [[corners.mean(axis=0).tolist(), place.tolist()] for place in places[~inside]]
    else:
        made["bar"] = along(places).tolist()
    # the outer part of a sliding pair is drawn thicker than the one that slides in it
    sliding = (j for j in mechanism.joints.values() if j.kind.axes == len(j.kind.sliding) == 1)
    made["outer"] = any(j.parent == name for j in sliding)
    body = mechanism.bodies.get(name)
    if body is not None and body.mass is not None and body.com is not None and name != mechanism.ground:
        made["mass"] = float(mechanism.number(body.mass))
        made["com"] = numbers(mechanism, body.com).tolist()
    if shape is not None:
        struts = [] if flat is None else [shape.near(place) for place in places[~flat[0]]]
        made["outline"] = {key: [shape.near(np.array(p)) for p in made[key]] for key in ("plate", "bar")}
        made["outline"] |= {"struts": struts, "com": shape.at(body.com) if body and body.com and made["com"] else None}
    return made


def _joints(model: Model, index: dict[str, int], shape: Outline | None) -> list[dict[str, Any]]:
    mechanism = model.mechanism
    labels = joint_freedom_labels(model.system)
    owners = [name for _, _, name in labels]
    return [
        {
            "name": joint.name,
            "type": joint.type,
            "parent": index[joint.parent],
            "child": index[joint.child],
            "point": numbers(mechanism, joint.point).tolist(),
            "axes": [_unit(numbers(mechanism, axis)) for axis in joint.axes],
            "kinds": [_kind(joint, k) for k in range(joint.kind.freedom)],
            "driven": list(joint.driven),
            "pitch": None if joint.pitch is None else float(mechanism.number(joint.pitch)),
            "screws": owners.index(joint.name) if joint.name in owners else 0,
            "freedoms": [label for label, _, name in labels if name == joint.name],
            "outline": shape and {"point": shape.at(joint.point), "axes": [shape.at(axis) for axis in joint.axes]},
        }
        for joint in mechanism.joints.values()
    ]


def _kind(joint: Joint, freedom: int) -> str:
    """The kind of a joint's freedom: "turn", "slide" or "screw"."""
    motion = joint.kind.freedoms[freedom]
    return "screw" if motion.helical else "slide" if motion.prismatic else "turn"


def _unit(vector: Array) -> list[float]:
    unit: list[float] = (vector / np.linalg.norm(vector)).tolist()
    return unit


def _limbs(mechanism: Mechanism) -> list[dict[str, Any]]:
    names = list(mechanism.joints)
    return [
        {"name": limb.name, "joints": [names.index(joint) for joint in limb.joints]}
        for limb in mechanism.limbs.values()
    ]


def _drives(model: Model) -> list[dict[str, Any]]:
    names = list(model.mechanism.joints)
    if "joint_reactions" not in model.programs or not model.system.drives:
        return []
    port = next(p for p in model.programs["joint_reactions"].outputs if p.name == "u")
    return [
        {"joint": names.index(joint), "freedom": freedom, "label": label, "unit": unit}
        for (joint, freedom), label, unit in zip(model.system.drives, port.labels, port.units, strict=True)
    ]


def _independent(model: Model) -> list[dict[str, Any]]:
    """The independent coordinates y: entry of q, kind, for a quaternion's component where it starts, what they move.

    `axis`: of free joints, of the platform's own motion and of rotation vectors, x, y or z.
    """
    tree = model.system.tree
    at = {c.label: k for k, c in enumerate(tree.q)}
    pose = {k.q.start: "xyz"[k.motion.axis or 0] for k in tree.links[1:]
            if k.motion.prismatic and (tree.joints[k.joint].kind.unconstrained or k.joint == tree.virtual)}  # fmt: skip
    result = []
    for label in next(p for p in model.programs["velocity"].inputs if p.name == "y_dot").labels:
        entry = at[label]
        start = next(
            (k.q.start for k in tree.links[1:] if k.q.stop - k.q.start == 4 and k.q.start <= entry < k.q.stop), None
        )
        kind = "turn" if start is not None else tree.q[entry].kind
        axis = pose.get(entry) if start is None else label[-1]
        name = label if start is None else f"{label[:-2]}r{label[-1]}"  # the slider is an angle, no entry
        made = {"label": label, "name": name, "q": entry, "kind": kind, "unit": tree.q[entry].unit, "quaternion": start}
        result.append(made | {"axis": axis})
    return result


def _margins(model: Model) -> list[dict[str, Any]]:
    """Every margin from a singularity: function, entry, name, and its value in the reference; 0 if singular there.

    Of the actuation margins only that of all drives: those of some drives are for who locks only these.
    """
    made = []
    for function in MARGINS:
        if function not in model.programs:
            continue
        port = model.programs[function].outputs[0]
        values = model.system.parameter_values
        (found,), _ = model(function, model.system.reference[None], *([values[None]] if len(values) else []))
        for k, (label, start) in enumerate(zip(port.labels, found[0], strict=True)):
            if function != "actuation_margins" or label == ALL_DRIVES:
                name = label if function == "limb_margins" else MARGINS[function]
                known = float(start) if abs(start) > SINGULAR else 0.0
                made.append({"function": function, "entry": k, "name": name, "start": known})
    return made


def _motion(model: Model, motion: RecordedMotion) -> dict[str, Any]:
    """The motion as little-endian 8-byte numbers in base64, those of the file.

    Of more states than a page should hold those in which a value is least or largest, and others at even distances: no
    peak is lost, and every number that is shown at one of them is a number of the file.
    """
    motion.check(model)
    arrays = {"t": motion.t[:, None], "q": motion.q, "v": motion.v, "u": motion.u, "reactions": motion.reactions}
    given = {name: array for name, array in arrays.items() if array is not None}
    columns = sum(array.shape[1] for array in given.values())
    frames = motion.frames or min(MAX_FRAMES, max(2, MAX_VALUES // columns))
    chosen = np.arange(len(motion.t))
    if len(motion.t) > frames:
        peaks = np.unique([k for a in given.values() for k in (*a.argmin(axis=0), *a.argmax(axis=0))])
        even = np.round(np.linspace(0, len(motion.t) - 1, max(2, frames - len(peaks)))).astype(int)
        chosen = np.union1d(peaks, even)
    packed = {name: base64.b64encode(array[chosen].astype("<f8").tobytes()).decode() for name, array in given.items()}
    return {"recorded": len(motion.t), "frames": len(chosen), "arrays": packed}
