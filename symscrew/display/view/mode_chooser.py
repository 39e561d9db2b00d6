"""Configurations of all assembly modes at the reference, between which the page's chooser goes."""

from __future__ import annotations

import numpy as np

from symscrew.assembly import assembly_modes, tree_coordinates
from symscrew.model import Model

Array = np.ndarray


def page_modes(model: Model) -> dict[str, Array]:
    """Name -> q (nq,) of the modes that joints of all limbs reach.

    Raises:
        DescriptionError: the mechanism has no drives, or its closure no polynomials.
    """
    found = assembly_modes(model)
    reached = [mode for mode in found.modes if mode.q is not None]
    return {mode.name: tree_coordinates(found, mode, model.system, "modes") for mode in reached}
