"""The reduced model: C against CasADi's own differentiation of the same motion, in both ABIs, and in an Opti."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from support.documentation import DOCS
from support.marks import slow
from support.optimal_problems import pendulum

from symscrew import catalogue
from symscrew.cli.parser import main
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError
from symscrew.export import (
    configuration_function,
    library_sources,
    model_hash,
    ode_function,
    print_c,
    print_reduced,
    read_manifest,
)
from symscrew.export.reduced import reduced
from symscrew.generation import reduced_target
from symscrew.generation.folder import generate
from symscrew.model import Model, derive
from symscrew.runtime import compile_c
from symscrew.runtime.origin import model_of

NAMES = ["four_bar", slow("three_ups_upu_s")]
NEEDED = (
    "assemble", "forward_dynamics_independent", "forward_dynamics_independent_derivatives",
    "forward_dynamics_independent_hessian",
)  # fmt: skip
H = 0.02  # [s], the step of the discrete functions


@cache
def model(name: str) -> Model:
    found = derive(catalogue.load(name), derivatives=True, second_derivatives=True)
    return found.only(NEEDED)


@cache
def library(name: str, folder: Path) -> Path:
    found = model(name)
    for file, text in {**print_c(found, batches=False), **print_reduced(found)}.items():
        (folder / file).write_text(text)
    first, *others = library_sources((path.name for path in folder.iterdir()), found.name)
    more = [str(folder / other) for other in (*others, f"{found.name}_reduced.c")]
    strict = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wdouble-promotion", "-Wconversion", "-Werror"]
    compile_c(folder / first, folder / "libreduced.so", flags=[*strict, *more])
    return folder / "libreduced.so"


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return {name: tmp_path_factory.mktemp(name) for name in ("four_bar", "three_ups_upu_s")}


def states(found: Model, count: int = 2) -> list[tuple[np.ndarray, np.ndarray]]:
    """States (x, u) near the reference, off it."""
    form, random = reduced(found), np.random.default_rng(6)
    system = found.system
    entries = [k for label in found.independent for k, c in enumerate(system.tree.q) if c.label == label]
    base = system.reference[entries]
    scale = 0.05 * system.length if system.tree.q[entries[0]].kind == "length" else 0.05
    return [
        (
            np.concatenate([base + scale * random.uniform(-1, 1, form.d), random.uniform(-1, 1, form.d)]),
            random.uniform(-5, 5, form.nu),
        )
        for _ in range(count)
    ]


@cache
def by_casadi(name: str) -> tuple[ca.Function, ca.Function]:
    """(x, u, lam) -> x_dot, slope, Hessian of lam . x_dot; the same of a Runge-Kutta step of length H."""
    ode = ode_function(model(name))
    nx, nu = ode.size1_in(0), ode.size1_in(1)
    v, lam = ca.MX.sym("v", nx + nu), ca.MX.sym("lam", nx)
    x, u = v[:nx], v[nx:]
    k1 = ode(x, u)
    k2 = ode(x + H / 2 * k1, u)
    k3 = ode(x + H / 2 * k2, u)
    k4 = ode(x + H * k3, u)
    made = []
    for value in (k1, x + H / 6 * (k1 + 2 * k2 + 2 * k3 + k4)):
        slope, (bend, _) = ca.jacobian(value, v), ca.hessian(ca.dot(lam, value), v)
        made.append(ca.Function("known", [v, lam], [value, ca.densify(slope), ca.densify(bend)]))
    return made[0], made[1]


def near(a: object, b: object) -> None:
    one, other = np.array(a), np.array(b)
    assert one.shape == other.shape
    assert np.abs(one - other).max(initial=0.0) < 1e-7 * max(1.0, np.abs(other).max(initial=0.0))


@pytest.mark.parametrize("name", NAMES)
def test_external_functions_have_exact_derivatives_of_both_orders(name: str, folders: dict[str, Path]) -> None:
    found = model(name)
    ours = ca.external(f"{found.name}_ode", str(library(name, folders[name])))
    assert ours.name_in() == ode_function(found).name_in() and ours.name_out() == ode_function(found).name_out()
    nx, nu = ours.size1_in(0), ours.size1_in(1)
    v, lam = ca.MX.sym("v", nx + nu), ca.MX.sym("lam", nx)
    value = ours(v[:nx], v[nx:])
    bend, _ = ca.hessian(ca.dot(lam, value), v)
    whole = ca.Function("ours", [v, lam], [value, ca.densify(ca.jacobian(value, v)), ca.densify(bend)])
    assert bend.nnz() == reduced(found).bend.sum() < (nx + nu) ** 2  # exact sparsity
    weights = np.linspace(-1, 1, nx)
    for x, u in states(found):
        v_here = np.concatenate([x, u])
        for a, b in zip(whole(v_here, weights), by_casadi(name)[0](v_here, weights), strict=True):
            near(a, b)
    q = ca.external(f"{found.name}_configuration", str(library(name, folders[name])))
    y = states(found)[0][0][: nx // 2]
    near(q(y), configuration_function(found)(y))


@pytest.mark.parametrize("name", NAMES)
def test_functions_by_the_names_of_acados(name: str, folders: dict[str, Path]) -> None:
    found, place = model(name), str(library(name, folders[name]))
    form = reduced(found)
    nx, nu, nv = form.nx, form.nu, form.nv
    swap = [*range(nx, nv), *range(nx)]  # acados: (u, x)
    lam = np.linspace(-1, 1, nx)
    made = {end: ca.external(f"{found.name}_{end}", place) for end in (
        "expl_ode_fun", "expl_vde_forw", "expl_vde_adj", "expl_ode_hess", "disc_dyn_fun", "disc_dyn_fun_jac",
        "disc_dyn_fun_jac_hess")}  # fmt: skip
    random = np.random.default_rng(1)
    for x, u in states(found):
        v = np.concatenate([x, u])
        value, slope, bend = (np.array(a) for a in by_casadi(name)[0](v, lam))
        sx, su = random.uniform(-1, 1, (nx, nx)), random.uniform(-1, 1, (nx, nu))
        near(made["expl_ode_fun"](x, u, H), value)
        wanted = (value, slope[:, :nx] @ sx, slope[:, :nx] @ su + slope[:, nx:])
        for a, b in zip(made["expl_vde_forw"](x, sx, su, u, H), wanted, strict=True):
            near(a, b)
        near(made["expl_vde_adj"](x, lam, u, H), slope.T @ lam[:, None])
        sens = np.block([[sx, su], [np.zeros((nu, nx)), np.eye(nu)]])
        adj, lower = made["expl_ode_hess"](x, sx, su, lam, u, H)
        near(adj, slope.T @ lam[:, None])
        whole = sens.T @ bend @ sens
        near(lower, np.array([whole[i, j] for j in range(nv) for i in range(j, nv)])[:, None])
        phi, jac, hess = (np.array(a) for a in by_casadi(name)[1](v, lam))
        near(made["disc_dyn_fun"](x, u, H), phi)
        for a, b in zip(made["disc_dyn_fun_jac"](x, u, H), (phi, jac.T[swap]), strict=True):
            near(a, b)
        for a, b in zip(
            made["disc_dyn_fun_jac_hess"](x, u, lam, H), (phi, jac.T[swap], hess[swap][:, swap]), strict=True
        ):
            near(a, b)


@pytest.mark.slow
def test_opti_takes_them_with_the_exact_hessian(folders: dict[str, Path]) -> None:
    """A small motion by multiple shooting: the same optimum on C and on CasADi's functions."""
    name = "four_bar"  # the derivatives that it is given are those of the tests above, of the seed's too
    found, place = model(name), str(library(name, folders[name]))
    step = ca.external(f"{found.name}_ode", place)
    (x0, _), *_ = states(found)
    costs = []
    for ode in (step, ode_function(found)):
        opti, n, nx = ca.Opti(), 4, ode.size1_in(0)
        x, u = opti.variable(nx, n + 1), opti.variable(ode.size1_in(1), n)
        opti.subject_to(x[:, 0] == np.concatenate([x0[: nx // 2], np.zeros(nx // 2)]))
        for k in range(n):
            middle = x[:, k] + H / 2 * ode(x[:, k], u[:, k])
            opti.subject_to(x[:, k + 1] == x[:, k] + H * ode(middle, u[:, k]))
        goal = np.concatenate([x0[: nx // 2] * 1.001, np.zeros(nx // 2)])
        opti.minimize(ca.sumsqr(u) + 1e4 * ca.sumsqr(x[:, n] - goal))
        for k in range(n + 1):
            opti.set_initial(x[:, k], np.concatenate([x0[: nx // 2], np.zeros(nx // 2)]))
        opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes"})
        solution = opti.solve()
        costs.append((float(solution.value(opti.f)), solution.stats()["iter_count"]))
    assert costs[0][0] == pytest.approx(costs[1][0], rel=1e-7) and costs[0][1] == costs[1][1]


@pytest.mark.slow
def test_the_recipe_of_the_documentation_solves_a_platform(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The page's program for Opti with another file, motion and size: three drives, a platform on three limbs."""
    found = derive(catalogue.load("planar_3rrr"), derivatives=True, second_derivatives=True).only(NEEDED)
    (tmp_path / "five").mkdir()
    ode_function(found).save(str(tmp_path / "five" / "five_bar_ode.casadi"))
    configuration_function(found).save(str(tmp_path / "five" / "five_bar_configuration.casadi"))
    entries = {c.label: float(found.system.reference[k]) for k, c in enumerate(found.system.tree.q)}
    y = [entries[label] for label in found.independent]
    ends = [[*y, 0, 0, 0], [y[0] + 0.1, y[1] - 0.05, y[2] + 0.08, 0, 0, 0]]
    blocks = re.findall(r"^```python\n(.*?)^```", (DOCS / "how_to" / "casadi.md").read_text(), re.M | re.S)
    (page,) = (block for block in blocks if "ca.Opti()" in block)
    for old, new in (
        (r"start, goal = 10, 0\.03, .*", f"start, goal = 3, 0.1, np.array({ends[0]}), np.array({ends[1]})"),
        (r"variable\(4, n \+ 1\), opti\.variable\(2, n\)", "variable(6, n + 1), opti.variable(3, n)"),
        (
            r'"print_level": 0',
            '"print_level": 0, "hessian_approximation": "limited-memory"',
        ),  # the second derivatives of
        # its motion take CasADi ten seconds to print: those of four_bar and the seed are held against C above
        (r"goal\[:2\]\)\.numel\(\) == 4", f"goal[:3]).numel() == {len(entries)}"),
    ):
        page, count = re.subn(old, new, page)
        assert count == 1, old
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    exec(compile(page, "recipe", "exec"), names)
    x, u = (names["found"].value(names[name]) for name in "xu")
    assert np.abs(u).max() > 0.1 and x[:, -1] == pytest.approx(ends[1], abs=1e-6)


def test_what_cannot_be_reduced_is_refused() -> None:
    with pytest.raises(DescriptionError, match="derive it with derivatives=True and second_derivatives=True"):
        print_reduced(derive(catalogue.load("four_bar")))


@pytest.mark.derived_anew
@pytest.mark.parametrize("mechanism", [pendulum(), slow(catalogue.load("four_bar"))], ids=lambda m: m.name)
def test_a_selection_of_second_derivatives_is_derived_again(mechanism: Mechanism, tmp_path: Path) -> None:
    """What `check` and `load` compare a folder with: `--functions` may leave the Hessian alone.

    The first derivatives, which are not in the folder, have a share in how it is written.
    """
    chosen = "forward_dynamics_independent_hessian"
    whole = derive(mechanism, derivatives=True, second_derivatives=True)
    generate(whole.only((chosen,)), tmp_path, ["numpy"])
    again = model_of(tmp_path, read_manifest(tmp_path))
    assert list(again.programs) == [chosen] and model_hash(again) == read_manifest(tmp_path)["hash"]


@pytest.mark.slow
def test_check_judges_the_reduced_model(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The folder of the documentation's command, and one whose C has a wrong Hessian, in the same bytes again."""
    command = ["generate", "four_bar", "--target", "reduced", "--functions", *NEEDED, "--out", str(tmp_path)]
    assert main(command) == 0 and main(["check", str(tmp_path)]) == 0
    assert "the reduced model and its derivatives agree with CasADi's own" in capsys.readouterr().out

    def wrong(found: Model) -> dict[str, str]:
        printed = print_reduced(found)
        files = {name: text.replace("hessian[2 * NV + 0] = block2[0];", "") for name, text in printed.items()}
        assert files != printed
        return files

    monkeypatch.setattr(reduced_target, "print_reduced", wrong)
    assert main(command) == 0 and main(["check", str(tmp_path)]) == 1
    assert "FAILED: the reduced model and its derivatives" in capsys.readouterr().out
