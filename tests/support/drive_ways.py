"""Ways of poses about the reference for kinematics between drives and a tool, and LinuxCNC modules that follow them."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from symscrew.export import DriveKinematics, print_linuxcnc
from symscrew.model import Model

HERE = Path(__file__).parent / "linuxcnc"
HEADERS = Path("/usr/include/linuxcnc")  # Debian's linuxcnc-uspace-dev
STUB = HERE / "stub"
AMPLITUDES = {  # mm or degrees about the reference, far from singularities
    "five_bar": {"X": 60, "Z": 60},
    "delta": {"X": 60, "Y": 60, "Z": 60},
    "stewart_6ups": {"X": 50, "Y": 50, "Z": 50, "A": 10, "B": 10, "C": 10},
    "three_ups_upu_s": {"A": 15, "B": 15},
}


@dataclass(frozen=True)
class Way:
    """What the harness says of a way: lengths in mm, angles in degrees, microseconds, configurations a call."""

    poses: int
    refused: int
    wrong: int
    error: float
    inverse_time: float
    inverse_steps: float
    forward_time: float
    forward_steps: float
    pins: dict[str, float]


def home(kinematics: DriveKinematics) -> list[str]:
    """The joints of the reference in mm and degrees."""
    q = np.array(kinematics.model.system.reference)
    return [repr(float(q[k] * (1000 if k in kinematics.sliding else 180 / np.pi))) for k in kinematics.driven]


def built(found: Model, kinematics: DriveKinematics, folder: Path, headers: Path, *, level: str = "-O2") -> Path:
    """The module with the harness as a program."""
    for file, text in print_linuxcnc(found, kinematics).items():
        (folder / file).write_text(text)
    defined = ["-DRTAPI", "-DSIM", "-DUSPACE", "-D__MODULE__"] if headers != STUB else []
    sources = [str(HERE / "harness.c"), str(folder / f"{found.name}kins.c")]
    command = ["cc", "-std=gnu11", "-Wall", "-Werror", level, *defined, f"-I{headers}", f"-I{folder}", *sources]
    subprocess.run([*command, "-o", str(folder / "harness"), "-lm"], check=True)
    return folder / "harness"


def followed(program: Path, kinematics: DriveKinematics, poses: int, amplitudes: dict[str, float]) -> Way:
    """The harness on ways of so many poses, forward kinematics started at that of the reference."""
    joints = home(kinematics)
    axes = [text for letter, size in amplitudes.items() for text in (str("XYZABC".index(letter)), str(size))]
    command = [str(program), str(poses), str(len(joints)), *joints, *axes]
    start = {"START_Z": repr(1000 * kinematics.tool[2])}
    lines = subprocess.run(command, capture_output=True, text=True, check=True, env=start).stdout.splitlines()
    first = lines[0].split()
    pins = {name: float(value) for name, value in (line.split() for line in lines[1:])}
    return Way(*map(int, first[:3]), *map(float, first[3:]), pins)
