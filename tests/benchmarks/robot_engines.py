"""A robot's file in our numbers beside those of MuJoCo or Pinocchio, at random states near the file's own pose.

    MJCF with MuJoCo    poses and twists of bodies; mass matrix along the motions that all constraints allow, forces of
                        gravity along them (closed chains), or mass matrix and all forces of inertia and gravity
                        (trees); the velocities that we allow in MuJoCo's own constraint Jacobian
    URDF with Pinocchio poses and twists of links; mass matrix and forces of the tree; couplings and loops hold in none
                        of the two

Inverse and forward dynamics, M a + h = u, have no further numbers.
"""

from __future__ import annotations

import tempfile
from functools import cached_property
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, tostring

import numpy as np

from symscrew.dynamics import generalised_forces, mass_matrix
from symscrew.effects import Acting, Effect, system_under, type_name
from symscrew.formats import ImportOptions, import_file
from symscrew.formats.file_names import fresh, safe_names
from symscrew.formats.safe_xml import read
from symscrew.functions import Motion, kinematic_functions
from symscrew.program import Program, evaluate, lower
from symscrew.reference import rotation_about
from symscrew.scene import robot_of

Array = np.ndarray[Any, Any]
STATES = 3
POINTER = 200  # bytes up to which a mesh is the pointer of a large file that was not fetched
NEARLY = 1e-5  # of two sites that meet [m]
IN_MUJOCO = ("gravity", "rotor_inertia")  # effects that are in its M a + h
IN_PINOCCHIO = ("gravity",)  # it reads no rotor of a transmission


class Ours:
    """A robot on our side: its system, and numbers of it at states that keep its loops and couplings."""

    def __init__(self, path: Path, options: ImportOptions, compared: tuple[str, ...] = IN_MUJOCO) -> None:
        self.found = import_file(path, options)
        robot = robot_of(self.found)
        effects: list[Effect] = [effect for effect in robot.effects if type_name(effect) in compared]
        self.mechanism = robot.mechanism
        self.system = system_under(robot.mechanism, effects)
        self.acting = Acting(self.system, effects)
        self.q, self.v, _ = self.system.states(STATES, 1)

    def mass(self) -> Array:
        """Mass matrices of the tree (states, n, n)."""
        rows = mass_matrix(self.system, self.acting.added_inertia)
        n = len(rows)
        if not n:
            return np.zeros((len(self.q), 0, 0))
        flat = self.system.numeric([x for row in rows for x in row], (self.system.inputs.q, self.q))
        return flat.reshape(-1, n, n)

    def forces(self, *, still: bool) -> Array:
        """Forces (states, n) that the tree needs without accelerations; `still`: without rates as well."""
        system = self.system
        nodes = generalised_forces(system, self.acting, [system.tape.zero] * len(system.tree.v))
        if not nodes:
            return np.zeros((len(self.q), 0))
        inputs = system.inputs
        return system.numeric(nodes, (inputs.q, self.q), (inputs.v, 0 * self.v if still else self.v))

    def null_spaces(self) -> list[Array]:
        """Bases (n, freedoms) of the rates v that keep loops and couplings."""
        system, n = self.system, len(self.system.tree.v)
        if not system.cuts:
            return [np.eye(n) for _ in self.q]
        from symscrew.functions.closing import jacobian_in_v

        columns = jacobian_in_v(system)
        flat = system.numeric([entry for column in columns for entry in column], (system.inputs.q, self.q))
        bases = []
        for matrix in flat.reshape(len(self.q), n, -1).transpose(0, 2, 1):
            _, s, vt = np.linalg.svd(matrix)
            bases.append(vt[int((s > 1e-9 * s[0]).sum()) :].T)
        return bases

    def at_rest(self) -> tuple[dict[str, Array], dict[str, Array]]:
        """Displacements and rates of every joint in the reference configuration."""
        values, zeros = {}, {}
        for joint in self.mechanism.joints.values():
            given = [float(self.mechanism.number(value)) for value in joint.reference]
            values[joint.name] = np.array([*given, *[0.0] * (joint.kind.freedom - len(given))])
            zeros[joint.name] = np.zeros(joint.kind.freedom)
        return values, zeros

    @cached_property
    def programs(self) -> dict[str, Program]:
        """What is compared of the motion."""
        made = {f.name: f for f in kinematic_functions(self.system, Motion(self.system))}
        return {name: lower(made[name]) for name in ("joint_displacements", "joint_rates", "body_poses", "body_twists")}

    def joints(self, v: Array) -> tuple[dict[str, Array], dict[str, Array]]:
        """Displacements and rates of every joint by name, at all states."""
        found = []
        for name, inputs in (("joint_displacements", [self.q]), ("joint_rates", [self.q, v])):
            values = evaluate(self.programs[name], inputs)[0][0]
            parts, start = {}, 0
            for joint in self.mechanism.joints.values():
                parts[joint.name] = values[..., start : start + joint.kind.freedom]
                start += joint.kind.freedom
            found.append(parts)
        return found[0], found[1]

    @cached_property
    def moved(self) -> dict[str, tuple[Array, Array]]:
        """Displacement (states, 4, 4) from the reference and twist (omega ; v_O) (states, 6) of every body."""
        bodies = [name for name in self.mechanism.bodies if name != self.mechanism.ground]
        count = len(self.q)
        poses = evaluate(self.programs["body_poses"], [self.q])[0][0].reshape(count, -1, 12)
        twists = evaluate(self.programs["body_twists"], [self.q, self.v])[0][0].reshape(count, -1, 6)
        found = {}
        for k, name in enumerate(bodies):
            whole = np.tile(np.eye(4), (count, 1, 1))
            whole[:, :3, :3] = poses[:, k, :9].reshape(-1, 3, 3).transpose(0, 2, 1)
            whole[:, :3, 3] = poses[:, k, 9:]
            found[name] = (whole, twists[:, k])
        return found


def relative(a: Array, b: Array, least: float = 1e-12) -> float:
    """The largest difference, of the largest entry, or of `least` where that is larger."""
    return float(np.abs(a - b).max(initial=0) / max(np.abs(b).max(initial=0), least, 1e-12))


def with_mujoco(path: Path, options: ImportOptions) -> tuple[float, str]:
    """(largest difference, what was compared)."""
    import mujoco

    ours = Ours(path, options)
    engine = mujoco_model(path)
    engine.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT)
    engine.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    close_sites(engine, data)
    places = names_in(engine, ours)
    for (
        name,
        i,
    ) in places.items():  # balls are turned from our reference, where couplings may displace what carries them
        values = ours.mechanism.joints[name].reference
        if engine.jnt_type[i] in (2, 3) and values:
            data.qpos[engine.jnt_qposadr[i]] = float(ours.mechanism.number(values[0]))
    mujoco.mj_forward(engine, data)
    reference = data.xmat.reshape(-1, 3, 3).copy()
    start = data.xpos.copy()
    bases, mass = ours.null_spaces(), ours.mass()
    closed = bool(ours.system.cuts)
    forces = ours.forces(still=closed)
    worst = 0.0
    numbers = bodies_in(engine, ours)
    for k, basis in enumerate(bases):
        columns = []
        for direction in (ours.v[k], *basis.T):
            displacements, rates = ours.joints(np.repeat(direction[None], len(ours.q), 0))
            columns.append(place(engine, data, places, (displacements, rates, k), reference, start))
        data.qvel[:] = columns[0]
        mujoco.mj_forward(engine, data)
        for name, i in numbers.items():
            whole, twist = (values[k] for values in ours.moved[name])
            at = whole[:3, :3] @ start[i] + whole[:3, 3]
            worst = max(worst, relative(at, data.xpos[i], 1.0))
            worst = max(worst, float(np.abs(whole[:3, :3] @ reference[i] - data.xmat[i].reshape(3, 3)).max()))
            theirs = np.zeros(6)
            mujoco.mj_objectVelocity(engine, data, mujoco.mjtObj.mjOBJ_XBODY, i, theirs, 0)
            own = np.concatenate([twist[:3], twist[3:] + np.cross(twist[:3], at)])
            worst = max(worst, relative(own, theirs, 1.0))
        if closed:
            data.qvel[:] = 0
            mujoco.mj_forward(engine, data)
        full = np.zeros((engine.nv, engine.nv))
        if engine.nv:
            mujoco.mj_fullM(engine, data, full)
        motions = np.array(columns[1:]).reshape(len(columns) - 1, engine.nv).T
        if engine.neq and motions.size:
            kept = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
            rows = data.efc_J.reshape(-1, engine.nv)[kept] if data.nefc else np.zeros((0, engine.nv))
            worst = max(worst, float(np.abs(rows @ motions).max(initial=0)))
            worst = max(worst, float(np.abs(data.efc_pos[kept]).max(initial=0)) if data.nefc else 0.0)
        worst = max(worst, relative(basis.T @ mass[k] @ basis, motions.T @ full @ motions))
        unit = np.abs(full).max(initial=0)  # forces that are zero have the size of one unit of acceleration
        worst = max(worst, relative(basis.T @ forces[k], motions.T @ data.qfrc_bias, unit))
    what = "closed: M and gravity along its motions" if closed else "tree: M, forces"
    return worst, f"{what}, {len(numbers)} bodies; {bases[0].shape[1]} freedoms"


def mujoco_model(path: Path) -> Any:
    """MuJoCo's model; where files are missing, without pictures and without the geoms that want them."""
    import mujoco

    try:
        return mujoco.MjModel.from_xml_path(str(path))
    except ValueError:
        spec = mujoco.MjSpec.from_file(str(path))
    for listed in (spec.skins, spec.textures, spec.materials, spec.excludes, spec.pairs, spec.sensors):
        for element in list(listed):
            spec.delete(element)
    files = {mesh.name or Path(mesh.file).stem: path.parent / spec.meshdir / mesh.file for mesh in spec.meshes}
    there = {name for name, file in files.items() if file.is_file() and file.stat().st_size > POINTER}
    for body in spec.bodies:
        for geom in list(body.geoms):
            geom.material = ""
            missing = geom.meshname and geom.meshname not in there  # our side was read, so it needs none of them
            if geom.hfieldname or missing:
                spec.delete(geom)
    for ground in list(spec.hfields):
        spec.delete(ground)
    for mesh in [mesh for mesh in spec.meshes if (mesh.name or Path(mesh.file).stem) not in there]:
        spec.delete(mesh)
    return spec.compile()


def close_sites(engine: Any, data: Any) -> None:
    """Move two sites that nearly meet to the middle between them: as our side does it, which moves joints else."""
    import mujoco

    for k in range(engine.neq):
        if engine.eq_type[k] == mujoco.mjtEq.mjEQ_CONNECT and engine.eq_objtype[k] == mujoco.mjtObj.mjOBJ_SITE:
            sites = [engine.eq_obj1id[k], engine.eq_obj2id[k]]
            if np.linalg.norm(data.site_xpos[sites[0]] - data.site_xpos[sites[1]]) > NEARLY:
                continue
            middle = data.site_xpos[sites].mean(axis=0)
            for site in sites:
                body = engine.site_bodyid[site]
                engine.site_pos[site] = data.xmat[body].reshape(3, 3).T @ (middle - data.xpos[body])
    mujoco.mj_forward(engine, data)


def names_in(engine: Any, ours: Ours) -> dict[str, int]:
    """Joint of ours -> index of MuJoCo's; joints without a name got one in the order of the file."""
    listed: list[str] = []
    for i in range(engine.njnt):
        listed.append(engine.joint(i).name or fresh("joint", listed))
    renamed = safe_names(listed)
    found = {renamed[name]: i for i, name in enumerate(listed) if renamed[name] in ours.mechanism.joints}
    if len(found) < engine.njnt:
        raise NotImplementedError("joints that were merged are not compared")
    return found


def bodies_in(engine: Any, ours: Ours) -> dict[str, int]:
    """Body of ours -> index of MuJoCo's, of those that have a name."""
    listed = {engine.body(i).name: i for i in range(engine.nbody) if engine.body(i).name}
    renamed = safe_names(listed)
    known = set(ours.mechanism.bodies) - {ours.mechanism.ground}
    return {renamed[name]: i for name, i in listed.items() if renamed[name] in known}


def place(engine: Any, data: Any, places: dict[str, int], ours: Any, reference: Array, start: Array) -> Array:
    """Put MuJoCo's coordinates where ours are; its rates for ours."""
    displacements, rates, k = ours
    velocity = np.zeros(engine.nv)
    for name, i in places.items():
        at, dof, body = engine.jnt_qposadr[i], engine.jnt_dofadr[i], engine.jnt_bodyid[i]
        d, w, turned = displacements[name][k], rates[name][k], reference[body]
        if engine.jnt_type[i] in (2, 3):
            data.qpos[at], velocity[dof] = d[0], w[0]
        else:
            turn = rotation_about(d[-3:])
            if engine.jnt_type[i] == 1:
                data.qpos[at : at + 4] = quaternion(turned.T @ turn @ turned)
                velocity[dof : dof + 3] = turned.T @ turn.T @ w
            else:
                data.qpos[at : at + 3] = start[body] + d[:3]
                data.qpos[at + 3 : at + 7] = quaternion(turn @ turned)
                velocity[dof : dof + 3], velocity[dof + 3 : dof + 6] = w[:3], turned.T @ turn.T @ w[3:]
    return velocity


def quaternion(rotation: Array) -> Array:
    import mujoco

    found = np.zeros(4)
    mujoco.mju_mat2Quat(found, np.ascontiguousarray(rotation).ravel())
    return found


def with_pinocchio(path: Path, options: ImportOptions) -> tuple[float, str]:
    """(largest difference, what was compared)."""
    import pinocchio

    if path.with_suffix(
        ".yaml"
    ).is_file():  # it changes joints, which Pinocchio does not read: opened, compared without
        import_file(path, options)
    ours = tree_of(path, options)  # first: what we refuse is refused, whatever the engine does
    engine, mended = pinocchio_model(path)
    data = engine.createData()
    ours.system.use_samples()
    mass, forces = ours.mass(), ours.forces(still=False)
    renamed = safe_names(str(name) for name in engine.names)
    names = [renamed[str(name)] for name in engine.names]
    missing = [name for name in names[1:] if name not in ours.mechanism.joints]
    if missing:
        raise NotImplementedError(f"joints {', '.join(missing)} are not ours")
    rest, _ = placed(engine, names, ours.at_rest(), None)
    pinocchio.framesForwardKinematics(engine, data, rest)
    start = [pose.homogeneous.copy() for pose in data.oMi]
    frames = link_frames(engine, ours)
    links = {name: data.oMf[i].homogeneous.copy() for name, i in frames.items()}
    worst = 0.0
    for k in range(len(ours.q)):
        columns = []
        for direction in (ours.v[k], *np.eye(len(ours.v[k]))):
            found = ours.joints(np.repeat(direction[None], len(ours.q), 0))
            given, rates = placed(engine, names, [{name: v[k] for name, v in part.items()} for part in found], start)
            columns.append(rates)
        theirs = pinocchio.crba(engine, data, given)
        theirs = np.triu(theirs) + np.triu(theirs, 1).T
        motions = np.array(columns[1:]).T
        worst = max(worst, relative(mass[k], motions.T @ theirs @ motions))
        bias = pinocchio.rnea(engine, data, given, columns[0], turning(engine, columns[0]))
        unit = np.abs(theirs).max(initial=0)
        worst = max(worst, relative(forces[k], motions.T @ bias, unit))
        pinocchio.forwardKinematics(engine, data, given, columns[0])
        pinocchio.updateFramePlacements(engine, data)
        for name, i in frames.items():
            whole, twist = (values[k] for values in ours.moved[name])
            worst = max(worst, relative(whole @ links[name], data.oMf[i].homogeneous, 1.0))
            seen = pinocchio.getFrameVelocity(engine, data, i, pinocchio.ReferenceFrame.WORLD)
            worst = max(worst, relative(twist, np.concatenate([seen.angular, seen.linear]), 1.0))
    closed = " of its tree" if ours.system.cuts else ""
    repaired = f"; {mended} inertias repaired in both" if mended else ""
    return worst, f"tree: M, forces{closed}, {len(frames)} links; {engine.nv} freedoms{repaired}"


def pinocchio_model(path: Path) -> tuple[Any, int]:
    """Pinocchio's model, and how many of its inertias are the nearest possible ones."""
    import pinocchio

    text, mended = possible(path)
    engine = pinocchio.buildModelFromXML(text)
    for k, whole in enumerate(engine.inertias):  # of links that fixed joints join, in one
        near = nearest(np.array(whole.inertia))
        if near is not None:
            engine.inertias[k] = pinocchio.Inertia(whole.mass, whole.lever, near)
            mended += 1
    return engine, mended


def nearest(given: Array) -> Array | None:
    """The nearest inertia that a body can have, or None where this is one."""
    values, axes = np.linalg.eigh(given)
    low = values.clip(min=0)
    miss = (low[2] - low[0] - low[1]) / 3
    if values[0] >= -1e-12 * values[2] and miss <= 1e-12 * values[2]:
        return None
    near: Array = axes @ np.diag(low + max(miss, 0) * np.array([1, 1, -1])) @ axes.T
    return near


def turning(engine: Any, v: Array) -> Array:
    """Pinocchio's accelerations where ours are zero: velocities of free joints are in axes that turn."""
    a = np.zeros(engine.nv)
    for joint in engine.joints:
        if joint.nv == 6:
            linear, angular = v[joint.idx_v : joint.idx_v + 3], v[joint.idx_v + 3 : joint.idx_v + 6]
            a[joint.idx_v : joint.idx_v + 3] = -np.cross(angular, linear)
    return a


def link_frames(engine: Any, ours: Ours) -> dict[str, int]:
    """Body of ours -> index of Pinocchio's frame of that link."""
    import pinocchio

    links = {str(f.name): i for i, f in enumerate(engine.frames) if f.type == pinocchio.FrameType.BODY}
    renamed = safe_names(links)
    return {renamed[name]: i for name, i in links.items()
            if renamed[name] in ours.mechanism.bodies and renamed[name] != ours.mechanism.ground}  # fmt: skip


def placed(engine: Any, names: list[str], ours: Any, start: list[Array] | None) -> tuple[Array, Array]:
    """Pinocchio's q and v where our joints have (displacements, rates); `start`: its joints' poses in our reference."""
    import pinocchio

    displacements, rates = ours
    q, v = pinocchio.neutral(engine), np.zeros(engine.nv)
    for i, name in enumerate(names):
        joint = engine.joints[i]
        if not i:
            continue
        d, w = displacements[name], rates[name]
        if joint.nv == 1:
            q[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(d[0]), np.sin(d[0])] if joint.nq == 2 else d
            v[joint.idx_v] = w[0]
        elif joint.nv == 6 and start is not None:
            parent, child = start[engine.parents[i]], start[i]
            whole = np.eye(4)
            whole[:3, :3] = rotation_about(d[3:])
            whole[:3, 3] = child[:3, 3] + d[:3] - whole[:3, :3] @ child[:3, 3]
            local = np.linalg.inv(parent @ engine.jointPlacements[i].homogeneous) @ whole @ child
            q[joint.idx_q : joint.idx_q + 7] = pinocchio.SE3ToXYZQUAT(pinocchio.SE3(local))
            turned = (whole @ child)[:3, :3].T
            v[joint.idx_v : joint.idx_v + 6] = np.concatenate([turned @ w[:3], turned @ w[3:]])
        elif joint.nv != 6:
            raise NotImplementedError(f"joint {name} with {joint.nv} freedoms is not compared")
    return q, v


def tree_of(path: Path, options: ImportOptions) -> Ours:
    """Our side of a URDF alone, without the file beside it; links without joints stand still, as in Pinocchio."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        copy.write_bytes(path.read_bytes())
        return Ours(copy, options, IN_PINOCCHIO)


def possible(path: Path) -> tuple[str, int]:
    """(text of a URDF with the nearest possible inertias for those that no body has, how many), for the other engine.

    Links on fixed joints are left as they are, as Pinocchio adds them up.
    """
    root = read(path)
    heavy = {link.get("name") for link in root.findall("link") if link.find("inertial") is not None}
    groups = {link.get("name"): {link.get("name")} for link in root.findall("link")}
    for joint in root.findall("joint"):
        ends = [end.get("link") for end in joint if end.tag in ("parent", "child")]
        if joint.get("type") == "fixed" and all(end in groups for end in ends):
            whole = set().union(*(groups[end] for end in ends))
            groups |= dict.fromkeys(whole, whole)
    fixed = {name for name, whole in groups.items() if len(whole & heavy) > 1}
    mended = 0
    for link in root.findall("link"):
        for moments in link.findall("inertial/inertia"):
            given = np.zeros((3, 3))
            for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                given[i, j] = given[j, i] = float(moments.get(f"i{'xyz'[i]}{'xyz'[j]}", "0"))
            near = None if link.get("name") in fixed else nearest(given)
            if near is None:
                continue
            mended += 1
            for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                moments.set(f"i{'xyz'[i]}{'xyz'[j]}", repr(float(near[i, j])))
    links = {link.get("name") for link in root.findall("link")}
    as_it_is = "world" in links or all(end.get("link") != "world" for end in root.iter("parent"))
    if not as_it_is:
        root.append(Element("link", name="world"))  # Drake's, which it does not read
    for element in root.iter():
        for key, value in element.attrib.items():
            if value != value.strip():  # a line end beside a number, of which it leaves out the whole element
                element.attrib[key], as_it_is = value.strip(), False
    if not mended and as_it_is:
        return path.read_text(), 0
    return tostring(root, encoding="unicode"), mended
