"""`hashes.json`: what stands in a folder of generated code in place of its long files.

    {"delta.c": {"sha256": "...", "bytes": 3499297}, ...}

A folder with it holds what a reader learns from: headers, operation counts, manifest and description. Of every other
file it says the hash, so that `check` can tell whether the tool would still write the same bytes. These are the same
on every machine: numbers in them come from functions and least squares of plain sums and products
(`symscrew.algebra`), not from the processor's library. Files of which that is not true are not in the table.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from symscrew.export.manifest_file import OutputError, read_json

HASHES = "hashes.json"
SHA256 = re.compile(r"[0-9a-f]{64}", re.ASCII)


@dataclass(frozen=True)
class FileHash:
    """SHA-256 (hexadecimal) and size of a file."""

    sha256: str
    size: int


def file_hash(content: bytes) -> FileHash:
    """The hash of a file with this content."""
    return FileHash(hashlib.sha256(content).hexdigest(), len(content))


def print_hashes(files: Mapping[str, bytes]) -> str:
    """The text of `hashes.json` for files by name, a line for each."""
    made = {name: file_hash(content) for name, content in sorted(files.items())}
    rows = [f" {json.dumps(name)}: {json.dumps({'sha256': h.sha256, 'bytes': h.size})}" for name, h in made.items()]
    return "{\n" + ",\n".join(rows) + "\n}\n"


def read_hashes(directory: Path) -> dict[str, FileHash]:
    """File name to hash from the folder's `hashes.json`; empty where it has none.

    Raises:
        OutputError: the file is no such table.
    """
    path = directory / HASHES
    if not path.exists():
        return {}
    content = read_json(path)
    if not isinstance(content, dict) or not content or not all(map(_sound, content.values())):
        raise OutputError(f"{path}: expected file names with 'sha256' and 'bytes', got {content!r:.60}; generate again")
    return {name: FileHash(entry["sha256"], entry["bytes"]) for name, entry in content.items()}


def _sound(entry: object) -> bool:
    if not isinstance(entry, dict) or not isinstance(entry.get("sha256"), str):
        return False
    return SHA256.fullmatch(entry["sha256"]) is not None and type(entry.get("bytes")) is int
