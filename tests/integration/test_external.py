"""CasADi external functions: the values of the model, Jacobians by finite differences, and IPOPT on top of both."""

from __future__ import annotations

import re
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from support.marks import slow
from support.model_states import model

from symscrew.description.builder import MechanismBuilder
from symscrew.export.c import print_c
from symscrew.export.casadi import casadi_functions
from symscrew.export.casadi_external import DIFFERENTIATED, jacobians_model, print_external
from symscrew.generation.folder import generate
from symscrew.model import Model, derive
from symscrew.program.jacobians import jacobian
from symscrew.program.straight_line import Iteration
from symscrew.runtime.compiled import compile_c, find_compiler
from symscrew.verification.regeneration import check

NAMES = ("four_bar", "panda", "mixed_loop", "slider_crank")


def library(found: Model, folder: Path) -> Path:
    for name, text in {**print_c(found), **print_external(found)}.items():
        (folder / name).write_text(text)
    others = [str(folder / f"{found.name}{part}.c") for part in ("_jacobians", "_external")]
    compile_c(folder / f"{found.name}.c", folder / f"lib{found.name}.so", flags=["-O1", *others])
    return folder / f"lib{found.name}.so"


@pytest.fixture(scope="module")
def four_bar(tmp_path_factory) -> Path:
    if find_compiler() is None:
        pytest.fail("these tests need a C compiler: apt-get install gcc")
    return library(model("four_bar"), tmp_path_factory.mktemp("four_bar"))


LARGE = ("panda", "mixed_loop")
SOME = ("forward_kinematics", "inverse_dynamics", "forward_dynamics", "platform_jacobian", "closure", "assemble")
"""Functions of the large ones: of every kind."""
CASES = [slow(name) if name in LARGE else name for name in (*NAMES, "pendulum")]


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_jacobians_of_programs_are_their_finite_differences(name):
    """Every input, quaternions entry by entry and run-time parameters too; an iteration by its solution."""
    found = model(name)
    found = found.only([f for f in found.programs if f in SOME]) if name in LARGE else found
    derived, jacobians = jacobians_model(found)
    assert set(jacobians) >= {"inverse_dynamics", "forward_dynamics"} & set(found.programs)
    for function, made in jacobians.items():
        values, status = derived(made.program.name, *derived.test_inputs[made.program.name])
        assert not np.any(status), function
        source = found.programs[function]
        inputs = [array[1:2] for array in found.test_inputs[function]]
        for i, port in enumerate(source.inputs):
            blocks = {o: np.zeros((p.size, port.size)) for o, p in enumerate(source.outputs)}
            for output, value in zip(made.program.outputs, values, strict=True):
                o, place, rows, columns = made.blocks[output.name]
                if place == i:
                    blocks[o][list(rows), list(columns)] = value[1]
            for k in range(port.size):
                ends = []
                size = 1e-7 if re.search(r"\.q[wxyz]$", port.labels[k]) else 1e-5  # longer ones are no quaternions
                for step in (size, -size):
                    moved = [array.copy() for array in inputs]
                    moved[i][0, k] += step
                    ends.append(found(function, *moved)[0])
                for o, block in blocks.items():
                    expected = (ends[0][o].ravel() - ends[1][o].ravel()) / (2 * size)
                    scale = max(1.0, np.abs(block).max(initial=0.0))
                    assert block[:, k] == pytest.approx(expected, abs=2e-6 * scale), (function, port.name, k)


@pytest.mark.slow
def test_values_names_and_statuses_are_those_of_the_model_and_of_its_casadi_functions(four_bar):
    """Every function, states that fail among them."""
    found = model("four_bar")
    own = casadi_functions(found)
    codes = set()
    for name, program in found.programs.items():
        function = ca.external(f"four_bar_casadi_{name}", str(four_bar))
        assert function.name_in() == own[name].name_in() == [port.name for port in program.inputs]
        assert function.name_out() == own[name].name_out() == [*(port.name for port in program.outputs), "status"]
        for k in range(function.n_in()):
            assert function.size_in(k) == own[name].size_in(k), name
        for k in range(function.n_out()):
            assert function.size_out(k) == own[name].size_out(k), name
        broken = [np.where(k == 0, np.nan, array[:1]) for k, array in enumerate(found.test_inputs[name])]
        inputs = [np.concatenate(pair) for pair in zip(found.test_inputs[name], broken, strict=True)]
        expected, status = found(name, *inputs)
        for k, code in enumerate(np.ravel(status)):
            *got, said = function.call([array[k] for array in inputs])
            *others, known = own[name].call([array[k] for array in inputs])
            codes.add(int(code))
            assert int(said) == code and int(known) == (code if code >= 0 else 1), name
            for a, b, c in zip(got, expected, others, strict=True):
                assert np.array(a).T.ravel() == pytest.approx(b[k], rel=1e-12, abs=1e-12, nan_ok=True)
                assert code != 0 or np.array(a) == pytest.approx(np.array(c), rel=1e-12, abs=1e-12)
    assert {0, 2} <= codes


@pytest.mark.slow
def test_a_failed_state_is_a_failed_evaluation_of_those_who_do_not_ask_for_the_status(four_bar):
    function = ca.external("four_bar_casadi_assemble", str(four_bar))
    q, status = function([np.nan], [0, 0, 0])
    assert int(status) == 2 and np.isnan(np.array(q)).all()
    y = ca.MX.sym("y")
    only = ca.Function("only", [y], [function(y, ca.DM.zeros(3))[0]])
    assert np.array(only(0.2)) == pytest.approx(np.array(function([0.2], [0, 0, 0])[0]))
    for failing in (only, only.jacobian(), ca.Function("slope", [y], [ca.jacobian(only(y), y)])):
        with pytest.raises(RuntimeError, match="Evaluation failed"):
            failing.call([np.nan] * failing.n_in())


@pytest.mark.slow
def test_the_jacobian_is_sparse_and_can_be_mapped(four_bar):
    function = ca.external("four_bar_casadi_acceleration", str(four_bar))
    by_rate = function.jacobian().sparsity_out("jac_a_y_ddot")
    made = jacobian(model("four_bar").programs["acceleration"])
    block = next(entry for entry in made.blocks.values() if entry[1] == 2)
    assert by_rate.nnz() == len(block[2])
    mapped = function.map(4)
    q, v, y = (array[:4].T for array in model("four_bar").test_inputs["acceleration"])
    expected = model("four_bar")("acceleration", q.T, v.T, y.T)[0][0]
    accelerations, status = mapped(q, v, y)
    assert not np.any(status) and np.array(accelerations) == pytest.approx(expected.T, abs=1e-12)


@pytest.mark.slow
def test_ipopt_with_external_functions_and_their_derivatives(four_bar):
    """The crank angle at which gravity needs no torque: a stationary point of the potential energy."""
    assemble = ca.external("four_bar_casadi_assemble", str(four_bar))
    dynamics = ca.external("four_bar_casadi_inverse_dynamics_independent", str(four_bar))
    energy = ca.external("four_bar_casadi_energy", str(four_bar))
    y = ca.MX.sym("y")
    q, _ = assemble(y, ca.DM.zeros(3))
    torque, _ = dynamics(q, 0, 0)
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.hessian_approximation": "limited-memory"}
    height = energy(q, ca.DM.zeros(3))[0][1]
    solver = ca.nlpsol("solver", "ipopt", {"x": y, "f": -height}, options)
    found = solver(x0=0.2, lbx=-1.5, ubx=1.5)
    assert solver.stats()["success"]
    at_rest = ca.Function("torque", [y], [torque])(found["x"])
    assert abs(float(at_rest)) < 1e-6
    assert -1.4 < float(found["x"]) < 1.4
    solver = ca.nlpsol("solver", "ipopt", {"x": y, "f": y**2, "g": torque}, options)
    again = solver(x0=float(found["x"]) + 0.1, lbg=0, ubg=0)
    assert solver.stats()["success"]
    assert float(again["x"]) == pytest.approx(float(found["x"]), abs=1e-5)


@pytest.mark.slow
def test_second_derivatives_are_refused_and_can_be_had_from_the_other_target(four_bar):
    """IPOPT on external functions, with the Hessian of the Lagrangian by CasADi's own: fewer steps, the same point."""
    energy, closure = (ca.external(f"four_bar_casadi_{name}", str(four_bar)) for name in ("energy", "closure"))
    q = ca.MX.sym("q", 3)
    rest = ca.DM.zeros(3)
    with pytest.raises(RuntimeError, match="Derivatives cannot be calculated for jac_four_bar_casadi_energy"):
        ca.hessian(energy(q, rest)[0][1], q)
    own = casadi_functions(model("four_bar").only(["energy", "closure"]))
    rows = sorted(set(closure.jacobian().sparsity_out(0).row()))  # of five, those that a planar motion changes
    multiplier, multipliers = ca.MX.sym("multiplier"), ca.MX.sym("multipliers", len(rows))
    lagrangian = -multiplier * own["energy"](q=q, v=rest)["energy"][1]
    lagrangian += ca.dot(multipliers, own["closure"](q=q)["residual"][rows])
    upper = ca.triu(ca.hessian(lagrangian, q)[0])
    arguments = [q, ca.MX.sym("p", 0, 0), multiplier, multipliers]
    names = ["x", "p", "lam_f", "lam_g"]
    exact = {"hess_lag": ca.Function("hess_lag", arguments, [upper], names, ["triu_hess_gamma_x_x"])}
    found = []
    for options in (exact, {"ipopt.hessian_approximation": "limited-memory"}):
        problem = {"x": q, "f": -energy(q, rest)[0][1], "g": closure(q)[0][rows]}
        solver = ca.nlpsol("solver", "ipopt", problem, {"ipopt.print_level": 0, "print_time": False, **options})
        found.append((np.array(solver(x0=[0.2, 0, 0], lbg=0, ubg=0)["x"]), solver.stats()))
    (first, stats), (second, others) = found
    assert stats["success"] and others["success"] and stats["iter_count"] < others["iter_count"]
    assert first == pytest.approx(second, abs=1e-6)
    torque = ca.external("four_bar_casadi_inverse_dynamics", str(four_bar))(first, rest, rest)[0]
    assert abs(float(torque)) < 1e-6


@pytest.mark.slow
def test_check_compares_the_jacobians_of_matrices_too(tmp_path):
    """Two named points: an output of 3 x 2."""
    builder = MechanismBuilder("two_points")
    builder.body("rod", mass=1, com=[0, 0, "-1/4"], inertia=[0.01, 0.01, 0])
    builder.joint("pivot", "R", parent="base", child="rod", point=[0, 0, 0], axes=[[0, 1, 0]], driven=True)
    builder.point("tip", body="rod", at=[0, 0, "-1/2"])
    builder.point("side", body="rod", at=["1/10", 0, 0])
    found = derive(builder.build()).only(["forward_kinematics", "point_motion"])
    generate(found, tmp_path / "two_points", ["external"])
    result = check(tmp_path / "two_points")
    assert result.ok, result.lines
    assert any("Jacobians of CasADi externals agree with the evaluator" in line for line in result.lines)


def test_what_is_differentiated_exists_and_iterations_too():
    programs = set().union(*(model(name).programs for name in NAMES))
    assert set(DIFFERENTIATED) - programs <= {"energy"}
    assert isinstance(model("four_bar").programs["assemble"], Iteration)
    made = jacobian(model("four_bar").programs["assemble"])
    assert [made.source.inputs[entry[1]].name for entry in made.blocks.values()] == ["y"]
