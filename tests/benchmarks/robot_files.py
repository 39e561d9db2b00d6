"""`python -m tests.benchmarks.robot_files FOLDER ... [--seconds N] [--accept]`: robots of a folder beside engines.

Every URDF and MJCF file below the folders is opened as it is and compared at random states near its reference:

    MJCF with MuJoCo    mass matrix along the motions that all constraints allow, forces of gravity along them (closed
                        chains), or mass matrix and all forces of inertia and gravity (trees); the velocities that we
                        allow in MuJoCo's own constraint Jacobian
    URDF with Pinocchio mass matrix and forces of the tree; couplings and loops hold in none of the two

A line per file: ok with the largest difference, relative; not ok; or why the file is not opened. Nothing is changed and
nothing is fetched: which models there are is for whoever calls.
"""

from __future__ import annotations

import argparse
import signal
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.dynamics import generalised_forces, mass_matrix
from symscrew.effects import Acting, Effect, system_under, type_name
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file
from symscrew.functions import Motion, kinematic_functions
from symscrew.program import evaluate, lower
from symscrew.reference import rotation_about
from symscrew.scene import robot_of

Array = np.ndarray[Any, Any]
STATES = 3
EQUAL = 1e-9  # relative, as for everything that is compared with other engines
POINTER = 200  # bytes up to which a mesh is the pointer of a large file that was not fetched
NEARLY = 1e-5  # of two sites that meet [m]
COMPARED = ("gravity", "rotor_inertia")  # what both engines have in M a + h


class Ours:
    """A robot on our side: its system, and numbers of it at states that keep its loops and couplings."""

    def __init__(self, path: Path, options: ImportOptions) -> None:
        self.found = import_file(path, options)
        robot = robot_of(self.found)
        effects: list[Effect] = [effect for effect in robot.effects if type_name(effect) in COMPARED]
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

    def joints(self, v: Array) -> tuple[dict[str, Array], dict[str, Array]]:
        """Displacements and rates of every joint by name, at all states."""
        functions = {f.name: f for f in kinematic_functions(self.system, Motion(self.system))}
        found = []
        for name, inputs in (("joint_displacements", [self.q]), ("joint_rates", [self.q, v])):
            values = evaluate(lower(functions[name]), inputs)[0][0]
            parts, start = {}, 0
            for joint in self.mechanism.joints.values():
                parts[joint.name] = values[..., start : start + joint.kind.freedom]
                start += joint.kind.freedom
            found.append(parts)
        return found[0], found[1]


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
    for k, basis in enumerate(bases):
        columns = []
        for direction in (ours.v[k], *basis.T):
            displacements, rates = ours.joints(np.repeat(direction[None], len(ours.q), 0))
            columns.append(place(engine, data, places, (displacements, rates, k), reference, start))
        data.qvel[:] = 0 if closed else columns[0]
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
    return worst, f"{what}; {bases[0].shape[1]} freedoms"


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
    from symscrew.formats.file_names import fresh, safe_names

    listed: list[str] = []
    for i in range(engine.njnt):
        listed.append(engine.joint(i).name or fresh("joint", listed))
    renamed = safe_names(listed)
    found = {renamed[name]: i for i, name in enumerate(listed) if renamed[name] in ours.mechanism.joints}
    if len(found) < engine.njnt:
        raise NotImplementedError("joints that were merged are not compared")
    return found


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

    from symscrew.formats.file_names import safe_names

    if path.with_suffix(
        ".yaml"
    ).is_file():  # it changes joints, which Pinocchio does not read: opened, compared without
        import_file(path, options)
    text, mended = possible(path)
    ours = tree_of(path, options)
    engine = pinocchio.buildModelFromXML(text)
    data = engine.createData()
    ours.system.use_samples()
    mass, forces = ours.mass(), ours.forces(still=False)
    listed = [str(name) for name in engine.names][1:]
    renamed = safe_names(listed)
    labels = [c.label for c in ours.system.tree.v]
    try:
        order = [labels.index(renamed[name]) for name in listed]
        entries = [[c.label for c in ours.system.tree.q].index(renamed[name]) for name in listed]
    except ValueError as error:
        raise NotImplementedError(f"joints with several freedoms are not compared: {error}") from error
    worst = 0.0
    for k, q in enumerate(ours.q):
        given = []
        for i in range(1, engine.njoints):
            value = q[entries[i - 1]]
            given += [np.cos(value), np.sin(value)] if engine.joints[i].nq == 2 else [value]
        found = pinocchio.crba(engine, data, np.array(given))
        found = np.triu(found) + np.triu(found, 1).T
        worst = max(worst, relative(mass[k][np.ix_(order, order)], found))
        bias = pinocchio.rnea(engine, data, np.array(given), ours.v[k][order], np.zeros(engine.nv))
        worst = max(worst, relative(forces[k][order], bias, np.abs(found).max(initial=0)))
    closed = " of its tree" if ours.system.cuts else ""
    repaired = f"; {mended} inertias repaired in both" if mended else ""
    return worst, f"tree: M, forces{closed}; {engine.nv} freedoms{repaired}"


def tree_of(path: Path, options: ImportOptions) -> Ours:
    """Our side of a URDF alone, without the file beside it; links without joints stand still, as in Pinocchio."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        copy.write_bytes(path.read_bytes())
        return Ours(copy, options)


def possible(path: Path) -> tuple[str, int]:
    """(text of a URDF with the nearest possible inertias for those that no body has, how many), for the other engine.

    Links on fixed joints are left as they are, as Pinocchio adds them up.
    """
    from defusedxml import ElementTree

    root = ElementTree.parse(str(path)).getroot()
    heavy = {link.get("name") for link in root.findall("link") if link.find("inertial") is not None}
    ends = [{end.get("link") for end in joint if end.tag in ("parent", "child")} for joint in root.findall("joint")
            if joint.get("type") == "fixed"]  # fmt: skip
    fixed = {name for pair in ends if pair <= heavy for name in pair}
    mended = 0
    for link in root.findall("link"):
        for moments in link.findall("inertial/inertia"):
            given = np.zeros((3, 3))
            for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                given[i, j] = given[j, i] = float(moments.get(f"i{'xyz'[i]}{'xyz'[j]}", "0"))
            values, axes = np.linalg.eigh(given)
            low = values.clip(min=0)
            miss = (low[2] - low[0] - low[1]) / 3
            if link.get("name") in fixed or (values[0] >= -1e-12 * values[2] and miss <= 1e-12 * values[2]):
                continue
            mended += 1
            whole = axes @ np.diag(low + max(miss, 0) * np.array([1, 1, -1])) @ axes.T
            for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
                moments.set(f"i{'xyz'[i]}{'xyz'[j]}", repr(float(whole[i, j])))
    if not mended:
        return path.read_text(), 0
    return ElementTree.tostring(root, encoding="unicode"), mended


def files_below(folders: list[Path]) -> Iterator[tuple[Path, Path]]:
    """URDF and MJCF files that describe a model of their own, MJCF with bodies, no scenes around included ones; each
    with the folder below which files that it names are read: the one that was given."""
    for folder in folders:
        for path in sorted([folder] if folder.is_file() else folder.rglob("*")):
            if path.suffix == ".urdf":
                yield path, folder
            elif path.suffix == ".xml" and path.is_file():
                text = path.read_text(errors="replace")
                if "<mujoco" in text and "<worldbody" in text and "<body" in text:
                    yield path, folder if folder.is_dir() else folder.parent


def judged(path: Path, options: ImportOptions, seconds: int) -> tuple[str, str]:
    """(verdict, details) of one file, within a processor time."""

    def late(*_: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        worst, what = (with_pinocchio if path.suffix == ".urdf" else with_mujoco)(path, options)
        return ("ok" if worst < EQUAL else "DIFFERS"), f"{worst:.1e} {what}{open_by(path, options)}"
    except DescriptionError as error:
        return "refused", str(error)[:200]
    except TimeoutError:
        return "late", f"more than {seconds} processor seconds"
    except Exception as error:  # the other engine's word, or ours: either is the file's verdict
        return "failed", f"{type(error).__name__}: {str(error)[:150]}"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def open_by(path: Path, options: ImportOptions) -> str:
    """How far the file's own loops are open: two engines that close them agree to that only."""
    found = [text.partition("open by ")[2] for text in import_file(path, options).account.changed if "open by" in text]
    return f"; loops of the file open by {found[0].partition(' in ')[0]}" if found else ""


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--accept", action="store_true", help="as `symscrew convert --accept --repair`")
    options = parser.parse_args()
    chosen = ImportOptions(accept=options.accept, repair=options.accept)
    counts: dict[str, int] = {}
    for path, folder in files_below(options.folders):
        begun = time.process_time()
        verdict, text = judged(path, replace(chosen, folder=folder), options.seconds)
        counts[verdict] = counts.get(verdict, 0) + 1
        print(f"{verdict:8} {time.process_time() - begun:5.1f} s  {path}: {text}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))


if __name__ == "__main__":
    main()
