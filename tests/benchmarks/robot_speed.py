"""`python -m tests.benchmarks.robot_speed FILE ... [--repeats N]`: robots' files beside Pinocchio and MuJoCo in time.

For every URDF or MJCF file, as `symscrew benchmark FILE --against pinocchio mujoco` prints it, with every hinge and
slide driven, as the others have it: median ns per state of one call after another, in turns with theirs, after all
results agree to 1e-9. A line per robot. Nothing is fetched: which files there are is for whoever calls.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.formats import ImportOptions, import_file
from symscrew.model import derive
from symscrew.runtime import CompileError
from symscrew.studies.benchmark import time_functions

from .tables import table

FUNCTIONS = ("inverse_dynamics", "forward_dynamics", "mass_matrix")
HEADER = ("robot", "freedoms", "function", "operations", "ns", "Pinocchio ns", "times", "MuJoCo ns", "times")


def driven(mechanism: Mechanism) -> Mechanism:
    """The mechanism with a drive on every hinge and slide."""
    joints = {
        name: replace(joint, driven=(0,) if joint.kind.freedom == 1 else joint.driven)
        for name, joint in mechanism.joints.items()
    }
    return replace(mechanism, joints=joints)


def lines(path: Path, repeats: int) -> Iterator[tuple[object, ...]]:
    """A line per function."""
    found = import_file(path, ImportOptions(accept=True, repair=True)).mechanism
    model = derive(found if len(found.joints) >= len(found.bodies) or found.couplings else driven(found))
    names = [name for name in FUNCTIONS if name in model.programs]
    try:
        rows, notes = time_functions(model, names, ("pinocchio", "mujoco"), repeats=repeats)
    except CompileError as error:  # MuJoCo needs inertia in every body, and is given some that the file has not
        if "mujoco" not in str(error):
            raise
        print(f"{path.name}: without MuJoCo: {error}", flush=True)
        rows, notes = time_functions(model, names, ("pinocchio",), repeats=repeats)
    for note in notes:
        if "no function of this kind" not in note:
            print(f"{path.name}: not compared: {note}", flush=True)
    for name in names:
        mine = next(row for row in rows if row.function == name and row.variant == "one state")
        cells: list[object] = []
        for peer in ("pinocchio", "mujoco"):
            other = [
                r.times.median for r in rows if r.function == name and peer in r.variant.lower() and ":" in r.variant
            ]
            cells += [f"{min(other):.0f}", f"{min(other) / mine.times.median:.1f}"] if other else ["", ""]
        freedoms = len(model.system.tree.v) - len(model.system.jacobian)
        yield found.name, freedoms, name, mine.operations, f"{mine.times.median:.0f}", *cells


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--repeats", type=int, default=15)
    options = parser.parse_args(arguments)
    found: list[tuple[object, ...]] = []
    for path in options.files:
        try:
            found += lines(path, options.repeats)
        except (DescriptionError, CompileError) as error:
            print(f"{path}: {error}", flush=True)
    print(table(HEADER, found))


if __name__ == "__main__":
    main()
