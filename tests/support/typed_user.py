"""What a user's type checker sees of the public names; mypy reads it with the package, nothing runs it."""

from typing import assert_type

import symscrew
from symscrew.mobility import Mobility
from symscrew.runtime import CompiledModel
from symscrew.simulation.motion import Run

mechanism = assert_type(symscrew.load_catalogue("four_bar"), symscrew.Mechanism)
model = assert_type(symscrew.derive(mechanism), symscrew.Model)
compiled = assert_type(symscrew.load("out"), CompiledModel)
run = assert_type(symscrew.simulate(symscrew.load_scene("fall.toml")), Run)
mobility = assert_type(symscrew.analyse_mobility(mechanism), Mobility)

symscrew.simulate("fall.toml")  # type: ignore[arg-type]  # a name is no scene: unless mypy refuses this, it warns
