"""Generated C on a microcontroller, emulated: flash, stack and instructions of every function."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.verification.embedded.emulation import CORES, measure, missing_tools

__all__ = ["CORES", "measure", "missing_tools"]

__getattr__ = doors(__name__)
