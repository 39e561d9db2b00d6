"""C of a function for four points at a time, against CasADi's own map of the function of one point."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from symscrew.optimisation import point_lanes
from symscrew.optimisation.point_lanes import EACH, INFIX, WRITTEN, printable, printed_lanes
from symscrew.runtime import compile_c, find_compiler

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def every_operation() -> ca.Function:
    """(z, numbers, weights) -> values by all operations that are printed, a sparse matrix, an input, a number."""
    z, n, w = ca.SX.sym("z", 3), ca.SX.sym("n", 2), ca.SX.sym("w", 2)
    x, y = z[0], z[1] + 2
    values = [
        x + y, x - y, x * y, x / y, -x, 2 * x, x * x, 1 / y, ca.sin(x), ca.cos(x), ca.tan(x), ca.asin(x / 4),
        ca.acos(x / 4), ca.atan(x), ca.atan2(x, y), ca.sqrt(y), ca.exp(x), ca.log(y), y**x, y**2.5, ca.tanh(x),
        ca.fabs(x), ca.fmin(x, z[1]), ca.fmax(x, z[1]), ca.sign(x), ca.if_else(x < z[1], y, 3),
        ca.if_else(x <= 0, y, x), ca.if_else(x == z[1], y, 0),
        ca.if_else(x != z[1], y, 0), ca.logic_not(x > 0), ca.logic_and(x > 0, z[1] > 0),
        ca.logic_or(x > 0, z[1] > 0), z[2], ca.SX(1.5), ca.SX(ca.inf), 1e-7 * n[0] * w[1], n[1] + w[0],
    ]  # fmt: skip
    pattern = ca.SX(3, 3)
    pattern[0, 1], pattern[2, 2] = x * n[0], y
    return ca.Function("every", [z, n, w], [ca.vertcat(*values), pattern])


def made(function: ca.Function, count: int, folder: Path) -> ca.Function:
    """The C of so many points, compiled without a warning."""
    source, library = folder / "lanes.c", folder / "lanes.so"
    source.write_text(printed_lanes({"of_all": (function, count, (1,))}))
    warned = ["-Wall", "-Wextra", "-Wno-psabi", "-Wno-unused-function", "-Werror", "-O1"]
    compile_c(source, library, flags=warned)
    return ca.external("of_all", str(library))


@pytest.mark.parametrize(("count", "part"), [(4, 2000), (7, 2000), (13, 5)])
def test_all_points_are_as_each_by_itself(
    count: int, part: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where functions are cut in parts that hand values on."""
    monkeypatch.setattr(point_lanes, "PART", part)
    function, random = every_operation(), np.random.default_rng(count)
    ours = made(function, count, tmp_path)
    given = [random.uniform(-1.5, 1.5, shape) for shape in ((3, count), 2, (2, count))]
    known = function.map("map", "serial", count, [1], [])
    for a, b in zip(ours(*given), known(*given), strict=True):
        assert a.sparsity() == b.sparsity()
        assert np.array(a.nonzeros()) == pytest.approx(np.array(b.nonzeros()), rel=1e-14, abs=1e-300)


def test_every_printed_operation_was_tried() -> None:
    function = every_operation()
    tried = {function.instruction_id(k) for k in range(function.n_instructions())}
    assert printable(function)
    left = {*INFIX, *WRITTEN, *EACH} - tried
    assert left <= {ca.OP_ASSIGN, ca.OP_CONSTPOW, ca.OP_POW}  # which of the powers is CasADi's choice
    assert tried & {ca.OP_CONSTPOW, ca.OP_POW}


def test_what_is_not_printed_is_left_to_casadi() -> None:
    x = ca.SX.sym("x")
    assert not printable(ca.Function("erf", [x], [ca.erf(x)]))
