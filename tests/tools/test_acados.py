"""The documentation's recipe for acados, run in acados where it is installed, against CasADi's Opti and IPOPT.

`ACADOS_SOURCE_DIR` says where: a folder with bin, lib, include and interfaces/acados_template, as acados's installation
makes it.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.documentation import DOCS

from symscrew import catalogue
from symscrew.export import library_sources, ode_function, print_c, print_reduced
from symscrew.model import Model, derive
from symscrew.runtime import compile_c

ACADOS = os.environ.get("ACADOS_SOURCE_DIR", "")
NEEDED = (
    "assemble", "forward_dynamics_independent", "forward_dynamics_independent_derivatives",
    "forward_dynamics_independent_hessian",
)  # fmt: skip
WAYS = {  # name of the catalogue -> what y changes by in 0.3 s [rad, m]
    "five_bar": (0.1, -0.05),
    "three_ups_upu_s_physical": (0.02, -0.015),
    "delta": (0.1, -0.05, 0.08),
}
BLOCK = re.compile(r"^```python title=\"in_acados\.py\"\n(.*?)^```", re.M | re.S)


def recipe() -> str:
    """The program of the page."""
    found = BLOCK.search((DOCS / "how_to" / "casadi.md").read_text())
    assert found
    return found[1]


def of(model: Model, start: np.ndarray, goal: np.ndarray) -> str:
    """The program of the page for another mechanism and motion: its names, sizes and numbers alone are exchanged."""
    ode, text = ode_function(model), recipe()
    given = f"n, h, start, goal = 10, 0.03, np.array({start.tolist()}), np.array({goal.tolist()})"
    nx, nu = ode.size1_in(0), ode.size1_in(1)
    for old, new in (
        (r'"five_bar_ode", "five/libfive.so"', f'"{model.name}_ode", "five/libfive.so"'),
        (r"n, h, start, goal = .*", given),
        (r'ca\.MX\.sym\("x", 4\), ca\.MX\.sym\("u", 2\)', f'ca.MX.sym("x", {nx}), ca.MX.sym("u", {nu})'),
        (r"np\.arange\(4\)", f"np.arange({nx})"),
    ):
        text, count = re.subn(old, new, text)
        assert count == 1, old
    return text


def by_opti(ode: ca.Function, start: np.ndarray, goal: np.ndarray) -> float:
    """Cost of the same steps by IPOPT."""
    opti, n, h = ca.Opti(), 10, 0.03
    x, u = opti.variable(len(start), n + 1), opti.variable(ode.size1_in(1), n)
    opti.subject_to(x[:, 0] == start)
    opti.subject_to(x[:, n] == goal)
    for k in range(n):
        opti.subject_to(x[:, k + 1] == x[:, k] + h * ode(x[:, k] + h / 2 * ode(x[:, k], u[:, k]), u[:, k]))
        opti.set_initial(x[:, k], start + (goal - start) * k / n)
    opti.minimize(ca.sumsqr(u))
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes"})
    return float(opti.solve().value(opti.f))


def test_the_recipe_takes_other_mechanisms() -> None:
    """What is exchanged stands in it once."""
    model = derive(catalogue.load("four_bar"), derivatives=True, second_derivatives=True).only(NEEDED)
    text = of(model, np.zeros(2), np.zeros(2))
    assert 'ca.external("four_bar_ode"' in text and 'ca.MX.sym("x", 2), ca.MX.sym("u", 1)' in text
    compile(text, "in_acados.py", "exec")


@pytest.mark.slow
@pytest.mark.skipif(not ACADOS, reason="ACADOS_SOURCE_DIR says where acados is")
@pytest.mark.parametrize("name", WAYS)
def test_acados_finds_the_optimum_of_ipopt(name: str, tmp_path: Path) -> None:
    model = derive(catalogue.load(name), derivatives=True, second_derivatives=True).only(NEEDED)
    folder = tmp_path / "five"
    folder.mkdir()
    for file, text in {**print_c(model, batches=False), **print_reduced(model)}.items():
        (folder / file).write_text(text)
    first, *others = library_sources((path.name for path in folder.iterdir()), model.name)
    more = [str(folder / other) for other in (*others, f"{model.name}_reduced.c")]
    compile_c(folder / first, folder / "libfive.so", flags=["-O1", *more])
    entries = {c.label: model.system.reference[k] for k, c in enumerate(model.system.tree.q)}
    y = np.array([float(entries[label]) for label in model.independent])
    start, goal = np.concatenate([y, 0 * y]), np.concatenate([y + WAYS[name], 0 * y])
    (tmp_path / "in_acados.py").write_text(recipe() if name == "five_bar" else of(model, start, goal))
    paths = {
        "PYTHONPATH": f"{ACADOS}/interfaces/acados_template",
        "LD_LIBRARY_PATH": f"{ACADOS}/lib:{folder}",
    }
    done = subprocess.run(
        [sys.executable, "in_acados.py"], cwd=tmp_path, env={**os.environ, **paths}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr[-2000:]
    found = float(re.findall(r"^acados: (\S+)$", done.stdout, re.M)[0])
    known = by_opti(ca.external(f"{model.name}_ode", str(folder / "libfive.so")), start, goal)
    assert found == pytest.approx(known, rel=1e-7)
