"""Functional mock-up units: a scene as FMI 2.0 or 3.0, for co-simulation and model exchange, C sources inside."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.fmu.unit_archive import archive, at_rest, build_unit, readme_section, unit_contents
    from symscrew.fmu.unit_check import compare_unit

__all__ = ["archive", "at_rest", "build_unit", "compare_unit", "readme_section", "unit_contents"]

__getattr__ = doors(__name__)
