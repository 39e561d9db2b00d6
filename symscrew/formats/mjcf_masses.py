"""What an MJCF's compiler makes of all masses: least ones, balanced moments, and a total.

    boundmass, boundinertia: the least of each    balanceinertia: moments that break a + b >= c become their mean
    settotalmass: all masses and inertias times one factor

Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symscrew.formats.draft import Draft, RawBody
from symscrew.formats.mjcf_settings import Settings
from symscrew.formats.physical_inertias import impossible, turned_moments
from symscrew.formats.rigid_displacements import ZERO, Triple, real, scaled


def settle_masses(draft: Draft, settings: Settings, bare: Mapping[str, Triple]) -> None:
    """Apply these settings to the draft's bodies; the ledger says how many each of them changed.

    `bare`: body of the file -> where its least mass is if it has none of its own; other bodies, between several joints
    of one, have no mass in the file.
    """
    bodies = [_bounded(draft, body, settings, bare[body.name]) if body.name in bare else body for body in draft.bodies]
    total = sum((body.mass for body in bodies if body.mass is not None), start=ZERO[0])
    if settings.total_mass > 0 and total > 0:
        factor = settings.total_mass / total
        bodies = [_times(body, factor) for body in bodies]
        draft.ledger.turned("settotalmass: all masses and inertias times one factor")
    draft.bodies = bodies


def _bounded(draft: Draft, body: RawBody, settings: Settings, place: Triple) -> RawBody:
    mass, least = settings.least_mass, settings.least_inertia
    if body.mass is None or body.com is None or body.inertia is None:
        if not mass and not least:
            return body
        body = RawBody(body.name, real(0), place, (ZERO, ZERO, ZERO))
    assert body.mass is not None and body.inertia is not None
    if mass and body.mass is not None and body.mass < mass:
        body = replace(body, mass=mass)
        draft.ledger.turned("boundmass")
    if least:
        raised = turned_moments(body, lambda a, b, c: (max(a, least), max(b, least), max(c, least)))
        if raised != body:
            draft.ledger.turned("boundinertia")
        body = raised
    if settings.balanced and impossible(body):
        body = turned_moments(body, lambda a, b, c: ((a + b + c) / 3,) * 3)
        draft.ledger.turned("balanceinertia")
    return body


def _times(body: RawBody, factor: object) -> RawBody:
    if body.mass is None or body.inertia is None:
        return body
    x, y, z = (scaled(row, factor) for row in body.inertia)
    return replace(body, mass=body.mass * factor, inertia=(x, y, z))
