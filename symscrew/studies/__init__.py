"""Studies: what accuracy costs in time (`accuracy`), functions beside other libraries (`benchmark`), maps over
coordinates and parameters (`workspace`), the source paper's example (`demo`), and the bill of a scene's effects.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.bill_of_effects import FUNCTIONS, Bill, figure, run, scene_bill
    from symscrew.studies.this_machine import machine
    from symscrew.studies.timing import Times, interleaved, nanoseconds_per_state
    from symscrew.studies.transcription_study import run as study_transcriptions

__all__ = [
    "FUNCTIONS",
    "Bill",
    "Times",
    "figure",
    "interleaved",
    "machine",
    "nanoseconds_per_state",
    "run",
    "scene_bill",
    "study_transcriptions",
]

__getattr__ = doors(__name__)
