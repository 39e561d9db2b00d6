"""Second derivatives of CasADi's external functions: CasADi's own differentiation, sparsity, IPOPT, and refusals."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.model_states import model

from symscrew.errors import DescriptionError
from symscrew.export import casadi_functions, print_c, print_external, print_hessians
from symscrew.generation.external_hessians_target import hessian_of
from symscrew.model import Model
from symscrew.runtime import compile_c

FEW = ("closure", "energy", "inverse_dynamics_independent", "assemble")


def library(found: Model, folder: Path) -> Path:
    written = {**print_c(found), **print_external(found), **print_hessians(found)}
    for name, text in written.items():
        (folder / name).write_text(text)
    sources = sorted(str(folder / name) for name in written if name.endswith(".c"))
    compile_c(Path(sources[0]), folder / "libhessians.so", flags=sources[1:])
    return folder / "libhessians.so"


@pytest.fixture(scope="module")
def four_bar(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return library(model("four_bar").only(FEW), tmp_path_factory.mktemp("hessians"))


def test_hessians_are_those_of_casadi_with_its_pattern_at_most(four_bar: Path) -> None:
    own = casadi_functions(model("four_bar").only(FEW))
    for name in FEW[:-1]:
        ours, theirs = (hessian_of(f) for f in (ca.external(f"four_bar_casadi_{name}", str(four_bar)), own[name]))
        assert ours.sparsity_out(0).is_subset(theirs.sparsity_out(0)) and ours.nnz_out(0) > 0
        for k in range(2):
            state = np.concatenate([array[k] for array in model("four_bar").test_inputs[name]])
            assert np.array(ours(state)) == pytest.approx(np.array(theirs(state)), rel=1e-10, abs=1e-10)


def test_ipopt_takes_them_without_an_option(four_bar: Path) -> None:
    """The highest place of the four-bar: in fewer steps than from first derivatives, at the same point."""
    energy, closure = (ca.external(f"four_bar_casadi_{name}", str(four_bar)) for name in ("energy", "closure"))
    rows = sorted(set(closure.jacobian().sparsity_out(0).row()))
    q = ca.MX.sym("q", 3)
    problem = {"x": q, "f": -energy(q, np.zeros(3))[0][1], "g": closure(q)[0][rows]}
    found = []
    for more in ({}, {"ipopt.hessian_approximation": "limited-memory"}):
        solver = ca.nlpsol("solver", "ipopt", problem, {"ipopt.print_level": 0, "print_time": False, **more})
        found.append((np.array(solver(x0=[0.2, 0, 0], lbg=0, ubg=0)["x"]), solver.stats()))
    (exact, stats), (other, others) = found
    assert stats["success"] and others["success"] and stats["iter_count"] < others["iter_count"]
    assert exact == pytest.approx(other, abs=1e-6)


def test_a_state_that_fails_fails(four_bar: Path) -> None:
    hessian = hessian_of(ca.external("four_bar_casadi_inverse_dynamics_independent", str(four_bar)))
    with pytest.raises(RuntimeError, match="Evaluation failed"):
        hessian([np.nan] * 5)


def test_a_model_without_such_functions_is_refused() -> None:
    with pytest.raises(DescriptionError, match="target external_hessians: needs one of forward_kinematics"):
        print_hessians(model("four_bar").only(["assemble"]))
