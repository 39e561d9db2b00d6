"""Functions that say how far a configuration is from each of the three kinds of singularity."""

from __future__ import annotations

from symscrew.functions.ports import function, q_port
from symscrew.kinematics import System
from symscrew.mobility import FORMS, Margins, actuation_margins, constraint_margins, limb_margins
from symscrew.program import Function, Port

TEXTS = {
    "limb_margins": "Limb (serial) singularities: 0 where the joint screws of a limb become dependent.",
    "constraint_margin": "Constraint singularity: 0 where the constraints lose rank and a freedom appears.",
    "actuation_margins": "Actuation singularities: 0 where a freedom is left with these drives locked.",
}


def margin_functions(system: System) -> list[Function]:
    """`limb_margins`, `constraint_margin`, `actuation_margins` of q, each where the mechanism has such.

    See `symscrew.mobility.margins` for what they are. Unit 1: lengths divided by the characteristic length. They
    divide by nothing, so they have no guards and are right at the singularity itself. Margins that were too large to be
    derived are named in the notes of the others of their kind.
    """
    found = {
        "limb_margins": limb_margins(system),
        "constraint_margin": constraint_margins(system),
        "actuation_margins": actuation_margins(system),
    }
    return [_function(system, name, margins) for name, margins in found.items() if margins]


def _function(system: System, name: str, margins: Margins) -> Function:
    count = len(margins)
    labels, forms = tuple(m.name for m in margins), tuple(m.form for m in margins)
    port = Port("margins", (count,), ("1",) * count, labels, _in_words(margins), forms)
    inputs = [(q_port(system), system.inputs.q)]
    outputs = [(port, [m.value for m in margins])]
    return function(system, name, TEXTS[name], inputs=inputs, outputs=outputs, notes=margins.not_tried)


def _in_words(margins: Margins) -> str:
    """Which margin is signed and which is squared."""
    names = {form: [m.name for m in margins if m.form == form] for form in FORMS}
    return "; ".join(f"{FORMS[form]}: {', '.join(which)}" for form, which in names.items() if which)
