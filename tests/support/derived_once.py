"""Models and mobilities that tests derive from the same description, kept for the next one that asks."""

from __future__ import annotations

from typing import Any

import pytest

import symscrew.model
from support.once import changes_package
from symscrew.mobility import analysis
from symscrew.runtime import model_key

MANY = 64  # models that a process holds so: the last used; those of a file of tests are about thirty


class MadeOnce:
    """In place of a function of a mechanism: an equal description with equal arguments gives the result of before.

    Not while a test changes the package (`monkeypatch`), nor for one whose claim is that two derivations are equal
    (`derived_anew`): these make all as users do, and what they make is not kept.
    """

    def __init__(self, make: Any) -> None:
        self.make, self.kept, self.item = make, dict[Any, Any](), None

    def begin(self, item: pytest.Item) -> None:
        self.item: pytest.Item | None = item

    def __call__(self, mechanism: Any, *effects: Any, **options: Any) -> Any:
        anew = self.item is not None and self.item.get_closest_marker("derived_anew") is not None
        key = model_key(mechanism, *(effects or ((),))), repr(sorted(options.items()))
        if anew or changes_package(self.item) or key[0] is None:  # None: a mechanism that cannot be written
            return self.make(mechanism, *effects, **options)
        found = self.kept.pop(key, None) or self.make(mechanism, *effects, **options)
        self.kept[key] = found
        if len(self.kept) > MANY:
            del self.kept[next(iter(self.kept))]
        return found


derived_once, analysed_once = MadeOnce(symscrew.model._derived), MadeOnce(analysis._analysed)
