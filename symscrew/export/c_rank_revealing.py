"""C of the second, rank-revealing path of forward dynamics: see `symscrew.program.rank_revealing`.

One routine per model works on arrays whose sizes are known when it is called, from the caller's stack: no
allocation, bounded loops.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from symscrew.export.c_precision import Precision
from symscrew.export.c_printed import Printed
from symscrew.export.listing import filled
from symscrew.program import RANK, RankRevealing

Define = Callable[[str], list[str]]

ROUTINES = """\
/* Makes the columns of a (rows x columns) orthogonal by rotations from the right, collected in v. */
static void MODEL_orthogonalise(int rows, int columns, REAL *a, REAL *v)
{
    REAL total = 0.0@;
    for (int k = 0; k < rows * columns; ++k) {
        total += a[k] * a[k];
    }
    for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < columns; ++i) {
            v[i + j * columns] = i == j ? 1.0@ : 0.0@;
        }
    }
    int turned = 1;
    for (int sweep = 0; sweep < 40 && turned != 0; ++sweep) {
        turned = 0;
        for (int i = 0; i + 1 < columns; ++i) {
            for (int j = i + 1; j < columns; ++j) {
                REAL *x = a + i * rows, *y = a + j * rows;
                REAL xx = 0.0@, yy = 0.0@, xy = 0.0@;
                for (int k = 0; k < rows; ++k) {
                    xx += x[k] * x[k];
                    yy += y[k] * y[k];
                    xy += x[k] * y[k];
                }
                const REAL least = xx < yy ? xx : yy;
                if (least <= LEAST * total || fabs@(xy) <= EQUAL * sqrt@(xx * yy)) {
                    continue;
                }
                turned = 1;
                const REAL ratio = (yy - xx) / (2.0@ * xy);
                const REAL tangent = (ratio < 0.0@ ? -1.0@ : 1.0@) / (fabs@(ratio) + sqrt@(1.0@ + ratio * ratio));
                const REAL cosine = 1.0@ / sqrt@(1.0@ + tangent * tangent), sine = cosine * tangent;
                for (int k = 0; k < rows; ++k) {
                    const REAL old = x[k];
                    x[k] = cosine * old - sine * y[k];
                    y[k] = sine * old + cosine * y[k];
                }
                x = v + i * columns;
                y = v + j * columns;
                for (int k = 0; k < columns; ++k) {
                    const REAL old = x[k];
                    x[k] = cosine * old - sine * y[k];
                    y[k] = sine * old + cosine * y[k];
                }
            }
        }
    }
}

static REAL MODEL_dot(int size, const REAL *x, const REAL *y)
{
    REAL sum = 0.0@;
    for (int k = 0; k < size; ++k) {
        sum += x[k] * y[k];
    }
    return sum;
}

/* Solves a positive definite system in place; 1 if a pivot is lost. */
static int MODEL_cholesky(int size, REAL *matrix, REAL *right)
{
    REAL largest = 0.0@;
    for (int j = 0; j < size; ++j) {
        largest = matrix[j + j * size] > largest ? matrix[j + j * size] : largest;
    }
    for (int j = 0; j < size; ++j) {
        for (int i = j; i < size; ++i) {
            REAL sum = matrix[i + j * size];
            for (int k = 0; k < j; ++k) {
                sum -= matrix[i + k * size] * matrix[j + k * size];
            }
            if (i == j && !(sum > LOST * largest)) {
                return 1;
            }
            matrix[i + j * size] = i == j ? sqrt@(sum) : sum / matrix[j + j * size];
        }
        for (int k = 0; k < j; ++k) {
            right[j] -= matrix[j + k * size] * right[k];
        }
        right[j] /= matrix[j + j * size];
    }
    for (int j = size - 1; j >= 0; --j) {
        for (int i = j + 1; i < size; ++i) {
            right[j] -= matrix[i + j * size] * right[i];
        }
        right[j] /= matrix[j + j * size];
    }
    return 0;
}

/* Accelerations a and multipliers from mass a = force + jacobian^T multipliers, jacobian a + bias = 0, all
   without units; v takes the null space. Returns the rank of the jacobian, or -1 if no acceleration is unique. */
static int MODEL_constrained(int n, int m, const REAL *mass, const REAL *force, REAL *jacobian,
                             const REAL *bias, REAL *v, REAL *work, REAL *a, REAL *multipliers)
{
    REAL *sizes = work, *reduced = work + n, *right = reduced + n * n, *moved = right + n;
    REAL largest = 1.0@; /* unit screws: one is their size */
    int rank = 0, free_count = 0;
    MODEL_orthogonalise(m, n, jacobian, v);
    for (int j = 0; j < n; ++j) {
        sizes[j] = MODEL_dot(m, jacobian + j * m, jacobian + j * m);
        largest = sizes[j] > largest ? sizes[j] : largest;
        a[j] = 0.0@;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > RANK * RANK * largest) {
            const REAL part = MODEL_dot(m, jacobian + j * m, bias) / sizes[j];
            for (int k = 0; k < n; ++k) {
                a[k] -= part * v[k + j * n];
            }
            ++rank;
        } else {
            sizes[j] = 0.0@;
        }
    }
    const int count = n - rank;
    for (int k = 0; k < n; ++k) {
        moved[k] = force[k] - MODEL_dot(n, mass + k * n, a);
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0@) {
            continue;
        }
        int other = 0;
        for (int i = 0; i < n; ++i) {
            if (sizes[i] > 0.0@) {
                continue;
            }
            REAL sum = 0.0@;
            for (int k = 0; k < n; ++k) {
                sum += v[k + i * n] * MODEL_dot(n, mass + k * n, v + j * n);
            }
            reduced[other + free_count * count] = sum;
            ++other;
        }
        right[free_count] = MODEL_dot(n, v + j * n, moved);
        ++free_count;
    }
    if (MODEL_cholesky(count, reduced, right) != 0) {
        return -1;
    }
    free_count = 0;
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0@) {
            continue;
        }
        for (int k = 0; k < n; ++k) {
            a[k] += right[free_count] * v[k + j * n];
        }
        ++free_count;
    }
    for (int k = 0; k < n; ++k) {
        moved[k] = MODEL_dot(n, mass + k * n, a) - force[k];
    }
    for (int i = 0; i < m; ++i) {
        multipliers[i] = 0.0@;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0@) {
            const REAL part = MODEL_dot(n, v + j * n, moved) / sizes[j];
            for (int i = 0; i < m; ++i) {
                multipliers[i] += part * jacobian[i + j * m];
            }
        }
    }
    return rank;
}
"""

INTERNAL = """\
/* A unit vector of multipliers that is in equilibrium by itself: orthogonal to the columns of the jacobian that
   count and to the `found` earlier ones. */
static void MODEL_internal_load(int n, int m, const REAL *jacobian, int found, REAL *loads)
{
    REAL *load = loads + found * m, best = -1.0@, largest = 1.0@;
    for (int j = 0; j < n; ++j) {
        const REAL size = MODEL_dot(m, jacobian + j * m, jacobian + j * m);
        largest = size > largest ? size : largest;
    }
    for (int pick = 0, chosen = -1; pick <= m; ++pick) {
        const int start = pick < m ? pick : chosen;
        for (int i = 0; i < m; ++i) {
            load[i] = i == start ? 1.0@ : 0.0@;
        }
        for (int again = 0; again < 2; ++again) {
            for (int j = 0; j < n + found; ++j) {
                const REAL *column = j < n ? jacobian + j * m : loads + (j - n) * m;
                const REAL size = MODEL_dot(m, column, column);
                if (j >= n || size > RANK * RANK * largest) {
                    const REAL part = MODEL_dot(m, column, load) / size;
                    for (int i = 0; i < m; ++i) {
                        load[i] -= part * column[i];
                    }
                }
            }
        }
        const REAL size = MODEL_dot(m, load, load);
        if (pick < m && size > best) {
            best = size;
            chosen = pick;
        }
    }
    const REAL factor = 1.0@ / sqrt@(MODEL_dot(m, load, load));
    for (int i = 0; i < m; ++i) {
        load[i] *= factor;
    }
}
"""


def routines(model: str, precision: Precision, *, internal: bool) -> list[str]:
    """The routines that all second paths of a model share; `internal` also those of internal loads."""
    text = ROUTINES + ("\n" + INTERNAL if internal else "")
    bounds = {"RANK": RANK, "LEAST": 1e-30, "EQUAL": 1e-15, "LOST": 1e-14}
    words = {word: precision.threshold(bound) for word, bound in bounds.items()}
    return filled(text, words | {"REAL": precision.real, "@": precision.suffix, "MODEL": model})


def second_path(printed: Printed, signature: str, define: Define, dense: str) -> list[str]:
    """The second path of one function: `signature` declares it, `define` prints the programs that it is made of.

    `dense` is the symbol of its dense program: its own, or that of a function before it, which is printed already.
    """
    model, symbol, program, precision = printed.model, printed.symbol, printed.program, printed.precision
    assert isinstance(program, RankRevealing)
    names = printed.handed()
    real = precision.real
    n, m = len(program.rates), len(program.rows)
    inputs, outputs = names[: len(program.inputs)], names[len(program.inputs) :]
    given = "".join(f"{name}, " for name in inputs)
    lines = define(dense) if dense == f"{symbol}_dense" else []
    if program.wrenches:
        lines += ["", *define(f"{symbol}_wrenches")]
    a = outputs[0]
    lines += [
        "",
        signature,
        "{",
        f"    static const {real} rate_scale[{n}] = {{{', '.join(precision.number(x) for x in program.rates)}}};",
        f"    static const {real} row_scale[{m}] = {{{', '.join(precision.number(x) for x in program.rows)}}};",
        f"    {real} inertia[{n * n}], load[{n}], closure[{n * m}], curvature[{m}];",
        f"    {real} turn[{n * n}], work[{n * n + 3 * n}], multipliers[{m}];",
        f"    const int failed = {dense}({given}inertia, load, closure, curvature);",
        f"    for (int j = 0; j < {n}; ++j) {{",
        "        load[j] *= rate_scale[j];",
        f"        for (int i = 0; i < {n}; ++i) {{",
        f"            inertia[i + j * {n}] *= rate_scale[i] * rate_scale[j];",
        "        }",
        f"        for (int i = 0; i < {m}; ++i) {{",
        f"            closure[i + j * {m}] *= row_scale[i] * rate_scale[j];",
        "        }",
        "    }",
        f"    for (int i = 0; i < {m}; ++i) {{",
        "        curvature[i] *= row_scale[i];",
        "    }",
        f"    const int rank = {model}_constrained({n}, {m}, inertia, load, closure, curvature, turn, work, {a}, "
        "multipliers);",
        f"    {real} total = {model}_dot({n}, {a}, {a});",
        f"    for (int j = 0; j < {n}; ++j) {{",
        f"        {a}[j] *= rate_scale[j];",
        "    }",
        *(_with_internal_loads(printed, program, given, outputs) if program.wrenches else []),
        "    if (failed != 0 || rank < 0 || !isfinite(total)) {",
        *(f"        {model}_set_nan({x}, {p.size});" for x, p in zip(outputs, program.outputs, strict=True)),
        "        return failed == 0 && isfinite(total) ? 1 : 2;",
        "    }",
        f"    return rank == {program.regular} ? -1 : -2;",
        "}",
    ]
    return lines


def entries_on_stack(program: RankRevealing) -> int:
    """So many numbers do the arrays of its second path hold, without those of the functions that it calls."""
    n, m = len(program.rates), len(program.rows)
    found = 3 * n * n + 4 * n + n * m + 2 * m
    if program.wrenches:
        size = program.outputs[1].size
        found += 2 * size + 2 * m * m + m * size + 2 * m if program.loads_matter else size
    return found


def _with_internal_loads(printed: Printed, program: RankRevealing, given: str, outputs: Sequence[str]) -> list[str]:
    """Reactions for the multipliers found, plus the internal loads that make their sum of squares smallest."""
    model, symbol, precision = printed.model, printed.symbol, printed.precision
    a, reactions = outputs
    n, m, size = len(program.rates), len(program.rows), program.outputs[1].size
    real, zero = precision.real, precision.number(0.0)
    solved = [
        f"    for (int i = 0; i < {m}; ++i) {{",
        "        multipliers[i] *= row_scale[i];",
        "    }",
        f"    (void){symbol}_wrenches({given}{a}, multipliers, {reactions}, sized);",
    ]
    summed = f"    total += {model}_dot({size}, {reactions}, {reactions});"
    if not program.loads_matter:
        return [f"    {real} sized[{size}];", *solved, summed]
    return [
        f"    {real} sized[{size}], shifted[{size}], loads[{m * m}] = {{{zero}}}, columns[{m * size}] = {{{zero}}};",
        f"    {real} mix[{m * m}] = {{{zero}}}, amount[{m}] = {{{zero}}};",
        *solved,
        f"    const int internal = {m} - (rank > 0 ? rank : 0);",
        "    for (int k = 0; k < internal && rank >= 0; ++k) {",
        f"        {real} moved[{m}];",
        f"        {model}_internal_load({n}, {m}, closure, k, loads);",
        f"        for (int i = 0; i < {m}; ++i) {{",
        f"            moved[i] = multipliers[i] + row_scale[i] * loads[i + k * {m}];",
        "        }",
        f"        (void){symbol}_wrenches({given}{a}, moved, shifted, columns + k * {size});",
        f"        for (int i = 0; i < {size}; ++i) {{",
        f"            columns[i + k * {size}] -= sized[i];",
        "        }",
        "    }",
        f"    {model}_orthogonalise({size}, internal, columns, mix);",
        f"    {real} largest = {precision.number(0.0)};",
        "    for (int k = 0; k < internal; ++k) {",
        f"        const {real} part = {model}_dot({size}, columns + k * {size}, columns + k * {size});",
        "        largest = part > largest ? part : largest;",
        f"        amount[k] = {precision.number(0.0)};",
        "    }",
        "    for (int k = 0; k < internal; ++k) {",
        f"        const {real} part = {model}_dot({size}, columns + k * {size}, columns + k * {size});",
        f"        if (part > {precision.threshold(1e-18)} * largest) {{",
        f"            const {real} factor = -{model}_dot({size}, columns + k * {size}, sized) / part;",
        "            for (int i = 0; i < internal; ++i) {",
        "                amount[i] += factor * mix[i + k * internal];",
        "            }",
        "        }",
        "    }",
        "    for (int k = 0; k < internal; ++k) {",
        f"        for (int i = 0; i < {m}; ++i) {{",
        f"            multipliers[i] += amount[k] * row_scale[i] * loads[i + k * {m}];",
        "        }",
        "    }",
        f"    (void){symbol}_wrenches({given}{a}, multipliers, {reactions}, sized);",
        summed,
    ]
