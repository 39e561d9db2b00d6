"""What a sweep tells of every case in its configuration: displacements, points, drives at rest, quality, margins."""

from __future__ import annotations

import numpy as np

from symscrew.export import tool_name
from symscrew.model import Model
from symscrew.studies.workspace.configurations import Call, start_margins

Array = np.ndarray
SINGULAR = 1e-9  # of R, relative: below, the platform has twists that no rates give, and the condition is infinite


def columns_at(model: Model, call: Call, q: Array, extra: tuple[Array, ...], *, stiffness: float) -> dict[str, Array]:
    """Result -> values (cases) at configurations q (cases, nq) and run-time parameters `extra`, if there are any."""
    results = _kinematics(model, call, q, extra)
    results |= _statics(model, call, q, extra)
    results |= _quality(model, call, q, extra, stiffness=stiffness)
    return results | _margins(model, call, q, extra)


def result_units(model: Model) -> dict[str, str]:
    """Result -> unit, of all that every case has; axes and varied parameters are results as well."""
    units = {"condition": "1", "stiffness least": "N m", "stiffness largest": "N m"} if _moved_by_drives(model) else {}
    port = model.programs["joint_displacements"].outputs[0]
    units |= dict(zip(port.labels, port.units, strict=True))
    if "forward_kinematics" in model.programs:
        port = model.programs["forward_kinematics"].outputs[0]
        units |= {f"point {label}": "m" for label in port.labels if label.rpartition(".")[0] in _moving(model)}
    if "inverse_dynamics" in model.programs:
        port = model.programs["inverse_dynamics"].outputs[0]
        units |= {f"drive {label}": unit for label, unit in zip(port.labels, port.units, strict=True)}
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        if kind in model.programs:
            units |= {f"{kind.split('_')[0]} {n}": "1" for n in model.programs[kind].outputs[0].labels}
            units["margin"] = "1"
    return units | dict.fromkeys(("reached", "around", "regular", "allowed", "status"), "1")


def _moved_by_drives(model: Model) -> bool:
    """Whether there is a platform whose motion the drives determine, so that it has a condition and a stiffness."""
    named = model.mechanism.platform is not None and "platform_jacobian" in model.programs
    return named and bool(model.system.drives)


def _moving(model: Model) -> set[str]:
    """Points of the description that move."""
    return {name for name, p in model.mechanism.points.items() if p.body != model.mechanism.ground}


def _kinematics(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Displacements of all joints [rad, m] and places of the points that move [m]."""
    port = model.programs["joint_displacements"].outputs[0]
    found = call("joint_displacements", q, *extra)[0][0]
    results = {label: found[:, k] for k, label in enumerate(port.labels)}
    if "forward_kinematics" in model.programs:
        port = model.programs["forward_kinematics"].outputs[0]
        places = call("forward_kinematics", q, *extra)[0][0]
        moving = _moving(model)
        results |= {
            f"point {label}": places[:, k] for k, label in enumerate(port.labels) if label.rpartition(".")[0] in moving
        }
    return results


def _statics(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Forces and torques of the drives that hold the mechanism at rest."""
    if "inverse_dynamics" not in model.programs:
        return {}
    program = model.programs["inverse_dynamics"]
    known = {"q": q, **({"p": extra[0]} if extra else {})}
    given = [known.get(port.name, np.zeros((len(q), port.size))) for port in program.inputs]
    u = call("inverse_dynamics", *given)[0][0]
    return {f"drive {label}": u[:, k] for k, label in enumerate(program.outputs[0].labels)}


def _quality(model: Model, call: Call, q: Array, extra: tuple[Array, ...], *, stiffness: float) -> dict[str, Array]:
    """Condition number and stiffness of the platform's motion, with lengths divided by the characteristic length.

    Twists are those at the platform's tool: at O they would depend on where the mechanism stands in the world. With an
    orthonormal basis Q of the platform's twists (omega ; v/L), drives turn or slide at M y where M = A R^-1:
    A takes independent rates to drive rates, (omega ; v/L) = Q R of them. The condition number is that of M with
    sliding drives divided by L, infinite where R is singular; the stiffness K = M^T diag(k) M has as eigenvalues the
    least and largest stiffness [N m] against a unit of such a twist.
    """
    if not _moved_by_drives(model):
        return {}
    system = model.system
    count, nv = len(q), len(system.tree.v)
    null = _matrix(call, "null_space", (q, *extra), nv) if "null_space" in model.programs else None
    basis = np.repeat(np.eye(nv)[None], count, 0) if null is None else null
    drives = np.stack(
        [call("drive_rates", q, np.ascontiguousarray(basis[:, :, k]), *extra)[0][0] for k in range(basis.shape[2])],
        axis=2,
    )
    twists = _matrix(call, "platform_jacobian", (q, *extra), 6) @ basis
    length = system.length
    twists[:, 3:] += np.cross(twists[:, :3], _tool(model, call, q, extra)[:, :, None], axis=1)
    twists[:, 3:] /= length
    slides = np.array([unit == "m/s" for unit in model.programs["drive_rates"].outputs[0].units])
    good = np.isfinite(twists).all(axis=(1, 2)) & np.isfinite(drives).all(axis=(1, 2))
    condition, least, largest = (np.full(count, np.nan) for _ in range(3))
    if good.any() and twists.shape[2] <= 6:
        _, R = np.linalg.qr(twists[good])
        diagonal = np.abs(np.diagonal(R, axis1=1, axis2=2))
        regular = diagonal.min(axis=1) > SINGULAR * diagonal.max(axis=1)
        place = np.flatnonzero(good)[regular]
        condition[good] = np.inf
        M = drives[place] @ np.linalg.inv(R[regular])
        scaled = M / np.where(slides, length, 1.0)[:, None]
        values = np.linalg.svd(scaled, compute_uv=False)
        if scaled.shape[1] >= scaled.shape[2]:
            condition[place] = values[:, 0] / values[:, -1]
            stiff = np.linalg.svd(M * np.sqrt(np.where(slides, 1.0, length**2) * stiffness)[:, None], compute_uv=False)
            least[place], largest[place] = stiff[:, -1] ** 2, stiff[:, 0] ** 2
    return {"condition": condition, "stiffness least": least, "stiffness largest": largest}


def _tool(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> Array:
    """Where the platform's tool is (cases, 3) [m]: its point of that name, else the middle of its joints' points."""
    name, mechanism = tool_name(model), model.mechanism
    if name is not None:
        labels = list(model.programs["forward_kinematics"].outputs[0].labels)
        at = call("forward_kinematics", q, *extra)[0][0]
        return np.asarray(at[:, [labels.index(f"{name}.{axis}") for axis in "xyz"]])
    own = [k for k, j in enumerate(mechanism.joints.values()) if mechanism.platform in (j.parent, j.child)]
    return np.asarray(_matrix(call, "joint_points", (q, *extra), 3)[:, :, own].mean(axis=2))


def _matrix(call: Call, name: str, inputs: tuple[Array, ...], rows: int) -> Array:
    """A function's matrix (cases, rows, columns), which it gives column by column."""
    flat = call(name, *inputs)[0][0]
    return flat.reshape(len(flat), -1, rows).transpose(0, 2, 1).copy()


def _margins(model: Model, call: Call, q: Array, extra: tuple[Array, ...]) -> dict[str, Array]:
    """Every margin at the configuration, by kind and name."""
    results: dict[str, Array] = {}
    for kind in ("limb_margins", "constraint_margin", "actuation_margins"):
        if kind in model.programs:
            values = call(kind, q, *extra)[0][0]
            labels = model.programs[kind].outputs[0].labels
            results |= {f"{kind.split('_')[0]} {label}": values[:, k] for k, label in enumerate(labels)}
    relative = [results[name] / value for name, value in start_margins(model, call).items()]
    if relative:
        results["margin"] = np.min(relative, axis=0)
    return results
