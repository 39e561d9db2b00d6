"""Transcriptions of several parts as one nonlinear program, and what joins them.

parts --unknowns side by side, rows one after the other--> `Joined`;    links: y goes on, rates by a momentum balance
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError, did_you_mean
from symscrew.optimisation.casadi_graph import symbolic_outputs
from symscrew.optimisation.constraints import closure_rows
from symscrew.optimisation.joined_problem import JoinedProblem, Link
from symscrew.optimisation.linear_rows import LinearRows
from symscrew.optimisation.motion_quantities import MotionQuantities
from symscrew.optimisation.point import point_symbols
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.rows import PointFunction, Row
from symscrew.optimisation.sparse import Family, Linear, SparseMap
from symscrew.optimisation.transcription import Transcribed
from symscrew.optimisation.unknowns import Terms, Unknowns


@dataclass(frozen=True)
class Joined:
    """The program of all parts: what `Transcribed` is for one; families of the parts come before those of links."""

    parts: tuple[Transcribed, ...]
    unknowns: Unknowns
    families: tuple[Family, ...]
    linear: Linear
    cost: np.ndarray

    def own(self, k: int, x: np.ndarray) -> np.ndarray:
        """The unknowns of part k among all, or their multipliers."""
        first = sum(part.unknowns.size for part in self.parts[:k])
        return x[first : first + self.parts[k].unknowns.size]

    def own_rows(self, k: int, values: np.ndarray) -> np.ndarray:
        """What belongs to the rows of part k among all rows, in the order of its own program."""
        counts = [sum(f.count * len(f.function.rows) for f in part.families) for part in self.parts]
        whole = sum(f.count * len(f.function.rows) for f in self.families)
        linear = [len(part.linear.labels) for part in self.parts]
        first, behind = sum(counts[:k]), whole + sum(linear[:k])
        return np.concatenate([values[first : first + counts[k]], values[behind : behind + linear[k]]])

    def with_rows(self, parts: Sequence[np.ndarray]) -> np.ndarray:
        """The inverse of `own_rows`; 0 for the rows of links."""
        counts = [sum(f.count * len(f.function.rows) for f in part.families) for part in self.parts]
        nonlinear = [rows[:n] for rows, n in zip(parts, counts, strict=True)]
        linear = [rows[n:] for rows, n in zip(parts, counts, strict=True)]
        whole = sum(f.count * len(f.function.rows) for f in self.families)
        between = np.zeros(whole - sum(counts))
        behind = np.zeros(len(self.linear.labels) - sum(len(rows) for rows in linear))
        return np.concatenate([*nonlinear, between, *linear, behind])


def joined(problem: JoinedProblem, parts: Sequence[Transcribed]) -> Joined:
    """One program of transcribed parts.

    Raises:
        DescriptionError: a link names what is no freedom, or joins parts that do not fit.
    """
    unknowns, families, linear = Unknowns(), list[Family](), list[Linear]()
    for k, part in enumerate(parts):
        first, own = unknowns.size, part.unknowns
        unknowns.index |= {f"{k}:{name}": first + at for name, at in own.index.items()}
        unknowns.scale = np.concatenate([unknowns.scale, own.scale])
        unknowns.lower = np.concatenate([unknowns.lower, own.lower])
        unknowns.upper = np.concatenate([unknowns.upper, own.upper])
        unknowns.tau = np.concatenate([unknowns.tau, own.tau])
        unknowns.labels += [f"{label} in {problem.called(k)}" for label in own.labels]
        families += [replace(f, map=_moved(f.map, first)) for f in part.families]
        linear.append(replace(part.linear, map=_moved(part.linear.map, first)))
    costs = [part.cost for part in parts]
    rows = LinearRows(parts[0].model, parts[0].grid, unknowns)
    for k, link in enumerate(problem.links):
        if link is not None:
            _check(parts[k].model, parts[k + 1].model, link, k)
            families += _rates(unknowns, parts, k, link)
            _add_continuity(rows, parts, k)
    _add_design(rows, parts)
    cost = np.concatenate([*costs, np.zeros(unknowns.size - sum(map(len, costs)))])
    return Joined(tuple(parts), unknowns, tuple(families), _stacked([*linear, rows.linear()]), cost)


def _moved(given: SparseMap, by: int) -> SparseMap:
    return replace(given, columns=given.columns + by)


def _stacked(linear: Sequence[Linear]) -> Linear:
    rows, columns, values, first = [], [], [], 0
    for part in linear:
        rows.append(part.map.rows + first)
        columns.append(part.map.columns)
        values.append(part.map.values)
        first += len(part.labels)
    return Linear(
        SparseMap.of(np.concatenate(rows), np.concatenate(columns), np.concatenate(values), first),
        np.concatenate([part.lower for part in linear]),
        np.concatenate([part.upper for part in linear]),
        tuple(label for part in linear for label in part.labels),
        np.concatenate([part.tau for part in linear]),
    )


def _check(first: PointModel, second: PointModel, link: Link, k: int) -> None:
    if first.equations.layout != second.equations.layout or first.equations.labels != second.equations.labels:
        raise DescriptionError(
            f"phases {k + 1} and {k + 2} have other coordinates; name the same ones under 'independent', and effects "
            "that read the same joints"
        )
    for label in link.impact:
        if label not in first.rate_labels:
            raise DescriptionError(
                f"impact of phase {k + 1}: unknown freedom {label!r}; {did_you_mean(label, first.rate_labels)}"
            )
    carried = [s.name for m in (first, second) for s in m.equations.acting.states if s.carried is not None]
    if carried:
        raise DescriptionError(f"phases: the state {carried[0]} starts with the motion, and no link can carry it over")


def _add_continuity(rows: LinearRows, parts: Sequence[Transcribed], k: int) -> None:
    """y of the end is y of the next start; states of effects that both phases have go on, others start anew."""
    index, (first, second) = rows.unknowns.index, (parts[k].model, parts[k + 1].model)
    where = f"between phases {k + 1} and {k + 2}"
    new = rows.new([f"{label} {where}" for label in first.equations.labels], 1.0)[0]
    rows.terms.add(new, index[f"{k + 1}:y"][0], 1 / first.scales.y)
    rows.terms.add(new, index[f"{k}:y"][-1], -1 / first.scales.y)
    for j, name in enumerate(second.states):
        if name not in first.states:
            continue
        later = index[f"{k + 1}:x"][0, j]
        rows.unknowns.lower[later], rows.unknowns.upper[later] = -np.inf, np.inf  # the part alone would hold it
        new = rows.new([f"state {name} {where}"], 1.0)[0]
        rows.terms.add(new, later, 1 / second.scales.x[j])
        rows.terms.add(new, index[f"{k}:x"][-1, first.states.index(name)], -1 / second.scales.x[j])


def _add_design(rows: LinearRows, parts: Sequence[Transcribed]) -> None:
    """Parameters that are chosen have one value in all parts."""
    for k, part in enumerate(parts[1:], 1):
        if part.model.design:
            p, size = rows.unknowns.index[f"{k}:p"], rows.unknowns.scale[rows.unknowns.index["0:p"]]
            new = rows.new([f"parameter {name} in all parts" for name in part.model.design], 0.0)[0]
            rows.terms.add(new, p, 1 / size)
            rows.terms.add(new, rows.unknowns.index["0:p"], -1 / size)


def _rates(unknowns: Unknowns, parts: Sequence[Transcribed], k: int, link: Link) -> list[Family]:
    """What the rates do between phases k and k + 1, as a family of one point."""
    function = link_function(parts[k].model, parts[k + 1].model, link, f"between phases {k + 1} and {k + 2}")
    model, name = parts[k].model, f"link_{k}"
    index = unknowns.index
    places = {
        "y": index[f"{k}:y"][-1], "y_1": index[f"{k}:y_1"][-1], "after": index[f"{k + 1}:y_1"][0],
        "T": index.get(f"{k}:T"), "T_after": index.get(f"{k + 1}:T"), "p": index.get(f"{k}:p"),
    }  # fmt: skip
    if function.blocks["z"].numel():
        labels = [f"coordinate {model.system.tree.q[j].label} {function_end(k)}" for j in model.equations.layout.z]
        places["z"] = unknowns.add(f"{name}:z", np.array(1.0), labels, model.scales.z)
    if function.blocks["impulse"].numel():
        size = np.full(len(link.impact), float(model.scales.force[0]) * model.scales.duration)
        labels = [f"impulse along {label} {function_end(k)}" for label in link.impact]
        places["impulse"] = unknowns.add(f"{name}:impulse", np.array(1.0), labels, size)
    terms, at = Terms(unknowns), 0
    for block, symbol in function.blocks.items():
        if symbol.numel():
            entries = places[block]
            assert entries is not None
            terms.add(at + np.arange(symbol.numel()), entries.ravel())
        at += symbol.numel()
    entries = SparseMap.of(*terms.entries(), at)
    return [Family(name, function, 1, entries, np.zeros(at), np.zeros(1), np.ones(1))]


def function_end(k: int) -> str:
    """Where phase k ends."""
    return f"at the end of phase {k + 1}"


def link_function(first: PointModel, second: PointModel, link: Link, where: str) -> PointFunction:
    """The rows of a link: rates that go on, or closure, momentum balance and restitution; see `Link`."""
    d, smooth = first.d, link.is_smooth
    sizes = {
        "y": d, "z": 0 if smooth else len(first.equations.layout.z), "y_1": d, "after": d, "impulse": len(link.impact),
        "T": int(first.problem.free_duration), "T_after": int(second.problem.free_duration),
        "p": 0 if smooth else len(first.design),
    }  # fmt: skip
    blocks = {name: ca.SX.sym(name, size) for name, size in sizes.items()}
    T, T_after = (
        blocks[name] if model.problem.free_duration else ca.SX(_fixed(model))
        for name, model in (("T", first), ("T_after", second))
    )
    before, after = blocks["y_1"] / T, blocks["after"] / T_after
    duration = first.scales.duration
    if smooth:
        rows = [
            Row(f"rate of {label} {where}", after[k] - before[k], scale=float(first.scales.y[k]) / duration)
            for k, label in enumerate(first.equations.labels)
        ]
        return PointFunction(blocks, tuple(rows))
    earlier, later = _Momentum(first, blocks), _Momentum(second, blocks)
    directions = [later.direction(label) for label in link.impact]
    change = later.inertia @ after - (earlier if link.catches else later).inertia @ before
    for k, direction in enumerate(directions):
        change = change - direction.T * blocks["impulse"][k]
    size = first.scales.force * duration
    rows = closure_rows(later.at, where)
    rows += [Row(f"momentum {where}, row {k + 1}", change[k], scale=float(size[k])) for k in range(d)]
    for direction, (label, restitution) in zip(directions, link.impact.items(), strict=True):
        rate = direction @ after + restitution * direction @ before
        rows.append(Row(f"rate of {label} behind the impact {where}", rate, scale=1 / duration))
    return PointFunction(blocks, tuple(rows))


def _fixed(model: PointModel) -> float:
    duration = model.problem.duration
    assert not isinstance(duration, tuple)
    return float(duration)


class _Momentum:
    """The inertia along y, N^T M N, and directions of freedoms at the y and z of a link."""

    def __init__(self, model: PointModel, blocks: dict[str, ca.SX]) -> None:
        self.model = model
        own = point_symbols(model, moving=True)
        states = ca.DM(model.initials)
        rest = {n: ca.SX.zeros(s.numel()) for n, s in own.items()}
        rest |= {"x": ca.SX(states), "T": ca.SX.ones(own["T"].numel())}
        rest |= {name: blocks[name] for name in ("y", "z", "p") if own[name].numel()}
        names = [name for name, symbol in own.items() if symbol.numel()]
        self._own, self._from, self._to = own, [own[n] for n in names], [ca.SX(rest[n]) for n in names]
        self._free = MotionQuantities(model, own)
        self.at = MotionQuantities(model, {**own, **{n: blocks[n] for n in ("y", "z", "p")}})
        residual = symbolic_outputs(model.equations.dynamics, self._free.known)["residual"]
        self.inertia = self._placed(ca.jacobian(residual, own["y_2"]) * self._free.T**2)

    def _placed(self, value: ca.SX) -> ca.SX:
        return ca.substitute([value], self._from, self._to)[0]

    def direction(self, label: str) -> ca.SX:
        """The rate of a freedom by y_dot: (1, d)."""
        rate = ca.SX(self._free.rate(label))
        return self._placed(ca.jacobian(rate, self._own["y_1"]) * self._free.T)
