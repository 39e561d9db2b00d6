"""The equations of a certificate: programs of a model, cut to what is asked of them, as the lists of its file.

Model, axes, limits --> closure and its independent rows, coordinates that are held, drives, margins, limited results
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean
from symscrew.model import Model
from symscrew.program import Program, evaluate
from symscrew.studies.certificate.certificate_checker import Equations, Form, constant, full_rank
from symscrew.studies.workspace import SINGULAR, independent_labels

Array = np.ndarray
MARGINS = ("limb_margins", "constraint_margin", "actuation_margins")
LIMITED = {"joint_displacements": "", "forward_kinematics": "point ", "inverse_dynamics": "drive "}
"""Functions whose results can have limits, and how a result is called."""
DEPENDENT = 1e-8
"""Part of a row, relative, that the rows before it leave of one that follows from them: rounding of the screws."""


def file_equations(
    model: Model, axes: Sequence[str], limits: Sequence[tuple[str, float, float]], start: Array
) -> dict[str, Any]:
    """What `Equations.read` of the checker takes, and the labels of the closure's rows.

    Args:
        model: the model.
        axes: independent coordinates and run-time parameters: the edges of a box.
        limits: result, least and largest value [SI]; infinite for none.
        start: a closed configuration (nq,), where it is seen which rows are independent.

    Raises:
        DescriptionError: a limit of something that is no result of a program.
    """
    labels = [c.label for c in model.system.tree.q]
    parameters = [n for n, p in model.mechanism.parameters.items() if p.run_time]
    places = [("q", labels.index(a)) if a in labels else ("p", parameters.index(a)) for a in axes]
    held = [labels.index(y) for y in independent_labels(model) if y not in axes]
    found: dict[str, Any] = {
        "closure": {"inputs": [["q", len(labels)]], "instructions": [], "results": []},
        "labels": [],
        "rows": [],
        "quaternions": [link.q.start for link in model.system.tree.links[1:] if link.motion.spherical],
        "count": len(labels),
        "axes": places,
        "held": [[k, float(start[k])] for k in held],
        "parameters": [float(x) for x in model.system.parameter_values],
        "driven": None,
        "conditions": [],
    }
    if "closure" in model.programs:
        program = model.programs["closure"]
        assert isinstance(program, Program)
        found["closure"] = program_lists(program, range(program.outputs[0].size))
        found["labels"] = list(program.outputs[0].labels)
        _choose(model, found, start)
    found["conditions"] = [*_margins(model, found), *_limits(model, limits)]
    return found


def program_lists(program: Program, wanted: Sequence[int]) -> dict[str, Any]:
    """The instructions behind some entries of the first output."""
    results = [program.results[0][k] for k in wanted]
    needed = {r for r in results if isinstance(r, int)}
    kept = []
    for target, op, args in reversed(program.instructions):
        if target in needed:
            kept.append([target, op, *args])
            needed |= {a for a in args if isinstance(a, int)}
    return {
        "inputs": [[port.name, port.size] for port in program.inputs],
        "instructions": kept[::-1],
        "results": [r if isinstance(r, int) else float(r) for r in results],
    }


def sampled_margins(model: Model) -> dict[str, Array]:
    """The margins that are looked at [1], of all drives and not of sets of them: in the reference, then near it."""
    found: dict[str, Array] = {}
    for name in MARGINS:
        if name not in model.programs:
            continue
        program = model.programs[name]
        assert isinstance(program, Program)
        p, q = model.system.parameter_values, model.system.sample_states[0]
        given = [p if port.name == "p" else q for port in program.inputs]
        labels = program.outputs[0].labels
        values = np.atleast_2d(evaluate(program, given)[0][0])
        kept = labels[:1] if name == "actuation_margins" else labels
        found |= {f"{name.split('_')[0]} {n}": values[:, k] for k, n in enumerate(kept)}
    return found


def vanishing_margins(model: Model) -> list[str]:
    """Those that are zero in the reference configuration and at the sample states near it: nothing holds anywhere."""
    return [name for name, values in sampled_margins(model).items() if (np.abs(values) <= SINGULAR).all()]


def limited_results(model: Model) -> dict[str, tuple[str, int, str]]:
    """Result that can be limited -> function, entry, unit."""
    found: dict[str, tuple[str, int, str]] = {}
    for function, prefix in LIMITED.items():
        if function in model.programs:
            port = model.programs[function].outputs[0]
            found |= {f"{prefix}{n}": (function, k, port.units[k]) for k, n in enumerate(port.labels)}
    for function in MARGINS:
        if function in model.programs:
            labels = model.programs[function].outputs[0].labels
            found |= {f"{function.split('_')[0]} {n}": (function, k, "1") for k, n in enumerate(labels)}
    return found


def _condition(model: Model, function: str, entries: Sequence[int], names: Sequence[str]) -> dict[str, Any]:
    program = model.programs[function]
    assert isinstance(program, Program)
    return {"program": program_lists(program, entries), "names": list(names), "limits": None}


def _margins(model: Model, values: dict[str, Any]) -> list[dict[str, Any]]:
    """Margins that are looked at by their programs: the others are volumes of matrices whose rank is looked at.

    The constraint margin vanishes where the closure loses rank, that of all drives where the closure with driven
    coordinates locked does. Margins that are zero all over are left out.
    """
    known, none = sampled_margins(model), vanishing_margins(model)
    by_rank = {"constraint_margin"} if values["rows"] else set()
    by_rank |= {"actuation_margins"} if values["driven"] is not None else set()
    found = []
    for function in MARGINS:
        if function in model.programs and function not in by_rank:
            names = [f"{function.split('_')[0]} {n}" for n in model.programs[function].outputs[0].labels]
            kept = [k for k, n in enumerate(names) if n in known and n not in none]
            found += [_condition(model, function, kept, [names[k] for k in kept])] if kept else []
    return found


def _limits(model: Model, limits: Sequence[tuple[str, float, float]]) -> list[dict[str, Any]]:
    known = limited_results(model)
    found: dict[str, tuple[list[int], list[str], list[Any]]] = {}
    for name, low, high in limits:
        if name not in known:
            raise DescriptionError(
                f"--limit with --certify: no bounds are known of {name!r}, only of joints, points, drives at rest and "
                f"margins; {did_you_mean(name, known)}"
            )
        function, entry, _ = known[name]
        entries, names, ends = found.setdefault(function, ([], [], []))
        entries.append(entry)
        names.append(f"limit {name}")
        ends.append([low if math.isfinite(low) else None, high if math.isfinite(high) else None])
    return [
        {**_condition(model, function, entries, names), "limits": ends}
        for function, (entries, names, ends) in found.items()
    ]


def _choose(model: Model, values: dict[str, Any], start: Array) -> None:
    """Names the rows that the proof uses, and the drives whose hold it shows, where they hold at the start.

    All rows that are not zero by their form where these are as many as the dependent coordinates; else the first that
    are independent of those before them. Drives of cut joints have no coordinate; for those their margin must do.
    """
    candidates = [k for k, r in enumerate(values["closure"]["results"]) if r != 0.0]
    equations = Equations.of({**values, "rows": candidates})
    columns = equations.dependent
    c = _slopes_at(equations, start)
    dense = c[:, columns] if columns else c
    wanted = len(columns) - len(values["quaternions"])
    if len(candidates) > wanted:
        basis = [*np.linalg.qr(dense[len(candidates) :].T)[0].T]
        chosen: list[int] = []
        for k, row in zip(candidates, dense, strict=False):
            left = row - sum((b * (b @ row) for b in basis), np.zeros_like(row))
            if np.linalg.norm(left) > DEPENDENT * np.linalg.norm(row) and len(chosen) < wanted:
                basis.append(left / np.linalg.norm(left))
                chosen.append(k)
        candidates = chosen
    values["rows"] = candidates
    tree = model.system.tree
    of_rate = {v: link.q.start + i for link in tree.links[1:] if not link.motion.spherical
               for i, v in enumerate(range(link.v.start, link.v.stop))}  # fmt: skip
    driven = [of_rate[v] for v in model.system.drive_rows() if v in of_rate]
    if driven and len(driven) == len(model.system.drives) and len(candidates) == wanted:
        c = _slopes_at(Equations.of({**values, "driven": driven}), start)
        left = [k for k in range(values["count"]) if k not in driven]
        if full_rank(Form(c[:, left, None], np.zeros((0, len(c), len(left), 1)), 0.0 * c[:, left, None]))[0]:
            values["driven"] = driven


def _slopes_at(equations: Equations, q: Array) -> Array:
    """Derivatives of the equations (rows, coordinates and parameters) at q (count,), without any proof."""
    given = {"q": [Form(np.array([x]), np.zeros((0, 1)), np.zeros(1)) for x in q]}
    given["p"] = [constant(x, 0) for x in equations.parameters]
    rows = equations.residual(given, slopes=True)[1]
    width = equations.count + len(equations.parameters)
    return np.stack([np.zeros(width) if row is None else row.c[:, 0] for row in rows])
