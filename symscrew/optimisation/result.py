"""A motion that was found: its dense interpolation, drives, joints, reactions, multipliers and errors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from symscrew.optimisation.consistent_poses import Kinematics
from symscrew.optimisation.guess import default_parameters
from symscrew.optimisation.problem import TrajectoryProblem
from symscrew.optimisation.transcription import Transcribed


@dataclass(frozen=True)
class Errors:
    """How far the motion is from obeying its equations between the points.

    `closure`: largest opening of the loops (without units) of the assembled configurations; `nodal_closure`: of the
    solver's own configurations at the points; `dynamic`: largest error of y_ddot against the drives'
    polynomial [1/s^2];
    `defects` (intervals,): what the error in an interval makes of the end of a replay, the larger of y and, times the
    duration, y_dot; `drift`: their sum, above which a replay does not end off the plan; `cost`: estimated error
    of the cost, in its units; `pivot`: smallest pivot of the closure (0: the coordinates y are singular);
    `violation`: largest violation of a bound between the points, scaled.
    """

    closure: float
    nodal_closure: float
    dynamic: float
    defects: np.ndarray
    drift: float
    cost: float
    pivot: float
    violation: float


@dataclass(frozen=True)
class Statistics:
    """Iterations, and time [s] by part (model, transcription, functions, solver, errors, total), by two clocks.

    `times`: the wall's; `processor`: the processor's, over all threads.
    """

    iterations: int
    times: Mapping[str, float]
    processor: Mapping[str, float]


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
class Trajectory:
    """The outcome of an optimisation; `ok` is False where it is only the best iterate.

    `arrays` are the unknowns by name (rates by relative time), `x`, `multipliers`, `bound_multipliers` the solver's
    own vectors; `cost` is in the units of the objectives; `parameters` the design found, by name. `status` is one
    sentence, `reasons` say which constraints cannot be met, where.
    """

    problem: TrajectoryProblem
    transcribed: Transcribed
    arrays: Mapping[str, np.ndarray]
    x: np.ndarray
    multipliers: np.ndarray
    bound_multipliers: np.ndarray
    cost: float
    cost_scale: float
    ok: bool
    status: str
    statistics: Statistics
    reasons: tuple[str, ...] = ()
    refinements: int = 0

    # -- what it is -------------------------------------------------------------------------------------------

    @property
    def model(self):  # type: ignore[no-untyped-def]
        """The expressions behind it."""
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
        return u if scheme is None else np.einsum("ij,njk->nik", scheme.control, u)

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
        mesh, arrays = self.transcribed.mesh, self.arrays
        found = np.clip(np.searchsorted(mesh, tau, side="right") - 1, 0, len(mesh) - 2)
        k = found if interval is None else interval
        h = (mesh[k + 1] - mesh[k])[:, None]
        s = (tau - mesh[k]) / h[:, 0]
        scheme = self.transcribed.scheme
        if scheme is None:
            from symscrew.optimisation.shooting import dense

            return dense(self, k, s)
        second, sums, twice = scheme.basis(s), scheme.rate_at(s), scheme.position_at(s)

        def mixed(weights: np.ndarray, name: str) -> np.ndarray:
            return np.einsum("nj,njd->nd", weights, arrays[name][k])

        result = {
            "y": arrays["y"][k] + h * s[:, None] * arrays["y_1"][k] + h**2 * mixed(twice, "y_2"),
            "y_1": arrays["y_1"][k] + h * mixed(sums, "y_2"),
            "y_2": mixed(second, "y_2"),
            "x": arrays["x"][k],
        }
        result["u"] = mixed(scheme.bernstein(s), "u")
        for name in ("positive_power", "distribution", "x_1"):
            if name in arrays:
                result[name] = mixed(second, name)
        if "x_1" in arrays:
            result["x"] = result["x"] + h * mixed(sums, "x_1")
        if "jerk" in self.model.kinds:
            slopes = second @ scheme.slope()  # the slope is a polynomial through its values at the nodes
            result["y_3"] = mixed(slopes, "y_2") / h
        return result

    def point_blocks(self) -> dict[str, np.ndarray]:
        """The unknowns of all points, z included: (points, ...)."""
        tau = self.transcribed.point_tau
        blocks = self.blocks(tau.ravel(), np.repeat(np.arange(len(tau)), tau.shape[1]))
        return {**blocks, "z": self.arrays["z"].reshape(tau.size, -1)}

    def configurations(self, tau: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q (n, nq) assembled at ascending relative times, and where that succeeded (n,)."""
        return self.kinematics.assemble_all(y, self._nearest(tau))

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
        closure = self._closure
        found = closure(*self._with_parameters(blocks["y"], z))
        return np.array(found[0]).T

    @cached_property
    def _closure(self) -> ca.Function:
        from symscrew.optimisation.casadi_graph import numeric

        return numeric(self.model.equations.closure)

    def _with_parameters(self, *arrays: np.ndarray) -> list[np.ndarray]:
        n = len(arrays[0])
        columns = [a.T for a in arrays]
        return [*columns, np.repeat(self.parameter_values[:, None], n, 1)] if len(self.parameter_values) else columns

    def _nearest(self, tau: np.ndarray) -> np.ndarray:
        points = self.transcribed.point_tau.ravel()
        right = (
            np.clip(np.searchsorted(points, tau), 1, len(points) - 1) if len(points) > 1 else np.zeros(len(tau), int)
        )
        left = np.maximum(right - 1, 0)
        nearer = np.where(np.abs(points[left] - tau) <= np.abs(points[right] - tau), left, right)
        q = np.nan_to_num(self.point_configurations)
        return q[nearer]

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
        from symscrew.optimisation.casadi_graph import numeric

        function = numeric(self.model.equations.motion)
        v, a = function(*self._with_parameters(*parts))
        return np.array(v).T, np.array(a).T

    def of_tree(self, name: str, samples: Samples) -> np.ndarray:
        """A kinematic function of the model at samples: (n, outputs)."""
        from symscrew.optimisation.casadi_graph import numeric

        program = self.model.equations.tree_function(name)
        return self._evaluated(numeric(program), [p.name for p in program.inputs], samples)

    def reactions(self, samples: Samples) -> np.ndarray:
        """Reactions of all joints (f ; m_O), absolute axes: (n, 6 joints)."""
        from symscrew.optimisation.casadi_graph import numeric

        program = self.model.equations.reactions
        return self._evaluated(numeric(program), [p.name for p in program.inputs], samples)

    def margins(self, samples: Samples) -> dict[str, np.ndarray]:
        """Singularity margins along the motion."""
        from symscrew.optimisation.casadi_graph import numeric

        result: dict[str, np.ndarray] = {}
        for program in self.model.equations.margins:
            values = self._evaluated(numeric(program), [p.name for p in program.inputs], samples)
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

    # -- errors ------------------------------------------------------------------------------------------------

    @cached_property
    def errors(self) -> Errors:
        """Errors between the points."""
        from symscrew.optimisation.mesh_errors import errors_of

        return errors_of(self)
