"""Target "reduced": the motion in the independent coordinates alone, for CasADi and acados. It brings "c" along."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from symscrew.export import configuration_function, library_sources, ode_function, print_reduced
from symscrew.generation.casadi_target import saved
from symscrew.generation.external_target import load_external
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import relative_difference
from symscrew.runtime import compile_c, find_compiler

# What C and CasADi may differ by: both assemble to 1e-10 by Newton's method, and a second derivative loses three digits
# of that near singularities.
AGREEING = 1e-7
STATES = 3  # of the model's own, at which they are compared


def files(order: Order) -> Mapping[str, str | bytes]:
    """<name>_reduced.c, <name>_ode.casadi, <name>_configuration.casadi."""
    model = order.model
    functions = {f"{model.name}_ode": ode_function(model), f"{model.name}_configuration": configuration_function(model)}
    return {**print_reduced(model), **saved(functions)}


def compare(case: Case) -> Iterator[Finding]:
    """Values, Jacobians and Hessians of the C against CasADi's own differentiation, where both succeed."""
    import casadi as ca

    if find_compiler() is None:  # which the target "c" says
        return
    directory, model = case.fresh, case.model
    library = directory / f"lib{model.name}_reduced.so"
    names = library_sources((path.name for path in directory.iterdir()), model.name)
    more = [str(directory / other) for other in (*names[1:], f"{model.name}_reduced.c")]
    compile_c(directory / names[0], library, flags=("-ffp-contract=off", *more))
    name = f"{model.name}_ode"
    known = ca.Function.load(str(directory / f"{name}.casadi"))
    ours, theirs = _with_derivatives(load_external(library, name)), _with_derivatives(known)
    q, y_dot, *drives = model.test_inputs["forward_dynamics_independent"]
    y = q[:, [model.system.tree.q[k].label in model.independent for k in range(q.shape[1])]] if model.independent else q
    u = drives[0] if drives else np.zeros((len(q), 0))
    worst, compared = 0.0, 0
    for k in range(min(STATES, len(q))):
        state = [np.concatenate([y[k], y_dot[k]]), u[k], np.linspace(-1.0, 1.0, 2 * y.shape[1])]
        expected = [np.array(x) for x in theirs(*state)]
        try:
            found = [np.array(x) for x in ours(*state)]
        except RuntimeError:  # a state that fails, where CasADi's numbers mean nothing
            continue
        compared += 1
        worst = max(worst, *(relative_difference(a, b) for a, b in zip(expected, found, strict=True)))
    text = f"the reduced model and its derivatives agree with CasADi's own to {worst:.1e} at {compared} states"
    yield compared > 0 and worst <= AGREEING, text


def _with_derivatives(function: Any) -> Any:
    """(x, u, lam) -> x_dot, its Jacobian by (x, u), Hessian of lam . x_dot."""
    import casadi as ca

    nx, nu = function.size1_in(0), function.size1_in(1)
    v, lam = ca.MX.sym("v", nx + nu), ca.MX.sym("lam", nx)
    value = function(v[:nx], v[nx:])
    hessian = ca.jacobian(ca.gradient(ca.dot(lam, value), v), v)  # both triangles: ca.hessian reads one of them
    every = [value, ca.densify(ca.jacobian(value, v)), ca.densify(hessian)]
    x, u = ca.MX.sym("x", nx), ca.MX.sym("u", nu)
    at = ca.Function("at", [v, lam], every)
    return ca.Function("with_derivatives", [x, u, lam], at.call([ca.vertcat(x, u), lam]))
