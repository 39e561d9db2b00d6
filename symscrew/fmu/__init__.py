"""Functional mock-up units: a scene as FMI 2.0 or 3.0, for co-simulation and model exchange, C sources inside."""

from symscrew.fmu.archive import build

__all__ = ["build"]
