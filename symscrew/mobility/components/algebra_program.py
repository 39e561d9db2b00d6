"""Singular, the program of exact algebra: found on the path, given its time, its answer taken.

    text of a program, seconds of the processor --Singular--> what it printed, whether it came to the end

(W. Decker, G.-M. Greuel, G. Pfister, H. Schoenemann.) Debian's package is singular-ui. A program that is given ends by
printing `@end`, so that one that was cut off is told from one that has ended.
"""

from __future__ import annotations

import math
import shutil
import subprocess

ALGEBRA_PROGRAM = "Singular"
BACKSTOP = 15
"""Times as long by the clock ends what waits: a busy machine gives a process a tenth of a processor."""


def algebra_answer(script: str, seconds: float) -> tuple[str, bool] | None:
    """What Singular prints within so many seconds of the processor, and whether it came to `@end`; None without it.

    Whole seconds where the system counts these: one more at most. Without any it is not begun.
    """
    program = shutil.which(ALGEBRA_PROGRAM)
    if program is None:
        return None
    if seconds <= 0:
        return "", False
    command, clock = [program, "--quiet", "--no-rc"], seconds
    shell = shutil.which("sh")
    if shell is not None:  # what sets limits wherever there is one; it counts whole seconds
        command = [shell, "-c", 'ulimit -t "$0" && exec "$@"', str(math.ceil(seconds)), *command]
        clock = BACKSTOP * seconds
    try:
        done = subprocess.run(command, input=script, capture_output=True, text=True, timeout=clock)
        return done.stdout, "@end" in done.stdout
    except subprocess.TimeoutExpired as error:
        output = error.stdout or b""
        return output.decode(errors="replace") if isinstance(output, bytes) else output, False
