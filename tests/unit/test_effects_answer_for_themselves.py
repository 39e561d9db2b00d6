"""No room but effects knows an effect by its name: what is asked of effects, they answer by methods."""

from __future__ import annotations

import ast
from pathlib import Path

import numpy as np
import pytest

import symscrew
from symscrew import catalogue
from symscrew.effects import Acting, Gravity, known_effects, simplifications, transformed
from symscrew.effects.massless_limbs import MasslessLimbs
from symscrew.effects.no_gyroscopic_terms import NoGyroscopicTerms
from symscrew.effects.quasi_static import QuasiStatic
from symscrew.kinematics import System

PACKAGE = Path(symscrew.__file__).parent
FOREIGN = {  # an attribute of MuJoCo's <option>; elements of <gazebo>, and of Drake's <transmission>
    ("formats/mjcf_settings.py", "gravity"),
    ("formats/mjcf_effects.py", "gravity"),
    ("formats/urdf_gazebo.py", "gravity"),
    ("formats/urdf_forces.py", "rotor_inertia"),
}


def type_names(source: str) -> set[str]:
    """Texts of a file, not its docstrings, that are the type of an effect."""
    known = known_effects()
    names = {*known, *(kind.__name__ for kind in known.values())}
    if not any(name in source for name in names):
        return set()
    tree = ast.parse(source)
    listed = [n.value for n in tree.body if isinstance(n, ast.Assign) and getattr(n.targets[0], "id", "") == "__all__"]
    public = {id(item) for value in listed for item in ast.walk(value)}
    return {
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and node.value in names and id(node) not in public
    }


def test_no_other_room_names_the_type_of_an_effect() -> None:
    others = [p for p in PACKAGE.rglob("*.py") if p.parent != PACKAGE / "effects"]
    assert len(others) > 100
    found = {(str(p.relative_to(PACKAGE)), name) for p in others for name in type_names(p.read_text())}
    assert found == FOREIGN


def test_a_name_in_another_room_would_be_found() -> None:
    assert type_names('if "quasi_static" in acting.simplifications: ...') == {"quasi_static"}


def test_what_is_left_out_is_what_any_of_the_effects_leaves_out() -> None:
    mechanism = catalogue.load("four_bar")

    def acting(*effects: symscrew.Effect) -> Acting:
        return Acting(System(transformed(mechanism, effects)), effects)

    plain, still = acting(Gravity()), acting(Gravity(), QuasiStatic())
    assert (plain.simplified, plain.keeps_motion, plain.keeps_gyroscopic_moments) == (False, True, True)
    assert (still.simplified, still.keeps_motion, still.keeps_gyroscopic_moments) == (True, False, True)
    spinless = acting(NoGyroscopicTerms())
    assert (spinless.simplified, spinless.keeps_motion, spinless.keeps_gyroscopic_moments) == (True, True, False)
    light = acting(MasslessLimbs(keep=("coupler",)))
    assert (light.simplified, light.keeps_motion, light.keeps_gyroscopic_moments) == (True, True, True)


@pytest.mark.parametrize("name", ["massless limbs", "no gyroscopic terms", "quasi-static"])
def test_simplifications_by_their_words(name: str) -> None:
    effect = simplifications()[name]
    assert effect.simplifies == name
    assert effect.depends_on and effect.depends_on <= {"inertia", "motion"}


def test_drives_of_a_quasi_static_scene_do_not_depend_on_the_motion() -> None:
    model = symscrew.derive(catalogue.load("four_bar"), (Gravity(), QuasiStatic()))
    assert "forward_dynamics" not in model.programs
    q, v, a = model.test_inputs["inverse_dynamics"]
    moving, still = (model("inverse_dynamics", q, f * v, f * a)[0][0] for f in (1.0, 0.0))
    assert np.array_equal(moving, still) and np.abs(moving).min() > 0.3
