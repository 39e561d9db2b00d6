"""The reduced model: motion in the independent coordinates alone, with first and second derivatives.

state x = (y, y_dot), drives u --> q of the assembly mode of the reference --> x_dot = (y_dot, y_ddot)

`<name>_reduced.c` wraps the model's C in CasADi's ABI. `<name>_ode` has Jacobian (`jac_`), adjoint (`adj1_`) and the
adjoint's Jacobian (`jac_adj1_`), so that CasADi finds exact Hessians; what acados asks for by name stands beside it:
`<name>_expl_ode_fun`, `_expl_vde_forw`, `_expl_vde_adj`, `_expl_ode_hess`, and `<name>_disc_dyn_fun`, `_jac`,
`_jac_hess`, a Runge-Kutta step of order 4 with its exact derivatives. `ode_function` is the same for CasADi alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from typing import Any

import casadi as ca
import numpy as np

from symscrew.errors import DescriptionError
from symscrew.export.casadi import iteration_function, program_function
from symscrew.export.casadi_external import HEAD, names_of, sparsities_of
from symscrew.export.listing import banner
from symscrew.functions import HESSIAN, function, moved_by, q_port, y_port
from symscrew.loops import Loops
from symscrew.model import Model
from symscrew.program import Iteration, Program, lower

FORWARD = "forward_dynamics_independent"
POLISH = 2  # Newton steps that CasADi differentiates: after k of them derivatives of order 2^k - 1 are exact
TEMPLATE = "reduced_model.c"


@dataclass(frozen=True)
class Reduced:
    """A model's sizes, the entries of its Hessian, and whether it has loops."""

    model: Model
    nx: int
    nu: int
    closed: bool

    @property
    def nv(self) -> int:
        """Entries of (x, u)."""
        return self.nx + self.nu

    @property
    def d(self) -> int:
        """Independent coordinates."""
        return self.nx // 2

    @property
    def blocks(self) -> list[list[tuple[int, int]]]:
        """Per output of the Hessian's function the places (row, column) of its entries in (x, u)."""
        groups = {"y": 0, "y_dot": self.d, "u": self.nx}
        program = self.model.programs[f"{FORWARD}{HESSIAN}"]
        labels = {name: list(port.labels) for name, port in zip(("y_dot", "u"), program.inputs[1:], strict=False)}
        labels["y"] = labels["y_dot"]
        found = []
        for port in program.outputs:
            one, other = next((a, b) for a in groups for b in groups if port.name == f"hessian_{a}_{b}")
            pairs = [label.split("|") for label in port.labels]
            found.append(
                [(groups[one] + labels[one].index(a), groups[other] + labels[other].index(b)) for a, b in pairs]
            )
        return found

    @property
    def slope(self) -> np.ndarray:
        """Which entries of d x_dot / d (x, u) are not zero at every state: (nx, nv)."""
        result = np.zeros((self.nx, self.nv), bool)
        result[range(self.d), range(self.d, self.nx)] = True
        start = 0
        program = self.model.programs[f"{FORWARD}_derivatives"]
        assert not isinstance(program, Iteration)
        for port, values in zip(program.outputs, program.results, strict=True):
            width = port.shape[1]
            own = np.array([isinstance(value, int) or value != 0.0 for value in values]).reshape(width, self.d).T
            result[self.d :, start : start + width] = own
            start += width
        return result

    @property
    def bend(self) -> np.ndarray:
        """Which entries of the Hessian of lam . x_dot are not zero at every state: (nv, nv)."""
        result = np.zeros((self.nv, self.nv), bool)
        for row, column in (place for block in self.blocks for place in block):
            result[row, column] = result[column, row] = True
        return result


def reduced(model: Model) -> Reduced:
    """What a model's reduced form is made of.

    Raises:
        DescriptionError: it cannot be had of this model; what was expected, and the cure.
    """
    if FORWARD in model.programs and not model.programs[FORWARD].outputs[0].size:
        raise DescriptionError(f"target reduced: {model.name} has no freedom, so that nothing moves")
    missing = [n for n in (FORWARD, f"{FORWARD}_derivatives", f"{FORWARD}{HESSIAN}") if n not in model.programs]
    if missing:
        what = "derive it with derivatives=True and second_derivatives=True, of bodies that have mass"
        raise DescriptionError(f"target reduced: {model.name} has no {', '.join(missing)}; {what}")
    program = model.programs[FORWARD]
    further = [port.name for port in program.inputs if port.name not in ("q", "y_dot", "u")]
    if further:
        what = "bake run-time parameters in, leave out effects with inputs or states of their own"
        raise DescriptionError(f"target reduced: {FORWARD} also takes {', '.join(further)}; {what}")
    d = program.outputs[0].size
    nu = next((port.size for port in program.inputs if port.name == "u"), 0)
    closed = "assemble" in model.programs
    if not closed and program.inputs[0].size != d:
        raise DescriptionError(f"target reduced: {model.name} has quaternions among its coordinates and no loop")
    return Reduced(model, 2 * d, nu, closed)


def ode_function(model: Model) -> ca.Function:
    """(x, u) -> x_dot of CasADi's own operations, with exact first and second derivatives."""
    form = reduced(model)
    x, u = ca.MX.sym("x", form.nx), ca.MX.sym("u", form.nu)
    y, y_dot = x[: form.d], x[form.d :]
    arguments = [configuration_of(form, y), y_dot, *([u] if form.nu else [])]
    program = model.programs[FORWARD]
    assert not isinstance(program, Iteration)
    y_ddot = program_function(program).call(arguments)[0]
    return ca.Function(f"{model.name}_ode", [x, u], [ca.vertcat(y_dot, y_ddot)], ["x", "u"], ["x_dot"])


def configuration_function(model: Model) -> ca.Function:
    """(y) -> q on the assembly mode of the reference configuration, differentiable."""
    form = reduced(model)
    y = ca.MX.sym("y", form.d)
    return ca.Function(f"{model.name}_configuration", [y], [configuration_of(form, y)], ["y"], ["q"])


def configuration_of(form: Reduced, y: Any) -> Any:
    """q of y: assembled, then polished by Newton steps through which derivatives go."""
    if not form.closed:
        return y
    iteration = form.model.programs["assemble"]
    assert isinstance(iteration, Iteration)
    q = ca.stop_diff(iteration_function(iteration)(y, ca.DM(form.model.system.reference))[0], 2)
    step = program_function(_step(form.model))
    for _ in range(POLISH):
        q = step(q, y)[0]
    return q


def _step(model: Model) -> Program:
    """(q, y) -> q_next: a whole Newton step that closes the loops and moves to y."""
    system = model.system
    loops = Loops(system, model.independent)
    wanted = loops.inputs("y")
    inputs = [(q_port(system), system.inputs.q), (y_port(loops, "y", 0), wanted)]
    outputs = [(q_port(system, "q_next"), moved_by(system, loops.newton_step(wanted)))]
    return lower(function(system, "newton_move", "A Newton step.", inputs=inputs, outputs=outputs))


# -- C ----------------------------------------------------------------------------------------------------------


def print_reduced(model: Model) -> dict[str, str]:
    """File name to text: `<name>_reduced.c`."""
    form = reduced(model)
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */", f'#include "{model.name}.h"']
    lines += ["", "#include <stddef.h>", *HEAD.rstrip().splitlines(), "", *_constants(form), ""]
    template = resources.files(__package__).joinpath(TEMPLATE).read_text(encoding="utf-8")
    lines += [*template.split("*/", 1)[1].strip().splitlines()]
    for name, inputs, outputs in _table(form):
        lines += ["", *_declared(f"{name.format(model.name)}", inputs, outputs)]
    return {f"{model.name}_reduced.c": "\n".join([*lines, ""])}


def _constants(form: Reduced) -> list[str]:
    """Sizes, the reference, and calls of the model's functions with the names that the template uses."""
    name, model = form.model.name, form.model
    nq = model.programs[FORWARD].inputs[0].size
    sizes = {"NY": form.d, "NX": form.nx, "NU": form.nu, "NV": form.nv, "NQ": nq}
    lines = [f"#define {key} {value}" for key, value in sizes.items()]
    u = ", u" if form.nu else ""
    call = f"{name}_{FORWARD}"
    by_u = ", by_u" if form.nu else ""
    hessian = [f"    double block{k}[{len(block)}];" for k, block in enumerate(form.blocks)]
    given = "".join(f", block{k}" for k in range(len(form.blocks)))
    scattered = [
        f"    hessian[{column} * NV + {row}] = block{k}[{i}];"
        for k, block in enumerate(form.blocks)
        for i, place in enumerate(block)
        for row, column in dict.fromkeys((place, place[::-1]))
    ]
    lines += ["", "/* q of the assembly mode of the reference configuration. */"]
    lines += ["static int configuration(const double *y, double *q)", "{"]
    if form.closed:
        numbers = ", ".join(repr(float(value)) for value in model.system.reference)
        lines += [f"    static const double reference[NQ] = {{{numbers}}};"]
        lines += [f"    return {name}_assemble(y, reference, q);"]
    else:
        lines += ["    for (int k = 0; k < NQ; ++k) {", "        q[k] = y[k];", "    }", "    return 0;"]
    unused = [] if form.nu else ["    (void)u;"]
    lines += ["}", "", "static int value(const double *q, const double *y_dot, const double *u, double *y_ddot)", "{"]
    lines += [*unused, f"    return {call}(q, y_dot{u}, y_ddot);", "}", ""]
    lines += ["/* Columns of d y_ddot / d (y, y_dot, u). */"]
    lines += ["static int slopes(const double *q, const double *y_dot, const double *u, double *by)", "{"]
    lines += [*unused, "    double *by_rate = by + NY * NY;"]
    lines += ["    double *by_u = by + 2 * NY * NY;"] if form.nu else []
    lines += [f"    return {call}_derivatives(q, y_dot{u}, by, by_rate{by_u});", "}", ""]
    lines += ["/* Hessian of weights . y_ddot by (y, y_dot, u). */", "static int bends(const double *q,"]
    lines += [
        "    const double *y_dot, const double *u, const double *weights, double *hessian)",
        "{",
        *unused,
        *hessian,
    ]
    lines += [f"    const int status = {call}{HESSIAN}(q, y_dot{u}, weights{given});"]
    lines += ["    for (int k = 0; k < NV * NV; ++k) {", "        hessian[k] = 0.0;", "    }", *scattered]
    return [*lines, "    return status;", "}"]


Place = tuple[str, list[int]]  # name, CasADi's pattern


def _table(form: Reduced) -> list[tuple[str, list[Place], list[Place]]]:
    """Every function of the ABI: name ({} is the model's), inputs and outputs."""
    nx, nu, nv = form.nx, form.nu, form.nv
    nq = form.model.programs[FORWARD].inputs[0].size
    x, u, p, slope, bend = _full("x", nx), _full("u", nu), _full("p", 1), form.slope, form.bend
    out, seed = _full("out_x_dot", nx), _full("adj_x_dot", nx)
    sides = {"x": slice(0, nx), "u": slice(nx, nv)}
    first = [_sparse(f"jac_x_dot_{k}", slope[:, at]) for k, at in sides.items()]
    found = [_full(f"out_adj_{k}", at.stop - at.start) for k, at in sides.items()]
    second = []
    for one, rows in sides.items():
        parts = {"x": bend[rows, sides["x"]], "u": bend[rows, sides["u"]]}
        parts["out_x_dot"] = np.zeros((rows.stop - rows.start, nx), bool)
        parts["adj_x_dot"] = slope[:, rows].T
        second += [_sparse(f"jac_adj_{one}_{other}", part) for other, part in parts.items()]
    sx, su, lam = _matrix("Sx", nx, nx), _matrix("Su", nx, nu), _full("lam", nx)
    fun, phi = _full("x_dot", nx), _full("phi", nx)
    by_ux, bent = _matrix("jac_ux_t", nv, nx), _matrix("hess_ux", nv, nv)
    half = nv * (nv + 1) // 2
    return [
        ("{}_configuration", [_full("y", form.d)], [_full("q", nq)]),
        ("{}_ode", [x, u], [fun]),
        ("jac_{}_ode", [x, u, out], first),
        ("adj1_{}_ode", [x, u, out, seed], [_full("adj_x", nx), _full("adj_u", nu)]),
        ("jac_adj1_{}_ode", [x, u, out, seed, *found], second),
        ("{}_expl_ode_fun", [x, u, p], [fun]),
        ("{}_expl_vde_forw", [x, sx, su, u, p], [fun, _matrix("vde_x", nx, nx), _matrix("vde_u", nx, nu)]),
        ("{}_expl_vde_adj", [x, lam, u, p], [_full("adj", nv)]),
        ("{}_expl_ode_hess", [x, sx, su, lam, u, p], [_full("adj", nv), _full("hess", half)]),
        ("{}_disc_dyn_fun", [x, u, p], [phi]),
        ("{}_disc_dyn_fun_jac", [x, u, p], [phi, by_ux]),
        ("{}_disc_dyn_fun_jac_hess", [x, u, lam, p], [phi, by_ux, bent]),
    ]


def _full(name: str, size: int) -> Place:
    return name, [size, 1, 1]


def _matrix(name: str, rows: int, columns: int) -> Place:
    return name, [rows, columns, 1]


def _sparse(name: str, entries: np.ndarray) -> Place:
    """Compressed columns."""
    rows, columns = entries.shape
    starts = np.concatenate([[0], np.cumsum(entries.sum(axis=0))])
    places = [int(r) for c in range(columns) for r in np.flatnonzero(entries[:, c])]
    return name, [rows, columns, *(int(s) for s in starts), *places]


def _size(pattern: Sequence[int]) -> int:
    rows, columns = pattern[:2]
    dense = list(pattern[2:]) == [1] and columns >= 1
    return rows * columns if dense else pattern[2 + columns]


def _declared(symbol: str, inputs: Sequence[Place], outputs: Sequence[Place]) -> list[str]:
    """One function: what CasADi asks about it, then its call of the template's function of the same end."""
    patterns = [pattern for _, pattern in (*inputs, *outputs)]
    words = sum(map(_size, patterns))
    lines = [f"EXTERNAL({symbol}, {len(inputs)}, {len(outputs)}, {words})", ""]
    lines += names_of(symbol, "in", [name for name, _ in inputs])
    lines += names_of(symbol, "out", [name for name, _ in outputs])
    lines += sparsities_of(symbol, "in", [pattern for _, pattern in inputs])
    lines += sparsities_of(symbol, "out", [pattern for _, pattern in outputs])
    lines += [f"int {symbol}(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem)", "{"]
    lines += [f"    const casadi_real *in{k} = input(arg[{k}], &w, {_size(p)});" for k, (_, p) in enumerate(inputs)]
    lines += [f"    casadi_real *out{k} = output(res[{k}], &w, {_size(p)});" for k, (_, p) in enumerate(outputs)]
    every = [*(f"in{k}" for k in range(len(inputs))), *(f"out{k}" for k in range(len(outputs)))]
    return [*lines, "    (void)iw;", "    (void)w;", "    (void)mem;", *_calls(symbol, every, outputs), "}"]


def _calls(symbol: str, every: Sequence[str], outputs: Sequence[Place]) -> list[str]:
    """The body behind the arguments: dense results of the template, gathered where the pattern is sparse."""
    if symbol.startswith("jac_adj1_"):
        return _gathered(outputs, "adjoint_slopes(in0, in1, in3, slope, hessian)", transposed=True)
    if symbol.startswith("jac_"):
        return _gathered(outputs, "ode_slopes(in0, in1, slope)", transposed=False)
    kinds = (
        "configuration", "expl_ode_fun", "expl_vde_forw", "expl_vde_adj", "expl_ode_hess", "disc_dyn_fun",
        "disc_dyn_fun_jac", "disc_dyn_fun_jac_hess",
    )  # fmt: skip
    if symbol.startswith("adj1_"):
        return ["    (void)in2;", "    return adjoint(in0, in1, in3, out0, out1) > 0;"]
    kind = next((kind for kind in kinds if symbol.endswith(f"_{kind}")), "ode")
    return [f"    return {kind}({', '.join(every)}) > 0;"]


def _gathered(outputs: Sequence[Place], call: str, *, transposed: bool) -> list[str]:
    """Entries of the patterns out of the dense slope (NX x NV) and Hessian (NV x NV), by columns."""
    lines = ["    double slope[NX * NV];", *(["    double hessian[NV * NV];"] if transposed else [])]
    lines += [f"    const int status = {call};"]
    for k, (name, pattern) in enumerate(outputs):
        columns, rest = pattern[1], pattern[2:]
        starts, places = rest[: columns + 1], rest[columns + 1 :]
        one, other = name.removeprefix("jac_adj_" if transposed else "jac_x_dot").lstrip("_").partition("_")[::2]
        for c in range(columns):
            for i in range(starts[c], starts[c + 1]):
                row, column = places[i], c
                if not transposed:
                    shift = "NX" if one == "u" else "0"
                    lines.append(f"    out{k}[{i}] = slope[({shift} + {column}) * NX + {row}];")
                elif other == "adj_x_dot":
                    shift = "NX" if one == "u" else "0"
                    lines.append(f"    out{k}[{i}] = slope[({shift} + {row}) * NX + {column}];")
                else:
                    down, right = ("NX" if side == "u" else "0" for side in (one, other))
                    lines.append(f"    out{k}[{i}] = hessian[({right} + {column}) * NV + {down} + {row}];")
    unread = [f"    (void)in{k};" for k in ((2, 4, 5) if transposed else (2,))]
    unwritten = [f"    (void)out{k};" for k, (_, p) in enumerate(outputs) if _size(p) == 0]
    return [*lines, *unread, *unwritten, "    return status > 0;"]
