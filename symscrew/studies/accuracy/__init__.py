"""What accuracy costs in time: studies of methods side by side, one file per study.

    states, motion --setups of a study--> measuring (interleaved repeats) --> points --> study_tables, study_plots

A study returns `Study`: points (error, cost, or why it failed) of named curves, with the reference and its own error.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.accuracy.every_study import STUDIES, problem_study, studies_of_a_mechanism, study_of
    from symscrew.studies.accuracy.measuring import Study
    from symscrew.studies.accuracy.states import Subject
    from symscrew.studies.accuracy.study_plots import save_study_plots
    from symscrew.studies.accuracy.study_tables import study_json, study_markdown, study_summary

__all__ = [
    "STUDIES",
    "Study",
    "Subject",
    "problem_study",
    "save_study_plots",
    "studies_of_a_mechanism",
    "study_json",
    "study_markdown",
    "study_of",
    "study_summary",
]

__getattr__ = doors(__name__)
