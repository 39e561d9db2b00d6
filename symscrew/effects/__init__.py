"""Effects: what acts on a mechanism beyond its own inertia. One file per effect; nothing when not asked for."""

from symscrew.effects.external_wrench import ExternalWrench
from symscrew.effects.gravity import Gravity

Effect = Gravity | ExternalWrench

__all__ = ["Effect", "ExternalWrench", "Gravity"]
