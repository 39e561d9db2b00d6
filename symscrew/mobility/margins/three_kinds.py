"""How far a configuration is from a singularity of each of three kinds: numbers of q that vanish exactly there.

Limb (serial) singularity: the joint screws of a limb become dependent. Constraint singularity: the closure of
the loops loses rank, so that the mechanism gains a freedom whatever its drives do. Actuation singularity: with
the drives locked a freedom is left. C. Gosselin, J. Angeles, IEEE Trans. Robotics Autom. 6 (1990) 281-290 (limb
and actuation as types 1 and 2); D. Zlatanov, I. Bonev, C. Gosselin, IEEE ICRA 2002, 496-502 (constraint).

Every margin is a volume: a determinant of screws or wrenches with lengths divided by the characteristic length,
unit 1, a polynomial in coordinates, sines and cosines. It is finite everywhere, at the singularity too, because
nothing is divided. Where the matrix is square the determinant is signed, positive in the reference configuration,
and changes sign through a generic singularity. Where it is not (fewer than six screws, redundant joints or
drives), rank is lost on a set of two or more dimensions less than the configurations', which no number can pass
with a change of sign; the margin is then the squared volume, the sum of the squares of all maximal minors.

The kinds are kept apart: the rates that only one cut joint's rows know are eliminated with the wrenches
reciprocal to them (minors without their common factor), so that the platform's determinants do not vanish where
only a limb is singular. Which entries, rows and columns are zero is read from the sample states: on the closure
manifold, on the assembly branch of the reference configuration.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from math import comb
from typing import TypeVar

import numpy as np

from symscrew.algebra import NEGLIGIBLE, Node, TooLargeError, Volume
from symscrew.kinematics import System
from symscrew.mobility.margins.closure_grids import ClosureGrids
from symscrew.mobility.margins.limb_volumes import LONG, limb_freedoms, limb_volume

MOST_SUBSETS = 20
"""Sets of just enough drives that get a margin (and loci) each: 20 are three of six drives.

Up to it every set is looked at; beyond it only all drives together, because the number of functions would grow as a
binomial coefficient. What is left out is said (`drive_sets`)."""

T = TypeVar("T")

FORMS = {
    "signed": "signed volume",
    "squared": "squared volume",
    "mixed": "signed volume of a part times squared volume of the rest",
}


@dataclass(frozen=True)
class Margin:
    """A number of the coordinates that is zero exactly at a singularity of one kind.

    Attributes:
        kind: limb, constraint or actuation.
        name: the limb, the platform, or the drives that are locked.
        value: the volume [1], lengths divided by the characteristic length.
        form: see `FORMS`; signed and mixed ones are positive in the reference configuration or, where they are
            zero there, at the next sample state.
        meaning: what happens where it is zero.
    """

    kind: str
    name: str
    value: Node
    form: str
    meaning: str

    def __repr__(self) -> str:
        return f"<Margin {self.kind} ({self.name}): {self.meaning}>"


@dataclass(frozen=True)
class Margins:
    """The margins of one kind, and a sentence for each that was not derived or not looked for as usual."""

    found: tuple[Margin, ...] = ()
    not_tried: tuple[str, ...] = ()

    def __iter__(self) -> Iterator[Margin]:
        return iter(self.found)

    def __len__(self) -> int:
        return len(self.found)


def limb_margins(system: System) -> Margins:
    """One margin for every limb: volume of its joint screws (omega ; v / length), over the tape of `system`.

    Without described limbs: the open chain, or the chain of joints that belongs to one cut joint alone; and, with
    the platform held at rest, whether the others can still move (type 1 of Gosselin and Angeles).

    Args:
        system: with its sample states (`System.use_samples`), from which zeros and ranks are read.
    """
    made = _Collected(system, "limb")
    for name, joints in limbs(system).items():
        if (freedoms := len(limb_freedoms(system, joints))) > LONG:
            made.not_tried.append(
                f"limb margin ({name}): {freedoms} freedoms are more than {LONG}, so its screws were looked at in the "
                "axes of the ground only; the number is the same, its expression may be longer"
            )
        made.add(name, partial(limb_volume, system, joints), f"joint screws of {name} become dependent")
    platform = system.mechanism.platform
    if system.cuts and not system.mechanism.limbs and platform is not None:
        path = system.tree.path(system.tree.link_of_body[platform])
        held = {k for i in path for k in range(system.tree.links[i].v.start, system.tree.links[i].v.stop)}
        made.add(
            platform,
            lambda: ClosureGrids(system).volume((), held),
            f"joints can move while {platform} rests",
        )
    return made.margins()


def constraint_margins(system: System) -> Margins:
    """The rank of the closure with all drives free; none for an open chain or a platform without constraints."""
    made = _Collected(system, "constraint")
    made.add(
        system.mechanism.platform or "closure",
        lambda: ClosureGrids(system).volume(()),
        "the constraints lose rank: a freedom more, drives or not",
    )
    return made.margins()


def actuation_margins(system: System) -> Margins:
    """With all drives locked; where there are more drives than freedoms also with every set that is just enough."""
    made = _Collected(system, "actuation")
    if not system.cuts or not system.drives:
        return made.margins()
    closure = ClosureGrids(system)
    every = tuple(range(len(system.drives)))
    chosen, left_out = drive_sets(every, closure.freedoms)
    made.not_tried += [f"actuation margins: {text}" for text in left_out]
    for locked in chosen:
        name = "all drives" if locked == every else " ".join(_drive_name(system, k) for k in locked)
        made.add(
            name,
            partial(closure.volume, locked),
            f"a freedom is left with {name} locked",
            counts=partial(closure.holds_as_much, locked, every),
        )
    return made.margins()


def drive_sets(drives: Sequence[T], freedoms: int) -> tuple[list[tuple[T, ...]], tuple[str, ...]]:
    """(all drives, then every set that is just enough for the freedoms; what was left out, in words)."""
    every = tuple(drives)
    if not 0 < freedoms < len(every):
        return [every], ()
    count = comb(len(every), freedoms)
    if count > MOST_SUBSETS:
        return [every], (
            f"the {count} sets of {freedoms} of the {len(every)} drives, which are just enough, were not looked at "
            f"one by one (more than {MOST_SUBSETS})",
        )
    return [every, *combinations(every, freedoms)], ()


def limbs(system: System) -> dict[str, tuple[str, ...]]:
    """Name -> joints of every chain that has a margin of its own."""
    mechanism, tree = system.mechanism, system.tree
    if mechanism.limbs:
        return {name: limb.joints for name, limb in mechanism.limbs.items()}
    if not system.cuts:
        end = mechanism.platform or list(mechanism.bodies)[-1]
        path = reversed(tree.path(tree.link_of_body[end]))
        return {end: tuple(dict.fromkeys(tree.links[i].joint for i in path))}
    closure = ClosureGrids(system)
    if not closure.shared:
        return {}
    owner = {k: link.joint for link in tree.links[1:] for k in range(link.v.start, link.v.stop)}
    chains = {}
    for cut, private in zip(system.cuts, closure.private, strict=True):
        if private and cut.is_joint:  # gears and rolling hold no chain together whose screws could become dependent
            chains[cut.joint.name] = (*dict.fromkeys(owner[k] for k in private), cut.joint.name)
    return chains


def _drive_name(system: System, index: int) -> str:
    joint, freedom = system.drives[index]
    single = system.mechanism.joints[joint].kind.freedom == 1
    return joint if single else f"{joint}.{freedom}"


class _Collected:
    """The margins of one kind so far, and what was not derived."""

    def __init__(self, system: System, kind: str) -> None:
        self.system, self.kind = system, kind
        self.found: list[Margin] = []
        self.not_tried: list[str] = []

    def add(
        self,
        name: str,
        make: Callable[[], Volume | None],
        meaning: str,
        counts: Callable[[], bool] = lambda: True,
    ) -> None:
        """The margin with the volume that `make` returns; none where it returns None or finds it too large.

        `counts`: whether these drives hold all that all drives hold; a set that does not has no margin.
        """
        try:
            made = make()
        except TooLargeError as error:
            if counts():
                self.not_tried.append(f"{self.kind} margin ({name}): not derived, it would need {error}")
            return
        if made is not None and counts():
            value = self._oriented(made)
            text = f"{FORMS[made.form]}; 0: {meaning}"
            self.found.append(Margin(self.kind, name, value, made.form, text))

    def margins(self) -> Margins:
        """All of them."""
        return Margins(tuple(self.found), tuple(self.not_tried))

    def _oriented(self, made: Volume) -> Node:
        """Positive in the reference configuration, the first sample; or at the next where it is zero."""
        if made.form == "squared":
            return made.value
        samples = np.atleast_1d(self.system.tape.sample(made.value))
        first = next((x for x in samples if abs(x) > NEGLIGIBLE), 1.0)
        return -made.value if first < 0 else made.value
