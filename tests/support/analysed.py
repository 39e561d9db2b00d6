"""Mobility of mechanisms that many tests ask for, analysed once in a process; who changes a result analyses its own."""

from __future__ import annotations

from functools import cache

from support.further_mechanisms import CASES
from support.reference_mechanisms import ENTRIES, build
from symscrew import catalogue
from symscrew.mobility import Mobility, analyse_mobility


@cache
def analysed(name: str) -> Mobility:
    """Of an entry of `data/mobility.json`, or of a further mechanism."""
    return analyse_mobility(build(ENTRIES[name]) if name in ENTRIES else CASES[name].make())


@cache
def of_catalogue(name: str) -> Mobility:
    """Of a mechanism of the catalogue."""
    return analyse_mobility(catalogue.load(name))
