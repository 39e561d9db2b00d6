"""`symscrew report`."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from symscrew import catalogue
from symscrew.description import Mechanism
from symscrew.display import Progress
from symscrew.effects import Effect
from symscrew.errors import DescriptionError, shorten
from symscrew.model import Model, derive
from symscrew.runtime import CompiledModel, load
from symscrew.studies import Times, interleaved, nanoseconds_per_state
from symscrew.studies.workspace import calls_of

BATCH, ROUNDS, WARM = 64, 41, 3


def run(options: argparse.Namespace, chosen) -> int:  # type: ignore[no-untyped-def]
    """Read, derive, measure, write; `chosen(options, mechanism)` are the effects."""
    from symscrew.report import document, write_document
    from symscrew.scene import load_scene
    from symscrew.studies import scene_bill

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
    call, measured = None, dict[str, Times]()
    if not options.no_timing:
        with progress.step("compile"):
            compiled = load(model)
        call, measured = calls_of(compiled), _times(model, compiled, progress)
    bill = scene_bill(scene, timed=not options.no_timing, progress=progress) if scene is not None else None
    accuracy = Path(options.accuracy) if options.accuracy else None
    made = document(model, call=call, times=measured, accuracy=accuracy, bill=bill, progress=progress)
    for file in write_document(made, path):
        print(file)
    return 0


def _times(model: Model, compiled: CompiledModel, progress: Progress) -> dict[str, Times]:
    """Nanoseconds per state of every function in compiled C, on batches of the sample states; else none."""
    if compiled.backend != "c":
        return {}
    with progress.step("time"):
        measures = {}
        for name, states in model.test_inputs.items():
            ports = model.programs[name].inputs
            inputs = {p.name: np.resize(x, (BATCH, p.size)) for p, x in zip(ports, states, strict=True)}
            measures[name] = nanoseconds_per_state(compiled[name], inputs)
        interleaved(measures, WARM)
        return interleaved(measures, ROUNDS)
