"""Symbolic quantities: the paper's screws in symbols, and rates against SymPy's own differentiation."""

from __future__ import annotations

import random

import pytest
import sympy

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.quantities import Quantities, Quantity


@pytest.fixture(scope="module")
def seed() -> Quantities:
    return Quantities(catalogue.load("three_ups_upu_s"))


def at_reference(quantity: Quantity, quantities: Quantities) -> sympy.Matrix:
    """Coordinates at the reference configuration, parameters left as symbols."""
    system = quantities.system
    values = {}
    for node, value in zip(system.inputs.q, system.reference, strict=True):
        values[node.args[0].sympy] = sympy.nsimplify(value, rational=True)
    return quantity.substituted().xreplace(values)


def test_limb_1_has_the_paper_s_screws(seed: Quantities) -> None:
    """Eq. (11) with symbols, in the reading of the docs, for sin = (R - r)/L, cos = H/L."""
    R, r, H = sympy.symbols("R r H", real=True)
    length = sympy.sqrt((R - r) ** 2 + H**2)
    sine, cosine = (R - r) / length, H / length
    expected = sympy.Matrix(
        [
            [1, 0, 0, 0, 0, 0],
            [0, 1, 0, 0, 0, -R],
            [0, 0, 0, sine, 0, cosine],
            [cosine, 0, -sine, 0, length - R * sine, 0],
            [0, 1, 0, -length * cosine, 0, length * sine - R],
        ]
    ).T
    got = at_reference(seed.limb_screws("limb1"), seed)
    difference = (got - expected).applyfunc(sympy.simplify)
    assert difference == sympy.zeros(6, 5)


def test_the_s_limb_has_three_rotations_through_o(seed: Quantities) -> None:
    got = at_reference(seed.limb_screws("limb5"), seed)
    assert got == sympy.Matrix(6, 3, lambda i, j: 1 if i == j else 0)


@pytest.mark.parametrize(
    ("name", "body"), [("slider_crank", "slider"), ("ur5", "forearm_link"), ("three_ups_upu_s", "limb2_upper")]
)
def test_rates_are_the_time_derivatives(name: str, body: str) -> None:
    """d/dt of twist and momentum by SymPy along (q, v, a) of the tree equals the rates by screw algebra."""
    quantities = Quantities(catalogue.load(name))
    system = quantities.system
    q, v, a = ([n.args[0].sympy for n in nodes] for nodes in (system.inputs.q, system.inputs.v, system.inputs.a))
    rates = dict(zip(v, a, strict=True))
    for link in system.tree.links[1:]:
        if link.motion.kind != "S":
            rates |= dict(zip(q[link.q], v[link.v], strict=True))
    random.seed(3)
    everything = set(q) | set(v) | set(a)
    values = {s: sympy.Float(random.uniform(0.2, 0.9), 40) for s in sorted(everything, key=str)}
    values |= {p.symbol: sympy.Float(p.value.evalf(40), 40) for p in quantities.mechanism.parameters.values()}
    for quantity, rate in (
        (quantities.twist(body), quantities.twist_rate(body)),
        (quantities.momentum(body), quantities.momentum_rate(body)),
    ):
        matrix = quantity.substituted()
        derivative = sympy.zeros(6, 1)
        for symbol, change in rates.items():
            if symbol in matrix.free_symbols:
                derivative += matrix.diff(symbol) * change
        got = rate.substituted().evalf(40, subs=values)
        expected = derivative.evalf(40, subs=values)
        assert max(abs(e) for e in expected) > 1e-3
        assert max(abs(e) for e in got - expected) < 1e-25


def test_collected_form_has_shallow_definitions_and_latex_names_every_symbol(seed: Quantities) -> None:
    momentum = seed.momentum("limb1_upper")
    assert momentum.definitions
    text = momentum.latex()
    assert r"\dot M" not in text and r"\mathrm{limb1\_upper}" in text
    assert r"\dot \theta_{\mathrm{limb1\_U.0}}" in text
    for symbol, latex, unit, description in momentum.symbols:
        assert symbol.is_real and latex and unit and description


def test_unknown_names_are_refused(seed: Quantities) -> None:
    with pytest.raises(DescriptionError, match="expected the name of a body, got 'platfrom'.*platform"):
        seed.twist("platfrom")
