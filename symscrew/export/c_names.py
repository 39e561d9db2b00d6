"""Names, arguments and declarations in C.

Port("count", ...) --> const double *restrict count_     (what the code itself calls `count` keeps its name)
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symscrew.export.c_precision import Precision
from symscrew.export.listing import code_lines, wrapped
from symscrew.program import Iteration, Port, Program

# what an argument must not be called: names of math.h and the like, and of local variables of the printed functions
NAMES_OF_MATH = "sin cos tan sqrt exp atan2 fabs isfinite NAN NULL INFINITY HUGE_VAL size_t M_PI M_E I errno assert"
NAMES_OF_MATH += " sinf cosf tanf sqrtf expf atan2f fabsf"
NAMES_OF_LOCALS = "count status k worst outcome total next residual change orientation start substeps most"
NAMES_OF_LOCALS += " rate_scale row_scale inertia load closure curvature turn known work multipliers rank sized shifted"
NAMES_OF_LOCALS += " loads columns mix amount internal moved part factor largest i j"
NAMES_OF_LOCALS += " angle sine cosine pivot stride pitch lane index first some block blocks number"
NAMES_OF_LOCALS += " checked0 checked1 checked2 checked3 result_ in out read written work place together there"
NAMES_OF_LOCALS += " size sized outcome function inputs outputs called batched"
NAMES_OF_LOCALS += " every fours sum sum0 sum1 sum2 sum3 waiting at constant"
TOGETHER = 111  # characters of a line of several declarations, its indentation and the comma behind it not counted
TAKEN = frozenset(f"{NAMES_OF_MATH} {NAMES_OF_LOCALS}".split())


def argument_names(ports: Sequence[Port]) -> list[str]:
    """The ports' names as C arguments: those that the code needs itself get an underscore."""
    return [port.name + "_" if port.name in TAKEN else port.name for port in ports]


def arguments(program: Program | Iteration, precision: Precision, restrict: str = "restrict") -> list[str]:
    """The declared arguments of a function: its inputs and outputs."""
    names = argument_names((*program.inputs, *program.outputs))
    read = len(program.inputs)
    real = precision.real
    return [
        f"{'const ' if i < read else ''}{real} *{f'{restrict} ' if restrict else ''}{name}"
        for i, name in enumerate(names)
    ]


def declare(symbol: str, given: Sequence[str], prefix: str = "int ", *, width: int = 110) -> str:
    """A declaration, over as many lines as its arguments take; none is broken."""
    lines = [f"{prefix}{symbol}("]
    for k, argument in enumerate(given or ["void"]):
        text = f"{argument}{',' if k + 1 < len(given) else ')'}"
        space = " " if k else ""
        if k and len(lines[-1]) + len(space) + len(text) > width:
            lines.append(f"    {text}")
        else:
            lines[-1] += space + text
    return "\n".join(lines)


def grouped(statements: Iterable[str]) -> list[str]:
    """Statements with declarations of one type that follow each other as one, as many of them on a line as fit.

    >>> grouped(["const REAL a = READ(v, 0);", "const REAL b = 2.0 * a; /* base */", "const REAL c = a * b;", "f(c);"])
    ['const REAL a = READ(v, 0), b = 2.0 * a, /* base */', '  c = a * b;', 'f(c);']
    """
    found: list[str] = []
    before = ""  # the type of the last statement, if it is a declaration, which is still without its end
    said = ""  # behind its last line
    for text in statements:
        code, mark, comment = text.partition("; /*")
        kind, _, declared = code.removesuffix(";").removeprefix("const ").partition(" ")
        if not code.startswith("const "):
            kind = ""
        if kind != before and before:
            found[-1] += f";{said}"
        if not kind:
            found.append(text)
        elif kind != before:
            found.append(f"const {kind} {declared}")
        elif not said and len(found[-1]) + len(declared) + len(comment) + 6 * bool(mark) < TOGETHER:
            found[-1] += f", {declared}"
        else:
            found[-1] += f",{said}"
            found.append(f"  {declared}")
        before, said = kind, f" /*{comment}" if mark and kind else ""
    if before:
        found[-1] += f";{said}"
    return found


def c_lines(statements: Iterable[str]) -> list[str]:
    """Statements of a body, the long ones over several lines, with what is said of them behind the last one."""
    return [line for text in statements for line in code_lines(text, comment="/*", first="    ")]


def wrapped_code(statement: str, indent: str = "    ") -> list[str]:
    """A long statement over several lines, broken at blanks."""
    return wrapped(statement, first=indent, later=indent + "    ", width=110)


def over_lines(macro: str, given: Sequence[str]) -> list[str]:
    """A macro with its arguments, as many on a line as fit."""
    return [part for line in declare(macro, given, "").split("\n") for part in wrapped_code(line, "")]
