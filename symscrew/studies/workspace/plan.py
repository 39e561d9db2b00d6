"""What a sweep is about: axes of coordinates and parameters, tolerances, limits; and its cases, by number."""

from __future__ import annotations

import hashlib
import json
import math
from dataclasses import asdict, dataclass, field, fields, replace

import numpy as np

from symscrew.description import Mechanism, given_value, numeric, to_toml
from symscrew.effects import Effect, type_name
from symscrew.errors import DescriptionError, did_you_mean, shorten

TILT, AZIMUTH = "tilt", "azimuth"
MOST_CASES = 50_000_000  # of a sweep: 0.4 GB for every result, of which there are dozens; more is refused

MOST_SAMPLES = 1_000_000  # per place; more is a slip of the finger, and MOST_CASES would refuse it later with less help
MOST_SEED = 2**64 - 1  # what NumPy takes in one word


@dataclass(frozen=True)
class Axis:
    """A coordinate or parameter with its values, evenly from `low` to `high` [rad, m, or the parameter's unit].

    `unit` is that in SI, "m" or "rad", of the unit that was typed, and empty for plain numbers.
    """

    name: str
    low: float
    high: float
    count: int
    unit: str = ""

    @property
    def values(self) -> np.ndarray:
        """The values in order."""
        return np.linspace(self.low, self.high, self.count)


@dataclass(frozen=True)
class Plan:
    """A sweep: every combination of the axes' values, each `samples` times where parameters have tolerances.

    `tolerances`: parameter -> standard deviation of a normal distribution about its value, samples drawn with `seed`
    by the number of the case. `limits`: result -> (least, largest). `stiffness` is that of a drive: [N/m] of one that
    slides, and times the square of the characteristic length [N m/rad] of one that turns. `steps`: of the walk from
    the reference configuration. `chunk`: cases per piece of work. `typed`: (option, result or parameter, SI unit) of
    limits and tolerances that were typed with a unit; `check_plan` holds them to those of the mechanism. `mode`: name
    of the assembly mode in which the walk begins; that of the reference where empty. `engine`: what evaluates the
    functions, a name of `engines.ENGINES`; "": the fastest that is there. It does not change the hash.
    """

    mechanism: Mechanism
    effects: tuple[Effect, ...]
    axes: tuple[Axis, ...]
    independent: tuple[str, ...] | None = None
    tolerances: tuple[tuple[str, float], ...] = ()
    samples: int = 1
    seed: int = 0
    limits: tuple[tuple[str, float, float], ...] = ()
    stiffness: float = 1e6
    steps: int = 16
    chunk: int = 1024
    parameters: tuple[str, ...] = field(default=())
    typed: tuple[tuple[str, str, str], ...] = ()
    mode: str = ""
    engine: str = ""

    def __repr__(self) -> str:
        over = ", ".join(axis.name for axis in self.axes) or "samples alone"
        return f"Plan({self.mechanism.name}: {self.count} cases over {over})"

    @property
    def count(self) -> int:
        """Number of cases."""
        return math.prod(axis.count for axis in self.axes) * self.samples

    @property
    def chunks(self) -> int:
        """Number of pieces of work."""
        return -(-self.count // self.chunk)

    @property
    def hash(self) -> str:
        """SHA-256 of all that determines the results, 16 hex digits."""
        effects = [(type_name(e), {field.name: getattr(e, field.name) for field in fields(e)}) for e in self.effects]
        rest = asdict(replace(self, mechanism=None, effects=(), typed=()))  # type: ignore[arg-type]
        rest = {key: value for key, value in rest.items() if key != "mode" or value}  # sweeps without one stay theirs
        del rest["engine"]
        text = json.dumps([to_toml(self.mechanism), effects, rest], sort_keys=True, default=repr)
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def cases(self, chunk: int) -> np.ndarray:
        """Values of the axes (cases, axes) of a piece."""
        return self.values_of(np.arange(chunk * self.chunk, min((chunk + 1) * self.chunk, self.count)))

    def values_of(self, numbers: np.ndarray) -> np.ndarray:
        """Values of the axes (cases, axes) of cases by number; the last axis runs fastest, samples faster still."""
        shape = tuple(axis.count for axis in self.axes)
        places = np.unravel_index(numbers // self.samples, shape) if shape else ()
        columns = [axis.values[place] for axis, place in zip(self.axes, places, strict=True)]
        return np.stack(columns, axis=1) if columns else np.zeros((len(numbers), 0))

    def deviations(self, chunk: int) -> np.ndarray:
        """Deviations of the parameters with tolerances (cases, tolerances) of a piece.

        Every piece has a random stream of its own, by its number, so that it does not matter who computes it when.
        """
        count = len(self.cases(chunk))
        stream = np.random.Generator(np.random.PCG64(np.random.SeedSequence([self.seed, chunk])))
        return stream.standard_normal((count, len(self.tolerances))) * [sigma for _, sigma in self.tolerances]

    def deviations_of(self, numbers: np.ndarray) -> np.ndarray:
        """The same of cases by number."""
        found = np.zeros((len(numbers), len(self.tolerances)))
        pieces = numbers // self.chunk
        for chunk in np.unique(pieces) if self.tolerances else ():
            found[pieces == chunk] = self.deviations(int(chunk))[numbers[pieces == chunk] % self.chunk]
        return found


def check_numbers(plan: Plan, processes: int | None = None, *, certify: bool = False) -> None:
    """Before anything is derived: whether samples, cases, seed, deviations and processes can be.

    `certify`: of boxes, which are not counted beforehand.

    Raises:
        DescriptionError: names what cannot be as the option of the command line.
    """
    known = plan.mechanism.parameters
    for name, sigma in plan.tolerances:
        if name not in known:
            raise DescriptionError(f"--tolerance: no parameter {shorten(name)}; {did_you_mean(name, known)}")
        if not sigma > 0:
            raise DescriptionError(f"--tolerance: expected a standard deviation of {name} above 0, got {sigma:g}")
    for option, value, least, most in (("samples", plan.samples, 1, MOST_SAMPLES), ("seed", plan.seed, 0, MOST_SEED)):
        if not least <= value <= most:
            raise DescriptionError(f"--{option}: expected a number from {least} to {most}, got {shorten(value)}")
    if not 0 < plan.stiffness < math.inf:
        raise DescriptionError(f"--stiffness: expected a number above 0 [N/m], got {plan.stiffness:g}")
    if processes is not None and processes < 1:
        raise DescriptionError(f"--processes: expected a number above 0, got {shorten(processes)}")
    if not plan.axes and not plan.tolerances:
        text = "nothing to sweep: give --over COORDINATE=from:to:count, or --tolerance PARAMETER=deviation"
        raise DescriptionError(text)
    if plan.count > MOST_CASES and not certify:
        raise DescriptionError(f"{plan.count} cases; at most {MOST_CASES // 10**6} million are computed in one sweep")


def read_axis(text: str, count: int | None = None) -> Axis:
    """An axis as it is typed: NAME=from:to:count, numbers with a unit if wanted; `count`: if none is typed.

    >>> read_axis("x=-1:1:5").values.tolist()
    [-1.0, -0.5, 0.0, 0.5, 1.0]

    Raises:
        DescriptionError: says what is wrong with it.
    """
    name, equals, rest = text.partition("=")
    parts = rest.split(":")
    if count is not None and len(parts) == 2 and all(part.strip() for part in parts):
        parts.append(str(count))
    if not equals or not name or len(parts) != 3 or not parts[2].strip().isdecimal():
        raise DescriptionError(
            f"--over: expected COORDINATE=from:to:count such as tilt=0:20deg:21, got {shorten(text)}"
        )
    (low, one), (high, other) = (read_quantity(part, "--over") for part in parts[:2])
    if one != other and low and high:  # a zero needs no unit
        raise DescriptionError(f"--over: expected both ends in one unit, such as -20deg:20deg, got {shorten(text)}")
    number = int(parts[2][:9])
    if number < 1 or (number > 1) == (low == high):
        raise DescriptionError(
            f"--over: expected from below to and at least 2 values, or one value, in {shorten(text)}"
        )
    return Axis(name.strip(), low, high, number, other if high else one)


def read_quantity(text: str, where: str) -> tuple[float, str]:
    """A number as `read_number` takes it, and the SI unit it is in, nothing without a unit."""
    try:
        found = given_value(text, where=where)
        value = float(numeric(found.value, where=where))
    except DescriptionError as error:
        raise DescriptionError(
            f"{where}: expected a number, perhaps with a unit such as mm or deg, got {shorten(text)}"
        ) from error
    if not math.isfinite(value):
        raise DescriptionError(f"{where}: expected a finite number, got {shorten(text)}")
    return value, found.unit


def read_limit(text: str) -> tuple[tuple[str, float, float], str]:
    """A limit as it is typed: RESULT=least:largest, one of them may be left out; and the unit that was typed, in SI.

    >>> read_limit("limb1_P=-5mm:")
    (('limb1_P', -0.005, inf), 'm')

    Raises:
        DescriptionError: it is typed otherwise, with two units, or has nothing between its ends.
    """
    name, equals, rest = text.partition("=")
    low, colon, high = rest.partition(":")
    if not equals or not colon or not (low or high):
        raise DescriptionError(
            f"--limit: expected RESULT=least:largest such as limb1_P=-50mm:50mm, got {shorten(text)}"
        )
    least, one = read_quantity(low, "--limit") if low.strip() else (-math.inf, "")
    most, other = read_quantity(high, "--limit") if high.strip() else (math.inf, "")
    if one != other and least and most and math.isfinite(most - least):  # a zero needs no unit
        raise DescriptionError(f"--limit: expected both ends in one unit, such as -5mm:5mm, got {shorten(text)}")
    if least > most:
        raise DescriptionError(f"--limit: expected the least first, nothing is between these, got {shorten(text)}")
    return (name.strip(), least, most), one or other
