"""A motion as its transcription describes it: between the points, at any time, with all that follows from it.

unknowns at points --polynomials--> y, y', y'', u --closed loops--> q, v, a --programs--> reactions, margins ...
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from symscrew.optimisation.casadi_graph import numeric_function
from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.guess import default_parameters
from symscrew.optimisation.point_model import PointModel
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.shooting_polynomials import end_accelerations, quintic
from symscrew.optimisation.tableau import Tableau
from symscrew.optimisation.transcription import Transcribed


@dataclass(frozen=True)
class Samples:
    """The motion at n times: t [s], y, y_dot, y_ddot (n, d), q (n, nq), v, a (n, nv), u (n, nu), x (n, states),
    z (n, nz); assembled (n,) tells where the loops could be closed."""

    t: np.ndarray
    y: np.ndarray
    y_dot: np.ndarray
    y_ddot: np.ndarray
    q: np.ndarray
    v: np.ndarray
    a: np.ndarray
    u: np.ndarray
    x: np.ndarray
    z: np.ndarray
    assembled: np.ndarray


@dataclass(frozen=True)
class PlannedMotion:
    """A motion by its unknowns.

    `arrays` are the unknowns by name (rates by relative time): `y`, `y_1`, `x` (intervals + 1, ...) at the ends of the
    intervals, the others (intervals, points, ...) at the points inside, `T`, `p` once.
    """

    problem: TrajectoryProblem
    transcribed: Transcribed
    arrays: Mapping[str, np.ndarray]

    # -- what it is -------------------------------------------------------------------------------------------

    @property
    def model(self) -> PointModel:
        """The problem with its equations."""
        return self.transcribed.model

    @property
    def duration(self) -> float:
        """Duration of the motion [s]."""
        if "T" in self.arrays:
            return float(self.arrays["T"][0])
        assert not isinstance(self.problem.duration, tuple)
        return float(self.problem.duration)

    @property
    def mesh(self) -> np.ndarray:
        """Times of the ends of the intervals [s]."""
        return self.transcribed.mesh * self.duration

    @property
    def points(self) -> np.ndarray:
        """Times of the points at which the drives are unknowns [s]."""
        return self.transcribed.point_tau.ravel() * self.duration

    @property
    def drives_at_points(self) -> np.ndarray:
        """Drives at `points`: (points, drives)."""
        return self.nodal_drives.reshape(-1, len(self.drive_labels))

    @property
    def nodal_drives(self) -> np.ndarray:
        """Drives at the points of every interval: (intervals, points, drives)."""
        scheme = self.transcribed.scheme
        u = self.arrays["u"]
        return u if scheme is None else np.asarray(np.einsum("ij,njk->nik", scheme.control, u))

    @property
    def drive_labels(self) -> tuple[str, ...]:
        """Labels of u."""
        return self.model.drive_labels

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of y."""
        return self.model.equations.labels

    @property
    def parameters(self) -> dict[str, float]:
        """The design parameters found."""
        return {name: float(self.arrays["p"][k]) for k, name in enumerate(self.model.design)}

    @cached_property
    def parameter_values(self) -> np.ndarray:
        """All run-time parameters with the design put in."""
        values = default_parameters(self.model)
        for name, value in self.parameters.items():
            values[self.model.parameter_names.index(name)] = value
        return values

    # -- interpolation -----------------------------------------------------------------------------------------

    def blocks(self, tau: np.ndarray, interval: np.ndarray | None = None) -> dict[str, np.ndarray]:
        """The unknowns of a point at relative times (n,), by their polynomials; without z.

        `interval` (n,) says whose polynomials are meant at the ends of intervals; default: the later one's.
        """
        tau = np.atleast_1d(np.asarray(tau, dtype=float))
        mesh, scheme = self.transcribed.mesh, self.transcribed.scheme
        found = np.clip(np.searchsorted(mesh, tau, side="right") - 1, 0, len(mesh) - 2)
        k = found if interval is None else interval
        s = (tau - mesh[k]) / (mesh[k + 1] - mesh[k])
        if scheme is None:
            return quintic(self.arrays, mesh, self._end_accelerations, k=k, s=s)
        return self._collocated(scheme, k, s)

    def _collocated(self, scheme: Tableau, k: np.ndarray, s: np.ndarray) -> dict[str, np.ndarray]:
        """The unknowns at parts s (n,) of the intervals k (n,) by the polynomials of the collocation."""
        arrays, h = self.arrays, np.diff(self.transcribed.mesh)[k][:, None]
        second, sums, twice = scheme.basis(s), scheme.rate_at(s), scheme.position_at(s)

        def mixed(weights: np.ndarray, name: str) -> np.ndarray:
            return np.asarray(np.einsum("nj,njd->nd", weights, arrays[name][k]))

        result = {
            "y": arrays["y"][k] + h * s[:, None] * arrays["y_1"][k] + h**2 * mixed(twice, "y_2"),
            "y_1": arrays["y_1"][k] + h * mixed(sums, "y_2"),
            "y_2": mixed(second, "y_2"),
            "x": arrays["x"][k],
        }
        result["u"] = mixed(scheme.bernstein(s), "u")
        own = [name for name, array in arrays.items() if array.ndim == 3 and name not in ("y_2", "z", "u")]
        result |= {name: mixed(second, name) for name in own}
        if "x_1" in arrays:
            result["x"] = result["x"] + h * mixed(sums, "x_1")
        if "y_3" in self.transcribed.families[0].function.blocks:
            slopes = second @ scheme.slope()  # the slope is a polynomial through its values at the nodes
            result["y_3"] = mixed(slopes, "y_2") / h
        return result

    @cached_property
    def _end_accelerations(self) -> tuple[np.ndarray, np.ndarray]:
        return end_accelerations(self.kinematics, self.arrays, self.transcribed.mesh, self.duration)

    def point_blocks(self) -> dict[str, np.ndarray]:
        """The unknowns of all points, z included: (points, ...)."""
        tau = self.transcribed.point_tau
        blocks = self.blocks(tau.ravel(), np.repeat(np.arange(len(tau)), tau.shape[1]))
        return {**blocks, "z": self.arrays["z"].reshape(tau.size, -1)}

    def configurations(self, tau: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q (n, nq) assembled at ascending relative times, and where that succeeded (n,)."""
        return self.kinematics.assemble_all(y, self.nearest(tau)[1])

    @cached_property
    def kinematics(self) -> Kinematics:
        """Numeric kinematics with the design put in."""
        return Kinematics(self.model, self.parameter_values)

    @cached_property
    def point_configurations(self) -> np.ndarray:
        """q at the points from the solver's own y and z: (points, nq)."""
        layout = self.model.equations.layout
        blocks = self.blocks(self.transcribed.point_tau.ravel())
        z = self.arrays["z"].reshape(len(blocks["y"]), len(layout.z))
        return self.kinematics.closure(blocks["y"], z)[0]

    def nearest(self, tau: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The points nearest to relative times: their times (n,) and the solver's configurations q (n, nq) there."""
        points = self.transcribed.point_tau.ravel()
        right = (
            np.clip(np.searchsorted(points, tau), 1, len(points) - 1) if len(points) > 1 else np.zeros(len(tau), int)
        )
        left = np.maximum(right - 1, 0)
        nearer = np.where(np.abs(points[left] - tau) <= np.abs(points[right] - tau), left, right)
        q = np.nan_to_num(self.point_configurations)
        return points[nearer], np.asarray(q[nearer])

    def sample(self, t: np.ndarray | None = None, *, count: int = 201) -> Samples:
        """The motion at times t [s], or at `count` equal ones; configurations are assembled, so loops are closed."""
        tau = np.linspace(0, 1, count) if t is None else np.asarray(t, dtype=float) / self.duration
        return self.sampled(tau)

    def sampled(self, tau: np.ndarray) -> Samples:
        """The motion at relative times."""
        blocks = self.blocks(tau)
        T = self.duration
        q, good = self.configurations(tau, blocks["y"])
        z = q[:, list(self.model.equations.layout.z)]
        y_dot, y_ddot = blocks["y_1"] / T, blocks["y_2"] / T**2
        v, a = self._motion(blocks["y"], z, y_dot, y_ddot)
        return Samples(tau * T, blocks["y"], y_dot, y_ddot, q, v, a, blocks["u"], blocks["x"], z, good)

    def _motion(self, *parts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        function = numeric_function(self.model.equations.motion)
        v, a = function(*self.kinematics.columns(*parts))
        return np.array(v).T, np.array(a).T

    def of_tree(self, name: str, samples: Samples) -> np.ndarray:
        """A kinematic function of the model at samples: (n, outputs)."""
        program = self.model.equations.tree_function(name)
        return self._evaluated(numeric_function(program), [p.name for p in program.inputs], samples)

    def reactions(self, samples: Samples) -> np.ndarray:
        """Reactions of all joints (f ; m_O), absolute axes: (n, 6 joints)."""
        program = self.model.equations.reactions
        return self._evaluated(numeric_function(program), [p.name for p in program.inputs], samples)

    def margins(self, samples: Samples) -> dict[str, np.ndarray]:
        """Singularity margins along the motion."""
        result: dict[str, np.ndarray] = {}
        for program in self.model.equations.margins:
            values = self._evaluated(numeric_function(program), [p.name for p in program.inputs], samples)
            result |= {label: values[:, k] for k, label in enumerate(program.outputs[0].labels)}
        return result

    def _evaluated(self, function: ca.Function, names: list[str], samples: Samples) -> np.ndarray:
        n = len(samples.t)
        known = {
            "q": samples.q, "v": samples.v, "a": samples.a, "u": samples.u, "x": samples.x, "t": samples.t[:, None],
            "p": np.repeat(self.parameter_values[None], n, 0),
        }  # fmt: skip
        for port, _ in self.model.equations.acting.own_inputs:
            known[port.name] = np.tile(self.problem.inputs.get(port.name, (0.0,) * port.size), (n, 1))
        found = function.map(n)(*[known[name].T for name in names])
        return np.array(found).T
