"""CasADi functions of a model: named inputs and outputs, and `status` as a last output.

The numbers are those of the C code. Where the status is not 0 the other outputs are whatever the operations
gave (they stay differentiable), so look at the status first. A saved function loads without symscrew:

    f = casadi.Function.load("inverse_dynamics.casadi")
    result = f(q=q, v=v, a=a); result["u"], result["status"]
    f.sx_in()    # its arguments as symbols by entry: limb1_U_q_0, limb1_U_q_1, ...

An iteration takes a fixed number of steps that change nothing once it has converged; the attempts with more
substeps are only evaluated when the ones before them failed, as in the C code.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import islice
from typing import Any

import casadi as ca

from symscrew.export.listing import check_names, checked_slots, live_instructions
from symscrew.export.value_names import value_names
from symscrew.model import Model
from symscrew.program import NO_ROTATION, Iteration, Port, Program

LARGEST = 1.7976931348623157e308  # the largest double: CasADi has no test for infinity, and NaN is not below either

TABLE: Mapping[str, Callable[..., Any]] = {  # of SX scalars; `SX.binary` takes a sixth of the time of operators
    "add": partial(ca.SX.binary, ca.OP_ADD),
    "sub": partial(ca.SX.binary, ca.OP_SUB),
    "mul": partial(ca.SX.binary, ca.OP_MUL),
    "neg": partial(ca.SX.unary, ca.OP_NEG),
    "reciprocal": partial(ca.SX.binary, ca.OP_DIV, ca.SX(1)),
    "div": partial(ca.SX.binary, ca.OP_DIV),
    "sqrt": partial(ca.SX.unary, ca.OP_SQRT),
    "exp": partial(ca.SX.unary, ca.OP_EXP),
    "sin": partial(ca.SX.unary, ca.OP_SIN),
    "cos": partial(ca.SX.unary, ca.OP_COS),
    "tan": partial(ca.SX.unary, ca.OP_TAN),
    "atan2": partial(ca.SX.binary, ca.OP_ATAN2),
    "abs": partial(ca.SX.unary, ca.OP_FABS),
    "less": partial(ca.SX.binary, ca.OP_LT),
    "select": lambda c, x, y: ca.if_else(c != 0, x, y),
}


def casadi_functions(model: Model) -> dict[str, ca.Function]:
    """A CasADi function per function of the model."""
    check_names(model)
    return {
        name: iteration_function(p) if isinstance(p, Iteration) else program_function(p)
        for name, p in model.programs.items()
    }


def program_function(program: Program) -> ca.Function:
    """A straight-line program as a function of SX, whose entries have their names in the theory."""
    called = value_names(program, ())
    slots: list[Any] = [None] * max(program.slots, 1 + max((i.target for i in program.instructions), default=0))
    entries = [ca.SX.sym(called[slot]) for slot in range(sum(port.size for port in program.inputs))]
    slots[: len(entries)] = entries
    waiting = iter(entries)
    symbols = [
        ca.reshape(ca.vertcat(ca.SX(0, 1), *islice(waiting, port.size)), *_dimensions(port)) for port in program.inputs
    ]

    constants: dict[float, Any] = {}

    def value(operand: int | float) -> Any:
        if isinstance(operand, int):
            return slots[operand]
        if operand not in constants:
            constants[operand] = ca.SX(operand)
        return constants[operand]

    for instruction in live_instructions(program)[0]:
        slots[instruction.target] = TABLE[instruction.op](*[value(a) for a in instruction.args])
    outputs = [
        ca.reshape(ca.vertcat(ca.SX(0, 1), *[value(s) for s in results]), *_dimensions(port))
        for port, results in zip(program.outputs, program.results, strict=True)
    ]
    # absolute values: in a plain sum x and -x would cancel while it is built, and with them the NaN of x
    total = ca.sum1(ca.fabs(ca.vertcat(ca.SX(0), *[slots[s] for s in checked_slots(program)])))
    passed = ca.SX(1)
    for slot, threshold in program.guards:
        passed = ca.logic_and(passed, ca.logic_not(ca.fabs(slots[slot]) <= threshold))
    status = ca.if_else(passed, ca.if_else(_finite(total), 0, 2), 1)
    for slot, low, high, code in reversed(program.limits):
        bounds = [
            *([slots[slot] >= low] if low is not None else []),
            *([slots[slot] <= high] if high is not None else []),
        ]
        within = ca.logic_and(bounds[0], bounds[-1])
        status = ca.if_else(within, status, ca.if_else(_finite(slots[slot]), code, 2))
    names = [port.name for port in program.outputs]
    inputs = [port.name for port in program.inputs]
    return ca.Function(program.name, symbols, [*outputs, status], inputs, [*names, "status"])


def iteration_function(iteration: Iteration) -> ca.Function:
    """An iteration as a function of MX over one rolled step."""
    y, guess, *parameters = [_symbol(ca.MX, port) for port in iteration.inputs]
    start = ca.vertcat(ca.MX(0, 1), *[guess[k] for k in iteration.independent])
    step = program_function(iteration.step)
    target = _target(iteration, _newton(iteration, step))
    first = step(guess, start, *parameters)
    branch = first[3]
    arguments = [guess, y, start, branch, *parameters]
    state = _attempt(iteration, target, 1)(*arguments)
    substeps = 2
    while substeps <= iteration.max_substeps:
        attempt = _attempt(iteration, target, substeps)
        failed = state[-1] != 0
        keep = _keep(attempt, iteration)
        more = _with_unused(attempt, state.numel())
        state = ca.Function.if_else(f"{attempt.name()}_if_needed", more, keep)(failed, state, *arguments)
        substeps *= 2
    finite = _finite(ca.sum1(ca.vertcat(*[ca.vec(x) for x in (y, guess, *parameters)])))
    status = ca.if_else(finite, ca.if_else(first[-1] >= NO_ROTATION, first[-1], state[-1]), 2)
    names = [port.name for port in iteration.inputs]
    outputs = [iteration.outputs[0].name, "status"]
    return ca.Function(iteration.name, [y, guess, *parameters], [state[:-1], status], names, outputs)


def _attempt(iteration: Iteration, target: ca.Function, substeps: int) -> ca.Function:
    """(guess, y, start, branch, parameters) -> (q; outcome) by `substeps` targets from the guess to y."""
    q, y = _symbol(ca.MX, iteration.outputs[0]), _symbol(ca.MX, iteration.inputs[0])
    start, branch = ca.MX.sym("start", y.numel()), ca.MX.sym("branch")
    parameters = [_symbol(ca.MX, port) for port in iteration.inputs[2:]]
    begin = ca.vertcat(q, 0)
    fixed = [y, start, branch, *parameters]
    parts = ca.DM([(k + 1) / substeps for k in range(substeps)]).T
    state = target(begin, 1.0, *fixed) if substeps == 1 else _folded(target, substeps, begin, fixed, varying=parts)
    return ca.Function(f"{iteration.name}_attempt_{substeps}", [q, *fixed], [state])


def _target(iteration: Iteration, newton: ca.Function) -> ca.Function:
    """(state, part, y, start, branch, parameters) -> state after Newton's iteration at one target."""
    n = iteration.outputs[0].size
    state, part = ca.MX.sym("state", n + 1), ca.MX.sym("part")
    y = _symbol(ca.MX, iteration.inputs[0])
    start, branch = ca.MX.sym("start", y.numel()), ca.MX.sym("branch")
    parameters = [_symbol(ca.MX, port) for port in iteration.inputs[2:]]
    running = ca.vertcat(state[:-1], ca.if_else(state[-1] == 0, -1, state[-1]))
    fixed = [start + (y - start) * part, branch, *parameters]
    steps = iteration.max_steps
    after = _folded(newton, steps, running, fixed)
    done = ca.vertcat(after[:-1], ca.if_else(after[-1] < 0, 3, after[-1]))
    return ca.Function(f"{iteration.name}_target", [state, part, y, start, branch, *parameters], [done])


def _newton(iteration: Iteration, step: ca.Function) -> ca.Function:
    """(state, y, branch, parameters) -> state after a step; its last entry is -1 until it is done."""
    n = iteration.outputs[0].size
    state = ca.SX.sym("state", n + 1)
    q, outcome = state[:-1], state[-1]
    y, branch = _symbol(ca.SX, iteration.inputs[0]), ca.SX.sym("branch")
    parameters = [_symbol(ca.SX, port) for port in iteration.inputs[2:]]
    following, residual, change, orientation, status = step(q, y, *parameters)
    converged = ca.logic_and(residual < iteration.tolerance, change < iteration.tolerance)
    found = ca.if_else(converged, ca.if_else(orientation * branch > 0, 0, 4), -1)
    running = outcome < 0
    moved = ca.logic_and(running, status == 0)
    result = ca.vertcat(
        ca.if_else(moved, following, q),
        ca.if_else(running, ca.if_else(status == 0, found, 3), outcome),
    )
    return ca.Function(f"{iteration.name}_newton", [state, y, branch, *parameters], [result])


def _folded(function: ca.Function, times: int, begin: Any, fixed: Sequence[Any], *, varying: Any = None) -> Any:
    """The state after `times` calls, each with its column of `varying` and the same `fixed` arguments."""
    repeated = [ca.repmat(x, 1, times) for x in fixed]
    return function.fold(times)(begin, *([] if varying is None else [varying]), *repeated)


def _with_unused(attempt: ca.Function, size: int) -> ca.Function:
    """The attempt with the present state as a first argument, which it does not read."""
    inputs = attempt.mx_in()
    return ca.Function(f"{attempt.name()}_again", [ca.MX.sym("state", size), *inputs], attempt.call(inputs))


def _keep(attempt: ca.Function, iteration: Iteration) -> ca.Function:
    """The present state, whatever the other arguments."""
    state = ca.MX.sym("state", iteration.outputs[0].size + 1)
    return ca.Function(f"{attempt.name()}_keep", [state, *attempt.mx_in()], [state])


def _finite(value: Any) -> Any:
    return ca.fabs(value) <= LARGEST


def _symbol(kind: Any, port: Port) -> Any:
    return kind.sym(port.name, *_dimensions(port))


def _dimensions(port: Port) -> tuple[int, int]:
    return (port.shape[0], port.shape[1]) if len(port.shape) == 2 else (port.size, 1)
