"""What accuracy costs in time: studies of methods side by side, one file per study.

    states, motion --setups of a study--> measuring (interleaved repeats) --> points --> report, plots

A study returns `Study`: points (error, cost, or why it failed) of named curves, with the reference and its own
error. `command` is `symscrew accuracy`.
"""

from symscrew.accuracy.measuring import Point, Setup, Study, measured

__all__ = ["Point", "Setup", "Study", "measured"]
