"""Finite against instantaneous mobility: the real motions through a configuration.

Near the configuration, the closure equations F(q) = 0 reduce to the reduced closure g(u) = 0: u are the
coordinates of the instantaneous motions (the null space of dF), and g are the components of F on the self-stresses
(the left null space), once the other equations are solved for the other coordinates (Lyapunov-Schmidt). The
mechanism really moves along g = 0. g starts with the quadratic forms that the screw brackets give (the second
order of the kinematic tangent cone, A. Müller, J. Mechanisms Robotics 8, 2016), and is analytic. So

- no redundant equation: the configuration space is smooth of the instantaneous dimension (implicit functions);
- g = 0 at random finite u, in 60 digits: it vanishes identically, smooth as well;
- one instantaneous motion and g(u) != 0: the zero is isolated, the freedom infinitesimal;
- a self-stress whose quadratic form is definite: isolated (prestress stability, Connelly and Whiteley);
- else the zeros of g on small spheres are found from many starts, followed inwards to the configuration, and
  each branch gets its dimension where it is smooth (`symscrew.mobility.branches`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from symscrew.algebra import CONTEXT
from symscrew.mobility.finite.branches import UndecidedError, find_branches
from symscrew.mobility.finite.independent_parts import blocks_of
from symscrew.mobility.finite.local_solutions import (  # fmt: skip
    Local,
    Trial,
    definite_stress,
    flatten,
    local_at,
    proved_definite,
    quadratic_forms,
    vanishes,
)
from symscrew.mobility.finite.passive_spins import without_spins
from symscrew.mobility.finite.tangent_cone import continued
from symscrew.mobility.finite.variety import DIGITS_60, Array, ClosureVariety
from symscrew.mobility.finite.witnesses import Witness
from symscrew.mobility.joint_network import Network
from symscrew.mobility.screw_systems import Screw, null_space

ORDERS = 6
"""Highest order of the kinematic tangent cone that is tried for a single motion. Known mechanisms stop at second to
fourth order; where none up to this one stops it, the finite displacement decides, and the evidence is that."""

ROUNDED = 1e-45
"""Residual of finite motions that is rounding of 60 digits, with all conditions; what is larger comes from the numbers:
of 30 digits, or of squares of what twelve digits leave."""
RESOLVED = 1e-8
"""Smallest singular value of the closure that counts with which finite motions are followed in double precision: below
it, Newton's method for the dependent coordinates amplifies rounding to more than a micrometre in a metre, and the
configuration is undecided. Above it the trials say themselves whether they converged."""


@dataclass(frozen=True)
class FiniteMobility:
    """The real motions through the configuration.

    `dof`: dimension of the configuration space here; `smooth`: it is a manifold of the instantaneous dimension;
    `branches`: the dimensions that branches through a singular configuration have, None where smooth; `kind`:
    `smooth`, `infinitesimal` (no real motion, some instantaneous), `singular` (one dimension, fewer than
    instantaneous or several branches), `kinematotropic` (branches of different dimension) or `undecided` (singular,
    `dof` None). `evidence` says how it was decided, `proved` whether without sampling; `witnesses` what can
    be checked again.
    """

    dof: int | None
    smooth: bool
    branches: tuple[int, ...] | None
    kind: str
    evidence: tuple[str, ...]
    proved: bool
    witnesses: tuple[Witness, ...] = ()

    def __repr__(self) -> str:
        return f"FiniteMobility({'not decided' if self.dof is None else self.dof}, {self.kind}, {self.judgement})"

    @property
    def judgement(self) -> str:
        """`proved`, `sampled`, or `undecided`."""
        return "undecided" if self.dof is None else "proved" if self.proved else "sampled"


def finite_mobility(network: Network) -> FiniteMobility:
    """Decides between smooth point, infinitesimal freedom and branches, block by block; see the module's text."""
    try:
        parts = [_block_mobility(block) for block in blocks_of(network)]
    except UndecidedError as error:
        return FiniteMobility(None, False, None, "undecided", (str(error),), False)
    smooth = all(part.smooth for part in parts)
    evidence = tuple(dict.fromkeys(text for part in parts for text in part.evidence))
    proved = all(part.proved for part in parts)
    witnesses = tuple(witness for part in parts for witness in part.witnesses)
    if smooth:
        return FiniteMobility(sum(part.dof or 0 for part in parts), True, None, "smooth", evidence, proved, witnesses)
    dimensions = {0}
    for part in parts:
        own = (part.branches or (0,)) if part.branches is not None else (part.dof or 0,)
        dimensions = {a + b for a in dimensions for b in own}
    branches = tuple(sorted(dimensions - {0}))
    return FiniteMobility(max(dimensions), False, branches, kind_of(branches), evidence, proved, witnesses)


def kind_of(branches: Sequence[int]) -> str:
    """The kind of a singular configuration by the dimensions of the branches through it."""
    if not branches:
        return "infinitesimal"
    return "kinematotropic" if len(branches) > 1 else "singular"


def _block_mobility(network: Network) -> FiniteMobility:
    rows = network.loop_rows()
    motions = null_space(rows, network.freedoms).basis
    dof = len(motions)
    if not rows:
        return _smooth(network, dof, "joints outside of loops move freely", proved=True)
    if dof == 0:
        return _smooth(network, 0, "no instantaneous motion, hence none", proved=True)
    if len(rows) == network.freedoms - dof:
        text = "the closure equations are independent, so that the configuration space is smooth (implicit functions)"
        return _smooth(network, dof, text, proved=True)
    slim, spins = without_spins(network)
    if spins:
        fewer = null_space(slim.loop_rows(), slim.freedoms).basis
        if len(fewer) + spins == dof:
            return _with_spins(_by_reduced_closure(slim, fewer, dof - spins), spins)
    return _by_reduced_closure(network, motions, dof)


def _with_spins(found: FiniteMobility, spins: int) -> FiniteMobility:
    """The result for the mechanism with its passive spins: every branch has them as well."""
    if not spins:
        return found
    text = f"{spins} passive spin{'s' * (spins > 1)} of links between spherical joints split off, exactly"
    branches = found.branches
    if branches is not None:
        branches = tuple(b + spins for b in branches) or (spins,)
    kind = found.kind if branches is None else kind_of(branches)
    return replace(found, dof=(found.dof or 0) + spins, branches=branches, kind=kind, evidence=(text, *found.evidence))


def _by_reduced_closure(network: Network, motions: Sequence[Screw], dof: int) -> FiniteMobility:
    coarse, fine = ClosureVariety(network), ClosureVariety(network, DIGITS_60)
    if not motions:
        return _smooth(network, 0, "no instantaneous motion but the spins", proved=True)
    here = local_at(coarse, np.zeros(coarse.columns), motions=motions)
    if here.gap[0] < RESOLVED:
        raise UndecidedError(
            f"the closure has a singular value of {here.gap[0]:.0e}, which is not zero as typed: finite motions in "
            "double precision do not tell it from zero, so nothing is concluded"
        )
    trials = [vanishes(coarse, fine, here, direction) for direction in flatten(here.dof)]
    if all(trial.closed for trial in trials):
        largest = max(trial.residual for trial in trials)
        if largest > ROUNDED:
            _confirmed_by_series(network, motions, largest)
        step = max(trial.step for trial in trials)
        along = "the instantaneous freedom" if dof == 1 else f"all {dof} instantaneous freedoms"
        return _smooth(
            network,
            dof,
            f"all loops close in 60 digits (residual {largest:.0e}) after {len(trials)} random finite motions "
            f"of size {step:g} along {along}: the redundant equations vanish identically",
            proved=False,
        )
    text = _missed(trials)
    if dof == 1:
        arc = continued(network, motions[0], ORDERS)
        if arc.order is not None and arc.obstruction < RESOLVED:
            raise UndecidedError(
                f"the one instantaneous motion stops at order {arc.order} by {arc.obstruction:.0e} only, which is not "
                "zero as typed: finite motions in double precision do not tell it from zero, so nothing is concluded"
            )
        if arc.order is not None:
            return _infinitesimal(
                network,
                f"the one instantaneous motion cannot be continued at order {arc.order} of the kinematic tangent cone "
                f"(screw brackets in 60 digits; a unit self-stress does work {arc.obstruction:.1e} there)",
            )
        if all(trial.closed or not trial.solved for trial in trials):
            raise UndecidedError(text)  # no residual was seen, so that nothing shows that the motion stops
        stopped = f"{text}; an analytic function of one variable that does not vanish has isolated zeros"
        return replace(_infinitesimal(network, stopped), proved=False)  # the motion was solved for in doubles
    forms = quadratic_forms(coarse, here)
    weights = definite_stress(forms)
    if weights is not None:
        pivot = proved_definite(network, motions, _about_origin(coarse, weights @ here.stresses))
        if pivot is not None:
            return _infinitesimal(
                network,
                "a self-stress has a positive definite quadratic form on the instantaneous motions (Cholesky in 60 "
                f"digits, smallest pivot {float(pivot):.1e}): no second-order motion, prestress stable",
            )
    return _singular(coarse, fine, here, forms, text=text)


def _confirmed_by_series(network: Network, motions: Sequence[Screw], largest: float) -> None:
    """Motions that close to less than numbers of 30 digits tell must not stop in their power series.

    Raises:
        UndecidedError: one does.
    """
    matrix = np.array(motions, dtype=object)
    for weights in flatten(len(motions)):
        arc = continued(network, np.array([CONTEXT.mpf(float(w)) for w in weights], dtype=object) @ matrix, ORDERS)
        if arc.order is not None:
            raise UndecidedError(
                f"finite motions close to {largest:.0e}, which is not rounding of 60 digits, and stop at order "
                f"{arc.order} of the kinematic tangent cone by {arc.obstruction:.0e}: not told from zero"
            )


def _missed(trials: Sequence[Trial]) -> str:
    """By how much finite motions failed to close, in words."""
    open_ = [trial for trial in trials if trial.solved and not trial.closed]
    if not open_:
        left = sum(1 for trial in trials if not trial.solved)
        return (
            f"{left} of {len(trials)} random finite motions could not be solved for the dependent coordinates, down to "
            f"a size of {min(trial.step for trial in trials):g}: it is not known whether the loops close along them"
        )
    worst = max(open_, key=lambda trial: trial.residual)
    return f"after a motion of size {worst.step:g} the redundant equations are off by {worst.residual:.1e}"


def _about_origin(variety: ClosureVariety, stress: Array) -> Array:
    """A self-stress for screws about the variety's centre as one for screws at O: m_O . omega + f . v_O."""
    centre = np.array([float(c) for c in variety.centre])
    loops = 6 * len(variety.network.chords)
    result: Array = stress[:loops].copy().reshape(-1, 6)
    # v_centre = v_O + omega x centre, so f . v_centre = f . v_O + omega . (centre x f)
    result[:, :3] += np.cross(centre, result[:, 3:])
    return np.concatenate([result.ravel(), stress[loops:]])


def _singular(coarse: ClosureVariety, fine: ClosureVariety, here: Local, forms: Array, *, text: str) -> FiniteMobility:
    found = find_branches(coarse, fine, here, forms)
    evidence = (text, *found.evidence)
    if not found.dimensions:
        return replace(_infinitesimal(coarse.network, ""), evidence=evidence, proved=False)
    kind = kind_of(found.dimensions)
    return FiniteMobility(max(found.dimensions), False, found.dimensions, kind, evidence, False, found.witnesses)


def _smooth(network: Network, dof: int, text: str, *, proved: bool) -> FiniteMobility:
    return FiniteMobility(dof, True, None, "smooth", (text,), proved, (Witness(network, "smooth", dof, dof),))


def smooth_mobility(network: Network, dof: int, text: str) -> FiniteMobility:
    """A smooth point by a proof that `text` names."""
    return _smooth(network, dof, text, proved=True)


def _infinitesimal(network: Network, text: str) -> FiniteMobility:
    return FiniteMobility(0, False, (), "infinitesimal", (text,), True, (Witness(network, "isolated", 0, 0),))
