"""Effects: what acts on a mechanism beyond its own inertia. One file per effect; nothing when not asked for."""

from symscrew.effects.acting import Acting, Effect
from symscrew.effects.external_wrench import ExternalWrench
from symscrew.effects.gravity import Gravity

__all__ = ["Acting", "Effect", "ExternalWrench", "Gravity"]
