"""A motion as a film or a picture, without a browser: GIF, MP4, PNG.

recorded motion, or a sweep of the coordinates --poses_over--> poses of bodies --drawing--> pictures --> file
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.display.drawing import Pose, Sketch, camera, draw_bodies, draw_joints, usual_view
from symscrew.display.plots import curve_style
from symscrew.display.shape import body_points
from symscrew.display.view import RecordedMotion
from symscrew.errors import DescriptionError
from symscrew.functions import moving_bodies
from symscrew.model import Model
from symscrew.whole_files import replaced

Array = np.ndarray
RATE = 20  # pictures per second: smooth to the eye, and a GIF of ten seconds stays below a few megabytes
MOST = 600  # pictures of a film: half a minute
SWEEP = 4.0  # seconds of a sweep
ANGLE, LENGTH, ENTRY = 0.35, 0.15, 0.17
"""How far a sweep goes: 20 degrees, of the characteristic length, and of a quaternion's entries 20 degrees again."""
TRIES, LESS = 12, 0.7  # a sweep whose loops do not close is tried so often, each time so much smaller
WIDTH, DPI = 6.4, 100  # of a film [in] and its pixels per inch
EVEN = 2  # sides of a picture are multiples of it, as encoders of films ask for


def sweep(model: Model) -> tuple[Array, Array]:
    """Times [s] and configurations (n, nq) of a motion of all independent coordinates from the reference and back.

    Raises:
        DescriptionError: the mechanism does not move.
    """
    system = model.system
    t = np.linspace(0.0, SWEEP, round(SWEEP * RATE) + 1)[:-1]
    labels = [c.label for c in system.tree.q]
    program = model.programs.get("assemble")
    names = list(program.inputs[0].labels) if program is not None else labels
    entries = [labels.index(name) for name in names]
    if not entries:
        raise DescriptionError(f"{model.name} does not move: there is no motion to film")
    reach = np.array([_reach(model, k) for k in entries])
    phases = np.pi * np.arange(len(entries)) / len(entries)
    for k in range(TRIES):
        swing = np.sin(2 * np.pi * t[:, None] / SWEEP + phases) - np.sin(phases)
        y = system.reference[entries] + LESS**k * reach * swing / 2
        q = _closed(model, y, entries)
        if q is not None:
            return t, q
    raise DescriptionError(
        f"{model.name} does not move from its reference configuration: record a motion and show that"
    )


def _reach(model: Model, entry: int) -> float:
    tree = model.system.tree
    if any(link.q.start <= entry < link.q.stop and link.q.stop - link.q.start == 4 for link in tree.links[1:]):
        return ENTRY
    return LENGTH * model.system.length if tree.q[entry].unit == "m" else ANGLE


def _closed(model: Model, y: Array, entries: Sequence[int]) -> Array | None:
    """Configurations (n, nq) at independent coordinates (n, ny); None where the loops do not close."""
    system = model.system
    if "assemble" not in model.programs:
        q = np.repeat(system.reference[None], len(y), 0)
        q[:, list(entries)] = y
        return q
    values = system.parameter_values
    more = [np.repeat(values[None], len(y), 0)] if len(values) else []
    (q,), status = model("assemble", y, np.repeat(system.reference[None], len(y), 0), *more)
    return q if (np.asarray(status) == 0).all() and np.isfinite(q).all() else None


def poses_over(model: Model, q: Array) -> list[dict[str, Pose]]:
    """Poses of all moving bodies in configurations (n, nq), from the reference configuration."""
    values = model.system.parameter_values
    more = [np.repeat(values[None], len(q), 0)] if len(values) else []
    (found,), _ = model("body_poses", q, *more)
    each = np.asarray(found).reshape(len(q), -1, 12)
    names = moving_bodies(model.system)
    return [
        {name: (row[k, :9].reshape(3, 3).T, row[k, 9:]) for k, name in enumerate(names)} for row in each
    ]  # fmt: skip


def frames_of_motion(model: Model, motion: RecordedMotion | None) -> tuple[list[dict[str, Pose]], float]:
    """Poses of the pictures of a film, and pictures per second: of a recorded motion at its own pace, or of a sweep."""
    if motion is None:
        _, q = sweep(model)
        return poses_over(model, q), RATE
    motion.check(model)
    seconds = float(motion.t[-1] - motion.t[0])
    count = int(np.clip(round(RATE * seconds) + 1, 2, MOST))
    wanted = np.linspace(motion.t[0], motion.t[-1], count)
    nearest = np.abs(motion.t[:, None] - wanted[None]).argmin(axis=0)
    return poses_over(model, motion.q[nearest]), (count - 1) / seconds


def pictures(model: Model, frames: Sequence[dict[str, Pose]]) -> Iterator[Array]:
    """The pictures (height, width, 3), bytes, all seen from one place in which all of them fit."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    mechanism = model.mechanism
    points = body_points(mechanism)
    still = Sketch(mechanism, camera(np.zeros((1, 3)), 0, 0), 1.0, {})
    whole = np.concatenate(
        [Sketch(mechanism, still.view, 1.0, poses).moved(body, p) for poses in frames for body, p in points.items()
         if len(p)]
    )  # fmt: skip
    view, size = camera(whole, *usual_view(mechanism)), 0.5 * float(np.ptp(whole, axis=0).max()) or 1.0
    seen = view(whole)
    low, high = seen.min(axis=0) - 0.12 * size, seen.max(axis=0) + 0.12 * size
    tall = float(np.clip((high - low)[1] / (high - low)[0], 0.4, 1.2))
    with curve_style():
        made = Figure(figsize=(WIDTH, EVEN * round(WIDTH * tall * DPI / EVEN) / DPI), dpi=DPI)
        canvas: Any = FigureCanvasAgg(made)
        for poses in frames:
            made.clear()
            axes = made.add_axes((0.0, 0.0, 1.0, 1.0))
            sketch = Sketch(mechanism, view, size, poses)
            draw_bodies(axes, sketch)
            draw_joints(axes, sketch)
            axes.set_xlim(low[0], high[0])
            axes.set_ylim(low[1], high[1])
            axes.set_aspect("equal", adjustable="datalim")
            axes.set_axis_off()
            canvas.draw()
            yield np.asarray(canvas.buffer_rgba())[..., :3].copy()


def write_film(model: Model, path: str | Path, motion: RecordedMotion | None = None) -> Path:
    """Write .gif or .mp4, a motion once through, or .png, where it begins; whole or not at all. Needs matplotlib.

    Raises:
        DescriptionError: another ending, no ffmpeg for .mp4, or a mechanism that does not move.
    """
    file = Path(path)
    if file.suffix not in WRITERS:
        raise DescriptionError(f"expected a file name that ends in {', '.join(WRITERS)}, got {file.name!r}")
    if file.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise DescriptionError("films in MP4 need ffmpeg, which is not installed: apt install ffmpeg; or use --gif")
    frames, rate = frames_of_motion(model, motion)
    if file.suffix == ".png":
        frames = frames[:1]
    return replaced(file, lambda part: WRITERS[file.suffix](part, pictures(model, frames), rate))


def _png(path: Path, made: Iterable[Array], rate: float) -> None:
    from PIL import Image

    Image.fromarray(next(iter(made))).save(path, format="PNG")


def _gif(path: Path, made: Iterable[Array], rate: float) -> None:
    from PIL import Image

    all_of_them = [Image.fromarray(picture).quantize(64) for picture in made]  # colours: few, and files stay small
    first, *rest = all_of_them
    first.save(path, format="GIF", save_all=True, append_images=rest, duration=round(1000 / rate), loop=0)


def _mp4(path: Path, made: Iterable[Array], rate: float) -> None:
    pictures_made = iter(made)
    first = next(pictures_made)
    high, wide = first.shape[:2]
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{wide}x{high}",
               "-r", f"{rate:.6f}", "-i", "-", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-f", "mp4"]  # fmt: skip
    with subprocess.Popen([*command, str(path)], stdin=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdin is not None and running.stderr is not None
        try:
            for picture in (first, *pictures_made):
                running.stdin.write(picture.tobytes())
            running.stdin.close()
        except BrokenPipeError:
            pass  # ffmpeg says why
        said = running.stderr.read().decode(errors="replace").strip()
        if running.wait() != 0:
            raise DescriptionError(f"ffmpeg could not write the film: {said[:200]}")


WRITERS: dict[str, Any] = {".gif": _gif, ".mp4": _mp4, ".png": _png}
"""Ending of a file's name -> what writes pictures into it, so many a second."""
