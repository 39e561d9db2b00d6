"""What every benchmark shares: interleaved repeats, quartiles, the machine, Markdown tables."""

from __future__ import annotations

import platform
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib import metadata
from pathlib import Path

import numpy as np

C_FLAGS = ("-O2", "-fno-math-errno", "-march=native")
CPP_FLAGS = ("-O3", "-march=native", "-DNDEBUG")
PACKAGES = ("symscrew", "sympy", "casadi", "numpy", "pin")


@dataclass(frozen=True)
class Times:
    """Least, quartiles and median of repeated measurements, in the unit of the measurement."""

    least: float
    lower: float
    median: float
    upper: float
    repeats: int

    @property
    def text(self) -> str:
        """The median with the quartiles."""
        return f"{self.median:.3g} ({self.lower:.3g} ... {self.upper:.3g})"

    def as_json(self) -> dict[str, float]:
        """Plain numbers."""
        return asdict(self)


def interleaved(measures: Mapping[str, Callable[[], float]], repeats: int) -> dict[str, Times]:
    """A B C A B C ...: one value of each measure per round, so that a disturbance meets all of them."""
    values: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(repeats):
        for name, measure in measures.items():
            values[name].append(measure())
    return {name: quartiles(found) for name, found in values.items()}


def quartiles(values: Sequence[float]) -> Times:
    """Summary of measurements."""
    least, lower, median, upper = np.percentile(values, [0, 25, 50, 75])
    return Times(float(least), float(lower), float(median), float(upper), len(values))


def machine() -> dict[str, str]:
    """Processor, compilers, flags and versions: all that the times depend on, as far as it can be asked."""
    facts = {"processor": _processor(), "system": f"{platform.system()} {platform.machine()}"}
    for compiler in ("gcc", "g++"):
        try:
            answer = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True)
            facts[compiler] = answer.stdout.splitlines()[0]
        except (OSError, subprocess.CalledProcessError):
            facts[compiler] = "none"
    facts["C flags"], facts["C++ flags"] = " ".join(C_FLAGS), " ".join(CPP_FLAGS)
    facts["python"] = platform.python_version()
    for package in PACKAGES:
        try:
            facts[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            facts[package] = "not installed"
    return facts


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.is_file() else []
    fields = {key.strip(): value.strip() for key, _, value in (line.partition(":") for line in lines)}
    model = fields.get("model name") or platform.processor() or "unknown"
    if "cpu family" in fields:
        model += f", family {fields['cpu family']} model {fields['model']}, {fields.get('cpu MHz', '?')} MHz"
    return f"{model}, {sum(line.startswith('processor') for line in lines)} cores"


def table(header: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A Markdown table."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def exponent(sizes: Sequence[float], values: Sequence[float]) -> float:
    """Slope of log value over log size, over the larger half of the sizes."""
    start = min(len(sizes) // 2, len(sizes) - 2)
    return float(np.polyfit(np.log(sizes[start:]), np.log(values[start:]), 1)[0])
