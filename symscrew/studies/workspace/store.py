"""Pieces of a sweep on disk, so that an interrupted sweep goes on where it was; and the whole as one file."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from symscrew.array_archives import read_archive
from symscrew.description import read_text
from symscrew.errors import DescriptionError, shorten
from symscrew.studies.workspace.plan import Plan
from symscrew.whole_files import is_staging, one_at_a_time, remove_abandoned, replaced, stage, write_text

MANIFEST = "manifest.json"
PIECE = re.compile(r"piece_(\d{7,10})_([0-9a-f]{16})\.npz", re.ASCII)  # number and digest of a file
ALWAYS = frozenset(("status", "reached", "regular", "allowed"))  # results of every sweep
BYTES = 8  # of a number
Results = dict[str, np.ndarray]


class Store:
    """A folder with a manifest and one file per piece.

    A piece counts as done when its file is whole, which its name says: it holds the digest of its bytes. Files are
    written beside and renamed, so that a killed sweep leaves whole pieces only.
    """

    def __init__(self, folder: Path, plan: Plan) -> None:
        """Open or create the folder; raises DescriptionError if it belongs to another sweep."""
        self.folder, self.plan = folder, plan
        manifest = folder / MANIFEST
        content = {"plan": plan.hash, "cases": plan.count, "chunk": plan.chunk}
        remove_abandoned(manifest)
        if manifest.is_file():
            try:
                found = json.loads(read_text(manifest))
            except (ValueError, RecursionError) as error:
                raise DescriptionError(
                    f"{manifest}: not a manifest of a sweep ({shorten(str(error))}); remove the folder"
                ) from error
            if found != content:
                raise DescriptionError(
                    f"{shorten(str(folder), 200)} holds pieces of another sweep; use another --out or remove the folder"
                )
            return
        if folder.exists() and (not folder.is_dir() or not all(is_staging(name) for name in os.listdir(folder))):
            raise DescriptionError(f"{shorten(str(folder), 200)} is not empty and holds no sweep; use another --out")
        folder.mkdir(parents=True, exist_ok=True)
        write_text(manifest, json.dumps(content) + "\n")

    def done(self) -> dict[int, Path]:
        """Number -> file of the pieces that are there and whole."""
        found = {}
        for name in sorted(os.listdir(self.folder)):
            match, file = PIECE.fullmatch(name), self.folder / name
            if match and int(match[1]) < self.plan.chunks and file.is_file() and _digest(file) == match[2]:
                found[int(match[1])] = file
        return found

    def put(self, number: int, results: Results) -> None:
        """Store a piece."""
        with stage(self.folder / "piece") as place:
            part = place / "piece.npz"
            np.savez(part, **results)  # type: ignore[arg-type]
            name = f"piece_{number:07d}_{_digest(part)}.npz"
            for other in self.folder.glob(f"piece_{number:07d}_*.npz"):
                other.unlink()
            os.replace(part, self.folder / name)

    def whole(self) -> Results:
        """All pieces in order.

        Raises:
            DescriptionError: one is missing, or does not hold what the sweep writes.
        """
        files = self.done()
        missing = [k for k in range(self.plan.chunks) if k not in files]
        if missing:
            raise DescriptionError(
                f"{self.folder}: {len(missing)} of {self.plan.chunks} pieces are missing; run it again"
            )
        pieces: list[Results] = []
        for k in range(self.plan.chunks):
            piece = read_archive(files[k], max_bytes=self.plan.chunk * BYTES)
            shape = (len(self.plan.cases(k)),)
            sound = all(array.shape == shape and array.dtype == float for array in piece.values())
            if not sound or not piece.keys() >= ALWAYS or (pieces and list(piece) != list(pieces[0])):
                raise DescriptionError(f"{files[k]}: not a piece of this sweep; remove it, and run it again")
            pieces.append(piece)
        return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


@contextlib.contextmanager
def held_store(folder: Path, plan: Plan) -> Iterator[Store]:
    """The store, in the hands of this process alone: another one that wants it waits until the end.

    Raises:
        DescriptionError: the folder belongs to another sweep.
    """
    notice = f"another process computes this sweep in {folder}; waiting for it"
    while True:
        store = Store(folder, plan)
        with one_at_a_time(folder, patience=None, notice=notice) as same:
            if same():  # else it was finished and removed meanwhile
                yield Store(folder, plan) if not (store.folder / MANIFEST).is_file() else store
                return


def _digest(file: Path) -> str:
    """SHA-256 of a file, 16 hex digits."""
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()[:16]


def save_npz(path: Path, results: Results) -> Path:
    """All results as arrays by name."""
    return replaced(path, lambda part: np.savez_compressed(part, **results))  # type: ignore[arg-type]


def save_csv(path: Path, results: Results) -> Path:
    """All results as columns, with full digits."""
    table = np.stack(list(results.values()), axis=1)

    def write(part: Path) -> None:
        header = ",".join(f'"{name}"' for name in results)
        np.savetxt(part, table, fmt="%.17g", delimiter=",", header=header, comments="")

    return replaced(path, write)
