"""The kinematics between drives and a tool, compiled for this machine: there and back at the states of a model.

q --> drives --forward, from the reference--> axes --inverse--> drives again
       |                                       |
       evaluator                               evaluator
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from symscrew.export import DriveKinematics, print_drive_host
from symscrew.generation.target_file import Finding
from symscrew.runtime import compile_c

AGREEING = 1e-9  # of the characteristic length, or rad: both ways end within 1e-11, times what the mechanism amplifies
REACHED = 0.8  # part of the states that must be reached from the reference: the others lie beyond a singularity


Floats = Sequence[float] | np.ndarray


@dataclass(frozen=True)
class Follower:
    """The compiled kinematics; arrays are in m and rad, of one state each."""

    library: ctypes.CDLL
    kinematics: DriveKinematics

    def forward(self, q: np.ndarray, joints: Floats, tool: Floats = (0, 0, 0)) -> tuple[int, np.ndarray]:
        """Status and axes X ... C of the tool; `q` is where it starts, and where it is afterwards."""
        world = np.zeros(6)
        return self._call("forward", q, np.array(tool, float), np.array(joints, float), world), world

    def inverse(self, q: np.ndarray, world: Floats, tool: Floats = (0, 0, 0)) -> tuple[int, np.ndarray]:
        """Status and drives for axes of the tool."""
        joints = np.zeros(len(self.kinematics.drives))
        return self._call("inverse", q, np.array(tool, float), np.array(world, float), joints), joints

    def jacobian(self, q: np.ndarray, tool: Floats = (0, 0, 0)) -> tuple[int, np.ndarray, float]:
        """Status, rates (6, freedoms) of the axes by the chosen drives, and the least margin to a singularity."""
        found, margin = np.zeros((len(self.kinematics.chosen), 6)), np.zeros(1)
        status = self._call("jacobian", q, np.array(tool, float), found, margin)
        return status, found.T, float(margin[0])

    def mode(self, q: np.ndarray) -> int:
        """The sign of the branch."""
        return self._call("mode", q)

    def _call(self, name: str, *arrays: np.ndarray) -> int:
        return int(
            self.library[f"{self.kinematics.model.name}_{name}"](*[ctypes.c_void_p(x.ctypes.data) for x in arrays])
        )


def compiled(kinematics: DriveKinematics, directory: Path) -> Follower:
    """Compile the part for this machine in a folder.

    Raises:
        CompileError: there is no C compiler, or it refuses the file.
    """
    for file, text in print_drive_host(kinematics).items():
        (directory / file).write_text(text)
    library = directory / f"lib{kinematics.model.name}.so"
    compile_c(directory / f"{kinematics.model.name}_host.c", library, flags=(f"-I{directory}",))
    return Follower(ctypes.CDLL(str(library)), kinematics)


def tool_axes(kinematics: DriveKinematics, q: np.ndarray) -> np.ndarray:
    """Axes X ... C (states, 6) of the tool by the evaluator."""
    found = kinematics.values("body_poses", q)
    own = found[:, 12 * kinematics.platform : 12 * kinematics.platform + 12].reshape(-1, 4, 3)
    at = own[:, 3] + np.einsum("nji,j->ni", own[:, :3], np.array(kinematics.tool))
    x, y, z = own[:, 0], own[:, 1], own[:, 2]
    angles = [
        np.arctan2(y[:, 2], z[:, 2]),
        np.arctan2(-x[:, 2], np.hypot(x[:, 0], x[:, 1])),
        np.arctan2(x[:, 1], x[:, 0]),
    ]
    return np.column_stack([at, *angles])


def round_trip(kinematics: DriveKinematics, directory: Path) -> Finding:
    """There and back at the model's sample states, against the evaluator."""
    follower = compiled(kinematics, directory)
    states = np.atleast_2d(kinematics.model.system.sample_states[0])
    expected, length = tool_axes(kinematics, states), float(kinematics.model.system.length)
    unit = np.array([length] * 3 + [1.0] * 3)
    drives = [length if k in kinematics.sliding else 1.0 for k in kinematics.driven]
    worst, reached = 0.0, 0
    for q, axes in zip(states, expected, strict=True):
        now = np.array(kinematics.model.system.reference)
        joints = q[list(kinematics.driven)]
        status, world = follower.forward(now, joints)
        if status:
            continue
        reached += 1
        there, back = follower.inverse(now, world)
        if there:
            return False, f"the way back from {np.round(world, 4).tolist()} fails with status {there}"
        difference = (np.abs(world - axes) / unit).max()
        worst = max(worst, float(difference), float((np.abs(back - joints) / drives).max()))
    text = (
        f"drives and tool agree with the evaluator there and back to {worst:.1e} at {reached} of {len(states)} states"
    )
    return worst <= AGREEING and reached >= REACHED * len(states), text
