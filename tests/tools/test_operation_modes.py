"""Operation modes by exact algebra: published components, and what real configurations say of them. Needs Singular."""

from __future__ import annotations

import json
import math
import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from support.further_mechanisms import CASES, Z, loop
from support.parallel_mechanisms import cells, double_parallelogram, four_puu, four_ruu, snu
from support.reference_mechanisms import ENTRIES, build

from symscrew.cli.parser import main
from symscrew.description.mechanism import Mechanism
from symscrew.mobility import analyse_mobility, judged_modes, with_components
from symscrew.mobility.components import (
    UNCHECKED,
    ClosureEquations,
    ConfigurationSpace,
    NumericalSpace,
    PoseModes,
    SampledMode,
    SampledModes,
    algebraic_closure,
    all_components,
    closure_equations,
    configuration_space,
    mode_lines,
    numerical_components,
    numerical_lines,
    pose_lines,
    pose_modes,
    space_lines,
    with_zero_parameters,
    zero_lines,
    zero_values,
)
from symscrew.mobility.components import charts as held_charts
from symscrew.mobility.components.algebra_program import ALGEBRA_PROGRAM, algebra_answer
from symscrew.mobility.components.component_parts import ExactParts
from symscrew.mobility.components.exact_parts import field_text, polynomials_text, variable_names
from symscrew.mobility.components.plane_sections import Basis, sections
from symscrew.mobility.joint_network import network_of

pytestmark = pytest.mark.skipif(shutil.which(ALGEBRA_PROGRAM) is None, reason="Singular is not installed (singular-ui)")

GIVEN_UP = 2.0  # of the processor, for a division that would not end in hours: its first half takes one
OTHERS: dict[str, Callable[[], Mechanism]] = {"snu": snu, "double parallelogram": double_parallelogram}


def whole_basis(closure: ClosureEquations) -> Basis:
    """A reduced basis of all equations as they are."""
    names, equations = ",".join(variable_names(closure)), polynomials_text(closure, closure.equations)
    answer = algebra_answer(
        f"ring r = {field_text(closure)[0]}, ({names}), dp; {field_text(closure)[1]} option(redSB); short = 0;"
        f"ideal K = std(ideal({equations})); int i;"
        'print("@size " + string(dim(K)) + " " + string(mult(K))); for (i = 1; i <= size(K); i++) { print(K[i]); }'
        'print("@end"); quit;', GIVEN_UP,
    )  # fmt: skip
    assert answer is not None and answer[1]
    size, *lines = answer[0].partition("@size ")[2].partition("@end")[0].split()
    return Basis(int(size), int(lines[0]), tuple(lines[1:]))


def mechanism(name: str) -> Mechanism:
    return OTHERS[name]() if name in OTHERS else build(ENTRIES[name]) if name in ENTRIES else CASES[name].make()


def space(name: str, **options: float) -> ConfigurationSpace:
    found = configuration_space(mechanism(name), network_of(mechanism(name)), **options)
    assert isinstance(found, ConfigurationSpace), found
    return found


@pytest.mark.parametrize(
    "name, sizes, through",
    [
        ("planar_4bar", [(1, 6)], 1),  # one curve (Hunt 1978)
        ("parallelogram", [(1, 2), (1, 4)], 1),  # translation in a circle, antiparallelogram (Hunt 1978, ch. 12)
        ("parallelogram-change_point", [(1, 2), (1, 4)], 2),
        ("bennett", [(1, 2)], 1),  # a conic in Study's quadric (Brunnthaler, Schroecker, Husty 2005)
        ("goldberg_5r", [(1, 4)], 1),
        # Sarrus: the translation, with the knees to one side or to two; the plate on the base turns about its hinges
        ("sarrus-flat_folded", [(2, 1), (1, 4), (1, 4)], 2),
        # kinematotropic: the rocker moves with one freedom, or stands while both folded dyads turn
        ("kinematotropic_double_fold-transition", [(2, 4), (1, 4), (1, 4)], 2),
        ("double_hooke", [(1, 12)], 1),
    ],
)
def test_published_components(name: str, sizes: list[tuple[int, int]], through: int) -> None:
    found = space(name)
    real = [part for part, on in zip(found.parts, found.on, strict=True) if on]
    assert found.proved and not found.resting and [(p.dimension, p.degree) for p in real] == sizes
    assert sum(part.through for part in real) == through
    dimensions = {part.dimension for part in found.parts if part.through}
    finite = analyse_mobility(mechanism(name)).finite
    assert dimensions == ({finite.dof} if finite.branches is None else set(finite.branches))


@pytest.mark.parametrize(
    "name, size",
    [
        ("planar_5bar", (2, 14)),  # a surface, of which no prime ideal is found in hours
        ("double_watt_cusp", (1, 52)),  # through a cusp (Connelly and Servatius 1994)
        ("3-PRS", (3, 8)),
        ("origami degree 6", (3, 16)),
    ],
)
def test_what_has_irreducible_sections_is_one_component(name: str, size: tuple[int, int]) -> None:
    found = space(name, seconds=GIVEN_UP)
    assert found.proved and [(p.dimension, p.degree) for p in found.parts] == [size] and found.on == (found.found,)


@pytest.mark.parametrize("name, pure", [("kinematotropic_double_fold", False), ("bennett", True)])
def test_lower_components_beside_an_irreducible_section_are_not_excluded(name: str, pure: bool) -> None:
    """A surface of degree 4 with two curves beside it, which no section sees; a conic with nothing beside it."""
    made = mechanism(name)
    closure = closure_equations(made, network_of(made))
    modulus = closure.field.generators[0].modulus if closure.field.generators else ()
    (section,) = sections([whole_basis(closure)], len(closure.variables), modulus, GIVEN_UP)
    assert section.irreducible and section.pure == pure


@pytest.mark.parametrize("name", ["parallelogram", "bricard_box"])
def test_what_has_several_components_is_not_proved_to_be_one(name: str) -> None:
    """The closure of a parallelogram without its factors, and a Bricard's, whose program ends with one piece."""
    made = mechanism(name)
    closure = closure_equations(made, network_of(made))
    basis = whole_basis(closure)
    (section,) = sections([basis], len(closure.variables), (), GIVEN_UP)
    assert not section.irreducible and basis.degree == {"parallelogram": 6, "bricard_box": 21}[name]


@pytest.mark.parametrize(
    "name, dimensions",
    [
        ("sarrus-stretched", [1, 1]),  # both knees go out to one side, or to two
        ("kinematotropic_double_fold-transition", [2, 1]),
        ("threebar_parallel_equal", [1]),  # overconstrained, and no group shows that it moves
        ("threebar_parallel_unequal", []),
    ],
)
def test_components_that_are_smooth_at_the_reference_prove_its_branches(name: str, dimensions: list[int]) -> None:
    as_sampled = analyse_mobility(mechanism(name))
    found = with_components(as_sampled, space(name))
    assert found.branches is not None and found.branches.complete and found.finite.proved
    assert [row.dimension for row in found.branches.rows] == dimensions
    assert found.finite.branches == as_sampled.finite.branches and found.verdict == as_sampled.verdict


def test_components_prove_nothing_where_they_are_singular_or_others_were_seen() -> None:
    """A flat vertex of four folds is the node of one curve; of the parallelogram's two curves one is left out."""
    for name, multiplicities, rows in (("origami degree 4", [2], 2), ("parallelogram-change_point", [1, 1], 1)):
        found, modes = analyse_mobility(mechanism(name)), space(name)
        assert found.branches is not None
        assert [part.multiplicity for part in modes.parts if part.through] == multiplicities
        vars(found)["branches"] = replace(found.branches, rows=found.branches.rows[:rows], complete="", open="unknown")
        again = with_components(found, modes).branches
        assert again is not None and not again.complete


def test_a_miura_fold_is_decomposed_whole() -> None:
    """Flat it folds along its zigzag, about two straight lines, or each of these with the other flat: all, proved.

    Nine panels about four vertices; a component on which a joint is turned by half a turn is listed once.
    """
    found = space("miura flat")
    assert found.proved and found.settles and not found.resting and all(not part.held for part in found.parts)
    assert [(p.dimension, p.degree) for p in found.parts if p.through] == [(2, 1), (1, 3), (1, 3), (1, 4)]
    assert len(found.parts) == 11 and len({part.equations for part in found.parts}) == 11
    rows = with_components(analyse_mobility(mechanism("miura flat")), found).branches
    assert rows is not None and rows.complete and sorted(row.dimension for row in rows.rows) == [1, 1, 1, 2]


def test_a_double_parallelogram_keeps_its_coupler_parallel_or_is_stiff() -> None:
    """The third crank takes the antiparallelogram away: of that mode two poses are left (Hunt 1978, ch. 12)."""
    found = space("double parallelogram")
    assert found.proved and [(p.dimension, p.degree) for p in found.parts if p.dimension] == [(1, 2)]


def test_cells_in_a_row_have_the_products_of_their_components() -> None:
    """A cell is a parallelogram or an antiparallelogram (Hunt 1978, ch. 12), each whatever the others are."""
    found = configuration_space(cells(2), network_of(cells(2)))
    assert isinstance(found, ConfigurationSpace)
    assert [(p.dimension, p.degree, p.through) for p in found.parts] == [
        (2, 4, True), (2, 8, False), (2, 8, False), (2, 16, False)]  # fmt: skip
    assert [p.irreducible for p in found.parts] == [True, True, True, False]  # of two that have no point in the field
    assert not found.proved and "numbers outside of the field" in found.reason and all(found.on)
    assert sum(found.on) == found.found and len(set(found.variables)) == len(found.variables) == 12
    names = {name for part in found.parts for e in part.equations for name in re.findall(r"[cs]_\w+", e)}
    assert names == set(found.variables)


def test_modes_of_the_3_upu_of_seoul() -> None:
    """Walter, Husty and Pfurner 2009: translations, twisted ones, planar ones upright and upside down, general ones."""
    found = space("snu")
    assert found.proved and {part.dimension for part in found.parts} == {3}
    assert sum(part.degree for part in found.parts) == 15  # four quadrics, without the plane of x = 0, which is no pose
    equations = [set(part.equations) for part in found.parts if part.degree == 1]
    assert {"y0", "x1", "x2", "x3"} in equations and {"y3", "x0", "x1", "x2"} in equations
    assert len([e for e in equations if {"x1", "x2"} <= e]) == 3  # these two, and the planar one
    assert [part.degree for part in found.parts if part.degree > 1] == [8] and all(found.on)


def test_the_two_modes_of_the_3_rps() -> None:
    """Schadlbauer, Walter and Husty 2014: x0 = 0 and x3 = 0 (there x1), of dimension 3; proved to be all of it.

    A hyperplane and three quadrics meet in degree 8, of which the plane of x = 0, where no pose is, is one.
    """
    found = space("3rps", seconds=GIVEN_UP)
    assert [(p.dimension, p.degree) for p in found.parts] == [(3, 7), (3, 7)]
    assert {part.equations[0] for part in found.parts} == {"x0", "x3"}
    assert found.proved and not found.reason


def folding_kite() -> Mechanism:
    """A kite in the plane with a hinge across, which stays: its tip rests while it turns about itself, folded."""
    axes = [Z, [3, 0, 4], Z, Z, Z]
    points = [[0, 0, 0], [1, 0, 0], [2, -1, 0], [5, 0, 0], [2, 1, 0]]
    made: Mechanism = loop(*(("R", point, axis) for point, axis in zip(points, axes, strict=True)))
    return made


@pytest.mark.parametrize("zero", [None, Fraction(-2)])
def test_a_joint_at_rest_where_its_variable_has_no_value(
    zero: Fraction | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The tip rests at 2 atan(1/2), whose tangent a chart with the zero at -2 lacks: another chart shows the fold."""
    if zero is not None:
        charts = (zero, *algebraic_closure.CHARTS)
        for module in (algebraic_closure, held_charts):
            monkeypatch.setattr(module, "CHARTS", charts)
    network = network_of(folding_kite())
    found = configuration_space(folding_kite(), network)
    assert isinstance(found, ConfigurationSpace) and found.proved and found.resting == ()
    assert sorted((p.dimension, p.degree, p.through) for p in found.parts) == [(1, 1, False), (1, 5, True)]
    assert sum(found.on) == found.found > 20 and all(found.on)
    held = dict(pair for part in found.parts for pair in part.held)
    assert held == pytest.approx({} if zero is None else {"J1": 2 * math.atan(0.5)})
    assert all("t1" not in e for part in found.parts if part.held for e in part.equations)
    assert any("J1 at 0.927295 rad all over it" in line for line in space_lines(found)) == bool(held)
    monkeypatch.setattr(held_charts, "exact_parts", lambda closure, seconds: ExactParts((), False, "too slow"))
    missed = configuration_space(folding_kite(), network)
    if zero is None:  # the angle that is not looked at is named, as before
        assert isinstance(missed, ConfigurationSpace) and [joint for joint, _ in missed.resting] == ["J1"]
    else:
        assert isinstance(missed, str) and "on none of the components" in missed


ROTATION = [[Fraction(c, 15) for c in row] for row in ((11, -10, 2), (2, 5, 14), (-10, -10, 5))]


def seen_modes(made: Mechanism) -> PoseModes:
    found = pose_modes(made, network_of(made))
    assert isinstance(found, PoseModes), found
    return found


def test_the_modes_of_the_4_ruu() -> None:
    """Nurahmi, Caro, Wenger, Schadlbauer and Husty 2016: two Schoenflies modes, and a third of two freedoms."""
    found = seen_modes(four_ruu())
    assert [set(mode.part.equations) for mode in found.modes] == [
        {"x1", "x2", "x0*y0+x3*y3"}, {"x0", "x3", "x1*y1+x2*y2"}]  # fmt: skip
    assert [(m.part.dimension, m.part.degree, m.part.through, m.motion.upright) for m in found.modes] == [
        (4, 2, True, 1), (4, 2, False, -1)]  # fmt: skip
    assert [(m.dimension, m.poses) for m in found.others.modes] == [(2, 2)] and not found.unseen
    for mode in found.modes:
        assert mode.motion.system.type == "1R3T" and mode.motion.axis == pytest.approx([0, 0, 1])
        assert mode.motion.freedoms == 4 and mode.motion.residual < 1e-12 and mode.motion.exact
    lines = pose_lines(found)
    assert "Schoenflies motion about (0, 0, 1)" in lines[1] and "the other way up" in lines[2]
    assert "sampled" in lines[3] and UNCHECKED in lines[0]


@pytest.mark.parametrize("limbs, general", [(2, 4), (3, 3), (4, 2)])
def test_modes_of_ruu_limbs_that_stand_askew(limbs: int, general: int) -> None:
    """Each limb takes one freedom in general, and all together only two where the outer axes are parallel."""
    found = seen_modes(four_ruu(limbs, ROTATION))
    assert {(m.part.dimension, m.part.degree, m.motion.upright) for m in found.modes} == {(4, 2, 1), (4, 2, -1)}
    vertical = np.array([float(row[2]) for row in ROTATION])
    assert all(np.abs(np.cross(m.motion.axis, vertical)).max() < 1e-9 for m in found.modes)
    assert [(m.dimension, m.poses) for m in found.others.modes] == [(general, general)]


def test_poses_that_no_configuration_reaches_are_no_mode() -> None:
    """Of four slides around the base none reaches the platform upside down, which has their places the other way."""
    found = seen_modes(four_puu())
    assert [(m.part.dimension, m.motion.upright) for m in found.modes] == [(4, 1)]
    assert [set(part.equations) for part in found.unseen] == [{"x0", "x3", "x1*y1+x2*y2"}]
    assert any("was seen on the poses x" in line for line in pose_lines(found))


def test_what_has_no_modes_of_axes_says_why() -> None:
    for name, reason in (("3rps", "no limb begins and ends"), ("parallelogram", "angles of all bodies")):
        assert reason in str(pose_modes(mechanism(name), network_of(mechanism(name))))


def test_bricard() -> None:
    """A curve, without the plane of x = y = 0 of the program's only piece; of isolated poses nothing is said."""
    found = space("bricard_box", seconds=GIVEN_UP)
    assert [p.dimension for p in found.parts if p.through] == [1] and found.on[0] == found.found > 10
    (part,) = found.parts
    assert part.degree == 20 and part.irreducible_in_its_dimension and not part.irreducible and not found.proved
    assert any("irreducible in its dimension, while lower ones" in line for line in space_lines(found))


def test_time_is_the_processors_and_what_is_endless_is_given_up() -> None:
    """A program that only waits spends none of it: the clock, which may be slow, ends it much later."""
    output, ended = algebra_answer('print("@pieces"); int i; while (1) { i = 1 - i; }', 1.0)
    assert "@pieces" in output and not ended
    output, ended = algebra_answer('int i = system("sh", "sleep 1.5"); print("@end"); quit;', 1.0)
    assert ended, output


def test_in_words_and_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mobility", "bennett", "--components", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)["components"]
    assert values["proved"] and [(c["dimension"], c["degree"]) for c in values["components"]] == [(1, 2)]
    assert values["all_joints_settled"] and values["all_but_with_a_joint_held_at"] == []
    assert main(["mobility", "bennett", "--components"]) == 0
    assert "1 component of the pose of" in capsys.readouterr().out


def test_where_many_solutions_meet_doubles_refute_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """A bar to the centre of curvature: four solutions meet three at a time in the reference, which doubles blur."""
    found = space("coupler point")
    assert [(part.dimension, part.degree) for part in found.parts] == [(0, 1), (0, 3)] and found.found == sum(found.on)
    assert found.on[0] > 5 and found.on[1] > 5
    whole = all_components.exact_parts

    def without_the_others(*args: Any, **options: Any) -> ExactParts:
        made = whole(*args, **options)
        return replace(made, parts=tuple(part for part in made.parts if part.through))

    monkeypatch.setattr(all_components, "exact_parts", without_the_others)
    made = mechanism("coupler point")
    assert "on none of the components" in str(configuration_space(made, network_of(made)))


def test_the_third_mode_of_the_4_ruu_is_there_with_two_freedoms() -> None:
    """Nurahmi and others 2016: certified by a regular configuration, in intervals; not where it does not close."""
    found = analyse_mobility(four_ruu())
    modes = seen_modes(four_ruu()).others
    (mode,) = judged_modes(found, modes).modes
    assert mode.certified and mode.dimension == 2 and mode.witness is not None
    assert "certified by intervals" in mode_lines(replace(modes, modes=(mode,)))[1]
    for other in (replace(mode, dimension=3), replace(mode, witness=0 * mode.witness)):  # there more moves
        (refused,) = judged_modes(found, replace(modes, modes=(replace(other, certified=False),))).modes
        assert not refused.certified


@pytest.mark.slow
def test_translations_of_a_delta_are_one_component() -> None:
    """Proved, of what does not decompose as a whole; over given arms they are two poses, where three spheres meet."""
    made = mechanism("delta_4s")
    network = network_of(made)
    mode = SampledMode(3, 3, ("x1", "x2", "x3", "y0"), 26, 1, through=True)
    seen = SampledModes("plat", (mode, replace(mode, equations=("1/2*x0+x1",))), 1)
    (held,) = with_zero_parameters(made, network, seen, 20.0)
    (one,) = held.parts
    assert held.zeros == ("x1", "x2", "x3", "y0") and not held.reason and one.whole and one.on
    part = one.part
    assert (part.dimension, part.degree, part.through, part.irreducible, part.multiplicity) == (3, 46, True, True, 1)
    assert "a component of all configurations" in zero_lines([held])[1]
    (late,) = with_zero_parameters(made, network, seen, 0.0)
    assert not late.parts and "not decided: exact algebra did not end" in zero_lines([late])[0]
    assert zero_values([held, late])[1] == {**zero_values([late])[0], "decided": False}
    assert with_zero_parameters(made, network, replace(seen, body="base"), 1.0) == ()


@pytest.mark.slow
def test_a_delta_with_ball_joints_translates_or_does_not() -> None:
    """Of its rods' 40 poses over given arm angles two are translations; factors modulo primes leave no other parts."""
    made = mechanism("delta_4s")
    (space,) = numerical_components(made, network_of(made), 3.0, over=30.0)
    (over,) = space.over
    assert isinstance(space, NumericalSpace) and not space.closed
    assert (over.total, over.joints, over.reason) == (40, ("B0", "B1", "B2"), "") and over.irreducible
    assert [(p.poses, p.certified, p.through) for p in over.parts] == [(2, 2, True), (38, 38, False)]
    assert sum(p.on for p in over.parts) > 50 and all(p.residual < 1e-30 for p in over.parts)
    assert any("over given B0, B1, B2: 2 components" in line for line in numerical_lines([space]))
