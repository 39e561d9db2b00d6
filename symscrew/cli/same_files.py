"""What a command made before of the same files, found before anything heavy is imported.

    words, file --every file that it names--> bytes --key--> user's cache: facts, files, or nothing: then it is made

What is read of the files is their bytes: whatever differs in one of them, be it a blank, makes the outcome anew. Only
TOML files are followed, from which others are named by texts; a text that names a file of another kind, which may name
further ones, keeps nothing. What is kept is read as JSON, and nothing in it is run.
"""

from __future__ import annotations

import base64
import binascii
import json
import sys
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from symscrew.cli.help import DONE, FAILED

LIBRARIES = ("casadi", "mpmath", "numpy", "scipy", "sympy")  # whose versions an outcome may depend on
LONGEST_NAME = 1000  # characters of a text that may name a file
MOST_BYTES = 1 << 24  # of a file: larger ones are refused where they are read


@dataclass(frozen=True)
class Outcome:
    """What is printed, as JSON holds it, and files by name.

    `good`: it may be kept. `earlier`: it was made in an earlier run.
    """

    facts: Mapping[str, Any]
    files: Mapping[str, bytes] = field(default_factory=dict)
    good: bool = True
    earlier: bool = False


def once_of_files(command: str, words: Sequence[object], file: str, make: Callable[[], Outcome]) -> Outcome:
    """The outcome of a command with these words for a file: from an earlier run, or made now and kept if it is good.

    `words`: all that the outcome depends on beside the file and what it names, as JSON holds it.
    """
    key = _key(command, words, file)
    found = kept_outcome(key)
    if found is not None:
        return found
    made = make()
    if key is not None and made.good and key == _key(command, words, file):  # nobody wrote into the files meanwhile
        keep_outcome(key, made)
    return made


def kept_outcome(key: str | None) -> Outcome | None:
    """What is kept under a key, or None."""
    from symscrew.runtime import entry

    with entry(key) as kept:  # not held while it is made: making may ask for entries of its own
        return _read(kept.read())


def keep_outcome(key: str | None, made: Outcome) -> None:
    """Keep an outcome under a key."""
    from symscrew.runtime import entry

    files = {name: base64.b64encode(data).decode("ascii") for name, data in made.files.items()}
    with entry(key) as kept:
        kept.write(json.dumps({"facts": made.facts, "files": files}).encode("ascii"))


def write_files(outcome: Outcome, paths: Mapping[str, Path | None]) -> None:
    """Write the files of an outcome, all of which are there by now, to the paths of this run."""
    from symscrew.whole_files import replaced

    for name, data in outcome.files.items():
        if (path := paths[name]) is not None:
            replaced(path, lambda part, data=data: part.write_bytes(data))  # type: ignore[misc]


def told(outcome: Outcome, paths: Mapping[str, Path | None], *, as_json: bool, said: str) -> int:
    """Write a motion's files, say its numbers or lines and what was written; the exit code."""
    from symscrew.display import print_text

    if outcome.earlier:
        for notice in outcome.facts["notices"]:
            print(f"note: {notice}", file=sys.stderr)
        print(said, file=sys.stderr)
    write_files(outcome, paths)
    if as_json:
        print(json.dumps(outcome.facts["numbers"], indent=1))
    else:
        print_text("\n".join(outcome.facts["lines"]))
    for path in paths.values():
        if path is not None:
            print(f"wrote {path}", file=sys.stderr)
    return DONE if outcome.facts["numbers"]["ok"] else FAILED


def _key(command: str, words: Sequence[object], file: str) -> str | None:
    """Hash of all that an outcome depends on; None where that cannot be told."""
    from symscrew.runtime import compiler_key, find_compiler, installed, key_of, version

    try:
        compiler = compiler_key(find_compiler())
        read = dict(_files(Path(file)))
        if compiler is None or None in read.values():
            return None
        text = json.dumps([command, *words, Path(file).stem, *map(installed, LIBRARIES)])
        parts = [b"outcome of files", version().encode("utf-8", "surrogateescape"), text.encode("ascii"), compiler]
        for name, content in read.items():
            parts += [name.encode("utf-8", "surrogateescape"), content or b""]
        return key_of(*parts)
    except (OSError, TypeError, ValueError, RecursionError):  # whoever reads it in earnest says what is wrong
        return None


def _files(file: Path) -> Iterator[tuple[str, bytes | None]]:
    """Name and content of a TOML file and of those that it names, in their order; None where more may be read."""
    wanted, seen = [("", file)], set[Path]()
    while wanted:
        name, path = wanted.pop()
        if path.suffix != ".toml" or not path.is_file() or path.stat().st_size > MOST_BYTES:
            yield name, None
            return
        content = path.read_bytes()
        yield f"{len(seen)} {name}", content
        seen.add(path.resolve())
        for text in _texts(tomllib.loads(content.decode("utf-8"))):
            if len(text) > LONGEST_NAME or "\0" in text:
                continue
            if not Path(text).suffix and Path(text).is_file():  # a mechanism in the folder where the command runs
                yield text, None
                return
            named = path.parent / text
            if named.is_file() and named.resolve() not in seen:
                wanted.append((text, named))


def _texts(content: object) -> Iterator[str]:
    """Every text in the tables of a TOML file."""
    if isinstance(content, str):
        yield content
    elif isinstance(content, Mapping):
        for part in content.values():
            yield from _texts(part)
    elif isinstance(content, Sequence):
        for part in content:
            yield from _texts(part)


def _read(kept: bytes | None) -> Outcome | None:
    try:
        found = json.loads(kept) if kept is not None else None
        files = {name: base64.b64decode(text, validate=True) for name, text in found["files"].items()} if found else {}
        return Outcome(found["facts"], files, earlier=True) if found else None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, binascii.Error):
        return None
