"""Models for all configurations, and for one operation mode."""

from __future__ import annotations

from functools import cache

import numpy as np

from support.model_states import differentiated, model
from symscrew import catalogue
from symscrew.description import toml_file
from symscrew.description.mechanism import Mechanism
from symscrew.model import Model, derive, inputs_at

PARALLELOGRAM = """
[mechanism]
name = "parallelogram"
ground = "base"

[bodies.crank]
mass = "0.5"
com = ["1/20", 0, "3/20"]
inertia = [["3/800", 0, "-1/800"], [0, "1/240", 0], ["-1/800", 0, "1/2400"]]

[bodies.coupler]
mass = "1.2"
com = ["7/20", 0, "3/10"]
inertia = [[0, 0, 0], [0, "1/40", 0], [0, 0, "1/40"]]

[bodies.rocker]
mass = "0.5"
com = ["11/20", 0, "3/20"]
inertia = [["3/800", 0, "-1/800"], [0, "1/240", 0], ["-1/800", 0, "1/2400"]]

[joints]
A = {type = "R", parent = "base", child = "crank", point = [0, 0, 0], axes = [[0, 1, 0]], driven = true}
B = {type = "R", parent = "crank", child = "coupler", point = ["1/10", 0, "3/10"], axes = [[0, 1, 0]]}
C = {type = "R", parent = "coupler", child = "rocker", point = ["3/5", 0, "3/10"], axes = [[0, 1, 0]]}
D = {type = "R", parent = "base", child = "rocker", point = ["1/2", 0, 0], axes = [[0, 1, 0]]}
"""


@cache
def parallelogram() -> Mechanism:
    return toml_file.parse_description(PARALLELOGRAM)


@cache
def models(name: str, derivatives: bool = False) -> tuple[Model, Model]:
    """The general model, and that of the mode."""
    if name == "parallelogram":
        return derive(parallelogram(), derivatives=True), derive(parallelogram(), derivatives=True, one_mode=True)
    general = differentiated(name) if derivatives else model(name)
    return general, derive(catalogue.load(name), derivatives=derivatives, one_mode=True)


def states(given_model: Model, name: str) -> list[np.ndarray]:
    """Inputs of a function at other consistent states than those the mode was found at."""
    q, v, a = given_model.system.states(12, 5)
    random = np.random.default_rng(3)
    ports = given_model.programs[name].inputs
    known = {"q": q, "v": v, "a": a}
    given = zip(ports, inputs_at(given_model.system, given_model.programs[name], (q, v, a)), strict=True)
    known |= {p.name: values for p, values in given if p.name in ("pose", "rate", "acceleration")}
    return [known.get(p.name, random.uniform(-1, 1, (len(q), p.size))) for p in ports]
