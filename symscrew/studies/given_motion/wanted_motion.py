"""Motions that are asked for: coordinates or poses over time, or the platform's twist, with their derivatives.

.toml, expressions --parse, differentiate--> program of t --> values, first and second derivatives
.csv, .npz, samples --polynomial through neighbours--> the same, with an estimate of its error

    [motion]
    duration = 10                      # [s]
    rate = 100                         # samples per second
    [coordinates]                      # joints by label; the platform's x y z, rx ry rz, qx qy qz, tilt ... yaw; points
    platform.z = "0.1*sin(2*t)"
    [twist]                            # in place of [coordinates]: wx wy wz [rad/s], vx vy vz [m/s] at O
    wx = "-0.1*sin(t)"
    [loads.tool]                       # further wrenches at points, absolute axes: fx fy fz [N], mx my mz [N m]
    fz = "-50"
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
import sympy

from symscrew.algebra import Tape, expression_node
from symscrew.array_archives import read_archive
from symscrew.description import Mechanism, check_sections, from_file, parse, read_tables, read_text
from symscrew.errors import DescriptionError, did_you_mean, expect, in_file, shorten
from symscrew.functions import TWIST_LABELS, WRENCH_LABELS
from symscrew.program import Function, Port, Program, evaluate, lower

Array = np.ndarray
SECTIONS = ("motion", "coordinates", "twist", "loads")
KEYS = {"motion": ("duration", "rate", "description")}
ENDINGS = (".toml", ".csv", ".npz")
MOST_SAMPLES = 1_000_000  # of a motion: 16 coordinates of so many, with rates and reactions, are a gigabyte
DEFAULT_RATE = 100.0  # samples per second, where nothing is said: what a plot of seconds needs
OF_RUNS = (
    "v", "a", "u", "x", "energy", "closure_error", "energy_balance", "joint", "rate", "power", "reactions", "margins"
)  # fmt: skip
"""What names of columns of runs begin with, which are no coordinates."""
LOOKS = 16  # times at which expressions are looked at between two samples
NEIGHBOURS = 7  # samples of the polynomial that derivatives are taken of: order 6; more samples amplify their rounding
FEWER = 5  # of the polynomial whose derivatives say how far to trust the former
_TIME = sympy.Symbol("t", real=True)


@dataclass(frozen=True, repr=False)
class WantedMotion:
    """Values, first and second derivatives (n, names) of `names` at times t (n,) [s].

    `twist`: names are components of the platform's twist, whose values are not used; `program` gives rates and their
    derivatives at any time then. `loads`: point -> (n, 6) force [N] and moment [N m]. `uncertain`: estimated relative
    error of the second derivatives, 0 where they are exact. `unseen`: the part of what expressions, their rates or
    accelerations reach between the samples that is not reached at a sample, 0 where the samples have it all.
    """

    names: tuple[str, ...]
    t: Array
    values: Array
    rates: Array
    accelerations: Array
    twist: bool = False
    program: Program | None = None
    loads: Mapping[str, Array] = field(default_factory=dict)
    uncertain: float = 0.0
    unseen: float = 0.0

    def __repr__(self) -> str:
        what = "twist" if self.twist else "values"
        return f"WantedMotion({what} of {', '.join(self.names)}: {len(self.t)} samples to {self.t[-1]:g} s)"


def load_motion(path: str | Path, mechanism: Mechanism) -> WantedMotion:
    """The motion in a file: .toml with expressions, .csv or .npz with samples.

    A .csv has names in its first line, `t` [s] among them; an .npz an array `t` and one of the same length per name.
    Of what `simulate` and `drives` wrote, the coordinates are the motion.

    Raises:
        DescriptionError: the file cannot be read; says where and what is wrong in it, and the cure.
    """
    file = Path(path)
    if file.suffix not in ENDINGS:
        raise DescriptionError(
            f"--motion: expected a file name that ends in {', '.join(ENDINGS)}, or NAME=EXPRESSION, "
            f"got {shorten(str(path))}"
        )
    if file.suffix == ".toml":
        return from_file(file, lambda text, **_: _of_tables(read_tables(text), mechanism))
    try:
        columns = _csv(read_text(file)) if file.suffix == ".csv" else _columns_of_archive(file)
        return _sampled(_asked_of_run(columns, mechanism))
    except DescriptionError as error:
        raise in_file(file.name, error) from error


def motion_of(
    texts: Mapping[str, str], mechanism: Mechanism, *, duration: float, rate: float = DEFAULT_RATE
) -> WantedMotion:
    """A motion of expressions in t [s] and the parameters, sampled `rate` times a second for `duration` [s].

    Names are coordinates, or components of the platform's twist (`wx` ... `vz`), not both.

    Raises:
        DescriptionError: an expression that cannot be read, evaluated or differentiated twice; no duration.
    """
    for text in texts.values():
        expect(text, str)
    for number in (duration, rate):
        expect(number, Real)
    return _expressed(texts, mechanism, _times(duration, rate), {})


def _of_tables(tables: Mapping[str, Any], mechanism: Mechanism) -> WantedMotion:
    check_sections(tables, SECTIONS, KEYS, ())
    head = tables.get("motion", {})
    if "duration" not in head:
        raise DescriptionError("motion.duration is missing; expected the seconds that the motion takes")
    given = [name for name in ("coordinates", "twist") if tables.get(name)]
    if len(given) != 1:
        raise DescriptionError("expected either [coordinates] or [twist] with at least one expression")
    numbers = [_number(head[k], f"motion.{k}") if k in head else DEFAULT_RATE for k in ("duration", "rate")]
    texts = _flat(tables[given[0]], given[0])
    if given[0] == "twist":
        for name in texts:
            if name not in TWIST_LABELS:
                raise DescriptionError(f"twist: no component {name!r}; {did_you_mean(name, TWIST_LABELS)}")
    loads = {}
    for point, table in tables.get("loads", {}).items():
        loads[point] = _flat(table, f"loads.{point}")
        for name in loads[point]:
            if name not in WRENCH_LABELS:
                raise DescriptionError(f"loads.{point}: no component {name!r}; {did_you_mean(name, WRENCH_LABELS)}")
    return _expressed(texts, mechanism, _times(*numbers), loads)


def _number(value: object, where: str) -> float:
    found = math.nan
    if isinstance(value, (int, float, Decimal)) and not isinstance(value, bool):
        with contextlib.suppress(OverflowError):
            found = float(value)
    if not 0 < found < math.inf:
        raise DescriptionError(f"{where}: expected a number above 0, got {shorten(value)}")
    return found


def _times(duration: float, rate: float) -> Array:
    if not 0 < duration < float("inf") or not 0 < rate < float("inf"):
        raise DescriptionError(f"expected a duration [s] and a rate [1/s] above 0, got {duration:g} and {rate:g}")
    if duration * rate > MOST_SAMPLES:
        raise DescriptionError(f"{duration * rate:.3g} samples; at most {MOST_SAMPLES} are computed: lower the rate")
    return np.linspace(0.0, duration, max(1, round(duration * rate)) + 1)


def _flat(table: object, where: str) -> dict[str, str]:
    """Names with dots, which TOML reads as tables in tables, and their expressions."""
    if not isinstance(table, dict):
        raise DescriptionError(f"{where}: expected a table of expressions, got {shorten(table)}")
    found: dict[str, str] = {}
    for name, value in table.items():
        if isinstance(value, dict) and value:
            found |= {f"{name}.{inner}": text for inner, text in _flat(value, f"{where}.{name}").items()}
        elif isinstance(value, (str, int, float, Decimal)) and not isinstance(value, bool):
            found[name] = str(value)
        else:
            raise DescriptionError(f"{where}.{name}: expected an expression, got {shorten(value)}")
    return found


def _expressed(
    texts: Mapping[str, str], mechanism: Mechanism, t: Array, loads: Mapping[str, Mapping[str, str]]
) -> WantedMotion:
    twist = set(texts) <= set(TWIST_LABELS)
    program = _program(texts, mechanism)
    values, rates, accelerations = _evaluated(program, t, texts)
    between = _between(t)
    others = _evaluated(program, between, texts)
    # values of a twist's components are velocities, their rates accelerations: second derivatives act on nothing
    parts = list(zip((values, rates, accelerations), others, strict=True))[: 2 if twist else 3]
    found = {}
    for point, components in loads.items():
        wrench = np.zeros((len(t), len(WRENCH_LABELS)))
        of_loads = _program(components, mechanism)
        read = _evaluated(of_loads, t, components)[0]
        parts.append((read, _evaluated(of_loads, between, components)[0]))
        wrench[:, [WRENCH_LABELS.index(name) for name in components]] = read
        found[point] = wrench
    return WantedMotion(
        tuple(texts), t, values, rates, accelerations, twist=twist, program=program if twist else None, loads=found,
        unseen=max(_unseen(*part) for part in parts),
    )  # fmt: skip


def _between(t: Array) -> Array:
    """Times between samples, random ones: what repeats with the samples does not repeat with them."""
    count = int(np.clip(MOST_SAMPLES // len(t), 1, LOOKS))
    parts = (np.arange(count) + np.random.default_rng(1).uniform(size=(len(t) - 1, count))) / count
    times: Array = (t[:-1, None] + np.diff(t)[:, None] * parts).ravel()
    return times


def _unseen(sampled: Array, between: Array) -> float:
    """The part of the largest entry between samples that is beyond the largest at a sample, of the worst column."""
    seen, there = (np.abs(part).max(axis=0, initial=0.0) for part in (sampled, between))
    return float((np.where(there > seen, there - seen, 0.0) / np.where(there > 0, there, 1.0)).max(initial=0.0))


def _program(texts: Mapping[str, str], mechanism: Mechanism) -> Program:
    """t -> values, first and second derivatives of expressions."""
    names = {**{p.name: p.value for p in mechanism.parameters.values()}, "t": _TIME}
    tape = Tape()
    time = tape.symbol("t", "s", "time of the motion")
    rows: list[list[Any]] = [[], [], []]
    for name, text in texts.items():
        expression = parse(text, names, where=name)
        for row in rows:
            try:
                row.append(tape.node(expression_node(tape, expression, {_TIME: time})))
            except ValueError as error:
                raise DescriptionError(
                    f"{name}: expected an expression that has two derivatives: {shorten(str(error), 120)}"
                ) from error
            expression = sympy.diff(expression, _TIME)
    labels = tuple(texts)
    ports = tuple(Port(n, (len(labels),), ("1",) * len(labels), labels, n) for n in ("value", "rate", "acceleration"))
    given = Port("t", (1,), ("s",), ("t",), "time")
    made = lower(Function("motion", "A motion.", (given,), ports, ((time,),), tuple(map(tuple, rows))))
    assert isinstance(made, Program)
    return made


def _evaluated(program: Program, t: Array, names: Sequence[str] | Mapping[str, str]) -> tuple[Array, Array, Array]:
    (values, rates, accelerations), _ = evaluate(program, (np.asarray(t)[:, None],))
    for part in (values, rates, accelerations):
        if not np.isfinite(part).all():
            k, column = np.argwhere(~np.isfinite(part))[0]
            raise DescriptionError(f"{list(names)[column]}: not finite, or without derivatives, at t = {t[k]:g} s")
    return values, rates, accelerations


# -- samples ----------------------------------------------------------------------------------------------


def _csv(text: str) -> dict[str, Array]:
    text = text.removeprefix("\ufeff")  # a mark of the order of bytes, with which spreadsheets begin a file
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    names = [name.strip() for name in lines[0].split(",")] if lines else []
    if len(lines) - 1 > MOST_SAMPLES:
        raise DescriptionError(f"{len(lines) - 1} samples; at most {MOST_SAMPLES} are computed")
    rows = []
    for k, line in enumerate(lines[1:], 2):
        cells = line.split(",")
        if len(cells) != len(names):
            raise DescriptionError(f"row {k}: expected {len(names)} numbers, got {len(cells)}")
        try:
            rows.append([float(cell) for cell in cells])
        except ValueError as error:
            raise DescriptionError(f"row {k}: expected numbers, got {shorten(line)}") from error
    return dict(zip(names, np.array(rows).T, strict=True)) if rows else {}


def _columns_of_archive(file: Path) -> dict[str, Array]:
    found = read_archive(file)
    n = len(found["t"]) if "t" in found and found["t"].ndim == 1 else -1
    if "q_labels" in found and "q" in found and found["q"].shape == (n, found["q_labels"].size):  # of a run
        labels = found["q_labels"].ravel().tolist()
        return {"t": found["t"].astype(float)} | {f"q.{x}": found["q"][:, k] for k, x in enumerate(labels)}
    return {name: a.astype(float) for name, a in found.items() if a.ndim == 1 and len(a) == n and a.dtype.kind in "fiu"}


def _asked_of_run(columns: Mapping[str, Array], mechanism: Mechanism) -> dict[str, Array]:
    """The columns that ask for a motion: beside coordinates, `q.LABEL`, those of results of a run do not."""
    own = {*mechanism.joints, *mechanism.bodies, *mechanism.points}
    if not any(name.startswith("q.") for name in columns) or "q" in own:
        return dict(columns)
    return {name: column for name, column in columns.items()
            if (begin := name.partition(".")[0]) not in OF_RUNS or begin in own}  # fmt: skip


def _sampled(columns: Mapping[str, Array]) -> WantedMotion:
    names = tuple(name for name in columns if name != "t")
    if "t" not in columns or not names:
        raise DescriptionError("expected a column t [s] and a column per coordinate, named in the first line")
    twist = [name for name in names if name in TWIST_LABELS]
    if twist:
        raise DescriptionError(f"{', '.join(twist)}: a twist is given by expressions of t, in a .toml file")
    t, values = columns["t"], np.stack([columns[name] for name in names], axis=1)
    if not np.isfinite(t).all() or not np.isfinite(values).all():
        raise DescriptionError("expected finite numbers, got some that are not")
    if len(t) < NEIGHBOURS or not (np.diff(t) > 0).all():
        raise DescriptionError(f"expected at least {NEIGHBOURS} samples at increasing times, got {len(t)}")
    if len(t) > MOST_SAMPLES:
        raise DescriptionError(f"{len(t)} samples; at most {MOST_SAMPLES} are computed")
    rates, accelerations = derivatives(t, values, NEIGHBOURS)
    _, coarse = derivatives(t, values, FEWER)
    largest = float(np.abs(accelerations).max())
    uncertain = float(np.abs(accelerations - coarse).max()) / largest if largest else 0.0
    return WantedMotion(names, t - t[0], values, rates, accelerations, uncertain=uncertain)


def derivatives(t: Array, values: Array, count: int) -> tuple[Array, Array]:
    """First and second derivatives (n, m) of samples, of the polynomial through the `count` samples nearest in order.

    Weights by Fornberg, Math. Comp. 51 (1988) 699, for samples at any distances.
    """
    n = len(t)
    first = np.clip(np.arange(n) - count // 2, 0, n - count)
    around = first[:, None] + np.arange(count)
    weights = _weights(t[around], t)
    first_rates, second_rates = (np.einsum("nk,nkm->nm", w, values[around]) for w in weights)
    return first_rates, second_rates


def _weights(nodes: Array, at: Array) -> tuple[Array, Array]:
    """Weights (n, count) of samples at `nodes` (n, count) for the first and second derivative at `at` (n,)."""
    n, count = nodes.shape
    w = np.zeros((3, n, count))
    w[0, :, 0] = 1.0
    product, here = np.ones(n), nodes[:, 0] - at
    for i in range(1, count):
        before, here = here, nodes[:, i] - at
        step = np.ones(n)
        for j in range(i):
            gap = nodes[:, i] - nodes[:, j]
            step = step * gap
            if j == i - 1:
                for order in (2, 1, 0):
                    lower_order = order * w[order - 1, :, i - 1] if order else 0.0
                    w[order, :, i] = product / step * (lower_order - before * w[order, :, i - 1])
            for order in (2, 1, 0):
                lower_order = order * w[order - 1, :, j] if order else 0.0
                w[order, :, j] = (here * w[order, :, j] - lower_order) / gap
        product = step
    return w[1], w[2]
