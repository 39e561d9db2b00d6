"""Scenes: a mechanism, what acts on it, how it starts and is driven, and how its motion is to be integrated.

`load_scene` reads a TOML file, `parse_scene` a text; see `symscrew.scene.scene_file` for the keys.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.scene.contents import Initial, Integrator, Scene, Table
    from symscrew.scene.controllers import controller, parameter_values
    from symscrew.scene.integration_methods import INTEGRATION_METHODS
    from symscrew.scene.robot_files import Robot, load_robot, robot_of, save_robot, scene_text
    from symscrew.scene.scene_file import load_scene, parse_scene
    from symscrew.scene.time_features import UNCHANGING, TimeFeatures, features_in_time

__all__ = [
    "INTEGRATION_METHODS",
    "UNCHANGING",
    "Initial",
    "Integrator",
    "Robot",
    "Scene",
    "Table",
    "TimeFeatures",
    "controller",
    "features_in_time",
    "load_robot",
    "load_scene",
    "parameter_values",
    "parse_scene",
    "robot_of",
    "save_robot",
    "scene_text",
]

__getattr__ = doors(__name__)
