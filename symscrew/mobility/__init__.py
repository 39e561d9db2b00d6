"""Mobility by reciprocal screws: instantaneous and finite, with the evidence for every rank, and margins.

    Mechanism --joint_network--> Network: a graph with a screw in 60 digits for every freedom
              --configuration--> the same, elsewhere: parameters and joint coordinates that were asked for
    Network   --screw_systems, instantaneous--> freedoms, constraints of limbs, overconstraint: self-stresses
    Mechanism --placing--> the configuration with some coordinates given, or which limb does not get there
              --finite/--> what really moves: smooth, isolated, or branches of some dimensions
              --field_counts--> Kutzbach, modified Kutzbach, Gogu, groups of loops, Waldron
              --rank_evidence--> every rank again over an exact field (symbols/), or why not
    Mechanism --symbols/--> screws, rates and degenerations in the parameters
    System    --margins/--> numbers of q that vanish at singularities --singularities--> their values
    all of it --analysis--> Mobility --findings/--> words, documents, JSON;  --checks--> every claim again
    Mobility  --motions/--> every branch: tangents, screw systems, joints at rest
    Mechanism --components/--> operation modes, components of the configuration space; component_study: in words
    Mobility  --assembly_ways--> assembly modes, and ways between them: certified, or sampled
    Mobility  --proofs/, proof_file--> a file of exact numbers that a checker judges alone

Away from these stands nothing: a stranger starts at `analysis`, whose last function is the pipeline.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.mobility.algebraic_branches import with_components, with_rechecked_parts
    from symscrew.mobility.analysis import Mobility, analyse_mobility
    from symscrew.mobility.assembly_ways import (
        Connections,
        connection_lines,
        connection_values,
        judged_connections,
        judged_modes,
    )
    from symscrew.mobility.checks import Check, verified, verify
    from symscrew.mobility.component_study import studied_components
    from symscrew.mobility.components import (
        ALGEBRA_PROGRAM,
        AllowedTime,
        NotAlgebraicError,
        algebra_answer,
        assembly_connections,
        regular_ways,
    )
    from symscrew.mobility.configuration import Reached, with_parameters
    from symscrew.mobility.findings import (
        formulas,
        key_figures,
        mathml,
        mobility_latex,
        mobility_markdown,
        mobility_page,
        mobility_text,
        mobility_values,
        sections,
        signs_ahead,
    )
    from symscrew.mobility.finite import ClosureVariety, moved, named_spins
    from symscrew.mobility.instantaneous import BodyFreedoms, LimbMobility
    from symscrew.mobility.joint_network import Edge, Network, network_of
    from symscrew.mobility.margins import FORMS, Margin, Margins, actuation_margins, constraint_margins, limb_margins
    from symscrew.mobility.motions import (
        BranchTable,
        Components,
        ScrewClass,
        WholeMotion,
        components_of,
        motion_lines,
        motion_values,
        screw_class,
    )
    from symscrew.mobility.placing import Configuration, inverse_kinematics
    from symscrew.mobility.pose_targets import read_coordinates, targets_of
    from symscrew.mobility.proof_file import mobility_proof, write_proof
    from symscrew.mobility.proofs import Verdict, check_proof, check_ways
    from symscrew.mobility.screw_systems import ScrewSystem
    from symscrew.mobility.symbols import (
        Exact,
        Field,
        NotDecidableError,
        condition,
        exact_system,
        exact_value,
        generator_itself,
    )

__all__ = [
    "ALGEBRA_PROGRAM",
    "FORMS",
    "AllowedTime",
    "BodyFreedoms",
    "BranchTable",
    "Check",
    "ClosureVariety",
    "Components",
    "Configuration",
    "Connections",
    "Edge",
    "Exact",
    "Field",
    "LimbMobility",
    "Margin",
    "Margins",
    "Mobility",
    "Network",
    "NotAlgebraicError",
    "NotDecidableError",
    "Reached",
    "ScrewClass",
    "ScrewSystem",
    "Verdict",
    "WholeMotion",
    "actuation_margins",
    "algebra_answer",
    "analyse_mobility",
    "assembly_connections",
    "check_proof",
    "check_ways",
    "components_of",
    "condition",
    "connection_lines",
    "connection_values",
    "constraint_margins",
    "exact_system",
    "exact_value",
    "formulas",
    "generator_itself",
    "inverse_kinematics",
    "judged_connections",
    "judged_modes",
    "key_figures",
    "limb_margins",
    "mathml",
    "mobility_latex",
    "mobility_markdown",
    "mobility_page",
    "mobility_proof",
    "mobility_text",
    "mobility_values",
    "motion_lines",
    "motion_values",
    "moved",
    "named_spins",
    "network_of",
    "read_coordinates",
    "regular_ways",
    "screw_class",
    "sections",
    "signs_ahead",
    "studied_components",
    "targets_of",
    "verified",
    "verify",
    "with_components",
    "with_parameters",
    "with_rechecked_parts",
    "write_proof",
]

__getattr__ = doors(__name__)
