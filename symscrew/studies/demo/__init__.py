"""The demo: the whole job on the source paper's mechanism. `paper_motion` moves, `paper_study` computes,
`paper_figures` shows.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.demo.paper_figures import demo_facts, demo_summary, demo_values, write_figures
    from symscrew.studies.demo.paper_motion import SECTION_5
    from symscrew.studies.demo.paper_study import study_paper

__all__ = ["SECTION_5", "demo_facts", "demo_summary", "demo_values", "study_paper", "write_figures"]

__getattr__ = doors(__name__)
