"""Assembly modes in words and as JSON values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from symscrew.assembly.all_modes import AssemblyMode, AssemblyModes
from symscrew.assembly.mode_ways import CONNECTED, SEPARATED, UNDECIDED, Connection

SHOWN = 14
"""Decimals in words: what follows is rounding. The JSON has all."""


def mode_lines(found: AssemblyModes) -> list[str]:
    """What was found, how complete it is, and a line for each mode."""
    count = len(found.modes)
    held = ", ".join(f"{name} = {value:.9g}" for name, value in found.held.items())
    lines = [f"{count} assembly mode{'s' * (count != 1)} of {found.mechanism.name} with {held}", _verdict(found)]
    account = found.account
    if account.paths:
        kinds = ("real", "complex", "infinity", "lost")
        words = dict(zip(kinds, ("to real solutions", "to complex ones", "to infinity", "lost"), strict=True))
        told = [f"{account.count(kind)} {words[kind]}" for kind in kinds if account.count(kind)]
        again = f", {account.again} times again, with shorter steps or on another way" if account.again else ""
        further = account.from_random_places
        more = f"; to {further} further solution{'s' * (further != 1)} Newton's method from random places" * bool(
            further
        )
        lines.append(f"{account.paths} path{'s' * (account.paths != 1)}: {', '.join(told)}{again}{more}")
    if found.curves:
        lines.append(f"{found.curves} paths end on solutions without end: somewhere it moves with what is held")
    if found.out_of_reach:
        lines.append(f"{found.out_of_reach} further solutions of the closure that joints of a limb do not reach")
    lines += [f"{mode.name:6} {_mode(mode, found.body)}" for mode in found.modes]
    return lines


def reach_lines(found: AssemblyModes, connections: Sequence[Connection], *, searched: bool) -> list[str]:
    """Of each mode which others it can reach."""
    words = {
        CONNECTED: "reaches {} without a singularity, proved",
        SEPARATED: "a singularity on every way to {}",
        UNDECIDED: "no way found to {}" if searched else "not looked for (--reachable): {}",
    }
    lines = []
    for mode in found.modes:
        reach = _reach(mode, connections)
        others = {kind: ", ".join(name for name, judged in reach.items() if judged == kind) for kind in words}
        told = [text.format(others[kind]) for kind, text in words.items() if others[kind]]
        lines += [f"{mode.name}: {'; '.join(told)}"] if told else []
    return lines


def _reach(mode: AssemblyMode, connections: Sequence[Connection]) -> dict[str, str]:
    pairs = [(c.one, c.two, c.judgement) for c in connections]
    return {two if one == mode.name else one: judged for one, two, judged in pairs if mode.name in (one, two)}


def _verdict(found: AssemblyModes) -> str:
    words = {
        "proved": "complete, proved",
        "bounded": "complete with probability one",
        "regular": "every regular mode with probability one",
        "tracked": "complete by tracking, not proved",
        "sampled": "not known to be all",
    }
    return f"{words[found.complete]}: {found.why}"


def _mode(mode: AssemblyMode, body: str) -> str:
    turn = np.degrees(np.arccos(np.clip((np.trace(mode.rotation) - 1) / 2, -1, 1)))
    place = ", ".join(f"{c:.6g}" for c in mode.translation.round(SHOWN) + 0.0)
    turned = ", ".join(f"{c:.6g}" for c in mode.quaternion.round(SHOWN) + 0.0)
    told = f"{body} turned by {turn:.4g} deg, quaternion ({turned}), "
    told += f"O moved by ({place}) m; smallest singular value {mode.smallest:.3g}, loops open by {mode.residual:.1e}"
    signs = ", ".join(f"{name} {sign}" for name, sign in mode.signs.items())
    told += f"; {signs}" if signs else ""
    if mode.curve:
        told += "; solutions beside it without end: it moves with what is held"
    elif mode.meeting > 1:
        told += f"; {mode.meeting} solutions meet in it exactly, as its exact numbers say: singular, certified"
    elif mode.exact:
        told += "; certified: exact numbers that make every equation zero"
    elif mode.paths > 1:
        told += f"; {mode.paths} solutions in one place or almost: singular, not certified"
    else:
        told += "; certified" if mode.certified else "; not certified"
    return told + (f"; {mode.ways} ways to hold it" if mode.ways > 1 else "")


def mode_values(found: AssemblyModes, connections: Sequence[Connection] = ()) -> dict[str, Any]:
    """The same as JSON values, numbers with all digits; rotations as quaternions (w, x, y, z), lengths in m.

    `ways`: of two modes that are connected the values of what is held on a way, straight between them.
    """
    account, bound = found.account, found.bound
    return {
        "mechanism": found.mechanism.name,
        "body": found.body,
        "held": dict(found.held),
        "complete": found.complete,
        "why": found.why,
        "bound": None if bound is None else {"count": bound.count, "dimension": bound.dimension, "how": bound.how},
        "paths": {kind: account.count(kind) for kind in ("real", "complex", "infinity", "lost")},
        "from_random_places": account.from_random_places,
        "on_curves": found.curves,
        "out_of_reach": found.out_of_reach,
        "modes": [{**_values(mode), "reachable": _reach(mode, connections)} for mode in found.modes],
        "ways": [{"from": c.one, "to": c.two, "held": [*map(dict, c.way)]} for c in connections if c.way],
    }


def _values(mode: AssemblyMode) -> dict[str, Any]:
    return {
        "name": mode.name,
        "quaternion_wxyz": [float(c) for c in mode.quaternion],
        "translation": [float(c) for c in mode.translation],
        "coordinates": dict(mode.values),
        "residual": mode.residual,
        "smallest_singular_value": mode.smallest,
        "margin": mode.volume,
        "signs": dict(mode.signs),
        "certified": mode.certified,
        "radius": mode.radius,
        "exact": mode.exact,
        "meeting": mode.meeting,
        "paths": mode.paths,
        "curve": mode.curve,
        "ways": mode.ways,
    }
