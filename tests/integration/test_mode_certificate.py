"""The proof that a configuration continues a mode: balls that hold what they say, and no step onto another mode."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.marks import slow
from support.model_states import model

from symscrew.export.mode_certificate import (
    NEAR,
    OPERATIONS,
    ModeCertificate,
    certificate_part,
    find_mode_certificate,
)
from symscrew.program import Instruction, Port, Program, evaluate
from symscrew.runtime import compile_c

pytestmark = pytest.mark.slow

ASKED = """
int certified(const double *from, const double *to)
{
    static CertificateWork work;
    return mode_certified(&work, from, to);
}
void balls(const double *box, double *made)
{
    Ball q[CERTIFICATE_Q], found[CERTIFICATE_SLOPES + CERTIFICATE_N];
    for (int k = 0; k < CERTIFICATE_Q; ++k) {
        q[k] = (Ball){box[2 * k], box[2 * k + 1]};
    }
    certificate_openings(q, found);
    certificate_slopes(q, found + CERTIFICATE_N);
    for (int k = 0; k < CERTIFICATE_SLOPES + CERTIFICATE_N; ++k) {
        made[2 * k] = found[k].m;
        made[2 * k + 1] = found[k].r;
    }
}
"""


def built(certificate: ModeCertificate, folder: Path) -> ctypes.CDLL:
    (folder / "proof.c").write_text("\n".join(["#include <math.h>", *certificate_part(certificate), ASKED]))
    compile_c(folder / "proof.c", folder / "proof.so", flags=("-Wall", "-Wextra", "-Wconversion", "-Werror"))
    return ctypes.CDLL(str(folder / "proof.so"))


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def asked(library: ctypes.CDLL) -> Callable[[np.ndarray, np.ndarray], bool]:
    def proved(a: np.ndarray, b: np.ndarray) -> bool:
        ends = np.ascontiguousarray([a, b])
        return bool(library.certified(pointer(ends[0]), pointer(ends[1])))

    return proved


def of(name: str) -> ModeCertificate:
    found = model(name)
    labels = [x.label for x in found.system.tree.q]
    return find_mode_certificate(found, [labels.index(y) for y in found.independent])


@pytest.mark.parametrize("name", ["five_bar", slow("three_ups_upu_s")])
def test_balls_hold_the_closure_and_its_slopes(name: str, tmp_path: Path) -> None:
    """Boxes of every width about states: what the evaluator says of points in them, corners too, is in the balls."""
    certificate = of(name)
    library, rng = built(certificate, tmp_path), np.random.default_rng(3)
    found = model(name)
    count = len(certificate.dependent) - len(certificate.turns)
    for width in (0.0, 1e-12, 1e-6, 1e-3, 0.1):
        q = found.system.states(1, int(1e3 * width) + 5)[0][1]
        balls = np.zeros((len(certificate.places) + len(certificate.dependent), 2))
        box = np.ascontiguousarray(np.column_stack([q, np.full(len(q), width)]))
        library.balls(pointer(box), pointer(balls))
        points = q + width * np.sign(rng.normal(size=(40, len(q)))) * rng.choice([1.0, 0.5], size=(40, len(q)))
        given = [points, *([np.tile(certificate.parameters, (40, 1))] if len(certificate.openings.inputs) > 1 else [])]
        values = np.hstack([evaluate(p, given)[0][0] for p in (certificate.openings, certificate.slopes)])
        own = np.vstack([balls[:count], balls[len(certificate.dependent) :]])
        room = own[:, 1] * (1 + 1e-6) + 4e-16 * (1 + np.abs(values))  # the evaluator rounds, too
        assert (np.abs(values - own[:, 0]) <= room).all()
        assert own[:, 1].max() <= 60 * (width + 1e-15)  # and says something: no slope of these is above some tens


def test_every_operation_on_balls_holds_its_range(tmp_path: Path) -> None:
    """Each operation of programs at random balls, against NumPy at their ends and within."""
    rng = np.random.default_rng(5)
    ports = (Port("q", (3,), ("1",) * 3, ("a", "b", "c"), ""),)
    sizes = {op: text.count("Ball") for op, (_, text, _) in OPERATIONS.items()}
    functions = []
    for op in OPERATIONS:
        own = Instruction(3, op, tuple(range(sizes[op])))
        functions.append(Program(op, "", ports, ports[:1], (own,), ((3,),), (), slots=4))
    body, names = [], list(OPERATIONS)
    for op in names:
        given = ", ".join(f"x[{k}]" for k in range(sizes[op]))
        body.append(f"    made[{len(body)}] = ball_{op}({given});")
    text = "\n".join(certificate_part(of("five_bar")))
    head = text[: text.index("static inline")]
    every = [f"static inline Ball ball_{op}({given})\n{{\n{inner}\n}}" for op, (_, given, inner) in OPERATIONS.items()]
    code = ["#include <math.h>", re.sub(r"static const .*?;", "", head, flags=re.DOTALL), *every]
    code += ["void every(const Ball *x, Ball *made)", "{", *body, "}"]
    (tmp_path / "every.c").write_text("\n".join(code))
    compile_c(tmp_path / "every.c", tmp_path / "every.so", flags=())
    library, known = ctypes.CDLL(str(tmp_path / "every.so")), dict.fromkeys(names, 0)
    for trial in range(250):
        middle = rng.normal(size=3) * 10.0 ** rng.integers(-2, 2, 3)
        radius = np.abs(middle) * 10.0 ** rng.integers(-14, 1, 3) * (trial % 5 > 0)
        balls, made = np.column_stack([middle, radius]), np.zeros((len(names), 2))
        library.every(pointer(balls), pointer(made))
        points = middle + radius * np.vstack([rng.uniform(-1, 1, (20, 3)), rng.choice([-1, 1], (20, 3))])
        for k, (op, program) in enumerate(zip(names, functions, strict=True)):
            with np.errstate(all="ignore"):
                (values,), _ = evaluate(program, [points])
            if np.isfinite(made[k, 1]):
                known[op] += 1
                off = np.abs(values[:, 0] - made[k, 0])
                assert (off <= made[k, 1] * (1 + 1e-6) + 4e-16 * np.abs(made[k, 0])).all(), (op, balls)
    assert min(known.values()) > 60  # of sqrt half of the middles are negative


def modes(certificate: ModeCertificate, y: np.ndarray) -> list[np.ndarray]:
    """The configurations of the five-bar with these angles given, by Newton's method from angles all over."""
    grid = np.linspace(-np.pi, np.pi, 4, endpoint=False) + 0.1
    q = np.zeros((16, 4))
    q[:, list(certificate.free)] = y
    follow = list(certificate.dependent)
    q[:, follow] = np.array(np.meshgrid(grid, grid)).reshape(2, -1).T
    rows, columns = np.array(certificate.places).T
    for _ in range(12):
        opening, slopes = (evaluate(p, [q])[0][0] for p in (certificate.openings, certificate.slopes))
        dense = np.zeros((len(q), 2, 4))
        dense[:, rows, columns] = slopes
        (a, b), (c, d) = dense[:, :, follow].transpose(1, 2, 0)
        x, z = opening.T
        step = np.column_stack([d * x - b * z, a * z - c * x]) / (a * d - b * c + 1e-300)[:, None]
        q[:, follow] -= step / np.maximum(1.0, 2 * np.abs(step).max(axis=1, keepdims=True))
    closed = q[np.abs(evaluate(certificate.openings, [q])[0][0]).max(axis=1) < 1e-13]
    closed[:, follow] -= 2 * np.pi * np.round(closed[:, follow] / (2 * np.pi))
    found: list[np.ndarray] = []
    for one in closed:
        if all(np.abs(one - other).max() > 1e-6 for other in found):
            found.append(one)
    return found


def test_no_step_onto_another_mode_is_proved(tmp_path: Path) -> None:
    """The five-bar towards where its two modes meet: closer and closer they never count as one, each does as itself."""
    certificate = find_mode_certificate(model("five_bar"), [0, 1])  # its left side leads, its right side follows
    prove = asked(built(certificate, tmp_path))
    low, high, along = 0.0, 1.0, np.array([0.0, -1.0])
    for _ in range(28):  # to where the loop opens
        middle = (low + high) / 2
        low, high = (middle, high) if len(modes(certificate, middle * along)) == 2 else (low, middle)
    apart = []
    for way in (0.3, 0.01, 1e-4, 1e-6, 3e-8):
        a, b = modes(certificate, low * (1 - way) * along)
        nearer = modes(certificate, low * (1 - 1.001 * way) * along)
        apart.append(float(np.abs(a - b).max()))
        assert not prove(a, b) and not prove(b, a)
        for other in nearer:  # each goes on as one of the two, and is proved to, but in the last digits
            assert [prove(a, other), prove(b, other)].count(True) in ((1,) if way > 1e-7 else (0, 1))
        assert (prove(a, a) and prove(b, b)) or way < 1e-7
    assert apart[0] > 0.5 and apart[-1] < 1e-2


@pytest.mark.parametrize("name", ["five_bar", slow("three_ups_upu_s"), slow("stewart_6ups")])
def test_what_is_not_closed_or_too_far_is_not_proved(name: str, tmp_path: Path) -> None:
    certificate, found = of(name), model(name)
    prove = asked(built(certificate, tmp_path))
    q = np.array(found.system.reference)
    free = list(certificate.free)
    moved = q[free] + 1e-3 * np.array([certificate_unit(found, k) for k in free])
    (near,), status = found("assemble", moved[None], q[None])
    assert status[0] == 0 and prove(q, q) and prove(q, near[0]) and prove(near[0], q)
    for k, unit in zip(certificate.dependent, certificate.units, strict=True):
        off = near[0].copy()
        off[k] += 40 * NEAR * unit
        assert not prove(q, off) and not prove(off, q)
        off[k] = np.nan
        assert not prove(q, off) and not prove(off, q)
    far = near[0].copy()
    far[certificate.dependent[0]] += 3.0
    assert not prove(q, far)


def certificate_unit(found: object, entry: int) -> float:
    system = found.system  # type: ignore[attr-defined]
    return float(system.length) if system.tree.q[entry].unit == "m" else 1.0
