"""Symbols of derived models."""

from __future__ import annotations

import pytest
from support.model_states import model

from symscrew.algebra.nodes import Symbol


@pytest.mark.parametrize("name", ["three_ups_upu_s", "delta", "ur5"])
def test_every_symbol_has_unit_description_and_assumptions(name: str) -> None:
    symbols = [node.args[0] for node in model(name).system.tape.symbols.values()]
    assert symbols
    for symbol in symbols:
        assert isinstance(symbol, Symbol)
        assert symbol.unit and symbol.description and symbol.sympy.is_real
