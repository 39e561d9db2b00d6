"""C that proves that a configuration continues the mode of another one: the closure on balls, and the test around it.

    closure of a model --rows that determine it--> F(q) --differentiated--> its slopes
                       both as C on balls (middle, radius), then mode_certificate.c: `mode_certified(from, to)`

A part for files of other targets: everything is `static`, its names begin with `certificate_` or `ball_`, and it needs
<math.h>. The rows are as many as the coordinates that follow, independent at the reference; of an overconstrained
mechanism the others are left out, so that what is proved of it is that its mode is the only one, not that it closes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import resources

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.export.listing import decimal, wrapped
from symscrew.model import Model
from symscrew.program import Port, Program, evaluate, jacobian

NEAR = 1e-9  # without units: what is assembled is within 1e-12; the box of a step must be wider, and steps are 1e-3
ROUNDING = 2.0**-52  # twice the largest relative error of an operation that is rounded to nearest
LIBRARY = 2e-15  # sines of glibc, newlib and musl are within 1e-16 times 1 to 2: nine units in the last place of 1
SLACK = 1.000001  # of radii; see the text in C
INDEPENDENT = 1e-8  # part of a row, relative, that the rows before it leave of one that follows from them: rounding

BALL = "typedef struct { double m, r; } Ball; /* the numbers within r of m */"
OPERATIONS = {  # operation -> those that it calls, arguments, body
    "add": ((), "Ball a, Ball b", """\
    const double m = a.m + b.m;
    return (Ball){m, a.r + b.r + CERTIFICATE_ROUNDING * fabs(m)};"""),
    "sub": ((), "Ball a, Ball b", """\
    const double m = a.m - b.m;
    return (Ball){m, a.r + b.r + CERTIFICATE_ROUNDING * fabs(m)};"""),
    "mul": ((), "Ball a, Ball b", """\
    const double m = a.m * b.m; /* what an underflow loses is less than 1e-300 */
    return (Ball){m, fabs(a.m) * b.r + a.r * (fabs(b.m) + b.r) + CERTIFICATE_ROUNDING * fabs(m) + 1e-300};"""),
    "neg": ((), "Ball a", "    return (Ball){-a.m, a.r};"),
    "reciprocal": ((), "Ball a", """\
    const double m = 1.0 / a.m, size = fabs(a.m); /* nothing is known of what changes by half of itself */
    return (Ball){m, a.r <= 0.5 * size ? a.r / (size * (size - a.r)) + CERTIFICATE_ROUNDING * fabs(m) : HUGE_VAL};"""),
    "div": (("mul", "reciprocal"), "Ball a, Ball b", "    return ball_mul(a, ball_reciprocal(b));"),
    "sqrt": ((), "Ball a", """\
    const double m = sqrt(a.m);
    return (Ball){m, a.r <= 0.5 * a.m ? a.r / (m + sqrt(a.m - a.r)) + CERTIFICATE_ROUNDING * m : HUGE_VAL};"""),
    "exp": ((), "Ball a", """\
    const double m = exp(a.m); /* e^r - 1 <= r + r^2 up to 1 */
    return (Ball){m, a.r <= 1.0 ? m * (a.r + a.r * a.r + 2.0 * CERTIFICATE_LIBRARY) : HUGE_VAL};"""),
    "sin": ((), "Ball a", """\
    return (Ball){sin(a.m), fabs(cos(a.m)) * a.r + 0.5 * a.r * a.r + CERTIFICATE_LIBRARY * (1.0 + a.r)};"""),
    "cos": ((), "Ball a", """\
    return (Ball){cos(a.m), fabs(sin(a.m)) * a.r + 0.5 * a.r * a.r + CERTIFICATE_LIBRARY * (1.0 + a.r)};"""),
    "tan": (("sin", "cos", "div"), "Ball a", "    return ball_div(ball_sin(a), ball_cos(a));"),
    "atan2": ((), "Ball y, Ball x", """\
    const double m = atan2(y.m, x.m), away = sqrt(x.m * x.m + y.m * y.m), off = x.r + y.r;
    const int cut = x.m <= x.r && fabs(y.m) <= y.r; /* the angle jumps there; arc sine of t is below 1.05 t up to 0.5 */
    return (Ball){m, off <= 0.5 * away && cut == 0 ? 1.05 * off / away + 4.0 * CERTIFICATE_LIBRARY : HUGE_VAL};"""),
    "abs": ((), "Ball a", "    return (Ball){fabs(a.m), a.r};"),
    "less": (("sub",), "Ball a, Ball b", """\
    const Ball d = ball_sub(b, a);
    return d.m > d.r ? (Ball){1.0, 0.0} : d.m < -d.r ? (Ball){0.0, 0.0} : (Ball){0.5, 0.5};"""),
    "select": ((), "Ball c, Ball a, Ball b", """\
    const double m = 0.5 * (a.m + b.m), r = 0.5 * fabs(a.m - b.m) + a.r + b.r; /* either of them */
    const Ball both = {m, r + CERTIFICATE_ROUNDING * (fabs(a.m) + fabs(b.m))};
    return fabs(c.m) > c.r ? a : c.m == 0.0 && c.r == 0.0 ? b : both;"""),
}  # fmt: skip


@dataclass(frozen=True)
class ModeCertificate:
    """The closure as the proof reads it.

    Attributes:
        openings: (q, p) -> the rows that are used.
        slopes: (q, p) -> their slopes by entries of q that are not zero.
        places: (row, entry of q) of every slope.
        free: entries of q that are given.
        dependent: the other ones.
        units: of those, what is 1 without units.
        turns: first entries of quaternions, each one a further row.
        parameters: values of the run-time parameters.
    """

    openings: Program
    slopes: Program
    places: tuple[tuple[int, int], ...]
    free: tuple[int, ...]
    dependent: tuple[int, ...]
    units: tuple[float, ...]
    turns: tuple[int, ...]
    parameters: tuple[float, ...]


def find_mode_certificate(model: Model, free: Sequence[int]) -> ModeCertificate:
    """What is proved with, for a model with loops whose coordinates follow from the entries `free` of q.

    Raises:
        DescriptionError: at the reference they do not follow: the closure loses rank there.
    """
    system = model.system
    closure = model.programs["closure"]
    assert isinstance(closure, Program)
    turns = tuple(link.q.start for link in system.tree.links[1:] if link.motion.spherical)
    length = float(system.length)
    sized = [length if x.unit == "m" else 1.0 for x in system.tree.q]
    dependent = tuple(k for k in range(len(sized)) if k not in free)
    candidates = [k for k, r in enumerate(closure.results[0]) if isinstance(r, int)]
    rows = _independent(closure, candidates, model, dependent=dependent, turns=turns)
    if len(rows) + len(turns) != len(dependent):
        raise DescriptionError(
            f"{model.name}: expected drives from which all of its coordinates follow at the reference, "
            f"its loops have {len(rows) + len(turns)} conditions for {len(dependent)}"
        )
    openings, slopes, places = _with_slopes(closure, rows)
    return ModeCertificate(
        openings, slopes, places, tuple(free), dependent, tuple(sized[k] for k in dependent), turns,
        tuple(float(x) for x in system.parameter_values),
    )  # fmt: skip


def _part(program: Program, rows: Sequence[int], name: str) -> Program:
    """The function of some entries of the first output, without conditions."""
    port = program.outputs[0]
    own = Port(
        port.name, (len(rows),), tuple(port.units[k] for k in rows), tuple(port.labels[k] for k in rows),
        port.description,
    )  # fmt: skip
    results = (tuple(program.results[0][k] for k in rows),)
    return replace(program, name=name, outputs=(own,), results=results, guards=(), limits=(), reach=())


def _with_slopes(closure: Program, rows: Sequence[int]) -> tuple[Program, Program, tuple[tuple[int, int], ...]]:
    """Openings, their slopes by q, and the places of these."""
    openings = _part(closure, rows, "certificate_openings")
    every = jacobian(openings)
    name = next(name for name, (_, given, _, _) in every.blocks.items() if given == 0)
    at = [port.name for port in every.program.outputs].index(name)
    slopes = replace(
        every.program, name="certificate_slopes", outputs=every.program.outputs[at : at + 1],
        results=every.program.results[at : at + 1], guards=(), limits=(), reach=(),
    )  # fmt: skip
    _, _, places, columns = every.blocks[name]
    return openings, slopes, tuple(zip(places, columns, strict=True))


def _independent(
    closure: Program, rows: Sequence[int], model: Model, *, dependent: Sequence[int], turns: Sequence[int]
) -> list[int]:
    """The first rows that are independent of those before them and of the lengths of quaternions."""
    system = model.system
    _, slopes, places = _with_slopes(closure, rows)
    q = np.array(system.reference, dtype=float)
    given = [q[None], *([np.array(system.parameter_values)[None]] if len(closure.inputs) > 1 else [])]
    dense = np.zeros((len(rows), len(q)))
    (values,), _ = evaluate(slopes, given)
    for (row, column), value in zip(places, values[0], strict=True):
        dense[row, column] = value
    lengths = np.zeros((len(turns), len(q)))
    for k, start in enumerate(turns):
        lengths[k, start : start + 4] = q[start : start + 4]
    basis: list[np.ndarray] = []
    found = []
    every: list[tuple[int, np.ndarray]] = [*((-1, x) for x in lengths), *zip(rows, dense, strict=True)]
    for k, entries in every:
        part = entries[list(dependent)]
        left = part
        for b in (*basis, *basis):  # twice, for rounding
            left = left - b * (b @ left)
        if np.linalg.norm(left) > INDEPENDENT * np.linalg.norm(part):
            basis.append(left / np.linalg.norm(left))
            found += [k] if k >= 0 else []
    return found


def certificate_part(certificate: ModeCertificate) -> list[str]:
    """Lines of C: constants, balls, the closure and its slopes, `mode_certified`."""
    sizes = {
        "CERTIFICATE_Q": certificate.openings.inputs[0].size,
        "CERTIFICATE_N": len(certificate.dependent),
        "CERTIFICATE_FREE": len(certificate.free),
        "CERTIFICATE_TURNS": len(certificate.turns),
        "CERTIFICATE_SLOPES": len(certificate.places),
    }
    numbers = {"NEAR": NEAR, "ROUNDING": ROUNDING, "LIBRARY": LIBRARY, "SLACK": SLACK}
    lines = [f"#define {name} {size}" for name, size in sizes.items()]
    lines += [f"#define CERTIFICATE_{name} {decimal(value)}" for name, value in numbers.items()]
    lines += [
        *_table("int", "free", certificate.free),
        *_table("int", "dependent", certificate.dependent),
        *_table("double", "unit", certificate.units),
        *_table("int", "turn", certificate.turns),
        *_table("int", "row", [row for row, _ in certificate.places]),
        *_table("int", "column", [column for _, column in certificate.places]),
        "",
        BALL,
    ]
    programs = (certificate.openings, certificate.slopes)
    used = {i.op for program in programs for i in program.live[0]}
    while True:
        further = used.union(*(OPERATIONS[op][0] for op in used))
        if further == used:
            break
        used = further
    for op, (_, arguments, body) in OPERATIONS.items():
        if op in used:
            lines += ["", f"static inline Ball ball_{op}({arguments})", "{", *body.splitlines(), "}"]
    for program in programs:
        lines += ["", *_function(program, certificate.parameters)]
    text = resources.files("symscrew.export").joinpath("mode_certificate.c").read_text("utf-8")
    return [*lines, "", *text.splitlines()]


def _table(kind: str, name: str, values: Sequence[float]) -> list[str]:
    """A constant array; one without entries has one that nobody reads."""
    texts = [str(x) if kind == "int" else decimal(float(x)).strip("()") for x in values] or ["0"]
    text = f"static const {kind} certificate_{name}[{len(texts)}] = {{{', '.join(texts)}}};"
    return wrapped(text, later="    ", width=110)


def _function(program: Program, parameters: Sequence[float]) -> list[str]:
    """A program on balls: run-time parameters have their values."""
    names = [f"q[{k}]" for k in range(program.inputs[0].size)]
    given = dict(enumerate([*names, *(f"(Ball){{{decimal(x)}, 0.0}}" for x in parameters)]))

    def operand(value: int | float) -> str:
        if isinstance(value, int):
            return given.get(value, f"x{value}")
        exact = float(value).is_integer()
        return f"(Ball){{{decimal(value)}, {'0.0' if exact else decimal(abs(value) * ROUNDING)}}}"

    lines = [f"static void {program.name}(const Ball *q, Ball *made)", "{"]
    needed = {r for r in program.results[0] if isinstance(r, int)}
    kept = []
    for target, op, args in reversed(program.instructions):
        if target in needed:
            kept.append(f"    const Ball x{target} = ball_{op}({', '.join(operand(a) for a in args)});")
            needed |= {a for a in args if isinstance(a, int)}
    lines += kept[::-1] or ["    (void)q;"]
    lines += [f"    made[{k}] = {operand(slot)};" for k, slot in enumerate(program.results[0])]
    return [*lines, "}"]
