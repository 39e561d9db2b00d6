"""`symscrew accuracy`: studies of methods side by side, as JSON, Markdown and plots.

mechanism, scene, folder or problem --_subject--> model --study_of (a table in studies/accuracy)--> Study --> files
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import add_no_cache, find_mechanism, need_matplotlib
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.studies.accuracy import STUDIES, studies_of_a_mechanism
from symscrew.whole_files import write_text

if TYPE_CHECKING:
    from symscrew.display import Progress
    from symscrew.studies.accuracy import Study, Subject

EXAMPLES = (
    "symscrew accuracy three_ups_upu_s --study precision --out study",
    "symscrew accuracy examples/benchmarks --out problems",
    "symscrew accuracy examples/benchmarks/n_four_bar.toml --study growth --out growth",
)
USUAL_OF_A_SCENE = ("forward",)
NO_COMPILER, GET_COMPILER = "there is no C compiler", "; apt install gcc"  # what studies say, and what to do about it
REPEATS, SECONDS = 9, 12.0  # repeats of every setting, as far as these seconds a study allow
FULL_REPEATS, FULL_SECONDS = 25, 120.0  # with `--full`


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew accuracy`; the studies are those of the table."""
    text = "a name of `symscrew list`, a scene file, or a folder of benchmark problems"
    command.add_argument("mechanism", metavar="NAME|SCENE|FOLDER", help=text)
    usual = studies_of_a_mechanism()
    others = [f"{name} ({entry.note})" if entry.note else name for name, entry in STUDIES.items() if name not in usual]
    text = (
        f"{', '.join(usual)} or all of these; {', '.join(others)}; default: all of a mechanism, "
        f"{', '.join(USUAL_OF_A_SCENE)} of a scene"
    )
    command.add_argument("--study", metavar="STUDY", help=text)
    command.add_argument("--problems", metavar="DIR", help="also the benchmark problems of a folder, a row for each")
    command.add_argument("--out", metavar="DIR", required=True, help="for JSON, Markdown table and plots")
    command.add_argument("--full", action="store_true", help="more repeats and smaller steps: takes longer")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Read, study, write; 1 where a study that was asked for has no point that worked."""
    from symscrew.display import Progress, print_table, print_text
    from symscrew.studies import machine
    from symscrew.studies.accuracy import study_of, study_summary

    choices = (*STUDIES, "all")
    if options.study is not None and options.study not in choices:
        raise UsageError(f"--study: {shorten(options.study)} is unknown; {did_you_mean(options.study, choices)}")
    if options.problems is not None and not Path(options.problems).is_dir():  # studies take minutes: not before it
        raise UsageError(f"--problems: expected a folder of benchmark problems, got {shorten(options.problems)}")
    directory = _directory(options.out)
    need_matplotlib("plots need")
    if options.study in STUDIES and STUDIES[options.study].of == "problem":
        return _of_a_problem(options, directory)
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
                raise UsageError(str(error)) from error
            left_out.append(f"{name}: {error}")
    directory.mkdir(parents=True, exist_ok=True)
    name = subject.model.name if subject is not None and path is None else Path(options.mechanism).stem
    written = _write(name, studies, directory, facts=facts, left_out=left_out)
    summary = study_summary(studies)
    if summary[1]:
        print_table(*summary)
    for study in studies:
        left_out += [f"{study.name}: {what}" for what in study.left_out]
        own = "not known" if study.reference_error is None else f"{study.reference_error:.1e}"
        print_text(f"{study.name}: {study.error_label}; {study.cost_label}; error of the reference {own}")
        for title, (header, rows) in study.tables.items():
            print(f"\n{title}\n")
            print_table(header, rows)
    for reason in left_out:
        print_text(f"left out: {reason}{GET_COMPILER if NO_COMPILER in reason else ''}")
    print(f"wrote {', '.join(p.name for p in written)} to {directory}")
    worked = all(any(p.error is not None for p in s.points) or s.tables for s in studies)
    return DONE if studies and worked else FAILED


def _write(
    name: str, studies: Sequence[Study], directory: Path, *, facts: Mapping[str, str], left_out: Sequence[str]
) -> list[Path]:
    """Write pictures, `accuracy.json` and `accuracy.md`."""
    from symscrew.studies.accuracy import save_study_plots, study_json, study_markdown

    pictures = [path for study in studies for path in save_study_plots(study, directory)]
    text = study_markdown(name, studies, facts, pictures=[p.name for p in pictures], left_out=left_out)
    return [
        write_text(directory / "accuracy.json", study_json(name, studies, facts, left_out)),
        write_text(directory / "accuracy.md", text),
        *pictures,
    ]


def _directory(name: str) -> Path:
    """Where `--out` goes; it is made when there is something to write."""
    path = Path(name)
    if "\0" in name:
        raise UsageError("--out: a path must not contain a null character")
    if path.exists() and not path.is_dir():
        raise UsageError(f"--out: expected a directory, {shorten(name)} is a file")
    parent = next(p for p in (path, *path.absolute().parents) if p.exists())
    try:
        with TemporaryDirectory(dir=parent, prefix=".symscrew-"):  # studies take minutes: not for nothing
            return path
    except OSError as error:
        raise UsageError(f"--out: cannot write to {shorten(str(parent))}: {error.strerror or error}") from error


def _subject(name: str, progress: Progress) -> tuple[Subject | None, Path | None]:
    """The model of a mechanism, or of a scene (a TOML file with a table [scene]), and the scene's file.

    A folder is one of benchmark problems: it has no model of its own.
    """
    from symscrew import catalogue
    from symscrew.description import read_tables, read_text
    from symscrew.model import derive
    from symscrew.scene import load_scene
    from symscrew.studies.accuracy import Subject

    path = Path(name)
    if path.is_dir() and name not in catalogue.names():
        return None, path
    if path.suffix == ".toml" and name not in catalogue.names():
        tables = read_tables(read_text(path))
        if "scene" in tables:
            scene = load_scene(path)
            with progress.step(f"derive {scene.mechanism.name}"):
                return Subject(derive(scene.mechanism, scene.effects), scene), path
    mechanism = find_mechanism(name, acting=True)
    with progress.step(f"derive {mechanism.name}"):
        return Subject(derive(mechanism)), None


def _studies(chosen: str | None, subject: Subject | None, problems: str | None) -> tuple[str, ...]:
    """Names of the studies to run: those asked for, or the usual ones of what was given."""
    further = ("problems",) if problems else ()
    if subject is None:
        if chosen not in (None, "all", "problems"):
            raise UsageError(f"--study {chosen}: expected a mechanism or a scene; a folder is one of problems")
        return ("problems",)
    if chosen in (None, "all"):
        usual = USUAL_OF_A_SCENE if chosen is None and subject.scene is not None else studies_of_a_mechanism()
        return (*usual, *further)
    assert chosen is not None
    return (chosen, *(name for name in further if name != chosen))


def _of_a_problem(options: argparse.Namespace, directory: Path) -> int:
    """A study of an optimisation problem, which has files of its own; 1 where nothing was solved."""
    from symscrew.description import read_tables, read_text
    from symscrew.display import Progress
    from symscrew.optimisation import load_problem
    from symscrew.studies.accuracy import problem_study

    path = Path(options.mechanism)
    if "problem" not in read_tables(read_text(path)):
        raise UsageError(f"--study {options.study}: expected the TOML file of an optimisation problem")
    problem = load_problem(path)
    with Progress().step(f"study {options.study} of {problem.name}"):
        found = problem_study(options.study, problem, full=options.full)
    directory.mkdir(parents=True, exist_ok=True)
    found.write(directory)
    print(found.markdown())
    return DONE if found.points else FAILED
