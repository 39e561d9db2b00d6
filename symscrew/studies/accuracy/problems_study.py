"""Study "problems": the benchmark problems of a folder, each solved to its stated accuracy beside its peers.

Every scene of the folder with a `<scene>.reference.json` beside it is run by `symscrew simulate` at several tolerances.
A row per problem: the least time of a whole run that is as accurate as stated, and the best of the stored peers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from symscrew.display import Progress
from symscrew.errors import DescriptionError
from symscrew.runtime import find_compiler
from symscrew.scene import load_scene
from symscrew.simulation import Library, prepare, table_code
from symscrew.studies.accuracy.forward_study import ENGINES, OWN, beginning, ours
from symscrew.studies.accuracy.measuring import Point, Setup, Stopwatch, Study, measured
from symscrew.studies.accuracy.run_history import Reference, read_reference
from symscrew.studies.accuracy.states import Subject
from symscrew.studies.accuracy.study_tables import number

HEADER = (
    "problem", "stated error", "error", "time of the run [ms]", "to derive and compile [s]", "best peer, its error",
    "its time [ms]", "bare generated C [ms]",
)  # fmt: skip
BARE = "generatedC"


def study(
    subject: Subject | None, progress: Progress, *, repeats: int, seconds: float, path: Path | None = None,
    full: bool = False,
) -> Study:  # fmt: skip
    """Error over time of a whole run for every problem of the folder `path`, and a table beside their peers."""
    if find_compiler() is None:
        raise DescriptionError("--study problems: its runs are of generated C, and there is no C compiler")
    scenes = sorted(path.glob("*.toml")) if path is not None and path.is_dir() else []
    found = {scene.stem: (scene, reference) for scene in scenes if (reference := read_reference(scene)) is not None}
    if not found:
        raise DescriptionError(
            "--study problems: expected a folder of scenes with references, as examples/benchmarks; "
            f"{path} has none"
        )  # fmt: skip
    setups: list[Setup] = []
    watches: dict[str, Stopwatch] = {}
    for name, (scene, reference) in progress.bar(list(found.items()), "problems: derive and compile"):
        watches[name] = Stopwatch()
        setups += _setups(name, scene, reference, watches[name])
    points = measured(setups, repeats=repeats, seconds=seconds, progress=progress, text="problems")
    rows = [
        _row(name, [p for p in points if p.curve == name], reference, sum(watches[name].seconds.values()))
        for name, (_, reference) in found.items()
    ]
    steps = dict.fromkeys(step for watch in watches.values() for step in watch.seconds)
    return Study(
        "problems",
        f"Benchmark problems of {path}",
        points,
        error_label="error as the problem measures it [rad, m]",
        cost_label="time of the whole run",
        cost_unit="ms",
        reference="the problems' own, each with a second formulation beside it; the largest of their errors",
        reference_error=max((r.own_error or 0.0) for _, r in found.values()),
        preparation={step: sum(w.seconds.get(step, 0.0) for w in watches.values()) for step in steps},
        left_out=(),
        notes=(
            "Peers: solver call only, on another machine than this; see the problems' own studies for all of them.",
            *(f"{name}: {r.problem}; stated: {_stated(r)}" for name, (_, r) in found.items()),
        ),
        tables={"Benchmark problems at their stated accuracy": (HEADER, rows)},
    )


def _setups(name: str, path: Path, reference: Reference, watch: Stopwatch) -> list[Setup]:
    scene = load_scene(path)
    scene = replace(scene, rate=1.0 / float(reference.times[1]), duration=float(reference.times[-1]))
    scene = replace(scene, integrator=replace(scene.integrator, method="dop853", step=None))
    model, plant = watch("derive", prepare, scene)
    library = watch("compile", Library, plant, table_code(list(scene.tables.values())))
    runs = ours(scene, library, beginning(scene, model, plant), reference.error_of(model))
    return [replace(setup, curve=name, share=1.0, facts={"method": OWN}) for setup in runs]


def _row(name: str, points: Sequence[Point], reference: Reference, spent: float) -> list[str]:
    """The fastest run that is as accurate as stated, else the most accurate one, beside the best peer."""
    good = [p for p in points if p.error is not None and p.cost is not None]
    reached = [p for p in good if reference.stated is None or (p.error or 0.0) <= reference.stated]
    best = min(reached, key=_seconds) if reached else min(good, key=lambda p: p.error or 0.0, default=None)
    row = [name, "-" if reference.stated is None else f"{reference.stated:g}"]
    row += ["failed", "-"] if best is None else [f"{best.error:.1e}", number(1e3 * _seconds(best))]
    row.append(f"{spent:.1f}")
    peers = [p for p in reference.peer_points(1.0) if not p.curve.startswith(BARE)]
    bare = [p for p in reference.peer_points(1.0) if p.curve.startswith(BARE)]
    peer, other = _best(peers, reference.stated), _best(bare, reference.stated)
    row += ["-", "-"] if peer is None else [f"{_named(peer)}, {peer.error:.0e}", number(1e3 * _seconds(peer))]
    return [*row, "-" if other is None else number(1e3 * _seconds(other))]


def _best(points: Sequence[Point], stated: float | None) -> Point | None:
    """The fastest of the points that reach the stated error; where none does the most accurate."""
    reached = [p for p in points if stated is None or (p.error or 0.0) <= stated]
    return min(reached or points, key=_seconds if reached else lambda p: (p.error or 0.0, _seconds(p)), default=None)


def _seconds(point: Point) -> float:
    assert point.cost is not None
    return point.cost.median


def _named(point: Point) -> str:
    engine, _, rest = point.curve.partition(" ")
    return f"{ENGINES.get(engine, engine)} {rest or point.setting}"


def _stated(reference: Reference) -> str:
    return next((n for n in reference.notes if n.startswith("Stated")), "none").removeprefix("Stated accuracy: ")
