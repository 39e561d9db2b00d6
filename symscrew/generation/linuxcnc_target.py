"""Target "linuxcnc": kinematics of LinuxCNC, followed there and back here."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from symscrew.export import find_drive_kinematics, print_linuxcnc
from symscrew.generation.drive_round_trip import round_trip
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.runtime import find_compiler


def files(order: Order) -> Mapping[str, str]:
    """<name>kins.c, <name>_drives.h, <name>_drives.c."""
    return print_linuxcnc(order.model, find_drive_kinematics(order.model))


def section(order: Order) -> Sequence[str]:
    """How it is built."""
    name = f"{order.model.name}kins"
    return [
        "### LinuxCNC",
        "",
        f"What its joints and axes are stands at the top of `{name}.c`.",
        "",
        "```sh",
        f"halcompile --install {name}.c",
        "```",
        "",
        f"In the ini file: `KINEMATICS = {name}` in `[KINS]`. Pins are listed in docs/how_to/linuxcnc.md.",
    ]


def compare(case: Case) -> Iterator[Finding]:
    """There and back, compiled without LinuxCNC."""
    if find_compiler() is None:
        yield True, "no C compiler here: kinematics not compiled"
        return
    yield round_trip(find_drive_kinematics(case.model), case.fresh)
