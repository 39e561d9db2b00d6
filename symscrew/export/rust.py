"""Rust of a model: one crate without the standard library, allocation or `unsafe`, a function per program.

    let velocity = four_bar::velocity::<Std>(&q, &y_dot)?;   // Q, YDot -> Result<VelocityOutput, Status>

Every kind of array is a type of its own, so that q and v cannot be exchanged; what fails gives a `Status` and no
numbers. The operations are those of the C in their order: both give the same bits where neither contracts a * b + c and
both take sines from the same library, which a type chosen by the caller (`Math`) names.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from symscrew.export.c_header import status_macros
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.listing import banner, check_names, filled, operations_text, plain, port_lines, statuses, wrapped
from symscrew.export.rust_function import arrays_module
from symscrew.export.rust_names import RustNames, real
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program, status_texts

ABOUT = """Arrays are column-major. Nothing is allocated, no state is kept, and there is no `unsafe`. `Math` names the
functions of a library; with the feature `std` the type `Std` takes those of the standard library. Functions give
`Err(status)` in place of numbers where they fail."""

MATH = """
/// The functions of a library that the code calls. On a machine without `std` hand them on to a library of your choice.
pub trait Math {
    fn sin(x: REAL) -> REAL;
    fn cos(x: REAL) -> REAL;
    fn tan(x: REAL) -> REAL;
    fn atan2(y: REAL, x: REAL) -> REAL;
    fn exp(x: REAL) -> REAL;
    fn sqrt(x: REAL) -> REAL;
}

/// `Math` of the standard library.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub struct Std;

#[cfg(feature = "std")]
impl Math for Std {
    #[inline]
    fn sin(x: REAL) -> REAL {
        x.sin()
    }
    #[inline]
    fn cos(x: REAL) -> REAL {
        x.cos()
    }
    #[inline]
    fn tan(x: REAL) -> REAL {
        x.tan()
    }
    #[inline]
    fn atan2(y: REAL, x: REAL) -> REAL {
        y.atan2(x)
    }
    #[inline]
    fn exp(x: REAL) -> REAL {
        x.exp()
    }
    #[inline]
    fn sqrt(x: REAL) -> REAL {
        x.sqrt()
    }
}
"""

CARGO = """# NOTE
[package]
name = "CRATE"
version = "0.0.0"
edition = "2018"
rust-version = "1.63"
publish = false

[lib]
name = "CRATE"
path = "NAME.rs"
doctest = false

[features]
std = []
"""


def print_rust(model: Model, precision: Precision = DOUBLE) -> dict[str, str]:
    """File name to text: `<name>.rs`, the crate, and `Cargo.toml`."""
    check_names(model)
    names = RustNames(model)
    lines = [f"//! {line}".rstrip() for line in [*banner(model), "", *wrapped(ABOUT)]]
    lines += [
        "#![no_std]",
        "#![forbid(unsafe_code)]",
        "#![allow(clippy::all, non_snake_case)] // names have those of joints",
        "",
    ]
    lines += ['#[cfg(feature = "std")]', "extern crate std;", *filled(MATH, {"REAL": real(precision)})]
    lines += ["", *_status(model)]
    for port, name in names.types.items():
        lines += ["", *_port_type(port, name, precision)]
    for function, program in model.programs.items():
        lines += ["", *_output(function, program, names), "", *_typed(function, program, names)]
    lines += ["", *arrays_module(model, precision)]
    cargo = filled(CARGO, {"NOTE": banner(model)[0], "CRATE": names.crate, "NAME": model.name})
    return {f"{model.name}.rs": "\n".join([*lines, ""]), "Cargo.toml": "\n".join([*cargo, ""])}


def _status(model: Model) -> list[str]:
    """What functions return where they fail, and how they succeeded where there are two ways."""
    texts = {
        code: text.replace("; all outputs are NaN", "") for code, text in status_texts(*model.programs.values()).items()
    }
    called = {code: "".join(word.capitalize() for word in m.split("_")) for code, m in status_macros(model).items()}
    lines = ["/// What a status says of a state; only those up to 0 come with numbers.", "#[repr(i32)]"]
    lines += ["#[derive(Clone, Copy, Debug, PartialEq, Eq)]", "pub enum Status {"]
    for code, name in called.items():
        lines += [f"    /// {plain(texts[code])}", f"    {name} = {code},"]
    lines += [
        "}",
        "",
        "impl Status {",
        "    /// The number of the status, as in the C.",
        "    pub fn code(self) -> i32 {",
    ]
    lines += [
        "        self as i32",
        "    }",
        "",
        "    /// What it says in words.",
        "    pub fn text(self) -> &'static str {",
    ]
    lines += ["        match self {"]
    for code, name in called.items():
        text = plain(texts[code]).replace('"', "'")
        lines += [f'            Status::{name} => "{text}",']
    lines += ["        }", "    }", "", "    fn of(code: i32) -> Status {", "        match code {"]
    others = [(code, name) for code, name in called.items() if code != 2]
    lines += [f"            {code} => Status::{name}," for code, name in others]
    return [*lines, f"            _ => Status::{called[2]},", "        }", "    }", "}"]


def _comment(lines: Iterable[str]) -> list[str]:
    return [f"/// {line}".rstrip() for line in lines]


def _port_type(port: Port, name: str, precision: Precision) -> list[str]:
    """An array as a type: its entries are the field `0`."""
    return [
        *_comment(["```text", *port_lines(port), "```"]),
        "#[derive(Clone, Copy, Debug, PartialEq)]",
        f"pub struct {name}(pub [{real(precision)}; {port.size}]);",
    ]


def _output(function: str, program: Program | Iteration, names: RustNames) -> list[str]:
    fields = names.fields(program)
    lines = [f"/// Results of `{function}`.", "#[derive(Clone, Copy, Debug, PartialEq)]"]
    lines += [f"pub struct {names.outputs[function]} {{"]
    lines += [f"    pub {field}: {names.of(port)}," for field, port in zip(fields, program.outputs, strict=True)]
    if names.two_ways(program):
        lines += ["    /// `Success`, or by which of the ways near a small pivot.", "    pub status: Status,"]
    return [*lines, "}"]


def _typed(function: str, program: Program | Iteration, names: RustNames) -> list[str]:
    """The function that users call."""
    given, fields = names.arguments(program), names.fields(program)
    taken = [f"{name}: &{names.of(port)}" for name, port in zip(given, program.inputs, strict=True)]
    output = names.outputs[function]
    head = f"pub fn {names.function(function)}<M: Math>({', '.join(taken)}) -> Result<{output}, Status> {{"
    made = [
        f"{field}: {names.of(port)}([0.0; {port.size}])" for field, port in zip(fields, program.outputs, strict=True)
    ]
    made += ["status: Status::Success"] if names.two_ways(program) else []
    passed = [*(f"&{name}.0" for name in given), *(f"&mut result.{field}.0" for field in fields)]
    second = "if code < 0 {\n        result.status = Status::of(code);\n    }\n    " if names.two_ways(program) else ""
    mutable = "mut " if fields else ""
    return [
        *_comment(_about(program)),
        *wrapped(head, later="    "),
        *wrapped(f"let {mutable}result = {output} {{ {', '.join(made)} }};", first="    ", later="        "),
        *wrapped(
            f"let code = arrays::{names.function(function)}::<M>({', '.join(passed)});", first="    ", later="        "
        ),
        *f"    {second}if code > 0 {{ Err(Status::of(code)) }} else {{ Ok(result) }}".splitlines(),
        "}",
    ]


def _about(program: Program | Iteration) -> Iterator[str]:
    yield from wrapped(program.description)
    yield ""
    for code, text in statuses(program).items():
        if code > 0:
            yield from wrapped(f"Err {code}: {text.replace('; all outputs are NaN', '')}", later="  ")
    yield from wrapped(f"O{operations_text(program)[1:]}")
    for note in program.notes:
        yield from wrapped(f"Note: {note}", later="  ")
