"""In which form the C of a model is printed: in several files or in one, with functions of many states or without."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

# C files of a folder beside the functions: after the model's name, or as they are
FOREIGN = ("kins.c", "_sfun.c")  # these include headers of a controller, of Simulink
NOT_THE_LIBRARY = (
    "_external.c",
    "_external_hessians.c",
    "_hessians.c",
    "_jacobians.c",
    "_reduced.c",
    "_drives.c",
    "_drives_host.c",
    *FOREIGN,
)
ALONE = ("example.c",)


@dataclass(frozen=True)
class Form:
    """`one_file`: one source in place of several by families; `batches`: with functions of many states."""

    one_file: bool = False
    batches: bool = True


USUAL_FORM = Form()


def readable_sources(files: Iterable[str], name: str) -> list[str]:
    """The C files of a folder that a compiler can read with what stands in the folder and in C's library."""
    foreign = {f"{name}{ending}" for ending in FOREIGN}
    return sorted(file for file in files if file.endswith(".c") and file not in foreign)


def library_sources(files: Iterable[str], name: str) -> list[str]:
    """The C files of a folder that make the library of a model's functions, in the order to name them: all of them.

    >>> library_sources(["arm_support.c", "arm.h", "arm_batch.c", "example.c", "arm_external.c"], "arm")
    ['arm_batch.c', 'arm_support.c']
    >>> library_sources(["two_drives.h", "two_drives.c"], "two_drives")
    ['two_drives.c']
    """
    others = {*ALONE, *(f"{name}{ending}" for ending in NOT_THE_LIBRARY)}
    own = [file for file in files if file.endswith(".c") and file not in others]
    return sorted(own, key=lambda file: (file != f"{name}.c", file))
