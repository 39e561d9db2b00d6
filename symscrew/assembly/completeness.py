"""Whether the modes that were found are all: as many certified zeros, complex ones too, as a bound allows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.certified_roots import Certificate, certified
from symscrew.assembly.exact_roots import ExactRoot
from symscrew.assembly.root_bounds import Bound, exact_bound, own_bound, regular_bound
from symscrew.assembly.start_system import StartSystem, together
from symscrew.assembly.target_roots import APART, Account, End
from symscrew.assembly.what_is_held import Held


def proof_of(equations: BatchEquations, boxes: Any, end: End) -> Certificate | None:
    """The box with one zero around an end; None where there is none, or it is known in exact numbers."""
    return end.proof or (certified(equations, boxes, end.z) if end.regular and end.exact is None else None)


@dataclass(frozen=True)
class Completeness:
    """`boxes`: the numbers in the slots, as rectangles; `progress`: is told what takes time."""

    held: Held
    equations: BatchEquations
    boxes: Any
    progress: Callable[[str], None]

    def verdict(
        self, start: StartSystem, account: Account, certificates: Sequence[Certificate | None]
    ) -> tuple[str, str, Bound | None]:
        """(what completeness is, why, the bound): by the family's bound, by that of this mechanism's own numbers."""
        real = [c for c in certificates if c is not None and c.kind == "real"]
        exact = [end.exact for end in account.ends if end.exact is not None]
        others = [end for end in account.ends if end.kind == "complex" and end.regular]
        family = start.bound
        wanted = None if family is None else family.count
        every = len(real) + len(others) + sum(root.meeting for root in exact)
        own: Bound | None = None
        if wanted is None or every < wanted:
            asked = own_bound(self.held)
            own = asked if isinstance(asked, Bound) else None
        best = own if own is not None and own.dimension <= 0 and own.count >= 0 else family
        if own is not None and own.dimension > 0:
            told = self._regular(own, real, others, exact)
            if told is not None:
                return told
            return "tracked" if start.complete else "sampled", (
                f"all zeros of this very mechanism have dimension {own.dimension}: {own.how}; isolated ones are those "
                f"that {account.paths} paths lead to"
            ), family  # fmt: skip
        whole = len(real) + len(exact) == sum(end.kind == "real" for end in account.ends)
        whole &= len({root.coordinates for root in exact}) == len(exact)
        whole &= best is own or all(root.isolated for root in exact)
        if best is not None and best.count == every and whole and self._all_certified(real, others):
            several = [root.meeting for root in exact if root.meeting > 1]
            meet = "" if not several else f", of which {', '.join(map(str, several))} meet in one place each"
            exactly = exact_bound(self.held)
            if isinstance(exactly, Bound) and exactly.dimension <= 0 and exactly.count == every:
                return "proved", f"as many certified solutions, {every}{meet}, as the number {exactly.how}", exactly
            return "bounded", f"as many certified solutions, {every}{meet}, as the bound {best.how}", best
        if start.complete:
            return "tracked", (
                f"all {account.paths} paths from the {len(start.zeros)} zeros of a general member were followed; the "
                f"bound {best.count if best else 0} holds {best.how if best else ''}; that the other paths end "
                "elsewhere is numerical"
            ), best  # fmt: skip
        if not len(start.zeros):
            return "sampled", f"no path led away from the reference, so that none were looked for; {start.why}", best
        return "sampled", f"{len(start.zeros)} zeros of a general member were found by monodromy; {start.why}", best

    def _regular(
        self, own: Bound, real: Sequence[Certificate], others: Sequence[End], exact: Sequence[ExactRoot]
    ) -> tuple[str, str, Bound] | None:
        """Whether all regular zeros are there, of a mechanism that has solutions without end beside them."""
        bound = regular_bound(self.held)
        regular = [root for root in exact if root.meeting == 1]
        every = len(real) + len(others) + len(regular)
        apart = len({root.coordinates for root in regular}) == len(regular)
        if isinstance(bound, str) or bound.count != every or not apart or not self._all_certified(real, others):
            return None
        return "regular", (
            f"as many certified regular solutions, {every}, as the bound {bound.how}; beside them are singular ones "
            f"without end, of dimension {own.dimension} over the complex numbers"
        ), bound  # fmt: skip

    def _all_certified(self, real: Sequence[Certificate], others: Sequence[End]) -> bool:
        """Whether complex solutions have certificates too, and say they are complex, and all zeros are different."""
        self.progress(f"certificates of {len(others)} complex solutions")
        found = [proof_of(self.equations, self.boxes, end) for end in others]
        proofs = [proof for proof in found if proof is not None and proof.kind == "complex"]
        every = (*real, *proofs)
        zeros = np.array([self.equations.scaled(proof.z[None] + 0j)[0] for proof in every])
        for z, proof in zip(zeros, every, strict=True):
            near = int(together(self.equations, zeros, z, APART).sum())
            if proof.beside is not None:  # boxes of these two are apart
                beside = self.equations.scaled(proof.beside[None] + 0j)
                near -= int(together(self.equations, beside, z, APART)[0])
            if near != 1:
                return False
        return len(proofs) == len(others)
