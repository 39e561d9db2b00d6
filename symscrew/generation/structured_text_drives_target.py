"""Target "st_drives": a function block between drives and a tool, followed there and back by matiec where it is."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from symscrew.export import DriveKinematics, find_drive_kinematics, print_structured_text_drives
from symscrew.generation.drive_round_trip import AGREEING, tool_axes
from symscrew.generation.structured_text_target import LIMIT, translated
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.runtime import find_compiler

CALL = """\
    static KIND block;
    KIND_init__(&block, 0);
    for (;;) {
        const double first = next();
        if (!(first == first)) {
            break;
        }
        for (int k = 0; k < JOINTS; ++k) {
            block.JOINT.value.table[k] = k > 0 ? next() : first;
        }
        block.RESET.value = 1; /* each from the reference */
        block.INVERSE.value = 0;
        KIND_body__(&block);
        told(block.STATUS.value);
        for (int k = 0; k < 6; ++k) {
            block.WORLD.value.table[k] = block.AXES.value.table[k];
            told(block.AXES.value.table[k]);
        }
        block.RESET.value = 0;
        block.INVERSE.value = 1;
        KIND_body__(&block);
        told(block.STATUS.value);
        for (int k = 0; k < JOINTS; ++k) {
            told(block.DRIVES.value.table[k]);
        }
    }
"""


def files(order: Order) -> Mapping[str, str]:
    """<name>_drives.st."""
    return print_structured_text_drives(order.model, find_drive_kinematics(order.model))


def compare(case: Case) -> Iterator[Finding]:
    """There and back at the sample states that are reached from the reference, by matiec."""
    if shutil.which("iec2c") is None or find_compiler() is None:
        yield True, "no matiec (iec2c) here: structured text of the drives not run"
        return
    yield there_and_back(find_drive_kinematics(case.model), case.fresh)


def there_and_back(kinematics: DriveKinematics, directory: Path) -> Finding:
    """What matiec and a C compiler make of <name>_drives.st in a folder, against the evaluator."""
    name, count = kinematics.model.name, len(kinematics.drives)
    calls = CALL.replace("KIND", f"{name}_kinematics".upper()).replace("JOINTS", str(count))
    failed = translated(directory, f"{name}.st", [f"  a_block : {name}_kinematics;"], calls.splitlines())
    if failed:
        return False, failed
    states = np.atleast_2d(kinematics.model.system.sample_states[0])
    joints = states[:, list(kinematics.driven)]
    made = subprocess.run(
        [str(directory / "main")], input=joints.astype("<f8").tobytes(), capture_output=True, check=True, timeout=LIMIT
    )
    found = np.frombuffer(made.stdout, "<f8").reshape(len(states), 8 + count)
    reached = found[:, 0] == 0
    length = float(kinematics.model.system.length)
    drives = [length if k in kinematics.sliding else 1.0 for k in kinematics.driven]
    off = np.abs(found[:, 1:7] - tool_axes(kinematics, states)) / ([length] * 3 + [1.0] * 3)
    back = np.abs(found[:, 8:] - joints) / drives
    worst = float(np.maximum(off.max(axis=1), back.max(axis=1))[reached].max(initial=0.0))
    good = bool((found[reached, 7] == 0).all()) and reached.any() and worst <= AGREEING
    text = f"structured text of the drives: there and back to {worst:.1e} at {reached.sum()} of {len(states)} states"
    return good, text
