"""The 4-RUU beside its two Schoenflies modes, by equations typed here: one component, irreducible over the rationals.

Where the platform's normal n is not vertical, a limb's inner axes lie along k x n: with R = Rz(a) Rx(g) Rz(b), in axes
turned by a, a limb's top point is 5 (c, s, 0) + (0, r, z) from its foot, with c^2 + s^2 = 1 and r^2 + z^2 = 41. So

    (e_x^2 - z^2 + 16)^2 + e_y^4 + 2 e_y^2 (e_x^2 + z^2 - 16) - 100 e_y^2 = 0

for the vector (e_x, e_y, z) from each foot to its top: four equations in six unknowns, so that every component has two
dimensions or more. Over given x3 : x0 = tan((a + b) / 2) and x2 : x1 = tan((a - b) / 2) in Study's parameters they have
finitely many solutions. Two symmetries, in the plane of the feet (Z, S -> -Z, -S) and by half a turn, which exchanges
limbs (X, Y, S -> -X, -Y, -S), part these into sets of four. If the solutions modulo each of the three symmetries are a
field over the rationals, all are one: an extension by two roots is a field where none of a, b and a b is a square.

Components on which the two ratios are not free are not among these; one with b free is excluded below modulo a prime.
(L. Nurahmi, S. Caro, P. Wenger, J. Schadlbauer, M. Husty, Mech. Mach. Theory 96, 2016: a third mode, of two freedoms.)
"""

from __future__ import annotations

import re
import shutil

import numpy as np
import pytest
from support.parallel_mechanisms import four_ruu
from sympy import ZZ
from sympy.polys.galoistools import gf_gcd

from symscrew.mobility.components import (
    ALGEBRA_PROGRAM,
    AllowedTime,
    algebra_answer,
    closure_equations,
    pose_modes,
)
from symscrew.mobility.components.component_parts import linear_equations
from symscrew.mobility.components.counted_poses import choices, counted_poses
from symscrew.mobility.components.plane_sections import sums_of
from symscrew.mobility.components.real_configurations import real_configurations
from symscrew.mobility.finite import ClosureVariety
from symscrew.mobility.joint_network import network_of

pytestmark = pytest.mark.skipif(shutil.which(ALGEBRA_PROGRAM) is None, reason="Singular is not installed (singular-ui)")

PRIMES = (32009, 32063, 32083, 32119)
POSES = 192
RATIOS = (2, 5)  # x3 : x0 and x2 : x1
FORMS = {  # of the solutions; what does not change under one symmetry has each value twice
    "all": "3*X+5*Y+7*Z+11*C+13*S",
    "mirrored": "3*X+5*Y+11*C+7*Z*S+2*Z^2",
    "turned": "3*X*S+5*Y*S+11*C+7*Z+4*X^2",
    "both": "3*X*Z+5*Y*Z+11*C+7*S+4*X^2",
}


def equations(prime: int, ratios: tuple[int, int] = RATIOS) -> list[str]:
    """X, Y, S are over sqrt(d), d = (1 + p^2) (1 + q^2), of which only squares remain; modulo a prime."""
    p, q = ratios
    d = (1 + p * p) * (1 + q * q)

    def part(number: int) -> int:  # over d
        return number * pow(d, -1, prime) % prime

    cos_a, sin_a, cos_b, sin_b = 1 - p * q, p + q, 1 + p * q, p - q
    made = [f"C^2+{d}*S^2-1"]
    for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1)):  # limbs a quarter turn apart: foot (6, 0, 0), top (3, 1, 4)
        (x, y), (u, v) = (3 * c - s, 3 * s + c), (6 * c, 6 * s)
        bx, by, ax, ay = cos_b * x - sin_b * y, sin_b * x + cos_b * y, cos_a * u + sin_a * v, cos_a * v - sin_a * u
        xx = f"({d}*(X+{part(bx - ax)})^2)"
        yy = f"({d}*(Y+{part(by)}*C-{part(ay)})^2)"
        high = f"((Z+({by})*S)^2-16)"
        made.append(f"({xx}-{high})^2+{yy}^2+2*{yy}*({xx}+{high})-100*{yy}")
    return made


def factors(prime: int, form: str, ratios: tuple[int, int] = RATIOS) -> tuple[int, list[int]]:
    """(how many solutions, degrees of the factors of what a form of them is a zero of, each value once)."""
    answer = algebra_answer(
        f"""LIB "general.lib"; ring r = {prime}, (X,Y,Z,C,S,u), dp; option(redSB);
        ideal K = std(ideal({",".join(equations(prime, ratios))}, u-({form})));
        print("@size " + string(dim(K)) + " " + string(vdim(K)));
        ring s = {prime}, (X,Y,Z,C,S,u), lp; ideal L = fglm(r, K); poly f = L[1]; f = f / gcd(f, diff(f, u));
        list F = factorize(f, 1); int i;
        for (i = 1; i <= ncols(F[1]); i++) {{ print("@degree " + string(deg(F[1][i]))); }}
        print("@end"); quit;""", 10.0,
    )  # fmt: skip
    assert answer is not None and answer[1], answer
    size = re.search(r"@size 0 (\d+)", answer[0])
    assert size is not None, answer[0]
    return int(size[1]), [int(d) for d in re.findall(r"@degree (\d+)", answer[0])]


def test_real_configurations_are_zeros_of_what_is_typed_here() -> None:
    """Those of the package, by exponentials of joint screws, whose platform is not upright; on no other poses."""
    network = network_of(four_ruu())
    q = real_configurations(network, 24)
    poses = ClosureVariety(network).forward(q)[1]
    length, centre = float(network.length), np.array([float(c) for c in ClosureVariety(network).centre])
    seen = 0
    for rotation, moved in zip(*poses["plate"], strict=True):
        across = np.array([-rotation[1, 2], rotation[0, 2]])
        if np.linalg.norm(across) < 1e-3:
            continue
        across /= np.linalg.norm(across)
        shift = (centre - rotation @ centre + moved) * length
        for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1)):
            top = rotation @ np.array([3 * c - s, 3 * s + c, 4.0]) + shift - np.array([6.0 * c, 6.0 * s, 0.0])
            xx, yy, high = (across @ top[:2]) ** 2, (across[0] * top[1] - across[1] * top[0]) ** 2, top[2] ** 2 - 16
            value = (xx - high) ** 2 + yy**2 + 2 * yy * (xx + high) - 100 * yy
            assert abs(value) < 1e-7
        seen += 1
    assert seen > 5


def test_as_many_poses_wherever_the_ratios_are() -> None:
    """All simple; an accident of one place or prime would have another number."""
    for prime, ratios in zip(PRIMES, ((2, 5), (3, 7), (11, 4), (8, 29)), strict=True):
        count, degrees = factors(prime, FORMS["all"], ratios)
        assert count == sum(degrees) == POSES


@pytest.mark.slow
def test_the_package_counts_the_same_limb_by_limb_beside_the_known_modes() -> None:
    """Without the known modes left out there are endlessly many, and no count."""
    made = four_ruu()
    network = network_of(made)
    closure, modes = closure_equations(made, network), pose_modes(made, network)
    assert not isinstance(modes, str) and len(modes.modes) == 2
    beside = [linear_equations(mode.part) for mode in modes.modes]
    assert sorted(beside) == [("x2", "x1"), ("x3", "x0")]
    ratios = next(chosen for chosen in choices(closure, 2) if chosen[0].over is not None)
    assert [ratio.name(closure) for ratio in ratios] == ["x3 : x0", "x2 : x1"]
    found = counted_poses(closure, ratios, 1, beside=beside, allowed=AllowedTime(30.0))
    assert found is not None and found.total == POSES
    assert counted_poses(closure, ratios, 1, beside=beside[:1], allowed=AllowedTime(3.0)) is None


@pytest.mark.parametrize("form", ["mirrored", "turned", "both"])
def test_poses_modulo_each_symmetry_are_a_field(form: str) -> None:
    """Degrees of factors modulo primes leave no sum but nothing and all."""
    left = set(range(POSES))
    for prime in PRIMES[2:]:
        count, degrees = factors(prime, FORMS[form])
        assert count == POSES and sum(degrees) == POSES // 2
        left &= sums_of(degrees)
    assert left == {0, POSES // 2}


@pytest.mark.slow
def test_no_other_mode_has_b_free_and_a_tied_or_at_rest() -> None:
    """Over a given b, such a mode would have a curve over some a, which every plane in X, Y, Z, C, S meets: two planes
    have no a in common, modulo a prime. Poses with S = 0 are left out: the platform is upright or upside down."""
    prime, (cos_b, sin_b) = PRIMES[0], (-4 * pow(5, -1, PRIMES[0]), 3 * pow(5, -1, PRIMES[0]))
    made = ["C^2+S^2-1", "c^2+s^2-1", "w*S-1"]
    for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        (u, v) = (3 * x - y, 3 * y + x)
        bx, by = (cos_b * u - sin_b * v) % prime, (sin_b * u + cos_b * v) % prime
        ex, ey = f"(X+{bx}-({6 * x}*c+({6 * y})*s))", f"(Y+{by}*C-(({6 * y})*c-({6 * x})*s))"
        high = f"((Z+{by}*S)^2-16)"
        made.append(f"({ex}^2-{high})^2+{ey}^4+2*{ey}^2*({ex}^2+{high})-100*{ey}^2")
    one, other = (
        values_of("3*c+5*s", f"{','.join(made)}, {plane}", prime)
        for plane in ("2*X+3*Y-5*Z+7*C+4*S-9", "11*X-3*Y+8*Z+5*C-6*S+17")
    )
    assert len(one) == len(other) == 633 and gf_gcd(one, other, prime, ZZ) == [1]


def values_of(form: str, ideal: str, prime: int) -> list[int]:
    """What the values of a form at finitely many points are the zeros of, modulo a prime, the leading one first.

    Of multiplying by the form, on the monomials that are no leading ones of a basis and what follows from them; by the
    powers of one random vector, which have to be independent.
    """
    answer = algebra_answer(
        f"""ring r = {prime}, (w,X,Y,Z,C,S,c,s), dp; option(redSB); short = 0;
        ideal K = slimgb(ideal({ideal})); ideal B = kbase(K); ideal P = reduce(({form})*B, K); int i;
        for (i = 1; i <= ncols(B); i++) {{ print("@row " + string(B[i]) + " " + string(P[i])); }}
        print("@end"); quit;""", 40.0,
    )  # fmt: skip
    assert answer is not None and answer[1], answer
    rows = [line.split()[1:] for line in answer[0].splitlines() if line.startswith("@row")]
    places = {monomial: k for k, (monomial, _) in enumerate(rows)}
    size = len(rows)
    times = np.zeros((size, size), dtype=np.int64)
    for k, (_, polynomial) in enumerate(rows):
        for sign, number, monomial in re.findall(r"([+-]?)(\d*)\*?([a-zA-Z][^+-]*|)", polynomial):
            if number or monomial:
                times[k, places[monomial or "1"]] = int(f"{sign}{number or 1}") % prime
    powers = [np.random.default_rng(1).integers(prime, size=size)]
    for _ in range(size):
        powers.append(times @ powers[-1] % prime)
    table = np.array(powers).T  # its last column by the others
    for k in range(size):
        pivot = k + int(np.flatnonzero(table[k:, k])[0])
        table[[k, pivot]] = table[[pivot, k]]
        table[k] = table[k] * pow(int(table[k, k]), -1, prime) % prime
        below = np.flatnonzero(table[:, k])
        below = below[below != k]
        table[below, k:] = (table[below, k:] - table[below, k, None] * table[k, k:]) % prime
    return [1, *(int(-c) % prime for c in table[::-1, -1])]
