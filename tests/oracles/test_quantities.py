"""Symbolic quantities: the paper's screws in symbols, and rates against SymPy's own differentiation."""

from __future__ import annotations

import random

import pytest
import sympy

from symscrew import catalogue
from symscrew.errors import DescriptionError
from symscrew.functions.quantities import Quantities, Quantity


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
    """d/dt of twist and momentum along (q, v, a) of the tree, by differences with 70 digits, equals the rates."""
    quantities = Quantities(catalogue.load(name))
    system = quantities.system
    q, v, a = ([n.args[0].sympy for n in nodes] for nodes in (system.inputs.q, system.inputs.v, system.inputs.a))
    rates = dict(zip(v, a, strict=True))
    for link in system.tree.links[1:]:
        if link.motion.kind != "S":
            rates |= dict(zip(q[link.q], v[link.v], strict=True))
    random.seed(3)
    values = {s: sympy.Rational(random.randint(20, 90), 100) for s in (*q, *v, *a)}
    values |= {p.symbol: p.value for p in quantities.mechanism.parameters.values()}
    step = sympy.Rational(1, 10**20)

    def moved(sign: int) -> dict[sympy.Symbol, sympy.Expr]:
        later = {s: values[s] + sign * step * values[rates[s]] for s in v}
        for symbol in q:
            if symbol in rates:
                rate, gain = values[rates[symbol]], values[rates[rates[symbol]]]
                later[symbol] = values[symbol] + sign * step * rate + step**2 / 2 * gain
        return {**values, **later}

    for quantity, rate in (
        (quantities.twist(body), quantities.twist_rate(body)),
        (quantities.momentum(body), quantities.momentum_rate(body)),
    ):
        after, before = (number(quantity, moved(sign)) for sign in (1, -1))
        expected = (after - before) / (2 * step)
        got = number(rate, values)
        assert max(abs(e) for e in expected) > 1e-3
        assert max(abs(e) for e in got - expected) < 1e-30


def number(quantity: Quantity, values: dict[sympy.Symbol, sympy.Expr]) -> sympy.Matrix:
    """The quantity with 70 digits, definition by definition."""
    known = {s: e.evalf(70) for s, e in values.items()}
    for symbol, expression in quantity.definitions:
        known[symbol] = expression.xreplace(known).evalf(70)
    return quantity.matrix.xreplace(known).evalf(70)


def test_collected_form_has_shallow_definitions_and_latex_names_every_symbol(seed: Quantities) -> None:
    momentum = seed.momentum("limb1_upper")
    assert momentum.definitions
    text = momentum.latex()
    assert r"\dot M" not in text and r"\mathrm{limb1\_upper}" in text
    assert r"\dot \theta_{\mathrm{limb1\_U.0}}" in text
    for symbol, latex, unit, description in momentum.symbols:
        assert symbol.is_real and latex and unit and description


def test_unknown_names_are_refused(seed: Quantities) -> None:
    with pytest.raises(DescriptionError, match=r"expected the name of a body, got 'platfrom'.*platform"):
        seed.twist("platfrom")
