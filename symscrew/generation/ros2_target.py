"""Target "ros2": a package of ros2_control, whose kinematics are followed there and back here."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symscrew.export import find_drive_kinematics, print_ros2
from symscrew.generation.drive_round_trip import round_trip
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.runtime import find_compiler


def files(order: Order) -> Mapping[str, str]:
    """Headers, plugin, package.xml, CMakeLists.txt, and the C that they call."""
    return print_ros2(order.model, find_drive_kinematics(order.model))


def compare(case: Case) -> Iterator[Finding]:
    """There and back, compiled without ROS."""
    if find_compiler() is None:
        yield True, "no C compiler here: kinematics not compiled"
        return
    yield round_trip(find_drive_kinematics(case.model), case.fresh)
