"""A plant's functions for calls from Python: compiled where there is a compiler, else on NumPy.

t, q, v, x --slopes--> v_dot, x_dot;    q, v near the closed loops --settle--> q, v on them
"""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from symscrew.program import RankRevealing, evaluate, evaluate_rank_revealing
from symscrew.runtime import compile_c
from symscrew.scene import Table
from symscrew.simulation.run_source import generated
from symscrew.simulation.state_programs import Plant

CLOSED = 1e-14  # opening of the loops, without units, at which Newton's steps end: nothing is left but rounding
GOOD = 1e-11  # an opening that no longer halves is taken as closed below this; above it the run is stopped
# Singular values below this part of the largest are directions that the closure does not hold in this configuration:
# no step is made along them. Larger: ill-conditioned loops are left open; smaller: steps jump at singularities.
RANK = 1e-9
# Of a start, as of one of compiled runs (kernels/start.c): what rounding leaves open, as part of the largest coordinate
# or rate, and by how many times what was open it may be moved.
ROUNDED, FEW_TURNS, MAGNIFIED = 1e-13, 100.0, 1e3
MOST_STEPS = 12  # of Newton's method, which doubles the digits from a state that was closed one step before
LARGEST_STEP = 1.0  # [1, rad]: a longer one leads to another assembly branch; the run is stopped

VAGUE = (
    "the start is beside a singular configuration and off the loops by more than rounding, and going onto them would "
    "move it a thousand times as far: give coordinates and rates with all digits"
)


class RunError(ArithmeticError):
    """The state cannot be evaluated or the loops cannot be closed; the message says why."""


class PlantFunctions:
    """Slopes and closure of a plant at single states, and steps on the manifold that the closure leaves."""

    def __init__(self, plant: Plant, tables: Sequence[Table], *, compiled: bool) -> None:
        self.plant, self.tables = plant, tuple(tables)
        self.system = plant.system
        sizes = plant.sizes
        self.nq, self.nv, self.nx, self.nu = (sizes[k] for k in ("q", "v", "x", "u"))
        self.spheres = self.system.tree.spheres
        self.plain = np.array(self.system.tree.plain, dtype=int).reshape(-1, 2)
        self.evaluations = 0
        self._library = self._compiled() if compiled else None

    def _compiled(self) -> ctypes.CDLL:
        with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
            folder, name = Path(temporary), self.plant.model.name
            for file, text in generated(self.plant).items():
                (folder / file).write_text(text, encoding="utf-8")
            compile_c(folder / f"{name}.c", folder / "functions.so")
            return ctypes.CDLL(str(folder / "functions.so"))

    def signals(self, t: float, outside: np.ndarray) -> np.ndarray:
        """Values of the tables at t, then forces from outside."""
        return np.array([*(float(table(t)) for table in self.tables), *outside])

    def slopes(
        self, t: float, q: np.ndarray, v: np.ndarray, x: np.ndarray, *, u: np.ndarray, outside: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Accelerations (nv,) and rates of the states (nx,).

        `u`: drives from outside [N, N m], empty where the scene commands them; `outside`: forces of contacts.

        Raises:
            RunError: they are not defined at this state.
        """
        self.evaluations += 1
        plant = self.plant
        arrays = [np.array([t]), q, v, x, u, self.signals(t, outside), plant.parameters]
        if self._library is None:
            (a, x_dot), status = evaluate(plant.slopes, arrays)
            outcome = int(status)
        else:
            a, x_dot = np.empty(self.nv), np.empty(self.nx)
            outcome = self._call("slopes", arrays, [a, x_dot])
        if outcome == 1:  # a pivot is small: the model's own function has a second path, which costs more
            commanded, _ = evaluate(plant.inputs, arrays)
            known = dict(zip(("t", "q", "v", "x", "u", "s", "p"), arrays, strict=True))
            known |= {p.name.removesuffix("_command"): c for p, c in zip(plant.inputs.outputs, commanded, strict=True)}
            effect_states = sum(p.size for p in plant.forward.inputs if p.name == "x")
            known["x"] = x[:effect_states]
            arguments = [known[p.name] for p in plant.forward.inputs]
            if isinstance(plant.forward, RankRevealing):
                results, status = evaluate_rank_revealing(plant.forward, arguments)
            else:
                results, status = evaluate(plant.forward, arguments)
            outcome = max(int(status), 0)
            a, x_dot = results[0], np.zeros(self.nx)
            if plant.rates is not None and self.nx:
                (x_dot,), _ = evaluate(plant.rates, arrays)
        if outcome > 0:
            raise RunError(f"the accelerations are not defined (status {outcome})")
        return a, x_dot

    def switches(self, t: float, q: np.ndarray, v: np.ndarray, x: np.ndarray, *, u: np.ndarray) -> np.ndarray:
        """What the slopes compare (n,), whose signs change at corners of the motion's law."""
        plant = self.plant
        assert plant.switches is not None
        arrays = [np.array([t]), q, v, x, u, self.signals(t, np.zeros(len(plant.outside))), plant.parameters]
        if self._library is None:
            return np.asarray(evaluate(plant.switches, arrays)[0][0]).ravel()
        g = np.empty(plant.switches.outputs[0].size)
        self._call("switches", arrays, [g])
        return g

    def state_units(self) -> np.ndarray:
        """Sizes of (q, v, x) where it is zero; states have none."""
        places = [self.system.length if c.kind == "length" else 1.0 for c in self.system.tree.q]
        return np.array([*places, *self.plant.units, *np.zeros(self.nx)])

    def _call(self, name: str, inputs: Sequence[np.ndarray], outputs: Sequence[np.ndarray]) -> int:
        assert self._library is not None
        arrays = [np.ascontiguousarray(a, dtype=float) for a in inputs] + list(outputs)
        function = getattr(self._library, f"{self.plant.model.name}_{name}")
        return int(function(*[ctypes.c_void_p(a.ctypes.data) for a in arrays]))

    def opening(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Residual (rows,) and Jacobian (rows, nv) of the closure without units."""
        plant, n = self.plant, self.nv
        if plant.closure is None:
            return np.zeros(0), np.zeros((0, n))
        m = len(plant.rows)
        arrays = [q, plant.parameters][: len(plant.closure.inputs)]
        if self._library is None:
            (residual, jacobian), _ = evaluate(plant.closure, arrays)
        else:
            residual, jacobian = np.empty(m), np.empty(len(plant.entries))
            self._call("closure_both", arrays, [residual, jacobian])
        matrix = np.zeros((m, n))
        matrix[plant.entries[:, 0], plant.entries[:, 1]] = jacobian
        return residual * plant.rows, matrix * plant.rows[:, None] * plant.units

    def coordinate_rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Rates of q: those of quaternions are half of q times omega."""
        rates = np.zeros(self.nq)
        rates[self.plain[:, 0]] = v[self.plain[:, 1]]
        for i, k in self.spheres:
            w, r, omega = q[i], q[i + 1 : i + 4], v[k : k + 3]
            rates[i] = -0.5 * r @ omega
            rates[i + 1 : i + 4] = 0.5 * (w * omega + np.cross(r, omega))
        return rates

    def moved(self, q: np.ndarray, step: np.ndarray) -> np.ndarray:
        """q after rotation vectors and shifts in the rates' axes."""
        result = np.array(q)
        result[self.plain[:, 0]] += step[self.plain[:, 1]]
        for i, k in self.spheres:
            turn = step[k : k + 3]
            angle = float(np.linalg.norm(turn))
            c, s = np.cos(angle / 2), 0.5 * np.sinc(angle / 2 / np.pi)
            w, r = q[i], q[i + 1 : i + 4]
            result[i] = w * c - s * (r @ turn)
            result[i + 1 : i + 4] = c * r + s * (w * turn + np.cross(r, turn))
        return self.normalised(result)

    def normalised(self, q: np.ndarray) -> np.ndarray:
        """q with unit quaternions."""
        result = np.array(q)
        for i, _ in self.spheres:
            result[i : i + 4] /= np.linalg.norm(result[i : i + 4])
        return result

    def settled_start(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """q and v of a start on the closure: as they are where rounding alone leaves them open.

        Raises:
            RunError: they are off by more, beside a singular configuration where going there would move them far.
        """
        if self.plant.closure is None:
            return self.settle(q, v)[:2]
        residual, jacobian = self.opening(q)
        units, places = self.plant.units, q[self.plain[:, 0]] / self.plant.units[self.plain[:, 1]]
        fastest = float(np.abs(v / units).max(initial=0.0))
        open_by, missed = (float(np.abs(a).max()) for a in (residual, jacobian @ (v / units)))
        rounding = ROUNDED * max(1.0, float(np.abs(places).max(initial=0.0)) / FEW_TURNS)
        if open_by <= rounding and missed <= ROUNDED * fastest:
            return self.normalised(q), v
        other, rates, _ = self.settle(q, v)
        known = max(open_by, rounding)
        moved = np.abs(other[self.plain[:, 0]] / units[self.plain[:, 1]] - places).max(initial=0.0)
        for i, _ in self.spheres:
            moved = max(moved, 2 * np.abs(other[i : i + 4] - q[i : i + 4]).max())
        changed = np.abs((rates - v) / units).max(initial=0.0)
        if moved > MAGNIFIED * known or changed > MAGNIFIED * max(missed, known * fastest):
            raise RunError(VAGUE)
        return other, rates

    def settle(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
        """q and v back on the closure by smallest weighted steps, and the smallest regular singular value."""
        q = self.normalised(q)
        if self.plant.closure is None:
            return q, v, 1.0
        units, before = self.plant.units, np.inf
        for _ in range(MOST_STEPS):
            residual, jacobian = self.opening(q)
            left, values, right = np.linalg.svd(jacobian, full_matrices=False)
            keep = values > RANK * values[0]
            open_by = np.abs(residual).max()
            if open_by < CLOSED or (open_by < GOOD and open_by > 0.5 * before):
                break
            before = open_by
            step = right[keep].T @ ((left[:, keep].T @ residual) / values[keep])
            if not np.isfinite(open_by) or np.abs(step).max() > LARGEST_STEP:
                raise RunError("the loops could not be closed again")
            q = self.moved(q, -step * units)
        else:
            if open_by > GOOD:
                raise RunError("the loops could not be closed again")
        scaled = v / units
        for _ in range(2):  # once more for what rounding left of the first
            scaled = scaled - right[keep].T @ ((left[:, keep].T @ (jacobian @ scaled)) / values[keep])
        return q, scaled * units, float(values[self.plant.rank - 1]) if self.plant.rank else 1.0
