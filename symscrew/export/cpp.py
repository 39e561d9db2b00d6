"""A C++17 header over the C code: a namespace, sizes checked by the compiler, results by value.

    const auto result = four_bar::inverse_dynamics(q, v, a);   // std::array, C array, or (C++20) std::span
    if (result.ok()) { use(result.u); } else { report(four_bar::text(result.status)); }

No dependency, no allocation, no exceptions. A second form of every function writes into the caller's arrays.
"""

from __future__ import annotations

from symscrew.description import namespace
from symscrew.export.c import argument_names
from symscrew.export.c_header import status_macros
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, check_names, plain
from symscrew.model import Model
from symscrew.program import Iteration, Program

VIEWS = """
/* `Size` numbers of the caller, read or written in place: a std::array, an array of C or a fixed std::span. */
template <std::size_t Size>
class In {
public:
    In(const std::array<REAL, Size> &values) noexcept : data_(values.data()) {}
    template <std::size_t Count, typename = std::enable_if_t<Count == Size>>
    In(const REAL (&values)[Count]) noexcept : data_(values) {}
#if defined(__cpp_lib_span)
    In(std::span<const REAL, Size> values) noexcept : data_(values.data()) {}
    In(std::span<REAL, Size> values) noexcept : data_(values.data()) {}
#endif
    const REAL *data() const noexcept { return data_; }

private:
    const REAL *data_;
};

template <std::size_t Size>
class Out {
public:
    Out(std::array<REAL, Size> &values) noexcept : data_(values.data()) {}
    template <std::size_t Count, typename = std::enable_if_t<Count == Size>>
    Out(REAL (&values)[Count]) noexcept : data_(values) {}
#if defined(__cpp_lib_span)
    Out(std::span<REAL, Size> values) noexcept : data_(values.data()) {}
#endif
    REAL *data() const noexcept { return data_; }

private:
    REAL *data_;
};
"""


def print_cpp(model: Model, precision: Precision = DOUBLE) -> dict[str, str]:
    """File name to text: `<name>.hpp`."""
    check_names(model)
    guard = f"{model.name.upper()}_HPP"
    lines = ["/*", *(f" * {line}".rstrip() for line in banner(model)), " */"]
    lines += [f"#ifndef {guard}", f"#define {guard}", "", "#include <array>", "#include <cstddef>"]
    lines += ["#include <type_traits>", "#if defined(__has_include)", "#if __has_include(<version>)"]
    lines += ["#include <version>", "#endif", "#endif", "#if defined(__cpp_lib_span)", "#include <span>", "#endif"]
    space = namespace(model.name)
    lines += ["", f'#include "{model.name}.h"', "", f"namespace {space} {{", ""]
    lines += ["enum class Status : int {"]
    lines += [f"    {macro.lower()} = {code}," for code, macro in status_macros(model).items()]
    lines += ["};", "", "/* What a status means. */", "inline const char *text(Status status) noexcept", "{"]
    lines += [f"    return ::{model.name}_status_text(static_cast<int>(status));", "}"]
    lines += VIEWS.rstrip().replace("REAL", precision.real).splitlines()
    for name, program in model.programs.items():
        lines += ["", *_function(model.name, name, program, precision.real)]
    lines += ["", f"}} /* namespace {space} */", "", f"#endif /* {guard} */", ""]
    return {f"{model.name}.hpp": "\n".join(lines)}


def _function(model: str, name: str, program: Program | Iteration, real: str) -> list[str]:
    """The result type and both forms of one function."""
    names = argument_names((*program.inputs, *program.outputs))
    inputs = list(zip(names, program.inputs, strict=False))
    outputs = list(zip(names[len(inputs) :], program.outputs, strict=True))
    read = [f"In<{port.size}> {argument}" for argument, port in inputs]
    written = [f"Out<{port.size}> {argument}" for argument, port in outputs]
    call = ", ".join(f"{argument}.data()" for argument in names)
    passed = ", ".join([*(argument for argument, _ in inputs), *(f"result.{argument}" for argument, _ in outputs)])
    result = f"{name}_result"
    return [
        f"/* {plain(program.description)} See {model}.h for shapes, units and labels. */",
        f"struct {result} {{",
        *(f"    std::array<{real}, {port.size}> {argument}{{}};" for argument, port in outputs),
        "    Status status{};",
        "    /* Whether the arrays hold results: they are NaN otherwise. */",
        "    bool ok() const noexcept { return static_cast<int>(status) <= 0; }",
        "};",
        "",
        f"inline Status {name}({', '.join([*read, *written])}) noexcept",
        "{",
        f"    return static_cast<Status>(::{model}_{name}({call}));",
        "}",
        "",
        f"inline {result} {name}({', '.join(read)}) noexcept",
        "{",
        f"    {result} result;",
        f"    result.status = {name}({passed});",
        "    return result;",
        "}",
    ]
