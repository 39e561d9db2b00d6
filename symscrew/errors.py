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
