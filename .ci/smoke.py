"""The main job with the package as it is installed, away from the checkout: what a user of the wheel does first.

    python -I .ci/smoke.py      run by the interpreter of an environment that has the wheel and nothing else of us

Prints the versions it ran with; ends with an error where anything is not as it should be.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from importlib import metadata
from pathlib import Path


def main() -> None:
    os.chdir(tempfile.mkdtemp(prefix="symscrew_smoke_"))
    import numpy as np

    import symscrew

    home = Path(symscrew.__file__).resolve()
    assert Path(sys.prefix).resolve() in home.parents, f"{home} is not the installed package"
    mechanism = symscrew.load_catalogue("four_bar")
    model = symscrew.derive(mechanism)
    symscrew.generate(model, "out")
    found = symscrew.check("out")
    assert found.ok, found.lines
    compiled = symscrew.load("out")
    q, y_dot = model.test_inputs["velocity"][:2]
    (expected, *_), _ = model("velocity", q, y_dot)
    assert np.allclose(compiled.velocity(q, y_dot, check=False)[0], expected, equal_nan=True, atol=1e-12)
    assert symscrew.analyse_mobility(mechanism).report()
    from symscrew.display import make_page

    page = make_page(model)
    assert "three.js authors" in page  # the licence goes with the library
    command = [str(Path(sys.prefix) / "bin" / "symscrew")]
    listed = subprocess.run([*command, "list"], capture_output=True, text=True, check=True).stdout
    assert "four_bar" in listed
    bad = subprocess.run([*command, "generate", "no_such"], capture_output=True, text=True, check=False)
    assert bad.returncode == 2 and "Traceback" not in bad.stderr, bad.stderr
    shipped = json.loads((home.parent / "sbom.cdx.json").read_text(encoding="utf-8"))
    assert shipped["metadata"]["component"]["version"] == metadata.version("symscrew")
    needed = [line for line in metadata.requires("symscrew") or () if "extra ==" not in line]
    names = sorted(re.match(r"[A-Za-z0-9_-]+", line)[0] for line in needed)
    print("works with", ", ".join(f"{name} {metadata.version(name)}" for name in names))


if __name__ == "__main__":
    main()
