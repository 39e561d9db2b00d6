"""Studies: what accuracy costs in time (`accuracy`), functions beside other libraries (`benchmark`), maps over
coordinates and parameters (`workspace`), the source paper's example (`demo`), and the bill of a scene's effects.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.bill_of_effects import BILLED_FUNCTIONS, Bill, bill_figure, bill_table, scene_bill
    from symscrew.studies.this_machine import machine
    from symscrew.studies.timing import Times, time_every_function

__all__ = [
    "BILLED_FUNCTIONS",
    "Bill",
    "Times",
    "bill_figure",
    "bill_table",
    "machine",
    "scene_bill",
    "time_every_function",
]

__getattr__ = doors(__name__)
