"""What calls show: a page in 3-D and a picture, in a notebook, the browser or a file.

mechanism, model or run --show_page--> Page        mechanism --draw--> Picture
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from symscrew import notebook
from symscrew.description import Mechanism
from symscrew.display.view import Limits, Pictures, RecordedMotion, make_page, open_made, page_modes, write_made
from symscrew.errors import DescriptionError, expect
from symscrew.model import Model, derive

PICTURES = (".png", ".pdf", ".svg")  # ends of names of files that a picture can be written into


class Moved(Protocol):
    """A motion of a model: of a run, of drives. t (n,) [s], q (n, nq), v (n, nv), u (n, nu), reactions or None."""

    @property
    def model(self) -> Model:
        """What moved."""

    @property
    def t(self) -> np.ndarray:
        """Times."""

    @property
    def q(self) -> np.ndarray:
        """Configurations."""

    @property
    def v(self) -> np.ndarray:
        """Rates."""

    @property
    def u(self) -> np.ndarray:
        """Drives."""

    @property
    def reactions(self) -> np.ndarray | None:
        """(n, 6 joints), the columns of the joints one after another."""


@dataclass(frozen=True, repr=False)
class Page:
    """A mechanism in 3-D, with a motion if there is one; a notebook shows it, `open` a browser, `save` writes it."""

    model: Model
    motion: RecordedMotion | None = None
    limits: Limits | None = None
    pictures: Pictures | None = None
    modes: Mapping[str, np.ndarray] | None = None

    def __repr__(self) -> str:
        return f"Page({self.model.name}{'' if self.motion is None else f', {len(self.motion.t)} states'})"

    @cached_property
    def text(self) -> str:
        """The page, one HTML document that asks the network for nothing."""
        return make_page(self.model, self.motion, self.limits, pictures=self.pictures, modes=self.modes)

    def save(self, path: str | Path) -> Path:
        """Write the page into a file. Raises OSError where that cannot be written."""
        return write_made(self.text, path)

    def open(self) -> Path:
        """Open the page in the browser; the file it stands in, in a new temporary folder."""
        return open_made(self.text, self.model.name)

    def _repr_html_(self) -> str:
        return notebook.framed(self.text, self.model.name)


@dataclass(frozen=True, repr=False)
class Picture:
    """A drawing: a notebook shows it, `save` writes it; `figure` is matplotlib's."""

    name: str
    figure: Any

    def __repr__(self) -> str:
        width, height = self.figure.get_size_inches()
        return f"Picture({self.name}, {width:g} x {height:g} inches)"

    def save(self, path: str | Path) -> Path:
        """Write .png, .pdf or .svg; equal pictures give equal bytes.

        Raises:
            DescriptionError: the name ends in something else.
        """
        from symscrew.display.plots import save_figure

        file = Path(path)
        if file.suffix not in PICTURES:
            raise DescriptionError(f"expected a file name that ends in {', '.join(PICTURES)}, got {file.name!r}")
        return save_figure(self.figure, file, tight=True)

    def _repr_png_(self) -> bytes:
        from symscrew.display.plots import curve_style

        content = io.BytesIO()
        with curve_style():
            self.figure.savefig(content, format="png", dpi=110, bbox_inches="tight")  # as wide as a notebook's column
        return content.getvalue()


def show_page(
    subject: Mechanism | Model | Moved,
    motion: RecordedMotion | None = None,
    *,
    limits: Limits | None = None,
    pictures: Pictures | None = None,
    modes: bool = False,
) -> Page:
    """The page in 3-D of a mechanism or model, or of a motion: a run, or what `drives` found.

    Outside of a notebook it is opened in the browser as well; in one, it shows itself. `limits`: how far joints may go,
    {"limb1_P": (-0.05, 0.1)} [rad or m], drawn and kept beside the end stops among the effects.
    `pictures`: triangles that bodies look like, `symscrew.formats.mesh_pictures("robot.urdf").triangles`.
    `modes`: with a chooser of all assembly modes at the reference.

    Raises:
        DescriptionError: the motion does not belong to the model; there are no modes.
    """
    if isinstance(subject, Mechanism):
        made = Page(derive(subject), motion, limits, pictures)
    elif isinstance(subject, Model):
        made = Page(subject, motion, limits, pictures)
    else:
        if not hasattr(subject, "model"):
            expect(subject, Mechanism, Model)
        made = Page(subject.model, recorded(subject), limits, pictures)
    if modes:
        made = replace(made, modes=page_modes(made.model))
    if not notebook.here():
        made.open()
    return made


def recorded(moved: Moved) -> RecordedMotion:
    """A motion as the page takes it."""
    model = moved.model
    labels = tuple(c.label for c in model.system.tree.q)
    drives = next((p.labels for p in model.programs["inverse_dynamics"].outputs if p.name == "u"), ()) if (
        "inverse_dynamics" in model.programs) else ()  # fmt: skip
    u = moved.u if moved.u.shape[1] and len(drives) == moved.u.shape[1] else None
    reactions = moved.reactions
    flat = None if reactions is None else reactions.reshape(len(moved.t), -1)
    return RecordedMotion(
        model.mechanism, moved.t, moved.q, moved.v, u, flat, labels, tuple(drives) if u is not None else ()
    )


def draw(
    mechanism: Mechanism, *, elevation: float | None = None, azimuth: float | None = None, labels: bool = True
) -> Picture:
    """A picture of a mechanism in its reference configuration; needs matplotlib.

    Args:
        mechanism: what to draw.
        elevation: of the viewer above the x-y plane [degrees]; default: along the axes of a planar mechanism, else 20.
        azimuth: of the viewer about z, from x [degrees]; default: likewise, else -62.
        labels: whether joints and points have their names.
    """
    expect(mechanism, Mechanism)
    from symscrew.display.drawing import mechanism_figure

    figure = mechanism_figure(mechanism, elevation=elevation, azimuth=azimuth, labels=labels)
    return Picture(mechanism.name, figure)
