"""Mobility by reciprocal screws: instantaneous and finite, with the evidence for every rank, and margins.

System --joint_network, screw_systems--> instantaneous freedoms --finite, branches--> motions
       --exact_field, symbolic_screws--> constraint wrenches in symbols, singularities
       --margins--> numbers that vanish where a rank falls
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.mobility.analysis import Mobility, analyse_mobility
    from symscrew.mobility.checks import Check, verify
    from symscrew.mobility.findings import (
        formulas,
        key_figures,
        mathml,
        mobility_latex,
        mobility_markdown,
        mobility_page,
        mobility_text,
        mobility_values,
        sections,
    )
    from symscrew.mobility.instantaneous import BodyFreedoms, LimbMobility
    from symscrew.mobility.margins import FORMS, Margin, actuation_margins, constraint_margins, limb_margins
    from symscrew.mobility.screw_systems import ScrewSystem

__all__ = [
    "FORMS",
    "BodyFreedoms",
    "Check",
    "LimbMobility",
    "Margin",
    "Mobility",
    "ScrewSystem",
    "actuation_margins",
    "analyse_mobility",
    "constraint_margins",
    "formulas",
    "key_figures",
    "limb_margins",
    "mathml",
    "mobility_latex",
    "mobility_markdown",
    "mobility_page",
    "mobility_text",
    "mobility_values",
    "sections",
    "verify",
]

__getattr__ = doors(__name__)
