"""Poses and motions that are none of the mechanism's, and poses out of a limb's reach: refused by name, by all targets.

How far a pose is from the mechanism is told here by the closure of all loops, once the limbs are in their closed form.
"""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.limb_platforms import platform
from support.marks import slow
from support.model_states import model as catalogued

from symscrew import catalogue
from symscrew.algebra import apply_numpy
from symscrew.functions.checked import SUFFIX
from symscrew.functions.closing import CLOSED
from symscrew.generation.folder import generate
from symscrew.model import Model, derive
from symscrew.program import NOT_ON_MECHANISM, OUT_OF_REACH, Program, status_texts
from symscrew.program.numpy_evaluation import evaluate
from symscrew.runtime.compiled import EvaluationError, find_compiler, load

pytestmark = pytest.mark.slow

Array = np.ndarray
PLATFORM = ("inverse_kinematics", "inverse_velocity", "inverse_dynamics_platform")


@cache
def model(name: str) -> Model:
    return derive(platform(name), checked=True) if name.isupper() else catalogued(name)


@cache
def checked(name: str) -> Model:
    return model(name) if name.isupper() else derive(catalogue.load(name), checked=True)


def program(found: Model, function: str) -> Program:
    made = found.programs[function]
    assert isinstance(made, Program)
    return made


def without_limits(found: Model, function: str, *inputs: Array) -> Array:
    """The first output, whatever the limits say."""
    (result, *_), status = evaluate(replace(program(found, function), limits=()), inputs)
    assert not status.any()
    return result


def rows(found: Model) -> Array:
    """What makes the closure's rows plain numbers."""
    system = found.system
    return np.array([1 / system.length if row.unit == "N" else 1.0 for cut in system.cuts for row in cut.rows])


def opening(found: Model, pose: Array) -> Array:
    """How far the loops are open in poses of the platform, without units."""
    q = without_limits(found, "inverse_kinematics", pose)
    return np.linalg.norm(found("closure", q)[0][0] * rows(found), axis=1)


def moved(found: Model, q: Array, step: Array) -> Array:
    """The platform's pose after a step of joint rates."""
    after = found.system.advance(q, step)
    labels = [c.label for c in found.system.tree.q]
    return after[:, [labels.index(label) for label in found.programs["inverse_kinematics"].inputs[0].labels]]


@pytest.mark.parametrize("name", ["PRS", slow("RPS"), slow("three_ups_upu_s"), slow("delta")])
def test_poses_near_the_mechanism_are_told_from_those_on_it(name: str) -> None:
    """Random poses, and the same moved at random, on both sides of the threshold."""
    found, random = model(name), np.random.default_rng(3)
    q, v, _ = found.system.states(12, 8)
    step = random.normal(size=v.shape) * np.asarray(found.system.scales, dtype=float)
    first = opening(found, moved(found, q, 1e-4 * step)) / 1e-4
    given = {
        port.name: x for port, x in zip(found.programs[PLATFORM[2]].inputs, found.test_inputs[PLATFORM[2]], strict=True)
    }
    for part, expected in ((0.0, 0), (0.8, 0), (1.25, NOT_ON_MECHANISM), (1e3, NOT_ON_MECHANISM)):
        pose = moved(found, q, part * CLOSED / first[:, None] * step)
        assert part > 2 or np.allclose(opening(found, pose), part * CLOSED, rtol=0.05, atol=1e-11)
        for function in PLATFORM:
            inputs = [pose, *(given[p.name][[0] * len(pose)] for p in found.programs[function].inputs[1:])]
            results, status = found(function, *inputs)
            assert (status == expected).all(), (function, part, status)
            assert all(np.isnan(result).all() == (expected != 0) for result in results)


def test_every_pose_within_reach_of_free_limbs_is_on_the_mechanism() -> None:
    """The limbs of a planar 3-RRR close in every pose: nothing is looked at but whether they get there."""
    found, random = model("planar_3rrr"), np.random.default_rng(1)
    pose = found.test_inputs["inverse_kinematics"][0][:1] + random.normal(size=(300, 3)) * [0.3, 0.3, 1.0]
    (q,), status = found("inverse_kinematics", pose)
    assert {0, OUT_OF_REACH, OUT_OF_REACH + 1, OUT_OF_REACH + 2} == set(status.tolist())
    good = status == 0
    assert np.abs(found("closure", q[good])[0][0]).max() < 1e-12


@pytest.mark.parametrize("name", ["PRS", slow("planar_3rrr")])
def test_the_limb_that_does_not_get_there_is_named(name: str) -> None:
    """Poses on a way that leads away: up to where a limb is stretched all is well, beyond it is that limb."""
    found = model(name)
    made = program(found, "inverse_kinematics")
    texts = status_texts(made)
    names = [texts[OUT_OF_REACH + k].split()[4] for k in range(len(made.reach))]
    assert names == list(made.reach) and len(names) == 3
    random, met = np.random.default_rng(2), set()
    lengths = found.programs["inverse_kinematics"].inputs[0].units.count("m")
    for start in np.repeat(found.system.states(7, 8)[0][1:], 3, 0):  # at the reference limbs are alike
        start = moved(found, start[None], np.zeros((1, len(found.system.tree.v))))[0]
        away = np.zeros_like(start)
        away[:lengths] = random.normal(size=lengths)
        near, far = 0.0, 100 * found.system.length
        while far - near > 1e-9 * found.system.length:
            middle = (near + far) / 2
            beyond = found("inverse_kinematics", start + middle * away)[1] >= OUT_OF_REACH
            near, far = (near, middle) if beyond else (middle, far)
        assert found("inverse_kinematics", start + near * away)[1] in (0, NOT_ON_MECHANISM)
        code = int(found("inverse_kinematics", start + far * away)[1])
        assert [k for k, value in radicands(made, start + far * away).items() if value < 0] == [code]
        met.add(code)
    assert len(met) == 3


def radicands(made: Program, pose: Array) -> dict[int, float]:
    """What the limbs' square roots take, by their statuses."""
    slots: list = [*pose, *[None] * (made.slots - len(pose))]
    with np.errstate(all="ignore"):
        for i in made.instructions:
            slots[i.target] = apply_numpy(i.op, [slots[x] if isinstance(x, int) else x for x in i.args])
    return {code: float(slots[slot]) for slot, *_, code in made.limits if code >= OUT_OF_REACH}


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("name", ["PRS", slow("planar_3rrr")])
def test_every_target_refuses_alike_and_says_why(name: str, tmp_path) -> None:
    found = model(name).only(PLATFORM)
    generate(found, tmp_path / "out", ("c", "numpy"))
    compiled, casadi = load(tmp_path / "out", trusted=True), load(found, backend="casadi")
    module: dict = {}
    text = (tmp_path / "out" / f"{found.name}_numpy.py").read_text(encoding="utf-8")
    exec(compile(text, "module", "exec"), module)
    for function in found.programs:
        inputs = [np.repeat(x[:1], 20, 0) for x in found.test_inputs[function]]
        inputs[0][1::2, 2] += 1e-3 if name != "planar_3rrr" else 0.0
        inputs[0][3::4, :3] += 50 * model(name).system.length
        inputs[0][5::6, 1] = np.nan
        _, status = found(function, *inputs)
        assert {0, 2} < set(status.tolist()) and max(status) >= OUT_OF_REACH
        alone = [int(compiled[function](*(x[k] for x in inputs), check=False)[-1]) for k in range(len(status))]
        together = compiled[function](*inputs, check=False)
        assert alone == status.tolist() == together[-1].tolist() == module[function](*inputs)[1].tolist(), function
        assert casadi[function](*inputs, check=False)[-1].tolist() == status.tolist()
        assert np.isnan(np.asarray(together[0])[status != 0]).all()
    limb = program(found, "inverse_kinematics").reach[0]
    far = found.test_inputs["inverse_kinematics"][0][0].copy()
    far[:3] += 50 * model(name).system.length
    for source in (compiled, casadi):
        with pytest.raises(EvaluationError, match=rf"out of reach: limb {limb} "):
            source["inverse_kinematics"](far)
    table = json.loads((tmp_path / "out" / "manifest.json").read_text())["functions"]["inverse_kinematics"]["status"]
    assert table[str(OUT_OF_REACH)].startswith(f"out of reach: limb {limb} ")
    header = (tmp_path / "out" / f"{found.name}.h").read_text(encoding="utf-8")
    assert f"#define {found.name.upper()}_OUT_OF_REACH_1 {OUT_OF_REACH} /* out of reach: limb {limb} " in header


@pytest.mark.parametrize("name", ["four_bar", slow("RPS")])
def test_variants_look_at_what_they_are_given(name: str) -> None:
    """Consistent states, at rest too, slow and fast, and states off by little and by much in q, v and a."""
    found, random = checked(name), np.random.default_rng(5)
    scales = np.asarray(found.system.scales, dtype=float)
    q, v, a = found.system.states(8, 6)
    weight = rows(found)
    jacobian = found("closure_jacobian", q)[0][0].reshape(len(q), len(scales), -1).swapaxes(1, 2)
    quick = np.abs(v / scales).max(axis=1, keepdims=True)
    sizes = {"v": np.linalg.norm(v / scales, axis=1)}
    sizes["a"] = np.sqrt((a / scales * (a / scales)).sum(axis=1) + sizes["v"] ** 4)
    assert np.all(quick > 0)

    def statuses(function: str, **other: Array) -> set[int]:
        known = {"q": q, "v": v, "a": a, **other}
        made, inputs = found.programs[function], found.test_inputs[function]
        given = [
            known[p.name] if p.name in known else x[[0] * len(q)] for p, x in zip(made.inputs, inputs, strict=True)
        ]
        return {max(0, int(code)) for code in found(function, *given)[1]}

    def off(size: float, which: str) -> Array:
        """v or a with rows of the closure that open by this part of the motion's size."""
        matrix = jacobian * weight[:, None] * scales  # the shortest step, else the motion along would count
        step = (np.linalg.pinv(matrix, rcond=1e-9) @ matrix @ random.normal(size=(*v.shape, 1)))[..., 0]
        opens, step = np.linalg.norm((matrix @ step[..., None])[..., 0], axis=1), step * scales
        return {"v": v, "a": a}[which] + (size * sizes[which] / opens)[:, None] * step

    variants = [name for name in found.programs if name.endswith(SUFFIX)]
    assert {f"{f}{SUFFIX}" for f in ("inverse_dynamics", "forward_dynamics", "velocity", "body_poses")} <= set(variants)
    assert not {f"closure{SUFFIX}", f"assemble{SUFFIX}", f"close_velocity{SUFFIX}"} & set(variants)
    for function in variants:
        ports = {port.name for port in found.programs[function].inputs}
        if "q" not in ports:
            continue
        plain = program(found, function.removesuffix(SUFFIX)).operations["total"]
        assert program(found, function).operations["total"] > plain
        for factor in (0.0, 1e-6, 1.0, 1e6):
            assert statuses(function, v=factor * v, a=factor**2 * a) == {0}, (function, factor)
        open_by = found.system.advance(q, 1e-3 * random.normal(size=v.shape) * scales)
        assert statuses(function, q=open_by) == {NOT_ON_MECHANISM}, function
        for which in {"v", "a"} & ports:
            assert statuses(function, **{which: off(0.9 * CLOSED, which)}) == {0}, (function, which)
            assert statuses(function, **{which: off(1.2 * CLOSED, which)}) == {NOT_ON_MECHANISM}, (function, which)


@pytest.mark.slow
def test_variants_of_the_platforms_functions_look_at_rates_and_accelerations() -> None:
    found = checked("RPS")
    pose, rate, gain = found.test_inputs["inverse_dynamics_platform"]
    for function, motion in (("inverse_velocity", [rate]), ("inverse_dynamics_platform", [rate, gain])):
        assert not found(function + SUFFIX, pose, *motion)[1].any()
        for k in range(len(motion)):
            other = [np.array(x) for x in motion]
            other[k][:, 3:] += 1e-3 * np.abs(other[k]).max()
            assert not found(function, pose, *other)[1].any()
            assert (found(function + SUFFIX, pose, *other)[1] == NOT_ON_MECHANISM).all()
