"""How operations and times grow with the number of limbs and of serial joints, with fitted exponents."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from symscrew.compiled import compile_c
from symscrew.export.c import print_c
from symscrew.mechanism import Mechanism
from symscrew.model import Model, derive
from symscrew.timing import interleaved

from .mechanisms import chain, platform
from .tables import exponent, table

LIMBS = (2, 3, 4, 6, 8, 12, 16)
JOINTS = (2, 4, 6, 8, 12, 16, 20, 25, 30)
FUNCTIONS = ("inverse_dynamics", "joint_reactions", "body_poses", "body_twists", "body_twist_rates", "mass_matrix")
STAGES = ("derive", "print", "compile")


def operations(model: Model) -> dict[str, int]:
    """Operations of the functions whose growth is shown."""
    return {name: model.programs[name].operations["total"] for name in FUNCTIONS}


def run(*, repeats: int = 3) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    texts, raw = [], {}
    series: dict[str, tuple[str, Callable[[int], Mechanism], tuple[int, ...]]] = {
        "platforms on S with n UPS limbs": ("limbs", platform, LIMBS),
        "serial chains of n revolute joints": ("joints", chain, JOINTS),
    }
    for title, (unit, make, sizes) in series.items():
        found = _series(make, sizes, repeats)
        columns = (*FUNCTIONS, *(f"{stage} s" for stage in STAGES))
        rows: list[list[object]] = [
            [n, *(f"{found[c][i]:.3g}" if c.endswith(" s") else found[c][i] for c in columns)]
            for i, n in enumerate(sizes)
        ]
        exponents = {c: exponent(sizes, found[c]) for c in columns}
        rows.append(["exponent", *(f"{exponents[c]:.2f}" for c in columns)])
        texts.append(f"{title} (exponents over the larger half)\n\n" + table([unit, *columns], rows))
        raw[title] = {"sizes": sizes, "values": found, "exponents": exponents}
    return "\n\n".join(texts), raw


def _series(make: Callable[[int], Mechanism], sizes: tuple[int, ...], repeats: int) -> dict[str, list[float]]:
    """Operations, and least seconds per stage, for every size. Compilation is measured once."""
    mechanisms = {n: make(n) for n in sizes}
    models: dict[int, Model] = {}

    def deriving(n: int) -> Callable[[], float]:
        def measure() -> float:
            start = time.perf_counter()
            models[n] = derive(mechanisms[n])
            return time.perf_counter() - start

        return measure

    derived = interleaved({str(n): deriving(n) for n in sizes}, repeats)
    found: dict[str, list[float]] = {name: [operations(models[n])[name] for n in sizes] for name in FUNCTIONS}
    found["derive s"] = [derived[str(n)].least for n in sizes]
    found["print s"], found["compile s"] = [], []
    with tempfile.TemporaryDirectory(prefix="benchmark_") as folder:
        for n in sizes:
            start = time.perf_counter()
            files = print_c(models[n])
            found["print s"].append(time.perf_counter() - start)
            for file, text in files.items():
                (Path(folder) / file).write_text(text)
            start = time.perf_counter()
            source = Path(folder) / f"{models[n].name}.c"
            compile_c(source, source.with_suffix(".so"))
            found["compile s"].append(time.perf_counter() - start)
    return found
