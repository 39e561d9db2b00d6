"""What joints transmit, by the joint's name, about the point and in the axes that a bearing's data sheet asks for.

    model, q, v, a --joint_wrenches--> wrenches["limb2_S"].about_joint().in_body_axes().force

Everything begins as the generated functions give it, (f ; m_O) from parent on child at O in absolute axes, without the
drive's share; each method returns a new wrench and says in its `repr` what it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from symscrew import notebook
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean, expect
from symscrew.model import Model
from symscrew.runtime import CompiledModel, load

Array = np.ndarray
NEEDED = ("joint_reactions", "joint_points", "body_poses")
"""Functions that are called for the wrenches of a state."""
TURN = 9  # entries of a body's pose that are its rotation, column by column; its place follows


@dataclass(frozen=True, repr=False)
class JointWrench:
    """Force (*batch, 3) [N] and moment (*batch, 3) [N m] from a joint's parent on its child.

    `point` (*batch, 3) [m] is the joint's own, in absolute axes; `turn` (*batch, 3, 3) takes body axes into absolute
    ones: those that the child carries, and that are absolute in the reference configuration. `about`: "O" or "joint";
    `axes`: "absolute" or "body".
    """

    joint: str
    force: Array
    moment: Array
    point: Array
    turn: Array
    about: str = "O"
    axes: str = "absolute"

    def __repr__(self) -> str:
        states = f", {self.force[..., 0].size} states" if self.force.ndim > 1 else ""
        return (
            f"JointWrench({self.joint}: force up to {_largest(self.force):.6g} N, moment about {self.about} up to "
            f"{_largest(self.moment):.6g} N m, {self.axes} axes{states})"
        )

    @property
    def screw(self) -> Array:
        """(*batch, 6): force, then moment."""
        return np.concatenate([self.force, self.moment], axis=-1)

    def about_joint(self) -> JointWrench:
        """The same wrench with its moment about the joint's own point: m_O - r x f."""
        return self._about("joint", -1.0)

    def about_origin(self) -> JointWrench:
        """The same wrench with its moment about the origin O."""
        return self._about("O", 1.0)

    def _about(self, point: str, sign: float) -> JointWrench:
        if self.about == point:
            return self
        there = self.in_absolute_axes()
        moved = replace(there, about=point, moment=there.moment + sign * np.cross(there.point, there.force))
        return moved.in_body_axes() if self.axes == "body" else moved

    def in_body_axes(self) -> JointWrench:
        """The same wrench in axes that the joint's child carries."""
        return self if self.axes == "body" else self._turned("body", np.swapaxes(self.turn, -1, -2))

    def in_absolute_axes(self) -> JointWrench:
        """The same wrench in absolute axes."""
        return self if self.axes == "absolute" else self._turned("absolute", self.turn)

    def _turned(self, axes: str, turn: Array) -> JointWrench:
        force, moment = ((turn @ part[..., None])[..., 0] for part in (self.force, self.moment))
        return replace(self, axes=axes, force=force, moment=moment)

    def _repr_html_(self) -> str:
        rows = [(name, *(f"{x:.6g}" for x in part)) for name, part in self._first()]
        many = ", first of several states" if self.force.ndim > 1 else ""
        return notebook.table(
            f"{self.joint}, moment about {self.about}, {self.axes} axes{many}", ("", "x", "y", "z"), rows
        )

    def _first(self) -> list[tuple[str, Array]]:
        return [(f"{n} [{u}]", p.reshape(-1, 3)[0]) for n, u, p in
                (("force", "N", self.force), ("moment", "N m", self.moment))]  # fmt: skip


class JointWrenches(Mapping[str, JointWrench]):
    """Wrenches of all joints by name, in the order of the description."""

    def __init__(self, mechanism: Mechanism, *, reactions: Array, points: Array, poses: Array) -> None:
        """Arrays as the functions `joint_reactions`, `joint_points` and `body_poses` give them.

        Args:
            mechanism: whose joints these are.
            reactions: (*batch, 6, joints), wrenches (f ; m_O).
            points: (*batch, 3, joints) [m], present places of the joints' points.
            poses: (*batch, 12, moving bodies), rotations column by column and places.
        """
        self.mechanism = mechanism
        bodies = [name for name in mechanism.bodies if name != mechanism.ground]
        batch = reactions.shape[:-2]
        turns = np.swapaxes(np.moveaxis(poses[..., :TURN, :], -1, 0).reshape(len(bodies), *batch, 3, 3), -1, -2)
        still = np.broadcast_to(np.eye(3), (*batch, 3, 3))
        self._wrenches = {
            joint.name: JointWrench(
                joint.name,
                reactions[..., :3, k],
                reactions[..., 3:, k],
                points[..., k],
                still if joint.child == mechanism.ground else turns[bodies.index(joint.child)],
            )
            for k, joint in enumerate(mechanism.joints.values())
        }

    def __getitem__(self, joint: str) -> JointWrench:
        if joint not in self._wrenches:
            raise DescriptionError(
                f"expected the name of a joint, got {joint!r}; {did_you_mean(joint, list(self._wrenches))}"
            )
        return self._wrenches[joint]

    def __iter__(self) -> Iterator[str]:
        return iter(self._wrenches)

    def __len__(self) -> int:
        return len(self._wrenches)

    def __contains__(self, joint: object) -> bool:
        return joint in self._wrenches

    def __repr__(self) -> str:
        largest = max(self.values(), key=lambda wrench: _largest(wrench.force), default=None)
        most = f", largest force {_largest(largest.force):.6g} N in {largest.joint}" if largest is not None else ""
        return f"JointWrenches({self.mechanism.name}: {len(self)} joints{most})"

    def _repr_html_(self) -> str:
        rows = [
            (name, f"{_largest(w.force):.6g}", f"{_largest(w.about_joint().moment):.6g}") for name, w in self.items()
        ]
        return notebook.table(
            f"{self.mechanism.name}: largest reactions", ("joint", "force [N]", "moment about it [N m]"), rows
        )


def joint_wrenches(model: Model, q: object, v: object, a: object, **inputs: object) -> JointWrenches:
    """What every joint transmits in states (q, v, a) of the tree.

    Args:
        model: with the effects that act.
        q: (*batch, nq), configurations on the loops.
        v: (*batch, nv), rates.
        a: (*batch, nv), accelerations.
        inputs: further inputs of `joint_reactions` by name: loads, parameters `p`.

    Returns:
        Wrenches (f ; m_O) by the joint's name.

    Raises:
        EvaluationError: a state in which a function fails.

    >>> from symscrew import catalogue
    >>> from symscrew.model import derive
    >>> crank = derive(catalogue.load("slider_crank"))
    >>> rest = [0.0] * len(crank.system.tree.v)
    >>> joint_wrenches(crank, crank.system.reference, rest, rest)["crank_R"].about_joint().axes
    'absolute'
    """
    expect(model, Model)
    known = ["q", "v", "a", *(port.name for name in NEEDED for port in model.declared(name).inputs)]
    for name in inputs:
        if name not in known:
            raise DescriptionError(f"no input {name!r} of joint reactions; {did_you_mean(name, dict.fromkeys(known))}")
    return wrenches_of(model, load(model.only(NEEDED)), {"q": q, "v": v, "a": a, **inputs})


def wrenches_of(model: Model, functions: CompiledModel, known: Mapping[str, object]) -> JointWrenches:
    """The same with compiled functions, `NEEDED` among them, at inputs by name."""
    found = {}
    for name in NEEDED:
        given = [known[port.name] for port in functions[name].inputs if port.name in known]
        result = functions[name](*given)
        found[name] = np.asarray(result[-1] if isinstance(result, tuple) else result)
    return JointWrenches(
        model.mechanism,
        reactions=found["joint_reactions"],
        points=found["joint_points"],
        poses=found["body_poses"],
    )


def _largest(vectors: Array) -> float:
    return float(np.linalg.norm(vectors, axis=-1).max(initial=0.0))
