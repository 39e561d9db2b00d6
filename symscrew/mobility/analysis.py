"""The mobility of a mechanism: the pipeline, and its result.

    Mechanism --joint_network--> Network --configuration--> the configuration that is asked for
              --instantaneous--> freedoms, limbs, platform --finite--> real motions
              --rank_evidence--> how every rank was decided

Formulas, redundant constraints and singularities are found when they are first looked at.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from symscrew import notebook
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.kinds import public
from symscrew.mobility.almost_singular import NEARLY_SINGULAR, almost_lower, almost_singular, left_open
from symscrew.mobility.carrying_limbs import carried_by_limbs
from symscrew.mobility.configuration import Reached, displaced, in_words, with_parameters
from symscrew.mobility.field_counts import FieldCounts, field_counts
from symscrew.mobility.finite import (
    FiniteMobility,
    NearGeometry,
    lone_pairs,
    rank_claims,
    search_special,
    undriven_freedoms,
)
from symscrew.mobility.instantaneous import (  # fmt: skip
    BodyFreedoms,
    Instantaneous,
    LimbMobility,
    body_freedoms,
    instantaneous_mobility,
    limb_constraints,
    limb_mobility,
    moved_body,
)
from symscrew.mobility.joint_network import Network, network_of
from symscrew.mobility.margin_ranks import Ranks, with_rank
from symscrew.mobility.motion_verdicts import confirmed, judged, why_complete, with_proof
from symscrew.mobility.motions import BranchTable, WholeMotion, branches_through, motion_along
from symscrew.mobility.overconstraint import Overconstraints, overconstraints
from symscrew.mobility.proofs import Evidence, MotionProof, gathered, motion_proof
from symscrew.mobility.rank_evidence import Decisions, NumericRanks, decide, nearly_parallel, singular_values
from symscrew.mobility.screw_systems import ScrewSystem
from symscrew.mobility.screw_text import describe_twist, describe_wrench
from symscrew.mobility.singularities import Singularities, singularities
from symscrew.mobility.symbols import (
    LimbPose,
    Locus,
    SymbolicLoops,
    SymbolicMobility,
    SymbolicScrews,
    conditions,
    limb_pose,
    rounded_axis,
    screws_of_limbs,
    symbolic_loops,
    symbolic_mobility,
    why_no_symbols,
)
from symscrew.mobility.withheld import AS_MEANT, IN_SYMBOLS, NOT_ALONE, SOLVED_FOR, TIED, WITHDRAWN


@dataclass(frozen=True)
class Mobility:
    """Mobility of a mechanism in one configuration.

    Attributes:
        mechanism: with the parameters that were asked for.
        network: its graph with the screws of this configuration, lengths in units of its size.
        first_order: the null space of the closure.
        finite: what really moves.
        platform: freedoms of the platform, or of the body that was asked for.
        limbs: constraints of each limb of the description.
        constraints: their union; None where it is not limbs alone that carry the platform.
        decisions: how every rank was decided.
        closed_to: closure residual of the configuration, in units of the mechanism's size.
        coordinates: joint coordinates and poses that were asked for [rad, m].
        parameters: values of parameters that were asked for.
        withdrawn: statements whose check failed (keys of `WITHDRAWN`); they are not made.
        taken: this is special geometry, taken for the one typed; None for what was typed itself.
        reached: the configuration with every coordinate's value there.
    """

    mechanism: Mechanism
    network: Network
    first_order: Instantaneous
    finite: FiniteMobility
    platform: BodyFreedoms
    limbs: tuple[LimbMobility, ...]
    constraints: ScrewSystem | None
    decisions: Decisions
    closed_to: float = 0.0
    coordinates: Mapping[str, Any] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)
    withdrawn: frozenset[str] = frozenset()
    taken: Taken | None = None
    reached: Reached | None = None

    def __repr__(self) -> str:
        finite = "not decided" if self.finite.dof is None else self.finite.dof
        return (
            f"<Mobility of {self.mechanism.name}: {self.dof} instantaneous, {finite} finite, "
            f"{self.platform.body} {self.platform.motion_type}, {self.overconstraints} redundant constraints>"
        )

    def without(self, statements: Set[str]) -> Mobility:
        """The result without the named statements (keys of `WITHDRAWN`): they are withheld, with the reason."""
        finite = self.finite
        if "finite" in statements:
            evidence = (WITHDRAWN["finite"], *finite.evidence)
            finite = FiniteMobility(None, False, None, "undecided", evidence, False)
        return replace(self, finite=finite, withdrawn=self.withdrawn | statements)

    @property
    def in_reference(self) -> bool:
        """Whether no joint coordinate was given."""
        return not self.coordinates

    @property
    def configuration(self) -> str:
        """Which configuration and which parameters, in words."""
        return in_words(self.coordinates, self.parameters)

    @property
    def verdict(self) -> tuple[object, ...]:
        """What it says in numbers: freedoms, branches, the platform's type, what drives hold, what limbs constrain."""
        finite, limbs = self.finite, tuple(len(limb.constraints.basis) for limb in self.limbs)
        real = (finite.dof, finite.smooth, finite.branches)
        return (self.dof, *real, self.platform.dof, self.platform.type, self.dof_drives_locked, limbs)

    @cached_property
    def near(self) -> Near | None:
        """The verdict on special geometry close to what was typed; None where there is none, or it is undecided."""
        least = self.finite.dof or 0
        judged = [(meant, one) for meant, one in self._beside if (meant.finite.dof or 0) >= least or one.tells]
        best = max(judged, key=lambda pair: (pair[0].finite.dof or 0, -pair[1].distance), default=None)
        if best is None or best[0].dof < self.dof or best[0].finite.dof is None or best[0].verdict == self.verdict:
            return None
        meant, one = best
        return Near(meant, *one.in_metres(float(self.network.length)))

    @cached_property
    def _searched(self) -> tuple[NearGeometry, ...] | str:
        """Special geometry close to what was typed, or why it is not known."""
        loops = replace(self.network, ties=())  # special geometry is theirs; couplings hold there, too
        claims = rank_claims(loops, self.platform.body, [limb.joints for limb in self.limbs])
        return () if self.taken is not None else search_special(loops, claims, moves=self.finite.smooth)

    @cached_property
    def _beside(self) -> tuple[tuple[Mobility, NearGeometry], ...]:
        """Special geometry close to what was typed, each with the result for it."""
        found = () if isinstance(self._searched, str) else self._searched
        return tuple((self._meant(replace(one.network, ties=self.network.ties)), one) for one in found)

    def _meant(self, network: Network) -> Mobility:
        """The result for special geometry that was solved for."""
        first_order = instantaneous_mobility(network)
        limbs = tuple(limb_mobility(network, limb.name, limb.joints) for limb in self.limbs)
        platform = body_freedoms(network, first_order, self.platform.body)
        constraints = limb_constraints(limbs, network.length) if self.constraints is not None else None
        decisions = Decisions(None, (), SOLVED_FOR, singular_values(first_order))
        finite = judged(network, first_order, decisions)
        return Mobility(self.mechanism, network, first_order, finite, platform, limbs, constraints, decisions, 0.0,
                        self.coordinates, self.parameters, IN_SYMBOLS, reached=self.reached)  # fmt: skip

    @property
    def nearly_special(self) -> tuple[str, ...]:
        """Ranks of the platform's type and of the drives' hold that are almost lower; empty where `near` tells more."""
        return () if self.near is not None else almost_lower(self.network, self.first_order, self.platform)

    @property
    def nearly_singular(self) -> str:
        """That the closure almost loses rank, in words; empty where it does not, or where `near` says what is there."""
        kept = self.decisions.singular_values[0]
        return "" if kept > NEARLY_SINGULAR or self.near is not None else almost_singular(self.network, kept)

    @property
    def method(self) -> str:
        """`exact` or `certified numeric`, with the evidence."""
        closed = "" if self.in_reference else f"; loops assembled to {self.closed_to:.0e}"
        return self.decisions.method + closed

    @cached_property
    def nearly_parallel(self) -> tuple[str, ...]:
        """Joints whose axes are almost parallel, which is not parallel, in words."""
        return nearly_parallel(self.network)

    @property
    def dof(self) -> int:
        """Instantaneous mobility of the whole: number of joint freedoms - rank of the closure."""
        return self.first_order.dof

    @property
    def kutzbach(self) -> int:
        """Kutzbach-Gruebler's count: number of joint freedoms - 6 per independent loop."""
        return self.first_order.kutzbach

    @property
    def overconstraints(self) -> int:
        """Number of redundant constraints, 6 per loop - rank = dof - kutzbach."""
        return self.first_order.overconstraints

    @property
    def internal_freedoms(self) -> int:
        """Instantaneous freedoms with the platform at rest."""
        return self.dof - self.platform.dof

    @property
    def dof_drives_locked(self) -> int | None:
        """Instantaneous freedoms that are left with all drives locked; None without drives."""
        return self.first_order.dof_drives_locked

    @property
    def freedoms(self) -> ScrewSystem | None:
        """The platform's freedoms; None for a mechanism without limbs or platform."""
        return self.platform.freedoms if self.limbs and self.mechanism.platform is not None else None

    @cached_property
    def symbolic(self) -> SymbolicMobility | None:
        """Constraints and freedoms in the parameters, and where they degenerate; None where not available.

        Symbols describe the reference configuration.
        """
        if not self.in_reference or "symbols" in self.withdrawn or self.network.ties:
            return None
        return symbolic_mobility(self.mechanism, work=self._screws)

    @cached_property
    def _screws(self) -> SymbolicScrews | None:
        """Limbs' screws and reciprocals in symbols, found once for them and the drives; None without a ring."""
        return screws_of_limbs(self.mechanism)

    @cached_property
    def without_symbols(self) -> str | None:
        """Why there are no symbols for limbs or platform; None where there are, or no limbs."""
        if not self.limbs or self.mechanism.platform is None or self.symbolic is not None:
            return NOT_ALONE if self.symbolic is not None and self.constraints is None else None
        if not self.in_reference:
            return "symbols describe the reference configuration only"
        if self.network.ties or self.taken is not None:
            return TIED if self.network.ties else AS_MEANT
        return WITHDRAWN["symbols"] if "symbols" in self.withdrawn else why_no_symbols(self.mechanism)

    @cached_property
    def loops(self) -> SymbolicLoops | str:
        """Joint rates and freedoms in the parameters for a mechanism without limbs, or why they are not given."""
        if not self.in_reference:
            return "no symbols away from the reference configuration"
        if not self.network.chords:
            return "no loops"
        if self.network.ties:
            return TIED
        if "loops" in self.withdrawn:
            return WITHDRAWN["loops"] if self.taken is None else AS_MEANT
        if rounded := rounded_axis(self.mechanism.joints.values(), self.mechanism):
            return rounded
        return symbolic_loops(self.mechanism, self.platform.body)

    @cached_property
    def limb_poses(self) -> dict[str, LimbPose | str]:
        """Limb -> its constraints in symbols for the displacements of its own joints, or why they are not given."""
        named = [limb.name for limb in self.limbs if limb.constraints.basis]
        if "poses" in self.withdrawn:
            return dict.fromkeys(named, WITHDRAWN["poses"] if self.taken is None else AS_MEANT)
        return {name: limb_pose(self.mechanism, name) for name in named}

    @cached_property
    def branches(self) -> BranchTable | None:
        """What moves along each branch through the configuration; None where the finite mobility is not decided."""
        if self.finite.dof is None or "branches" in self.withdrawn:
            return None
        proof = None if self.finite.smooth and self.finite.proved else self.motion_proof  # one branch, as is proved
        complete = why_complete(self.finite, proof)
        table = branches_through(self.network, self.finite, self.platform.body, complete=complete)
        return with_proof(table, self.finite, proof)

    @cached_property
    def along(self) -> WholeMotion | str:
        """What holds along the coordinate lines through the configuration, with singular poses. May take seconds."""
        found = motion_along(self.network, self.finite, self.platform, self.mechanism, exact=self.decisions.all_exact)
        if isinstance(found, str) or not found.idle or not self.in_reference:
            return found
        still = analyse_mobility(found.locked(self.mechanism), body=self.platform.body)
        bounded = self.finite.proved or (self.decisions.closure_exact and self.dof == still.finite.dof)
        same = bounded and still.finite.proved and still.finite.dof == self.finite.dof
        return found.at_rest(still.mechanism, still.network, self.platform.body) if same else found

    @cached_property
    def motion_proof(self) -> MotionProof | None:
        """What is proved of the real motion, by evidence that a checker can judge; None where it is not as a whole."""
        return motion_proof(*self.evidence) if self.in_reference else None

    @cached_property
    def evidence(self) -> Evidence:
        """What a proof file has to show: exact numbers of the description, and a proof for the motion of every part."""
        return gathered(self.mechanism, self.network, self.platform.body)

    @cached_property
    def counts(self) -> FieldCounts:
        """The counts of the field: Kutzbach and modified, Gogu's, groups of the loops, Waldron's orders."""
        found = (self.network, self.first_order, self.platform, self.limbs)
        return field_counts(*found, carried=self.constraints is not None)

    @cached_property
    def redundant(self) -> Overconstraints:
        """Self-stresses: joints whose reactions are not unique, and how to remove the redundancy."""
        return overconstraints(self.network, self.first_order)

    @cached_property
    def singularities(self) -> Singularities:
        """Margins from limb, constraint and actuation singularities, and actuation loci in the parameters."""
        reached, work = (None, self._screws) if self.in_reference else (self.reached, None)
        found = singularities(self.mechanism, reached, work=work)
        if found.margins is None or "margins" in self.withdrawn:
            return replace(found, margins=None, unknown=found.unknown or WITHDRAWN["margins"])
        without, kept, finite = self.dof - len(self.network.driven), self.decisions.singular_values[0], self.finite
        almost = kept if kept < NEARLY_SINGULAR else None
        fewer = (self.dof, finite.dof) if finite.dof is not None and finite.dof < self.dof else None
        known = (undriven_freedoms(self.network), lone_pairs(self.network), finite.smooth, almost, fewer, without)
        ranks = Ranks(self.limbs, self.dof_drives_locked, *known)
        return replace(found, margins=tuple(with_rank(margin, ranks) for margin in found.margins))

    @property
    def not_tried(self) -> tuple[str, ...]:
        """What was given up or left out because of its size, a sentence each; empty for most mechanisms."""
        loops = () if self.limbs or isinstance(self.loops, str) else self.loops.not_tried
        poses = (pose for pose in self.limb_poses.values() if not isinstance(pose, str))
        limbs = self.symbolic.not_tried if self.symbolic is not None else ()
        texts = [*loops, *limbs, *(text for pose in poses for text in pose.not_tried), *self.singularities.not_tried]
        named = None if self.near is None else self.near.meant.finite
        beside = [(meant.finite, one) for meant, one in self._beside]
        return (*left_open(self._searched, beside, self.finite, named, length=float(self.network.length)), *texts)

    @property
    def loci(self) -> tuple[Locus, ...]:
        """Where, in the parameters, something degenerates in the reference configuration."""
        loops = () if self.limbs or isinstance(self.loops, str) else self.loops.loci
        limbs = () if self.symbolic is None else self.symbolic.loci
        return conditions((*limbs, *loops, *self.singularities.loci))

    def _repr_html_(self) -> str:
        return notebook.lines(self.mechanism.name, self.report().splitlines())

    def report(self) -> str:
        """The result in words, one line a fact."""
        lines = [
            f"{self.mechanism.name}: mobility {self.dof} {self.configuration} "
            f"(Kutzbach-Gruebler {self.kutzbach}, redundant constraints {self.overconstraints})"
        ]
        for limb in self.limbs:
            lines.append(f"{limb.name}: {len(limb.screws)} joint freedoms, {len(limb.constraints.basis)} constraints")
            lines += [f"    {describe_wrench(w)}" for w in limb.constraints.basis]
        if self.constraints is not None and self.freedoms is not None:
            rank, free = self.constraints.rank, len(self.freedoms.basis)
            lines.append(f"{self.mechanism.platform}: constraint system of rank {rank}, {free} freedoms")
            lines += [f"    {describe_twist(t)}" for t in self.freedoms.basis]
        lines.append(self.method)
        return "\n".join(lines)


@dataclass(frozen=True)
class Near:
    """Special geometry close to the one typed.

    `meant`: the result for it, found in 60 digits; `distance`: the largest change of a place, or of an axis times the
    mechanism's size [m]; `changes`: the change of every joint [m], the largest first.
    """

    meant: Mobility
    distance: float
    changes: tuple[tuple[str, float], ...]

    def places(self) -> dict[str, tuple[tuple[str, ...], tuple[tuple[str, ...], ...], str | None]]:
        """Joint -> (point [m], axes, pitch [m/rad]) of the special geometry in 40 digits: what to type instead."""
        return {name: self.meant.network.edges[name].as_typed(self.meant.network.length) for name, _ in self.changes}


@dataclass(frozen=True)
class Taken:
    """What was typed, where special geometry within `tolerance` [m] of it is taken instead."""

    typed: Mobility
    distance: float
    tolerance: float


def as_meant(typed: Mobility, tolerance: float) -> Mobility:
    """The result for the special geometry within `tolerance` [m] of the one typed; without such, the result as typed.

    Raises:
        DescriptionError: the tolerance is no positive length.
    """
    if not 0 < tolerance < float("inf"):
        raise DescriptionError(f"tolerance: expected a positive length [m], got {tolerance:g}")
    near = typed.near
    if near is None or near.distance > tolerance:
        return typed
    return replace(near.meant, taken=Taken(typed, near.distance, tolerance))


@public("analyse_mobility")
def analyse_mobility(
    mechanism: Mechanism,
    *,
    body: str | None = None,
    at: Mapping[str, Any] | None = None,
    tolerance: float | None = None,
) -> Mobility:
    """Mobility of the mechanism in its reference configuration, or in the one that `at` says.

    Args:
        mechanism: any mechanism; loops are found from its graph.
        body: whose freedoms to report; default the platform, without one the body farthest from the ground.
        at: values of parameters, and of coordinates (`joint`, `joint.i`, `platform.z`, `tilt` ...: the names are those
            of `symscrew.kinematics.coordinate_names`) that the loops are assembled to from the reference configuration;
            numbers [rad, m], or texts with a unit such as "10mm", "30deg".
        tolerance: special geometry within this of the one typed [m; axes times the size] is meant (`Mobility.taken`).

    Raises:
        DescriptionError: unknown body, parameter or coordinate, no assembly there, or a tolerance that is no length.

    >>> from symscrew import catalogue
    >>> found = analyse_mobility(catalogue.load("bennett"))
    >>> found.dof, found.kutzbach, found.finite.dof
    (1, -2, 1)
    """
    mechanism, coordinates = with_parameters(mechanism, at or {})
    parameters = {name: value for name, value in (at or {}).items() if name not in coordinates}
    reached = displaced(mechanism, network_of(mechanism), coordinates)
    network = reached.network
    first_order = instantaneous_mobility(network)
    limbs = tuple(limb_mobility(network, name, limb.joints) for name, limb in mechanism.limbs.items())
    platform = body_freedoms(network, first_order, body or moved_body(mechanism))
    constraints = limb_constraints(limbs, network.length) if carried_by_limbs(mechanism) else None
    ranks = NumericRanks(network, first_order, platform, limbs, constraints)
    decisions = decide(mechanism, ranks, displaced=bool(coordinates))
    finite = judged(network, first_order, decisions)
    found = Mobility(mechanism, network, first_order, finite, platform, limbs, constraints, decisions,
                     reached.closed_to, coordinates, parameters, reached=reached)  # fmt: skip
    if not coordinates and not finite.proved:
        kept = {"motion_proof": found.motion_proof, "evidence": found.evidence}  # which do not rest on the judgement
        vars(found := replace(found, finite=confirmed(network, finite, found.motion_proof))).update(kept)
    return found if tolerance is None else as_meant(found, tolerance)
