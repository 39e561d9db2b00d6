"""Wall time of the whole command `symscrew generate NAME --out DIR`, from a cold start to files on disk."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from symscrew.studies.timing import interleaved

from .tables import table

COMMAND = "import sys; from symscrew.cli.parser import main; sys.exit(main())"  # what the script `symscrew` does
CASES = ("three_ups_upu_s_physical", "stewart_6ups", "panda")
TARGETS = {"C": ["--target", "c"], "C, CasADi, NumPy": ["--target", "c", "casadi", "numpy"]}


def run(*, repeats: int = 5) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:

        def command(name: str, targets: list[str]) -> Callable[[], float]:
            def measure() -> float:
                place = Path(folder) / f"{name}_{len(list(Path(folder).iterdir()))}"
                start = time.perf_counter()
                arguments = ["-c", COMMAND, "generate", name, "--out", str(place), *targets]
                subprocess.run([sys.executable, *arguments], check=True, capture_output=True)
                took = time.perf_counter() - start
                if not (place / f"{name}.h").is_file():
                    raise RuntimeError(f"generate {name} ended without {name}.h")
                return took

            return measure

        measures = {f"{name}: {what}": command(name, t) for name in CASES for what, t in TARGETS.items()}
        times = interleaved(measures, repeats)
    rows = [[*key.split(": "), f"{t.least:.2f}", t.text] for key, t in times.items()]
    text = table(["mechanism", "targets", "least s", "median s (quartiles)"], rows)
    return text, {key: t.as_json() for key, t in times.items()}
