"""Times of generated functions, beside other libraries that compute the same."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.benchmark.function_times import USUAL_FUNCTIONS, Row, throughput, time_functions
    from symscrew.studies.benchmark.time_plot import draw_times

__all__ = ["USUAL_FUNCTIONS", "Row", "draw_times", "throughput", "time_functions"]

__getattr__ = doors(__name__)
