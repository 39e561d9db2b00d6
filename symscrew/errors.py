"""The error that bad input ends in."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class DescriptionError(ValueError):
    """A description that cannot be used: says where, what was expected, what came, and the cure.

    The command line turns it into exit code 2.
    """


class FileError(DescriptionError):
    """What is wrong in a file, whose name it begins with: files that name this one do not put theirs before it."""


def in_file(name: str, error: DescriptionError) -> FileError:
    """The error with the name of the file that it is in, once."""
    return error if isinstance(error, FileError) else FileError(f"{name}: {error}")


# How what public functions take is made: the cure where something else came.
MADE_BY = {
    "Mechanism": "symscrew.load_catalogue(name), symscrew.load_description(file) or a MechanismBuilder makes one",
    "Model": "symscrew.derive(mechanism) makes one",
    "Scene": "symscrew.load_scene(file) makes one",
    "TrajectoryProblem": "symscrew.optimisation.load_problem(file) makes one",
    "Effect": "symscrew.effects has their kinds, to be called with what they need: symscrew.Gravity()",
    "str": "it names a file, a folder or a mechanism, or is an expression",
    "Real": "a number, in SI units",
    "Mapping": "names with their values, such as {'A': 0.3}",
}


class KindError(DescriptionError, TypeError):
    """A public function was given another kind of thing than it takes: a name in place of what bears it, a model in
    place of a mechanism."""


def expect(value: object, *kinds: type) -> None:
    """Refuse a value that is of none of these kinds.

    Raises:
        KindError: says what was expected, what came, and what makes it.

    >>> class Mechanism: pass
    >>> expect("four_bar", Mechanism)
    Traceback (most recent call last):
    ...
    symscrew.errors.KindError: expected a Mechanism, got 'four_bar' (str); symscrew.load_catalogue(name), \
symscrew.load_description(file) or a MechanismBuilder makes one
    """
    if isinstance(value, kinds):
        return
    wanted = " or a ".join(kind.__name__ for kind in kinds)
    own = getattr(value, kinds[0].__name__.lower(), None)
    cure = MADE_BY[kinds[0].__name__]
    if isinstance(own, kinds[0]):  # a model has its mechanism, a run its model
        cure = f"it has one, as .{kinds[0].__name__.lower()}"
    raise KindError(f"expected a {wanted}, got {shorten(value)} ({type(value).__name__}); {cure}")


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A sentence that lists the known names nearest to `name`, or all of them when they are few.

    >>> did_you_mean("mas", ["mass", "com", "inertia"])
    "did you mean 'mass'?"
    >>> did_you_mean("elbo", ["shoulder_joint", "elbow_joint"])
    "did you mean 'elbow_joint'?"
    """
    candidates = list(known)
    near = difflib.get_close_matches(name, candidates, n=3, cutoff=0.6)
    if not near and len(name) > 2:
        near = [candidate for candidate in candidates if name.lower() in candidate.lower()][:3]
    if near:
        return "did you mean " + " or ".join(repr(candidate) for candidate in near) + "?"
    if not candidates:
        return "none is known here"
    shown = ", ".join(candidates[:20])
    return f"known: {shown}" + (", ..." if len(candidates) > 20 else "")


def shorten(value: object, limit: int = 60) -> str:
    """`value` as it would be typed, cut to `limit` characters: hostile input must not fill the screen."""
    try:
        text = repr(value)
    except ValueError:  # Python refuses to print integers of more than 4300 digits
        text = f"a {type(value).__name__} with very many digits"
    return text if len(text) <= limit else text[: limit - 3] + "..."
