"""Where the mode of a contact ends within a step of a library's integrator.

contacts at nine places of the step --polynomials of the margins--> first zero --> part of the step, contact

A polynomial that is positive at all of its Bernstein coefficients is so throughout, so that halving finds the first
zero, however short the excursion behind it is (Farouki, CAGD 29, 2012, 379, section 3). The compiled loop does the same
(`kernels/events.c`, `kernels/polynomials.c`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache

import numpy as np

from symscrew.simulation.contacts import ContactState, Law, Modes, forces, held_with, holds

DEGREE = 8  # of the polynomials through a step: those of the integrators are of degree seven, or three
# Margins below this part of the largest force, of a unit of the joint, and of the largest rate, count as zero at the
# start of a step.
FORCE_SLACK, SLACK = 1e-12, 1e-11
# The instant of an event is that of the step's polynomial; putting the state onto the loops moves it by that
# polynomial's error. A margin that is off zero by less at the start of its new mode counts as zero.
MOST_MOVED = 1e-5
ZERO_RATE = 1e-9  # of a margin's largest coefficient: a smaller one is none
# Roundings of a value that a step's polynomial gives, of a dozen terms: coefficients that these may have made are none.
# In a step so short that nothing moves by more a stop that was left would else be met again at once, without end.
ROUNDINGS = 16 * float(np.finfo(float).eps)
DIP = 1e-9  # of how far a margin rises within the step: what it falls before by less is none
NONE = 2.0  # part of a step at which what does not end within it is said to end


def first_end(
    within: Callable[[float], ContactState], modes: Modes, units: np.ndarray, fresh: int, *, blurred: float = 0.0
) -> tuple[float, int] | None:
    """The part of the step (0 to 1) at which the first mode ends, and its contact; None: all last.

    Args:
        within: contacts at a part of the step.
        modes: of the contacts.
        units: of rates (nv,).
        fresh: the contact whose mode has just changed, or -1: its margin begins at zero but for rounding.
        blurred: part of the step by which roundings of the time put the contacts elsewhere; of a nanosecond after a
            minute 1e-5, which bends polynomials as roundings of values do.
    """
    samples = [within(float(part)) for part in places()]
    rules = samples[0].rules
    held = [k for k, rule in enumerate(rules) if holds(rule, modes.values[k])]
    force = np.array([forces(at, modes) for at in samples]) if held else np.zeros((len(samples), len(rules)))
    found: tuple[float, int] = (NONE, -1)
    for k, rule in enumerate(rules):
        slips = rule.contact.kind == "friction" and k not in held
        if k in held:
            own = _of_forces(force[:, k], rule, modes.values[k], fresh=k == fresh)
        else:
            own = _of_motion(samples, rule, modes.values[k], unit=float(units[rule.v]), fresh=k == fresh)
        for margin, slack, size in own:
            noise = ROUNDINGS + (blurred if k == fresh else 0.0)
            part = end_of(_powers() @ margin, slack, noise * size * _growth())
            if part <= 1.0 and part < found[0] and not (slips and held_with(samples[0], k, held)):
                found = (part, k)
    return None if found[1] < 0 else found


@cache
def places() -> np.ndarray:
    """Parts of a step at which it is looked at: Chebyshev's, both ends among them."""
    return np.asarray(0.5 * (1.0 - np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)))


@cache
def _growth() -> np.ndarray:
    """What an error of the values at most makes of each coefficient (9,)."""
    return np.asarray(np.abs(_powers()).sum(axis=1))


@cache
def _powers() -> np.ndarray:
    """Values at the places -> coefficients of powers of the part (9, 9)."""
    return np.asarray(np.linalg.inv(np.vander(places(), increasing=True)))


def _of_forces(force: np.ndarray, rule: Law, mode: int, *, fresh: bool) -> Iterator[tuple[np.ndarray, float, float]]:
    """Margins (9,) of a contact that is held: a stuck one has two, one on a stop its side.

    With what counts as zero at the start, and the size of what a margin is the difference of: none, for forces are off
    by more than roundings. A joint that has just stuck as its force fell from the level may be beyond it by as much as
    the instant is off.
    """
    friction = rule.contact.kind == "friction"
    level = rule.static if friction else 0.0
    slack = FORCE_SLACK * max(float(np.abs(force).max()), level)
    for side in (-1, 1) if friction else (mode,):
        margin = level - side * force
        beyond = -float(margin[0]) if fresh and friction and -MOST_MOVED * level < margin[0] < 0 else 0.0
        yield margin, max(slack, beyond), 0.0


def _of_motion(
    samples: Sequence[ContactState], rule: Law, mode: int, *, unit: float, fresh: bool
) -> Iterator[tuple[np.ndarray, float, float]]:
    """Margins (9,) of a contact that slips, or of a free stop, with what counts as zero and the size of its parts."""
    slack = SLACK * unit
    if rule.contact.kind == "friction":
        rates = np.array([at.v[rule.v] for at in samples])
        slack *= max(at.fastest for at in samples)
        # a rate that only touches zero does not end a slip
        yield mode * rates + slack, slack, float(np.abs(rates).max())
        return
    q = np.array([at.q[rule.q] for at in samples])
    size = float(np.abs(q).max())
    below, above = q - rule.lower, rule.upper - q
    for margin, other in ((below, above), (above, below)):
        if not np.isfinite(margin).all():
            continue
        first = abs(float(margin[0]))
        own = first <= abs(float(other[0]))  # of two stops the one that was met, however near they are
        yield margin, max(slack, first) if fresh and own and first < MOST_MOVED * unit else slack, size


def end_of(c: np.ndarray, slack: float, noise: np.ndarray) -> float:
    """The part of the step at which a margin with these coefficients of powers (9,) ends; 2: it does not.

    Coefficients up to `noise` (9,) are none.

    A margin within `slack` of zero at the start counts as zero there: what it does next decides. Where its rate is
    zero, too, that is its second derivative, of which a polynomial has the sign only if it is large; there a margin
    that falls ends where it is below -slack.
    """
    size, zeros = float(np.abs(c[1:]).max()), 0
    while zeros < DEGREE and abs(c[zeros]) <= (slack if zeros == 0 else max(ZERO_RATE * size, noise[zeros])):
        zeros += 1
    if zeros == DEGREE:
        return NONE  # it stays zero
    if zeros == 1 and c[1] < 0 and _only_dips(c, slack):
        return end_of(np.array([c[0], 0.0, *c[2:]]), slack, noise)
    left = np.concatenate([c[zeros:], np.zeros(zeros)])  # what has the same sign behind these zeros
    if zeros < 2 or left[0] > 0:
        return first_below(left)
    lifted = np.array([slack, *c[1:]])
    below = first_below(lifted)
    if below > 1:
        return NONE
    most = max(float(np.polynomial.polynomial.polyval(below * i / (DEGREE + 1), lifted)) for i in range(1, DEGREE + 1))
    return below if most > 2 * slack else 0.0  # it came back later, or falls from the start


def _only_dips(c: np.ndarray, slack: float) -> bool:
    """Whether a margin that counts as zero at the start falls by nothing before it rises: a step's polynomial is off in
    its first coefficient by more than roundings, and a joint that leaves a dead point begins as the cube of time."""
    values = np.polynomial.polynomial.polyval(_early(), np.array([0.0, *c[1:]]))
    most = float(values.max())
    return bool(values[-1] > 0 and -float(values.min()) <= min(DIP * most, slack))


@cache
def _early() -> np.ndarray:
    """Parts of a step, close to each other at its start."""
    return np.geomspace(1e-9, 1.0, 181)


def first_below(c: np.ndarray) -> float:
    """The first part at which a polynomial with these coefficients of powers (9,) is not positive; 2: none."""
    pieces = [(_bernstein() @ c, 0.0, 1.0)]
    while pieces:
        b, left, right = pieces.pop()
        if not b[0] > 0:
            return left
        if (b[1:] > 0).all():
            continue
        middle = 0.5 * (left + right)
        if not left < middle < right:
            return right
        one, other, work = np.empty_like(b), np.empty_like(b), b
        for j in range(len(b)):  # de Casteljau's halving
            one[j], other[DEGREE - j] = work[0], work[-1]
            work = 0.5 * (work[:-1] + work[1:])
        pieces += [(other, middle, right), (one, left, middle)]
    return NONE


@cache
def _bernstein() -> np.ndarray:
    """Coefficients of powers -> those of Bernstein: b_i = sum of binom(i, k) / binom(n, k) c_k."""
    matrix = np.zeros((DEGREE + 1, DEGREE + 1))
    for i in range(DEGREE + 1):
        ratio = 1.0
        for k in range(i + 1):
            matrix[i, k] = ratio
            ratio *= (i - k) / (DEGREE - k) if k < DEGREE else 0.0
    return matrix
