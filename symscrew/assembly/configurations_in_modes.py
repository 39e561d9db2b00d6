"""The configuration of a mode by its name: where a run, a map or a plan begins.

    mechanism, name, values of some coordinates --assembly_modes--> mode --displacements of all freedoms--> q (tree)

Names are those of `symscrew.assembly.mode_names`: a mode at other values has the name of that of the reference to which
a straight way of what is held leads without a singularity.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from symscrew.assembly.all_modes import AssemblyMode, AssemblyModes, assembly_modes
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, shorten
from symscrew.kinematics import System, full_name
from symscrew.mobility import ClosureVariety, Reached, network_of, read_coordinates

Array = np.ndarray[Any, Any]


def configuration_in_mode(system: System, name: str, given: Mapping[str, Any], where: str) -> Array:
    """The coordinates q (nq,) of the spanning tree in the mode `name`, with these coordinates or parameters.

    Values of drives alone leave the other drives as in the reference; any other coordinates are held in their place.

    Raises:
        DescriptionError: there is no such mode; `where` says what asked for it.
    """
    mechanism = system.mechanism
    found = modes_at(mechanism, given)
    names = [mode.name for mode in found.modes]
    if name not in names:
        held = ", ".join(f"{key} = {value:.6g}" for key, value in found.held.items())
        known = f"it has {', '.join(names)}" if names else "it has none"
        raise DescriptionError(f"{where}: {mechanism.name} has no mode {shorten(name)} with {held}; {known}")
    return tree_coordinates(found, found.mode(name), system, where)


def modes_at(mechanism: Mechanism, given: Mapping[str, Any]) -> AssemblyModes:
    """All modes with these coordinates or parameters: values of drives alone, or what is held in their place."""
    network = network_of(mechanism)
    driven = {label for edge in network.edges.values() for label, (_, column) in zip(
        mechanism.joints[edge.name].kind.motion_names(edge.name), edge.motions, strict=True
    ) if column in network.driven}  # fmt: skip
    parameters = {k: v for k, v in given.items() if k in mechanism.parameters}
    values = {full_name(mechanism, k): v for k, v in given.items() if k not in parameters}
    if set(values) <= driven:
        return assembly_modes(mechanism, values, at=parameters)
    return assembly_modes(mechanism, at={**parameters, **values})


def tree_coordinates(found: AssemblyModes, mode: AssemblyMode, system: System, where: str) -> Array:
    """The coordinates q (nq,) of the spanning tree in a mode; raises DescriptionError where no limb reaches it."""
    if mode.q is None:
        raise DescriptionError(f"{where}: joints of a limb do not reach the mode {mode.name}")
    values = read_coordinates(found.mechanism, ClosureVariety(found.network), mode.q)
    return np.asarray(Reached(found.network, mode.residual, values).tree(system))
