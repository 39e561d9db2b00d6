"""Who names a joint's type or motion by letter: tables, and the readers of other formats."""

from __future__ import annotations

import ast
from collections.abc import Iterable

import pytest
from support.sources import FILES, name_of, nodes

from symscrew.description.joints import JOINT_TYPES
from symscrew.kinematics.pairs import PAIRS

pytestmark = pytest.mark.slow

ASKED = ("kind", "type", "kinds", "types", "letter", "letters")
FOREIGN = {
    "loops/limbs/planar_limbs.py",  # its three closed forms, by the limb's two motions
    "formats/mjcf_bodies.py",  # a slide and a hinge that an equality couples
    "formats/idle_spins.py",  # a rod between two balls of a file that may be a bar here
    "formats/contradictory_loops.py",  # turns of a file that its author calls spherical
    "formats/mjcf_closing.py",  # hinges and slides of a file, by which its open loops are closed
    "formats/merged_joints.py",  # chains of elementary joints that are one joint here
    "studies/accuracy/load_sharing.py",  # limbs of the seed by their letters
    "mobility/proofs/proof_checker.py",  # imports nothing of the package, so that who doubts it need not trust it
    "mobility/proofs/proof_numbers.py",  # what it writes for that checker
    "mobility/proofs/way_checker.py",  # imports that checker alone
    "mobility/proofs/way_proofs.py",  # what it writes for it
    "formats/mjcf_keyframes.py",  # how many numbers a file's joint has in a keyframe
    "assembly/held_structure.py",  # groups of unknowns are called free here, as bodies are: no joint is meant
    "assembly/closure_ideal.py",  # the same
    "assembly/batch_equations.py",  # the same
}


def letters(node: ast.AST) -> bool:
    """Whether a node is a text of joint letters, or a collection with one."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value:
        return node.value in JOINT_TYPES or set(node.value) <= {*PAIRS, *(x for x in JOINT_TYPES if len(x) == 1)}
    return isinstance(node, ast.Tuple | ast.List | ast.Set) and any(map(letters, node.elts))


def asks(node: ast.AST) -> bool:
    """Whether a node is something that a joint or a motion calls itself."""
    names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
    names |= {n.attr for n in ast.walk(node) if isinstance(n, ast.Attribute)}
    return not names.isdisjoint(ASKED) and "dtype" not in names


def compares_letters(nodes: Iterable[ast.AST]) -> bool:
    """Whether one of these nodes compares what a joint or a motion calls itself with letters."""
    for node in nodes:
        if isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
            if any(map(letters, sides)) and any(map(asks, sides)):
                return True
    return False


def in_text(source: str) -> bool:
    return compares_letters(ast.walk(ast.parse(source)))


def test_a_handful_of_files_name_motions_by_letter() -> None:
    found = {name_of(path) for path in FILES if compares_letters(nodes(path))}
    assert found == FOREIGN


def test_a_comparison_with_a_letter_would_be_found() -> None:
    assert in_text('if link.motion.kind == "S": ...')
    assert in_text('if joint.type in ("E", "free"): ...')
    assert in_text('slides = any(m.kind in "PH" for m in motions)')
    assert not in_text('if array.dtype.kind != "U": ...')
    assert not in_text('if link.motion.spherical or coordinate.kind == "length": ...')


def test_every_motion_of_the_table_has_a_lower_pair() -> None:
    kinds = {motion.kind for kind in JOINT_TYPES.values() for motion in kind.motions}
    assert kinds <= set(PAIRS)
    assert {name: kind.letter for name, kind in JOINT_TYPES.items()} == {name: name for name in JOINT_TYPES}
