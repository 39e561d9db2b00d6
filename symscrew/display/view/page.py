"""The page: a template, its style and scripts, the bundled 3-D library, the model's functions and data, in one file.

The page asks the network for nothing; its content security policy forbids it.
"""

from __future__ import annotations

import html
import json
import re
import tempfile
import webbrowser
from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.display.view.motion_file import RecordedMotion
from symscrew.display.view.page_data import functions_of, page_scene
from symscrew.display.view.reaches import Reach
from symscrew.display.view.run_time_shape import with_outline
from symscrew.export import print_script
from symscrew.model import Model
from symscrew.whole_files import replaced

SCRIPTS = (
    "screws.js", "kinematics.js", "shapes.js", "layers.js", "stage.js", "panel.js", "plots.js", "records.js", "main.js",
)  # fmt: skip
LIBRARY = "library.min.js"


Limits = Mapping[str, Reach]
Pictures = Mapping[str, Any]
"""Body -> triangles (n, 3, 3) [m]."""


def make_page(
    model: Model,
    motion: RecordedMotion | None = None,
    limits: Limits | None = None,
    *,
    pictures: Pictures | None = None,
    modes: Mapping[str, np.ndarray] | None = None,
) -> str:
    """The page of a model as text, with a recorded motion if there is one.

    `limits`: reaches of joints by their names [rad or m], beside those of the model's end stops.
    `pictures`: triangles that bodies look like, in absolute axes in the reference configuration.
    `modes`: configurations (nq,) of assembly modes by name, for a chooser.

    Raises:
        DescriptionError: the motion or a limit does not belong to this model.
    """
    model = with_outline(model)
    scene = page_scene(model, motion, limits, pictures=pictures, modes=modes)
    data = json.dumps(scene, ensure_ascii=False, allow_nan=False)
    parts = {
        "title": html.escape(model.name),
        "style": _file("page", "page.css"),
        "data": data.replace("<", "\\u003c"),
        "licences": _in_script(_file("assets", "LICENSE")),
        "library": _file("assets", LIBRARY),
        "functions": _in_script(print_script(model, "functions", functions_of(model))),
        "scripts": "\n".join(f"<script>\n{_file('page', name)}</script>" for name in SCRIPTS),
    }
    return re.sub(r"<!-- insert (\w+) -->", lambda found: parts[found.group(1)], _file("page", "page.html"))


def write_made(page: str, path: str | Path) -> Path:
    """Write a page that is made; the file is there whole or not at all. Raises OSError where it cannot be written."""
    return replaced(Path(path), lambda part: part.write_text(page, encoding="utf-8"))


def open_made(page: str, name: str) -> Path:
    """Write a page that is made into a new temporary directory and open it in the browser, if there is one."""
    file = write_made(page, Path(tempfile.mkdtemp(prefix="symscrew_view_")) / f"{name}.html")
    webbrowser.open(file.as_uri())
    return file


def _file(*parts: str) -> str:
    return resources.files("symscrew.display.view").joinpath(*parts).read_text(encoding="utf-8")


def _in_script(text: str) -> str:
    """A script whose comments cannot end the element it stands in."""
    return text.replace("</", "<\\/").replace("<!--", "<\\!--")
