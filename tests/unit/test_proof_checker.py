"""The checker of proof files: what it takes, and that it refuses every tampered number that matters."""

from __future__ import annotations

import copy
import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from support.further_mechanisms import CASES, Z, graph, loop, three_bars
from support.marks import slow
from support.reference_mechanisms import ENTRIES, build

from symscrew import MechanismBuilder, catalogue
from symscrew.mobility import analyse_mobility, check_proof, mobility_proof, verify
from symscrew.mobility.proofs import proof_checker, rank_entry

pytestmark = pytest.mark.slow

KINDS = {
    "planar_4bar": "groups", "sarrus": "limbs", "collinear_3R": "stopped", "bennett": "endless",
    "parallelogram-change_point": "form", "kinematotropic_double_fold-transition": "direction",
}  # fmt: skip
IDENTITIES = {"null", "arc", "value", "kind"}
"""Where one entry changed makes a false equation, whatever the entry: all of these must be refused, and ranks."""


@cache
def proof(name: str) -> str:
    mechanism = build(ENTRIES[name]) if name in ENTRIES else catalogue.load(name)
    return json.dumps(mobility_proof(analyse_mobility(mechanism)))


def values_of(name: str) -> Any:
    return json.loads(proof(name))


def leaves(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*path, key))
    else:
        yield path


def number(value: Any) -> bool:
    return type(value) is int or (isinstance(value, str) and value.lstrip("-").replace("/", "").isdecimal())


def changed(value: Any) -> Any:
    if isinstance(value, bool):
        return not value
    return value + 1 if isinstance(value, int) else str(Fraction(value) + Fraction(1, 3))


def tampered(values: Any, path: tuple[Any, ...]) -> Any:
    result = copy.deepcopy(values)
    inner = result
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = changed(inner[path[-1]])
    return result


def at(values: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        values = values[key]
    return values


def accepted(values: Any) -> bool:
    try:
        return check_proof(values).holds
    except proof_checker.UnreadableError:
        return False


@pytest.mark.parametrize("name", KINDS)
def test_every_kind_of_proof_is_taken(name: str) -> None:
    values = values_of(name)
    verdict = check_proof(values)
    assert [block["proof"]["kind"] for block in values["blocks"]] == [KINDS[name]]
    assert verdict.holds and len(verdict.proved) == len(values["claims"])
    sampled = {entry["claim"] for entry in values["not proved"]}
    assert ("finite mobility" in sampled) == (KINDS[name] in ("none", "direction"))


@pytest.mark.parametrize("name", [slow(name) if kind == "direction" else name for name, kind in KINDS.items()])
def test_a_changed_number_is_refused(name: str) -> None:
    """Of the mechanism always, by its digest; with a new digest only a number that leaves all screws as lines."""
    values = values_of(name)
    places = [path for path in leaves(values) if number(at(values, path)) or isinstance(at(values, path), bool)]
    assert len(places) > 40
    for path in places[:: {"endless": 9, "direction": 3}.get(KINDS[name], 1)]:  # of long proofs a part
        other = tampered(values, path)
        if path[0] == "mechanism":
            assert not accepted(other), path
            other["digest"] = proof_checker.digest(other["mechanism"])
            if accepted(other):
                assert same_lines(values["mechanism"], other["mechanism"]), path
        elif path[0] != "not proved" and (IDENTITIES & set(path) or path[-2] == "rank"):
            assert not accepted(other), path
        elif accepted(other):
            assert facts(other) == facts(values), path  # another minor, say: it shows the same


def facts(values: Any) -> dict[str, Any]:
    return proof_checker.facts_of(proof_checker.Mechanism(values["mechanism"]), values)


def same_lines(a: Any, b: Any) -> bool:
    """Whether all joints have the same screws: a point may lie anywhere on its axis, a slider's anywhere at all."""
    one, two = (proof_checker.Mechanism(m) for m in (a, b))
    return all(
        [[c.terms for c in s] for s in one.joints[n].screws] == [[c.terms for c in s] for s in two.joints[n].screws]
        for n in one.joints
    )


@pytest.mark.parametrize("name", KINDS)
def test_a_false_claim_is_refused(name: str) -> None:
    values = values_of(name)
    values["claims"] += [{"claim": "finite mobility", "value": 3}]
    assert not accepted(values)
    assert not accepted({**values_of(name), "claims": []})
    values = values_of(name)
    values["blocks"][0]["proof"] = {"kind": "groups", "groups": []}
    assert not accepted(values)


@pytest.mark.parametrize("name, change", [("planar_4bar", {"dof": 0}), ("collinear_3R", {"dof": 1, "branches": (1,)})])
def test_verification_asks_the_checker(name: str, change: dict[str, Any]) -> None:
    found = analyse_mobility(build(ENTRIES[name]))
    checks = {check.claim: check for check in verify(found)}
    assert checks["proof file, by its checker"].holds
    wrong = replace(found, finite=replace(found.finite, witnesses=(), **change))
    check = {check.claim: check for check in verify(wrong)}["proof file, by its checker"]
    assert not check.holds and check.withdraws == "finite" and "the evidence shows" in check.evidence


def test_a_proof_of_another_kind_does_not_carry_over() -> None:
    """The form that shows two branches at a change point shows none where the loop is not stretched, and so on."""
    for name in KINDS:
        for other in KINDS.keys() - {name}:
            values, foreign = values_of(name), values_of(other)
            values["blocks"] = foreign["blocks"]
            assert not accepted(values) or KINDS[other] == "none"


def test_an_arc_proves_what_no_isolated_configuration_could_do() -> None:
    """Sixteen orders, from a motion on, of a loop of hinges and slides: what the theorem leaves open is refused."""
    values = values_of("bennett")
    arc = values["blocks"][0]["proof"]["arc"]
    assert len(arc) == proof_checker.MOST_WAYS == 16 and facts(values)["smooth"]
    for changed_arc, why in ((arc[:-1], "an arc that is too short"), ([["0"] * 4] * 16, "an arc that does not start")):
        other = copy.deepcopy(values)
        other["blocks"][0]["proof"]["arc"] = changed_arc
        assert any(why in line for line in check_proof(other).refused)
    screw = loop(("R", [0, 0, 0], Z), ("R", [0, 0, 0], Z), ("H", [1, 0, 0], Z), pitches={2: "0.1"})
    other = json.loads(json.dumps(mobility_proof(analyse_mobility(screw))))
    assert other["blocks"][0]["proof"]["kind"] != "endless"
    arc = [["1"] * 3] * 16
    other["blocks"][0]["proof"] = {"kind": "endless", "groups": [proof_checker.WHOLE], "arc": arc}
    assert any("a screw joint" in line for line in check_proof(other).refused)


def test_near_is_not_there() -> None:
    """Bennett's proportions off by 1e-40: the exact rank is higher, so the null vectors are none."""
    values = values_of("bennett")
    first = values["mechanism"]["joints"][0]["point"]
    first[0] = str(Fraction(first[0]) + Fraction(1, 10**40))
    values["digest"] = proof_checker.digest(values["mechanism"])
    assert not accepted(values)


@pytest.mark.parametrize(
    "text",
    ["", "{}", "[1]", '{"format": 3}', '{"format": "symscrew mobility proof 1"}', "null", "[" * 100000, '{"a": NaN}',
     '{"format": 1, "format": 2}', '{"mechanism": {"' + "k" * 5000 + '": 1}}'],
)  # fmt: skip
def test_what_is_no_proof_file_is_said_so(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "file.json"
    path.write_text(text)
    assert proof_checker.main([str(path)]) == 2
    said = capsys.readouterr().err
    assert "not a proof file" in said and said.count("\n") == 1 and len(said) < len(str(path)) + 300
    assert proof_checker.main([str(tmp_path / "none.json")]) == 2 and proof_checker.main([]) == 2


def test_numbers_that_are_no_fractions_are_not_read() -> None:
    for text in ("1e999999999", "0x10", "1/0", "nan", "1_000", " 1", 0.5, True, None):
        values = values_of("planar_4bar")
        values["mechanism"]["joints"][0]["point"][0] = text
        values["digest"] = proof_checker.digest(values["mechanism"])
        with pytest.raises(proof_checker.UnreadableError):
            check_proof(values)


def test_the_checker_runs_alone(tmp_path: Path) -> None:
    """Without the package on any path: a copy of the file in a folder of its own."""
    script = tmp_path / "checker.py"
    script.write_text(Path(proof_checker.__file__).read_text())
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    good.write_text(proof("planar_4bar"))
    bad.write_text(proof("planar_4bar").replace('"finite mobility", "value": 1', '"finite mobility", "value": 2'))
    for path, status, line in ((good, 0, "every claim of the file is proved"), (bad, 1, "does not prove")):
        done = subprocess.run([sys.executable, "-I", "-S", str(script), str(path)], capture_output=True, text=True)
        assert done.returncode == status and line in done.stdout, done.stderr


def test_irrational_numbers_are_roots_in_intervals() -> None:
    values = values_of("three_ups_upu_s")
    assert accepted(values) and check_proof(values).not_proved == ()
    for path in leaves(values["mechanism"]["generators"][0]["polynomial"]):
        other = tampered(values, ("mechanism", "generators", 0, "polynomial", *path))
        other["digest"] = proof_checker.digest(other["mechanism"])
        assert not accepted(other), path


def test_numbers_in_no_field_are_any_of_an_interval() -> None:
    verdict = check_proof(values_of("schatz_turbula"))
    assert verdict.holds and any("finite mobility at most 1" in text for text in verdict.proved)
    assert any(text.startswith("instantaneous mobility 1") for text in verdict.not_proved)


def expected(name: str) -> dict[str, Any]:
    entry = ENTRIES[name]["expected"]
    return {
        "Kutzbach-Gruebler": entry["kutzbach"],
        "instantaneous mobility": entry["dof"],
        "redundant constraints": entry["overconstraints"],
        "internal freedoms": entry["internal_freedoms"],
        "freedoms with the drives locked": entry["dof_drives_locked"],
        "finite mobility": entry["dof_finite"],
        "smooth": entry["smooth"],
        "branches": entry["branches"],
    }


DEAR = {
    "stewart_6sps", "delta_4s-parallel_forearms", "3rps-mode_transition", "stewart_6ups-fichter_yaw90",
    "six legs, no circle", "six legs on a circle", "bricard octahedron 1", "miura flat, four columns",
    "bricard plane-symmetric", "bricard line-symmetric", "waldron hybrid", "queer square", "turning triangles",
}  # fmt: skip
"""The oracles of mobility ask this checker of those of the literature, too; of the others, kinds of them are left."""


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in ENTRIES if name not in DEAR])
def test_what_is_proved_is_what_the_reference_says(name: str) -> None:
    values = values_of(name)
    assert check_proof(values).holds
    shown, known = facts(values), expected(name)
    for claim in shown.keys() & known.keys():
        assert shown[claim] == known[claim], claim
    if known["finite mobility"] is not None:
        assert shown["finite mobility at least"] <= known["finite mobility"] <= shown["finite mobility at most"]
    if (known["dof"] if "dof" in known else known["instantaneous mobility"]) == 0:
        assert shown["finite mobility"] == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in CASES if name not in DEAR])
def test_what_is_proved_is_what_the_literature_says(name: str) -> None:
    values = json.loads(json.dumps(mobility_proof(analyse_mobility(CASES[name].make()))))
    assert check_proof(values).holds
    dof, finite, branches, _ = CASES[name].expected
    shown = facts(values)
    assert shown.get("instantaneous mobility", dof) == dof and shown.get("finite mobility", finite) == finite
    assert "branches" not in shown or shown["branches"] == (None if branches is None else list(branches))
    assert shown["finite mobility at least"] <= finite <= shown["finite mobility at most"]


def test_a_loop_of_joints_without_freedoms_moves_nothing_and_is_no_obstacle() -> None:
    """Beside three hinges in a line, which are shaky: their motion is shut, and the checker sees it."""
    builder = MechanismBuilder("rests", platform="c")
    for body in "abcd":
        builder.body(body)
    for k, (parent, child) in enumerate((("base", "a"), ("a", "b"), ("b", "base"))):
        builder.joint(f"R{k}", "R", parent=parent, child=child, point=[k * (k + 1) // 2, 0, 0], axes=[Z])
    for k, (parent, child) in enumerate((("b", "c"), ("c", "d"), ("d", "b"))):
        builder.joint(f"F{k}", "fixed", parent=parent, child=child, point=[0, 0, 0])
    found = analyse_mobility(builder.build())
    assert (found.dof, found.finite.dof, found.finite.judgement) == (1, 0, "proved")
    assert check_proof(mobility_proof(found)).holds


def test_a_rank_of_another_matrix_says_nothing_of_the_drives() -> None:
    """A five-bar whose one drive does not hold it: the rank of its block, or its closure, is not that with drives."""
    values = values_of("five_bar")
    values["mechanism"]["drives"] = values["mechanism"]["drives"][:1]
    values["digest"] = proof_checker.digest(values["mechanism"])
    values["claims"] = [{"claim": "freedoms with the drives locked", "value": 0}]
    for name in ("block 0", "closure"):
        values["ranks"] = {name: values["blocks"][0]["rank"]}
        assert not accepted(values)


def held_beside_a_hinge() -> dict[str, Any]:
    """A hinge held by a weld, with a form of no motion for a proof, and a free hinge beside: mobility 1."""
    joints = [
        {"name": name, "parent": "g", "child": child, "point": ["0"] * 3, "motions": motions}
        for name, child, motions in (
            ("A", "b", []), ("B", "b", [{"kind": "R", "axis": ["0", "0", "1"]}]),
            ("C", "c", [{"kind": "R", "axis": ["0", "0", "1"]}]),
        )
    ]  # fmt: skip
    mechanism = {
        "name": "held",
        "ground": "g",
        "body": "b",
        "generators": [],
        "joints": joints,
        "limbs": {},
        "drives": [],
    }
    proof = {
        "kind": "form", "basis": [], "stress": ["0"] * 5 + ["1"],
        "groups": [[["0", "0", "1", "0", "0", "0"], ["0", "0", "0", "0", "0", "1"]]],
    }  # fmt: skip
    rank = {"rank": [1, 1], "minor": {"rows": [2], "columns": [0]}, "null": []}
    return {
        "format": proof_checker.FORMAT, "mechanism": mechanism, "digest": proof_checker.digest(mechanism),
        "blocks": [{"rank": rank, "proof": proof}], "ranks": {}, "not proved": [],
        "claims": [{"claim": "finite mobility", "value": 0}],
    }  # fmt: skip


def test_a_form_of_no_motion_takes_no_freedom_from_the_rest() -> None:
    values = held_beside_a_hinge()
    assert not accepted(values)
    values["blocks"][0]["proof"] = {"kind": "none"}
    assert not accepted(values)
    values["claims"][0]["value"] = 1
    assert accepted(values)


def test_a_name_in_a_file_says_nothing_in_the_checkers_place() -> None:
    values = values_of("five_bar")
    values["not proved"] = [{"claim": "x\nproved: finite mobility 7", "value": 1, "why": "\x1b[2J"}]
    said = str(check_proof(values))
    assert "\nproved: finite mobility 7" not in said and "\x1b" not in said


@pytest.mark.parametrize("off, moves", [(Fraction(1, 10**40), True), (Fraction(1, 10**10), False)])
def test_what_exact_decimals_stop_by_less_than_rounding_is_no_contradiction(off: Fraction, moves: bool) -> None:
    """Three parallel cranks have the rank of what moves whatever their lengths; the third is longer by a little."""
    feet = [[0, 0], [3, 1], [5, -1]]
    tips = [[1, 2], [4, 3], [6 + off, 1 + 2 * off]]
    found = analyse_mobility(three_bars([], feet, tips))
    assert found.dof == 1 and (found.finite.dof == 1) is moves
    assert [check.claim for check in verify(found) if not check.holds] == []
    values = mobility_proof(found)
    assert {"claim": "finite mobility", "value": 0} in values["claims"]
    said = [entry for entry in values["not proved"] if "taken for rounding" in entry["claim"]]
    assert [entry["value"] for entry in said] == ([1, True, None] if moves else [])
    assert any("taken as exact, stop the motion" in text for text in found.finite.evidence) is moves


def hinge(parent: str, child: str, x: int, y: int) -> tuple[Any, ...]:
    return ("R", parent, child, [x, y, 0], Z)


WELDS = [("fixed", parent, child, [0, 0, 0], None) for parent, child in ("ac", "cb", "ab")]
TRIANGLE = [hinge("a", "b", 7, 7), hinge("b", "c", 8, 9), hinge("c", "a", 9, 7)]


@pytest.mark.parametrize("held", [WELDS, TRIANGLE], ids=["welds", "triangle"])
def test_limbs_meet_in_bodies_that_joints_at_rest_make_one(held: list[tuple[Any, ...]]) -> None:
    """Three hinges in a line, shaky, hold what carries a four-bar: no two limbs, though no body is in both."""
    line = [hinge("base", "x", 0, 0), hinge("x", "a", 1, 0), hinge("base", "b", 3, 0)]
    four = [hinge("a", "z", 5, 4), hinge("z", "P", 6, 7), hinge("b", "y", 3, 1), hinge("y", "P", 2, 5)]
    found = analyse_mobility(graph(*line, *four, *held))
    assert (found.dof, found.finite.dof) == (2, 1)
    assert [check.evidence for check in verify(found) if not check.holds] == []


def test_limbs_of_a_forged_file_are_refused_where_a_joint_at_rest_joins_them() -> None:
    """The same, of which two limbs would say that all instantaneous motions are real."""
    line = [hinge("base", "x", 0, 0), hinge("x", "a", 1, 0), hinge("base", "b", 3, 0)]
    found = analyse_mobility(graph(*line, hinge("a", "P", 5, 4), hinge("b", "y", 3, 1), hinge("y", "P", 2, 5), *WELDS))
    values, (numbers, _) = json.loads(json.dumps(mobility_proof(found))), found.evidence
    plane = [["0", "0", "1", "0", "0", "0"], ["0", "0", "0", "1", "0", "0"], ["0", "0", "0", "0", "1", "0"]]
    limbs = []
    for names in (["J1", "J2", "J4"], ["J3", "J5", "J6"]):
        screws = [screw for name in names for screw in numbers.read.joints[name].screws]
        minor = rank_entry(numbers, list(map(list, zip(*screws, strict=True))))["minor"]
        limbs.append({"joints": names, "group": plane, "minor": minor})
    rank = rank_entry(numbers, numbers.read.matrix(("block", "0")))
    rest = {"rank": rank, "proof": {"kind": "limbs", "between": ["base", "P"], "limbs": limbs}}
    at_rest = {"joints": ["J7", "J8", "J9"], "minor": {"rows": [], "columns": []}}
    values["blocks"] = [{"rank": rank, "proof": {"kind": "rigid", "rigid": [at_rest], "rest": rest}}]
    values["claims"], values["not proved"] = [{"claim": "finite mobility", "value": 1}], []
    assert check_proof(values).refused == ("finite mobility 1: limbs that share a body",)


def test_a_value_is_claimed_in_the_type_that_it_has() -> None:
    """To Python 1 is 1.0 and true; to a reader of the file it is not."""
    values = values_of("parallelogram-change_point")
    (claim,) = [claim for claim in values["claims"] if claim["claim"] == "branches"]
    assert claim["value"] == [1] and accepted(values)
    for other in ([True], [1.0]):
        claim["value"] = other
        assert not accepted(values), other


def test_freedoms_and_points_are_counted_as_they_are() -> None:
    """No freedom is counted back from the last, and a point has three coordinates, whatever the joint."""
    for change in (
        lambda mechanism: mechanism["drives"][0].__setitem__(1, -1),
        lambda mechanism: next(j for j in mechanism["joints"] if j["motions"][0]["kind"] == "S")["point"].append("0"),
    ):
        values = values_of("three_ups_upu_s")
        change(values["mechanism"])
        values["digest"] = proof_checker.digest(values["mechanism"])
        with pytest.raises(proof_checker.UnreadableError):
            check_proof(values)


def test_what_a_console_cannot_write_ends_no_verdict(tmp_path: Path) -> None:
    values = values_of("planar_4bar")
    values["mechanism"]["name"] = "Kurbel \u2192 Schwinge"
    values["digest"] = proof_checker.digest(values["mechanism"])
    path = tmp_path / "file.json"
    path.write_text(json.dumps(values))
    command = [sys.executable, "-S", proof_checker.__file__, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, env={"PYTHONIOENCODING": "ascii"})
    assert done.returncode == 0 and "Mobility of Kurbel \\u2192 Schwinge" in done.stdout, done.stderr


def test_identities_are_multiplied_out_once_and_over_the_field(monkeypatch: pytest.MonkeyPatch) -> None:
    """(t - r) (t + r) = t^2 - 2 where r^2 = 2, and not t^2 - 3; of a part nothing is shown twice in one run."""
    numbers = proof_checker.Numbers([{"between": ["1", "2"], "polynomial": ["-2", "0"]}])
    root, one = numbers.read([["1", 1]]), numbers.one
    less, more = {(1, 0): one, (0, 0): -root}, {(1, 0): one, (0, 0): root}
    for square, zero in ((2, True), (3, False)):
        right = {(2, 0): one, (0, 0): numbers.rational(Fraction(-square))}
        assert proof_checker.cancelled(numbers, [(less, more), ({(0, 0): -one}, right)]) is zero
    seen: list[int] = []
    form = proof_checker.Block.form
    monkeypatch.setattr(proof_checker.Block, "form", lambda block, given: seen.append(1) or form(block, given))
    assert check_proof(values_of("parallelogram-change_point")).holds and len(seen) == 1
