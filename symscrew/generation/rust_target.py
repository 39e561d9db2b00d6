"""Target "rust": a crate without the standard library, which rustc compiles and runs here."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from symscrew.export import RustNames, print_rust
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values
from symscrew.model import Model

LIMIT = 600  # seconds to compile and run: the longest functions of the catalogue take a minute

MAIN = """\
// Reads states as bytes, calls functions, writes results and statuses as bytes.
use CRATE::*;
use std::convert::TryInto;
use std::io::{Read, Write};

type Real = REAL;

fn read<const N: usize>(states: &mut std::slice::Iter<[u8; SIZE]>) -> [Real; N] {
    let mut found = [0.0; N];
    for value in found.iter_mut() {
        *value = Real::from_le_bytes(*states.next().expect("a number"));
    }
    found
}

fn write(made: &mut Vec<u8>, values: &[Real]) {
    for value in values {
        made.extend_from_slice(&value.to_le_bytes());
    }
}

fn status(made: &mut Vec<u8>, code: i32) {
    write(made, &[code as Real]);
}

fn main() {
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes).expect("states");
    let numbers: Vec<[u8; SIZE]> = bytes.chunks_exact(SIZE).map(|x| x.try_into().unwrap()).collect();
    let mut states = numbers.iter();
    let mut made = Vec::new();
CALLS
    std::io::stdout().write_all(&made).expect("results");
}
"""


def files(order: Order) -> Mapping[str, str]:
    """<name>.rs and Cargo.toml."""
    return print_rust(order.model, order.precision)


def section(order: Order) -> Sequence[str]:
    """How a function is called."""
    model, names = order.model, RustNames(order.model)
    function, program = next((n, p) for n, p in model.programs.items() if any(port.size for port in p.outputs))
    values = [", ".join(repr(float(x)) for x in np.atleast_2d(array)[0]) for array in model.test_inputs[function]]
    given = [f"{names.of(p)}([{text}])" for p, text in zip(program.inputs, values, strict=True)]
    field = next(f for f, port in zip(names.fields(program), program.outputs, strict=True) if port.size)
    return [
        "### Rust",
        "",
        "```rust",
        f"use {names.crate}::*;",
        "",
        "fn main() {",
        *(f"    let input{k} = {text};" for k, text in enumerate(given)),
        f"    match {names.function(function)}::<Std>({', '.join(f'&input{k}' for k in range(len(given)))}) {{",
        f'        Ok(found) => println!("{field}: {{:?}}", found.{field}.0),',
        '        Err(status) => println!("{}", status.text()),',
        "    }",
        "}",
        "```",
        "",
        "```sh",
        f"rustc --edition 2018 --crate-type rlib --crate-name {names.crate} -O --cfg 'feature=\"std\"' {model.name}.rs",
        f"rustc --edition 2018 -O main.rs --extern {names.crate}=lib{names.crate}.rlib",
        "```",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """Values by rustc, at the test states."""
    rustc = shutil.which("rustc")
    if rustc is None:
        yield True, "no rustc here (apt install rustc): Rust not compiled"
        return
    if case.precision.suffix:  # the evaluator has more digits: its C is compared with it by its own target
        failed = build(rustc, case.model, case.fresh, "f32", optimised=False)
        yield not failed, failed or f"{case.model.name}.rs compiles"
        return
    failed = build(rustc, case.model, case.fresh, "f64", optimised=False)
    if failed:
        yield False, failed
        return
    given = {name: case.model.test_inputs[name] for name in case.expected}
    found = call(case.model, case.fresh, given, np.dtype("<f8"))
    yield compare_values("Rust", case.model, case.expected, lambda name, _: found[name])


def build(rustc: str, model: Model, directory: Path, real: str, *, optimised: bool = True) -> str:
    """Compile the crate in a folder and a program that calls it; "" or what the compiler says."""
    names = RustNames(model)
    (directory / "main.rs").write_text(_main(model, real))
    level = f"opt-level={3 if optimised else 0}"
    crate = ("--crate-type", "rlib", "--crate-name", names.crate, "--cfg", 'feature="std"', f"{model.name}.rs")
    for more in (crate, ("main.rs", "--extern", f"{names.crate}=lib{names.crate}.rlib")):
        command = [rustc, "--edition", "2018", "-C", level, *more]
        try:
            done = subprocess.run(
                command, cwd=directory, capture_output=True, encoding="utf-8", errors="replace", check=False,
                timeout=LIMIT,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"rustc does not compile {model.name}.rs: {error}"
        if done.returncode or "warning" in done.stderr:
            return f"rustc on {model.name}.rs: {done.stderr.strip()[:300]}"
    return ""


def _main(model: Model, real: str) -> str:
    """The program: all functions, each at as many states as it is told first."""
    names, calls = RustNames(model), list[str]()
    for function, program in model.programs.items():
        given = [f"&{names.of(port)}(read(&mut states))" for port in program.inputs]
        fields = [f"write(&mut made, &found.{field}.0);" for field in names.fields(program)]
        lost = [f"write(&mut made, &[Real::NAN; {port.size}]);" for port in program.outputs]
        code = "found.status.code()" if names.two_ways(program) else "0"
        calls += [
            "    let [count] = read(&mut states);",
            "    for _ in 0..count as usize {",
            f"        match {names.function(function)}::<Std>({', '.join(given)}) {{",
            f"            Ok({'found' if fields or code != '0' else '_'}) => {{",
            *(f"                {line}" for line in [*fields, f"status(&mut made, {code});"]),
            "            }",
            "            Err(code) => {",
            *(f"                {line}" for line in [*lost, "status(&mut made, code.code());"]),
            "            }",
            "        }",
            "    }",
        ]
    words = {"CRATE": names.crate, "REAL": real, "SIZE": str(int(real[1:]) // 8), "CALLS": "\n".join(calls)}
    text = MAIN
    for word, meaning in words.items():
        text = text.replace(word, meaning)
    return text


def call(
    model: Model, directory: Path, given: Mapping[str, Sequence[np.ndarray]], kind: np.dtype[np.floating], *options: str
) -> dict[str, Results]:
    """Results of functions by the program that `build` made, at inputs (states, size), none of the others."""
    counts = {name: len(given[name][0]) if given.get(name) else int(name in given) for name in model.programs}
    data = []
    for name, count in counts.items():
        columns = [np.asarray(x).reshape(count, x.shape[-1]) for x in given.get(name, ())]
        data += [np.array([count], kind), *((np.hstack(columns) if columns else np.zeros(0)).astype(kind).ravel(),)]
    command = [str(directory / "main"), *options]
    made = subprocess.run(command, input=np.concatenate(data).tobytes(), capture_output=True, check=True, timeout=LIMIT)
    numbers = np.frombuffer(made.stdout, kind)
    found = {}
    for name, count in counts.items():
        sizes = [port.size for port in model.programs[name].outputs]
        rows = numbers[: count * (sum(sizes) + 1)].reshape(count, sum(sizes) + 1)
        numbers = numbers[rows.size :]
        found[name] = (tuple(np.split(rows[:, :-1], np.cumsum(sizes)[:-1], axis=1)), rows[:, -1].astype(int))
    return found
