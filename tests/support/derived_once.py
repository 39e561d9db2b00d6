"""Models that tests derive from the same description, kept for the next one that asks."""

from __future__ import annotations

from typing import Any

import pytest

import symscrew.model
from symscrew.model import Model
from symscrew.runtime import model_key

MANY = 64  # models that a process holds so: the last used; those of a file of tests are about thirty


class DerivedOnce:
    """In place of derivation: an equal description with equal effects and options gives the same model.

    Not for a test that changes the package (`monkeypatch`), or whose claim is that two derivations are equal
    (`derived_anew`): these derive as users do, and what they derive is not kept.
    """

    def __init__(self, derive: Any) -> None:
        self.derive, self.kept, self.anew = derive, dict[Any, Model](), False

    def begin(self, item: pytest.Item) -> None:
        changes = "monkeypatch" in getattr(item, "fixturenames", ())
        self.anew = changes or item.get_closest_marker("derived_anew") is not None

    def __call__(self, mechanism: Any, effects: Any, **options: Any) -> Model:
        key = model_key(mechanism, effects), repr(sorted(options.items()))
        if self.anew or key[0] is None:  # None: a mechanism that cannot be written
            return self.derive(mechanism, effects, **options)
        found = self.kept.pop(key, None) or self.derive(mechanism, effects, **options)
        self.kept[key] = found
        if len(self.kept) > MANY:
            del self.kept[next(iter(self.kept))]
        return found


derived_once = DerivedOnce(symscrew.model._derived)
