"""What the functions in the file of a target take: the order to write files, and the case to compare them.

    Order --files--> {file name: text or bytes}   what `generate` writes; every target has it
    Order --section--> lines of README.md         an example that runs, where the printer of README.md has none
    Case  --compare--> (passed, what), ...        what `check` says of the files' numbers

Where a tool to run the files is missing, `compare` says so instead of failing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from symscrew.export import USUAL_FORM, Form, Precision
from symscrew.generation.value_comparison import Results
from symscrew.model import Model

Finding = tuple[bool, str]


@dataclass(frozen=True)
class Order:
    """What is to be written: a model, the type of its numbers, what its C was measured to take on microcontrollers.

    `form`: of the C, in one file or in several, with functions of many states or without. `processes`: how many may
    print it.
    """

    model: Model
    precision: Precision
    measured: Sequence[Mapping[str, Any]] = ()
    form: Form = USUAL_FORM
    processes: int = 1


@dataclass(frozen=True)
class Case:
    """What is to be compared: files in `fresh`, just generated, with the evaluator's results at the test states.

    `directory` is the folder that is checked: nothing is compiled, loaded or run from there.
    """

    model: Model
    expected: Mapping[str, Results]
    fresh: Path
    directory: Path
    precision: Precision
    form: Form = USUAL_FORM
