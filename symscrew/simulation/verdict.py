"""Whether a run that came to its end is good: by a second run with other steps, by its energy and its loops.

run --another tolerance or step--> estimate of its error --energy, closure, doubts-->
    completed | accuracy not reached | not judged | failed
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from symscrew.kinematics import System
from symscrew.scene import Scene
from symscrew.simulation.recording import Estimate, History

# The second run is this much looser; where it differs by more than the tolerance, a third one is this much tighter and
# its difference is the estimate. Nearer to 1 both would make the same errors; farther, a looser one says less.
OTHER = 10.0
# Below the first all runs have the same local tolerances, those of rounding, and no difference; the second: a scene's.
TIGHTEST, LOOSEST = 3e-12, 0.1
# Loops that are open by more, without units, or energy out of balance by more than this part of what moves: the run is
# no motion of this mechanism, whatever its tolerance. Rounding leaves 1e-12, a tolerance of 1e-2 some 1e-2.
OPEN, UNBALANCED = 1e-9, 0.03
# Energy out of balance by more than this many tolerances, relative: rates are off by more than coordinates, by the
# number of swings, and energies by twice that.
RATES = 1e3
# Part of its way by which a run with a fixed step, which asks for no accuracy, may be off: with more it is another
# motion. Explicit Euler with a hundred steps a swing is off by exp(2 pi^2/100) - 1 = 0.22 after the first.
GROSS = 0.1
# The method that a run with a fixed step is compared with where this passes what inputs do in time: its steps do not.
ALL_SEEN = "dop853"
# Coordinates have a way each: a wheel that turns on does not hide what swings beside it. One that has gone less far,
# in rad or lengths, is measured by this, or by the longest way where that is shorter: of what hardly moves any part is
# gross.
SHORT_WAY = 0.1


def estimated(scene: Scene, system: System, found: History, run: Callable[[Scene], History]) -> Estimate:
    """The error of a run by others of the same scene: `run` integrates a scene.

    None is made of a run that did not come to its end, or that is not judged by it: see `doubts` in `verdict`.
    """
    choice = scene.integrator
    if not found.ok or found.doubts:
        return Estimate()
    budget = 4 * choice.most_steps
    if choice.step is not None and found.passing:  # and half of it may pass the same
        other = run(_with(scene, method=ALL_SEEN, step=None, most_steps=budget))
        return replace(_difference(system, found, other), other="steps that pass nothing of its inputs")
    if choice.step is not None:
        # steps end at outputs, knots and corners: half of a longer one would be the same steps
        taken = min(choice.step, scene.duration / max(found.counters.get("steps", 1.0), 1.0))
        other = run(_with(scene, step=taken / 2, most_steps=budget))
        return replace(_difference(system, found, other), other="half the step")
    looser, tighter = OTHER * max(choice.tolerance, TIGHTEST), choice.tolerance / OTHER
    first = Estimate()
    if looser <= LOOSEST:
        first = _difference(system, found, run(_with(scene, tolerance=looser, most_steps=budget)))
        if first.error <= choice.tolerance or tighter < TIGHTEST:
            return first
    return _difference(system, found, run(_with(scene, tolerance=tighter, most_steps=budget)))


def _with(scene: Scene, **choice: float | str | None) -> Scene:
    return replace(scene, integrator=replace(scene.integrator, **choice))  # type: ignore[arg-type]


def _difference(system: System, found: History, other: History) -> Estimate:
    count = min(len(found.t), len(other.t))
    units = np.array([system.length if c.kind == "length" else 1.0 for c in system.tree.q])
    off = np.abs((found.q[:count] - other.q[:count]) / units)
    apart = off.max(axis=1, initial=0.0)
    if not other.ok:
        return Estimate(float("inf"), stopped=other.status)
    early = float(apart[: max(2, count // 10)].max(initial=0.0))
    error = float(apart.max(initial=0.0))
    ways = np.abs((found.q - found.q[:1]) / units).max(axis=0, initial=0.0)
    ways = np.maximum(ways, min(SHORT_WAY, ways.max(initial=0.0)))
    part = float((off.max(axis=0, initial=0.0) / np.where(ways > 0, ways, np.inf)).max(initial=0.0))
    return Estimate(error, error / early if early > 0 else np.nan, part)


def verdict(
    scene: Scene, estimate: Estimate, opening: float, unbalanced: float, *, doubts: Sequence[str] = ()
) -> tuple[bool, str]:
    """Whether a run that came to its end is as accurate as asked for, and its status.

    Args:
        scene: with the tolerance; a fixed step asks for no accuracy, so that only gross errors count.
        estimate: of the run's error.
        opening: largest opening of the loops, without units.
        unbalanced: largest energy out of balance, as a part of the energies that were moved.
        doubts: what the integrator met that it has no treatment of.
    """
    if opening > OPEN:
        return False, f"failed: the loops are open by {opening:.2g} (lengths by the characteristic length)"
    fixed, tolerance = scene.integrator.step is not None, scene.integrator.tolerance
    if not fixed and unbalanced > max(UNBALANCED, RATES * min(tolerance, 1e-4)):
        return False, f"failed: the energy is out of balance by {unbalanced:.2g} of the energies moved"
    if doubts:
        return False, f"completed, not judged: {'; '.join(doubts)}"
    if estimate.error == float("inf"):
        text = f"the run with {estimate.other} to compare it with {estimate.stopped}"
        return False, f"completed, accuracy not reached: {text}"
    if fixed and estimate.part > GROSS:
        text = f"with {estimate.other} the motion is {estimate.error:.2g} off, {100 * estimate.part:.2g} % of its way"
        return False, f"completed, accuracy not reached: {text}; shorten the step"
    if fixed:
        return True, "completed"
    if np.isnan(estimate.error):
        return False, "completed, not judged: there is no other run to compare with"
    grown = f", and differences grew by a factor of {estimate.growth:.2g}" if estimate.growth > 1e3 else ""
    if estimate.error > tolerance:
        text = f"an error of about {estimate.error:.2g} is estimated, {tolerance:g} was asked for{grown}"
        return False, f"completed, accuracy not reached: {text}"
    if unbalanced > RATES * tolerance:
        text = f"the energy is out of balance by {unbalanced:.2g} of the energies moved"
        return False, f"completed, accuracy not reached: {text}{grown}"
    return True, "completed"
