"""Pieces of a sweep on disk, so that an interrupted sweep goes on where it was; and the whole as one file."""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
from pathlib import Path

import numpy as np

from symscrew.description import read_text
from symscrew.errors import DescriptionError, shorten
from symscrew.studies.workspace.plan import Plan
from symscrew.whole_files import replaced

MANIFEST = "manifest.json"
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
        if manifest.is_file():
            try:
                found = json.loads(read_text(manifest))
            except ValueError as error:
                raise DescriptionError(f"{manifest}: not a manifest of a sweep ({error})") from error
            if found != content:
                raise DescriptionError(
                    f"{shorten(str(folder), 200)} holds pieces of another sweep; use another --out or remove the folder"
                )
            return
        if folder.exists() and any(folder.iterdir()):
            raise DescriptionError(f"{shorten(str(folder), 200)} is not empty and holds no sweep; use another --out")
        folder.mkdir(parents=True, exist_ok=True)
        replaced(manifest, lambda path: path.write_text(json.dumps(content) + "\n", encoding="utf-8"))

    def done(self) -> dict[int, Path]:
        """Number -> file of the pieces that are there and whole."""
        found = {}
        for file in sorted(self.folder.glob("piece_*.npz")):
            _, number, digest = file.stem.split("_")
            if hashlib.sha256(file.read_bytes()).hexdigest()[:16] == digest:
                found[int(number)] = file
        return found

    def put(self, number: int, results: Results) -> None:
        """Store a piece."""
        handle, name = tempfile.mkstemp(dir=self.folder, prefix=".piece_")
        with os.fdopen(handle, "wb") as stream:
            np.savez(stream, **results)  # type: ignore[arg-type]
        part = Path(name)
        digest = hashlib.sha256(part.read_bytes()).hexdigest()[:16]
        for other in self.folder.glob(f"piece_{number:07d}_*.npz"):
            other.unlink()
        os.replace(part, self.folder / f"piece_{number:07d}_{digest}.npz")

    def whole(self) -> Results:
        """All pieces in order; raises DescriptionError if one is missing."""
        files = self.done()
        missing = [k for k in range(self.plan.chunks) if k not in files]
        if missing:
            raise DescriptionError(
                f"{self.folder}: {len(missing)} of {self.plan.chunks} pieces are missing; run it again"
            )
        pieces = []
        for k in range(self.plan.chunks):
            with np.load(files[k], allow_pickle=False) as archive:
                pieces.append({name: archive[name] for name in archive.files})
        return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


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
