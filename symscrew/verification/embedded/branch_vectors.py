"""States and calls that reach the branches of generated C: what evidence on it is collected with.

a function's own states, random ones, huge ones, NaN and infinity   --> its checks
states where a pivot vanishes (`pivot_vectors`), a rank is lost      --> its second path
small matrices made for it, each handed over by itself              --> every branch of the linear algebra behind
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symscrew.export import Precision
from symscrew.model import Model
from symscrew.program import QUATERNION, Iteration, Port, Program, RankRevealing, evaluate, evaluate_iteration
from symscrew.verification.embedded.pivot_vectors import pivot_states

RANDOM, SEED = 96, 7  # vectors per function whose entries are random: they reach most refusals, and take no time
GUESSES = 64  # of an iteration, up to half a turn off: some lead to another branch
NEAR = 64  # of an iteration, its solution off by about its tolerance: with the loops closed, but the step too large
OFF = (-1.0, 2.0)  # powers of 10 of the tolerance that these are off by
ENTRIES = 64  # of an array of which each is made NaN, infinite, huge by itself: of longer ones the first and last
LENGTHS = (0.9, 1.1)  # of quaternions that are none
STARTS, STEPS = 4, 40  # of Newton's method to where the loops lose their rank: it takes ten from most starts
SLOPE = 1e-7  # step of its differences: half of the digits of a double
LOST = 1e-11  # smallest singular value at which the rank is gone: a hundredth of what the second path takes for 0

# Matrices by columns for the routines behind second paths. Their branches: rotations of either sense, none needed,
# no end of them where there is NaN; pivots that are lost or of growing size; ranks that are full, lost, unknown.
ROUTINES = """
    {
        const REAL bad = (REAL)NAN;
        REAL pairs[5][4] = {{1, 0, 0, 1}, {2, 1, 1, 3}, {3, 1, 1, 2}, {2, -1, 1, 3}, {bad, 0, 0, bad}};
        REAL squares[5][4] = {{1, 2, 2, 1}, {1, 0, 0, 2}, {2, 0, 0, 1}, {4, 2, 2, 3}, {bad, 0, 0, bad}};
        REAL work[64], turn[9], a[3], loads[3], right[2];
        for (int k = 0; k < 5; ++k) {
            right[0] = right[1] = 1;
            MODEL_orthogonalise(2, 2, pairs[k], turn);
            (void)MODEL_cholesky(2, squares[k], right);
        }
        for (int k = 0; k < 6; ++k) {
            REAL mass[9] = {1, 0, 0, 0, 2, 0, 0, 0, 3}, force[3] = {1, 1, 1}, bias[2] = {1, 1};
            REAL rows[6][6] = {{1, 0, 0, 1, 0, 0}, {1, 1, 1, 1, 0, 0}, {9, 0, 0, 1, 1, 0}, {0, 0, 0, 0, 0, 0},
                               {bad, bad, bad, bad, bad, bad}, {1, 0, 0, 1, 1, 1}};
            mass[8] = k == 5 ? -3 : 3;
            (void)MODEL_constrained(3, 2, mass, force, rows[k], bias, turn, work, a, loads);
        }
    }
"""
INTERNAL = """
    {
        REAL rows[3][6] = {{1, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0}, {9, 1, 0, 1, 0, 3}}, loads[9] = {0};
        for (int k = 0; k < 3; ++k) {
            MODEL_internal_load(2, 3, rows[k], 0, loads);
            MODEL_internal_load(2, 3, rows[k], 1, loads);
        }
    }
"""


@dataclass(frozen=True)
class Vectors:
    """States of a function, an array (states, size) per input; per guard the least size that was found of its pivot."""

    arrays: list[np.ndarray]
    least: tuple[float, ...]


def function_vectors(model: Model, name: str, real: Precision) -> Vectors:
    """States that reach the branches of a function, as far as they are found."""
    kind = np.float32 if real.suffix else np.float64
    program = model.programs[name]
    own = [np.atleast_2d(x) for x in model.test_inputs[name]]
    rng = np.random.default_rng(SEED)
    rows = [[x[k] for x in own] for k in range(len(own[0]) if own else 0)]
    for k in range(RANDOM):
        scale = 10.0 ** rng.integers(-3, 3)
        rows.append([x[0] + scale * rng.normal(size=x.shape[1]) * (k % (i + 2) == 0) for i, x in enumerate(own)])
    rows += [_turned(program, row) for row in rows]
    rows.append([_reference(model, port, x[0]) for port, x in zip(program.inputs, own, strict=True)])
    for i, x in enumerate(own):
        for value in (np.nan, np.inf, -np.inf, np.finfo(kind).max, 0.0):
            for entry in range(x.shape[1]) if x.shape[1] <= ENTRIES else (0, x.shape[1] - 1):
                row = [y[0].copy() for y in own]
                row[i][entry] = value
                rows.append(row)
        rows.append([np.zeros_like(y[0]) if j == i else y[0] for j, y in enumerate(own)])
        for length in LENGTHS:
            at = [k for k, form in enumerate(program.inputs[i].forms) if form == QUATERNION]
            rows.append([y[0].copy() for y in own])
            rows[-1][i][at] *= length
    if isinstance(program, Iteration):
        for k in range(GUESSES):
            rows.append([x[k % len(x)] + rng.uniform(-np.pi, np.pi, x.shape[1]) * (i == 1) for i, x in enumerate(own)])
            rows.append(_turned(program, rows[-1]))
        rows += _near_solutions(program, own, real)
    with np.errstate(all="ignore"):
        at_pivots, least = _at_pivots(program, own, rng, real)
        rows += at_pivots
        if isinstance(program, RankRevealing):
            rows += _beside_pivots(program, own, rng)
        return Vectors([np.array([row[i] for row in rows]).astype(kind) for i in range(len(own))], least)


def _reference(model: Model, port: Port, x: np.ndarray) -> np.ndarray:
    """An input at the reference configuration, where every joint's displacement is zero."""
    return np.array(model.system.reference, dtype=float) if port.name in ("q", "guess") else x


def _turned(program: Program | Iteration, row: Sequence[np.ndarray]) -> list[np.ndarray]:
    """A state with quaternions of length 1."""
    found = [np.array(x, dtype=float) for x in row]
    for port, x in zip(program.inputs, found, strict=True):
        at = [k for k, form in enumerate(port.forms) if form == QUATERNION]
        for k in at[::4]:
            x[k : k + 4] /= np.linalg.norm(x[k : k + 4])
    return found


def _near_solutions(program: Iteration, own: Sequence[np.ndarray], real: Precision) -> list[list[np.ndarray]]:
    """Guesses off by about the tolerance: where the loops are closed within it, and the step is smaller or larger."""
    rng = np.random.default_rng(SEED)
    solved = evaluate_iteration(program, own)[0][0]
    sizes = program.tolerance**real.digits * 10.0 ** rng.uniform(*OFF, NEAR)
    rows = []
    for k, size in enumerate(sizes):
        y, _, *more = (x[k % len(x)] for x in own)
        rows.append([y, solved[k % len(solved)] + size * rng.normal(size=solved.shape[-1]), *more])
    return rows


def _at_pivots(
    program: Program | Iteration, own: Sequence[np.ndarray], rng: np.random.Generator, real: Precision
) -> tuple[list[list[np.ndarray]], tuple[float, ...]]:
    """States where pivots vanish and values meet limits; of an iteration those of its step, whose q is the guess."""
    if not isinstance(program, Iteration):
        found = pivot_states(program, own, rng, real)
        return found.states, found.least
    found = pivot_states(program.step, [own[1], own[0], *own[2:]], rng, real)  # (y, guess, p) -> (q, y, p)
    return [[own[0][0], row[0], *row[2:]] for row in found.states], found.least


def _beside_pivots(
    program: RankRevealing, own: Sequence[np.ndarray], rng: np.random.Generator
) -> list[list[np.ndarray]]:
    """States where the closure loses its rank, and the same with huge and infinite rates.

    Newton's method on the smallest singular value that counts, from random q.
    """
    dense, found = program.dense, []
    assert dense is not None
    at = next(k for k, port in enumerate(program.inputs) if port.name == "q")
    turned = [k for k, form in enumerate(program.inputs[at].forms) if form == QUATERNION]
    others = [x[0] for x in own]
    n, m = len(program.rates), len(program.rows)
    scales = np.outer(program.rows, program.rates)

    def closures(q: np.ndarray) -> np.ndarray:
        given = [q if k == at else np.tile(x, (len(q), 1)) for k, x in enumerate(others)]
        matrices: np.ndarray = evaluate(dense, given)[0][2].reshape(len(q), n, m).swapaxes(1, 2) * scales
        return matrices

    for _ in range(STARTS):
        q = own[at][0] + rng.normal(size=own[at].shape[1])
        for _ in range(STEPS):
            for k in turned[::4]:
                q[k : k + 4] /= np.linalg.norm(q[k : k + 4])
            here, *beside = closures(np.vstack([q, q + SLOPE * np.eye(len(q))]))
            left, sizes, right = np.linalg.svd(here)
            least = program.regular - 1
            if sizes[least] < LOST or not np.isfinite(sizes[least]):
                break
            # what the row of the least value loses in the directions that the others do not have: zero at a lost rank
            slope = np.array([right[least:] @ (matrix - here).T @ left[:, least] / SLOPE for matrix in beside]).T
            wanted = np.zeros(len(slope))
            wanted[0] = sizes[least]
            step = np.linalg.lstsq(slope, wanted, rcond=1e-9)[0]
            q = q - step / max(1.0, 2.0 * float(np.abs(step).max()))
        found.append([q if k == at else x for k, x in enumerate(others)])
        for huge in (1e200, np.inf):
            found.append([q if k == at else np.full_like(x, huge) for k, x in enumerate(others)])
    return found


def direct_calls(model: Model, source: str, real: Precision) -> list[str]:
    """Statements of C that call the routines behind functions with what no state of a mechanism makes."""
    lines = []
    if f"{model.name}_constrained(" in source:
        lines += ROUTINES.splitlines()
    if f"{model.name}_internal_load(" in source:
        lines += INTERNAL.splitlines()
    large = "1e25f" if real.suffix else "1e200"  # whose square overflows
    for name, program in model.programs.items():
        if not isinstance(program, RankRevealing):
            continue
        given, lines = [f"x{i}" for i in range(len(program.inputs))], [*lines, "    {"]
        made = [f"made{i}" for i in range(len(program.outputs))]
        for x, values in zip(given, model.test_inputs[name], strict=True):
            body = ", ".join(real.number(float(v)) for v in np.atleast_2d(values)[0]) or real.number(0.0)
            lines.append(f"        const REAL own_{x}[] = {{{body}}};")
        arrays = [f"{y}[{max(port.size, 1)}]" for y, port in zip(made, program.outputs, strict=True)]
        lines.append(f"        REAL {', '.join(arrays)};")
        for first, last in (("(REAL)NAN", "1"), ("1", large), ("2", "1"), (large, "1")):
            lines.append("        {")
            for x, port in zip(given, program.inputs, strict=True):
                factor = last if x == given[-1] and len(given) > 1 else first if x == given[0] else "1"
                lines += [f"            REAL {x}[{max(port.size, 1)}];"]
                lines += [f"            for (int k = 0; k < {max(port.size, 1)}; ++k) {{"]
                lines += [f"                {x}[k] = own_{x}[k] * ({factor}) + (({factor}) > 2 ? ({factor}) : 0);"]
                lines += ["            }"]
            lines += [f"            (void)MODEL_{name}_rank_revealing({', '.join([*given, *made])});", "        }"]
        lines += ["    }"]
    return [line.replace("MODEL", model.name).replace("REAL", real.real) for line in lines]
