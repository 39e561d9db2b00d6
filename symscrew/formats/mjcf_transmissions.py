"""What actuators and forces of an MJCF file act on: a joint, or a fixed tendon over several of them.

    tendon of one joint, or of joints that equalities tie to one  -->  that joint, times a factor
    tendon of several                                             -->  a pulley: a body without mass on a joint whose
                                                                       coordinate is coupled to theirs, s = sum c_i q_i

A drive on the pulley's joint pulls on every joint with c_i times its force, as the tendon does; the coupling says so.
Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html#tendon-fixed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

from symscrew.description import JOINT_TYPES
from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.formats.draft import Draft, RawBody, RawCoupling, RawEffect, RawJoint
from symscrew.formats.file_names import fresh
from symscrew.formats.mjcf_couplings import Tied
from symscrew.formats.mjcf_forces import SLIP
from symscrew.formats.mjcf_settings import Settings
from symscrew.formats.rigid_displacements import UNITS, ZERO, Real, real
from symscrew.formats.safe_xml import Element, attribute, check_attributes, elements, label, number, numbers

FORCES = {"stiffness": "spring", "damping": "damper", "frictionloss": "frictionloss", "armature": None}
"""Attributes of a tendon that make a force along it -> the flag that takes it away."""


KNOWN = (
    "name", "class", "group", "user", "limited", "range", "margin", "solreflimit", "solimplimit", "solreffriction",
    "solimpfriction", *FORCES, "springlength", "springyield", "actuatorfrclimited", "actuatorfrcrange", "material",
    "rgba", "width",
)  # fmt: skip
"""Attributes of a fixed tendon and of those of its class."""


def on_joint(attributes: Mapping[str, str]) -> str | None:
    """The joint that an actuator with these attributes is on, if it is on one."""
    return attributes.get("joint") or attributes.get("jointinparent")


@dataclass(frozen=True)
class Target:
    """What a transmission acts on: a joint of the draft, by `factor` times its displacement; through a `tendon`."""

    joint: str
    factor: Real
    tendon: str | None = None


@dataclass
class Transmissions:
    """The fixed tendons of a file that something acts on.

    Attributes:
        tendons: fixed tendon -> joint -> coefficient, followers of equalities replaced by what they follow.
        own: the same as the file has it.
        given: all tendons, attributes of their classes included.
        names: of all joints.
        pulleys: tendon -> the joint of its pulley, where it goes over several joints; as they are asked for.
    """

    tendons: Mapping[str, Mapping[str, Real]]
    own: Mapping[str, Mapping[str, Real]]
    given: Mapping[str, Element]
    names: frozenset[str]
    pulleys: dict[str, str] = field(default_factory=dict)

    def of(self, attributes: Mapping[str, str], where: str) -> Target | None:
        """What an actuator with these attributes acts on; None for what is neither a joint nor a fixed tendon."""
        joint = on_joint(attributes)
        if joint is not None:
            return Target(joint, real(1))
        name = attributes.get("tendon")
        if name is None:
            return None
        if name not in self.given:
            raise DescriptionError(f"{where}: there is no tendon {shorten(name)}; {did_you_mean(name, self.given)}")
        return self._along(name) if name in self.tendons else None

    def _along(self, name: str) -> Target:
        terms = self.tendons[name]
        if len(terms) == 1:
            ((joint, factor),) = terms.items()
            return Target(joint, factor, name)
        if name not in self.pulleys:
            self.pulleys[name] = fresh(name, [*self.names, *self.pulleys.values()])
        return Target(self.pulleys[name], real(1), name)

    def coefficients(self, target: Target) -> Mapping[str, Real]:
        """Joint -> by how much it moves what a target's coordinate measures."""
        name = next((tendon for tendon, joint in self.pulleys.items() if joint == target.joint), None)
        return {target.joint: target.factor} if name is None else self.tendons[name]


def transmissions(root: Element, settings: Settings, ties: Sequence[Tied]) -> Transmissions:
    """The tendons of a file; `ties`: its couplings, of which the linear ones of two joints say who follows whom.

    Where joints have values of their own in the file's pose, tendons that name followers are pulleys: their length has
    another zero than that of the joint which is followed.
    """
    given: dict[str, Element] = {}
    for section in elements(root, "tendon"):
        for k, tendon in enumerate(elements(section)):
            whole = settings.with_defaults(tendon, "tendon")
            if tendon.tag == "fixed":
                check_attributes(whole, KNOWN)
            given[tendon.get("name") or f"tendon_{k}"] = whole
    follows = {
        next(iter(tied.first)): (next(iter(tied.second)), tied.powers[1])
        for tied in ties
        if len(tied.first) == len(tied.second) == 1 and not any((tied.powers[0], *tied.powers[2:]))
        and list(tied.first.values()) == list(tied.second.values()) == [1]
    }  # fmt: skip
    if any(any(numbers(joint.get("ref", "0"), "<joint>, ref")) for joint in root.iter("joint")):
        follows = {}
    fixed = {name: tendon for name, tendon in given.items() if tendon.tag == "fixed"}
    tendons = {name: _gathered(tendon, follows) for name, tendon in fixed.items()}
    own = {name: _gathered(tendon, {}) for name, tendon in fixed.items()}
    return Transmissions(tendons, own, given, frozenset(j.get("name") or "" for j in root.iter("joint")))


def _gathered(tendon: Element, follows: Mapping[str, tuple[str, Real]]) -> dict[str, Real]:
    """Joint -> coefficient of a tendon, with joints that follow another put on that one."""
    terms: dict[str, Real] = {}
    for joint, factor in _terms(tendon):
        seen = {joint}
        while joint in follows and follows[joint][0] not in seen:
            joint, factor = follows[joint][0], factor * follows[joint][1]
            seen.add(joint)
        terms[joint] = terms.get(joint, ZERO[0]) + factor
    kept = {joint: factor for joint, factor in terms.items() if factor != 0}
    if not kept:
        raise DescriptionError(f"{label(tendon)}: expected joints with coefficients that are not all zero")
    return kept


def _terms(tendon: Element) -> list[tuple[str, Real]]:
    """(joint, coefficient) as the file lists them."""
    where = f"{label(tendon)}, coef"
    return [(attribute(p, "joint"), real(number(attribute(p, "coef"), where))) for p in elements(tendon, "joint")]


def tendon_forces(
    draft: Draft,
    found: Transmissions,
    rests: Mapping[str, Real],
    off: Collection[str],
    *,
    cord: Callable[[Draft, Element, Sequence[str]], None],
) -> None:
    """Enter what tendons say of forces and reach; what no mechanism here holds is in the ledger.

    `rests`: hinge or slide -> its springref, at which tendons have the length at which they rest unless they say one;
    `off`: flags of the file by which forces do not act; `cord` enters a tendon in space.
    """
    for name, tendon in found.given.items():
        where = label(tendon)
        acting = [key for key, flag in FORCES.items() if flag not in off]
        forces = [key for key in acting if any(v != 0 for v in numbers(tendon.get(key, "0"), f"{where}, {key}"))]
        if tendon.tag != "fixed":
            cord(draft, tendon, forces)
        elif forces:
            _forces(draft, tendon, forces, target=found.of({"tendon": name}, where), rests=rests, found=found)
        if forces and any(v != 0 for v in numbers(tendon.get("springyield", "0"), f"{where}, springyield")):
            draft.ledger.lost("springyield of a tendon")
        if "range" in tendon.attrib:
            draft.ledger.passed("range of a tendon")


def _forces(
    draft: Draft,
    tendon: Element,
    forces: Sequence[str],
    *,
    target: Target | None,
    rests: Mapping[str, Real],
    found: Transmissions,
) -> None:
    assert target is not None
    square = float(target.factor**2)
    for key in forces:
        listed = numbers(tendon.attrib[key], f"{label(tendon)}, {key}")
        size = float(listed[0])
        if any(v != 0 for v in listed[1:]):
            draft.ledger.lost(f"powers of {key} of a tendon above the first")
        if key == "damping":
            table = {"kind": "damping", "coefficient": size * square}
        elif key == "armature":
            table = {"kind": "armature", "inertia": size * square}
            if branched(draft, found.coefficients(target)):
                draft.ledger.turned(BRANCHED)
        elif key == "frictionloss":
            table = {"kind": "friction", "coulomb": size * abs(float(target.factor)), "velocity": float(SLIP)}
        else:
            ends = [real(v) for v in numbers(tendon.get("springlength", "-1"), f"{label(tendon)}, springlength")]
            if len(ends) > 1 and ends[0] != ends[1]:
                draft.ledger.lost("springlength with a slack part")
                continue
            own = sum((c * rests.get(j, ZERO[0]) for j, c in _terms(tendon)), start=ZERO[0])
            rest = (own if ends[0] == -1 else ends[0]) / target.factor
            table = {"kind": "spring", "stiffness": size * square, "rest": float(rest)}
        draft.effects.append(RawEffect(target.joint, table, target.tendon))
        draft.ledger.turned(f"{key} of a tendon")


BRANCHED = "armature of a tendon over branches: whole here, the engine leaves out what couples them"
"""What is said of such a tendon."""


def branched(draft: Draft, joints: Collection[str]) -> bool:
    """Whether joints are not all on one way outwards."""
    above = {joint.child: joint for joint in draft.joints}
    ways: list[set[str]] = []
    for joint in (joint for joint in draft.joints if joint.name in joints):
        way, at = {joint.name}, joint.parent
        while at in above:
            way.add(above[at].name)
            at = above[at].parent
        ways.append(way)
    return not any(way.issuperset(joints) for way in ways)


def pulley_body(tendon: str) -> str:
    """What the body of a tendon's pulley is called."""
    return f"{tendon}_pulley"


def pulley_coupling(tendon: str) -> str:
    """What the coupling of a tendon's pulley is called."""
    return f"{tendon}_tendon"


def add_pulleys(draft: Draft, found: Transmissions, values: dict[str, Real], driven: Mapping[str, object]) -> None:
    """The bodies, joints and couplings of the pulleys that were asked for, on the ground.

    `values`: hinge or slide -> its coordinate in the reference configuration; the pulleys' are added.
    """
    for tendon, joint in found.pulleys.items():
        terms = found.tendons[tendon]
        for name in terms:
            if name not in values:
                raise DescriptionError(
                    f"{label(found.given[tendon])}: expected a hinge or slide joint, got {shorten(name)}; "
                    f"{did_you_mean(name, values)}"
                )
        hinges = {j.name for j in draft.joints if JOINT_TYPES[j.type].hinge}
        body = fresh(pulley_body(tendon), [draft.ground, *(b.name for b in draft.bodies)])
        value = sum((c * values[name] for name, c in terms.items()), start=ZERO[0])
        draft.bodies.append(RawBody(body))
        draft.joints.append(
            RawJoint(
                joint, "R" if set(terms) <= hinges else "P", draft.ground, body, ZERO, (UNITS[2],),
                driven=(0,) if joint in driven else (), reference=(value,),
            )
        )  # fmt: skip
        values[joint] = value
        names = fresh(pulley_coupling(tendon), [c.name for c in draft.couplings])
        draft.couplings.append(RawCoupling(names, {joint: (real(1),)} | {name: (-c,) for name, c in terms.items()}))
        draft.ledger.turned("tendon over several joints: a pulley that is coupled to them")
