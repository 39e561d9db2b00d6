"""Target "external_hessians": second derivatives of the external functions, compiled. It brings "external" along."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from symscrew.export import casadi_functions, hessians_model, library_sources, print_hessians
from symscrew.generation.external_target import load_external
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import relative_difference
from symscrew.runtime import compile_c, find_compiler

# What both may differ by: second derivatives lose two or three digits where a pivot is small.
AGREEING = 1e-9
STATES = 2  # of the model's own, at which they are compared


def files(order: Order) -> Mapping[str, str | bytes]:
    """<name>_external_hessians.c, <name>_hessians.h, <name>_hessians.c."""
    return print_hessians(order.model)


def section(order: Order) -> Sequence[str]:
    """How the library is made, and what CasADi does with it."""
    name = order.model.name
    parts = ("jacobians", "external", "hessians", "external_hessians")
    files = " ".join(f"{name}_{part}.c" for part in parts)
    return [
        "### Second derivatives of the external functions",
        "",
        f"Compile {files} to one library",
        "with the sources of the C. `casadi.hessian` of what is made of its functions then takes exact and sparse",
        "second derivatives, and so does IPOPT without any option. `assemble` is an iteration and has first ones only:",
        "keep `q` as unknowns and `closure(q) = 0` as constraints.",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """Hessians of the weighted results against CasADi's own differentiation, where both succeed."""
    if find_compiler() is None:  # which the target "c" says
        return
    directory, model = case.fresh, case.model
    library = directory / f"lib{model.name}_hessians.so"
    names = library_sources((path.name for path in directory.iterdir()), model.name)
    parts = ("jacobians", "external", "hessians", "external_hessians")
    more = [*names[1:], *(f"{model.name}_{part}.c" for part in parts)]
    compile_c(directory / names[0], library, flags=("-ffp-contract=off", *(str(directory / file) for file in more)))
    own, worst, compared = casadi_functions(model), 0.0, 0
    _, found = hessians_model(model)
    for name in found:
        ours = hessian_of(load_external(library, f"{model.name}_casadi_{name}"))
        theirs = hessian_of(own[name])
        for k in np.flatnonzero(np.asarray(case.expected[name][1]) == 0)[:STATES]:
            state = np.concatenate([array[k] for array in model.test_inputs[name]])
            a, b = (np.array(f(state)) for f in (theirs, ours))
            worst, compared = max(worst, relative_difference(a, b)), compared + 1
    text = f"{len(found)} Hessians of CasADi externals agree with CasADi's own to {worst:.1e} at {compared} states"
    yield worst <= AGREEING, text


def hessian_of(function: Any) -> Any:
    """All inputs in one vector -> the Hessian of the results, weighted by numbers that are all different."""
    import casadi as ca

    x = ca.MX.sym("x", sum(function.numel_in(k) for k in range(function.n_in())))
    given, at = [], 0
    for k in range(function.n_in()):
        given.append(ca.reshape(x[at : at + function.numel_in(k)], function.size_in(k)))
        at += function.numel_in(k)
    total = ca.MX(0)
    for result in function.call(given)[:-1]:  # all but the status
        total += ca.dot(ca.DM(np.linspace(0.5, 1.5, result.numel())), ca.vec(result))
    return ca.Function("hessian", [x], [ca.hessian(total, x)[0]])
