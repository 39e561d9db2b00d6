"""LinuxCNC kinematics of a model: a module with `kinematicsForward`, `kinematicsInverse`, pins and units.

    halcompile --compile <name>kins.c          KINEMATICS = <name>kins in the ini file

The forward kinematics follow the mode of the last pose in steps that are proved, and refuse what none lead to.
The interface is that of `kinematics.h` of LinuxCNC 2.9 and of its master branch; neither has functions for a Jacobian
or a tool frame, so that these are pins.
"""

from __future__ import annotations

from symscrew.export.drive_kinematics import DriveKinematics
from symscrew.export.drive_kinematics_c import axes_text, kinematics_part, print_functions, template, unit_tables
from symscrew.export.listing import banner, check_names, plain, wrapped
from symscrew.model import Model

TEMPLATE = "linuxcnc_kins.c"
INCLUDES = ("rtapi.h", "rtapi_app.h", "hal.h", "kinematics.h")


def print_linuxcnc(model: Model, kinematics: DriveKinematics) -> dict[str, str]:
    """File name to text: `<name>kins.c`, and `<name>_drives.h`, `<name>_drives.c`, which it includes."""
    check_names(model)
    name = f"{model.name}kins"
    about = [*banner(model)[:3], *wrapped(plain(axes_text(kinematics)), later="  ")]
    lines = ["/*", *(f" * {line}".rstrip() for line in about), " */"]
    lines += [*(f"#include <{file}>" for file in INCLUDES), "", f'#include "{kinematics.model.name}.c"', ""]
    lines += [
        *kinematics_part(kinematics),
        *unit_tables(kinematics),
        "",
        *template(TEMPLATE).replace("KINS.", f"{name}.").splitlines(),
    ]
    text = "\n".join([*lines, ""]).replace('hal_init("KINS")', f'hal_init("{name}")')
    return {f"{name}.c": text, **print_functions(kinematics)}
