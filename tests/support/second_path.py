"""Models whose forward dynamics always take the second path."""

from __future__ import annotations

import dataclasses

from symscrew.model import Model
from symscrew.program.rank_revealing import RankRevealing

FUNCTIONS = ("forward_dynamics", "forward_dynamics_reactions")


def always_second(found: Model) -> Model:
    """The model with guards that every state fails."""
    programs = dict(found.programs)
    for name in FUNCTIONS:
        program = programs[name]
        assert isinstance(program, RankRevealing)
        programs[name] = dataclasses.replace(program, guards=tuple((slot, 1e300) for slot, _ in program.guards))
    return dataclasses.replace(found, programs=programs)
