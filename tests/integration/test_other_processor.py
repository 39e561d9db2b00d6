"""What is generated does not depend on the processor."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from support.model_states import model

from symscrew.generation.folder import render

TARGETS = ("c", "numpy", "external", "javascript", "fmu", "mjcf", "markdown")
FUNCTIONS = ("assemble", "energy", "forward_dynamics", "inverse_dynamics", "joint_reactions")


@pytest.mark.slow
def test_what_is_generated_does_not_depend_on_the_processor(tmp_path: Path) -> None:
    """A second process without the vector units and with the linear algebra of an old processor."""
    units = [str(feature) for feature in np._core._multiarray_umath.__cpu_dispatch__]
    script = (
        "import sys, pathlib\n"
        f"TARGETS = {TARGETS}\n"
        "from symscrew import catalogue\n"
        "from symscrew.generation.folder import render\n"
        "from symscrew.model import derive\n"
        f"files = render(derive(catalogue.load('four_bar')).only({FUNCTIONS}), TARGETS)\n"
        "for name, data in files.items(): (pathlib.Path(sys.argv[1]) / name).write_bytes(data)\n"
    )
    other = {**os.environ, "NPY_DISABLE_CPU_FEATURES": " ".join(units), "OPENBLAS_CORETYPE": "Nehalem"}
    plain = [sys.executable, "-W", "ignore", "-c", script, str(tmp_path)]
    subprocess.run(plain, env=other, check=True, capture_output=True)
    own = render(model("four_bar").only(FUNCTIONS), TARGETS)
    assert len(own) > 10
    for name, data in own.items():
        assert (tmp_path / name).read_bytes() == data, name
