"""Scenes: a mechanism, what acts on it, how it starts and is driven, and how its motion is to be integrated.

`load` reads a TOML file, `loads` a text; see `symscrew.scene.reading` for the keys.
"""

from symscrew.scene.reading import load, loads
from symscrew.scene.scene import Initial, Integrator, Scene, Table

__all__ = ["Initial", "Integrator", "Scene", "Table", "load", "loads"]
