"""Screws, twists, momentum screws and their rates as SymPy matrices that a person reads.

All parameters stay symbols, everything is at O in absolute axes, in the paper's orders. A quantity comes in
collected form, with the intermediate results that the tape shares as definitions; `substituted` puts them
back, `latex` prints it.

>>> from symscrew import catalogue
>>> quantities = Quantities(catalogue.load("slider_crank"))
>>> quantities.joint_screws("crank_R").substituted().T
Matrix([[0, 1, 0, 0, 0, 0]])
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import sympy

from symscrew.algebra import Node, sympy_expression
from symscrew.description import Mechanism
from symscrew.errors import DescriptionError, did_you_mean, expect
from symscrew.functions.kinematic import Motion, all_joint_screws
from symscrew.functions.momenta import mass_properties
from symscrew.kinematics import BodyMotion, MassProperties, System, identifiers, momentum_rate, momentum_screw

NOISE = 1e-40  # [any unit] of a constant: rounding of 60 digits is below, no length or mass of a mechanism is


@dataclass(frozen=True)
class Quantity:
    """A matrix with the definitions of its intermediate symbols, in order of use.

    `matrix`: SymPy, in inputs and intermediate symbols. `symbols`: (symbol, LaTeX, unit, description).
    """

    name: str
    matrix: sympy.Matrix
    definitions: tuple[tuple[sympy.Symbol, sympy.Expr], ...]
    symbols: tuple[tuple[sympy.Symbol, str, str, str], ...]

    def __repr__(self) -> str:
        rows, columns = self.matrix.shape
        return f"Quantity({self.name}: {rows} x {columns}, {len(self.definitions)} intermediate symbols)"

    def _repr_latex_(self) -> str:
        return "$$\\begin{gathered}\n" + self.latex() + "\n\\end{gathered}$$"

    def _latex(self, printer: object) -> str:
        """What `sympy.latex` prints of it: the matrix in the inputs alone, as one expression can hold it."""
        names = {symbol: text for symbol, text, _, _ in self.symbols}
        return str(sympy.latex(self.substituted(), symbol_names=names))

    def substituted(self) -> sympy.Matrix:
        """The matrix in the inputs alone; nothing is simplified."""
        known: dict[sympy.Symbol, sympy.Expr] = {}
        for symbol, expression in self.definitions:
            known[symbol] = expression.xreplace(known)
        return self.matrix.xreplace(known)

    def latex(self, *, substituted: bool = False) -> str:
        """LaTeX of the matrix, its definitions one per line; with `substituted` in the inputs alone."""
        names = {symbol: text for symbol, text, _, _ in self.symbols}
        names |= {symbol: str(symbol).replace("z", "z_{", 1) + "}" for symbol, _ in self.definitions}
        matrix = self.substituted() if substituted else self.matrix
        lines = [f"{self.name} = {sympy.latex(matrix, symbol_names=names)}"]
        if not substituted:
            lines += [f"{names[s]} = {sympy.latex(e, symbol_names=names)}" for s, e in self.definitions]
        return " \\\\\n".join(lines)


class Quantities:
    """What can be printed of a mechanism, by name."""

    def __init__(self, mechanism: Mechanism) -> None:
        expect(mechanism, Mechanism)
        symbolic = {name: replace(p, run_time=True) for name, p in mechanism.parameters.items()}
        self.mechanism = replace(mechanism, parameters=symbolic)
        self.system = System(self.mechanism)
        self.motion = Motion(self.system)
        self._screws = all_joint_screws(self.system, self.motion)

    def __repr__(self) -> str:
        return f"Quantities({self.mechanism.name!r}: joints, limbs, bodies and cut joints by name)"

    def joint_screws(self, joint: str) -> Quantity:
        """Unit screws of a joint as columns (omega ; v), 6 x freedoms, eq. (5)."""
        _known(joint, self._screws, "joint")
        return self._quantity(rf"S_{{\mathrm{{{_plain(joint)}}}}}", [s.components for s in self._screws[joint]])

    def limb_screws(self, limb: str) -> Quantity:
        """Screw matrix of a limb: its joints' unit screws as columns, eqs. (6), (11)."""
        _known(limb, self.mechanism.limbs, "limb")
        columns = [s.components for joint in self.mechanism.limbs[limb].joints for s in self._screws[joint]]
        return self._quantity(rf"S_{{\mathrm{{{_plain(limb)}}}}}", columns)

    def twist(self, body: str) -> Quantity:
        """Twist (omega ; v_O) of a body, 6 x 1, eq. (6)."""
        return self._quantity(rf"V_{{\mathrm{{{_plain(body)}}}}}", [self._motion(body).twist.components])

    def twist_rate(self, body: str) -> Quantity:
        """Componentwise rate of a body's twist, 6 x 1."""
        return self._quantity(rf"\dot V_{{\mathrm{{{_plain(body)}}}}}", [self._motion(body).rate.components])

    def momentum(self, body: str) -> Quantity:
        """Momentum screw (p ; L_O) of a body, 6 x 1, eq. (31)."""
        properties, motion = self._mass(body), self._motion(body)
        return self._quantity(
            rf"M_{{\mathrm{{{_plain(body)}}}}}", [momentum_screw(properties, motion.twist).components]
        )

    def momentum_rate(self, body: str) -> Quantity:
        """Rate of the momentum screw of a body, a wrench (f ; m_O), 6 x 1, eq. (35)."""
        properties, motion = self._mass(body), self._motion(body)
        return self._quantity(rf"\dot M_{{\mathrm{{{_plain(body)}}}}}", [momentum_rate(properties, motion).components])

    def constraints(self, joint: str) -> Quantity:
        """Reciprocal wrenches (f ; m_O) of a cut joint as columns, at O in absolute axes."""
        cuts = {cut.joint.name: cut for cut in self.system.cuts}
        _known(joint, cuts, "cut joint")
        cut = cuts[joint]
        pose = self.system.pose[cut.tip]
        at = pose.point(cut.tip_point)
        columns = []
        for row in cut.rows:
            force, couple = pose.direction(row.force), pose.direction(row.couple)
            arm = (
                at[1] * force[2] - at[2] * force[1],
                at[2] * force[0] - at[0] * force[2],
                at[0] * force[1] - at[1] * force[0],
            )
            columns.append((*force, *(c + m for c, m in zip(couple, arm, strict=True))))
        return self._quantity(rf"W_{{\mathrm{{{_plain(joint)}}}}}", columns)

    def _motion(self, body: str) -> BodyMotion:
        _known(body, self.system.tree.link_of_body, "body")
        return self.motion.body(body)

    def _mass(self, body: str) -> MassProperties:
        _known(body, self.mechanism.bodies, "body")
        properties = mass_properties(self.system, body)
        if properties is None:
            raise DescriptionError(f"body {body}: expected a mass for its momentum screw, it has none")
        return properties

    def _quantity(self, name: str, columns: Sequence[Sequence[object]]) -> Quantity:
        tape = self.system.tape
        nodes = [[tape.node(c) for c in column] for column in columns]
        shared = _shared([n for column in nodes for n in column])
        named = {node: sympy.Symbol(f"z{i + 1}", real=True) for i, node in enumerate(shared)}
        definitions = []
        for node, symbol in named.items():
            earlier = {other: s for other, s in named.items() if other.index < node.index}
            definitions.append((symbol, without_noise(sympy_expression(node, earlier))))
        rows = len(nodes[0]) if nodes else 0
        matrix = sympy.Matrix(rows, len(nodes), lambda i, j: without_noise(sympy_expression(nodes[j][i], named)))
        return Quantity(name, matrix, tuple(definitions), _symbols(self.system))


def without_noise(expression: sympy.Expr) -> sympy.Expr:
    """The expression without what 60 digits leave of a zero: -1.9e-62 z_3 is none."""
    noise = {n: sympy.Integer(0) for n in expression.atoms(sympy.Float) if abs(n) < NOISE}
    return expression.xreplace(noise) if noise else expression


def _shared(roots: Sequence[Node]) -> list[Node]:
    """Nodes that are used more than once below the roots and are worth a name, in order of evaluation."""
    uses: dict[Node, int] = {}
    stack, seen = list(roots), set()
    while stack:
        node = stack.pop()
        if node.index in seen or node.op in ("const", "symbol"):
            continue
        seen.add(node.index)
        for arg in node.args:
            uses[arg] = uses.get(arg, 0) + 1
            stack.append(arg)
    plain = ("const", "symbol", "neg", "sin", "cos")
    return sorted((n for n, count in uses.items() if count > 1 and n.op not in plain), key=lambda n: n.index)


def _symbols(system: System) -> tuple[tuple[sympy.Symbol, str, str, str], ...]:
    """Every input symbol with its LaTeX, unit and description."""
    marks = {"q": "", "v": r"\dot ", "a": r"\ddot "}
    latex: dict[str, str] = {}
    for prefix, entries in (("q", system.tree.q), ("v", system.tree.v), ("a", system.tree.v)):
        names = identifiers(c.label for c in entries)
        for c in entries:
            joint = c.label.replace("_", r"\_")
            letter = {"angle": r"\theta", "length": "p", "quaternion": r"\epsilon", "rotation": r"\omega"}[c.kind]
            mark = "" if c.kind == "rotation" and prefix == "v" else marks[prefix]
            latex[f"{prefix}_{names[c.label]}"] = rf"{mark}{letter}_{{\mathrm{{{joint}}}}}"
    result = []
    for name, node in system.tape.symbols.items():
        symbol = node.args[0]
        text = latex.get(name, sympy.latex(symbol.sympy))
        result.append((symbol.sympy, text, symbol.unit, symbol.description))
    return tuple(result)


def _plain(name: str) -> str:
    return name.replace("_", r"\_")


def _known(name: str, known: Collection[str], what: str) -> None:
    if name not in known:
        raise DescriptionError(f"expected the name of a {what}, got {name!r}{did_you_mean(name, known)}")
