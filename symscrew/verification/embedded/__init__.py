"""Generated C on a microcontroller, emulated: flash, stack and instructions of every function."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.verification.embedded.c_evidence import Evidence, collect
    from symscrew.verification.embedded.emulation import CORES, measure, missing_tools

__all__ = ["CORES", "Evidence", "collect", "measure", "missing_tools"]

__getattr__ = doors(__name__)
