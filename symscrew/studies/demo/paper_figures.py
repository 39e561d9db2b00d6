"""What the demo shows: facts in sentences, a summary table, figures 7, 8, 9 and 11 of the source paper."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from symscrew.description import Joint, Mechanism
from symscrew.display import Progress, aligned_table, fitting_table
from symscrew.studies.demo.paper_study import LIMIT, TIMED_STATES, Case, Demo
from symscrew.whole_files import made_together

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from symscrew.display import Curve

Array = np.ndarray


def demo_facts(demo: Demo) -> str:
    """The results in words, before the table."""
    seed, spin = demo.cases[0], demo.assumption
    omega = np.abs(seed.motion.twist[:, :3]).max(axis=0)
    period = 2 * np.pi / demo.scene.motion.frequency
    return "\n".join(
        [
            "Mobility by reciprocal screws, eqs. (10)-(18)",
            *(f"  {line}" for line in demo.mobility.report().splitlines()),
            "",
            f"Motion of section 5: {demo.scene.steps} steps of {demo.scene.duration / demo.scene.steps:g} s; "
            f"omega_x and omega_y prescribed, omega_z from the loops",
            f"  largest |omega| = ({omega[0]:.6f}, {omega[1]:.6f}, {omega[2]:.6f}) rad/s; loops closed to "
            f"{seed.motion.opening:.1e} m; error of the integration about {seed.motion.drift:.1e}",
            f"  after t = {period:.4f} s the platform is {1e3 * _offset(seed, period):.2f} mrad off its first "
            "pose: omega_x and omega_y are not rates of coordinates",
            f"  screw matrix S = blockdiag(S_1 ... S_{len(seed.mechanism.limbs)}): {spin.shape[0]} x {spin.shape[1]}",
            f"  assuming omega_z = 0, the least squares of eq. (27) leave a residual of up to "
            f"{spin.residual.max():.3e}; with the omega_z that the constraint demands, {spin.exact_residual:.1e}:",
            "  away from the reference pose the constraint wrench of the limb has moments about x and y too and "
            "ties omega_z to omega_x and omega_y; least squares spreads the contradiction over the joints",
            "",
            f"Statics under {_load(demo)} and gravity, at rest in the reference pose",
            "  minimum-norm drives ("
            + ", ".join(demo.statics.labels)
            + ") = ("
            + ", ".join(f"{u + 0.0:.3f}" for u in demo.statics.drives)
            + ") N, positive extends the leg",
        ]
    )


def _offset(case: Case, instant: float) -> float:
    """Angle [rad] of the platform from its first pose at the sample nearest to an instant."""
    nearest = int(np.argmin(np.abs(case.motion.t - instant)))
    poses = np.asarray(case.functions.body_poses(case.motion.q[nearest]))
    bodies = [name for name in case.mechanism.bodies if name != case.mechanism.ground]
    rotation = poses[:9, bodies.index(case.mechanism.platform or bodies[-1])].reshape(3, 3)
    return float(np.linalg.norm(rotation - np.eye(3)) / np.sqrt(2))


def _load(demo: Demo) -> str:
    force, moment = demo.scene.load[:3], demo.scene.load[3:]
    return (
        f"force ({', '.join(f'{f:g}' for f in force)}) N and moment ({', '.join(f'{m:g}' for m in moment)}) N m "
        f"at {demo.scene.loaded_point}"
    )


Row = tuple[str, Callable[[Case], str]]


def demo_summary(demo: Demo, *, markdown: bool = False) -> str:
    """One table, a column per mechanism, as wide as the console; `markdown`: a line a row, for a file."""
    table = aligned_table if markdown else fitting_table
    code = {"c": "generated C", "casadi": "CasADi (no C compiler found)"}[demo.cases[0].functions.backend]
    rows: list[Row] = [
        ("joint freedoms; drives", lambda c: f"{_joint_count(c)}; {c.drives.shape[1]}"),
        ("largest drive force", lambda c: f"{np.abs(c.drives).max():.4f} N"),
        ("largest joint force", lambda c: f"{np.linalg.norm(c.reactions[:, :3], axis=1).max():.4f} N"),
        ("drives: momentum screws against Newton-Euler", lambda c: f"{c.drive_difference:.1e} relative"),
        ("reactions: momentum screws against Newton-Euler", lambda c: f"{c.reaction_difference:.1e} relative"),
        ("derive the model", lambda c: f"{c.derive_time:.2f} s"),
        ("print and compile, or build for CasADi", lambda c: f"{c.compile_time:.2f} s"),
        *((f"{name}", _timing(name)) for name in demo.cases[0].timings),
    ]
    body = [[text, *(value(case) for case in demo.cases)] for text, value in rows]
    return "\n".join(
        [
            table(["quantity", *(case.mechanism.name for case in demo.cases)], body),
            "",
            f"Times: {code}, median per state of calls with {TIMED_STATES} states, so without Python's share; "
            "one thread.",
            verdict(demo),
        ]
    )


def verdict(demo: Demo) -> str:
    """Whether the two methods agree."""
    worst = max(max(c.drive_difference, c.reaction_difference) for c in demo.cases)
    word = "agree" if demo.agrees else "DO NOT AGREE"
    return f"Momentum screws and Newton-Euler {word}: largest relative difference {worst:.1e}, limit {LIMIT:.0e}."


def _joint_count(case: Case) -> int:
    return case.functions["joint_rates"].outputs[0].size


def _timing(name: str) -> Callable[[Case], str]:
    return lambda c: f"{c.timings[name].operations} operations, {c.timings[name].nanoseconds:.0f} ns"


def demo_values(demo: Demo) -> dict[str, Any]:
    """The numbers of the demo, as they go into summary.json."""
    return {
        "agrees": demo.agrees,
        "mobility": demo.mobility.dof,
        "screw_matrix": list(demo.assumption.shape),
        "largest_omega_z": float(np.abs(demo.cases[0].motion.twist[:, 2]).max()),
        "residual_if_omega_z_is_zero": float(demo.assumption.residual.max()),
        "residual_with_omega_z": demo.assumption.exact_residual,
        "loop_opening": demo.cases[0].motion.opening,
        "statics": dict(zip(demo.statics.labels, demo.statics.drives.tolist(), strict=True)),
        "backend": demo.cases[0].functions.backend,
        "cases": {case.mechanism.name: _case_values(case) for case in demo.cases},
    }


def _case_values(case: Case) -> dict[str, Any]:
    return {
        "drive_difference": case.drive_difference,
        "reaction_difference": case.reaction_difference,
        "largest_drives": np.abs(case.drives).max(axis=0).tolist(),
        "operations": {name: timing.operations for name, timing in case.timings.items()},
        "nanoseconds": {name: timing.nanoseconds for name, timing in case.timings.items()},
        "derive_seconds": case.derive_time,
        "compile_seconds": case.compile_time,
    }


def write_figures(demo: Demo, directory: Path, progress: Progress) -> list[Path]:
    """All figures and the summary into `directory`, all of them or none; returns the paths."""
    from symscrew.display import save_figure

    text = f"# symscrew demo\n\n```\n{demo_facts(demo)}\n```\n\n{demo_summary(demo, markdown=True)}\n"
    numbers = json.dumps(demo_values(demo), indent=1) + "\n"

    def make(place: Path) -> None:
        for name, (draw, tight) in _pictures(demo).items():
            with progress.step(f"draw {name}"):
                save_figure(draw(), place / name, tight=tight)
        for name, content in (("summary.md", text), ("summary.json", numbers)):
            (place / name).write_text(content, encoding="utf-8")

    return made_together(directory, make)


def _pictures(demo: Demo) -> dict[str, tuple[Callable[[], Figure], bool]]:
    """File name to (what draws it, whether its margins are cut off)."""
    from symscrew.display import mechanism_figure, reaction_figure

    seed = demo.cases[0]
    pictures: dict[str, tuple[Callable[[], Figure], bool]] = {
        "mechanism.png": (lambda: mechanism_figure(seed.mechanism), True),
        "figure_7_displacements.png": (lambda: _joint_figure(seed, rate=False), False),
        "figure_8_rates.png": (lambda: _joint_figure(seed, rate=True), False),
        "figure_9_drives.png": (lambda: _drive_figure(demo), False),
        "omega_z.png": (lambda: _spin_figure(demo), False),
    }
    for case in demo.cases:
        for what, unit in (("force", "N"), ("moment", "N m")):
            curves = _reaction_curves(case, moments=what == "moment")
            draw = partial(reaction_figure, case.motion.t, curves, label=f"{what}  [{unit}]")
            pictures[f"figure_11_{what}s_{case.mechanism.name}.png"] = (draw, False)
    return pictures


def _joint_figure(case: Case, *, rate: bool) -> Figure:
    from symscrew.display import Curve, joint_figure

    function = case.functions["joint_rates" if rate else "joint_displacements"]
    found = np.asarray(function(case.motion.q, case.motion.v) if rate else function(case.motion.q))
    port = function.outputs[0]
    groups: dict[str, list[Curve]] = {}
    for number, limb in enumerate(case.mechanism.limbs.values(), 1):
        own = [k for k, label in enumerate(port.labels) if label.split(".")[0] in limb.joints]
        letters = "".join(case.mechanism.joints[name].type for name in limb.joints)
        groups[f"limb {number}, {letters}"] = [
            Curve(_symbol(number, place, port.units[k], rate), found[:, k], port.units[k])
            for place, k in enumerate(own, 1)
        ]
    return joint_figure(case.motion.t, groups, rate=rate)


def _symbol(limb: int, place: int, unit: str, rate: bool) -> str:
    letter = "p" if unit.startswith("m") else r"\theta"
    return rf"$\dot {letter}_{{{limb}{place}}}$" if rate else rf"${letter}_{{{limb}{place}}}$"


def _drive_figure(demo: Demo) -> Figure:
    from symscrew.display import Curve, drive_figure

    cases = {}
    for case in demo.cases:
        curves = [Curve(f"$F_{k + 1}$", case.drives[:, k], "N") for k in range(case.drives.shape[1])]
        title = case.mechanism.description.rsplit(";", 1)[-1].strip() or case.mechanism.name
        cases[title] = (curves, case.drives_b)
    return drive_figure(demo.cases[0].motion.t, cases)


def _spin_figure(demo: Demo) -> Figure:
    from symscrew.display import Curve, assumption_figure

    motion, spin = demo.cases[0].motion, demo.assumption
    residual = np.interp(motion.t, spin.t, spin.residual)
    return assumption_figure(
        motion.t, Curve(r"$\omega_z$", motion.twist[:, 2], "rad/s"), Curve("residual", residual, "")
    )


def _reaction_curves(case: Case, *, moments: bool) -> dict[str, list[Curve]]:
    """Reactions at the joints on the base and on the platform: forces, or moments about the joint's point.

    Moments only where a joint transmits any.
    """
    from symscrew.display import Curve

    ends = (case.mechanism.ground, case.mechanism.platform)
    places: dict[str, list[Curve]] = {}
    for end in ends:
        for index, joint in enumerate(case.mechanism.joints.values()):
            if end not in (joint.parent, joint.child) or (end == ends[1] and ends[0] in (joint.parent, joint.child)):
                continue
            found = case.reactions[:, :, index]
            part = found[:, 3:] - np.cross(_joint_point(case, joint), found[:, :3]) if moments else found[:, :3]
            if moments and np.abs(part).max() < 1e-9 * np.abs(found).max():
                continue
            letter = "m" if moments else "f"
            places[_place(case.mechanism, joint)] = [
                Curve(f"${letter}_{axis}$", part[:, k], "") for k, axis in enumerate("xyz")
            ]
    return places


def _joint_point(case: Case, joint: Joint) -> Array:
    """Present place (n, 3) of a joint's point, carried by its child."""
    reference = np.array([float(case.mechanism.number(c)) for c in joint.point])
    bodies = [name for name in case.mechanism.bodies if name != case.mechanism.ground]
    pose = np.asarray(case.functions.body_poses(case.motion.q))[:, :, bodies.index(joint.child)]
    place: Array = pose[:, :9].reshape(-1, 3, 3).transpose(0, 2, 1) @ reference + pose[:, 9:]
    return place


def _place(mechanism: Mechanism, joint: Joint) -> str:
    """The named point at the joint with the limb and the type of the joint."""
    from symscrew.display import indexed_symbol

    limbs = [k for k, limb in enumerate(mechanism.limbs.values(), 1) if joint.name in limb.joints]
    name = f"limb {limbs[0]}, {joint.type}" if limbs else joint.name.replace("_", " ")
    here = [p.name for p in mechanism.points.values() if p.at == joint.point]
    return f"{indexed_symbol(here[0])} ({name})" if here else name
