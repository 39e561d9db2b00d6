"""The header of generated C: conventions and entries of arrays once, then a paragraph and declarations a function."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from symscrew.export import c_batch
from symscrew.export.c_names import arguments, declare
from symscrew.export.c_parameters import parameter_type
from symscrew.export.c_precision import DOUBLE, Precision
from symscrew.export.c_single import error_lines, single_errors
from symscrew.export.conventions import conventions, stack
from symscrew.export.listing import MAX_LABELS, banner, operations_text, packed, plain, statuses, unit_of, wrapped
from symscrew.model import Model
from symscrew.program import OUT_OF_REACH, Iteration, Port, Program, status_texts

STATUS_MACROS = {
    -2: "RANK_LOST",
    -1: "RANK_REVEALING",
    0: "SUCCESS",
    1: "NEAR_SINGULAR",
    2: "NOT_FINITE",
    3: "NOT_CONVERGED",
    4: "OTHER_BRANCH",
    5: "NO_ROTATION",
    6: "NOT_ON_MECHANISM",
}


def status_macros(model: Model) -> dict[int, str]:
    """What statuses of a model's functions are called in C."""
    further = (code for code in status_texts(*model.programs.values()) if code >= OUT_OF_REACH)
    return {**STATUS_MACROS, **{code: f"OUT_OF_REACH_{k}" for k, code in enumerate(further, 1)}}


NOTHING = "; all outputs are NaN"  # of a status: the header says so of all that are failures
ENUMERATED = 64  # entries of an array that get names: longer arrays are read in loops, and their order is described
WIDTH = 116  # characters of a line of a comment
FEW = 5  # parts of a list that is written out wherever it is needed
LONGEST = 119  # of a declaration without its semicolon
ABOUT_ARRAYS = """On failure all outputs are NaN. Do not compile with -ffinite-math-only or -ffast-math: the checks
for NaN would vanish."""
ABOUT_BATCHES = """A batch writes the status of each of `count` states to `status` unless that is NULL, and returns
the largest, 0 if all are below. <function>_batch takes the arrays of the states one after the other;
<function>_batch_soa has entry k of state i at [k * stride + i], stride >= count. Both take eight states at once on
vector units; results may differ from those of single calls by rounding (not where the compiler contracts nothing and
the sines are the same). With -fopenmp, %d states and more are shared among threads."""
ABOUT_STACK = "The stack holds the temporaries of a call, which a compiler tells (-fstack-usage)"
ABOUT_SECOND_PATHS = "near a small pivot, where the status is below 0, also arrays of %d bytes at most"
ABOUT_BLOCKS = "batches also hold blocks of eight states, of %d bytes at most: define %s_STATE_BY_STATE to do without"
ABOUT_LANES = """Single calls have equal limbs side by side on vector units of x86-64 (AVX2) where that is faster;
results are those of limb after limb, but for what the compiler contracts. Define %s_LIMB_BY_LIMB to do without."""


def print_header(model: Model, *, precision: Precision = DOUBLE, batches: bool = True) -> str:
    """Declarations, sizes and what a user must know of every function."""
    upper = model.name.upper()
    about = [ABOUT_ARRAYS]
    if batches:
        about += [ABOUT_BATCHES % c_batch.THREADED, ABOUT_LANES % upper]
    about.append(_stack(model, precision, batches=batches))
    if precision.suffix:
        about = [f"Single precision: all numbers are of type {precision.real}.", *about]
    measured = single_errors(model) if precision.suffix else {}
    told = [f"{what}: {text}" for what, text in conventions(model).items()]
    texts = status_texts(*model.programs.values())
    lines = [
        *comment([*banner(model), *(line for text in about for line in ("", *wrapped(text, width=WIDTH)))]),
        f"#ifndef {upper}_H",
        f"#define {upper}_H",
        "",
        "#include <stddef.h>",
        "",
        *comment([line for text in told for line in wrapped(text, later="  ", width=WIDTH)]),
        "",
        "/* What functions return; the text of a status says it in words. */",
        *(
            f"#define {upper}_{macro} {_literal(code)} /* {plain(texts[code].replace(NOTHING, ''))} */"
            for code, macro in status_macros(model).items()
        ),
        "",
        *_entries(model),
        *_told_once(model),
        "",
        "#ifdef __cplusplus",
        'extern "C" {',
        "#endif",
        "",
        "/* What a status means, in words that stay where they are: nobody frees them. */",
        f"const char *{model.name}_status_text(int status);",
        *parameter_type(model, precision),
    ]
    named, lists, common = _described_once(model), _lists(model), _common_sizes(model)
    for name, program in model.programs.items():
        symbol = f"{model.name}_{name}"
        errors = error_lines(program, measured.get(name)) if precision.suffix else []
        lines += ["", *short_comment([*_paragraph(symbol, program, named, lists), *errors])]
        lines += _sizes(symbol, program, common)
        lines += [declare(symbol, arguments(program, precision, ""), width=LONGEST) + ";"]
        if batches:
            lines += [text + ";" for text in c_batch.signatures(symbol, program, precision, "", width=LONGEST)]
    lines += ["", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {upper}_H */", ""]
    return "\n".join(lines)


def _literal(code: int) -> str:
    """A number that stays one in any expression: a minus sign binds less than what may stand beside it."""
    return str(code) if code >= 0 else f"({code})"


def comment(lines: Iterable[str]) -> list[str]:
    """Lines as a comment of C."""
    return ["/*", *((f" * {line}").rstrip() for line in lines), " */"]


def _stack(model: Model, precision: Precision, *, batches: bool) -> str:
    """What calls take of the stack at most."""
    told, bytes_of = [ABOUT_STACK], stack(model, precision, batches=batches)
    if bytes_of["second_path"]:
        told.append(ABOUT_SECOND_PATHS % bytes_of["second_path"])
    if batches:
        told.append(ABOUT_BLOCKS % (bytes_of["blocks"], model.name.upper()))
    return f"{'; '.join(told)}."


def _told_once(model: Model) -> list[str]:
    """Sizes of arrays of several functions, and lists of parts that arrays have entries for."""
    upper, lines = model.name.upper(), list[str]()
    sizes = [f"{upper}_{name}_SIZE = {size}" for name, size in _common_sizes(model).items()]
    if sizes:
        lines += ["/* Their sizes, and those of other arrays that are the same in all functions. */"]
        lines += wrapped(f"enum {{ {', '.join(sizes)} }};", later="    ", width=WIDTH)
    for parts, name in _lists(model).items():
        if not name.startswith("the "):
            continue
        lines += short_comment(wrapped(f"{name}: {', '.join(parts)}", later="  ", width=WIDTH))
    return lines


def short_comment(lines: Sequence[str]) -> list[str]:
    """Lines as a comment of C that takes no line more than these."""
    text = [f"{' *' if k else '/*'} {line}".rstrip() for k, line in enumerate(lines)]
    return [*text[:-1], f"{text[-1]} */"]


def _ports(model: Model) -> list[Port]:
    return [port for p in model.programs.values() for port in (*p.inputs, *p.outputs)]


def _key(port: Port) -> tuple[object, ...]:
    return port.name, port.labels, port.units


def _described_once(model: Model) -> dict[tuple[object, ...], Port]:
    """Arrays of several functions with the same entries under the same name, one of each; none of two kinds."""
    ports = {_key(port): port for port in _ports(model) if port.size > 1 and len(port.labels) == port.size}
    kinds, times = Counter(port.name for port in ports.values()), Counter(map(_key, _ports(model)))
    chosen = {
        key for key, port in ports.items() if kinds[port.name] == 1 and times[key] > 1 and port.size <= ENUMERATED
    }
    return {key: port for key, port in ports.items() if key in chosen}


def _labels(port: Port, lists: Mapping[tuple[str, ...], str]) -> list[str]:
    """The entries of an array: all of them, or the parts and their components where each part has the same.

    `lists`: names of lists of parts that are told once.
    """
    unit = unit_of(port)
    units = ["" if unit is not None else f" [{u}]" for u in port.units]
    short = _as_others(port, lists)
    if short:
        return wrapped(short, first="    ", later="    ", width=WIDTH)
    for mark in (".", "|"):
        split = [label.rpartition(mark) for label in port.labels]
        parts = list(dict.fromkeys(first for first, _, _ in split))
        inner = list(dict.fromkeys(f"{last}{u}" for (_, _, last), u in zip(split, units, strict=True)))
        entries = [(first, f"{last}{u}") for (first, _, last), u in zip(split, units, strict=True)]
        if len(parts) > 1 and len(inner) > 1 and entries == [(part, entry) for part in parts for entry in inner]:
            text = f"for each of {lists.get(tuple(parts)) or ', '.join(parts)}: {', '.join(inner)}"
            return wrapped(text, first="    ", later="    ", width=WIDTH)
        if len(parts) > 1 and len(inner) > 1 and entries == [(part, entry) for entry in inner for part in parts]:
            columns = ", ".join(f"{mark}{entry}" for entry in inner)
            text = f"for each of {columns}: {lists.get(tuple(parts)) or ', '.join(parts)}"
            return wrapped(text, first="    ", later="    ", width=WIDTH)
        without = list(dict.fromkeys(last for _, _, last in split))
        if len(parts) > 1 and port.labels == tuple(f"{part}{mark}{last}" for part in parts for last in without):
            text = f"for each of {lists.get(tuple(parts)) or ', '.join(parts)}: {', '.join(without)}; {_units(port)}"
            return wrapped(text, first="    ", later="    ", width=WIDTH)
    entries_ = [f"{k} {label}{u}" for k, (label, u) in enumerate(zip(port.labels, units, strict=True))][:MAX_LABELS]
    if port.size > MAX_LABELS:
        entries_.append(f"... {port.size} entries; all labels are in manifest.json")
    return packed([plain(entry) for entry in entries_], indent="    ", width=WIDTH)


def _units(port: Port) -> str:
    return f"units {', '.join(dict.fromkeys(port.units))}"


def _as_others(port: Port, lists: Mapping[tuple[str, ...], str]) -> str:
    """The entries of an array, or the rows and columns of a matrix, if they are in the order of others; else ""."""
    units = f", {_units(port)}" if unit_of(port) is None else ""
    if port.labels in lists:
        return f"in the order of {lists[port.labels]}{units}"
    rows, columns = (
        tuple(dict.fromkeys(label.split("|")[k] for label in port.labels if "|" in label)) for k in (0, -1)
    )
    if rows in lists and list(port.labels) == [f"{row}|{column}" for column in columns for row in rows]:
        return f"rows in the order of {lists[rows]}, columns of {lists.get(columns) or ', '.join(columns)}{units}"
    return ""


def _lists(model: Model) -> dict[tuple[str, ...], str]:
    """Labels of arrays that are told once, with their names; lists of parts that several arrays have entries for."""
    once, found = _described_once(model), Counter[tuple[str, ...]]()
    arrays: dict[tuple[str, ...], str] = {}
    for port in once.values():
        arrays.setdefault(port.labels, port.name)
    for port in (p for p in _ports(model) if _key(p) not in once and len(p.labels) == p.size > 1):
        for mark in (".", "|"):
            parts = tuple(dict.fromkeys(label.rpartition(mark)[0] for label in port.labels))
            if len(parts) < port.size and all(parts):
                found[parts] += 1
    several = [parts for parts, times in found.items() if len(parts) > FEW and times > 1]
    kinds = {kind: set(getattr(model.mechanism, kind, ())) for kind in ("bodies", "joints", "points")}
    named = {parts: next((k for k, every in kinds.items() if every >= set(parts)), "") for parts in several}
    alike = Counter((kind, len(parts)) for parts, kind in named.items())
    kept = {parts: kind for parts, kind in named.items() if kind and alike[kind, len(parts)] == 1}
    return {**{parts: f"the {len(parts)} {kind}" for parts, kind in kept.items()}, **arrays}


def _common_sizes(model: Model) -> dict[str, int]:
    """Sizes of arrays that several functions have under the same name, all of them of this size."""
    sizes: dict[str, set[int]] = {}
    for port in _ports(model):
        sizes.setdefault(port.name.upper(), set()).add(port.size)
    times = Counter(port.name.upper() for port in _ports(model))
    functions = {name.upper() for name in model.programs}
    return {name: min(of) for name, of in sizes.items() if len(of) == 1 and times[name] > 1 and name not in functions}


def _entries(model: Model) -> list[str]:
    """Indices of the entries of arrays that several functions have, as enumerations."""
    lines = ["/* Entries of arrays that several functions have. */"]
    for port in _described_once(model).values():
        stem = f"{model.name.upper()}_{port.name.upper()}"
        names = [re.sub(r"[^A-Za-z0-9]+", "_", f"{stem}_{label}").upper() for label in port.labels]
        if len(set(names)) == port.size and port.size <= ENUMERATED:
            text = ", ".join(names)
            unit = unit_of(port)
            several = ", ".join(f"{n} of unit 1" if u == "1" else f"{n} in {u}" for u, n in Counter(port.units).items())
            units = several if unit is None else unit
            lines.append(f"/* {port.name}[{port.size}] [{units}]: {plain(port.description)} */")
            lines += wrapped(f"enum {model.name}_{port.name} {{ {text} }};", later="    ", width=WIDTH)
    return lines if len(lines) > 1 else []


def _paragraph(
    symbol: str,
    program: Program | Iteration,
    named: dict[tuple[object, ...], Port],
    lists: Mapping[tuple[str, ...], str],
) -> list[str]:
    """All that a user must know to call a function, beyond what is said once."""
    lines = wrapped(f"{symbol}: {program.description}", width=WIDTH)
    for title, ports in (("in", program.inputs), ("out", program.outputs)):
        once = [p for p in ports if _key(p) in named]
        if title == "in" and len(once) == len(ports):
            continue
        for port in ports:
            if port in once and title == "in":
                continue
            unit = unit_of(port)
            shape = f" ({'x'.join(map(str, port.shape))}, column by column)" if len(port.shape) > 1 else ""
            head = f"{title} {port.name}[{port.size}]{shape}{'' if unit is None else f' [{unit}]'}"
            lines += wrapped(f"{head}: {port.description}", first="  ", later="    ", width=WIDTH)
            if port not in once and port.size > 1 and len(port.labels) == port.size:
                lines += _labels(port, lists)
            elif len(port.labels) == 1 and port.size == 1:
                lines[-1] += f" ({plain(port.labels[0])})"
    codes = ", ".join(map(str, statuses(program)))
    lines += wrapped(f"Returns {codes}; {operations_text(program)}", first="  ", later="    ", width=WIDTH)
    for note in program.notes:
        lines += wrapped(f"Note: {note}", first="  ", later="    ", width=WIDTH)
    return lines


def _sizes(symbol: str, program: Program | Iteration, common: Mapping[str, int]) -> list[str]:
    """Sizes of arrays that are not told once."""
    ports: Sequence[Port] = [p for p in (*program.inputs, *program.outputs) if p.name.upper() not in common]
    names = [port.name.upper() for port in ports]
    if len(set(names)) != len(names):
        names = [port.name for port in ports]
    sizes = [f"{symbol.upper()}_{name}_SIZE = {port.size}" for name, port in zip(names, ports, strict=True)]
    return wrapped(f"enum {{ {', '.join(sizes)} }};", later="    ", width=WIDTH) if sizes else []
