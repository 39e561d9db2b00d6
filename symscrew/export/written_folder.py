"""A folder that `generate` wrote: its manifest, and which of its files are the tool's."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from symscrew.export.hash_file import HASHES, read_hashes
from symscrew.export.manifest_file import TOOL, OutputError, read_json
from symscrew.whole_files import finish

MANIFEST = "manifest.json"
_PLAIN_FILE = re.compile(r"[A-Za-z][A-Za-z0-9_]*(\.[A-Za-z0-9_]+)+", re.ASCII)


def read_manifest(directory: Path) -> dict[str, Any]:
    """The manifest in `directory`, after what a killed process left to be moved has been moved.

    Raises:
        OutputError: there is none, or it is not one of this tool.
    """
    try:
        finish(directory, last=MANIFEST, owned=own_files)
    except OSError as error:
        raise OutputError(
            f"{directory}: was being written, and cannot be ({error.strerror}); generate again"
        ) from error
    content = read_json(directory / "manifest.json")
    ours = isinstance(content, dict) and content.get("tool") == TOOL
    if not ours or not isinstance(content.get("functions"), dict):
        raise OutputError(f"{directory}: expected a manifest.json written by {TOOL}; generate into it first")
    for key in ("effects", "targets", "files"):
        if not isinstance(content.get(key), list):
            raise OutputError(f"{directory}/manifest.json: expected a list {key!r}, got {content.get(key)!r:.60}")
    found: dict[str, Any] = content
    return found


def own_files(directory: Path) -> set[str]:
    """Names of files that the tool wrote into a folder, as its manifest says; none where it says nothing."""
    try:
        listed = read_json(directory / MANIFEST).get("files", [])
        hashed = set(read_hashes(directory))  # in the manifest's list, but not written
        written = {f for f in listed if isinstance(f, str) and _PLAIN_FILE.fullmatch(f)} | {MANIFEST}
    except (OutputError, AttributeError, TypeError):
        return set()
    return (written - hashed) | {HASHES} if hashed else written
