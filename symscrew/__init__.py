"""symscrew: symbolic models of mechanisms on screw theory, with code export.

    import symscrew
    mechanism = symscrew.load_description("mechanism.toml")   # or symscrew.MechanismBuilder(...).build()
    model = symscrew.derive(mechanism)                        # named straight-line programs
    symscrew.generate(model, "out")                           # C, CasADi, NumPy
    compiled = symscrew.load("out")                           # compiled C, called with NumPy arrays

Nothing heavy is imported before it is used.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

PUBLIC = {
    "MechanismBuilder": ("symscrew.builder", "MechanismBuilder"),
    "DescriptionError": ("symscrew.errors", "DescriptionError"),
    "load_description": ("symscrew.description", "load"),
    "load_catalogue": ("symscrew.catalogue", "load"),
    "analyse_mobility": ("symscrew.mobility", "analyse_mobility"),
    "Quantities": ("symscrew.quantities", "Quantities"),
    "Gravity": ("symscrew.effects", "Gravity"),
    "ExternalWrench": ("symscrew.effects", "ExternalWrench"),
    "base_parameters": ("symscrew.inertial_parameters", "base_parameters"),
    "inertial_parameters": ("symscrew.inertial_parameters", "inertial_parameters"),
    "derive": ("symscrew.model", "derive"),
    "generate": ("symscrew.generation", "generate"),
    "check": ("symscrew.verification", "check"),
    "load": ("symscrew.compiled", "load"),
}


def __getattr__(name: str) -> Any:
    if name not in PUBLIC:
        raise AttributeError(f"module 'symscrew' has no attribute {name!r}; known: {', '.join(PUBLIC)}")
    module, attribute = PUBLIC[name]
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return ["__version__", *PUBLIC]
