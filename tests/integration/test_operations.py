"""Operations of the generated code: none has risen, growth, the recorded counts, and the counting itself.

Counts are deterministic: one that rises is a change of the derivation, and needs a reason.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from benchmarks.mechanisms import chain, platform
from support.marks import slow
from support.model_states import differentiated, model
from support.operation_counts import recorded as recorded_counts
from support.operation_counts import rise

from symscrew import catalogue
from symscrew.export.c import print_source
from symscrew.generation.folder import render
from symscrew.model import Model, derive
from symscrew.program.straight_line import Iteration

pytestmark = pytest.mark.slow

GENERATED = Path(__file__).parents[2] / "generated"
QUICK = ("three_ups_upu_s_physical", "five_bar", "four_bar", "ur5")


def total(found: Model, function: str) -> int:
    assert function in found.programs, f"{found.name} has no function {function}; it has {list(found.programs)}"
    return found.programs[function].operations["total"]


@pytest.mark.parametrize("name", catalogue.names())
def test_no_count_has_risen(name: str) -> None:
    assert rise("plain", name, model(name)) == {}


@pytest.mark.parametrize("name", [name if name in QUICK else slow(name) for name in catalogue.names()])
def test_no_count_of_derivatives_has_risen(name: str) -> None:
    assert rise("derivatives", name, differentiated(name)) == {}


@cache
def sized(kind: str, size: int) -> Model:
    return derive({"platform": platform, "chain": chain}[kind](size))


# Doubling the limbs doubles the work at most; in a chain the first joints cost less than all later ones: twists of 4,
# 8, 12, 16 and 20 joints take 84, 285, 487, 687 and 887 operations.
@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "small", "functions", "factor"),
    [
        ("platform", 4, ("inverse_dynamics", "joint_reactions", "body_poses", "body_twists", "body_twist_rates"), 2.1),
        ("platform", 4, ("mass_matrix",), 4.0),
        ("chain", 8, ("inverse_dynamics", "joint_reactions", "body_poses"), 2.4),
        ("chain", 8, ("body_twists", "body_twist_rates"), 2.5),
        ("chain", 8, ("mass_matrix",), 4.4),
    ],
)
def test_growth(kind: str, small: int, functions: tuple[str, ...], factor: float) -> None:
    for function in functions:
        before, after = (total(sized(kind, size), function) for size in (small, 2 * small))
        assert after <= recorded_counts("sized", f"{kind} {2 * small}")[function]
        assert after <= factor * before, f"{function}: {before} operations grow to {after}"


@pytest.mark.slow
def test_every_further_joint_and_limb_costs_the_same() -> None:
    """Linear, not only nearly so: equal steps of the size cost equal operations.

    Limbs stand on a regular polygon, whose coordinates repeat more or less often by the number of corners:
    by fours alike.
    """
    for kind, sizes in (("chain", (8, 12, 16)), ("platform", (4, 8, 12))):
        for function in ("inverse_dynamics", "joint_reactions", "body_twists"):
            a, b, c = (total(sized(kind, size), function) for size in sizes)
            assert c - b == pytest.approx(b - a, rel=0.03), (kind, function)


def recorded() -> list[Path]:
    found = sorted(GENERATED.glob("*/ops.json"))
    assert found, "no generated/*/ops.json: run symscrew generate"
    return found


@pytest.mark.slow
def test_counts_are_the_committed_ones() -> None:
    for path in recorded():
        now = json.loads(render(model(path.parent.name), ())["ops.json"])
        then = json.loads(path.read_text(encoding="utf-8"))
        changed = {f: (then.get(f), now.get(f)) for f in {*then, *now} if then.get(f) != now.get(f)}
        assert not changed, f"{path.parent.name}: generate again and commit, if this is meant: {changed}"


# -- the counting rule, by reading the printed C ---------------------------------------------------------

TOKEN = re.compile(
    r"(?P<number>\d+\.?\d*(?:[eE][+-]?\d+)?)|(?P<name>[A-Za-z_]\w*)|(?P<operator>\|\||&&|[<>=!]=|[-+*/<>!?:()\[\]{},;=&])|\s+"
)
COUNTS = dict.fromkeys(("sin", "cos", "tan", "atan2", "exp", "SQRT", "ABS", "LESS", "SELECT"), 1)
COUNTS |= {f"SQRT{n}": 1 for n in range(2, 9)} | {f"SMALL{n}": 2 * n for n in range(2, 9)}
COUNTS |= {
    "SMALL": 2,
    **{f"FINITE{n}": 1 for n in ("", *range(2, 9))},
    **{f"FINITE_UNLESS{n}": 1 for n in ("", *range(2, 9))},
    "RESULT": 1,
    "FOUR": 3,
    "NOT_BELOW": 1,
    "NOT_ABOVE": 1,
}  # RESULT adds to a sum


def count_c(source: str, symbol: str, *, signs: bool = True) -> int:
    """Operations of a printed function: + - * / and signs, macros of operations, calls of the library.

    One for each, as executed when nothing fails. A comparison with its choice is one operation; the choice of the
    status is not one. A negative constant is no operation. Four entries that are added at once are three sums. A sine
    is one, however often it is read. `signs`: with negations.
    """
    bodies = re.findall(rf"^BODY\({symbol}\)\([^;{{]*\n?\{{\n(.*?)^\}}", source, re.M | re.S)
    assert len(bodies) == 1, f"no body {symbol}"
    count = count_statements(bodies[0], source, signs=signs) + count_angles(source, symbol)
    calls = Counter(re.findall(r"^    (?:FIRST|NEXT)_LIMB\(\d, (\w+), (\d),", bodies[0], re.M))
    sines = sines_of(bodies[0])
    for (function, number), times in calls.items():
        (text,) = re.findall(rf"^STAGE\({function}, {number}\)\([^;{{]*\n?\{{\n(.*?)^\}}", source, re.M | re.S)
        count += times * count_statements(text, source, signs=signs) + signs * count_negated(text)
        sines |= sines_of(text)
    return count + len(sines)


# Negations more than in the program, of all its operations: what limbs hand on up to a sign is turned where it is read
# alone. Everything else is equal.
HANDED_ON = 0.015


def sines_of(text: str) -> set[tuple[str, int]]:
    """The sines and cosines that a text reads: each is taken once, however often it is read."""
    found = {(array, int(k)) for array, k in re.findall(r"SINES\((\w+), (\d+)\)", text)}
    each = re.findall(r"IN_EACH(\d)\(SINES, (\w+), (\d+), (\d+)\)", text)
    return found | {(array, int(k) + int(step) * n) for limbs, array, k, step in each for n in range(int(limbs))}


def count_statements(text: str, source: str, *, signs: bool) -> int:
    """Operations of the statements of a body, or of a stage for one limb: signs that limbs differ in are none."""
    count, constants = 0, set(re.findall(r"^    (\w+) = [\d.e+-]+[,;] /\*", source, re.M))
    text = re.sub(r"\(void\)\w+;|/\*.*?\*/|own->|-?\bsign\d+ \* ", "", text, flags=re.S)
    for statement in re.sub(r"const NUMBER\d .*?;", "", text, flags=re.S).split(";"):
        right = statement.split(" = ", 1)[-1]
        before = "="
        tokens = [m for m in TOKEN.finditer(right) if not m[0].isspace()]
        for position, token in enumerate(tokens):
            following = tokens[position + 1][0] if position + 1 < len(tokens) else ""
            unary = before in ("=", "(", ",", "*", "/", "+", "-", "<", "{")
            if token["name"]:
                count += COUNTS.get(token["name"], 0)
            elif token[0] in "+-" and unary:
                count += signs and not (re.match(r"[\d.]", following) or following in constants)
            elif token[0] in ("+", "-", "*", "/"):
                count += 1
            before = token[0]
    return count


def count_negated(stage: str) -> int:
    """Results that a stage stores with the opposite sign, over all limbs: nothing is there to add them to."""
    signs = {name: values.count("-1.0") for name, values in re.findall(r"(sign\d+) = OF\d\(([^)]*)\)", stage)}
    limbs = {name: values.count(",") + 1 for name, values in re.findall(r"(sign\d+) = OF\d\(([^)]*)\)", stage)}
    stored = re.findall(r"WRITE\d\([^;]*?, (-?)(sign\d+) \* [^;]*;", stage)
    return sum(limbs[name] - signs[name] if minus else signs[name] for minus, name in stored)


def count_angles(source: str, symbol: str) -> int:
    """Operations of the angles whose sines a function takes first."""
    text = source[source.index(f"int {symbol}(") :]
    called = re.search(r"\w+_sines\d+(?=\()", text[: text.index("\n}")])
    if called is None:
        return 0
    text = source[source.index(f"void {called[0]}(") :]
    angles = re.search(r"\w+_angles\d+(?=\()", text)
    assert angles is not None
    text = source[source.index(f"void {angles[0]}(") :]
    return len(re.findall(r"^    const double angle\d+ =", text[: text.index("\n}")], re.M))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["three_ups_upu_s", "four_bar", "delta", "ur5"])
def test_counted_operations_are_the_printed_ones(name: str) -> None:
    """Of every function of a small loop and of an arm; of platforms those that have what these have not."""
    found = model(name)
    if name in ("three_ups_upu_s", "delta"):
        found = found.only(["inverse_dynamics_platform", "forward_dynamics", "inverse_kinematics", "limb_margins"])
    source = print_source(found)
    wrong = {}
    for function, program in found.programs.items():
        if not isinstance(program, Iteration):
            total, negations = program.operations["total"], sum(i.op == "neg" for i in program.instructions)
            printed = count_c(source, f"{name}_{function}", signs=False)
            if printed != total - negations or count_c(source, f"{name}_{function}") > total + HANDED_ON * total:
                wrong[function] = (printed, total - negations)
    assert not wrong, f"printed and counted operations differ: {wrong}"
