"""A study of drives as text, as JSON, as pictures and as a folder: what a person reads, and what a program reads on.

DriveStudy --study_text--> tables; --write_study--> motion.npz, motion.csv, summary.json, pictures
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from symscrew.description import to_toml
from symscrew.display import fitting_table
from symscrew.studies.given_motion.study import DriveStudy
from symscrew.whole_files import made_together

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from symscrew.display import Curve

Array = np.ndarray
ALL_DRIVES = "all drives"  # the margin of a redundant set of drives
NOTHING = 1e-9  # of the largest reaction: a number below is rounding
UNSEEN = 0.05  # of what is reached between samples: largest numbers that are wrong by less are told without a word
MOST_CURVES = 6  # in a frame: as many as there are colours


def doubts(study: DriveStudy) -> list[str]:
    """What the samples of a motion do not tell, in sentences."""
    found = []
    if study.wanted.unseen > UNSEEN:
        found.append(
            f"too few samples: of what a rate, an acceleration or a load reaches between them "
            f"{100 * study.wanted.unseen:.0f} % is not in these tables; raise the rate"
        )
    if study.wanted.uncertain:
        found.append(f"accelerations from samples: known to about {study.wanted.uncertain:.1e} of the largest")
    return found


def study_text(study: DriveStudy) -> str:
    """The verdict, a table of drives, one of joints, the smallest margins; no line is longer than 60 characters but for
    names."""
    followed = study.followed
    lines = [
        f"{study.model.name}: {len(study.t)} states to t = {study.t[-1]:g} s; {study.status}",
        f"motion followed to {max(followed.missed):.1e}, loops open by {followed.opening:.1e} (lengths by the "
        "characteristic length)",
    ]
    lines += doubts(study)
    drives, joints, margins = (study_json(study)[key] for key in ("drives", "joints", "margins"))
    if drives:
        header = ["drive", "largest", "rms", "rate", "power [W]"]
        rows = [[n, f"{d['largest']:.4g} {d['unit']}", f"{d['rms']:.4g}", f"{d['largest_rate']:.3g} {d['rate_unit']}",
                 f"{d['largest_power']:.4g}"] for n, d in drives.items()]  # fmt: skip
        lines += ["", fitting_table(header, rows)]
    rows = [[n, f"{j['largest_force']:.4g}", f"{j['largest_moment']:.4g}", f"{j['at']:.4g}"] for n, j in joints.items()]
    lines += ["", fitting_table(["joint", "force [N]", "moment about it [N m]", "at t [s]"], rows)]
    if margins:
        rows = [[name, f"{margins[name]['least']:.3g}", f"{margins[name]['at']:.4g}"] for name in watched(study)]
        lines += ["", fitting_table(["margin", "least", "at t [s]"], rows)]
    return "\n".join(lines)


def study_json(study: DriveStudy) -> dict[str, Any]:
    """The numbers of the tables, as `--json` prints them."""
    t, powers = study.t, study.powers
    drives = {
        label: {
            "unit": unit,
            "largest": float(np.abs(study.u[:, k]).max()),
            "rms": float(np.sqrt(np.mean(study.u[:, k] ** 2))),
            "rate_unit": "m/s" if unit == "N" else "rad/s",
            "largest_rate": float(np.abs(study.drive_rates[:, k]).max()),
            "largest_power": float(np.abs(powers[:, k]).max()),
        }
        for k, (label, unit) in enumerate(zip(study.labels["u"], study.units["u"], strict=True))
    }
    joints = {}
    all_largest = float(np.abs(study.wrench_table).max(initial=0.0))
    for name, wrench in study.wrenches.items():
        forces = np.linalg.norm(wrench.force, axis=1)
        moment = float(np.linalg.norm(wrench.about_joint().moment, axis=1).max())
        joints[name] = {
            "largest_force": float(forces.max()),
            "largest_moment": moment if moment > NOTHING * all_largest else 0.0,
            "at": float(t[int(forces.argmax())]),
        }
    ranges = {
        label: {"least": float(column.min()), "largest": float(column.max()), "unit": unit}
        for label, unit, column in zip(study.labels["joint"], study.units["joint"], study.displacements.T, strict=True)
    }
    margins = {name: _least(t, values) for name, values in study.margins.items()}
    return {
        "mechanism": study.model.name,
        "ok": study.ok,
        "status": study.status,
        "difference": study.difference,
        "states": len(t),
        "duration": float(t[-1]),
        "motion": list(study.wanted.names),
        "missed": max(study.followed.missed),
        "opening": study.followed.opening,
        "uncertain": study.wanted.uncertain,
        "unseen": study.wanted.unseen,
        "drives": drives,
        "joints": joints,
        "displacements": ranges,
        "margins": margins,
    }


def _least(t: Array, values: Array) -> dict[str, float]:
    """The least size of a margin and when; 0 where it changes its sign, which is a singular configuration passed."""
    through = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    if len(through):
        return {"least": 0.0, "at": float(t[through[0]])}
    least = int(np.abs(values).argmin())
    return {"least": float(abs(values[least])), "at": float(t[least])}


def arrays(study: DriveStudy) -> dict[str, Array]:
    """What the archive holds: keys as of a run, so that `symscrew view motion.npz` plays it."""
    tree = study.model.system.tree
    labels = {"q": [c.label for c in tree.q], "v": [c.label for c in tree.v], "u": list(study.labels["u"])}
    labels |= {"displacements": list(study.labels["joint"]), "margins": list(study.margins)}
    margins = np.stack(list(study.margins.values()), axis=1) if study.margins else np.zeros((len(study.t), 0))
    return {
        "t": study.t, "q": study.q, "v": study.v, "a": study.a, "u": study.u, "reactions": study.reactions,
        "displacements": study.displacements, "rates": study.rates, "drive_rates": study.drive_rates,
        "margins": margins, **{f"{key}_labels": np.array(value, dtype=str) for key, value in labels.items()},
        "joint_names": np.array(list(study.model.mechanism.joints), dtype=str), "ok": np.array(study.ok),
        "status": np.array(study.status), "mechanism": np.array(to_toml(study.model.mechanism)),
    }  # fmt: skip


FILES = ("motion.npz", "motion.csv", "summary.json")
"""What a study is written to, beside pictures."""


def write_study(study: DriveStudy, folder: Path, *, drawn: bool = True) -> list[Path]:
    """All or nothing into a folder: motion.npz, motion.csv, summary.json and, if `drawn`, pictures."""

    def make(place: Path) -> None:
        kept = arrays(study)
        np.savez_compressed(place / FILES[0], **kept)  # type: ignore[arg-type]
        study.columns.save(place / FILES[1])
        (place / FILES[2]).write_text(json.dumps(study_json(study), indent=1) + "\n", encoding="utf-8")
        if drawn:
            from symscrew.display import save_figure

            for name, draw in pictures(study).items():
                save_figure(draw(), place / name)

    return made_together(folder, make)


def pictures(study: DriveStudy) -> Mapping[str, Callable[[], Figure]]:
    """File name -> what draws it: displacements, rates, drives, powers, reactions, margins over time."""
    from symscrew.display import Curve, reaction_figure

    def of_drives(values: Array, unit: str) -> dict[str, list[Curve]]:
        return _framed([Curve(_readable(n), values[:, k], unit) for k, n in enumerate(study.labels["u"])])

    made: dict[str, Callable[[], Figure]] = {}
    for rate, name in ((False, "displacements.png"), (True, "rates.png")):
        made[name] = lambda rate=rate: _joints(study, rate=rate)  # type: ignore[misc]
    if study.u.shape[1]:
        units = "N" if set(study.units["u"]) == {"N"} else "N m" if set(study.units["u"]) == {"N m"} else "N, N m"
        made["drives.png"] = lambda: reaction_figure(study.t, of_drives(study.u, units), label=f"drive  [{units}]")
        made["powers.png"] = lambda: reaction_figure(study.t, of_drives(study.powers, "W"), label="power  [W]")
    made["forces.png"] = lambda: reaction_figure(study.t, _reactions(study, moments=False), label="force  [N]")
    if _reactions(study, moments=True):
        made["moments.png"] = lambda: reaction_figure(study.t, _reactions(study, moments=True), label="moment  [N m]")
    if study.margins:
        made["margins.png"] = lambda: reaction_figure(study.t, _margins(study), label="margin  [1]")
    return made


def _readable(name: str) -> str:
    return name.replace("_", " ")


def _framed(curves: Sequence[Curve]) -> dict[str, list[Curve]]:
    """Curves in frames of a few each."""
    parts = [list(curves[k : k + MOST_CURVES]) for k in range(0, len(curves), MOST_CURVES)]
    return {f"{part[0].name} to {part[-1].name}" if len(part) > 1 else part[0].name: part for part in parts}


def _joints(study: DriveStudy, *, rate: bool) -> Figure:
    from symscrew.display import Curve, reaction_figure

    values, units = (study.rates, study.units["rate"]) if rate else (study.displacements, study.units["joint"])
    mechanism = study.model.mechanism
    groups = {limb.name: set(limb.joints) for limb in mechanism.limbs.values()}
    rest = set(mechanism.joints).difference(*groups.values()) if groups else set(mechanism.joints)
    groups |= {"joints": rest} if rest else {}
    frames: dict[str, list[Curve]] = {}
    for title, names in groups.items():
        for unit in dict.fromkeys(units):
            own = [k for k, n in enumerate(study.labels["joint"]) if n.split(".")[0] in names and units[k] == unit]
            short = _without_common(title, [study.labels["joint"][k] for k in own])
            curves = [Curve(name, values[:, k], unit) for name, k in zip(short, own, strict=True)]
            for number, part in enumerate(range(0, len(curves), MOST_CURVES), 1):
                more = f", {number}" if len(curves) > MOST_CURVES else ""
                frames[f"{_readable(title)}{more}  [{unit}]"] = curves[part : part + MOST_CURVES]
    return reaction_figure(study.t, frames, label="rate" if rate else "displacement", across=2)


def _without_common(limb: str, labels: Sequence[str]) -> list[str]:
    """Labels of a limb's joints without the limb's name, which stands above them."""
    return [_readable(label.removeprefix(f"{limb}_")) for label in labels]


def _margins(study: DriveStudy) -> dict[str, list[Curve]]:
    """A frame per kind; of sets of redundant drives only all together, which is what can be lost."""
    from symscrew.display import Curve

    frames: dict[str, list[Curve]] = {}
    for name, values in watched(study).items():
        kind, _, label = name.partition(".")
        frames.setdefault(kind, []).append(Curve(_readable(label), values, "1"))
    return frames


def watched(study: DriveStudy) -> dict[str, Array]:
    """Margins that the mechanism cannot do without: where drives are redundant, of all of them together."""
    every = f"actuation.{ALL_DRIVES}"
    return {n: m for n, m in study.margins.items() if every not in study.margins or not n.startswith("actuation.")
            or n == every}  # fmt: skip


def _reactions(study: DriveStudy, *, moments: bool) -> dict[str, list[Curve]]:
    """Forces, or moments about the joint's point, of the joints that transmit any, absolute axes."""
    from symscrew.display import Curve

    largest = float(np.abs(study.wrench_table).max(initial=0.0)) or 1.0
    frames = {}
    for name, wrench in study.wrenches.items():
        values = wrench.about_joint().moment if moments else wrench.force
        if np.abs(values).max() > NOTHING * largest:
            letter = "m" if moments else "f"
            frames[_readable(name)] = [Curve(f"${letter}_{c}$", values[:, k], "") for k, c in enumerate("xyz")]
    return frames
