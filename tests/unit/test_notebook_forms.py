"""How objects look: one line each at the prompt, tables and formulas in a notebook; texts of a user are no markup."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest
import sympy
from support.model_states import model

from symscrew import notebook
from symscrew.assembly import assembly_modes
from symscrew.functions import Quantities
from symscrew.functions.quantities import without_noise
from symscrew.mobility import analyse_mobility
from symscrew.results import Columns

LONGEST = 250  # characters of a line at the prompt; a terminal shows it in three lines at most


def parts_of(thing: Any, depth: int, seen: dict[int, Any]) -> Iterator[Any]:
    """A thing and what its public attributes and items hold of the package's own, this many steps away."""
    if id(thing) in seen or depth < 0:
        return
    seen[id(thing)] = thing  # kept, so that no other gets its number
    if type(thing).__module__.startswith("symscrew"):
        yield thing
    values: list[Any] = []
    if isinstance(thing, dict):
        values = list(thing.values())[:50]
    elif isinstance(thing, (tuple, list)):
        values = list(thing)[:50]
    elif type(thing).__module__.startswith("symscrew"):
        values = [value for name, value in getattr(thing, "__dict__", {}).items() if not name.startswith("_")]
    for value in values:
        yield from parts_of(value, depth - 1, seen)


def test_one_line_at_the_prompt() -> None:
    four_bar = model("four_bar")
    known = [four_bar, four_bar.mechanism, analyse_mobility(four_bar.mechanism), Quantities(four_bar.mechanism)]
    known.append(Quantities(four_bar.mechanism).twist("coupler"))
    seen: dict[int, Any] = {}
    found: dict[str, list[str]] = {}
    for thing in known:
        for part in parts_of(thing, 3, seen):
            found.setdefault(type(part).__name__, []).append(repr(part))
    assert len(found) > 25, sorted(found)
    long = {
        name: texts[0][:100]
        for name, texts in found.items()
        if name not in INSIDE and any("\n" in text or len(text) > LONGEST for text in texts)
    }
    assert long == {}


def test_assembly_modes_are_one_line_and_a_table() -> None:
    modes = assembly_modes(model("four_bar").mechanism, {"A": 0.3})
    shown = [repr(modes), repr(modes.modes[0])]
    assert all("\n" not in line and len(line) < 100 for line in shown), shown
    rows = modes._repr_html_()
    assert rows.count("<tr>") == 1 + len(modes.modes) == 3 and modes.modes[1].name in rows


INSIDE = {"Node"}
"""Of the tape's inside: shown as what they are for whoever works on it."""


def test_formulas_in_a_notebook() -> None:
    quantity = Quantities(model("four_bar").mechanism).joint_screws("B")
    symbols = {symbol: text for symbol, text, _, _ in quantity.symbols}
    assert sympy.latex(quantity) == sympy.latex(quantity.substituted(), symbol_names=symbols)
    shown = quantity._repr_latex_()
    assert shown.startswith("$$") and shown.endswith("$$") and quantity.latex() in shown


def test_rounding_of_zero_is_never_printed() -> None:
    x = sympy.Symbol("x")
    tiny, small = sympy.Float("-1.9e-62", 60), sympy.Float("1e-12", 60)
    assert without_noise(sympy.cos(x) + tiny * x) == sympy.cos(x)
    assert without_noise(small * x) == small * x and without_noise(tiny * x) == 0


class _Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags.append(tag)

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.mark.parametrize(
    "hostile", ['<script>alert("1")</script>', "</table><img src=x onerror=alert(1)>", "a & b < c"]
)
def test_texts_of_a_user_are_never_markup(hostile: str) -> None:
    four_bar = model("four_bar").mechanism
    shown = [
        notebook.table(hostile, ("a", "b"), [(hostile, 1)]),
        notebook.lines(hostile, [hostile]),
        replace(four_bar, description=hostile)._repr_html_(),
        Columns(hostile, np.zeros(1), {hostile: np.zeros(1)}, {hostile: hostile})._repr_html_(),
    ]
    for text in shown:
        parsed = _Tags()
        parsed.feed(text)
        assert set(parsed.tags) <= {"table", "caption", "thead", "tbody", "tr", "td", "th", "p", "b", "pre"}
        assert hostile in parsed.text, "and they are shown as they were written"


def test_long_tables_say_what_follows() -> None:
    text = notebook.table("rows", ("number",), [(str(k),) for k in range(100)])
    assert text.count("<tr>") == notebook.MOST_ROWS + 2 and "... 40 more" in text


def test_models_and_mobility_have_tables() -> None:
    four_bar = model("four_bar")
    assert "inverse_dynamics" in four_bar._repr_html_() and json.dumps(four_bar._repr_html_())
    assert "mobility 1" in analyse_mobility(four_bar.mechanism)._repr_html_()
