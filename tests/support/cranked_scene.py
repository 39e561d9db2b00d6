"""A slider-crank with friction and a motor."""

from __future__ import annotations

SCENE = """
[scene]
name = "cranked"
mechanism = "slider_crank"
duration = 0.5
rate = 40
[initial]
rates = {crank_R = 3}
[[effects]]
type = "viscous_friction"
joint = "slider_P"
coefficient = 2
[[effects]]
type = "dc_motor"
joint = "crank_R"
torque_constant = 0.05
resistance = 1.2
inductance = 0.08
ratio = 20
[drives]
crank_R = "0.5*cos(t)"
[inputs]
voltage_crank_R = ["2*cos(t)"]
"""
