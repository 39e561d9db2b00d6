"""The gallery: a picture of every mechanism of the catalogue and of every example, drawn from them.

`PYTHONPATH=.:tests python -m support.gallery` writes docs/gallery.md and its pictures; `... gallery NAME` those named.
Examples with a motion are drawn where it ends, paler where it was before; a test compares page and files.
"""

from __future__ import annotations

import hashlib
import io
import re
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import catalogue
from symscrew.description import Mechanism, read_tables, to_toml
from symscrew.display.drawing import drawn_in, mechanism_figure
from symscrew.display.film import poses_over
from symscrew.display.plots import curve_style
from symscrew.model import Model, derive

ROOT = Path(__file__).parents[2]
DOCS, EXAMPLES = ROOT / "docs", ROOT / "examples"
FOLDERS = {"scenes": "Scenes", "benchmarks": "Benchmark problems", "effects": "Effects", "motions": "Given motions",
           "optimisation": "Optimal motions"}  # fmt: skip
LONGEST = 60.0  # seconds for an optimal motion; one that takes longer is drawn at rest
SEEN = 7  # configurations of a motion in one picture
DPI, COLOURS = 90, 112  # pixels per inch, and colours of a picture: some ten kilobytes each


def examples() -> dict[str, Path]:
    """Name of the picture -> file of the example."""
    return {f"{folder}_{file.stem}": file for folder in FOLDERS for file in sorted((EXAMPLES / folder).glob("*.toml"))}


def mechanism_of(file: Path) -> Mechanism:
    """The mechanism that an example is about."""
    tables = read_tables(file.read_text(encoding="utf-8"))
    head = tables.get("scene") or tables.get("problem") or {}
    if "scene" in head:
        return mechanism_of(file.parent / head["scene"])
    name = head.get("mechanism", "three_ups_upu_s")
    return catalogue.find(name if name in catalogue.names() else file.parent / name)


def title(file: Path) -> str:
    """The first sentence of an example's comment."""
    lines = []
    for line in file.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    text = " ".join(lines)
    return re.split(r"(?<=[^0-9.]{3})[.:;](?: |$)", text)[0].strip() or file.stem


def source(name: str) -> str:
    """What a picture is made of: a hash of it stands in the picture."""
    if name in catalogue.names():
        return to_toml(catalogue.load(name))
    file = examples()[name]
    return file.read_text(encoding="utf-8") + to_toml(mechanism_of(file))


def mark_of(name: str) -> str:
    """The hash of a picture's source."""
    return hashlib.sha256(source(name).encode()).hexdigest()[:16]


def moved(file: Path) -> tuple[Model, np.ndarray] | None:
    """The model of an example and configurations of its motion (n, nq); None where there is none to be had soon."""
    from symscrew.display import read_mechanism_and_motion
    from symscrew.optimisation import load_problem, solve, write_plan
    from symscrew.scene import load_scene
    from symscrew.simulation import simulate
    from symscrew.studies.given_motion import drives

    if file.parent.name == "motions":
        found = drives(mechanism_of(file), file)
        return found.model, found.q
    if file.parent.name != "optimisation":
        run = simulate(load_scene(file))
        return run.model, run.q
    problem = load_problem(file)
    timed = problem.solver.name == "ipopt"
    plan = solve(replace(problem, solver=replace(problem.solver, time_limit=LONGEST)) if timed else problem)
    if not plan.ok:
        return None
    with tempfile.TemporaryDirectory() as folder:
        _, motion = read_mechanism_and_motion(str(write_plan(plan, Path(folder) / "plan.npz")))
    assert motion is not None
    return derive(motion.mechanism), motion.q


def draw(name: str) -> Any:
    """The figure of a mechanism or an example."""
    if name in catalogue.names():
        return mechanism_figure(catalogue.load(name))
    file = examples()[name]
    found = moved(file)
    if found is None:
        return mechanism_figure(mechanism_of(file))
    model, q = found
    poses = poses_over(model, q[np.linspace(0, len(q) - 1, SEEN).astype(int)])
    return drawn_in(model.mechanism, poses[-1], behind=poses[:-1], labels=False)


def write(name: str) -> Path:
    """The picture of a mechanism or an example."""
    from PIL import Image, PngImagePlugin

    content, told = io.BytesIO(), PngImagePlugin.PngInfo()
    with curve_style():
        draw(name).savefig(content, format="png", dpi=DPI, bbox_inches="tight", pad_inches=0.04)
    told.add_text("source", mark_of(name))
    path = DOCS / "gallery" / f"{name}.png"
    path.parent.mkdir(exist_ok=True)
    Image.open(content).convert("RGB").quantize(COLOURS).save(path, pnginfo=told, optimize=True)
    return path


def page() -> str:
    """The gallery's text."""
    lines = [
        "# Gallery",
        "",
        "Every mechanism of the catalogue and every example, drawn from its own file. `symscrew draw NAME --out",
        "seed.pdf` draws a mechanism so, `symscrew view NAME` shows it in 3-D with its screws, `symscrew view RUN.npz",
        "--gif run.gif` films a motion. A motion is drawn where it ends, paler where it was before.",
        "",
        "## The catalogue",
        "",
        "`symscrew list` names them; `symscrew new NAME --from delta` copies one to start from.",
        "",
    ]
    for name in catalogue.names():
        lines += [f"### `{name}`", "", catalogue.load(name).description + ".", "", f"![{name}](gallery/{name}.png)", ""]
    for folder, heading in FOLDERS.items():
        lines += [f"## {heading}", ""]
        for name, file in examples().items():
            if file.parent.name == folder:
                place = file.relative_to(ROOT)
                lines += [f"### `{place}`", "", title(file) + ".", "", f"![{file.stem}](gallery/{name}.png)", ""]
    return "\n".join(lines)


if __name__ == "__main__":
    for wanted in sys.argv[1:] or (*catalogue.names(), *examples()):
        print(write(wanted), flush=True)
    (DOCS / "gallery.md").write_text(page(), encoding="utf-8")
