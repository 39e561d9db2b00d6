"""The methods by which a scene can be integrated, a row each: what a method is, and which code carries it out.

A new method is a row here and its step: in `simulation/kernels/steps.c` where it has a `kernel`, in
`symscrew.simulation.portable` for runs without a C compiler, with contacts or with a controller in Python.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class IntegrationMethod:
    """How a method goes on.

    `marching`: "fixed" steps of our own, "projected" after every step of a library's one-step method, "restarted" at
    every output because a multistep method cannot go on from a projected state, or by "sundials". `kernel`: number of
    the method in the compiled loop, None where that has it not. `library`: its class in `scipy.integrate`. `stable`:
    largest |h r| of a decaying mode exp(-r t) at which explicit steps h do not grow errors (Hairer, Wanner, Solving
    Ordinary Differential Equations II, section IV.2); None for implicit methods, which have no such limit. `lands`:
    whether steps end where a law of force has a corner. Those of order 1 have larger errors of their own, and so have
    multistep methods: landed or not, lsoda and cvodes are off by the same two digits at every tolerance that was tried.
    """

    marching: str
    kernel: int | None = None
    library: str = ""
    stable: float | None = None
    lands: bool = True

    @property
    def fixed_step(self) -> bool:
        """Whether a scene gives the step; else it gives a tolerance."""
        return self.marching == "fixed"


INTEGRATION_METHODS: Mapping[str, IntegrationMethod] = {
    "dop853": IntegrationMethod("projected", kernel=4, library="DOP853", stable=6.39),
    "rk4": IntegrationMethod("fixed", kernel=2, stable=2.785),
    "rk8": IntegrationMethod("fixed", kernel=3, stable=6.39),
    "euler": IntegrationMethod("fixed", kernel=0, stable=2.0, lands=False),
    "semi_implicit_euler": IntegrationMethod("fixed", kernel=1, stable=2.0, lands=False),
    "cvodes": IntegrationMethod("sundials", lands=False),
    "radau": IntegrationMethod("projected", library="Radau"),
    "bdf": IntegrationMethod("restarted", library="BDF", lands=False),
    "lsoda": IntegrationMethod("restarted", library="LSODA", lands=False),
}
