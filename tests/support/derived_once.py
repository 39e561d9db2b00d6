"""Models that many tests of a file derive from the same, kept: for tests whose claim is not that two are equal."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

import symscrew.model
from symscrew.model import Model
from symscrew.runtime import model_key


@contextmanager
def derived_once() -> Iterator[None]:
    """Within, whoever derives from an equal description, equal effects and options gets the same model."""
    derive, kept = symscrew.model._derived, dict[Any, Model]()

    def remembered(mechanism: Any, effects: Any, **options: Any) -> Model:
        key = model_key(mechanism, effects), repr(sorted(options.items()))
        if key[0] is None:  # a mechanism that cannot be written
            return derive(mechanism, effects, **options)
        if key not in kept:
            kept[key] = derive(mechanism, effects, **options)
        return kept[key]

    with pytest.MonkeyPatch.context() as changed:
        changed.setattr(symscrew.model, "_derived", remembered)
        yield
