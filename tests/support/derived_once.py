"""Models that tests derive from the same description, kept for the next one that asks."""

from __future__ import annotations

from typing import Any

import pytest

import symscrew.model
from support.once import changes_package
from symscrew.model import Model
from symscrew.runtime import model_key

MANY = 64  # models that a process holds so: the last used; those of a file of tests are about thirty


class DerivedOnce:
    """In place of derivation: an equal description with equal effects and options gives the same model.

    Not while a test changes the package (`monkeypatch`), nor for one whose claim is that two derivations are equal
    (`derived_anew`): these derive as users do, and what they derive is not kept.
    """

    def __init__(self, derive: Any) -> None:
        self.derive, self.kept, self.item = derive, dict[Any, Model](), None

    def begin(self, item: pytest.Item) -> None:
        self.item: pytest.Item | None = item

    def __call__(self, mechanism: Any, effects: Any, **options: Any) -> Model:
        anew = self.item is not None and self.item.get_closest_marker("derived_anew") is not None
        key = model_key(mechanism, effects), repr(sorted(options.items()))
        if anew or changes_package(self.item) or key[0] is None:  # None: a mechanism that cannot be written
            return self.derive(mechanism, effects, **options)
        found = self.kept.pop(key, None) or self.derive(mechanism, effects, **options)
        self.kept[key] = found
        if len(self.kept) > MANY:
            del self.kept[next(iter(self.kept))]
        return found


derived_once = DerivedOnce(symscrew.model._derived)
