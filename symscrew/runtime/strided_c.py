"""C that gives a batch function arrays of any strides, of double whatever the function's own type, and threads.

    int <symbol>_arrays(count, strides, inputs ..., outputs ..., status)
    int <symbol>_numpy(count, shares, like, inputs, outputs, status)

Blocks of states are collected, entry after entry, given to <symbol>_batch_soa, and its results spread out.
`strides` holds, array after array, the numbers between two states and between two entries; 0 between states means the
same entries for all.

The second takes NumPy's arrays as they are: it looks at their types, shapes and strides, and calls <symbol>_batch or
<symbol>_batch_soa where their layout allows, and else the first. Asking an array for its address from Python takes a
microsecond, as much as thirty states of a short function; in C it is a field of the object. These fields are part of
NumPy's ABI (`PyArrayObject_fields`): every compiled extension reads them in place. `NUMPY_AS_EXPECTED` holds if they
are found where they ought to be; where not (another Python than CPython), nothing calls this function. Inputs and
outputs come as tuples; where `status` is no array, statuses are not told. Compiled with `THREADS`, it divides the
states among `shares` threads; shares begin where blocks begin, so that each state has the neighbours, and the bits,
that it has in one thread.

Both are compiled beside the generated files and use nothing of them but the batch functions.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Sequence

import numpy as np

from symscrew.export import DOUBLE, Precision
from symscrew.program import Port

# States of a block: of arrays that the second cache holds, as many as the first one holds of most functions; of larger
# ones, as many as the batch functions take at once, so that numbers of the next block arrive while these are computed.
NEAR, FAR = 32, 8
NEARBY = 1 << 17  # numbers of all arrays together that the second cache holds: 1 MB
MISFIT = 1000  # returned where an array is not as expected or there is no memory for a block; above every status
# Threads of POSIX, made for a call and gone with it: tens of microseconds each. Those of OpenMP stay and are there at
# once, but who is ready first spins on its processor, where the other thread could run: beside another program, calls
# took 3 to 12 times as long as in one thread; and they do not survive a fork.
THREADS = ("-pthread", "-DSYMSCREW_THREADS")
PTHREADS = ("#if defined(SYMSCREW_THREADS)", "#include <pthread.h>", "#endif")
MOST_SHARES = 64  # threads of a call, at most: their parts stand on the stack
LINE = 8  # numbers of a line of the cache
HEAD = object.__basicsize__  # bytes of every object of Python before its own fields; the last of them is its type
ITEMS = tuple.__basicsize__  # bytes of a tuple before its items

COPIES = """
static void collect_LANES(size_t size, size_t some, const ptrdiff_t *stride, const double *array, REAL *restrict block)
{
    for (size_t k = 0; k < size; ++k) {
        const double *entry = array + (ptrdiff_t)k * stride[1];
        REAL *to = block + k * LANES;
        if (stride[0] == 1) {
            for (size_t i = 0; i < some; ++i) {
                to[i] = (REAL)entry[i];
            }
        } else {
            for (size_t i = 0; i < some; ++i) {
                to[i] = (REAL)entry[(ptrdiff_t)i * stride[0]];
            }
        }
    }
}

static void spread_LANES(size_t size, size_t some, const ptrdiff_t *stride, const REAL *restrict block, double *array)
{
    for (size_t k = 0; k < size; ++k) {
        double *entry = array + (ptrdiff_t)k * stride[1];
        const REAL *from = block + k * LANES;
        for (size_t i = 0; i < some; ++i) {
            entry[(ptrdiff_t)i * stride[0]] = (double)from[i];
        }
    }
}
"""

ROUTINES = """
/* Asks for numbers of the next block: they lie too far apart for the processor to foresee them. */
static void ask(size_t size, size_t some, size_t next, const ptrdiff_t *stride, const double *array)
{
#if defined(__GNUC__)
    if (stride[1] == 1) { /* the entries of a state are neighbours */
        for (size_t i = some; i < some + next; ++i) {
            for (size_t k = 0; k < size; k += LINE) {
                __builtin_prefetch(array + (ptrdiff_t)i * stride[0] + k);
            }
        }
    } else if (next > 0) {
        for (size_t k = 0; k < size; ++k) {
            __builtin_prefetch(array + (ptrdiff_t)some * stride[0] + (ptrdiff_t)k * stride[1]);
        }
    }
#else
    (void)size;
    (void)some;
    (void)next;
    (void)stride;
    (void)array;
#endif
}

typedef struct {
    char head[HEAD - sizeof(void *)];
    const void *type;
    double *data;
    int dimensions;
    const ptrdiff_t *shape, *strides;
    const void *base, *number;
} Array;

typedef struct {
    char head[ITEMS];
    const Array *item[1];
} Tuple;

enum { ROWS = 1, COLUMNS = 2 };

/* Whether this is an array (count, size) or (size) of the same type as `like`; its strides, and how it may be read. */
static int fits(const Array *like, const Array *a, size_t count, size_t size, ptrdiff_t *stride, int *layout)
{
    const ptrdiff_t number = (ptrdiff_t)sizeof(double);
    if (a->type != like->type || a->number != like->number || a->dimensions < 1 || a->dimensions > 2) {
        return 0;
    }
    if ((size_t)a->shape[a->dimensions - 1] != size || (a->dimensions == 2 && (size_t)a->shape[0] != count)) {
        return 0;
    }
    stride[0] = a->dimensions == 2 ? a->strides[0] : 0;
    stride[1] = a->strides[a->dimensions - 1];
    if (stride[0] % number != 0 || stride[1] % number != 0 || (size_t)a->data % sizeof(double) != 0) {
        return 0;
    }
    stride[0] /= number;
    stride[1] /= number;
    if (size > 0) {
        const int rows = (count == 1 || stride[0] == (ptrdiff_t)size) && (size == 1 || stride[1] == 1);
        const int columns = stride[0] == 1 && (size == 1 || stride[1] == (ptrdiff_t)count);
        *layout &= (rows ? ROWS : 0) | (columns ? COLUMNS : 0);
    }
    return 1;
}

/* Some of the states of a call: what one thread does. */
typedef struct {
    size_t first, some, count;
    int layout;
    const ptrdiff_t *strides;
    double *const *data;
    int *codes;
    int outcome, started;
} Part;

/* The largest status of all states, in so many threads, which end with the call. */
static int divided(void *(*run)(void *), const Part *whole, size_t shares)
{
    Part parts[MOST_SHARES];
    const size_t blocks = (whole->count + NEAR - 1) / NEAR, wanted = shares < MOST_SHARES ? shares : MOST_SHARES;
    const size_t step = wanted < 2 ? whole->count : (blocks + wanted - 1) / wanted * NEAR;
    size_t number = 1;
    int worst;
#if defined(SYMSCREW_THREADS)
    pthread_t threads[MOST_SHARES];
#endif
    parts[0] = *whole;
    parts[0].some = step;
    for (size_t first = step; step > 0 && first < whole->count; first += step, ++number) {
        Part *const part = parts + number;
        *part = *whole;
        part->first = first;
        part->some = whole->count - first < step ? whole->count - first : step;
#if defined(SYMSCREW_THREADS)
        part->started = pthread_create(threads + number, NULL, run, part) == 0;
#endif
    }
    run(parts);
    worst = parts[0].outcome;
    for (size_t k = 1; k < number; ++k) {
        if (!parts[k].started) {
            run(parts + k);
        }
#if defined(SYMSCREW_THREADS)
        if (parts[k].started) {
            pthread_join(threads[k], NULL);
        }
#endif
        worst = parts[k].outcome > worst ? parts[k].outcome : worst;
    }
    return worst;
}
"""


def _found() -> bool:
    """Whether fields of NumPy's arrays are where <symbol>_numpy reads them."""
    if sys.implementation.name != "cpython" or not hasattr(ctypes, "py_object"):
        return False
    like = np.zeros((3, 2))[:, 1]
    word = ctypes.sizeof(ctypes.c_void_p)

    def field(number: int) -> int:
        return ctypes.c_size_t.from_address(id(like) + HEAD + number * word).value

    shape = ctypes.c_ssize_t.from_address(field(2)).value, ctypes.c_ssize_t.from_address(field(3)).value
    dimensions = ctypes.c_int.from_address(id(like) + HEAD + word).value
    kind = ctypes.c_size_t.from_address(id(like) + HEAD - word).value
    expected = (like.__array_interface__["data"][0], id(like.dtype), 1, (3, like.strides[0]), id(np.ndarray))
    pair = (like, like.dtype)
    items = [ctypes.c_size_t.from_address(id(pair) + ITEMS + k * word).value for k in range(2)]
    return (field(0), field(5), dimensions, shape, kind) == expected and items == list(map(id, pair))


NUMPY_AS_EXPECTED = _found()


def strided_source(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port], precision: Precision) -> str:
    """The text of <symbol>_arrays and <symbol>_numpy."""
    words = {
        "REAL": precision.real,
        "HEAD": str(HEAD),
        "LINE": str(LINE),
        "ITEMS": str(ITEMS),
        "MOST_SHARES": str(MOST_SHARES),
        "NEAR": str(NEAR),
    }
    routines = "".join(COPIES.replace("LANES", str(lanes)) for lanes in (NEAR, FAR)) + ROUTINES
    for word, value in words.items():
        routines = routines.replace(word, value)
    own = [*(f"const {precision.real} *" for _ in inputs), *(f"{precision.real} *" for _ in outputs), "int *"]
    batches = f"""\
int {symbol}_batch(size_t count, {", ".join(own)});
int {symbol}_batch_soa(size_t count, size_t stride, {", ".join(own)});
"""
    functions = [text for made in (_arrays, _numpy) for text in (*made(symbol, inputs, outputs, precision), "")]
    return "\n".join(["#include <stddef.h>", "#include <stdlib.h>", *PTHREADS, routines, batches, *functions])


def _arrays(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port], precision: Precision) -> list[str]:
    real, ports, read = precision.real, (*inputs, *outputs), range(len(inputs))
    taken = ", ".join([f"{'const ' if k in read else ''}double *a{k}" for k in range(len(ports))] + ["int *status"])
    entries = max(sum(port.size for port in ports), 1)
    signature = f"int {symbol}_arrays(size_t count, const ptrdiff_t *strides, {taken})"
    used = [*(["collect"] if not inputs else []), *(["spread"] if not outputs else [])]
    return [
        f"{signature};",
        signature,
        "{",
        "    int worst = 0;",
        f"    const size_t lanes = count <= {NEARBY // entries} ? {NEAR} : {FAR};",
        f"    {real} *const block = malloc({entries} * lanes * sizeof({real}));",
        *(f"    (void){name}_{lanes};" for name in used for lanes in (NEAR, FAR)),
        *([] if ports else ["    (void)strides;"]),
        *([] if inputs else ["    (void)ask;"]),
        "    if (block == NULL) {",
        f"        return {MISFIT};",
        "    }",
        f"    if (lanes == {NEAR}) {{",
        *_blocks(symbol, inputs, outputs, NEAR),
        "    } else {",
        *_blocks(symbol, inputs, outputs, FAR),
        "    }",
        "    free(block);",
        "    return worst;",
        "}",
    ]


def _blocks(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port], lanes: int) -> list[str]:
    """The loop over blocks of so many states; of few, those of the next block are asked for."""
    ports, read = (*inputs, *outputs), len(inputs)
    blocks = [f"block + {sum(port.size for port in ports[:k]) * lanes}" for k in range(len(ports))]
    codes = "status != NULL ? status + first : NULL"
    lines = [
        f"        for (size_t first = 0; first < count; first += {lanes}) {{",
        f"            const size_t some = count - first < {lanes} ? count - first : {lanes};",
        "            int outcome;",
    ]
    if lanes == FAR and inputs:
        lines.append(f"            const size_t rest = count - first - some, next = rest < {lanes} ? rest : {lanes};")
    for k, port in enumerate(ports):
        given = f"{port.size}, some, strides + {2 * k}"
        start = f"a{k} + (ptrdiff_t)first * strides[{2 * k}]"
        if k == read:
            lines.append(f"            outcome = {symbol}_batch_soa(some, {lanes}, {', '.join([*blocks, codes])});")
        if k >= read:
            lines.append(f"            spread_{lanes}({given}, {blocks[k]}, {start});")
            continue
        lines.append(f"            if (first == 0 || strides[{2 * k}] != 0) {{")
        if lanes == FAR:
            lines.append(f"                ask({port.size}, some, next, strides + {2 * k}, {start});")
        lines += [f"                collect_{lanes}({given}, {start}, {blocks[k]});", "            }"]
    if not outputs:
        lines.append(f"            outcome = {symbol}_batch_soa(some, {lanes}, {', '.join([*blocks, codes])});")
    return [*lines, "            worst = outcome > worst ? outcome : worst;", "        }"]


def _part(symbol: str, ports: Sequence[Port], precision: Precision) -> list[str]:
    """The states of one thread."""

    def begin(step: str) -> str:
        starts = (f"p->data[{k}] + {step.format(s=2 * k, size=port.size)}" for k, port in enumerate(ports))
        return ", ".join([*starts, "p->codes != NULL ? p->codes + first : NULL"])

    ways = [f"    p->outcome = {symbol}_arrays(p->some, p->strides, {begin('(ptrdiff_t)first * p->strides[{s}]')});"]
    if precision is DOUBLE:
        ways = [
            "    if (p->layout & ROWS) {",
            f"        p->outcome = {symbol}_batch(p->some, {begin('first * {size}')});",
            "    } else if (p->layout & COLUMNS) {",
            f"        p->outcome = {symbol}_batch_soa(p->some, p->count, {begin('first')});",
            "    } else {",
            f"    {ways[0]}",
            "    }",
        ]
    return [
        f"static void *{symbol}_part(void *argument)",
        "{",
        "    Part *const p = argument;",
        "    const size_t first = p->first;",
        *ways,
        "    return NULL;",
        "}",
    ]


def _numpy(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port], precision: Precision) -> list[str]:
    ports = (*inputs, *outputs)
    taken = "const Array *like, const Tuple *inputs, const Tuple *outputs, const Array *status"
    signature = f"int {symbol}_numpy(size_t count, size_t shares, {taken})"
    held = [*(f"inputs->item[{k}]" for k in range(len(inputs))), *(f"outputs->item[{k}]" for k in range(len(outputs)))]
    lines = [
        *_part(symbol, ports, precision),
        "",
        f"{signature};",
        signature,
        "{",
        f"    ptrdiff_t strides[{max(2 * len(ports), 1)}];",
        f"    double *data[{max(len(ports), 1)}];",
        "    int *const codes = status->type == like->type ? (int *)(void *)status->data : NULL;",
        "    int layout = ROWS | COLUMNS;",
        *([] if inputs else ["    (void)inputs;"]),
        *([] if outputs else ["    (void)outputs;"]),
    ]
    for k, (port, item) in enumerate(zip(ports, held, strict=True)):
        lines += [
            f"    if (!fits(like, {item}, count, {port.size}, strides + {2 * k}, &layout)) {{",
            f"        return {MISFIT};",
            "    }",
            f"    data[{k}] = {item}->data;",
        ]
    whole = "Part whole = {0, count, count, layout, strides, data, codes, 0, 0}"
    return [*lines, f"    {whole};", f"    return divided({symbol}_part, &whole, shares);", "}"]
