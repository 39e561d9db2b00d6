"""Structured text: accepted by a grammar of IEC 61131-3 that is not ours, and by matiec; equal to the evaluator."""

from __future__ import annotations

import dataclasses
import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.limb_platforms import platform
from support.marks import slow
from support.model_states import model
from support.structured_text import blocks

from symscrew.export import (
    block_ports,
    find_drive_kinematics,
    print_structured_text,
    print_structured_text_drives,
)
from symscrew.generation import generate, structured_text_target
from symscrew.generation.drive_round_trip import tool_axes
from symscrew.generation.rust_target import call
from symscrew.generation.structured_text_drives_target import there_and_back
from symscrew.model import Model, derive
from symscrew.program import NOT_ON_MECHANISM, OUT_OF_REACH
from symscrew.verification import check

LIMIT = 1e-12  # of the largest entry of an array: rounding


@pytest.fixture
def grammar() -> None:
    pytest.importorskip("tree_sitter_iec61131_3_st", reason="needs the extra 'plc'")


def text_of(found: Model) -> str:
    (text,) = print_structured_text(found).values()
    return text


def differences(found: Model, made: Mapping[str, Any], given: Mapping[str, Any]) -> tuple[list[str], set[int]]:
    """Where blocks and evaluator differ, the second path apart, and the statuses that came."""
    wrong, seen = [], set[int]()
    for name, arrays in given.items():
        program = found.programs[name]
        inputs, outputs = block_ports(program)
        expected, status = found(name, *arrays)
        instance = made[f"{found.name}_{name}".lower()]()
        for k in range(len(arrays[0])):
            instance(**{n.lower(): x[k].tolist() for n, x in zip(inputs, arrays, strict=True)})
            wanted = int(np.atleast_1d(status)[k])
            wanted = 1 if wanted < 0 else wanted
            seen.add(instance.status)
            if instance.status != wanted or instance.valid != (wanted == 0):
                wrong.append(f"{name}: {instance.status}, expected {wanted}")
            for port, symbol, array in zip(program.outputs, outputs, expected, strict=True):
                if wanted == 0 and port.size:
                    off = np.abs(np.array(getattr(instance, symbol.lower())) - array[k]).max()
                    if not off <= LIMIT * max(float(np.abs(array[k]).max()), 1e-3):
                        wrong.append(f"{name}, {port.name}: {off}")
    return wrong, seen


@pytest.mark.parametrize("name", ["four_bar", slow("planar_3rrr"), slow("ur5")])
def test_blocks_compute_what_the_evaluator_does(name: str, grammar: None) -> None:
    found = model(name)
    wrong, seen = differences(found, blocks(text_of(found)), found.test_inputs)
    assert wrong == [] and 0 in seen


def test_what_is_refused_is_refused_with_the_same_status(grammar: None) -> None:
    """Lengths of quaternions, poses off the mechanism and out of reach, infinite numbers; the last success stays."""
    names = ("inverse_kinematics", "assemble", "velocity")
    found = derive(platform("PRS")).only(names)
    given: dict[str, list[np.ndarray]] = {}
    for name in names:
        ports = found.programs[name].inputs
        port = next((p for p in ports if p.forms), ports[0])
        rows = []
        for size, shift in ((1.0, 0.0), (1 + 6e-7, 0.0), (0.0, 0.0), (1.0, 1e-3), (1.0, 50.0), (np.nan, 0.0)):
            row = [np.array(x[1]) for x in found.test_inputs[name]]
            turned = [k for k, form in enumerate(port.forms) if form] or [0]
            row[ports.index(port)][turned] *= size
            row[ports.index(port) if name == "inverse_kinematics" else 0][:3] += shift
            rows.append(row)
        given[name] = [np.array(column) for column in zip(*rows, strict=True)]
    wrong, seen = differences(found, blocks(text_of(found)), given)
    assert wrong == [] and seen >= {0, 2, 5, NOT_ON_MECHANISM} and max(seen) >= OUT_OF_REACH
    instance = blocks(text_of(found))[f"{found.name}_velocity".lower()]()
    inputs, (v,) = block_ports(found.programs["velocity"])
    good = [x[1].tolist() for x in found.test_inputs["velocity"]]
    instance(**dict(zip((n.lower() for n in inputs), good, strict=True)))
    before = list(getattr(instance, v.lower()))
    instance(**dict(zip((n.lower() for n in inputs), [[np.nan] * len(good[0]), *good[1:]], strict=True)))
    assert instance.status == 2 and not instance.valid and getattr(instance, v.lower()) == before


def test_names_differ_in_more_than_case_and_are_no_words(grammar: None) -> None:
    found = model("four_bar").only(["velocity"])
    program = found.programs["velocity"]
    ports = [dataclasses.replace(p, name=n) for p, n in zip(program.inputs, ("array", "Array"), strict=True)]
    made = [dataclasses.replace(p, name="status") for p in program.outputs]
    renamed = dataclasses.replace(program, inputs=tuple(ports), outputs=tuple(made))
    changed = dataclasses.replace(found, programs={"velocity": renamed})
    text = text_of(changed)
    inside = re.findall(r"^  (\w+) : ", text, re.MULTILINE)
    assert len({name.lower() for name in inside}) == len(inside) and not re.search(r"\w__\w", text)
    wrong, _ = differences(changed, blocks(text), {"velocity": found.test_inputs["velocity"]})
    assert wrong == []


def test_loops_have_bounds_and_nothing_is_of_a_vendor() -> None:
    text = text_of(model("four_bar"))
    code = re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL)
    for condition in re.findall(r"WHILE (.*?) DO", code):
        assert re.match(r"(\w+) < |substeps <= \d+", condition), condition
    assert not re.search(r"\b(REPEAT|POINTER|REFERENCE|__NEW|FOR|VAR_IN_OUT|UNTIL)\b|\^|\{|//", code)


@pytest.mark.parametrize("name", ["four_bar"])
def test_matiec_takes_it(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if shutil.which("iec2c") is None:
        pytest.skip("needs iec2c of matiec, from its sources, with its folder lib beside it")
    found = model(name).only(
        ["assemble", "velocity", "inverse_dynamics_platform", "limb_margins", "inverse_kinematics"]
    )
    generate(found, tmp_path / "out", ["st"])
    assert any("structured text agrees with the evaluator" in line for line in check(tmp_path / "out").lines)
    halved = structured_text_target.MAIN.replace("fwrite(&value", "value *= 0.5; fwrite(&value")
    monkeypatch.setattr(structured_text_target, "MAIN", halved)
    assert not check(tmp_path / "out").ok
    given = {"velocity": found.test_inputs["velocity"]}
    monkeypatch.undo()
    (tmp_path / f"{name}.st").write_text(text_of(found))
    assert structured_text_target.build(found, tmp_path) == ""
    (v,), _ = call(found, tmp_path, given, np.dtype("<f8"))["velocity"]
    assert np.abs(v - found("velocity", *given["velocity"])[0][0]).max() < LIMIT


@pytest.mark.parametrize("name", ["five_bar", slow("three_ups_upu_s")])
def test_drives_to_tool_and_back(name: str, grammar: None) -> None:
    """The block that keeps the configuration: axes of the evaluator with a tool, back to the drives, refusals of C."""
    own = find_drive_kinematics(model(name))
    (text,) = print_structured_text_drives(model(name), own).values()
    machine = blocks(text)[f"{own.model.name}_kinematics"]()
    offset, idle = [0.03, -0.02, 0.05], {"joint": [0.0] * len(own.drives), "world": [0.0] * 6, "tool": [0.0] * 3}
    states = np.atleast_2d(own.model.system.sample_states[0])[:3]
    tooled = dataclasses.replace(own, tool=tuple(np.add(own.tool, offset)))
    for q, axes in zip(states, tool_axes(tooled, states), strict=True):
        joints = q[list(own.driven)].tolist()
        machine(**{**idle, "inverse": False, "reset": True, "joint": joints, "tool": offset})
        assert machine.status == 0 and machine.valid and np.abs(np.array(machine.axes) - axes).max() < 1e-10
        for reset in (False, True):  # from here, and from the reference
            machine(**{**idle, "inverse": True, "reset": reset, "world": list(machine.axes), "tool": offset})
            assert machine.status == 0 and np.abs(np.array(machine.drives) - joints).max() < 1e-9
    here = list(machine.q)
    machine(**{**idle, "inverse": True, "reset": False, "world": [0.0, 0.0, 9.0, 3.0, 1.4, 0.0]})
    assert machine.status > 0 and not machine.valid and machine.q == here
    machine(**{**idle, "inverse": False, "reset": False, "joint": [np.nan] * len(own.drives)})
    assert machine.status == 2 and machine.q == here


def test_matiec_takes_the_drives(tmp_path: Path) -> None:
    if shutil.which("iec2c") is None:
        pytest.skip("needs iec2c of matiec, from its sources, with its folder lib beside it")
    own = find_drive_kinematics(model("five_bar"))
    for file, text in print_structured_text_drives(model("five_bar"), own).items():
        (tmp_path / file).write_text(text)
    good, text = there_and_back(own, tmp_path)
    assert good and "there and back to" in text
