"""What happens where a mode of a contact ends: it slips, sticks, turns back, meets its stop or leaves it.

state, modes, contact --> rates behind it, modes, words, energy taken

All stops that are met at one instant are met together, by Newton's law with complementarity: along the inward normals,
with the rates g before and h behind, impulses p >= 0 and accelerations G by unit forces,

    h = g + G p,     h + e g >= 0,     p (h + e g) = 0     (e = 0 where g >= 0)

(Moreau; Glocker, Set-Valued Force Laws, 2001, section 8). The energy that contact k takes is -p_k (g_k + h_k)/2.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.simulation.complementarity import SHARED, complementary
from symscrew.simulation.contacts import STILL, ContactState, Modes, forces, is_dead, released, responses

# A stop is met where its gap is below this, without units: what the search for the instant leaves. Larger: stops that
# are only near take part in an impact; smaller: of two that are met at once one is met later, by itself.
TOUCHING = 1e-9
# A rebound that forces turn back within this height, in units of the joint, ends the bouncing: the contact stays
# closed. At 0 the impacts of a ball accumulate without end; larger, rebounds are lost. One that nothing turns back goes
# on, however slow it is.
SOFT = 1e-13
# Rebounds below this part of the largest rate are rounding of it.
NO_REBOUND = 1e-12
# Part of a friction's level by which the force at an instant that was searched for may be off it.
AT_LEVEL = 1e-6


@dataclass(frozen=True)
class Change:
    """Rates v (nv,) and modes behind an instant, what happened in words, energy taken [J] by name of the joint."""

    v: np.ndarray
    modes: Modes
    texts: tuple[str, ...]
    losses: Mapping[str, float] = field(default_factory=dict)


def beginning(at: ContactState, modes: Modes) -> Change:
    """At the start: stops that the joints move into are met at once, the others hold or let go."""
    if not any(_approaching(at, k, end) for k, end in _touched(at, modes)):
        return Change(at.v, released(at, modes), ())
    return _met(at, modes)


def change(at: ContactState, modes: Modes, which: int) -> Change:
    """Behind the end of the mode of contact `which`."""
    rule, mode = at.rules[which], modes.values[which]
    name = rule.contact.joint
    if rule.contact.kind == "friction" and mode != 0:
        found = released(at, modes.with_mode(which, 0))
        if found.values[which] != -mode and is_dead(at, which):  # the law says nothing there: its rate has turned
            found = found.with_mode(which, -mode)
        if found.values[which] == mode and _at_level(at, modes.with_mode(which, 0), which):
            found = modes.with_mode(which, 0)  # what would go on has turned back: its force falls from the level
        return Change(at.v, found, (f"{name} sticks" if found.values[which] == 0 else f"{name} turns back",))
    if rule.contact.kind == "friction":
        force = forces(at, modes)
        # of a joint that no force moves either direction will do: where it is the other one, it turns back at once
        found = modes.with_mode(which, -int(np.sign(force[which])) or 1)
        return Change(at.v, found, (f"{name} slips",))
    if mode == 0:
        return _met(at, modes, which)
    found = released(at, modes.with_mode(which, 0))
    if found.values[which] == mode:  # it goes on to push: the force only touched zero
        return Change(at.v, found, ())
    return Change(at.v, found, (f"{name} leaves its stop",))


def _at_level(at: ContactState, modes: Modes, which: int) -> bool:
    """Whether the force that holds a stuck joint is its static level, but for what the instant is off."""
    level = at.rules[which].static
    return abs(abs(float(forces(at, modes)[which])) - level) <= AT_LEVEL * level


def _gap(at: ContactState, k: int, end: int) -> float:
    rule = at.rules[k]
    place = at.q[rule.q]
    return float(rule.upper - place if end > 0 else place - rule.lower) / float(at.units[rule.v])


def _touched(at: ContactState, modes: Modes, which: int = -1) -> list[tuple[int, int]]:
    """Stops that are held or met now, with the end at which they are."""
    found = []
    for k, rule in enumerate(at.rules):
        if rule.contact.kind != "stop":
            continue
        nearest = min((1, -1), key=lambda end, k=k: _gap(at, k, end))  # type: ignore[misc]
        end = modes.values[k] or nearest
        if modes.values[k] or k == which or _gap(at, k, end) < TOUCHING:
            found.append((k, end))
    return found


def _approaching(at: ContactState, k: int, end: int) -> bool:
    rate = end * at.v[at.rules[k].v] / at.units[at.rules[k].v]
    return bool(rate > STILL * at.fastest)


def _met(at: ContactState, modes: Modes, which: int = -1) -> Change:
    """Rates and modes behind the impact of all stops that are met."""
    rules, units = at.rules, at.units
    contacts = _touched(at, modes, which)
    rows = [rules[k].v for k, _ in contacts]
    signs = -np.array([end for _, end in contacts], dtype=float)  # inwards
    columns = responses(at, [k for k, _ in contacts], np.zeros(len(rules)))[1] * signs
    gain = columns[rows] * signs[:, None]
    before = signs * at.v[rows]
    rebound = np.array([rules[k].restitution for k, _ in contacts]) * np.maximum(-before, 0)
    impulse = complementary(gain, before - rebound)
    after = before + gain @ impulse
    slow = _soft(at, modes, contacts, gains=columns, impulse=impulse)
    if slow.any():  # they stay closed: what is left of their rates is taken too
        rest = np.zeros(len(contacts))
        rest[slow] = np.linalg.lstsq(gain[np.ix_(slow, slow)], -after[slow], rcond=SHARED)[0]
        impulse = impulse + rest
        after = before + gain @ impulse
    v = at.v + columns @ impulse
    losses: dict[str, float] = {}
    texts: list[str] = []
    for i, (k, end) in enumerate(contacts):
        rule = rules[k]
        losses[rule.contact.joint] = losses.get(rule.contact.joint, 0.0) - 0.5 * impulse[i] * (before[i] + after[i])
        if modes.values[k] == 0 and (k == which or _approaching(at, k, end)):
            texts.append(f"{rule.contact.joint} meets its {'upper' if end > 0 else 'lower'} stop")
        v[rule.v] = 0.0 if slow[i] else v[rule.v]
        modes = modes.with_mode(k, end if slow[i] else 0)
    for k, rule in enumerate(rules):
        if rule.contact.kind == "friction" and abs(v[rule.v] / units[rule.v]) > STILL * at.fastest:
            modes = modes.with_mode(k, int(np.sign(v[rule.v])))
    return Change(v, released(replace(at, v=v), modes), tuple(texts), losses)


def _soft(
    at: ContactState,
    modes: Modes,
    contacts: Sequence[tuple[int, int]],
    *,
    gains: np.ndarray,
    impulse: np.ndarray,
) -> np.ndarray:
    """Which of the stops that are met (their numbers and ends) stay closed behind these impulses."""
    rows, units = [at.rules[k].v for k, _ in contacts], at.units
    inwards = -np.array([end for _, end in contacts], dtype=float)
    behind = replace(at, v=at.v + gains @ impulse)
    after = inwards * behind.v[rows]
    slow = np.abs(after / units[rows]) <= NO_REBOUND * at.fastest
    for (k, end), closed in zip(contacts, slow, strict=True):
        modes = modes.with_mode(k, end if closed else 0)
    pressed = -inwards * behind.accelerations(forces(behind, modes))[rows]
    return np.asarray(slow | ((after > 0) & (after**2 <= 2 * SOFT * units[rows] * pressed)))


def onto_stops(at: ContactState, modes: Sequence[int], q: np.ndarray) -> np.ndarray:
    """q (nq,) with held stops exactly at their ends; the loops are closed behind it by whoever integrates."""
    moved = np.array(q)
    for rule, mode in zip(at.rules, modes, strict=True):
        if rule.contact.kind == "stop" and mode:
            moved[rule.q] = rule.upper if mode > 0 else rule.lower
    return moved
