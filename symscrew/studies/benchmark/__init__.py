"""Times of generated functions, beside other libraries that compute the same."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.studies.benchmark.function_times import USUAL, Row, run, throughput

__all__ = ["USUAL", "Row", "run", "throughput"]

__getattr__ = doors(__name__)
