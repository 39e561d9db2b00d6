"""Evidence for an assessor: what was checked of generated C, how, with what, and what was found, as one file.

    C of the functions --cppcheck, MISRA C:2012--> rules, each with its justification or open
                       --its text, the compiler's graph of calls--> loops, recursion, heap, worst stack
                       --emulator--> instructions
                       --vectors, gcov--> statuses, numbers that are not finite on success, branches

`ok` is the verdict: no open rule, no allocation, no unbounded loop, no number that is not finite on a status up to 0.
Branches that no vector takes are counted and listed; they do not change the verdict.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from symscrew.export import PRECISIONS, Precision, model_hash, print_c
from symscrew.model import Model
from symscrew.program import status_texts
from symscrew.verification.embedded.branch_vectors import direct_calls, function_vectors
from symscrew.verification.embedded.emulation import EmbeddedError, measure

LIMIT = 900  # [s] of a tool: the checker takes a minute for the longest functions of the catalogue

# Deviations: rule -> category, and why the code deviates.
DEVIATIONS: Mapping[str, tuple[str, str]] = {
    "2.4": ("advisory", "enumerations in the header name entries of arrays for users; the code itself takes numbers"),
    "2.5": ("advisory", "macros of the header name statuses and sizes for users; those of bodies serve both forms"),
    "8.7": ("advisory", "functions of the header have external linkage, whether this file calls them or not"),
    "8.9": ("advisory", "constants of a mechanism stand once, with their meaning, though one function may read them"),
    "8.14": ("required", "`restrict` states the header's contract that arrays do not overlap; callers must keep it"),
    "9.3": ("required", "arrays start as {0.0}, which the rule allows for zero; the checker sees a real number"),
    "10.4": ("required", "size_t places are multiplied by small positive literals of int, which cannot be negative"),
    "12.1": (
        "advisory",
        "sums of products are written as in mathematics; the grammar of C fixes the association",
    ),
    "12.3": ("advisory", "declarations of several constants of one type; there is no comma operator in expressions"),
    "15.5": ("advisory", "a refused input ends a function where it is seen, before numbers are made of it"),
    "18.4": ("advisory", "matrices by columns are handed on from a place in an array whose size is known"),
    "20.5": ("advisory", "macros of bodies end with the part of the file that reads them"),
    "20.7": ("required", "a macro's parameter that is a type or a name cannot be in parentheses"),
    "20.10": ("advisory", "a body's name is put together from its function's by ##, once"),
}
ALLOWED = frozenset(
    ["sin", "cos", "tan", "atan2", "exp", "sqrt", "fabs"]
)  # of libraries: mathematics; none of them allocates
STRING = frozenset({"memset", "memcpy"})  # what compilers put in place of loops over arrays
FORBIDDEN = re.compile(r"\b(while|do|goto|setjmp|longjmp|malloc|calloc|realloc|free|alloca)\b")
LOOP = re.compile(r"\bfor \(([^;]*); ([^;]*); ([^)]*)\)")
COUNTED = re.compile(r"\w+( \+ 1)? (<|<=|>|>=) [\w +*-]+")  # a count against a bound that the loop does not change


@dataclass(frozen=True)
class Evidence:
    """What was found: `facts` for a program, `text` for a person, `ok` the verdict with its reasons."""

    ok: bool
    reasons: tuple[str, ...]
    facts: Mapping[str, Any]

    @property
    def text(self) -> str:
        """As Markdown."""
        return _markdown(self)


def collect(model: Model, core: str, precision: str, functions: Sequence[str]) -> Evidence:
    """The evidence on functions of a model.

    Args:
        model: whose functions.
        core: a key of CORES, for stack and instructions.
        precision: "single" or "double".
        functions: names of those.

    Raises:
        DescriptionError: no such core or function.
        EmbeddedError: a tool is missing or fails.
    """
    measured = measure(model, core, precision, functions)  # recursion or an unbounded stack is an error there
    missing = [tool for tool in ("cppcheck", "gcc", "gcov", "nm") if shutil.which(tool) is None]
    if missing:
        raise EmbeddedError(f"not found: {', '.join(missing)} (apt install cppcheck gcc binutils)")
    chosen = replace(model, programs={name: model.programs[name] for name in functions})
    real = PRECISIONS[precision]
    with tempfile.TemporaryDirectory(prefix="symscrew_") as temporary:
        folder = Path(temporary)
        for file, text in print_c(chosen, precision=real, batches=False, lanes=False).items():
            (folder / file).write_text(text, encoding="utf-8")
        source = (folder / f"{model.name}.c").read_text(encoding="utf-8")
        facts: dict[str, Any] = {
            "mechanism": model.name,
            "programs": model_hash(chosen),
            "source": hashlib.sha256(source.encode()).hexdigest(),
            "measured": measured,
            "misra": _rules(folder, model.name),
            "loops": _loops(source),
            "calls": _called(folder, model.name),
            "vectors": _vectors(chosen, folder, real),
            "branches": _branches(folder, model.name),
            "tools": {tool: _run([tool, "--version"], folder).splitlines()[0] for tool in ("cppcheck", "gcc", "gcov")},
        }
    reasons = tuple(_faults(facts, source))
    return Evidence(not reasons, reasons, facts)


def _run(command: Sequence[str], folder: Path, data: bytes | None = None) -> str:
    """What a tool says on both of its outputs."""
    try:
        done = subprocess.run(command, cwd=folder, input=data, capture_output=True, check=False, timeout=LIMIT)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise EmbeddedError(f"{command[0]} does not run: {error}") from error
    if done.returncode:
        raise EmbeddedError(f"{command[0]} ended with {done.returncode}: {done.stderr.decode(errors='replace')[-500:]}")
    return (done.stdout + done.stderr).decode("utf-8", "replace")


def _rules(folder: Path, name: str) -> dict[str, int]:
    """Findings by rule of MISRA C:2012."""
    command = ["cppcheck", "--addon=misra", "--std=c99", "--language=c", "--quiet", "--template={id}", f"{name}.c"]
    found = Counter(re.findall(r"^misra-c2012-([\d.]+)$", _run(command, folder), re.MULTILINE))
    return dict(sorted(found.items(), key=lambda item: [int(x) for x in item[0].split(".")]))


def _loops(source: str) -> dict[str, Any]:
    """How many loops, and those whose bound is not seen in their head."""
    heads = [found[0] for found in LOOP.finditer(_code(source))]
    conditions = [LOOP.match(head)[2] for head in heads]  # type: ignore[index]
    parts = [condition.split(" && ")[0] for condition in conditions]
    return {
        "count": len(heads),
        "unbounded": sorted({h for h, p in zip(heads, parts, strict=True) if not COUNTED.fullmatch(p)}),
    }


def _code(source: str) -> str:
    """Without comments, texts and lines of the preprocessor."""
    plain = re.sub(r'/\*.*?\*/|"[^"\n]*"', "", source, flags=re.DOTALL)
    return re.sub(r"^\s*#.*$", "", plain, flags=re.MULTILINE)


def _called(folder: Path, name: str) -> list[str]:
    """Functions of libraries that the compiled code calls."""
    _run(["gcc", "-std=c99", "-O2", "-fno-math-errno", "-c", f"{name}.c", "-o", "calls.o"], folder)
    return sorted(line.split()[-1] for line in _run(["nm", "-u", "calls.o"], folder).splitlines() if line.strip())


def _faults(facts: Mapping[str, Any], source: str) -> list[str]:
    """What speaks against the code."""
    rules = {rule: n for rule, n in facts["misra"].items() if rule not in DEVIATIONS}
    found = [f"MISRA C:2012 rule {rule}: {n} findings without a justification" for rule, n in rules.items()]
    found += [f"a loop without a bound in its head: {head}" for head in facts["loops"]["unbounded"]]
    found += [f"the code has the word {word}" for word in sorted(set(FORBIDDEN.findall(_code(source))))]
    known = {f"{name}{end}" for name in ALLOWED for end in ("", "f")} | {"sincos", "sincosf", *STRING}
    found += [f"the code calls {name}" for name in facts["calls"] if name not in known]
    bad = {name: entry["not_finite"] for name, entry in facts["vectors"].items() if entry["not_finite"]}
    return found + [f"{name}: {n} numbers that are not finite on a status up to 0" for name, n in bad.items()]


def _vectors(model: Model, folder: Path, real: Precision) -> dict[str, Any]:
    """Per function: vectors, statuses that came, numbers that were not finite on success. Writes coverage."""
    names = list(model.programs)
    source = (folder / f"{model.name}.c").read_text(encoding="utf-8")
    (folder / "vectors.c").write_text(_main(model, source, real), encoding="utf-8")
    flags = ["-std=c99", "-O0", "--coverage", f"-D{model.name.upper()}_SCALAR"]
    _run(["gcc", *flags, "vectors.c", "-o", "vectors", "-lm"], folder)
    found = {}
    data, counts = [], []
    for name in names:
        arrays = function_vectors(model, name, real)
        counts.append(len(arrays[0]) if arrays else 1)
        data.append(b"".join(b"".join(x[k].tobytes() for x in arrays) for k in range(counts[-1])))
    head = np.array(counts, np.int32).tobytes()
    rows = _run(["./vectors"], folder, head + b"".join(data)).splitlines()
    for name, count in zip(names, counts, strict=True):
        own, rows = [line.split() for line in rows[:count]], rows[count:]
        seen = Counter(int(status) for status, _ in own)
        wrong = sum(int(bad) for status, bad in own if int(status) <= 0)
        found[name] = {"vectors": count, "statuses": dict(sorted(seen.items())), "not_finite": wrong}
    return found


def _main(model: Model, source: str, real: Precision) -> str:
    """Reads counts and states, prints per state the status and how many results are not finite; calls routines."""
    number, lines = real.real, ["#include <math.h>", "#include <stdio.h>", f'#include "{model.name}.c"', ""]
    body = [f"    int counts[{len(model.programs)}];", "    if (fread(counts, sizeof counts, 1, stdin) != 1) {"]
    body += ["        return 1;", "    }"]
    for f, (name, program) in enumerate(model.programs.items()):
        sizes = [max(port.size, 1) for port in (*program.inputs, *program.outputs)]
        arrays = [f"x{i}[{size}]" for i, size in enumerate(sizes)]
        body += [f"    for (int k = 0; k < counts[{f}]; ++k) {{", f"        static {number} {', '.join(arrays)};"]
        for i, port in enumerate(program.inputs):
            if port.size:
                body += [
                    f"        if (fread(x{i}, sizeof x{i}, 1, stdin) != 1) {{",
                    "            return 1;",
                    "        }",
                ]
        body += [f"        const int status = {model.name}_{name}({', '.join(f'x{i}' for i in range(len(sizes)))});"]
        body += ["        int bad = 0;"]
        for i, port in enumerate(program.outputs, len(program.inputs)):
            if port.size:
                body += [
                    f"        for (int e = 0; e < {port.size}; ++e) {{",
                    f"            bad += !isfinite(x{i}[e]);",
                    "        }",
                ]
        body += ['        printf("%d %d\\n", status, bad);', "    }"]
    texts = [*status_texts(*model.programs.values()), 999]  # one that there is not
    body += [f"    (void){model.name}_status_text({code});" for code in texts]
    body += direct_calls(model, source, real)
    return "\n".join([*lines, "int main(void)", "{", *body, "    return 0;", "}", ""])


def _branches(folder: Path, name: str) -> dict[str, Any]:
    """Lines and branches of the generated source that the vectors took, by gcov."""
    notes = next(path.name for path in folder.iterdir() if path.name.endswith("vectors.gcno"))
    text = _run(["gcov", "-b", "-c", notes], folder)
    own = text[text.index(f"File '{name}.c'") :]
    lines, branches = (
        re.search(rf"{what}:([\d.]+)% of (\d+)", own) for what in ("Lines executed", "Taken at least once")
    )
    missed, line = [], ""
    for row in (folder / f"{name}.c.gcov").read_text(encoding="utf-8", errors="replace").splitlines():
        if re.match(r"branch +\d+ (never executed|taken 0\b)", row):
            missed.append(line)
        elif not row.startswith(("branch", "call", "function", "unconditional")):
            line = row.split(":", 2)[-1].strip()[:100]
    return {
        "lines": float(lines[1]) if lines else 100.0,
        "branches": float(branches[1]) if branches else 100.0,
        "of": int(branches[2]) if branches else 0,
        "missed": sorted(set(missed)),
    }


HEAD = "| function | flash [B] | frame [B] | instructions | vectors | statuses (times) | not finite on success |"
ABOUT = """\
`frame`: the most stack that the code can take, by the compiler's graph of calls, which has no recursion.
`instructions`: the largest of the states that were run, library included; not a bound, and not cycles.
"""


def _markdown(evidence: Evidence) -> str:
    """The file for a person."""
    facts, measured = evidence.facts, evidence.facts["measured"]
    verdict, precision = "ok" if evidence.ok else "not ok", measured["precision"]
    lines = [f"# Evidence on generated C: {facts['mechanism']}", "", f"Verdict: **{verdict}**.", ""]
    lines += [*(f"- {reason}" for reason in evidence.reasons), *([""] if evidence.reasons else [])]
    lines += [f"Programs {facts['programs']}, SHA-256 of the source {facts['source']}, {precision} precision."]
    lines += [f"Cross-compiled with {measured['compiler']}; counted by {measured['counted_by']}."]
    lines += [f"On this machine: {'; '.join(facts['tools'].values())}.", "", "## Functions", ""]
    lines += [*ABOUT.splitlines(), "", HEAD, "|---|---|---|---|---|---|---|"]
    for name, entry in facts["vectors"].items():
        row = measured["functions"][name]
        seen = ", ".join(f"{status} ({times})" for status, times in entry["statuses"].items())
        cells = [f"`{name}`", *(row[k] for k in ("flash", "frame", "instructions"))]
        lines.append(f"| {' | '.join(map(str, [*cells, entry['vectors'], seen, entry['not_finite']]))} |")
    loops, calls = facts["loops"]["count"], ", ".join(facts["calls"]) or "none"
    lines += ["", "## Structure", "", f"{loops} loops, counted against a bound in their head, unless listed above."]
    lines += [f"Functions of libraries that are called: {calls}; none allocates.", ""]
    lines += ["## MISRA C:2012, by cppcheck's addon", ""]
    lines += ["| rule | category | findings | justification |", "|---|---|---|---|"]
    for rule, count in facts["misra"].items():
        category, why = DEVIATIONS.get(rule, ("?", "**open**"))
        lines.append(f"| {rule} | {category} | {count} | {why} |")
    lines += ["", "The addon does not check every rule; this list is no statement of compliance.", ""]
    branches = facts["branches"]
    told = f"Lines {branches['lines']} %, branches {branches['branches']} % of {branches['of']}. Not taken:"
    return "\n".join(
        [*lines, "## Coverage, by gcov", "", told, "", *(f"- `{line}`" for line in branches["missed"]), ""]
    )
