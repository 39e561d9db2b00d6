"""The key under which the user's cache keeps what was made of a mechanism and effects."""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.description import Mechanism, to_toml
from symscrew.effects import Effect, effect_to_table
from symscrew.errors import DescriptionError
from symscrew.runtime.user_cache import key_of
from symscrew.runtime.versions import version


def model_key(
    mechanism: Mechanism, effects: Sequence[Effect], independent: Sequence[str] | None = None, *, of: bytes = b"model"
) -> str | None:
    """Of all that a model is made of; None where a mechanism cannot be written. `of`: what is kept, a word."""
    try:
        texts = [to_toml(mechanism), repr(mechanism.warnings), *map(repr, map(_named, effects))]
    except DescriptionError:
        return None
    chosen = [] if independent is None else [f"independent: {list(independent)!r}"]
    return key_of(of, *(text.encode("utf-8", "surrogateescape") for text in (version(), *texts, *chosen)))


def _named(effect: Effect) -> tuple[str, object]:
    return f"{type(effect).__module__}.{type(effect).__qualname__}", effect_to_table(effect)
