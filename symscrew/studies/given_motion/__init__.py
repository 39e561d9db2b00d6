"""Motion in, tables out: joints, rates, drives, reactions and margins of a motion of the platform that is given.

file or expressions --wanted_motion--> values and their derivatives --goals, following--> q, v, a --study--> DriveStudy
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.given_motion.study import DriveStudy, drives
    from symscrew.studies.given_motion.study_files import (
        FILES,
        doubts,
        pictures,
        study_json,
        study_text,
        watched,
        write_study,
    )
    from symscrew.studies.given_motion.wanted_motion import WantedMotion, load_motion, motion_of

__all__ = [
    "FILES",
    "DriveStudy",
    "WantedMotion",
    "doubts",
    "drives",
    "load_motion",
    "motion_of",
    "pictures",
    "study_json",
    "study_text",
    "watched",
    "write_study",
]

__getattr__ = doors(__name__)
