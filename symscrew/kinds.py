"""What public functions are given, held against what their signatures say, before anything is done with it.

    def derive(mechanism: Mechanism, *, independent: Sequence[str] | None = None)
      --public--> derive(mechanism, independent=3)
      --> derive: independent: expected a sequence of texts or None, got 3 (int); ...

The signature is the one place that says what a function takes; what is looked at is read from it. Values (a name that
is none, a negative number) are looked at where they are used.
"""

from __future__ import annotations

import ast
import inspect
import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence, Sized
from functools import cache, wraps
from numbers import Integral, Real
from typing import Any, ParamSpec, TypeVar

from symscrew.errors import MADE_BY, KindError, shorten

P = ParamSpec("P")
R = TypeVar("R")
# Names in signatures that stand for others.
MEANT = {
    "Controller": "Callable",
    "Limits": "Mapping[str, Any]",
    "Moved": "Any",  # whatever has a model and its motion
    "Pictures": "Mapping[str, Any]",
    "PathLike": "Path",
}
LONGEST_NAME = 255  # bytes of a file's name that every common disk takes
ANYTHING = frozenset({"Any", "object", "ndarray"})
IN_WORDS = {
    "None": "None",
    "str": "text",
    "bool": "True or False",
    "int": "whole number",
    "float": "number",
    "Path": "path",
    "Callable": "function",
    "Mapping": "mapping",
    "Sequence": "sequence",
    "tuple": "tuple",
}
MANY = {"str": "texts", "Effect": "effects, (symscrew.Gravity(),)", "Mapping": "mappings"}


def public(name: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """For the public function of this name, which looks at the kinds of its arguments first.

    Every parameter is held against its annotation: unions, texts, numbers (of NumPy as well; never NaN), paths,
    sequences and mappings with what is in them, functions, and classes by their names.

    Raises:
        KindError: when the function is called; names it and the parameter, what was expected and what came.

    >>> @public("scaled")
    ... def scaled(by: float, names: Sequence[str] = ()) -> float: return by
    >>> scaled(2, names=["a", 3])
    Traceback (most recent call last):
    ...
    symscrew.errors.KindError: scaled: names[1]: expected a text, got 3 (int); help(symscrew.scaled) says what it takes
    """

    def of(function: Callable[P, R]) -> Callable[P, R]:
        parameters = inspect.signature(function).parameters
        kinds = {key: _read(_written(p)) for key, p in parameters.items() if p.kind is not p.VAR_KEYWORD}
        places = tuple(kinds)

        @wraps(function)
        def looked(*arguments: P.args, **options: P.kwargs) -> R:
            for key, value in (*zip(places, arguments, strict=False), *options.items()):
                if key in kinds:
                    _look(name, key, value, kinds[key])
            return function(*arguments, **options)

        return looked

    return of


def _written(parameter: inspect.Parameter) -> str:
    """The annotation of a parameter; anything where there is none (`self`), and of arguments that have no names."""
    named = parameter.annotation is not parameter.empty and parameter.kind is not parameter.VAR_POSITIONAL
    return str(parameter.annotation) if named else "Any"


@cache
def _read(annotation: str) -> tuple[ast.expr, ...]:
    """The alternatives of an annotation; where a path may stand, so may the text of one."""
    found = tuple(_alternatives(ast.parse(annotation, mode="eval").body))
    paths = any(_name(kind) == "Path" for kind in found)
    return tuple(kind for kind in found if not (paths and _name(kind) == "str"))


def _alternatives(of: ast.expr) -> Iterable[ast.expr]:
    if isinstance(of, ast.BinOp):
        yield from _alternatives(of.left)
        yield from _alternatives(of.right)
    elif (meant := MEANT.get(_name(of))) is not None:
        yield from _read(meant)
    else:
        yield of


def _name(of: ast.expr) -> str:
    """A kind without what it holds and where it is from."""
    if isinstance(of, ast.Subscript):
        return _name(of.value)
    return of.attr if isinstance(of, ast.Attribute) else of.id if isinstance(of, ast.Name) else "None"


def _inside(of: ast.expr) -> tuple[tuple[ast.expr, ...], ...]:
    """The alternatives of each of the kinds that one holds."""
    if not isinstance(of, ast.Subscript):
        return ()
    held = of.slice.elts if isinstance(of.slice, ast.Tuple) else [of.slice]
    return tuple(tuple(_alternatives(one)) for one in held)


def _look(function: str, where: str, value: object, kinds: Sequence[ast.expr]) -> None:
    """Raises KindError unless a value, with all that is in it, is of one of these kinds."""
    fitting = next((kind for kind in kinds if _fits(value, _name(kind))), None)
    if fitting is None:
        raise _refused(function, where, value, kinds)
    if not isinstance(fitting, ast.Subscript):
        return
    name, held = _name(fitting), _inside(fitting)
    if name == "Mapping" and isinstance(value, Mapping):
        for key, entry in value.items():
            _look(function, f"a name in {where}", key, held[0])
            _look(function, f"{where}[{shorten(key)}]", entry, held[1])
    elif name == "Sequence" and isinstance(value, Sized):  # what can be gone through only once is left to who uses it
        for k, entry in enumerate(iter(value)):  # type: ignore[call-overload]
            _look(function, f"{where}[{k}]", entry, held[0])
    elif name == "tuple" and isinstance(value, tuple | list):
        if len(value) != len(held):
            raise _refused(function, where, value, kinds)
        for k, (entry, of) in enumerate(zip(value, held, strict=True)):
            _look(function, f"{where}[{k}]", entry, of)


def _fits(value: Any, name: str) -> bool:
    """Whether a value is of a kind, whatever is in it."""
    if name in ANYTHING:
        return True
    if name == "None":
        return value is None
    if name in ("bool", "int", "float"):
        number = value.item() if name != "int" and getattr(value, "shape", None) == () else value
        truth = isinstance(number, bool)
        if name == "bool" or truth:
            return truth and name == "bool"
        return isinstance(number, Integral) if name == "int" else isinstance(number, Real) and _finite(number)
    if name == "Path":
        return isinstance(value, str | os.PathLike) and _names_a_file(value)
    if name == "Callable":
        return callable(value)
    if name == "Sequence":
        return isinstance(value, Iterable) and not isinstance(value, str | bytes | type) and not hasattr(value, "ndim")
    known = {"str": str, "Mapping": Mapping, "tuple": tuple | list}
    if name in known:
        return isinstance(value, known[name])
    return any(kind.__name__ == name for kind in type(value).__mro__)


def _finite(number: Real) -> bool:
    try:
        return math.isfinite(number)
    except (OverflowError, TypeError, ValueError):  # an integer beyond all doubles, a symbol
        return False


def _names_a_file(path: str | os.PathLike[str]) -> bool:
    """Whether the system can be asked for such a path: without null characters and halves of letters, not too long."""
    try:
        encoded = os.fsencode(path)
        return b"\0" not in encoded and max(map(len, encoded.split(os.fsencode(os.sep)))) <= LONGEST_NAME
    except (UnicodeEncodeError, TypeError):
        return False


def _refused(function: str, where: str, value: Any, kinds: Sequence[ast.expr]) -> KindError:
    words = list(dict.fromkeys(map(_words, kinds)))
    first = next((_name(kind) for kind in kinds if _name(kind) in MADE_BY and _name(kind) not in IN_WORDS), None)
    cure = MADE_BY[first] if first is not None else f"help(symscrew.{function}) says what it takes"
    if first is not None and type(getattr(value, first.lower(), None)).__name__ == first:
        cure = f"it has one, as .{first.lower()}"  # a model has its mechanism, a run its model
    expected = f"a {' or a '.join(words)}".replace("a None", "None").replace("a True", "True")
    return KindError(f"{function}: {where}: expected {expected}, got {shorten(value)} ({type(value).__name__}); {cure}")


def _words(kind: ast.expr) -> str:
    """A kind as a person calls it."""
    name, held = _name(kind), _inside(kind)
    if name == "Sequence" and held:
        return f"sequence of {MANY.get(_name(held[0][0]), 'values')}"
    if name == "Mapping" and held:
        return "mapping of names, such as {'A': 0.3}"
    return IN_WORDS.get(name, name)
