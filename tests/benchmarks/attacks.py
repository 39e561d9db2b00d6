"""The table of attacks: each is carried out, in a process of its own, and what came of it is printed."""

from __future__ import annotations

from typing import Any

from symscrew.description import markdown_text
from tests.support.attacks import every_attack

from .tables import table


def run(*, repeats: int) -> tuple[str, dict[str, Any]]:
    """A row per attack. `repeats` says how often each is carried out; the worst outcome is shown."""
    rounds = [every_attack() for _ in range(repeats)]
    worst = [min(outcomes, key=lambda outcome: outcome.withstood) for outcomes in zip(*rounds, strict=True)]
    rows = [(o.attack.target, o.attack.name, "yes" if o.withstood else "**NO**", markdown_text(o.text)) for o in worst]
    count = sum(o.withstood for o in worst)
    text = table(["attacked", "by", "withstood", "outcome"], rows)
    found = [{"target": o.attack.target, "name": o.attack.name, "ok": o.withstood, "text": o.text} for o in worst]
    return f"{text}\n\n{count} of {len(worst)} withstood", {"attacks": found}
