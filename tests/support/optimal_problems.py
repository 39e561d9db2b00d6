"""Problems of trajectory optimisation that several tests share."""

from __future__ import annotations

from symscrew import catalogue
from symscrew.description.builder import MechanismBuilder
from symscrew.description.mechanism import Mechanism
from symscrew.effects.gravity import Gravity
from symscrew.optimisation.problem import Bounds, Conditions, Objective, TrajectoryProblem, Transcription

KELLY = {"cart": 1.0, "pole": 0.3, "length": 0.5, "gravity": 9.81, "travel": 2.0, "force": 20.0, "goal": 1.0}


def slider() -> Mechanism:
    """A mass of 1 kg on a driven slide."""
    made = MechanismBuilder("slider")
    made.body("mass", mass=1, com=[0, 0, 0])
    made.joint("slide", "P", parent="base", child="mass", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    return made.build()


def pendulum(arm: float = 0.0) -> Mechanism:
    """1 kg at 1 m below a driven hinge, hanging at angle 0; `arm` [m] beside it along its axis."""
    made = MechanismBuilder("pendulum", platform="bob")
    made.body("bob", mass=1, com=[0, repr(arm), -1])
    made.joint("hinge", "R", parent="base", child="bob", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    return made.build()


def bead() -> Mechanism:
    """1 kg on two driven slides, x and z, with a post beside it."""
    made = MechanismBuilder("bead", platform="bead")
    made.body("carriage")
    made.body("bead", mass=1, com=[0, 0, 0])
    made.joint("x", "P", parent="base", child="carriage", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("z", "P", parent="carriage", child="bead", point=[0, 0, 0], axes=[[0, 0, 1]], driven=True)
    made.point("bead", body="bead", at=[0, 0, 0])
    made.point("post", body="base", at=[0, 0, "0.1"])
    return made.build()


def cart_pole() -> Mechanism:
    """Cart-pole of M. Kelly, An Introduction to Trajectory Optimization, SIAM Review 59(4), 2017, section 6."""
    made = MechanismBuilder("cart_pole")
    made.body("cart", mass="1", com=[0, 0, 0])
    made.body("pole", mass="0.3", com=[0, 0, "-0.5"])
    made.joint("slide", "P", parent="base", child="cart", point=[0, 0, 0], axes=[[1, 0, 0]], driven=True)
    made.joint("hinge", "R", parent="cart", child="pole", point=[0, 0, 0], axes=[[0, -1, 0]])
    return made.build()


def cart_pole_problem(transcription: Transcription) -> TrajectoryProblem:
    """Swing-up in 2 s over 1 m with least effort, on the given mesh."""
    return TrajectoryProblem(
        cart_pole(),
        duration=2.0,
        start=Conditions(coordinates={"slide": 0.0, "hinge": 0.0}, at_rest=True),
        end=Conditions(coordinates={"slide": KELLY["goal"], "hinge": 3.141592653589793}, at_rest=True),
        bounds=Bounds(drives={"slide": (-20.0, 20.0)}, joints={"slide": (-2.0, 2.0)}),
        independent=("slide", "hinge"),
        transcription=transcription,
        accuracy=None,
    )


def rest_to_rest(start: dict[str, float], end: dict[str, float]) -> dict[str, Conditions]:
    """Start and end at rest."""
    return {"start": Conditions(coordinates=start, at_rest=True), "end": Conditions(coordinates=end, at_rest=True)}


SEED_MOTION = rest_to_rest({"limb5_S.qx": 0.08, "limb5_S.qy": -0.05}, {"limb5_S.qx": -0.06, "limb5_S.qy": 0.07})
SEED_DRIVES = tuple(f"limb{k}_P" for k in (1, 2, 3, 4))


def seed(limit: float = 60.0, **settings) -> TrajectoryProblem:  # type: ignore[no-untyped-def]
    """The seed mechanism between two orientations in general position, drives within +-limit [N]; no refinement."""
    bounds = Bounds(drives=dict.fromkeys(SEED_DRIVES, (-limit, limit)))
    mechanism = catalogue.load("three_ups_upu_s_physical")
    usual = {"duration": 1.0, "bounds": bounds, "accuracy": None, **SEED_MOTION}
    return TrajectoryProblem(mechanism, **{**usual, **settings})


MINIMUM_TIME = {"duration": (0.05, 5.0), "objectives": (Objective("time"),)}

__all__ = [
    "KELLY", "MINIMUM_TIME", "SEED_DRIVES", "SEED_MOTION", "Gravity", "bead", "cart_pole", "cart_pole_problem",
    "pendulum", "rest_to_rest", "seed", "slider",
]  # fmt: skip
