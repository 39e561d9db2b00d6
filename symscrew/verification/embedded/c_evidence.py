"""Evidence for an assessor: what was checked of generated C, how, with what, and what was found, as one file.

    C of the functions --cppcheck, MISRA C:2012--> rules, each with its justification or open
                       --its text, the compiler's graph of calls--> loops, recursion, heap, worst stack
                       --emulator--> instructions, cycles at most
                       --vectors, gcov--> statuses, numbers on success and on failure, branches

`ok` is the verdict: no open rule, no allocation, no unbounded loop, no number that is not finite on a status up to 0,
no number on another status, every branch taken. A check that no input violates is taken by a forced value, and listed.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import tempfile
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from symscrew.export import PRECISIONS, model_hash, print_c
from symscrew.model import Model
from symscrew.verification.embedded.branch_coverage import covered, said
from symscrew.verification.embedded.core_cycles import worst_cycles
from symscrew.verification.embedded.emulation import EmbeddedError, measure

# Deviations: rule -> category, and why the code deviates.
DEVIATIONS: Mapping[str, tuple[str, str]] = {
    "2.3": (
        "advisory",
        "the header's type of run-time parameters is for users; the code takes their array",
    ),
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
    "19.2": (
        "advisory",
        "run-time parameters by name and as an array are numbers of one type at the same places",
    ),
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
        coverage = covered(chosen, folder, real)
        facts: dict[str, Any] = {
            "mechanism": model.name,
            "programs": model_hash(chosen),
            "source": hashlib.sha256(source.encode()).hexdigest(),
            "measured": measured,
            "cycles": worst_cycles(model, core, precision, functions),
            "misra": _rules(folder, model.name),
            "loops": _loops(source),
            "calls": _called(folder, model.name),
            "vectors": coverage.runs,
            "branches": coverage.facts,
            "tools": {tool: said([tool, "--version"], folder).splitlines()[0] for tool in ("cppcheck", "gcc", "gcov")},
        }
    reasons = tuple(_faults(facts, source))
    return Evidence(not reasons, reasons, facts)


def _rules(folder: Path, name: str) -> dict[str, int]:
    """Findings by rule of MISRA C:2012."""
    command = ["cppcheck", "--addon=misra", "--std=c99", "--language=c", "--quiet", "--template={id}", f"{name}.c"]
    found = Counter(re.findall(r"^misra-c2012-([\d.]+)$", said(command, folder), re.MULTILINE))
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
    said(["gcc", "-std=c99", "-O2", "-fno-math-errno", "-c", f"{name}.c", "-o", "calls.o"], folder)
    return sorted(line.split()[-1] for line in said(["nm", "-u", "calls.o"], folder).splitlines() if line.strip())


def _faults(facts: Mapping[str, Any], source: str) -> list[str]:
    """What speaks against the code."""
    rules = {rule: n for rule, n in facts["misra"].items() if rule not in DEVIATIONS}
    found = [f"MISRA C:2012 rule {rule}: {n} findings without a justification" for rule, n in rules.items()]
    found += [f"a loop without a bound in its head: {head}" for head in facts["loops"]["unbounded"]]
    found += [f"the code has the word {word}" for word in sorted(set(FORBIDDEN.findall(_code(source))))]
    known = {f"{name}{end}" for name in ALLOWED for end in ("", "f")} | {"sincos", "sincosf", *STRING}
    found += [f"the code calls {name}" for name in facts["calls"] if name not in known]
    for name, entry in facts["vectors"].items():
        for part, how in ((entry, ""), (entry["forced"], ", with a check forced")):
            if part["not_finite"]:
                found.append(f"{name}: {part['not_finite']} numbers that are not finite on a status up to 0{how}")
            if part["given_on_failure"]:
                found.append(f"{name}: {part['given_on_failure']} numbers given on a status above 0{how}")
    never = [entry for entry in facts["branches"]["untaken"] if entry["how"] == "nothing"]
    return found + [f"{entry['function']}: a branch that nothing takes: {entry['line']}" for entry in never]


HEAD = "| function | flash [B] | frame [B] | instructions | vectors | statuses (times) | not finite on success |"
ABOUT = """\
`frame`: the most stack that the code can take, by the compiler's graph of calls, which has no recursion.
`instructions`: the largest of two ordinary states, library included.
"""
CYCLES = """\
Every instruction that the emulator executes, at the most that it takes by the manual of the core (Arm DDI 0439): no
wait states of the memory, no interrupts. The dearest call of states of every status, second paths included; of an
iteration the most steps that it can make, each the dearest that was seen.
"""
NO_CYCLES = "Arm publishes no cycles of this core's instructions: none are counted."


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
    lines += ["", "## Cycles, at most", ""]
    lines += [*CYCLES.splitlines(), "", "| function | cycles |", "|---|---|"] if facts["cycles"] else [NO_CYCLES]
    for name, entry in facts["cycles"].items():
        more = f": {entry['steps']} steps at most, {entry['step']} each" if "step" in entry else ""
        lines.append(f"| `{name}` | {entry['cycles']}{more} |")
    loops, calls = facts["loops"]["count"], ", ".join(facts["calls"]) or "none"
    lines += ["", "## Structure", "", f"{loops} loops, counted against a bound in their head, unless listed above."]
    lines += [f"Functions of libraries that are called: {calls}; none allocates.", ""]
    lines += ["## MISRA C:2012, by cppcheck's addon", ""]
    lines += ["| rule | category | findings | justification |", "|---|---|---|---|"]
    for rule, count in facts["misra"].items():
        category, why = DEVIATIONS.get(rule, ("?", "**open**"))
        lines.append(f"| {rule} | {category} | {count} | {why} |")
    lines += ["", "The addon does not check every rule; this list is no statement of compliance.", ""]
    return "\n".join([*lines, *_coverage(facts["branches"], facts["vectors"]), ""])


COVERAGE = """\
Counted on a copy of the source in which every check is a statement of its own and asks a function for the value that it
compares. Without an argument that function hands the value on; `forced` are calls in which one check, of the first six
hundred of a call, meets 0, -1e30, 1e30 or no number instead, those behind it what they would, or one of these, too.
A branch that only forced values take belongs to a check that no input was found to violate, neither at random nor by a
search along changes of sign, and where there is none for the smallest value: it stays as a defence. `least` is the
smallest size of a pivot that was found where the checks before it say yes, `limit` where this one says no.
"""


def _coverage(branches: Mapping[str, Any], runs: Mapping[str, Any]) -> list[str]:
    """What was taken, and what only by force."""
    of, known = branches["of"], branches["of"] - branches["nothing"]
    lines = ["## Coverage, by gcov", "", *COVERAGE.splitlines(), ""]
    lines += [f"Lines {branches['lines']} %, branches {100.0 * known / max(1, of):.6g} % of {of}:"]
    lines += [
        f"{branches['by_inputs']} taken by inputs, {branches['forced']} only by forced values, {branches['decided']}"
    ]
    lines += [f"that the same choice around them has decided, {branches['nothing']} by nothing.", ""]
    lines += ["| function | forced | statuses (times) | not finite on success | numbers on failure |"]
    lines += ["|---|---|---|---|---|"]
    for name, entry in runs.items():
        forced = entry["forced"]
        seen = ", ".join(f"{status} ({times})" for status, times in forced["statuses"].items())
        bad, given = (entry[k] + forced[k] for k in ("not_finite", "given_on_failure"))
        lines.append(f"| `{name}` | {forced['runs']} | {seen} | {bad} | {given} |")
    if branches["untaken"]:
        lines += ["", "| not by inputs, in | condition | what it guards | taken | least | limit |"]
        lines += ["|---|---|---|---|---|---|"]
    for entry in branches["untaken"]:
        sizes = [f"{entry[k]:.3g}" if entry[k] is not None else "" for k in ("least", "limit")]
        condition = entry["line"].replace("|", "\\|")
        cells = [f"`{entry['function']}`", f"`{condition}`", entry["meaning"], entry["how"], *sizes]
        lines.append(f"| {' | '.join(cells)} |")
    return lines
