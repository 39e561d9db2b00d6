"""The mobility of a mechanism: the pipeline, and its result.

    Mechanism --joint_network--> Network --configuration--> the configuration that is asked for
              --instantaneous--> freedoms, limbs, platform --finite--> real motions
              --rank_evidence--> how every rank was decided

Formulas, redundant constraints and singularities are found when they are first looked at.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from symscrew.description import Mechanism
from symscrew.mobility.configuration import displaced, with_parameters
from symscrew.mobility.finite import FiniteMobility, finite_mobility
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
from symscrew.mobility.overconstraint import Overconstraints, overconstraints
from symscrew.mobility.rank_evidence import Decisions, NumericRanks, decide, nearly_parallel
from symscrew.mobility.screw_systems import ScrewSystem
from symscrew.mobility.screw_text import describe_twist, describe_wrench
from symscrew.mobility.singularities import Singularities, singularities
from symscrew.mobility.symbols import (
    LimbPose,
    Locus,
    NotPolynomialError,
    SymbolicLoops,
    SymbolicMobility,
    limb_pose,
    symbolic_loops,
    symbolic_mobility,
    symbolic_screws,
)


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
        constraints: their union; None without limbs or platform.
        decisions: how every rank was decided.
        closed_to: closure residual of the configuration, in units of the mechanism's size.
        coordinates: joint coordinates that were asked for [rad, m].
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

    def __repr__(self) -> str:
        finite = "not decided" if self.finite.dof is None else self.finite.dof
        return (
            f"<Mobility of {self.mechanism.name}: {self.dof} instantaneous, {finite} finite, "
            f"{self.platform.body} {self.platform.type}, {self.overconstraints} redundant constraints>"
        )

    @property
    def in_reference(self) -> bool:
        """Whether no joint coordinate was given."""
        return not self.coordinates

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
        return symbolic_mobility(self.mechanism) if self.in_reference else None

    @cached_property
    def without_symbols(self) -> str | None:
        """Why there are no symbols for the limbs; None where there are, or no limbs."""
        if not self.limbs or self.mechanism.platform is None or self.symbolic is not None:
            return None
        if not self.in_reference:
            return "symbols describe the reference configuration only"
        try:
            symbolic_screws(self.mechanism)
        except NotPolynomialError as error:
            return f"no symbols: {error}"
        return "no symbols: the closed forms are not of reasonable size"

    @cached_property
    def loops(self) -> SymbolicLoops | str:
        """Joint rates and freedoms in the parameters for a mechanism without limbs, or why they are not given."""
        if not self.in_reference:
            return "no symbols away from the reference configuration"
        if not self.network.chords:
            return "no loops"
        return symbolic_loops(self.mechanism, self.platform.body)

    @cached_property
    def limb_poses(self) -> dict[str, LimbPose | str]:
        """Limb -> its constraints in symbols for the displacements of its own joints, or why they are not given."""
        return {limb.name: limb_pose(self.mechanism, limb.name) for limb in self.limbs if limb.constraints.basis}

    @cached_property
    def redundant(self) -> Overconstraints:
        """Self-stresses: joints whose reactions are not unique, and how to remove the redundancy."""
        return overconstraints(self.network, self.first_order)

    @cached_property
    def singularities(self) -> Singularities:
        """Margins from limb, constraint and actuation singularities, and actuation loci in the parameters."""
        return singularities(self.mechanism, self.coordinates)

    @property
    def not_tried(self) -> tuple[str, ...]:
        """What was given up or left out because of its size, a sentence each; empty for most mechanisms."""
        loops = () if self.limbs or isinstance(self.loops, str) else self.loops.not_tried
        poses = (pose for pose in self.limb_poses.values() if not isinstance(pose, str))
        return (*loops, *(text for pose in poses for text in pose.not_tried), *self.singularities.not_tried)

    @property
    def loci(self) -> tuple[Locus, ...]:
        """Where, in the parameters, something degenerates in the reference configuration."""
        loops = () if self.limbs or isinstance(self.loops, str) else self.loops.loci
        return (*(self.symbolic.loci if self.symbolic is not None else ()), *loops, *self.singularities.loci)

    def report(self) -> str:
        """The result in words, one line a fact."""
        lines = [
            f"{self.mechanism.name}: mobility {self.dof} in the reference configuration "
            f"(Kutzbach-Gruebler {self.kutzbach}, redundant constraints {self.overconstraints})"
        ]
        for limb in self.limbs:
            lines.append(f"{limb.name}: {len(limb.screws)} joint freedoms, {len(limb.constraints.basis)} constraints")
            lines += [f"    {describe_wrench(w)}" for w in limb.constraints.basis]
        if self.constraints is not None and self.freedoms is not None:
            lines.append(
                f"{self.mechanism.platform}: constraint system of rank {self.constraints.rank}, "
                f"{len(self.freedoms.basis)} freedoms"
            )
            lines += [f"    {describe_twist(t)}" for t in self.freedoms.basis]
        lines.append(self.method)
        return "\n".join(lines)


def analyse_mobility(mechanism: Mechanism, *, body: str | None = None, at: Mapping[str, Any] | None = None) -> Mobility:
    """Mobility of the mechanism in its reference configuration, or in the one that `at` says.

    Args:
        mechanism: any mechanism; loops are found from its graph.
        body: whose freedoms to report; default the platform, without one the body farthest from the ground.
        at: values of parameters, and of joint coordinates (`joint`, `joint.i`; [rad], [m]) that the loops are
            assembled to from the reference configuration.

    Raises:
        DescriptionError: unknown body, parameter or coordinate, or no assembly there.

    >>> from symscrew import catalogue
    >>> found = analyse_mobility(catalogue.load("bennett"))
    >>> found.dof, found.kutzbach, found.finite.dof
    (1, -2, 1)
    """
    mechanism, coordinates = with_parameters(mechanism, at or {})
    network, residual = displaced(mechanism, network_of(mechanism), coordinates)
    first_order = instantaneous_mobility(network)
    limbs = tuple(limb_mobility(network, name, limb.joints) for name, limb in mechanism.limbs.items())
    platform = body_freedoms(network, first_order, body or moved_body(mechanism))
    constraints = limb_constraints(limbs, network.length) if limbs and mechanism.platform is not None else None
    ranks = NumericRanks(network, first_order, platform, limbs, constraints)
    decisions = decide(mechanism, ranks, displaced=bool(coordinates))
    return Mobility(
        mechanism,
        network,
        first_order,
        finite_mobility(network),
        platform,
        limbs,
        constraints,
        decisions,
        residual,
        coordinates,
    )
