"""C of the kinematics between drives and a tool: functions of the model, tables, and the part that follows a mode.

<name>_drives.h, <name>_drives.c    the functions that it calls
tables, then drive_kinematics.c     state, forward, inverse, Jacobian: `static`, for the file of a controller
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import resources

import numpy as np

from symscrew.export.c import print_c
from symscrew.export.drive_kinematics import LETTERS, MARGINS, DriveKinematics
from symscrew.export.listing import decimal, wrapped
from symscrew.export.mode_certificate import certificate_part
from symscrew.program import Iteration

HOST = "drive_kinematics_host.c"
TEMPLATE = "drive_kinematics.c"
AXES = ("X", "Y", "Z", "w", "x", "y", "z")  # as `drive_backward` has them


def template(file: str) -> str:
    """The text of a template of this folder."""
    return resources.files("symscrew.export").joinpath(file).read_text("utf-8")


def print_functions(kinematics: DriveKinematics) -> dict[str, str]:
    """<name>_drives.h and <name>_drives.c."""
    return print_c(kinematics.model, batches=False, lanes=False)


def tables(kinematics: DriveKinematics) -> list[str]:
    """Sizes, tables and calls for the template."""
    model, system = kinematics.model, kinematics.model.system
    length = float(system.length)
    sliding = set(kinematics.sliding)
    chosen = [kinematics.driven[k] for k in kinematics.chosen]
    poses = model.programs["body_poses"].outputs[0].size
    count = max((model.programs[name].outputs[0].size for name in MARGINS if name in model.programs), default=1)
    sizes = {
        "N_JOINTS": len(kinematics.drives),
        "N_FREE": len(chosen),
        "N_Q": len(system.tree.q),
        "N_V": len(system.tree.v),
        "N_POSES": poses,
        "PLATFORM": 12 * kinematics.platform,
        "N_MARGINS": count,
        "CLOSED_FORM": int(bool(kinematics.pose.entries)),
    }
    lines = [f"#define {name} {size}" for name, size in sizes.items()]
    lines += [f"#define PER_LENGTH {decimal(1 / length)}", "#define PI 3.14159265358979323846", ""]
    lines += _calls(kinematics)
    lines += ["", *_array("double", "reference_q", np.array(system.reference))]
    lines += _array("int", "chosen_joint", kinematics.chosen) + _array("int", "chosen_q", chosen)
    if not kinematics.pose.entries:
        lines += _array("double", "chosen_unit", [length if k in sliding else 1.0 for k in chosen])
        lines += _array("int", "commanded", kinematics.axes)
    lines += _array("int", "driven_q", kinematics.driven)
    lines += _array("double", "tool_point", kinematics.tool)
    if kinematics.pose.entries:
        lines += _array("int", "pose_entry", [AXES.index(name) for name in kinematics.pose.entries])
        lines += _array("double", "pose_centre", kinematics.pose.centre)
    values = np.array(system.parameter_values, dtype=float)
    return [*lines, *(_array("double", "parameters", values) if len(values) else [])]


def unit_tables(kinematics: DriveKinematics) -> list[str]:
    """Which joints are lengths, and which axes are commanded, for controllers with units of their own."""
    axes = _array("int", "commanded", kinematics.axes) if kinematics.pose.entries else []
    return axes + _array("int", "joint_sliding", [int(k in kinematics.sliding) for k in kinematics.driven])


def _array(kind: str, name: str, values: Sequence[float] | np.ndarray) -> list[str]:
    """A constant array; one without entries has one that nobody reads."""
    texts = [str(int(x)) if kind == "int" else decimal(float(x)).strip("()") for x in values] or ["0"]
    text = f"static const {kind} {name}[{len(texts)}] = {{{', '.join(texts)}}};"
    return wrapped(text, later="    ", width=110)


def _calls(kinematics: DriveKinematics) -> list[str]:
    """Macros of the functions, with run-time parameters at their values."""
    model = kinematics.model
    lines = []
    for name, program in model.programs.items():
        if name in MARGINS:
            continue
        own = [port.name for port in program.inputs if port.name != "p"]
        given = ", ".join(["parameters" if port.name == "p" else port.name for port in program.inputs])
        if isinstance(program, Iteration):
            further = ", parameters" if len(program.inputs) > len(own) else ""
            made = "next, residual, change, orientation"
            step = f"#define {name.upper()}_STEP(q, y, {made}) {model.name}_{name}_step(q, y{further}, {made})"
            lines += wrapped(step, width=200)
        lines.append(f"#define {name.upper()}({', '.join([*own, 'out'])}) {model.name}_{name}({given}, out)")
    return lines


def margins(kinematics: DriveKinematics) -> str:
    """Statements that find the least margin."""
    model = kinematics.model
    lines = []
    for name in MARGINS:
        if name in model.programs:
            program = model.programs[name]
            given = ", ".join("parameters" if port.name == "p" else "state->q" for port in program.inputs)
            # of the drives only what is left with all of them locked: some pairs may well be singular
            size = 1 if name == "actuation_margins" else program.outputs[0].size
            lines += [
                f"if ({model.name}_{name}({given}, margins) > 0) {{",
                "    return 0.0;",
                "}",
                f"for (int k = 0; k < {size}; ++k) {{",
                "    least = fabs(margins[k]) < least ? fabs(margins[k]) : least;",
                "}",
            ]
    return "\n    ".join(lines)


def kinematics_part(kinematics: DriveKinematics) -> list[str]:
    """Tables and what follows a mode, for the file of a controller."""
    text = template(TEMPLATE).replace("    MARGINS\n", f"    {margins(kinematics)}\n" if margins(kinematics) else "")
    proof = certificate_part(kinematics.certificate)
    return ["#include <math.h>", "", *tables(kinematics), "", *proof, "", *text.splitlines()]


def print_drive_host(kinematics: DriveKinematics) -> dict[str, str]:
    """The part for a program on this machine: <name>_drives_host.c and what it includes."""
    name = kinematics.model.name
    lines = [f'#include "{name}.c"', "", "#include <string.h>", *kinematics_part(kinematics)]
    lines += [_array("int", "driven_v", [dict(kinematics.scalar)[k] for k in kinematics.driven])[0], ""]
    lines += [template(HOST).replace("NAME_", f"{name}_")]
    return {f"{name}_host.c": "\n".join(lines), **print_functions(kinematics)}


def axes_text(kinematics: DriveKinematics) -> str:
    """Joints and axes in words: `joint 0 limb1_P [m]; ... Axes A, B; from joints 0, 1, back in closed form.`"""
    sliding = set(kinematics.sliding)
    joints = zip(kinematics.drives, kinematics.driven, strict=True)
    told = "; ".join(f"joint {k} {name} [{'m' if at in sliding else 'rad'}]" for k, (name, at) in enumerate(joints))
    letters = ", ".join(LETTERS[k] for k in kinematics.axes)
    back = "in closed form" if kinematics.pose.entries else "by Newton's iteration"
    return f"{told}. Axes {letters}; from joints {', '.join(map(str, kinematics.chosen))}, back {back}."
