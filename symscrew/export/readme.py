"""README.md of a generated directory: what is in it, what it means, and an example of about ten lines per target."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType

import numpy as np

from symscrew.description import markdown_text, members, namespace
from symscrew.export.c_files import family
from symscrew.export.c_form import library_sources
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, plain
from symscrew.export.readme_tables import (
    convention_list,
    coordinate_tables,
    recipe_table,
    size_section,
    status_table,
    table,
)
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program

SHOWN = ("inverse_dynamics_platform", "inverse_dynamics", "inverse_dynamics_independent")
ALWAYS = (
    "`manifest.json`: functions, arguments, units and labels; `ops.json`: operation counts",
    "`test_vectors.json`: inputs and results of every function; `mechanism.toml`: the description",
)


def print_readme(
    model: Model,
    targets: Mapping[str, str],
    precision: Precision = DOUBLE,
    further: Sequence[str] = (),
    *,
    files: Mapping[str, int] = MappingProxyType({}),
) -> str:
    """The text; deterministic, its examples use the first test state of one function.

    Args:
        model: what was printed.
        targets: name to what its files are, in which {0} stands for the model's name.
        precision: of the C.
        further: lines at the end.
        files: all files of the folder, among them the sources of C, with their bytes.
    """
    sources = library_sources(files, model.name) or [f"{model.name}.c"]
    name = _shown(model)
    program = model.programs[name]
    lines = [f"# {model.name}", "", *(f"{markdown_text(line)}  " for line in banner(model)[:3]), "", "## Files"]
    for target, about in targets.items():
        lines += [f"- {about.format(model.name)}", *(_sources(model, sources) if target == "c" else [])]
    lines += [f"- {text}" for text in ALWAYS]
    lines += ["", *coordinate_tables(model), "", "## Functions", ""]
    rows = [[f"`{n}`", _ports(p.inputs), _ports(p.outputs), _first_sentence(p)] for n, p in model.programs.items()]
    lines += table(("function", "arguments", "results", "is"), rows)
    for section in (recipe_table(model), status_table(model), convention_list(model), size_section(model, files)):
        lines += ["", *section] if section else []
    lines += ["", *_about(program, name)]
    examples: dict[str, list[Callable[..., list[str]]]] = {
        "c": [partial(_c, precision=precision, sources=sources), partial(_cpp, precision=precision, sources=sources)],
        "casadi": [_casadi],
        "numpy": [_numpy],
        "external": [partial(_external, sources=sources)],
        "javascript": [_javascript],
        "mjcf": [_mjcf],
        "urdf": [_urdf],
    }
    for target in targets if any(port.size for port in program.outputs) else ():  # else there is nothing to show
        for example in examples.get(target, ()):
            lines += ["", *example(model, name, program)]
    lines += ["", *further] if further else []
    return "\n".join([*lines, ""])


def _sources(model: Model, sources: Sequence[str]) -> list[str]:
    """What each source of the C holds."""
    families: dict[str, list[str]] = {}
    for function in model.programs:
        families.setdefault(f"{model.name}_{family(function)}.c", []).append(f"`{function}`")
    told = {source: f"{', '.join(families[source])}" for source in sources if source in families}
    told[f"{model.name}_batch.c"] = "functions of many states; it reads the bodies of the others"
    told[f"{model.name}_support.c"] = f"statuses, and with `{model.name}_support.h` what the sources share"
    if sources == [f"{model.name}.c"]:
        return [f"  - `{sources[0]}`: all functions"]
    return [f"  - `{source}`: {told[source]}" for source in sources if source in told]


def _shown(model: Model) -> str:
    """The function of the examples: inverse dynamics with the fewest numbers to type, and one to print."""
    known = [name for name in SHOWN if name in model.programs] or list(model.programs)

    def numbers(name: str) -> tuple[bool, int]:
        program = model.programs[name]
        return not any(port.size for port in program.outputs), sum(port.size for port in program.inputs)

    return min(known, key=numbers)


def _ports(ports: Sequence[Port]) -> str:
    return ", ".join(f"{port.name}[{port.size}]" for port in ports)


def _first_sentence(program: Program | Iteration) -> str:
    return markdown_text(re.split(r"\. (?=[A-Z])", plain(program.description))[0].rstrip("."))


def _about(program: Program | Iteration, name: str) -> list[str]:
    lines = ["## Examples", "", f"`{name}`: {plain(program.description)}"]
    for port in (*program.inputs, *program.outputs):
        labels = ", ".join(port.labels[:12]) + (", ..." if len(port.labels) > 12 else "")
        lines.append(f"- `{port.name}`: {plain(port.description)}" + (f" ({plain(labels)})" if labels else ""))
    return lines


def _states(
    model: Model, name: str, brackets: tuple[str, str], number: Callable[[float], str] = repr
) -> dict[str, str]:
    """Input name -> the numbers of the first test state, in the brackets of a language."""
    opening, closing = brackets
    arrays = [np.atleast_2d(array)[0] for array in model.test_inputs[name]]
    ports = model.programs[name].inputs
    texts = [", ".join(number(float(x)) for x in array) for array in arrays]
    return {port.name: f"{opening}{text}{closing}" for port, text in zip(ports, texts, strict=True)}


def _first(program: Program | Iteration) -> Port:
    return next(port for port in program.outputs if port.size)


def _c(
    model: Model, name: str, program: Program | Iteration, *, precision: Precision, sources: Sequence[str]
) -> list[str]:
    real = precision.real
    sizes = [f"{real} {p.name}_[{max(p.size, 1)}]" for p in program.outputs]
    states = _states(model, name, ("{", "}"), _typed_number(precision)).items()
    typed = _typed(model)
    inputs = [f"    const {real} {k}_[] = {v};" for k, v in states if v != "{}" and not (typed and k == "p")]
    passed = [f"{p.name}_" if p.size else "NULL" for p in (*program.inputs, *program.outputs)]
    passed = [f"{argument}.p" if typed and argument == "p_" else argument for argument in passed]
    main = [
        f'#include "{model.name}.h"',
        "#include <stdio.h>",
        "",
        "int main(void)",
        "{",
        *inputs,
        *typed,
        *(f"    {size};" for size in sizes),
        f"    const int outcome = {model.name}_{name}({', '.join(passed)});",
        f'    printf("%s: %.12g\\n", {model.name}_status_text(outcome), (double){_first(program).name}_[0]);',
        "    return outcome > 0;",
        "}",
    ]
    command = f"`cc -std=c99 -O2 -fno-math-errno main.c {' '.join(sources)} -lm -o main && ./main`"
    return ["### C", "", "```c", *main, "```", "", command, *_fewer(name, sources)]


def _fewer(name: str, sources: Sequence[str]) -> list[str]:
    """Which of several sources one function takes."""
    own = next((source for source in sources if source.endswith(f"_{family(name)}.c")), None)
    support = next((source for source in sources if source.endswith("_support.c")), None)
    if own is None or support is None:
        return []
    return ["", f"`{name}` by itself takes `{own}` and `{support}` only; functions of many states take all of them."]


def _typed_number(precision: Precision) -> Callable[[float], str]:
    """Doubles as Python writes them, constants of other types with their suffix."""
    return (lambda x: precision.number(x).strip("()")) if precision.suffix else repr


def _typed(model: Model) -> list[str]:
    """Run-time parameters with their names and defaults, if there are any: what a user changes."""
    chosen = list(members(p.name for p in model.mechanism.parameters.values() if p.run_time).values())
    line = f"    {model.name}_parameters p_ = {model.name.upper()}_PARAMETERS_DEFAULT;"
    return [f"{line} /* such as p_.by_name.{chosen[0]} */"] if chosen else []


def _cpp(
    model: Model, name: str, program: Program | Iteration, *, precision: Precision, sources: Sequence[str]
) -> list[str]:
    states = _states(model, name, ("{", "}"), _typed_number(precision)).items()
    sizes = {port.name: port.size for port in program.inputs}
    typed = _typed(model)
    first = f"result.{_member(program)}[0]"
    first = f"static_cast<double>({first})" if precision.suffix else first
    arrays = [
        f"    const std::array<{precision.real}, {sizes[k]}> {k}_{v};" for k, v in states if not (typed and k == "p")
    ]
    passed = [f"{k}_.p" if typed and k == "p" else f"{k}_" for k, _ in states]
    main = [
        f'#include "{model.name}.hpp"',
        "#include <cstdio>",
        "",
        "int main()",
        "{",
        *arrays,
        *typed,
        f"    const auto result = {namespace(model.name)}::{name}({', '.join(passed)});",
        f'    std::printf("%s: %.12g\\n", {namespace(model.name)}::text(result.status), {first});',
        "    return result.ok() ? 0 : 1;",
        "}",
    ]
    objects = " ".join(f"{source[:-2]}.o" for source in sources)
    command = (
        f"`cc -std=c99 -O2 -fno-math-errno -c {' '.join(sources)} && c++ -std=c++17 -O2 main.cpp {objects} -o main`"
    )
    return ["### C++", "", "```cpp", *main, "```", "", command]


def _member(program: Program | Iteration) -> str:
    from symscrew.export.c import argument_names

    names = argument_names((*program.inputs, *program.outputs))[len(program.inputs) :]
    return next(name for name, port in zip(names, program.outputs, strict=True) if port.size)


def _numpy(model: Model, name: str, program: Program | Iteration) -> list[str]:
    inputs = [f"{k}_ = np.array([{v}])" for k, v in _states(model, name, ("[", "]")).items()]
    main = [
        "import numpy as np",
        f"import {model.name}_numpy as model",
        "",
        *inputs,
        f"results, status = model.{name}({', '.join(f'{p.name}_' for p in program.inputs)})",
        f'print(f"{{status[0]}}: {{results[{program.outputs.index(_first(program))}].ravel()[0]:.12g}}")',
    ]
    return ["### NumPy", "", "```python", *main, "```"]


def _casadi(model: Model, name: str, program: Program | Iteration) -> list[str]:
    inputs = [f"{k}_ = {v}" for k, v in _states(model, name, ("[", "]")).items()]
    given = ", ".join(f"{p.name}={p.name}_" for p in program.inputs)
    main = [
        "import casadi",
        "",
        *inputs,
        f'function = casadi.Function.load("{name}.casadi")',
        f"result = function({given})",
        f'print(f"{{int(result["status"])}}: {{float(result["{_first(program).name}"][0]):.12g}}")'.replace(
            '["', "['"
        ).replace('"]', "']"),
    ]
    return ["### CasADi", "", "```python", *main, "```"]


def _external(model: Model, name: str, program: Program | Iteration, *, sources: Sequence[str]) -> list[str]:
    inputs = [f"{k}_ = {v}" for k, v in _states(model, name, ("[", "]")).items()]
    library = f"lib{model.name}_external.so"
    main = [
        "import casadi",
        "",
        *inputs,
        f'function = casadi.external("{model.name}_casadi_{name}", "./{library}")',
        f"result = function({', '.join(f'{p.name}={p.name}_' for p in program.inputs)})",
        f"print(f\"{{int(result['status'])}}: {{float(result['{_first(program).name}'][0]):.12g}}\")",
    ]
    files = [*sources, f"{model.name}_jacobians.c", f"{model.name}_external.c"]
    command = f"`cc -std=c99 -O2 -fno-math-errno -shared -fPIC {' '.join(files)} -lm -o {library}`"
    hessian = (
        "`status` is the last output, as of the `.casadi` functions: 0 where the others hold. First derivatives only: "
    )
    hessian += 'give IPOPT the option `hessian_approximation="limited-memory"`, or add `--target external_hessians`.'
    return ["### CasADi external functions", "", command, "", hessian, "", "```python", *main, "```"]


def _javascript(model: Model, name: str, program: Program | Iteration) -> list[str]:
    inputs = [f"const {k}_ = {v};" for k, v in _states(model, name, ("[", "]")).items()]
    given = ", ".join(f"{p.name}_" for p in program.inputs)
    main = [
        f'const model = require("./{model.name}.js");',
        *inputs,
        f"const result = model.{name}({given});",
        f"console.log(`${{result.status}}: ${{result.{_first(program).name}[0]}}`);",
    ]
    return ["### JavaScript", "", "```js", *main, "```"]


def _mjcf(model: Model, name: str, program: Program | Iteration) -> list[str]:
    main = [
        "import mujoco",
        "",
        f'model = mujoco.MjModel.from_xml_path("{model.name}.xml")',
        "data = mujoco.MjData(model)",
        "mujoco.mj_forward(model, data)",
        'print(f"freedoms of the tree: {model.nv}")',
    ]
    return ["### MJCF", "", "```python", *main, "```"]


def _urdf(model: Model, name: str, program: Program | Iteration) -> list[str]:
    main = [
        "import pinocchio",
        "",
        f'model = pinocchio.buildModelFromUrdf("{model.name}.urdf")',
        "data = model.createData()",
        "pinocchio.forwardKinematics(model, data, pinocchio.neutral(model))",
        'print(f"freedoms: {model.nv}")',
    ]
    return ["### URDF", "", "```python", *main, "```"]
