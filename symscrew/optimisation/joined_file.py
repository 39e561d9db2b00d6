"""A joined problem from a TOML file: [[phases]] or [[cases]] beside the sections of one motion.

What stands outside the parts holds for all of them; a part adds to it (effects, bounds by key, inputs, parameters,
transcription) or replaces it (duration, via, objectives, conditions). [start] is that of the first phase, [end] that of
the last one; of cases they are those of every case that gives none.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from symscrew.description import check_keys, check_sections, from_file, read_tables
from symscrew.errors import DescriptionError, shorten
from symscrew.optimisation import problem_keys
from symscrew.optimisation.joined_problem import JoinedProblem, Link, with_weight
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.problem_file import KEYS, SECTIONS, parse_problem, problem_of, reader_of

ADDED = ("bounds", "inputs", "parameters", "preload", "transcription")  # sections whose keys a part adds to
OWN = ("end", "via", "guess")  # of phases: sections outside them that stand for none, or for one only
PARTS = tuple(problem_keys.PARTS)


def load_problem_file(path: str | Path) -> TrajectoryProblem | JoinedProblem:
    """The problem of a file, with one motion or several.

    Raises:
        DescriptionError: the file cannot be read, or says where and what is wrong in it, and the cure.
    """

    def parse(text: str, *, folder: Path | None, name: str) -> TrajectoryProblem | JoinedProblem:
        several = any(kind in read_tables(text) for kind in PARTS)
        return (parse_joined if several else parse_problem)(text, folder=folder, name=name)

    return from_file(path, parse)


def parse_joined(text: str, *, folder: Path | None = None, name: str = "trajectory") -> JoinedProblem:
    """The joined problem that a TOML text describes; files it names are looked for in `folder`."""
    tables = read_tables(text)
    keys = {**KEYS, **{kind: tuple(problem_keys.PARTS[kind]) for kind in PARTS}}
    check_sections(tables, (*SECTIONS, *PARTS), keys, (*problem_keys.LISTS, *PARTS))
    given = [kind for kind in PARTS if kind in tables]
    if len(given) != 1:
        raise DescriptionError(f"expected tables [[phases]] or [[cases]], got {' and '.join(given) or 'none'}")
    kind, parts = given[0], tables[given[0]]
    if len(parts) < 2:
        raise DescriptionError(f"{kind}: expected at least two tables [[{kind}]], got {len(parts)}")
    common = {section: content for section, content in tables.items() if section != kind}
    for section in ("via", "guess"):
        if section in common and kind == "phases":
            raise DescriptionError(f"{section}: with [[phases]] it belongs to one of them; give it as phases.{section}")
    read = reader_of(common, folder)
    problems, links = [], list[Link | None]()
    for k, part in enumerate(parts):
        where = f"{kind}[{k}]"
        problem = problem_of(_merged(common, part, kind, k, last=k == len(parts) - 1), folder=folder, name=name)
        problems.append(with_weight(problem, read.number(part.get("weight", 1), f"{where}.weight")))
        if kind == "phases" and k < len(parts) - 1:
            links.append(Link(read.numbers(part.get("impact", {}), f"{where}.impact"), _catches(part, where)))
        elif kind == "phases" and ("impact" in part or "catches" in part):
            raise DescriptionError(f"{where}: an impact stands at the end of a phase that another one follows")
    return JoinedProblem(tuple(problems), tuple(links or [None] * (len(parts) - 1)), problems[0].name, text)


def _catches(part: Mapping[str, Any], where: str) -> bool:
    value = part.get("catches", False)
    if not isinstance(value, bool):
        raise DescriptionError(f"{where}.catches: expected true or false, got {shorten(value)}")
    return value


def _merged(common: Mapping[str, Any], part: Mapping[str, Any], kind: str, k: int, *, last: bool) -> dict[str, Any]:
    """The sections of one part by itself."""
    made = {section: content for section, content in common.items() if section not in OWN}
    made["problem"] = dict(common.get("problem", {}))
    if "duration" in part:
        made["problem"]["duration"] = part["duration"]
    if kind == "phases":
        made |= {"end": common["end"]} if last and "end" in common else {}
        if k:
            made.pop("start", None)
    else:
        made |= {section: common[section] for section in OWN if section in common}
    for section, content in part.items():
        if section in ("duration", "weight", "impact", "catches"):
            continue
        expected = list if section in problem_keys.LISTS else dict
        if not isinstance(content, expected):
            what = "a list of tables" if expected is list else "a table"
            raise DescriptionError(f"{kind}[{k}].{section}: expected {what}, got {shorten(content)}")
        if section == "effects":
            made[section] = [*common.get(section, []), *content]
        elif section in ADDED:
            made[section] = _added(common.get(section, {}), dict(content))
        else:
            made[section] = content
        if section in KEYS:
            for table in content if expected is list else [content]:
                check_keys(f"{kind}[{k}].{section}", table, KEYS[section])
    return made


def _added(usual: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """A section with a part's keys; tables by label are put together, lists follow each other."""
    made = dict(usual)
    for key, value in own.items():
        before = usual.get(key)
        if isinstance(before, dict) and isinstance(value, dict):
            made[key] = _added(before, value)
        elif key in ("distances", "obstacles") and isinstance(before, list) and isinstance(value, list):
            made[key] = [*before, *value]
        else:
            made[key] = value
    if "mesh" in own:  # it says how many intervals there are
        made.pop("intervals", None)
    elif "intervals" in own:
        made.pop("mesh", None)
    return made
