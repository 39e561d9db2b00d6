"""`symscrew accuracy`."""

from __future__ import annotations

import argparse
import importlib.util
import os
from pathlib import Path

from symscrew import catalogue
from symscrew.description import read_tables, read_text
from symscrew.display import Progress
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.model import derive
from symscrew.scene import load_scene
from symscrew.studies import machine
from symscrew.studies.accuracy import (
    OF_A_MECHANISM,
    Study,
    Subject,
    study_json,
    study_markdown,
    study_of,
    study_summary,
    table,
)
from symscrew.whole_files import write_text

CHOICES = (*OF_A_MECHANISM, "growth", "problems", "transcription", "all")
USUAL_OF_A_SCENE = ("forward",)
REPEATS, SECONDS = 9, 12.0
FULL_REPEATS, FULL_SECONDS = 25, 120.0


def run(options: argparse.Namespace) -> int:
    """Read, study, write; 1 where a study that was asked for has no point that worked."""
    if options.study is not None and options.study not in CHOICES:
        raise DescriptionError(f"--study: {shorten(options.study)} is unknown; {did_you_mean(options.study, CHOICES)}")
    directory = _directory(options.out)
    if importlib.util.find_spec("matplotlib") is None:
        raise DescriptionError('plots need matplotlib, which is not installed: pip install "symscrew[plot]"')
    if options.study == "transcription":
        return _transcription(options, directory)
    progress = Progress()
    subject, path = _subject(options.mechanism, progress)
    asked = _studies(options.study, subject, options.problems)
    facts = machine()
    studies: list[Study] = []
    left_out: list[str] = []
    repeats, seconds = (FULL_REPEATS, FULL_SECONDS) if options.full else (REPEATS, SECONDS)
    for name in asked:
        try:
            with progress.step(f"study {name}"):
                place = Path(options.problems) if name == "problems" and options.problems else path
                found = study_of(name, subject, place, full=options.full)
                studies.append(found(progress, repeats=repeats, seconds=seconds))
        except (DescriptionError, ArithmeticError) as error:
            if options.study != "all" and len(asked) == 1:
                raise DescriptionError(str(error)) from error
            left_out.append(f"{name}: {error}")
    directory.mkdir(parents=True, exist_ok=True)
    name = subject.model.name if subject is not None and path is None else Path(options.mechanism).stem
    written = _write(name, studies, facts, left_out, directory)
    print(study_summary(studies))
    for study in studies:
        own = "not known" if study.reference_error is None else f"{study.reference_error:.1e}"
        print(f"{study.name}: {study.error_label}; {study.cost_label}; error of the reference {own}")
        for title, (header, rows) in study.tables.items():
            print(f"\n{title}\n\n{table(header, rows)}")
    for reason in left_out:
        print(f"left out: {reason}")
    print(f"wrote {', '.join(p.name for p in written)} to {directory}")
    worked = all(any(p.error is not None for p in s.points) or s.tables for s in studies)
    return 0 if studies and worked else 1


def _write(name: str, studies: list[Study], facts: dict[str, str], left_out: list[str], directory: Path) -> list[Path]:
    from symscrew.studies.accuracy import save_study_plots

    pictures = [path for study in studies for path in save_study_plots(study, directory)]
    text = study_markdown(name, studies, facts, [p.name for p in pictures], left_out)
    return [
        write_text(directory / "accuracy.json", study_json(name, studies, facts, left_out)),
        write_text(directory / "accuracy.md", text),
        *pictures,
    ]


def _directory(name: str) -> Path:
    path = Path(name)
    if "\0" in name:
        raise DescriptionError("--out: a path must not contain a null character")
    if path.exists() and not path.is_dir():
        raise DescriptionError(f"--out: expected a directory, {shorten(name)} is a file")
    parent = next(p for p in (path, *path.absolute().parents) if p.exists())
    if not os.access(parent, os.W_OK | os.X_OK):
        raise DescriptionError(f"--out: no permission to write to {shorten(str(parent))}")
    return path


def _subject(name: str, progress: Progress) -> tuple[Subject | None, Path | None]:
    """The model of a mechanism, or of a scene (a TOML file with a table [scene]), and the scene's file.

    A folder is one of benchmark problems: it has no model of its own.
    """
    path = Path(name)
    if path.is_dir() and name not in catalogue.names():
        return None, path
    if path.suffix == ".toml" and name not in catalogue.names():
        tables = read_tables(read_text(path))
        if "scene" in tables:
            scene = load_scene(path)
            with progress.step(f"derive {scene.mechanism.name}"):
                return Subject(derive(scene.mechanism, scene.effects), scene), path
    mechanism = catalogue.find(name)
    with progress.step(f"derive {mechanism.name}"):
        return Subject(derive(mechanism)), None


def _studies(chosen: str | None, subject: Subject | None, problems: str | None) -> tuple[str, ...]:
    further = ("problems",) if problems else ()
    if subject is None:
        if chosen not in (None, "all", "problems"):
            raise DescriptionError(f"--study {chosen}: expected a mechanism or a scene; a folder is one of problems")
        return ("problems",)
    if chosen in (None, "all"):
        return (*(USUAL_OF_A_SCENE if chosen is None and subject.scene is not None else OF_A_MECHANISM), *further)
    assert chosen is not None
    return (chosen, *(name for name in further if name != chosen))


def _transcription(options: argparse.Namespace, directory: Path) -> int:
    """The study of transcriptions of an optimisation problem."""
    from symscrew.studies import study_transcriptions

    tables = read_tables(read_text(Path(options.mechanism)))
    if "problem" not in tables:
        raise DescriptionError("--study transcription: expected the TOML file of an optimisation problem")
    return int(study_transcriptions(Path(options.mechanism), directory, full=options.full) or 0)
