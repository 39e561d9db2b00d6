"""Maps over independent coordinates and parameters: workspace, design studies, tolerances.

Plan --engine (chunks in parallel)--> evaluation --> store --> around --> map_summary, maps
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.workspace.around import around_holes
    from symscrew.studies.workspace.case_columns import result_units
    from symscrew.studies.workspace.configurations import (
        SINGULAR,
        Call,
        calls_of,
        independent_labels,
        reference_coordinates,
        start_margins,
        walk,
        watched_margins,
    )
    from symscrew.studies.workspace.engine import run_locally, run_on_dask
    from symscrew.studies.workspace.evaluation import (
        check_drawn,
        check_plan,
        has_own_axes,
        prepare_sweep,
        quaternion_labels,
    )
    from symscrew.studies.workspace.map_summary import all_around, sweep_summary, sweep_summary_text
    from symscrew.studies.workspace.maps import draw_maps
    from symscrew.studies.workspace.plan import (
        AZIMUTH,
        TILT,
        Axis,
        Plan,
        check_numbers,
        read_axis,
        read_limit,
        read_quantity,
    )
    from symscrew.studies.workspace.store import Results, Store, held_store, save_csv, save_npz
    from symscrew.studies.workspace.sweep_call import Sweep, workspace

__all__ = [
    "AZIMUTH",
    "SINGULAR",
    "TILT",
    "Axis",
    "Call",
    "Plan",
    "Results",
    "Store",
    "Sweep",
    "all_around",
    "around_holes",
    "calls_of",
    "check_drawn",
    "check_numbers",
    "check_plan",
    "draw_maps",
    "has_own_axes",
    "held_store",
    "independent_labels",
    "prepare_sweep",
    "quaternion_labels",
    "read_axis",
    "read_limit",
    "read_quantity",
    "reference_coordinates",
    "result_units",
    "run_locally",
    "run_on_dask",
    "save_csv",
    "save_npz",
    "start_margins",
    "sweep_summary",
    "sweep_summary_text",
    "walk",
    "watched_margins",
    "workspace",
]

__getattr__ = doors(__name__)
