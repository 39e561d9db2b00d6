"""Kinematics of controllers: a million poses there and back on four machines, and beside LinuxCNC's genhexkins.

genhexkins is not ours and not here: GENHEXKINS names a folder with genhexkins.c, genhexkins.h, switchkins.c,
switchkins.h, kinematics.h and _posemath.c of LinuxCNC 2.9 as they are; other headers are those of Debian's package.
Without it the comparison is left out.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from support.drive_ways import AMPLITUDES, HEADERS, HERE, STUB, Way, built, followed

from symscrew import catalogue
from symscrew.description import Mechanism, MechanismBuilder
from symscrew.export import DriveKinematics, find_drive_kinematics
from symscrew.model import derive

from .tables import table

MILLION = 1_000_000
COUNTED = 20_000  # poses in which steps of the other module are counted
# The ends of the struts by default in genhexkins.h of LinuxCNC 2.9, in machine units; here a unit is a millimetre.
BASE = [(-22.95, 13.25), (22.95, 13.25), (22.95, 13.25), (0.0, -26.5), (0.0, -26.5), (-22.95, 13.25)]
PLATFORM = [(-1.0, 11.5), (1.0, 11.5), (10.459, -4.884), (9.459, -6.616), (-9.459, -6.616), (-10.459, -4.884)]
HEIGHT = 20.0  # of the platform at home, as in LinuxCNC's sample configuration hexapod-sim
WAYS = {  # lengths and degrees about home; the platform turned by 90 degrees about its axis is singular
    "near home": {"X": 4, "Y": 4, "Z": 4, "A": 8, "B": 8, "C": 8},
    "wide": {"X": 8, "Y": 8, "Z": 6, "A": 15, "B": 15, "C": 40},
    "to a singularity": {"C": 89.9},
    "past it": {"C": 120},
}
HEADER = [
    "poses", "refused", "wrong", "largest error", "inverse [us]", "forward [us]", "configurations a forward call",
]  # fmt: skip
GLUE = """
#include <hal.h>
#include <kinematics.h>
#include <math.h>
#include <rtapi.h>
void rtapi_print(const char *f, ...) { (void)f; }
void rtapi_print_msg(msg_level_t l, const char *f, ...) { (void)l; (void)f; }
int pm_sincos(double a, double *s, double *c) { *s = sin(a); *c = cos(a); return 0; }
int hal_pin_bit_new(const char *n, hal_pin_dir_t d, hal_bit_t **p, int c) { return hal_pin_bit_newf(d, p, c, "%s", n); }
int hal_pin_float_new(const char *n, hal_pin_dir_t d, hal_float_t **p, int c)
{ return hal_pin_float_newf(d, p, c, "%s", n); }
#define OTHER(k) \\
    int k##Setup(const int a, const char *b, kparms *c) { (void)a; (void)b; (void)c; return 0; } \\
    int k##Forward(const double *a, EmcPose *b, const KINEMATICS_FORWARD_FLAGS *c, KINEMATICS_INVERSE_FLAGS *d) \\
    { (void)a; (void)b; (void)c; (void)d; return -1; } \\
    int k##Inverse(const EmcPose *a, double *b, const KINEMATICS_INVERSE_FLAGS *c, KINEMATICS_FORWARD_FLAGS *d) \\
    { (void)a; (void)b; (void)c; (void)d; return -1; }
OTHER(identityKinematics)
OTHER(userkKinematics)
"""


def hexapod() -> Mechanism:
    """genhexkins' default machine: a unit of it is a millimetre; the masses do not matter."""
    made = MechanismBuilder("hexapod", platform="platform")
    top = f"{HEIGHT}/1000"
    made.body("platform", mass=1, com=[0, 0, top], inertia=[1, 1, 1])
    for k, ((bx, by), (px, py)) in enumerate(zip(BASE, PLATFORM, strict=True), 1):
        ends = [[f"{bx}/1000", f"{by}/1000", 0], [f"{px}/1000", f"{py}/1000", top]]
        dx, dy = f"({px - bx!r}/1000)", f"({py - by!r}/1000)"
        across = f"sqrt({dx}^2 + {dy}^2)"
        length = f"sqrt({dx}^2 + {dy}^2 + ({top})^2)"  # a joint's coordinate is the length of its strut
        flat = [f"-{dy}/{across}", f"{dx}/{across}", 0]
        steep = [f"-{top}*{dx}/({across}*{length})", f"-{top}*{dy}/({across}*{length})", f"{across}/{length}"]
        made.limb(
            f"leg{k}", "UPS", base="base", tip="platform", points=ends, axes=[[flat, steep], [], []],
            reference=[[0, 0], length, []],
        )  # fmt: skip
    made.point("tool", body="platform", at=[0, 0, top])
    return made.build()


def genhexkins(folder: Path, place: Path, *more: str) -> Path:
    """Their module with the harness, by further options of the compiler."""
    (place / "glue.c").write_text(GLUE)
    own = [str(folder / file) for file in ("genhexkins.c", "switchkins.c", "_posemath.c")]
    flags = ["-std=gnu11", "-O2", "-w", "-DRTAPI", "-DSIM", "-DUSPACE", "-D__MODULE__", f"-I{folder}", f"-I{HEADERS}"]
    flags += more
    sources = [str(place / "glue.c"), *own, str(HERE / "harness.c")]
    subprocess.run(["cc", *flags, *sources, "-o", str(place / "genhexkins"), "-lm"], check=True, cwd=place)
    return place / "genhexkins"


def row(way: Way) -> list[str]:
    times = [f"{way.inverse_time:.2f}", f"{way.forward_time:.2f}", f"{way.forward_steps:.2f}"]
    return [f"{way.poses:,}", f"{way.refused:,}", f"{way.wrong:,}", f"{way.error:.1e}", *times]


def run(repeats: int = 1) -> tuple[str, dict[str, Any]]:
    """The tables, and the numbers."""
    headers = HEADERS if HEADERS.is_dir() else STUB
    raw: dict[str, Any] = {}
    rows = []
    with tempfile.TemporaryDirectory() as place:
        for name, amplitudes in AMPLITUDES.items():
            folder = Path(place) / name
            folder.mkdir()
            model = derive(catalogue.load(name))
            own = find_drive_kinematics(model)
            way = followed(built(model, own, folder, headers), own, MILLION * repeats, amplitudes)
            rows.append([name, *row(way)])
            raw[name] = vars(way)
        text = table(["machine", *HEADER], rows)
        theirs = os.environ.get("GENHEXKINS")
        if theirs:
            found, numbers = beside(Path(theirs), Path(place), MILLION // 10 * repeats)
            text, raw = f"{text}\n\n{found}", {**raw, "genhexkins": numbers}
    return text, raw


def beside(theirs: Path, place: Path, poses: int) -> tuple[str, dict[str, Any]]:
    """Both modules on the same ways of genhexkins' default machine."""
    model = derive(hexapod())
    own = find_drive_kinematics(model)
    programs = {"symscrew": built(model, own, place, HEADERS), "genhexkins": genhexkins(theirs, place)}
    rows, raw = [], {}
    for name, amplitudes in WAYS.items():
        size = {k: float(x) for k, x in amplitudes.items()}
        for module, program in programs.items():
            way = followed(program, own, poses, size)
            steps = way.forward_steps if module == "symscrew" else iterations(theirs, place, own, size)
            rows.append([name, module, *row(way)[:-1], f"{steps:.2f}"])
            raw[f"{name}, {module}"] = {**vars(way), "steps": steps}
    return table(["way", "module", *HEADER[:-1], "Newton steps a forward call"], rows), raw


def iterations(theirs: Path, place: Path, own: DriveKinematics, size: dict[str, float]) -> float:
    """Steps of Newton's method of a forward call of theirs, counted by gcov: their pin is of its second half."""
    counted = place / "counted"
    shutil.rmtree(counted, ignore_errors=True)
    counted.mkdir()
    followed(genhexkins(theirs, counted, "-O0", "--coverage"), own, COUNTED, size)
    notes = next(path.name for path in counted.iterdir() if path.name.endswith("genhexkins.gcno"))
    subprocess.run(["gcov", notes], cwd=counted, check=True, capture_output=True)
    rows = (counted / "genhexkins.c.gcov").read_text(encoding="utf-8").splitlines()
    times = next(row.split(":")[0] for row in rows if row.endswith("    iteration++;"))
    return int(times.strip(" *")) / COUNTED
