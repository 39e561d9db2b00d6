"""What accuracy costs in time: studies of methods side by side, one file per study.

    states, motion --setups of a study--> measuring (interleaved repeats) --> points --> study_tables, study_plots

A study returns `Study`: points (error, cost, or why it failed) of named curves, with the reference and its own error.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.accuracy.every_study import OF_A_MECHANISM, study_of
    from symscrew.studies.accuracy.measuring import Point, Setup, Study, measured
    from symscrew.studies.accuracy.states import Subject
    from symscrew.studies.accuracy.study_plots import save_study_plots
    from symscrew.studies.accuracy.study_tables import study_json, study_markdown, study_summary, table

__all__ = [
    "OF_A_MECHANISM",
    "Point",
    "Setup",
    "Study",
    "Subject",
    "measured",
    "save_study_plots",
    "study_json",
    "study_markdown",
    "study_of",
    "study_summary",
    "table",
]

__getattr__ = doors(__name__)
