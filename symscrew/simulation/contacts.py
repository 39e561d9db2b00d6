"""Stick and slip, and impacts at rigid stops: forces that obey a law with cases.

Every contact is in one of a few modes; in a mode its force is given, or it is what keeps the contact's rate at zero.
Accelerations are affine in the forces, so the latter follow from a linear system. A mode ends where its law does:
the rate of a slipping joint changes its sign, a stuck one needs more than the static force, a stop is reached, or
would have to pull.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.description import exact, numeric
from symscrew.effects import Contact
from symscrew.errors import DescriptionError
from symscrew.model import Model
from symscrew.simulation.complementarity import SHARED, complementary

Answers = Callable[[np.ndarray, np.ndarray], np.ndarray]
# A rate below this part of the largest one counts as zero when modes are chosen: the joint sticks. Larger: what is slow
# is stuck though it moves. Smaller: what an integrator left of a rate that is zero chooses a direction of slipping.
STILL = 1e-9
# A joint that answers its own force by less than this part of the largest acceleration cannot be held by friction (a
# dead point of the loops): it slips through. Smaller: forces grow without bound close to dead points.
HELD = 1e-5
# A joint that answers its own force by no more than this part of it, once others are held, is held with them: its rate
# is rounding. Larger: a joint that hardly moves beside them would never turn back. Smaller: rounding, at 1e-12 where
# what is held reaches it through loops, would turn it back without end.
HELD_WITH = 1e-9
# Part of a friction's level by which a force that is at it may seem off: the roundings of its unit, put in and out.
AT_BOUND = 1e-14
# Part of the forces at hand by which one that holds a contact may break its law: rounding. At 0 a joint that rubs at
# its stop, and whose friction just reaches its level, leaves the stop and meets it without end.
NO_FORCE = 1e-12
# Part of the time by which what is held lets go later than it is found to: roundings of the instant. At 0, of a force
# that rises within a nanosecond, its level is met before it is reached: held again, ten thousand times.
LATE = 1e-15
# An answer to a unit force that is less than its inverse of what accelerates already is found by a larger force.
SMALL_ANSWER = 1e3


@dataclass(frozen=True)
class Law:
    """A contact with numbers: index into v and q of its freedom, and its law."""

    contact: Contact
    v: int
    q: int
    coulomb: float
    static: float
    stribeck: float
    lower: float
    upper: float
    restitution: float

    def level(self, rate: float) -> float:
        """Size of the friction at a rate."""
        if self.static <= self.coulomb or not np.isfinite(self.stribeck):
            return self.coulomb
        return self.coulomb + (self.static - self.coulomb) / (1 + (rate / self.stribeck) ** 2)


def laws(model: Model, contacts: Sequence[Contact], parameters: np.ndarray | None = None) -> tuple[Law, ...]:
    """The contacts with numbers; `parameters`: the run-time ones in the program's order, default the description's.

    Raises:
        DescriptionError: a contact in a cut joint, or friction that depends on the load.
    """
    if not contacts:
        return ()
    chosen = [p.name for p in model.mechanism.parameters.values() if p.run_time]
    given = model.system.parameter_values if parameters is None else parameters
    names = model.mechanism.values({n: exact(float(value)) for n, value in zip(chosen, given, strict=True)})
    tree = model.system.tree

    def number(value: object, default: float) -> float:
        return default if value is None else float(numeric(exact(value, names)))

    result = []
    for contact in contacts:
        where = f"contact in joint {contact.joint!r}"
        if contact.joint not in tree.joints:
            known = ", ".join(j for j in tree.joints if j in model.mechanism.joints)
            raise DescriptionError(
                f"{where}: stick-slip and impacts need a joint of the spanning tree ({known}); use the smooth or "
                "compliant mode here"
            )
        if number(contact.load, 0.0) != 0.0:
            raise DescriptionError(f"{where}: friction with events takes no 'load'; use the smooth mode for it")
        v = tree.velocity_indices(contact.joint)[contact.freedom]
        q = next(li.q.start for li in tree.links[1:] if li.v.start <= v < li.v.stop)
        coulomb = number(contact.coulomb, 0.0)
        result.append(
            Law(
                contact, v, q, coulomb, number(contact.static, coulomb), number(contact.stribeck_velocity, np.inf),
                number(contact.lower, -np.inf), number(contact.upper, np.inf), number(contact.restitution, 0.0),
            )
        )  # fmt: skip
    return tuple(result)


@dataclass(frozen=True)
class ContactState:
    """The contacts at a state: `rules`, q, v, `units` that divide rates, `answers` a (nv,) to rates and forces (n,)."""

    rules: Sequence[Law]
    q: np.ndarray
    v: np.ndarray
    units: np.ndarray
    answers: Answers

    def accelerations(self, forces: np.ndarray) -> np.ndarray:
        """Accelerations (nv,) by forces of the contacts (n,)."""
        return self.answers(self.v, forces)

    @property
    def fastest(self) -> float:
        """The largest rate, without units: what is slow or fast is so beside it, whatever time is measured in."""
        return float(np.abs(self.v / self.units).max(initial=0.0))


@dataclass(frozen=True)
class Modes:
    """Friction: -1, 0, +1 for slipping down, stuck, slipping up. Stops: -1, 0, +1 for at the lower end, free, upper."""

    values: tuple[int, ...]

    def with_mode(self, k: int, mode: int) -> Modes:
        """The same with another mode of contact k."""
        return replace(self, values=(*self.values[:k], mode, *self.values[k + 1 :]))


def holds(rule: Law, mode: int) -> bool:
    """Whether a contact in this mode keeps its rate at zero: stuck, or on its stop."""
    return (mode == 0) == (rule.contact.kind == "friction")


def forces(at: ContactState, modes: Modes) -> np.ndarray:
    """Contact forces (n,) at a state: given by the law, or such that rates that are kept at zero stay there."""
    return _holding(at, modes)[0]


def _holding(at: ContactState, modes: Modes) -> tuple[np.ndarray, np.ndarray]:
    """Contact forces (n,), and what rounding may leave of each that holds."""
    force, held = _by_law(at, modes)
    rounding = np.zeros(len(force))
    if not held:
        return force, rounding
    rows = [at.rules[k].v for k in held]
    a, columns = responses(at, held, force)
    gain = columns[rows]
    force[held] = np.linalg.lstsq(gain, -a[rows], rcond=SHARED)[0]
    own = np.diag(gain)
    alone = np.abs(a[rows]) / np.where(own > 0, own, np.inf)  # what would hold each without the others
    rounding[held] = NO_FORCE * np.maximum(alone, np.abs(force).max())
    return force, rounding


def _by_law(at: ContactState, modes: Modes) -> tuple[np.ndarray, list[int]]:
    """Forces (n,) of contacts that slip or are free, and which others are held."""
    given, held = np.zeros(len(at.rules)), []
    for k, (rule, mode) in enumerate(zip(at.rules, modes.values, strict=True)):
        if holds(rule, mode):
            held.append(k)
        elif rule.contact.kind == "friction":
            given[k] = -mode * rule.level(float(at.v[rule.v]))
    return given, held


def responses(at: ContactState, which: Sequence[int], given: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Accelerations (nv,) by given forces of all contacts (n,), and (nv, contacts) by a unit more of each of these.

    Where what acts already accelerates far more, a unit's part would be rounding: a larger force by its size is it.
    """
    base, columns = at.accelerations(given), []
    most = float(np.abs(base / at.units).max(initial=0.0))
    for k in which:
        size = 1.0
        for _ in range(2):
            force = np.array(given)
            force[k] += size
            column = (at.accelerations(force) - base) / size
            answer = float(np.abs(column / at.units).max(initial=0.0))
            if not most > SMALL_ANSWER * answer * size > 0:
                break
            size = most / answer
        columns.append(column)
    return base, np.stack(columns, 1)


def start_modes(at: ContactState) -> Modes:
    """Modes at the start by places and rates alone: slipping with the rate, or stuck; on a stop at rest, or free.

    `mode_changes.beginning` says what becomes of them.

    Raises:
        DescriptionError: a joint starts beyond its stop.
    """
    rules, q, v, units = at.rules, at.q, at.v, at.units
    modes = []
    for rule in rules:
        rate = v[rule.v] / units[rule.v]
        if rule.contact.kind == "friction":
            modes.append(0 if abs(rate) <= STILL * at.fastest else int(np.sign(rate)))
            continue
        for end, place in ((1, rule.upper), (-1, rule.lower)):
            if end * (q[rule.q] - place) > 1e-9 * units[rule.v]:
                raise DescriptionError(
                    f"initial.coordinates: {rule.contact.joint} = {q[rule.q]:g} lies beyond its stop at {place:g}"
                )
        near = 1e-12 * units[rule.v]
        end = 1 if rule.upper - q[rule.q] < near else -1 if q[rule.q] - rule.lower < near else 0
        modes.append(end if abs(rate) <= STILL * at.fastest else 0)
    return Modes(tuple(modes))


def released(at: ContactState, modes: Modes) -> Modes:
    """Modes after those have ended whose forces break their law.

    Contacts hold and release each other: which of them end follows from all together, and not from the forces that each
    would need if all were held. Of two stops that would pull, one may have to push once the other has let go.

    Raises:
        UndecidedError: forces that obey all laws were not found.
    """
    modes = _turned(at, modes)
    if _excess(at, modes):
        modes = _all_within_laws(at, modes)
    while excess := _excess(at, modes):  # they share a freedom, and the least forces are another share of what holds it
        k = max(excess, key=lambda k: abs(excess[k]))
        modes = modes.with_mode(k, -int(np.sign(excess[k])) if at.rules[k].contact.kind == "friction" else 0)
    return modes


def _all_within_laws(at: ContactState, resting: Modes) -> Modes:
    """The modes of resting contacts whose forces all obey their laws.

    Behind its static level friction falls to that of slipping: stops that let go may have to push then, and a joint
    that slips may be held again, once.
    """
    slips: dict[int, int] = {}
    again: set[int] = set()
    while True:
        modes = resting
        for k, way in slips.items():
            modes = modes.with_mode(k, way)
        ended = _ended(at, modes)
        new = {k: way for k, way in ended.items() if way}
        slips |= new
        for k, way in ended.items():
            modes = modes.with_mode(k, way)
        if new:
            continue
        a = at.accelerations(forces(at, modes)) / at.units
        backwards = {k: way * float(a[at.rules[k].v]) for k, way in slips.items() if k not in again}
        worst = min(backwards, key=lambda k: backwards[k], default=-1)
        if worst < 0 or backwards[worst] >= -STILL * float(np.abs(a).max()):
            return modes
        del slips[worst]
        again.add(worst)


def _excess(at: ContactState, modes: Modes) -> dict[int, float]:
    """Held contacts whose forces break their law, with these."""
    force, rounding = _holding(at, modes)
    found = {}
    for k in _by_law(at, modes)[1]:
        rule = at.rules[k]
        stuck = rule.contact.kind == "friction"
        if (abs(force[k]) - rule.static if stuck else modes.values[k] * force[k]) > rounding[k]:
            found[k] = float(force[k])
    return found


def _ended(at: ContactState, modes: Modes) -> dict[int, int]:
    """Held contacts whose force is at its bound where all obey their laws, and the modes that they take."""
    given, held = _by_law(at, modes)
    if not held:
        return {}
    rules, ends = [at.rules[k] for k in held], [modes.values[k] for k in held]
    rows, rubs = [rule.v for rule in rules], [rule.contact.kind == "friction" for rule in rules]
    base, columns = responses(at, held, given)
    level = np.array([rule.static if stuck else np.inf for rule, stuck in zip(rules, rubs, strict=True)])
    low = np.where([end > 0 or stuck for end, stuck in zip(ends, rubs, strict=True)], -level, 0.0)
    high = np.where([end < 0 or stuck for end, stuck in zip(ends, rubs, strict=True)], level, 0.0)
    found = complementary(columns[rows], base[rows], low=low, high=high)
    moved = base[rows] + columns[rows] @ found
    ended = {}
    for i, k in enumerate(held):
        if rubs[i] and abs(found[i]) >= level[i] * (1 - AT_BOUND):
            ended[k] = -int(np.sign(found[i])) or int(np.sign(moved[i])) or 1
        elif not rubs[i] and found[i] == 0.0:
            ended[k] = 0
    return ended


def _turned(at: ContactState, modes: Modes) -> Modes:
    """Modes with those stuck joints slipping that no force of theirs can hold: at a dead point of the loops the joint's
    rate is zero whatever the others do, and changes its sign there."""
    stuck = [k for k, r in enumerate(at.rules) if r.contact.kind == "friction" and modes.values[k] == 0]
    base = at.accelerations(np.zeros(len(at.rules))) / at.units if stuck else np.zeros(0)
    for k in stuck:
        row = at.rules[k].v
        if abs(base[row]) > 1e-9 * float(np.abs(base).max()) and is_dead(at, k):
            modes = modes.with_mode(k, int(np.sign(base[row])))
    return modes


def is_dead(at: ContactState, k: int) -> bool:
    """Whether joint k does not answer its own friction: a force that would hold it is none, or rounding."""
    base = at.accelerations(np.zeros(len(at.rules))) / at.units
    force = np.zeros(len(at.rules))
    force[k] = max(at.rules[k].static, 1.0)
    response = at.accelerations(force) / at.units - base
    most = float(np.abs(response).max())
    return bool(response[at.rules[k].v] < HELD * most or most < 1e-12 * float(np.abs(base).max()))


def held_with(at: ContactState, k: int, others: Sequence[int]) -> bool:
    """Whether joint k cannot move as long as other contacts are held: a stop at the end of a rod holds its crank, too.

    What rounding leaves of its rate says nothing of its friction then, which bears its part of the load: held back, it
    would turn back at once, and so on without end. A joint that does not answer its own force (`is_dead`) is not held.
    """
    if not others or is_dead(at, k):
        return False
    columns = responses(at, [k, *others], np.zeros(len(at.rules)))[1]
    gain = columns[[at.rules[i].v for i in (k, *others)]]
    size = 1 / np.sqrt(np.maximum(np.diag(gain), np.finfo(float).tiny))
    gain = size[:, None] * gain * size  # without units
    left = gain[0, 0] - gain[0, 1:] @ np.linalg.lstsq(gain[1:, 1:], gain[1:, 0], rcond=SHARED)[0]
    return bool(abs(left) <= HELD_WITH)
