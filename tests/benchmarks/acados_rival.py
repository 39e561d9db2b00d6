"""The same motions again and again by acados on the generated functions: rates beside `re_optimisation`.

`python -m tests.benchmarks.acados_rival`, where `ACADOS_SOURCE_DIR` says where acados is and `LD_LIBRARY_PATH` has its
lib. States (y, y_dot), 20 steps of Runge-Kutta 4 with drives that are constant in each, so that costs differ from those
of collocation; SQP with exact Hessians and HPIPM, from the last motion. The reduced model's C gives x_dot with its
derivatives of both orders.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from symscrew.export import library_sources, print_c, print_reduced
from symscrew.model import derive
from symscrew.runtime import compile_c

from .re_optimisation import SHARES, SOLVES, moved, problems
from .tables import table

NEEDED = (
    "assemble", "forward_dynamics_independent", "forward_dynamics_independent_derivatives",
    "forward_dynamics_independent_hessian",
)  # fmt: skip
NODES = 20


def rates(name: str) -> dict[str, Any]:
    """Processor seconds of solves, and their costs."""
    problem = problems()[name]
    model = derive(problem.mechanism, independent=problem.independent, derivatives=True, second_derivatives=True)
    model = model.only(NEEDED)
    folder = Path(tempfile.mkdtemp())
    for file, text in {**print_c(model, batches=False), **print_reduced(model)}.items():
        (folder / file).write_text(text)
    first, *others = library_sources((path.name for path in folder.iterdir()), model.name)
    library = folder / "libreduced.so"
    more = [str(folder / other) for other in (*others, f"{model.name}_reduced.c")]
    compile_c(folder / first, library, flags=["-O2", "-Wl,-soname,libreduced.so", *more])
    ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)  # acados's library asks for it by this name

    def state(coordinates: dict[str, float]) -> np.ndarray:
        y = np.array([coordinates[label] for label in model.independent])
        return np.concatenate([y, 0 * y])

    start, goal = (state(dict(c.coordinates)) for c in (problem.start, problem.end))
    solver = _solver(ca.external(f"{model.name}_ode", str(library)), problem, folder, start=start, goal=goal)
    for k in range(NODES + 1):
        solver.set(k, "x", start + (goal - start) * k / NODES)
    assert solver.solve() == 0
    found: dict[str, Any] = {"cost": solver.get_cost()}
    for share in SHARES:
        spent = []
        for k in range(SOLVES):
            now = state(moved(problem, share * (k + 1)))
            solver.set(0, "lbx", now)
            solver.set(0, "ubx", now)
            began = time.process_time()
            said = solver.solve()
            spent.append(time.process_time() - began)
            assert said == 0, said
        found[f"warm {share:g}"] = {
            "median": float(np.median(spent)),
            "steps": int(np.ravel(solver.get_stats("sqp_iter"))[0]),
        }
    return found


def _solver(ode: ca.Function, problem: Any, folder: Path, *, start: np.ndarray, goal: np.ndarray) -> Any:
    from acados_template import AcadosModel, AcadosOcp, AcadosOcpSolver  # type: ignore[import-not-found]

    h, nx, nu = float(problem.duration) / NODES, ode.size1_in(0), ode.size1_in(1)
    x, u = ca.MX.sym("x", nx), ca.MX.sym("u", nu)
    model, ocp = AcadosModel(), AcadosOcp()
    model.name, model.x, model.u = f"{ode.name()}_ocp", x, u
    k1 = ode(x, u)
    k2 = ode(x + h / 2 * k1, u)
    k3 = ode(x + h / 2 * k2, u)
    k4 = ode(x + h * k3, u)
    model.disc_dyn_expr = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    model.cost_expr_ext_cost, model.cost_expr_ext_cost_e = ca.sumsqr(u), 0 * x[0]
    ocp.model, ocp.cost.cost_type, ocp.cost.cost_type_e = model, "EXTERNAL", "EXTERNAL"
    ocp.constraints.x0 = start
    ocp.constraints.idxbx_e, ocp.constraints.lbx_e, ocp.constraints.ubx_e = np.arange(nx), goal, goal
    limits = list(problem.bounds.drives.values())
    ocp.constraints.idxbu = np.arange(nu)
    ocp.constraints.lbu, ocp.constraints.ubu = (np.array([b[k] for b in limits]) for k in (0, 1))
    options = ocp.solver_options
    ocp.dims.N = options.N_horizon = NODES
    options.tf, options.tol, options.nlp_solver_type = NODES * h, 1e-8, "SQP"
    options.integrator_type, options.hessian_approx = "DISCRETE", "EXACT"
    options.qp_solver, options.nlp_solver_max_iter = "PARTIAL_CONDENSING_HPIPM", 100
    options.model_external_shared_lib_dir, options.model_external_shared_lib_name = str(folder), "reduced"
    with contextlib.chdir(folder):
        return AcadosOcpSolver(ocp, json_file="ocp.json", verbose=False)


def run(names: tuple[str, ...] = ("seed", "delta")) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    raw = {name: rates(name) for name in names}
    rows = []
    for name, found in raw.items():
        warm = [found[f"warm {share:g}"] for share in SHARES]
        rows.append([name, *(f"{1 / w['median']:.0f} ({w['steps']})" for w in warm), f"{found['cost']:.8g}"])
    header = ("acados, solves per second", *(f"warm, {share:.1%} off (steps)" for share in SHARES), "cost, cold")
    return table(header, rows), raw


if __name__ == "__main__":
    sys.path.insert(0, f"{os.environ['ACADOS_SOURCE_DIR']}/interfaces/acados_template")
    print(run(tuple(sys.argv[1:]) or ("seed", "delta"))[0])
