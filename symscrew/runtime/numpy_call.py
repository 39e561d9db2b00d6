"""A batch function as a function of Python's own: arrays in, new arrays out, without a step in Python between.

    <symbol>_call(shares, told, inputs ...) -> (largest status, results, statuses or None, shape of the batch), or None

ctypes takes a microsecond for a call with some arguments, and making results another one: as much as a hundred states
of a short function. `callable_of` makes a built-in function of the C: Python calls it as its own (METH_FASTCALL, a
vector of arguments), and it makes the arrays of the results by NumPy's `PyArray_New`. Both belong to interfaces that
stay for all versions of Python 3.10 and NumPy, so no header of either is needed to compile it. What it calls of them
is a table of addresses, which it finds in the bytes object that is its `self`: nothing is linked, there is no state.

None is returned for arguments that are not arrays (states, entries) or (entries) of float64 of their sizes, for no
state at all, for an array of one state beside one of several, and where there is no memory for a block: others know
what to say.
"""

from __future__ import annotations

import ctypes
import re
import struct
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from symscrew.program import Port
from symscrew.runtime.strided_c import MISFIT

# States of a thread, at least: making it takes as long as a thousand states of a short function.
THREAD_STATES = 4096
HELD = 16  # states for which other threads of Python may wait: to let them run takes as long as one
BYTES_HEAD = bytes.__basicsize__ - 1  # bytes of a bytes object before its first; one more is its end
FASTCALL = 0x80  # of PyMethodDef: the arguments come as a vector, and how many
PYARRAY_NEW = 93  # its place in NumPy's table, the same in all versions
DOUBLES, INTS, COLUMN_MAJOR = 12, 5, 2  # NPY_DOUBLE, NPY_INT, NPY_ARRAY_F_CONTIGUOUS
# What the C calls of Python, in the order of its table.
CALLED = (
    *("PyTuple_New", "PyTuple_SetItem", "PyLong_FromSsize_t", "PyLong_AsSsize_t"),
    *("Py_IncRef", "Py_DecRef", "PyEval_SaveThread", "PyEval_RestoreThread"),
)

ROUTINES = """
typedef struct {
    void *(*array)(
        const void *type, int dimensions, const ptrdiff_t *shape, int number, const ptrdiff_t *strides, void *data,
        int itemsize, int flags, void *object);
    void *(*tuple)(ptrdiff_t size);
    int (*put)(void *tuple, ptrdiff_t place, void *object);
    void *(*integer)(ptrdiff_t value);
    ptrdiff_t (*value)(void *integer);
    void (*hold)(void *object);
    void (*drop)(void *object);
    void *(*release)(void);
    void (*acquire)(void *state);
    void *none;
    const Array *like;
} Python;

typedef struct {
    const char *name;
    void *(*call)(void *self, void *const *given, ptrdiff_t number);
    int flags;
    const char *text;
} Method;

static void *nothing(const Python *python)
{
    python->hold(python->none);
    return python->none;
}

/* An object goes into a tuple: 0 if both are there, and nothing is left of the object if not. */
static int put(const Python *python, void *tuple, ptrdiff_t place, void *object)
{
    if (tuple != NULL && object != NULL) {
        return python->put(tuple, place, object);
    }
    if (object != NULL) {
        python->drop(object);
    }
    return 1;
}

/* (worst, results, status, batch); all that is in it belongs to it. NULL where there is no memory. */
static void *told_of(const Python *python, int worst, void *results, void *status, const Array *first)
{
    void *const all = python->tuple(4), *const batch = python->tuple(first != NULL);
    int failed = first != NULL ? put(python, batch, 0, python->integer(first->shape[0])) : 0;
    failed += put(python, all, 0, python->integer(worst));
    failed += put(python, all, 1, results);
    failed += put(python, all, 2, status != NULL ? status : nothing(python));
    failed += put(python, all, 3, batch);
    if (failed && all != NULL) {
        python->drop(all);
    }
    return failed ? NULL : all;
}
"""


CALL = """
static void *SYMBOL_call(void *self, void *const *given, ptrdiff_t number)
{
    static const size_t sizes[] = {SIZES};
    const size_t read = READ, ports = PORTS;
    const Python *const python = (const Python *)(const void *)((const char *)self + BYTES_HEAD);
    const Array *const like = python->like, *first = NULL;
    ptrdiff_t strides[STRIDES], shape[2];
    double *data[ARRAYS];
    Array *status = NULL;
    size_t count = 1, shares = 1;
    int layout = ROWS | COLUMNS, failed = 0;
    if (number != (ptrdiff_t)read + 2) {
        return nothing(python);
    }
    for (size_t k = 0; k < read; ++k) {
        const Array *const array = given[k + 2];
        if (array->type != like->type) {
            return nothing(python);
        }
        if (array->dimensions == 2 && (first == NULL || first->shape[1] < 2)) {
            first = array;
        }
    }
    if (first != NULL) {
        count = (size_t)first->shape[0];
        if (count < 1) {
            return nothing(python);
        }
    }
    for (size_t k = 0; k < read; ++k) {
        const Array *const array = given[k + 2];
        if (!fits(like, array, count, sizes[k], strides + 2 * k, &layout)) {
            return nothing(python);
        }
        data[k] = array->data;
    }
    if (count >= 2 * THREAD_STATES) {
        const ptrdiff_t wanted = python->value(given[0]);
        const size_t most = count / THREAD_STATES;
        shares = wanted < 2 ? 1 : (size_t)wanted < most ? (size_t)wanted : most;
    }
    const int columns = first != NULL && first->strides[0] == (ptrdiff_t)sizeof(double);
    void *const results = python->tuple(MADE);
    shape[0] = (ptrdiff_t)count;
    for (size_t k = read; k < ports && results != NULL && !failed; ++k) {
        shape[first != NULL] = (ptrdiff_t)sizes[k];
        Array *const array = python->array(
            like->type, first != NULL ? 2 : 1, shape, DOUBLES, NULL, NULL, 0, columns ? COLUMN_MAJOR : 0, NULL);
        failed = put(python, results, (ptrdiff_t)(k - read), array);
        if (!failed && fits(like, array, count, sizes[k], strides + 2 * k, &layout)) {
            data[k] = array->data;
        }
    }
    if (results != NULL && !failed && python->value(given[1]) != 0) {
        shape[0] = (ptrdiff_t)count;
        status = python->array(like->type, first != NULL, shape, INTS, NULL, NULL, 0, 0, NULL);
        failed = status == NULL;
    }
    if (results == NULL || failed) {
        if (results != NULL) {
            python->drop(results);
        }
        return NULL;
    }
    Part whole = {0, count, count, layout, strides, data, NULL, 0, 0};
    whole.codes = status != NULL ? (int *)(void *)status->data : NULL;
    void *const state = count > HELD ? python->release() : NULL;
    const int worst = divided(SYMBOL_part, &whole, shares);
    if (state != NULL) {
        python->acquire(state);
    }
    if (worst == MISFIT) {
        python->drop(results);
        if (status != NULL) {
            python->drop(status);
        }
        return nothing(python);
    }
    return told_of(python, worst, results, status, first);
}

extern const Method SYMBOL_method;
const Method SYMBOL_method = {"SYMBOL", SYMBOL_call, FASTCALL, NULL};
"""


def call_source(symbol: str, inputs: Sequence[Port], outputs: Sequence[Port]) -> str:
    """The text of <symbol>_call, which stands behind that of `strided_source`."""
    ports = (*inputs, *outputs)
    words = {
        "SYMBOL": symbol,
        "SIZES": ", ".join(str(port.size) for port in ports) or "0",
        "STRIDES": max(2 * len(ports), 1),
        "ARRAYS": max(len(ports), 1),
        "READ": len(inputs),
        "PORTS": len(ports),
        "MADE": len(outputs),
        "BYTES_HEAD": BYTES_HEAD,
        "THREAD_STATES": THREAD_STATES,
        "HELD": HELD,
        "MISFIT": MISFIT,
        "DOUBLES": DOUBLES,
        "INTS": INTS,
        "COLUMN_MAJOR": COLUMN_MAJOR,
        "FASTCALL": FASTCALL,
    }
    return ROUTINES + re.sub(
        r"\b[A-Z_]+(?=\b|_call|_part|_method)", lambda found: str(words.get(found[0], found[0])), CALL
    )


@cache
def _table() -> bytes | None:
    """The addresses that <symbol>_call needs; None where NumPy makes no arrays in the way that it expects."""
    like = _like()
    try:
        core = getattr(np, "_core", None) or np.core
        capsule = core._multiarray_umath._ARRAY_API
        pointer = ctypes.pythonapi.PyCapsule_GetPointer
        pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
        start = pointer(capsule, None)
        found = [ctypes.cast(getattr(ctypes.pythonapi, name), ctypes.c_void_p).value for name in CALLED]
    except (AttributeError, ValueError):
        return None
    new = ctypes.c_void_p.from_address(start + PYARRAY_NEW * ctypes.sizeof(ctypes.c_void_p)).value
    if not new or not _makes_arrays(new):
        return None
    return struct.pack(f"{len(found) + 3}P", new, *found, id(None), id(like))


@cache
def _like() -> np.ndarray:
    """An array of the type of all others, kept for the time of this process."""
    return np.zeros(1)


def _makes_arrays(address: int) -> bool:
    """Whether what stands at an address makes arrays as `PyArray_New` does."""
    make = ctypes.PYFUNCTYPE(
        *(ctypes.py_object, ctypes.py_object, ctypes.c_int, ctypes.c_void_p, ctypes.c_int),
        *(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int, ctypes.c_int, ctypes.c_void_p),
    )(address)
    shape = (ctypes.c_ssize_t * 2)(3, 2)
    made = make(np.ndarray, 2, shape, DOUBLES, None, None, 0, COLUMN_MAJOR, None)
    codes = make(np.ndarray, 1, shape, INTS, None, None, 0, 0, None)
    doubles = made.dtype == np.dtype(float) and made.shape == (3, 2) and made.flags.f_contiguous
    return bool(doubles and codes.dtype == np.dtype(np.intc) and codes.shape == (3,))


def callable_of(library: ctypes.CDLL, symbol: str) -> Callable[..., Any] | None:
    """<symbol>_call of a library as a function of Python; None where it cannot be called."""
    table = _table()
    if table is None:
        return None
    try:
        method = ctypes.addressof(ctypes.c_char.in_dll(library, f"{symbol}_method"))
    except ValueError:
        return None
    make = ctypes.PYFUNCTYPE(ctypes.py_object, ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p)(
        ("PyCFunction_NewEx", ctypes.pythonapi)
    )
    made: Callable[..., Any] = make(method, table, None)
    return made
