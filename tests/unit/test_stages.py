"""Headings of generated code: which limb, which stage of the theory; what pivots mean."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace

import pytest
from support.model_states import model

from symscrew.algebra import QUANTITIES, Origin
from symscrew.export.c import print_source
from symscrew.export.javascript import print_javascript
from symscrew.export.numpy import print_numpy
from symscrew.export.pivots import pivot_text
from symscrew.export.stages import MOST, STAGE_OF, STAGES, Stages, headed
from symscrew.export.value_names import value_names
from symscrew.program import Instruction, Port, Program
from symscrew.program.equal_limbs import Limb, Limbs

LIMBS = Limbs(((Limb("one", {"upper": "link"}), Limb("two", {"lower": "link"})),))


def program(*lines: tuple[str, str, tuple[int, ...]]) -> Program:
    """One input; slots 1, 2, ... with (quantity, part, operands), nameless where the quantity is empty."""
    instructions = tuple(Instruction(k, "add", args) for k, (_, _, args) in enumerate(lines, 1))
    origins = {k: Origin(quantity, part) for k, (quantity, part, _) in enumerate(lines, 1) if quantity}
    port = Port("x", (1,), ("1",), ("x",), "")
    return Program("f", "", (port,), (), instructions, (), (), (), len(lines) + 1, origins, LIMBS)


def test_every_quantity_is_of_one_stage() -> None:
    assert set(QUANTITIES) <= set(STAGE_OF)
    assert max(Counter(word for words in STAGES.values() for word in words.split()).values()) == 1


def shown(found: Program) -> list[str]:
    names = value_names(found, ())
    lines = [(f"{names[i.target]} = ...;", i.target) for i in found.instructions]
    return list(headed(lines, Stages(found), lambda slot: names[slot]))


def test_a_heading_where_a_limb_or_a_stage_begins_and_nowhere_else() -> None:
    first = [("omega", "upper", (0, 0))] * MOST
    second = [("momentum_rate", "upper", (1, 0))] * MOST
    other = [("omega", "lower", (0, 0))] * MOST
    heads = [text for text in shown(program(*first, *second, *other)) if text.startswith("/*")]
    assert heads == [
        "/* one: velocities, eq. (6) */", "/* one: momentum rate, eq. (35) */", "/* two: velocities, eq. (6) */",
    ]  # fmt: skip
    few = other[1:]
    heads = [text for text in shown(program(*first, *few, *first)) if text.startswith("/*")]
    assert heads == ["/* one: velocities, eq. (6) */"]


def test_a_nameless_line_of_another_limb_says_so() -> None:
    """It is of the limb of its operands; with operands of two limbs, of that of its reader."""
    own = [("omega", "upper", (0, 0))] * MOST
    further = [("omega", "lower", (0, 0)), ("", "", (9, 9)), ("", "", (1, 10)), ("alpha", "lower", (11, 11))]
    text = shown(program(*own, *further))
    assert [line.partition("/* ")[2] for line in text[-3:]] == ["two */", "two */", ""]
    assert all("/*" not in line for line in text[1:-3])


def test_a_nameless_line_that_several_limbs_read_is_of_none() -> None:
    """It is made of both limbs, and both read it: not of the one that reads it first."""
    own = [("omega", "upper", (0, 0))] * MOST
    hub = [("omega", "lower", (0, 0)), ("", "", (1, 9))]
    first = [("alpha", "upper", (10, 10))]
    for readers, said in ((first, [""]), ([*first, ("alpha", "lower", (10, 10))], ["", "mechanism */"])):
        text = shown(program(*own, *hub, *readers))
        (line,) = (line for line in text if re.match(r"t\d+ ", line))
        assert line.partition("/* ")[2] == said[-1]


@pytest.mark.parametrize("name", ["four_bar", "slider_crank"])
def test_no_statement_changes(name: str) -> None:
    """Headings are comments: without them the code is what it is without origins, but for the names."""
    found = model(name)
    function = next(f for f, p in found.programs.items() if isinstance(p, Program) and p.guards)
    part = found.programs[function]
    assert isinstance(part, Program)
    texts = []
    for programs in (part, replace(part, origins={})):
        source = print_source(replace(found, programs={function: programs}))
        body = source.partition(f"BODY({name}_{function})")[2].partition("\n}")[0]
        text = re.sub(r"\b[A-Za-z]\w*_\w*|\bt\d+", "x", re.sub(r"\s*/\*.*?\*/", "", body))
        texts.append(
            re.sub(r"(const REAL|,)\s+x = |;\s+const REAL x = ", ", x = ", text)
        )  # which share a line is no matter
    assert texts[0] == texts[1]


def test_pivots_are_told_in_words() -> None:
    assert pivot_text(Origin("lever", "limb2_U.0", "moment_z", "limb2_S.fz")) == (
        "where the reciprocal wrench limb2_S.fz has no power along limb2_U.0, as in a stretched limb"
    )
    assert pivot_text(Origin("pivot", "hub", "wz")) == "where the loops no longer determine hub.wz"
    assert pivot_text(Origin("pivot", "", "1")).startswith("where step 1 of symmetric equations loses rank")
    assert pivot_text(None) and "{" not in "".join(pivot_text(Origin(q, "p", "c", "b")) for q in QUANTITIES)


@pytest.mark.parametrize("name", ["four_bar", "slider_crank"])
def test_every_pivot_of_a_function_has_a_name_and_a_meaning(name: str) -> None:
    source = print_source(model(name))
    tests = re.findall(r"^        SMALL\((\w+), [^)]*\)(.*(?:\n +/\*.*)?)$", source, re.M)  # words may have a line
    assert tests and all(re.search(r"/\* where .* \*/$", rest) for _, rest in tests)
    assert not [pivot for pivot, _ in tests if re.fullmatch(r"t\d+", pivot)]


def computed(text: str) -> set[str]:
    """Names of more than one word that get the value of an operation; statements may take several lines."""
    code = re.sub(r"/\*.*?\*/|(#|//)[^\n]*", "", text, flags=re.DOTALL)
    lines = re.sub(r"(= \(| [-+*/])\n +", r"\1 ", code)
    return set(re.findall(r"\b([A-Za-z]+\w*_\w*) = [^;\n]* [-+*/] ", lines))


def test_every_language_has_the_names_and_the_headings() -> None:
    """What NumPy and JavaScript compute has the names that C gives it, under headings of the same stages."""
    found = model("four_bar").only(["inverse_dynamics"])
    source = print_source(found)
    (python,), (script,) = print_numpy(found).values(), print_javascript(found).values()
    texts = (source.partition("BODY(")[2].partition("\n}")[0], python, script)
    c, numpy, javascript = map(computed, texts)
    program = found.programs["inverse_dynamics"]
    assert isinstance(program, Program)
    assert numpy == javascript and c | numpy <= set(value_names(program, ()).values()) and len(c & numpy) > 5
    told = [re.findall(rf"^ +{mark} (\w+: .*)$", text, re.M) for text, mark in ((python, "#"), (script, "//"))]
    assert told[0] and told[0] == told[1]
