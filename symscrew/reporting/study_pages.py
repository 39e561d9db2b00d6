"""Sections that come from elsewhere: the results of `symscrew accuracy`, the bill of a scene's effects."""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

from symscrew.description import check_name, read_text
from symscrew.errors import DescriptionError, shorten
from symscrew.reporting.blocks import Block, Bullets, Picture, Section, Table, Text
from symscrew.studies import BILLED_FUNCTIONS, Bill

COSTS = {"ns": 1e9, "ms": 1e3, "s": 1.0}


def accuracy_section(directory: Path) -> list[Section]:
    """The studies in a directory that `symscrew accuracy` wrote: tables and plots.

    Raises:
        DescriptionError: no readable accuracy.json there.
    """
    file = directory / "accuracy.json"
    if not file.is_file():
        raise DescriptionError(
            f"--accuracy: {shorten(str(directory), 200)} has no accuracy.json; run symscrew accuracy first"
        )
    try:
        content = json.loads(read_text(file))
        return [
            Section("Accuracy against time", (Text(_head(content)),)),
            *(_study(s, directory) for s in content["studies"]),
        ]
    except (KeyError, TypeError, ValueError, AttributeError, OSError, RecursionError) as error:
        if isinstance(error, DescriptionError):
            raise
        raise DescriptionError(f"{file}: not a result of symscrew accuracy ({shorten(str(error))})") from error


def _head(content: dict[str, Any]) -> str:
    machine = ", ".join(f"{k}: {v}" for k, v in content["machine"].items())
    return f"Studies of {content['subject']}. Machine: {machine}."


def _study(study: dict[str, Any], directory: Path) -> Section:
    own = study["reference_error"]
    facts = [
        f"Reference: {study['reference']}" + ("" if own is None else f"; its own error {own:.1e}"),
        f"Error: {study['error_label']}. Cost: {study['cost_label']}, median with quartiles.",
        *map(str, study["notes"]),
        *(f"Left out: {what}" for what in study["left_out"]),
    ]
    unit = study["cost_unit"] if study["cost_unit"] in COSTS else "ns"
    rows = []
    for point in study["points"]:
        error = point["failure"] and f"failed: {point['failure']}"
        error = error or ("-" if point["error"] is None else f"{point['error']:.1e}")
        cost = point["cost"]
        text = "-" if cost is None else f"{_cost(cost, unit)}"
        rows.append((str(point["curve"]), str(point["setting"]), error, text))
    blocks: list[Block] = [Bullets(tuple(facts))]
    name = check_name(study["name"], "accuracy.json, study")  # it becomes the name of a file
    picture = directory / f"{name}.png"
    if picture.is_file():
        blocks.append(Picture(name, picture.read_bytes(), str(study["title"]), ".png"))
    header = ("method", "setting", "error", f"cost [{unit}]")
    blocks.append(Table(header, tuple(rows), frozenset({2, 3})))
    for title, (head, lines) in study["tables"].items():
        blocks.append(Table(tuple(map(str, head)), tuple(tuple(map(str, line)) for line in lines), caption=title))
    return Section(str(study["title"]), tuple(blocks), level=3)


def _cost(cost: dict[str, float], unit: str) -> str:
    low, middle, high = (f"{cost[key] * COSTS[unit]:.3g}" for key in ("lower", "median", "upper"))
    return f"{middle} ({low} \u2026 {high})"


def bill_section(bill: Bill) -> Section:
    """What each effect of a scene costs and changes."""
    from symscrew.display import curve_style
    from symscrew.studies import bill_figure

    rows = []
    for item in bill.items:
        times = [item.nanoseconds.get(f) for f in BILLED_FUNCTIONS]
        rows.append(
            (
                item.effect,
                *(f"{item.operations[f]:+d}" if f in item.operations else "-" for f in BILLED_FUNCTIONS),
                str(item.states),
                *("-" if t is None else f"{t:+.1f}" for t in times),
                *(f"{100 * item.change[n]:.3g} %" if n in item.change else "-" for n in ("drives", "accelerations")),
            )
        )
    own = [bill.nanoseconds.get(f) for f in BILLED_FUNCTIONS]
    totals = [str(bill.operations[f]) if f in bill.operations else "-" for f in BILLED_FUNCTIONS]
    rows.append(
        (
            "all of it",
            *totals,
            str(sum(i.states for i in bill.items)),
            *("-" if t is None else f"{t:.0f}" for t in own),
            "",
            "",
        )
    )
    header = (
        "effect",
        "operations inverse",
        "forward",
        "states",
        "ns inverse",
        "forward",
        "drives change",
        "accelerations change",
    )
    out = io.BytesIO()
    with curve_style():
        bill_figure(bill).savefig(out, format="png", dpi=200, metadata={"Software": None})
    text = (
        f"Scene {bill.name}, along its {bill.motion}. Operations, states and nanoseconds: with the effect less "
        "without it. "
        "Change: root mean square of the difference that leaving the effect out makes."
    )
    picture = Picture("bill", out.getvalue(), "What each effect adds, and what leaving it out changes.", ".png")
    return Section("Bill of effects", (Text(text), Table(header, tuple(rows), frozenset(range(1, 8))), picture))
