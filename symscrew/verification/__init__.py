"""Whether generated code is what the tool would write today, compiles without a warning, and agrees by number.

folder --regeneration--> equal bytes, or hashes? --> every target's numbers against the reference evaluator
       --embedded--> the same on a microcontroller, emulated
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.verification.embedded import collect, measure
    from symscrew.verification.regeneration import check

__all__ = ["check", "collect", "measure"]

__getattr__ = doors(__name__)
