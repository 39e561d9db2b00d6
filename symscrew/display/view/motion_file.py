"""Recorded motions: RUN.npz, the arrays of a simulated or optimised motion and the mechanism that moved.

| array | shape | content |
|---|---|---|
| `t` | (n,) | times [s], increasing |
| `q`, `v` | (n, nq), (n, nv) | configuration and rates of the tree |
| `u` | (n, nu) | drives; may be missing |
| `reactions` | (n, 6 joints) | wrench (f ; m_O) of every joint, from parent on child, absolute axes; may be missing |
| `mechanism` | () | TOML text of the description, or a name of the catalogue |
| `q_labels`, `u_labels` | (nq,), (nu,) | labels of the columns |
| `scene` | () | TOML text with the [[effects]] under which it moved; may be missing |

Other arrays are ignored.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from symscrew import catalogue
from symscrew.array_archives import read_archive
from symscrew.description import Mechanism, parse_description
from symscrew.errors import DescriptionError, shorten
from symscrew.model import Model

Array = np.ndarray
NEEDED = ("t", "q", "v", "mechanism", "q_labels")


@dataclass(frozen=True)
class RecordedMotion:
    """A motion as it was read: t (n,) [s], q (n, nq), v (n, nv); u (n, nu) and reactions (n, 6 joints) or None.

    `scene`: with the effects under which it moved, which may keep other joints in the tree; empty where none is known.
    `frames`: about how many states a page is to hold, all peaks among them; None: as many as make 4 MB.
    """

    mechanism: Mechanism
    t: Array
    q: Array
    v: Array
    u: Array | None
    reactions: Array | None
    q_labels: tuple[str, ...]
    u_labels: tuple[str, ...]
    frames: int | None = None
    scene: str = ""

    def __repr__(self) -> str:
        return f"RecordedMotion({self.mechanism.name}: {len(self.t)} states from {self.t[0]:g} s to {self.t[-1]:g} s)"

    def check(self, model: Model) -> None:
        """Raises DescriptionError unless the columns are those of the model."""
        tree = model.system.tree
        labels = tuple(c.label for c in tree.q)
        if self.q_labels != labels:
            raise DescriptionError(
                f"the motion's q has the columns {shorten(', '.join(self.q_labels), 200)}; {model.name} has "
                f"{shorten(', '.join(labels), 200)}: record the motion again with this description"
            )
        sizes = {"v": (self.v, len(tree.v)), "u": (self.u, len(model.system.drives))}
        sizes["reactions"] = (self.reactions, 6 * len(model.mechanism.joints))
        for name, (array, columns) in sizes.items():
            if array is not None and array.shape[1] != columns:
                raise DescriptionError(
                    f"the motion's {name} has {array.shape[1]} columns; {model.name} needs {columns}"
                )


def read_mechanism_and_motion(name_or_path: str) -> tuple[Mechanism, RecordedMotion | None]:
    """A mechanism by its name or file, or a recorded motion (.npz) and the mechanism that moved.

    Raises:
        DescriptionError: neither, or the file does not hold what its name says.
    """
    if name_or_path.endswith(".npz"):
        motion = read_motion(name_or_path)
        return motion.mechanism, motion
    return catalogue.find(name_or_path), None


def read_motion(path: str | Path) -> RecordedMotion:
    """The motion in the file at `path`.

    Raises:
        DescriptionError: the file cannot be read, lacks an array, or its arrays do not fit together.
    """
    file = Path(path)
    arrays = read_archive(file, (*NEEDED, "u", "u_labels", "reactions", "scene"))
    missing = [name for name in NEEDED if name not in arrays]
    if missing:
        raise DescriptionError(f"{file.name}: expected the arrays {', '.join(NEEDED)}; missing: {', '.join(missing)}")
    return _motion(file.name, arrays)


def _motion(name: str, arrays: dict[str, Array]) -> RecordedMotion:
    text = arrays["mechanism"]
    if text.shape != () or text.dtype.kind != "U":
        raise DescriptionError(f"{name}: `mechanism` must be one text: a TOML description or a name of the catalogue")
    given = str(text)
    mechanism = catalogue.load(given) if given in catalogue.names() else parse_description(given)
    t = _numbers(name, "t", arrays, (-1,))
    assert t is not None
    if len(t) < 2 or not (np.diff(t) > 0).all():
        raise DescriptionError(f"{name}: `t` must hold at least two increasing times")
    q, v, u, reactions = (_numbers(name, key, arrays, (len(t), -1)) for key in ("q", "v", "u", "reactions"))
    assert q is not None and v is not None
    q_labels = _texts(name, "q_labels", arrays, q.shape[1])
    u_labels = _texts(name, "u_labels", arrays, u.shape[1]) if u is not None and "u_labels" in arrays else ()
    scene = str(arrays["scene"]) if "scene" in arrays and arrays["scene"].dtype.kind == "U" else ""
    return RecordedMotion(mechanism, t, q, v, u, reactions, q_labels, u_labels, scene=scene)


def _numbers(name: str, key: str, arrays: dict[str, Array], shape: tuple[int, ...]) -> Array | None:
    """A finite array of the shape (-1: any), or None if it is not there."""
    if key not in arrays:
        return None
    array = arrays[key]
    fits = array.ndim == len(shape) and all(want in (-1, n) for want, n in zip(shape, array.shape, strict=True))
    if array.dtype.kind not in "fiu" or not fits:
        wanted = " x ".join("any" if n < 0 else str(n) for n in shape)
        raise DescriptionError(f"{name}: `{key}` must hold numbers, {wanted}, got {array.dtype} {array.shape}")
    if not np.isfinite(array).all():
        raise DescriptionError(f"{name}: `{key}` holds values that are not finite")
    return np.asarray(array, dtype=float)


def _texts(name: str, key: str, arrays: dict[str, Array], count: int) -> tuple[str, ...]:
    array = arrays[key]
    if array.dtype.kind != "U" or array.shape != (count,):
        raise DescriptionError(f"{name}: `{key}` must hold {count} texts, got {array.dtype} {array.shape}")
    return tuple(str(text) for text in array)
