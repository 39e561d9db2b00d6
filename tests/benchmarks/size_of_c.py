"""What the C of a mechanism consists of, and what compiling it takes with and without some of GCC's passes.

    every character is of one kind: name, comment, blank ...;   values by how often they are read

Beside it what shorter text would come to: the least of each is a bound, as nobody would want to read all of them at
once. Seconds are processor time of the compiler, the variants in turns, the least of the repeats.
"""

from __future__ import annotations

import re
import resource
import subprocess
import tempfile
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from symscrew import catalogue
from symscrew.export import print_c
from symscrew.model import derive

from .tables import table

WORDS = "const|REAL|double|static|return|if|else|for|size_t|void|restrict|int|READ|SINES|WRITE"
KINDS = {
    "comments": r"/\*.*?\*/",
    "texts": r'"(?:[^"\\]|\\.)*"',
    "indentation": r"^[ \t]+",
    "t1, t2, ...": r"\bt\d+\b",
    "words of C and macros": rf"\b(?:{WORDS})\b",
    "names": r"[A-Za-z_]\w*",
    "numbers": r"\.?\d[\w.]*",
    "ends of lines": r"\n",
    "blanks": r"[ \t]+",
    "operators and marks": r".",
}
SEED = "three_ups_upu_s"
TOKEN = re.compile("|".join(f"(?P<k{k}>{pattern})" for k, pattern in enumerate(KINDS.values())), re.S | re.M)
DECLARED = re.compile(r"(?:const \w+|,)\s+(\w+) = ")
OPERATION = re.compile(r" [-+*/] ")
WITHOUT = ("schedule-insns2", "gcse", "tree-pre", "tree-vrp", "cse-follow-jumps", "rerun-cse-after-loop")
VARIANTS = {
    "-O2": ("-O2",),
    f"-O2 without {', '.join(WITHOUT)}": ("-O2", *(f"-fno-{name}" for name in WITHOUT)),
    "-O1": ("-O1",),
}


def run(*, repeats: int = 3) -> tuple[str, dict[str, Any]]:
    """Markdown and raw numbers."""
    model = derive(catalogue.load(SEED))
    files = print_c(model, several=True)
    text = "".join(files.values())
    kinds = Counter[str]()
    for found in TOKEN.finditer(text):
        kinds[list(KINDS)[int((found.lastgroup or "k0")[1:])]] += len(found[0])
    reads, once, operations = _values(files)
    shorter = _shorter(text, once)
    with tempfile.TemporaryDirectory(prefix="benchmark_") as name:
        seconds = _compiled(files, Path(name), repeats)
    parts = [
        f"{SEED}: {len(text)} bytes, {text.count(chr(10))} lines, {operations} operations, {reads.total()} values.",
        table(["kind", "bytes"], [[kind, str(count)] for kind, count in kinds.most_common()]),
        table(["values that are read", "number"], [[str(n), str(reads[n])] for n in sorted(reads)]),
        table(["shorter by", "bytes"], [[what, str(count)] for what, count in shorter.items()]),
        table(["compiled", "s of the processor"], [[what, f"{least:.2f}"] for what, least in seconds.items()]),
    ]
    raw = {"kinds": kinds, "reads": reads, "operations": operations, "shorter": shorter, "seconds": seconds}
    return "\n\n".join(parts), raw


def _values(files: Mapping[str, str]) -> tuple[Counter[int], list[str], int]:
    """How often values are read, at most 6; names of those that are read once; operations between values."""
    reads, once, operations = Counter[int](), list[str](), 0
    for text in (text for name, text in files.items() if name.endswith(".c")):  # constants stand in headers
        for function in re.split(r"^\}", re.sub(KINDS["comments"], "", text, flags=re.S), flags=re.M):
            words = Counter(re.findall(r"[A-Za-z_]\w*", function))
            for name in DECLARED.findall(function):
                reads[min(words[name] - 1, 6)] += 1
                once += [name] * (words[name] == 2)
            operations += len(OPERATION.findall(function))
    return reads, once, operations


def _shorter(text: str, once: Sequence[str]) -> dict[str, int]:
    """Bytes that other ways of writing would save, each by itself."""
    half = re.sub(r"^ +", lambda found: " " * (len(found[0]) // 2), text, flags=re.M)
    return {
        "half the indentation": len(text) - len(half),
        "n_ in place of minus_": 4 * len(re.findall(r"\bminus_", text)),
        "values that are read once written into their readers": sum(2 * len(name) + len(",  = ") for name in once),
        "no comments": sum(map(len, re.findall(KINDS["comments"], text, re.S))),
    }


def _compiled(files: Mapping[str, str], folder: Path, repeats: int) -> dict[str, float]:
    """Seconds that all files take together."""
    for name, text in files.items():
        (folder / name).write_text(text)
    sources = sorted(str(folder / name) for name in files if name.endswith(".c"))
    found: dict[str, list[float]] = {variant: [] for variant in VARIANTS}
    for _ in range(repeats):
        for variant, flags in VARIANTS.items():
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            for source in sources:
                subprocess.run(["gcc", "-std=c99", *flags, "-c", source, "-o", str(folder / "made.o")], check=True)
            found[variant].append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    return {variant: min(times) for variant, times in found.items()}
