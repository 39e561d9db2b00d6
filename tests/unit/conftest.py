"""What makes a test a unit test: it compiles nothing, and derives nothing larger than the four-bar."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

import symscrew.model
from symscrew import catalogue
from symscrew.runtime import compilers

LARGEST = len(catalogue.load("four_bar").bodies)


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    system = symscrew.model.System

    def of_few_bodies(mechanism: Any, *given: Any, **options: Any) -> Any:
        assert len(mechanism.bodies) <= LARGEST, f"{mechanism.name} is larger than the four-bar: no unit test"
        return system(mechanism, *given, **options)

    def nothing_is_compiled(*_: Any, **options: Any) -> None:
        raise AssertionError("a compiler is called: no unit test")

    monkeypatch.setattr(symscrew.model, "System", of_few_bodies)
    monkeypatch.setattr(compilers, "attempts", nothing_is_compiled)
    yield
