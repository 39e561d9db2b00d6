"""Mechanisms beyond the reference data, and the higher-order analysis by brackets against differences."""

from __future__ import annotations

import numpy as np
import pytest
from support.analysed import analysed
from support.further_mechanisms import CASES
from support.reference_mechanisms import ENTRIES, build

from symscrew.algebra.operations import CONTEXT
from symscrew.mobility.checks import verify
from symscrew.mobility.finite.local_solutions import local_at, quadratic_forms
from symscrew.mobility.finite.tangent_cone import continued
from symscrew.mobility.finite.variety import DIGITS_60, ClosureVariety
from symscrew.mobility.finite.witnesses import Witness, recheck
from symscrew.mobility.instantaneous import instantaneous_mobility
from symscrew.mobility.joint_network import network_of

pytestmark = pytest.mark.slow

SLOW = {
    "five legs on a circle", "five legs, no circle", "miura flat", "five-bar, collinear", "wunderlich",
    "bricard line-symmetric", "waldron hybrid", "3S, collinear", "two rhombi", "octahedral, line-symmetric",
    "octahedral, plane-symmetric", "hexapod, line-symmetric", "griffis-duffy",
}  # fmt: skip


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow if n in SLOW else ()) for n in CASES])
def test_known_mobility(name: str) -> None:
    found = analysed(name)
    assert (found.dof, found.finite.dof, found.finite.branches, found.overconstraints) == CASES[name].expected
    assert found.kutzbach + found.overconstraints == found.dof and found.decisions.exact
    assert [check.claim for check in verify(found) if not check.holds] == []


@pytest.mark.parametrize("name", ["3rps-mode_transition", "sarrus-flat_folded", "stewart_6sps", "double_watt_cusp"])
def test_quadratic_forms_are_second_differences(name: str) -> None:
    """The brackets against central differences of the analytic Jacobian along the instantaneous motions."""
    network = network_of(build(ENTRIES[name]))
    variety = ClosureVariety(network)
    motions = instantaneous_mobility(network).motions
    here = local_at(variety, np.zeros(variety.columns), motions=motions)
    h = 1e-5
    points = np.concatenate([h * here.kernel.T, -h * here.kernel.T])
    jacobians = variety.evaluate(points)[1]
    change = (jacobians[: here.dof] - jacobians[here.dof :]) / (2 * h)
    forms = np.einsum("kr,irc,cj->kij", here.stresses, change, here.kernel)
    assert np.abs(quadratic_forms(variety, here) - (forms + forms.transpose(0, 2, 1)) / 2).max(initial=0) < 1e-10


@pytest.mark.parametrize(
    "name, order", [("collinear_3R", 2), ("threebar_parallel_unequal", 2), ("bennett", None), ("schatz_turbula", None)]
)
def test_order_at_which_a_motion_stops(name: str, order: int | None) -> None:
    network = network_of(build(ENTRIES[name]))
    assert continued(network, instantaneous_mobility(network).motions[0], 6).order == order


def test_a_bar_to_the_centre_of_curvature_stops_at_third_order() -> None:
    network = network_of(CASES["coupler point"].make())
    arc = continued(network, instantaneous_mobility(network).motions[0], 6)
    assert arc.order == 3 and arc.obstruction > 1e-6


@pytest.mark.parametrize("name", ["stewart_6sps", "delassus_4h", "delta_rrpar", "oldham", "sarrus"])
def test_fixed_point_residual_is_that_of_the_exponentials(name: str) -> None:
    network = network_of(build(ENTRIES[name]))
    variety = ClosureVariety(network, DIGITS_60)
    random = np.random.default_rng(5)
    q = np.array([CONTEXT.mpf(float(c)) for c in 0.3 * random.normal(size=variety.columns)], dtype=object)
    residual, slopes = (part[0] for part in variety.evaluate(q[None]))
    assert max(abs(residual - variety.residual(q))) < 1e-56
    assert abs(slopes - variety.slopes(q[None])[0]).max() < 1e-56


def test_wrong_claims_are_found_out() -> None:
    """The second route disagrees with claims that are false."""
    shaky = network_of(build(ENTRIES["collinear_3R"]))
    moving = network_of(build(ENTRIES["bennett"]))
    crossing = network_of(build(ENTRIES["parallelogram-change_point"]))
    wrong = (
        Witness(shaky, "smooth", 1, 1), Witness(moving, "isolated", 0, 0), Witness(crossing, "smooth", 2, 2),
        Witness(moving, "smooth", 2, 2), Witness(crossing, "isolated", 0, 0),
    )  # fmt: skip
    assert [recheck(witness)[1] for witness in wrong] == [False] * 5
    assert recheck(Witness(moving, "smooth", 1, 1))[1] and recheck(Witness(shaky, "isolated", 0, 0))[1]
