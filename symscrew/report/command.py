"""`symscrew report`."""

from __future__ import annotations

import argparse
from pathlib import Path

from symscrew import catalogue
from symscrew.compiled import load
from symscrew.console import Progress
from symscrew.effects import Effect
from symscrew.errors import DescriptionError, shorten
from symscrew.mechanism import Mechanism
from symscrew.model import derive
from symscrew.workspace.configurations import calls_of


def run(options: argparse.Namespace, chosen) -> int:  # type: ignore[no-untyped-def]
    """Read, derive, measure, write; `chosen(options, mechanism)` are the effects."""
    from symscrew.cost import scene_bill
    from symscrew.report import document, write
    from symscrew.report.timing import times
    from symscrew.scene import load as load_scene

    path = Path(options.out)
    if path.suffix not in (".html", ".md"):
        raise DescriptionError(f"--out: expected a file name that ends in .html or .md, got {shorten(options.out)}")
    if not path.parent.is_dir():
        raise DescriptionError(f"--out: no folder {shorten(str(path.parent), 200)} to write into")
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism: Mechanism = catalogue.find(options.mechanism)
        effects: list[Effect] = chosen(options, mechanism)
        scene = load_scene(options.scene) if options.scene else None
    if scene is not None and scene.mechanism.name != mechanism.name:
        raise DescriptionError(f"--scene: is about {scene.mechanism.name}, but the report about {mechanism.name}")
    with progress.step(f"derive {mechanism.name}"):
        model = derive(mechanism, effects)
    call, measured = None, dict[str, tuple[float, float, float]]()
    if not options.no_timing:
        with progress.step("compile"):
            compiled = load(model)
        call, measured = calls_of(compiled), dict(times(model, compiled, progress))
    bill = scene_bill(scene, timed=not options.no_timing, progress=progress) if scene is not None else None
    accuracy = Path(options.accuracy) if options.accuracy else None
    made = document(model, call=call, times=measured, accuracy=accuracy, bill=bill, progress=progress)
    for file in write(made, path):
        print(file)
    return 0
