"""The report of a mechanism as a call: `report(mechanism).save("seed.html")`, or shown where a notebook stands.

mechanism or model --derive--> model --document--> Document
"""

from __future__ import annotations

from pathlib import Path

from symscrew.description import Mechanism
from symscrew.errors import expect
from symscrew.model import Model, derive
from symscrew.reporting.blocks import Document
from symscrew.reporting.sections import document
from symscrew.runtime import load
from symscrew.studies import Times, time_every_function
from symscrew.studies.given_motion import DriveStudy
from symscrew.studies.workspace import Sweep


def report(
    subject: Mechanism | Model,
    *,
    timed: bool = False,
    accuracy: str | Path | None = None,
    motion: DriveStudy | None = None,
    sweep: Sweep | None = None,
) -> Document:
    """One document on a mechanism: mobility, screws, functions, singularities.

    Args:
        subject: a mechanism, taken under gravity alone, or a model with its effects.
        timed: whether functions are compiled and timed; where there is no C compiler nothing is.
        accuracy: a folder that `symscrew accuracy` wrote, to include.
        motion: what `symscrew.drives` found along a motion, to include.
        sweep: what `symscrew.workspace` found, to include.

    Returns:
        The document: `.save("seed.html")` writes it, a notebook shows it.

    Raises:
        DescriptionError: the folder holds no results.
    """
    expect(subject, Mechanism, Model)
    model = derive(subject) if isinstance(subject, Mechanism) else subject
    times: dict[str, Times] | None = None
    if timed:
        compiled = load(model)
        times = time_every_function(model, compiled) if compiled.backend == "c" else {}
    return document(model, times=times, accuracy=Path(accuracy) if accuracy is not None else None,
                    motion=motion, sweep=sweep)  # fmt: skip
