"""What `symscrew accuracy` leaves: raw JSON and Markdown tables; the table for a README, shortened to the best."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict

from symscrew.description import markdown_text
from symscrew.display import aligned_table
from symscrew.studies.accuracy.measuring import Point, Study
from symscrew.studies.timing import Times

SAME_TIME = 1.05  # times that differ by less are one: repeats differ as much
UNITS = {"ns": 1e9, "ms": 1e3, "s": 1.0}


def study_json(name: str, studies: Sequence[Study], machine: Mapping[str, str], left_out: Sequence[str] = ()) -> str:
    """The raw results, everything as numbers and texts, costs in seconds; `left_out`: studies that there are not."""
    values = {"subject": name, "machine": dict(machine), "studies": [asdict(study) for study in studies]}
    return json.dumps({**values, "left_out": list(left_out)}, indent=1, allow_nan=False, default=float) + "\n"


def study_markdown(
    name: str,
    studies: Sequence[Study],
    machine: Mapping[str, str],
    *,
    pictures: Sequence[str],
    left_out: Sequence[str] = (),
) -> str:
    """All points of all studies, with references, preparation, notes, the machine, and why studies are left out."""
    lines = [f"# Accuracy against time: {markdown_text(name)}", ""]
    for study in studies:
        lines += [f"## {study.title}", "", *about(study), "", points_table(study.points, study), ""]
        for title, (header, rows) in study.tables.items():
            lines += [f"**{title}**", "", aligned_table(header, rows), ""]
        lines += [f"![{study.title}]({p})" for p in pictures if p.startswith(study.name) and p.endswith(".png")]
        lines.append("")
    if left_out:
        lines += ["## Left out", "", *(f"- {markdown_text(reason)}" for reason in left_out), ""]
    lines += ["## Machine", "", aligned_table(("part", "found"), list(machine.items())), ""]
    return "\n".join(lines)


def about(study: Study) -> list[str]:
    """Sentences on a study: reference, axes, preparation, what is missing."""
    own = "not known" if study.reference_error is None else f"{study.reference_error:.1e}"
    lines = [
        f"- Reference: {study.reference}: {own}.",
        f"- Error: {study.error_label}. Cost: {study.cost_label}, median with quartiles of interleaved repeats; "
        "processor time of the one thread.",
    ]
    if study.preparation:
        spent = ", ".join(f"{what} {seconds:.2f} s" for what, seconds in study.preparation.items())
        lines.append(f"- Preparation, not part of any cost: {spent}.")
    return [*lines, *(f"- {note}" for note in study.notes), *(f"- Left out: {what}." for what in study.left_out)]


def points_table(points: Sequence[Point], study: Study) -> str:
    """Every point of a study, failed ones too."""
    unit = study.cost_unit if study.cost_unit in UNITS else "ns"
    counted = any("operations" in p.facts for p in points)
    header = ["curve", "setting", "error", f"cost [{unit}] (quartiles)", "repeats"]
    header += ["operations"] if counted else []
    return aligned_table(header, [_row(p, unit, counted) for p in points])


def _row(point: Point, unit: str, counted: bool) -> list[str]:
    error = _failed(point) if point.failure else ("-" if point.error is None else f"{point.error:.2e}")
    row = [point.curve, point.setting, error, cost_text(point.cost, unit), str(point.cost.repeats if point.cost else 0)]
    return [*row, str(point.facts.get("operations", "-"))] if counted else row


def _failed(point: Point) -> str:
    return point.failure if point.failure.startswith("not run") else f"failed: {point.failure}"


def cost_text(cost: Times | None, unit: str) -> str:
    """Median (lower ... upper)."""
    if cost is None:
        return "-"
    factor = UNITS[unit]
    return f"{number(cost.median * factor)} ({number(cost.lower * factor)} ... {number(cost.upper * factor)})"


def number(value: float) -> str:
    """Three digits, without an exponent where that is short.

    >>> number(1234.5), number(0.0123), number(1.234e-7)
    ('1230', '0.0123', '1.23e-07')
    """
    if value == 0 or not 1e-4 <= abs(value) < 1e7:
        return f"{value:.3g}"
    return f"{float(f'{value:.3g}'):.10g}"


def study_summary(studies: Sequence[Study]) -> tuple[tuple[str, ...], list[list[str]]]:
    """Header and rows: of one study each curve's Pareto front, at most four points; of several its best."""
    rows, most = [], 4 if len(studies) == 1 else 1
    for study in studies:
        unit = study.cost_unit if study.cost_unit in UNITS else "ns"
        for curve, points in study.curves.items():
            few = len(points) <= 8 and study.name in ("precision", "effects")
            for point in [p for p in points if p.error is not None] if few else front(points, most):
                rows.append(
                    [study.name, curve, point.setting, f"{point.error:.1e}", f"{cost_text(point.cost, unit)} {unit}"]
                )
            failed = [p for p in points if p.failure]
            if failed and len(failed) == len(points):
                rows.append([study.name, curve, f"{len(failed)} settings", _failed(failed[0]), "-"])
    return ("study", "curve", "setting", "error", "cost"), rows


def front(points: Sequence[Point], most: int = 4) -> list[Point]:
    """Points of which none is both slower by over 5 % and less accurate than another; spread over the errors.

    Of one alone: the cheapest of those whose error is at most twice the least.
    """
    good = [(p.error, p.cost.median, p) for p in points if p.error is not None and p.cost is not None]
    best = [
        (error, point)
        for error, cost, point in good
        if not any(e < error and c <= SAME_TIME * cost for e, c, other in good if other is not point)
    ]
    best.sort(key=lambda found: -found[0])
    if len(best) <= most:
        return [point for _, point in best]
    if most == 1:
        return [next(p for p in sorted((p for _, p in best), key=_median) if (p.error or 0.0) <= 2 * best[-1][0])]
    picked = [round(k * (len(best) - 1) / (most - 1)) for k in range(most)]
    return [best[k][1] for k in picked]


def _median(point: Point) -> float:
    assert point.cost is not None
    return point.cost.median
