"""Sections with numbers: what a motion needs of drives and joints, and what a map over the workspace found.

DriveStudy --motion_section--> tables and pictures        Sweep --sweep_section--> text and the map
"""

from __future__ import annotations

import io
import tempfile
from pathlib import Path

from symscrew.reporting.blocks import Block, Bullets, Picture, Section, Table, Text
from symscrew.studies.given_motion import DriveStudy, doubts, pictures, study_json, watched
from symscrew.studies.workspace import Sweep, draw_maps, sweep_summary_text

DRAWN = ("drives.png", "powers.png", "margins.png")
"""Pictures of a motion that a report shows: what sizes motors, and how near it comes to singularities."""
ROUNDED = 1e-12  # rad or m: displacements below are what rounding leaves of none
DPI = 130  # of pictures that fill the page's width: 900 pixels


def motion_section(study: DriveStudy) -> Section:
    """The numbers of a motion: largest and mean drives, what joints carry, least margins; with curves."""
    found = study_json(study)
    head = (
        f"{', '.join(found['motion'])} over {found['duration']:g} s, {found['states']} states. {study.status}. The "
        f"motion is followed to {found['missed']:.1e}, the loops are open by {found['opening']:.1e}."
    )
    blocks: list[Block] = [Text(head), *(Text(f"{text[0].upper()}{text[1:]}.") for text in doubts(study))]
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    if found["drives"]:
        header = ("drive", "unit", "largest", "root mean square", "largest rate", "", "largest power [W]")
        rows = tuple(
            (name, d["unit"], f"{d['largest']:.4g}", f"{d['rms']:.4g}", f"{d['largest_rate']:.3g}", d["rate_unit"],
             f"{d['largest_power']:.4g}")
            for name, d in found["drives"].items()
        )  # fmt: skip
        blocks.append(Table(header, rows, frozenset({2, 3, 4, 6}), "Drives"))
    rows = tuple(
        (name, f"{j['largest_force']:.4g}", f"{j['largest_moment']:.4g}", f"{j['at']:.4g}")
        for name, j in found["joints"].items()
    )
    header = ("joint", "force [N]", "moment about its point [N m]", "at t [s]")
    blocks.append(Table(header, rows, frozenset({1, 2, 3}), "Largest reactions"))
    rows = tuple(
        (name, _clean(r["least"]), _clean(r["largest"]), r["unit"]) for name, r in found["displacements"].items()
    )
    blocks.append(Table(("joint", "least", "largest", ""), rows, frozenset({1, 2}), "Displacements"))
    least = {name: found["margins"][name] for name in watched(study)}
    if least:
        rows = tuple((name, f"{m['least']:.3g}", f"{m['at']:.4g}") for name, m in least.items())
        blocks.append(Table(("margin", "least", "at t [s]"), rows, frozenset({1, 2}), "Distance from singularities"))
    drawn = pictures(study)
    blocks += [Picture(f"motion_{n[:-4]}", _png(drawn[n]()), _caption(n), ".png") for n in DRAWN if n in drawn]
    return Section("Along a motion", tuple(blocks))


def _clean(value: float) -> str:
    return "0" if abs(value) < ROUNDED else f"{value:.4g}"


def _caption(name: str) -> str:
    return {"drives.png": "Drives over time.", "powers.png": "Powers of the drives over time.",
            "margins.png": "Margins over time: 0 at a singularity."}[name]  # fmt: skip


def _png(figure: object) -> bytes:
    from symscrew.display import curve_style

    out = io.BytesIO()
    with curve_style():
        figure.savefig(out, format="png", dpi=DPI, metadata={"Software": None})  # type: ignore[attr-defined]
    return out.getvalue()


def sweep_section(sweep: Sweep) -> Section:
    """What a map over the workspace says, and the map."""
    axes = ", ".join(f"{a.name} in {a.count} steps" for a in sweep.plan.axes)
    lines = tuple(line.strip() for line in sweep_summary_text(dict(sweep.summary)).splitlines() if line.strip())
    blocks: list[Block] = [Text(f"{sweep.plan.count} cases over {axes}."), Bullets(lines)]
    with tempfile.TemporaryDirectory(prefix="symscrew_") as folder:
        drawn = draw_maps(sweep.plan, dict(sweep.results), sweep.units, Path(folder) / "map.png")
        if drawn is not None:
            blocks.append(Picture("workspace", drawn.read_bytes(), f"Over {axes}.", ".png"))
    return Section("Workspace", tuple(blocks))
