"""Why loops of a file close in no pose, and what would close them: each alone, and with what the file may mean.

Gepetto's files say with a word for every loop whether its frames meet in place (3d) or in turning as well (6d, also
where nothing is said), and name the joints that are balls though a URDF has turns there. A word that is missing leaves
a loop that cannot close.

    draft, loops --> joints and loops that close, where one meaning does or is asked for; else a sentence for the error
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from symscrew.errors import shorten
from symscrew.formats.closed_pose import CLOSED, STARTS, Loop, Tree, closed_displacements, open_alone
from symscrew.formats.draft import Draft, RawJoint

BALLS = "spherical"
"""Part of the name of joints that are balls, as the tool that writes Gepetto's files takes them."""
NAMED = 3
"""Loops and joints that are named; of more their number is said."""


@dataclass(frozen=True)
class Cure:
    """What closes all loops: joints and loops in place of the file's, in short words for an error and in full."""

    joints: Sequence[RawJoint]
    loops: Sequence[Loop]
    short: str
    full: str


@dataclass(frozen=True)
class Contradiction:
    """Loops that no start closes: by how much they stay open alone, and what closes all, the least change first."""

    gaps: Mapping[int, float]
    cures: Sequence[Cure]

    @classmethod
    def of(cls, draft: Draft, loops: Sequence[Loop]) -> Contradiction:
        """What is known of such loops."""
        gaps = open_alone(Tree.of(draft, loops))
        return cls(gaps, list(_cures(draft, loops, gaps)))

    def cure(self, loosen: bool) -> Cure | None:
        """The only thing that closes the loops if the file means it; of several the first where `loosen` says so."""
        return self.cures[0] if self.cures and (loosen or len(self.cures) == 1) else None

    def said(self) -> str:
        """Which loops do not close alone, which changes of the file close all."""
        said = []
        if self.gaps:
            least = [f"loop 'closing_{k + 1}' {gap:.3g}" for k, gap in self.gaps.items()]
            said.append(f"alone, too, the best of {STARTS} starts leave open [m, rad]: {_some(least)}")
        cures = [f"{cure.short} all loops close" for cure in self.cures]
        return "; ".join([*said, *cures, *(["take the first of these with --loosen"] if cures else [])])


def _cures(draft: Draft, loops: Sequence[Loop], gaps: Mapping[int, float]) -> Iterator[Cure]:
    held = [k for k, (*_, turning) in enumerate(loops) if turning]
    for loose in ([k for k in held if k in gaps], held):  # the fewest first
        places = [(one, other, turning and k not in loose) for k, (one, other, turning) in enumerate(loops)]
        if loose and _closes(draft, places):
            named = [f"closing_{k + 1}" for k in loose]
            said = "with type 3d in place of 6d for"
            yield Cure(draft.joints, places, f"{said} {_some(named)}", f"{said} {', '.join(named)}")
            break
    balls = [joint.name for joint in draft.joints if BALLS in joint.name and joint.type == "R"]
    changed = [replace(j, type="S", axes=(), driven=()) if j.name in balls else j for j in draft.joints]
    if balls and _closes(replace(draft, joints=changed), loops):
        some = f"joint_name: [{', '.join(balls[:NAMED])}{', ...' if balls[NAMED:] else ''}]"
        said = f"with joint_type SPHERICAL for the {len(balls)} turns called {BALLS!r}"
        yield Cure(changed, loops, f"{said} ({shorten(some)})", f"{said}: {', '.join(balls)}")


def _closes(draft: Draft, loops: Sequence[Loop]) -> bool:
    return closed_displacements(Tree.of(draft, loops), 1)[1] <= CLOSED


def _some(names: Sequence[str]) -> str:
    more = f" and {len(names) - NAMED} more" if names[NAMED:] else ""
    return ", ".join(names[:NAMED]) + more
