"""The assembly mode of a run: one name along regular motions, other names for other assemblies, a word on changes."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model

from symscrew.algebra import most_independent
from symscrew.cli.parser import main
from symscrew.loops import closed_limbs, hub_links, limb_coordinates
from symscrew.scene import load_scene
from symscrew.simulation import run_summary, simulate
from symscrew.simulation.assembly_mode import AssemblyModes, changed

pytestmark = pytest.mark.slow

Array = np.ndarray


@cache
def modes(name: str) -> AssemblyModes:
    found = model(name)
    return AssemblyModes(found, found.system.parameter_values)


def turned(name: str, driven: int, angles: Array, start: Array | None = None) -> list[Array]:
    """Configurations on the way of one independent coordinate, each assembled from the one before."""
    found = model(name)
    q = found.system.reference if start is None else start
    places = list(found.programs["assemble"].independent)
    way = []
    for angle in angles:
        y = found.system.reference[places].copy()
        y[driven] += angle
        (q,), status = found("assemble", y, q)
        assert status == 0
        way.append(q)
    return way


@pytest.mark.parametrize("name", ["four_bar", slow("slider_crank")])
def test_a_name_stays_over_many_turns_and_differs_for_the_other_assembly(name: str) -> None:
    """A crank that turns fully passes dead centres of what it drives, and no place where it does not determine it."""
    found, named = model(name), modes(name)
    way = turned(name, 0, np.arange(1, 135) * 0.3)
    assert {named.name(q) for q in way} == {"drives locked: +"} and way[-1][0] > 6 * 2 * np.pi
    crossed = other_closure(name)
    assert named.name(crossed) == "drives locked: -"
    assert {named.name(q) for q in turned(name, 0, np.arange(1, 25) * 0.3, crossed)} == {"drives locked: -"}
    assert np.abs(found("closure", crossed)[0][0]).max() < 1e-12


def other_closure(name: str) -> Array:
    """The other assembly at the same drives: from guesses at random, since `assemble` stays on the guess's own."""
    found, random = model(name), np.random.default_rng(4)
    system, places = found.system, list(found.programs["assemble"].independent)
    y = system.reference[places]
    for _ in range(200):
        guess = system.reference + random.uniform(-2, 2, len(system.reference))
        guess[places] = y
        (q,), status = found("assemble", y, guess)
        if status == 0 and np.abs(np.sin((q - system.reference) / 2)).max() > 1e-3:
            return np.asarray(q)
    raise AssertionError("found no other assembly")


def test_a_five_bar_keeps_its_name_and_its_mirror_image_has_another() -> None:
    found, named = model("five_bar"), modes("five_bar")
    q, _, _ = found.system.states(20, 5)
    assert {named.name(state) for state in q} == {"drives locked: +"}
    assert named.name(other_closure("five_bar")) == "drives locked: -"


@pytest.mark.slow
def test_arms_of_a_delta_have_a_sign_each() -> None:
    """The other elbow of one arm, and of two, on the same pose of the platform."""
    found, named = model("delta"), modes("delta")
    system = found.system
    hub, limbs = hub_links(system) or (), closed_limbs(system) or ()
    known = {k: system.inputs.q[k] for link in hub for k in range(link.q.start, link.q.stop)}
    nodes = limb_coordinates(system, limbs, known, system.inputs.q).q
    cranks = [limb.links[0].q.start for limb in limbs if len(limb.links) == 3]
    for q in system.states(6, 5)[0][:2]:
        for turned_over in ((), (0,), (1,), (2,), (0, 2)):
            guess = q.copy()
            guess[[cranks[k] for k in turned_over]] += 2.5
            other = system.numeric(nodes, (system.inputs.q, guess[None]))[0]
            assert np.abs(found("closure", other)[0][0]).max() < 1e-12
            signs = ["-" if k in turned_over else "+" for k in range(3)]
            arms = ", ".join(f"arm{k + 1}_R {sign}" for k, sign in enumerate(signs))
            assert named.name(other).startswith(f"platform held: {arms}; drives locked: ")
        assert named.name(q).endswith("drives locked: +")


@pytest.mark.parametrize(
    "name", ["planar_3rrr", slow("three_ups_upu_s"), slow("stewart_6ups"), slow("sarrus"), slow("bennett")]
)
def test_names_do_not_depend_on_the_state_without_a_singularity(name: str) -> None:
    found, named = model(name), modes(name)
    reference = named.name(found.system.reference)
    assert reference and "-" not in reference and "0" not in reference
    assert {named.name(q) for q in found.system.states(20, 5)[0]} == {reference}


def test_no_loops_no_name() -> None:
    assert modes("pendulum").name(np.array([1.0])) == ""


def test_rows_that_are_most_independent() -> None:
    matrix = np.array([[1.0, 0], [1, 1e-9], [0, 0], [0.5, 2]])
    assert most_independent(matrix) == [0, 3]


def test_a_change_is_told_with_its_reason() -> None:
    both = "platform held: a +, b +; drives locked: +"
    assert changed(both, both) == ()
    (text,) = changed(both, "platform held: a +, b -; drives locked: +")
    assert text.startswith("the assembly mode changed: platform held: a +, b + became a +, b -:") and "passed" in text
    (text,) = changed("drives locked: 0", "drives locked: +")
    assert "singular itself" in text


SCENE = """
[scene]
name = "swinging"
mechanism = "{name}"
duration = {duration}
rate = 20

[initial.rates]
{joint} = {rate}

[[effects]]
type = "gravity"
acceleration = {gravity}

[integrator]
tolerance = 1e-8
"""


def scene_file(tmp_path, **values: object):
    path = tmp_path / "scene.toml"
    path.write_text(SCENE.format(**values))
    return path


def test_a_run_names_its_mode_at_start_and_end(tmp_path, capsys) -> None:
    """A crank that turns many times: one name, in the report, in the JSON; none of the words about a change."""
    path = scene_file(tmp_path, name="four_bar", duration=2, joint="A", rate=12.0, gravity="[0, 0, 0]")
    assert main(["simulate", str(path), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["assembly_mode"] == {"name": "", "start": "drives locked: +", "end": "drives locked: +"}
    assert main(["simulate", str(path)]) == 0
    assert "assembly mode: drives locked: +, the same at start and end\n" in capsys.readouterr().out


@pytest.mark.slow
def test_a_run_through_a_singularity_of_its_drives_says_that_the_mode_changed(tmp_path) -> None:
    """A falling five-bar is regular where its drives do not determine it: the loops are, and only the name changes."""
    path = scene_file(tmp_path, name="five_bar", duration=3, joint="base_left", rate=3.0, gravity='[0, "-9.81", 0]')
    run = simulate(load_scene(path))
    named = modes("five_bar")
    signs = [named.name(q) for q in run.q]
    assert run.ok and set(signs) >= {"drives locked: +", "drives locked: -"}
    first = next(k for k, sign in enumerate(signs) if sign.endswith("-"))
    shorter = simulate(load_scene(scene_file(tmp_path, name="five_bar", duration=float(run.t[first]),
                                             joint="base_left", rate=3.0, gravity='[0, "-9.81", 0]')))  # fmt: skip
    assert shorter.modes == ("drives locked: +", "drives locked: -")
    assert any(text.startswith("the assembly mode changed: drives locked: + became -") for text in shorter.events)
    assert any(text.startswith("assembly mode: drives locked: +, at the start; drives locked: - at the end")
               for text in run_summary(shorter))  # fmt: skip
