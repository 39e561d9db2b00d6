"""What inputs do in time, so that no step passes it unseen: knots, jumps, and how fast what is smooth changes.

expressions of t --interval series, halved until resolved--> edges of intervals; knots, jumps, kinks --> breaks

On every interval between two edges each input is a polynomial of order 8 up to a part `RESOLVED` of its size, with a
proof by intervals: a pulse of a millisecond in a hundred seconds is found wherever it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np
import sympy

from symscrew.description import parse
from symscrew.effects import Acting
from symscrew.kinematics import identifiers
from symscrew.model import Model
from symscrew.scene.contents import Scene
from symscrew.scene.interval_series import ORDER, series

# Part of an input's size by which it may differ from a polynomial on an interval: what is smaller is not looked for.
# The widths of intervals go with its eighth root.
RESOLVED = 1e-8
# Intervals of all inputs together; a scene whose inputs need more is told that they are not bounded. A step per four of
# them is some seconds of computing.
MOST = 100_000
# Part of the duration before a break within which there is no other edge: a step from there onto it would be rounding.
NEAR = 1e-13
SAMPLES = 64  # intervals on which the size of an input is looked at


@dataclass(frozen=True)
class TimeFeatures:
    """`edges` (n,) [s] ascending, behind 0; `lefts` (n,): at a break the latest time [s] before it, else 0.

    The end of a run whose inputs change is a break. `notices` say which inputs are not bounded, and why.
    """

    edges: np.ndarray = field(default_factory=lambda: np.zeros(0))
    lefts: np.ndarray = field(default_factory=lambda: np.zeros(0))
    notices: tuple[str, ...] = ()

    def ahead(self, t: float, end: float, span: int) -> tuple[float, float]:
        """The end of what can be integrated at once from t [s], and the latest time before it: the next break, `span`
        edges ahead (0: however many), or `end`."""
        later = np.flatnonzero((self.edges > t) & (self.edges < end))
        jumps = later[self.lefts[later] > 0]
        first = min([*jumps[:1], *later[span - 1 : span if span else 0]], default=-1)
        if first < 0:
            return end, end
        return float(self.edges[first]), float(self.lefts[first]) or float(self.edges[first])

    def passed(self, step: float, span: int) -> tuple[str, ...]:
        """A notice of what steps of a fixed length [s] may pass: `span` edges within one; they end at breaks."""
        edges, ends = np.concatenate([[0.0], self.edges]), np.concatenate([[0], np.cumsum(self.lefts > 0)])
        widths = np.where(ends[span:] == ends[:-span], edges[span:] - edges[:-span], np.inf)
        if not len(widths) or not widths.min() < step:
            return ()
        width, at = widths.min(), edges[widths.argmin()]
        return (
            f"inputs change within {width:.2g} s at t = {at:.6g} s, which steps of {step:.2g} s may pass unseen or "
            "take for longer than it is; shorten the step, or leave it out",
        )


UNCHANGING = TimeFeatures()


def features_in_time(scene: Scene, model: Model) -> TimeFeatures:
    """Edges and breaks of the scene's drives, inputs of effects, rates of states, and of what effects say of t, within
    its duration."""
    functions: dict[sympy.Expr, str] = {}
    notices = []
    for where, expression in _expressions(scene, model):
        for part in _parts_in_time(expression):
            if part.free_symbols == {_TIME}:
                functions.setdefault(part, where)
            else:
                notices.append(
                    f"{where}: {part} changes with time and the motion together, so how fast cannot be bounded "
                    "beforehand: what is shorter than the steps may be passed unseen (longest_step bounds them)"
                )
    breaks = {t: t for table in scene.tables.values() for t in table.times if 0 < t < scene.duration}
    if scene.tables or functions:  # what inputs do behind the end is not looked at: no step goes there
        breaks[scene.duration] = scene.duration
    edges, jumps, unresolved = _intervals(list(functions), scene.duration)
    for k, reason in unresolved.items():
        expression = list(functions)[k]
        notices.append(
            f"{functions[expression]}: {expression} {reason}: what is shorter than the steps may be passed unseen "
            "(longest_step bounds them)"
        )
    breaks |= {t: left for t, left in jumps.items() if t > NEAR * scene.duration}
    following = np.array([*sorted(breaks), np.inf])
    gaps = following[np.searchsorted(following, edges, side="right")] - np.array(edges)
    every = sorted({*np.array(edges)[gaps > NEAR * scene.duration].tolist(), *breaks})
    lefts = [breaks.get(t, 0.0) for t in every]
    return TimeFeatures(np.array(every, dtype=float), np.array(lefts, dtype=float), tuple(dict.fromkeys(notices)))


_TIME = sympy.Symbol("t", real=True)


def _expressions(scene: Scene, model: Model) -> Iterator[tuple[str, sympy.Expr]]:
    """The scene's expressions with numbers for parameters, and where they stand."""
    chosen = {name: sympy.Float(value, 30) for name, value in scene.parameters.items()}
    names = model.mechanism.values(chosen)
    forward = model.programs["forward_dynamics"]
    states = [label for port in forward.inputs if port.name == "x" for label in port.labels]
    tree = model.system.tree
    plain = [("q", identifiers(c.label for c in tree.q)), ("v", identifiers(c.label for c in tree.v))]
    others = [*(f"{prefix}_{name}" for prefix, found in plain for name in found.values()), *states, *scene.states]
    names |= {name.replace(".", "_"): sympy.Symbol(name.replace(".", "_"), real=True) for name in others}
    # knots of tables are breaks, and between them tables are polynomials of order 3: as smooth as a constant
    names |= {name: sympy.Integer(1) for name in scene.tables}
    names["t"] = _TIME
    for name, text in scene.signals.items():
        names[name] = parse(text, names, where=f"signals.{name}")
    for label, text in scene.drives.items():
        yield f"drives.{label}", parse(text, names)
    for port, texts in scene.inputs.items():
        yield from ((f"inputs.{port}[{k}]", parse(text, names)) for k, text in enumerate(texts))
    for name, (rate, _) in scene.states.items():
        yield f"states.{name}.rate", parse(rate, names)
    yield from _of_effects(model, model.mechanism.values(chosen))


def _of_effects(model: Model, values: Mapping[str, sympy.Expr]) -> Iterator[tuple[str, sympy.Expr]]:
    """What effects say of the time in their own texts, with the derivatives that they take, at the parameters' values:
    a base's motion, a wrench."""
    known = [model.programs[name] for name in ("forward_dynamics", "effect_power") if name in model.programs]
    if any(port.name == "t" for program in known for port in program.inputs):
        numbers = {p.symbol: values[name] for name, p in model.mechanism.parameters.items()}
        for what, expression in Acting(model.system, model.effects).functions_of_time:
            yield what, expression.xreplace(numbers)


def _parts_in_time(expression: sympy.Expr) -> Iterator[sympy.Expr]:
    """Largest parts that depend on time alone, and functions of time and motion together."""
    if _TIME not in expression.free_symbols:
        return
    if expression.free_symbols == {_TIME}:
        yield expression
    elif expression.is_Add or expression.is_Mul:
        alone = expression.func(*[arg for arg in expression.args if arg.free_symbols <= {_TIME}])
        yield from _parts_in_time(alone)
        for arg in expression.args:
            if not arg.free_symbols <= {_TIME}:
                yield from _parts_in_time(arg)
    elif expression.is_Pow and expression.exp.is_Integer and expression.exp.is_positive:
        yield from _parts_in_time(expression.base)
    else:
        yield expression


def _intervals(
    functions: list[sympy.Expr], duration: float
) -> tuple[list[float], Mapping[float, float], Mapping[int, str]]:
    """Edges, breaks (time behind -> time before), and the functions that are not bounded, with the reason."""
    reasons: dict[int, str] = {}
    sizes = []
    ends = np.linspace(0.0, duration, SAMPLES + 1)
    with np.errstate(all="ignore"):
        for k, function in enumerate(functions):
            try:
                first = series(function, ends[:-1], ends[1:])[0]
            except (ValueError, TypeError, OverflowError):
                reasons[k] = "is a function of time that cannot be bounded"
                first = (np.zeros(1), np.zeros(1))
            finite = np.abs(np.concatenate(first))
            sizes.append(float(finite[np.isfinite(finite)].max(initial=0.0)))
        left, right = np.zeros(1), np.full(1, duration)
        edges: list[float] = []
        open_ends: list[tuple[float, float]] = []
        while len(left):
            bad = np.zeros(len(left), dtype=bool)
            for k, function in enumerate(functions):
                if k not in reasons:
                    wide = ~_resolved(function, sizes[k], left, right)
                    bad |= wide
                    if wide.sum() + len(edges) > MOST:
                        reasons[k] = f"changes too fast to be resolved in {duration:g} s"
                        return [], {}, reasons
            edges += right[~bad].tolist()
            middle = 0.5 * (left + right)
            whole = bad & (right - left <= 4 * np.spacing(np.maximum(right, 1e-6 * duration)))
            open_ends += list(zip(left[whole].tolist(), right[whole].tolist(), strict=True))
            split = bad & ~whole
            left, right, middle = left[split], right[split], middle[split]
            left, right = np.concatenate([left, middle]), np.concatenate([middle, right])
    breaks: dict[float, float] = {}
    for low, high in sorted(open_ends):
        joined = breaks.pop(low, low)
        breaks[min(high, duration)] = joined
    return [t for t in sorted(edges) if t < duration], {t: max(v, 5e-324) for t, v in breaks.items()}, reasons


def _resolved(function: sympy.Expr, size: float, left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Where the function is a polynomial to `RESOLVED` of its size: the remainder of its Taylor series says so."""
    low, high = series(function, left, right)[ORDER]
    return np.asarray(np.maximum(np.abs(low), np.abs(high)) * (right - left) ** ORDER <= RESOLVED * size)
