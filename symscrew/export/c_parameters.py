"""The run-time parameters of a model as a type of C with names, units and defaults.

    pendulum_parameters parameters = PENDULUM_PARAMETERS_DEFAULT;
    parameters.by_name.length = 0.6;
    pendulum_inverse_dynamics(q, v, a, parameters.p, u);

A union, so that the names and the array `p` of the functions are the same numbers; nothing is copied.
"""

from __future__ import annotations

from symscrew.description import members
from symscrew.export.c_precision import Precision
from symscrew.export.listing import plain, wrapped
from symscrew.model import Model


def parameter_type(model: Model, precision: Precision) -> list[str]:
    """Lines of the header, none for a model without run-time parameters."""
    chosen = [p for p in getattr(model.mechanism, "parameters", {}).values() if p.run_time]
    if not chosen:
        return []
    upper, numbers = model.name.upper(), [precision.number(float(x)) for x in model.system.parameter_values]
    about = wrapped("Run-time parameters: `by_name` and the functions' argument `p` are the same numbers. Start")
    about += [f"with {model.name}_parameters parameters = {upper}_PARAMETERS_DEFAULT;"]
    lines = ["", "/*", *(f" * {line}" for line in about), " */", "typedef union {", "    struct {"]
    names = members(parameter.name for parameter in chosen)
    for parameter, number in zip(chosen, numbers, strict=True):
        text = plain(f"[{parameter.unit}] {parameter.description or parameter.name}; default {number.strip('()')}")
        lines += [f"        {precision.real} {names[parameter.name]}; /* {text} */"]
    lines += ["    } by_name;", f"    {precision.real} p[{len(chosen)}];", f"}} {model.name}_parameters;"]
    lines += [f"#define {upper}_PARAMETERS_DEFAULT {{{{ \\"]
    lines += [f"    {number}{',' if k + 1 < len(numbers) else ''} \\" for k, number in enumerate(numbers)]
    return [*lines, "}}"]
