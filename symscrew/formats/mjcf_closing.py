"""Loops of an MJCF that are open in its own pose, sites and relative poses that do not meet: joints that close them.

The engine pulls such loops together while it runs. A mechanism's reference configuration has them closed: hinges and
slides go the shortest way to where they are, and the ledger says how far.

    draft, equalities --closed_displacements--> draft, poses and sites where loops close
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symscrew.formats.assembled import assembled
from symscrew.formats.closed_pose import CLOSED, Tree, closed_displacements
from symscrew.formats.draft import Draft
from symscrew.formats.mjcf_loops import Placed, Tie
from symscrew.formats.rigid_displacements import Pose
from symscrew.formats.tree_freedoms import freedoms_of, ways_to

FARTHEST = 1e30
"""Gap [m] from which on doubles hold no squares of it that are worth an iteration; nothing real is as far apart."""
SINGLE = ("R", "P")
"""Joints that are moved: what others have as values refers to the place of their bodies."""


def where_they_close(draft: Draft, found: Sequence[Tie], placed: Placed) -> Placed:
    """Where bodies and sites are once the loops are closed, the draft with them; as they are where that is not found.

    Nor is it looked for where balls or free bodies would be carried along, or what a medium drags by its own axes.
    """
    if draft.drags or not all(tie.gap < FARTHEST for tie in found):
        return placed
    freedoms = [f for k, joint in enumerate(draft.joints) if joint.type in SINGLE for f in freedoms_of(k, joint)]
    ways = ways_to(draft, freedoms)
    turned = [joint for joint in draft.joints if joint.type not in (*SINGLE, "fixed") and ways[joint.parent]]
    if turned:
        return placed
    tree = Tree(freedoms, ways, [((tie.parent, tie.one), (tie.child, tie.other), tie.turning) for tie in found])
    q, gap = closed_displacements(tree)
    if gap > CLOSED:
        return placed
    by = assembled(draft, tree, q)

    def moved(body: str, pose: Pose) -> Pose:
        return by[body] @ pose if body in by else pose

    poses = {body: moved(body, pose) for body, pose in placed.poses.items()}
    return replace(placed, poses=poses, sites={n: (b, moved(b, pose)) for n, (b, pose) in placed.sites.items()})
