"""Files as nobody writes them: whole ones with some places changed, each of which a reader takes or refuses well.

    whole file --edits (hypothesis)--> changed file --reader, at most SECONDS--> accepted, or one error in a sentence

Taken or refused: what is accepted must be writable, and be the same when it is read back. A traceback of another kind,
an error that fills the screen, and a reader that does not come to an end fail; hypothesis then makes the file short.
"""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from symscrew.errors import DescriptionError
from symscrew.export import OutputError

SECONDS = 10.0  # of the processor, to read a file: what takes longer hangs; and by the clock, on a busy machine, so
TIMES = 30  # many times as long
LONGEST = 4000  # letters of an error
# Short: the same files in every run of the default tests; long: more of them in the slow run, also the same each time,
# so that what fails in one fails in all. HUNT: new ones in every run (tests/fuzz/conftest.py).
COMMON: dict[str, Any] = {"deadline": None, "database": None, "suppress_health_check": list(HealthCheck)}
PROFILES = {
    "short": settings(max_examples=2, derandomize=True, **COMMON),
    "long": settings(max_examples=60, derandomize=True, **COMMON),
}
HUNT = settings(max_examples=3000, derandomize=False, print_blob=True, **COMMON)
PROFILE = pytest.mark.parametrize("profile", ["short", pytest.param("long", marks=pytest.mark.slow)])
NUMBERS = (
    "0", "-0", "1", "-1", "1e-400", "1e400", "1e-100", "1e100", "1e-101", "nan", "inf", "-inf", "NaN", "1e", "0x1f",
    "9" * 400, "0." + "0" * 400 + "1", "exp(700)", "sin(1)^2+cos(1)^2-1", "1/0", "0^0", "sqrt(-1)", "pi", "1e308*10",
    "2^10^10", "log(0)", "(" * 200, "k", "true", "1.0.0", "1_000", "2^3^4^5", "tan(pi/2)", "10^-90", "atan2(0,0)",
)  # fmt: skip
WORDS = (
    "", " ", "a", "A", "base", "mass", "ground", "__class__", "../../etc/passwd", "/dev/zero", "\0", "\ud7ff", "é",
    "x" * 5000, "%s%n", "{0}", "*/", "${HOME}", "<b>", "&amp;", "]]>", "''", '"', "\\", "#", "=", "[", "]", "[[", "if",
    ",", "'''", "-", "None", "self", "R", "S", "P", "U", "C", "H", "0", "true", "name", "type", "\u200f", "\n\n",
)  # fmt: skip
Read = Callable[[Any], object]


class HangError(AssertionError):
    """A reader that does not come to an end."""


@contextlib.contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """An end after so many seconds of the processor."""

    def end(*_: object) -> None:
        raise HangError(f"no end after {seconds} s")

    timers = {signal.SIGPROF: (signal.ITIMER_PROF, seconds), signal.SIGALRM: (signal.ITIMER_REAL, TIMES * seconds)}
    before = {number: signal.signal(number, end) for number in timers}
    try:
        for timer, limit in timers.values():
            signal.setitimer(timer, limit)
        yield
    finally:
        for number, (timer, _) in timers.items():
            signal.setitimer(timer, 0)
            signal.signal(number, before[number])


def fuzz(profile: str, files: st.SearchStrategy[Any], read: Read, *, share: int = 1) -> dict[str, int]:
    """Read many files; how many were accepted, and how many refused.

    Args:
        profile: how many, of PROFILES.
        files: what to read.
        read: reads it, writes what it gives, and reads that again; asserts that they are the same.
        share: one of so many, of files that take long to read.
    """
    counts = {"accepted": 0, "refused": 0}

    chosen = HUNT if settings.default == HUNT else PROFILES[profile]

    @settings(chosen, max_examples=-(-chosen.max_examples // share))
    @given(files)
    def one(file: Any) -> None:
        try:
            with at_most(SECONDS):
                read(file)
        except (DescriptionError, OutputError) as error:
            assert 0 < len(str(error)) < LONGEST, str(error)[:LONGEST]
            counts["refused"] += 1
        else:
            counts["accepted"] += 1

    one()
    return counts


@st.composite
def changed_text(draw: st.DrawFn, wholes: Sequence[str], most: int = 3) -> str:
    """A whole text with some of its tokens replaced, removed, doubled or exchanged."""
    tokens = _tokens(draw(st.sampled_from(list(wholes))))
    for _ in range(draw(st.integers(0, most))):
        place = draw(st.integers(0, len(tokens) - 1))
        other = draw(st.integers(0, len(tokens) - 1))
        change = draw(st.sampled_from(("number", "word", "remove", "double", "exchange", "text", "cut")))
        if change in ("number", "word"):
            tokens[place] = draw(st.sampled_from(NUMBERS if change == "number" else WORDS))
        elif change == "remove":
            tokens[place] = ""
        elif change == "double":
            tokens[place] += "".join(tokens[min(place, other) : max(place, other)][:60])
        elif change == "exchange":
            tokens[place], tokens[other] = tokens[other], tokens[place]
        elif change == "text":
            tokens[place] = draw(st.text(max_size=8))
        else:
            tokens = tokens[: max(place, 1)]
    return "".join(tokens)


def _tokens(text: str) -> list[str]:
    """Words, numbers, blanks and single signs of a text, in order."""
    found: list[str] = []
    for letter in text:
        alike = found and (found[-1][-1].isalnum() or found[-1][-1] in "_.") and (letter.isalnum() or letter in "_.")
        if alike:
            found[-1] += letter
        else:
            found.append(letter)
    return found


@st.composite
def changed_bytes(draw: st.DrawFn, wholes: Sequence[bytes], most: int = 4) -> bytes:
    """Whole bytes with some of them changed, put in, or cut off."""
    content = bytearray(draw(st.sampled_from(list(wholes))))
    for _ in range(draw(st.integers(0, most))):
        place = draw(st.integers(0, max(len(content) - 1, 0)))
        change = draw(st.sampled_from(("set", "insert", "cut", "zero", "large")))
        if change == "set":
            content[place : place + 1] = draw(st.binary(min_size=1, max_size=1))
        elif change == "insert":
            content[place:place] = draw(st.binary(max_size=6))
        elif change == "cut":
            del content[place:]
        else:  # of a size or an offset
            content[place : place + 4] = bytes(4) if change == "zero" else b"\xff\xff\xff\x7f"
    return bytes(content)


JUNK = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=6) | st.sampled_from(WORDS[:12]),
    lambda inside: st.lists(inside, max_size=3) | st.dictionaries(st.text(max_size=4), inside, max_size=3),
    max_leaves=6,
)


@st.composite
def changed_json(draw: st.DrawFn, whole: Any, most: int = 2) -> Any:
    """A JSON value with some of the values in it replaced by others, or by each other."""
    for _ in range(draw(st.integers(0, most))):
        places = _places(whole)
        place, other = draw(st.sampled_from(places)), draw(st.sampled_from(places))
        whole = _with(whole, place, draw(JUNK | st.just(_at(whole, other))))
    return whole


def _places(value: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inside = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [at, *(place for key, entry in inside for place in _places(entry, (*at, key)))]


def _at(value: Any, place: Sequence[Any]) -> Any:
    for key in place:
        value = value[key]
    return value


def _with(value: Any, place: Sequence[Any], new: Any) -> Any:
    if not place:
        return new
    key, *rest = place
    made: Any = dict(value) if isinstance(value, dict) else list(value)
    made[key] = _with(value[key], rest, new)
    return made
