r"""The screws of a limb, from the base to the platform: axes and points as they are carried along, then the columns.

joints --Rodrigues, step by step--> e_{ik} unit vectors, r_{ik} points --> S_{ik} = (e_{ik} ; r_{ik} x e_{ik})

Angles are counted as an author counts them: from where the next axis or link would lie along an absolute axis, so that
a leg that leans by 30 degrees in the reference configuration has the angle 30 degrees there, and no sum of sines. With
G the rotation back by that constant, T_k = T_{k-1} Rot(G a, theta + phi) carries G u to where the joint carries u.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy

from symscrew.description import Joint, Mechanism
from symscrew.paper_formulas.formula import DEGREE, Formula, Part, degrees, index_of, latex_of, vector_latex
from symscrew.paper_formulas.named_lengths import Lengths

LONG = 230  # letters of LaTeX of a column that still fits a line of a paper; longer ones stay (e ; r x e)
MOST_OPERATIONS = 60  # of the entries of a matrix that is carried on: longer ones get names, and formulas stay short
MOST_OF_A_VECTOR = 12  # the same of an axis or a link as it lies: it enters every product of a rotation
MOST_OF_A_LEAN = 120  # of cosine and sine of an angle at rest: roots of roots grow with every joint, and take minutes
ZERO = sympy.zeros(3, 1)
PLAIN = ("R", "P", "U", "C", "S", "fixed")  # joint types whose motions are turns and translations along given axes


@dataclass(frozen=True)
class Freedom:
    """A freedom of a limb: its name in the code, whether it turns, axis and point in the reference configuration."""

    label: str
    turns: bool
    axis: sympy.Matrix
    point: sympy.Matrix
    spherical: bool = False
    joint: str = ""


def freedoms_of(mechanism: Mechanism, joints: Sequence[str]) -> list[Freedom] | str:
    """The freedoms of a chain in order from the ground, or a sentence why there are no formulas for it."""
    made: list[Freedom] = []
    body = mechanism.ground
    for name in joints:
        joint = mechanism.joints[name]
        if joint.parent != body:
            return f"{name} is not described from the base to the platform"
        if joint.type not in PLAIN:
            return f"{name} is a {joint.kind.name} joint, for which there are none yet"
        body = joint.child
        made += _of_joint(joint)
    return made


def _of_joint(joint: Joint) -> list[Freedom]:
    point = sympy.Matrix(joint.point)
    labels = joint.kind.freedom_names(joint.name)
    if joint.kind.ball:
        return [Freedom(n, True, sympy.eye(3)[:, k], point, True, joint.name) for k, n in enumerate(labels)]
    motions = zip(labels, joint.kind.freedoms, strict=True)
    return [Freedom(n, m.turns, sympy.Matrix(joint.axes[m.axis or 0]), point, joint=joint.name) for n, m in motions]


class Chain:
    """A limb's formulas, step by step."""

    def __init__(self, number: int, freedoms: Sequence[Freedom], lengths: Lengths) -> None:
        """`number` is the limb's index in all names."""
        self.number, self.lengths = number, lengths
        self.freedoms = freedoms
        self.names = dict(lengths.names)
        self.symbols: dict[str, str] = {}
        self.made: list[Formula] = []
        self.points: dict[str, str] = {}
        self.columns: list[str] = []
        self.circles: list[tuple[sympy.Symbol, sympy.Symbol]] = []
        self._run()

    def _run(self) -> None:
        turn, back = sympy.eye(3), sympy.eye(3)
        at = self.lengths.constant(self.freedoms[0].point) if self.freedoms else ZERO
        for k, freedom in enumerate(self.freedoms):
            index = index_of(self.number, k)
            if k:
                way = self.lengths.constant(back @ (freedom.point - self.freedoms[k - 1].point))
                at = self._tidy(at + turn @ self._skew(way, "b", index))
            self.columns.append(rf"\boldsymbol{{S}}_{index}")
            if freedom.spherical:
                self._column(freedom, index, freedom.axis, at)
                following = self.freedoms[k + 1 : k + 2]
                if self._leads(k) and not (following and following[0].joint == freedom.joint):
                    turn = self._frozen(self._tidy(turn @ self._any_rotation(freedom, index)), "T", index)
                continue
            still = self._skew(self.lengths.constant(back @ freedom.axis), "u", index)
            axis = self._tidy(turn @ still)
            if freedom.turns:
                self._column(freedom, index, axis, at)
                if self._leads(k):
                    cosine, sine = self._lean(still, back, k)
                    self._angle(freedom, index, cosine, sine)
                    turn = self._tidy(turn @ _rotation(still, *self._cosine_and_sine(index)))
                    back = self.lengths.exact(_rotation(still, cosine, -sine) @ back)
                    turn = self._frozen(turn, "T", index)
            else:
                slide = sympy.Symbol(f"d {index}", real=True)
                self.names[slide] = f"d_{index}"
                self.symbols[f"d_{index}"] = f"displacement of {freedom.label} from the reference configuration [m]"
                self._column(freedom, index, axis, at)
                at = self._tidy(at + slide * axis)
            at = self._frozen(at, "p", index)

    def _any_rotation(self, freedom: Freedom, index: str) -> sympy.Matrix:
        """The rotation of a spherical joint that carries more of the limb: symbols for its entries."""
        name = f"N_{index}"
        self.symbols[rf"\boldsymbol{{N}}_{index}"] = (
            f"rotation of {freedom.joint} from the reference configuration; its entries add row and column"
        )
        made = sympy.zeros(3, 3)
        for i in range(3):
            for j in range(3):
                made[i, j] = sympy.Symbol(f"N {index} {i + 1}{j + 1}", real=True)
                self.names[made[i, j]] = f"{name[:-1]},{i + 1}{j + 1}}}"
        return made

    def _skew(self, vector: sympy.Matrix, letter: str, index: str) -> sympy.Matrix:
        """A vector of the geometry, with names where it is long and along no absolute axis: u_{ik}, a link b_{ik}."""
        return self._frozen(vector, letter, index, most=MOST_OF_A_VECTOR) if sum(e != 0 for e in vector) > 1 else vector

    def _frozen(self, matrix: sympy.Matrix, letter: str, index: str, most: int = MOST_OPERATIONS) -> sympy.Matrix:
        """The matrix with names for its entries, once they are long: T_{ik} carries vectors, p_{ik} is a point."""
        if sum(sympy.count_ops(entry) for entry in matrix) <= most:
            return matrix
        name = rf"\boldsymbol{{{letter}}}_{index}"
        rows = [" & ".join(latex_of(e, self.names) for e in matrix.row(i)) for i in range(matrix.rows)]
        self.made.append(Formula(name, r"\begin{pmatrix} " + r" \\ ".join(rows) + r" \end{pmatrix}", ("entries",)))
        named = matrix.copy()
        for i in range(matrix.rows):
            for j in range(matrix.cols):
                if not matrix[i, j].is_number:
                    place = f"{i + 1}{j + 1}" if matrix.cols > 1 else str(i + 1)
                    entry = sympy.Symbol(f"{letter} {index} {place}", real=True)
                    self.names[entry] = f"{letter}_{{{index[1:-1]},{place}}}"
                    named[i, j] = entry
        return named

    def _leads(self, k: int) -> bool:
        """Whether the k-th freedom carries anything that is printed: an axis, or a point that is not its own."""
        rest = self.freedoms[k + 1 :]
        return any(not f.spherical or f.point != self.freedoms[k].point for f in rest)

    def _lean(self, still: sympy.Matrix, back: sympy.Matrix, k: int) -> tuple[sympy.Expr, sympy.Expr]:
        """Cosine and sine of the angle by which what follows leans from an absolute axis, about an absolute axis."""
        one, zero = sympy.Integer(1), sympy.Integer(0)
        along = [j for j in range(3) if still[j] != 0]
        if len(along) != 1:
            return one, zero
        a, sign = along[0], still[along[0]]
        b, c = (a + 1) % 3, (a + 2) % 3
        for vector in self._following(k):
            here = self.lengths.constant(back @ vector)
            if here[b] == 0 and here[c] == 0:
                continue
            size = sympy.sqrt(sympy.expand(self.lengths.written(here[b] ** 2 + here[c] ** 2)))
            first, second = self.lengths.written(here[b]) / size, self.lengths.written(here[c]) / size
            if sympy.count_ops(first) + sympy.count_ops(second) > MOST_OF_A_LEAN:
                return one, zero
            if abs(self.lengths.number(first)) >= abs(self.lengths.number(second)):  # from the nearer absolute axis
                flip = sympy.sign(self.lengths.number(first))
                return self.lengths.simple(flip * first), self.lengths.simple(flip * sign * second)
            flip = sympy.sign(self.lengths.number(second))
            return self.lengths.simple(flip * second), self.lengths.simple(-flip * sign * first)
        return one, zero

    def _following(self, k: int) -> list[sympy.Matrix]:
        """What the k-th freedom carries: links and axes in order."""
        made = []
        for before, freedom in zip(self.freedoms[k:], self.freedoms[k + 1 :], strict=False):
            made.append(freedom.point - before.point)
            if not freedom.spherical:
                made.append(freedom.axis)
        return made

    def _angle(self, freedom: Freedom, index: str, cosine: sympy.Expr, sine: sympy.Expr) -> None:
        angle = rf"\theta_{index}"
        lean = "" if sine == 0 else rf" + \varphi_{index}"
        words = f"angle of {freedom.label} from the reference configuration [rad]"
        self.symbols[angle] = words
        if lean:
            self.made.append(
                Formula(rf"\cos \varphi_{index}", latex_of(self.lengths.named(cosine), self.names), ("lean cosine",))
            )
            self.made.append(
                Formula(rf"\sin \varphi_{index}", latex_of(self.lengths.named(sine), self.names), ("lean sine",))
            )
        self.made.append(Formula(f"c_{index}", rf"\cos({angle}{lean})", ("cosine", freedom.label)))
        self.made.append(Formula(f"s_{index}", rf"\sin({angle}{lean})", ("sine", freedom.label)))

    def _cosine_and_sine(self, index: str) -> tuple[sympy.Symbol, sympy.Symbol]:
        cosine, sine = (sympy.Symbol(f"{letter} {index}", real=True) for letter in ("c", "s"))
        self.names |= {cosine: f"c_{index}", sine: f"s_{index}"}
        self.circles.append((cosine, sine))
        return cosine, sine

    def _column(self, freedom: Freedom, index: str, axis: sympy.Matrix, at: sympy.Matrix) -> None:
        """A unit screw: (e ; r x e) of a turn, (0 ; e) of a translation."""
        lower = self._tidy(at.cross(axis)) if freedom.turns else axis
        name, code = rf"\boldsymbol{{S}}_{index}", ("screw", freedom.label)
        whole = vector_latex(sympy.Matrix([*(axis if freedom.turns else ZERO), *lower]), self.names)
        if len(whole) <= LONG:
            self.made.append(Formula(name, whole, code))
            return
        e, r = rf"\boldsymbol{{e}}_{index}", rf"\boldsymbol{{r}}_{index}"
        self.made.append(Formula(e, vector_latex(axis, self.names)))
        if not freedom.turns:
            self.made.append(Formula(name, rf"\begin{{pmatrix}} \boldsymbol{{0}} \\ {e} \end{{pmatrix}}", code))
            return
        point = vector_latex(at, self.names)
        if point in self.points:
            r = self.points[point]
        else:
            self.points[point] = r
            self.made.append(Formula(r, point))
        self.made.append(Formula(name, rf"\begin{{pmatrix}} {e} \\ {r} \times {e} \end{{pmatrix}}", code))

    def _tidy(self, matrix: sympy.Matrix) -> sympy.Matrix:
        return matrix.applyfunc(lambda entry: self._on_circles(self.lengths.tidy(entry)))

    def _on_circles(self, expression: sympy.Expr) -> sympy.Expr:
        """cos^2 + sin^2 = 1 put in, where that makes it shorter."""
        for pair in self.circles:
            if not set(pair) <= expression.free_symbols or sympy.count_ops(expression) > MOST_OPERATIONS:
                continue
            flat = sympy.expand(expression)
            others = [other for way in (pair, pair[::-1]) if (other := _without_square(flat, *way)) != flat]
            expression = min(
                (expression, *map(self.lengths.tidy, others)), key=lambda e: (sympy.count_ops(e), len(str(e)))
            )
        return expression


def _rotation(axis: sympy.Matrix, cosine: sympy.Expr, sine: sympy.Expr) -> sympy.Matrix:
    """cos I + sin [u]x + (1 - cos) u u^T (Rodrigues)."""
    u = axis
    skew = sympy.Matrix([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    return cosine * sympy.eye(3) + sine * skew + (1 - cosine) * (u @ u.T)


def _without_square(flat: sympy.Expr, one: sympy.Symbol, other: sympy.Symbol) -> sympy.Expr:
    """A sum of products with 1 - other^2 for one^2."""

    def lower(power: sympy.Expr) -> sympy.Expr:
        return (1 - other**2) ** (power.exp // 2) * one ** (power.exp % 2)

    return sympy.expand(flat.replace(lambda e: e.is_Pow and e.base == one and e.exp.is_Integer and e.exp > 1, lower))


def limb_part(mechanism: Mechanism, joints: Sequence[str], number: int, lengths: Lengths) -> Part:
    """Axes, points and screws of a limb."""
    found = freedoms_of(mechanism, joints)
    title = f"Limb {number}"
    if isinstance(found, str):
        return Part(title, f"No formulas: {found}.")
    along = own_axis(found, lengths)
    chain = Chain(number, found if along is None else turned_back(found, along), lengths)
    letters = "".join(mechanism.joints[name].type for name in joints)
    words = [f"Joints from the base: {letters}."]
    whole = rf"\begin{{bmatrix}} {' & '.join(chain.columns)} \end{{bmatrix}}"
    if along is not None:
        angle = degrees(float(sympy.atan2(along[1], along[0])) * DEGREE)
        words.append(
            f"Its screws are in axes of its own, turned by {angle} degrees about z; $\\boldsymbol{{Z}}$ turns the "
            "angular and the linear part of every screw."
        )
        whole = rf"\boldsymbol{{Z}}({angle}^{{\circ}}) {whole}"
    if any(freedom.spherical for freedom in found):
        which = "the absolute" if along is None else "these"
        words.append(f"Columns of the spherical joint are about {which} axes through its centre.")
    made = (*chain.made, Formula(rf"\boldsymbol{{S}}_{{{number}}}", whole, ("matrix",)))
    return Part(title, " ".join(words), made, chain.symbols)


def own_axis(freedoms: Sequence[Freedom], lengths: Lengths) -> sympy.Matrix | None:
    """Where x of a limb's own axes points, a unit vector across z; None where the absolute axes serve as well.

    The first turn about a level axis is about the limb's x or y, and the limb begins where x points: authors draw a
    limb in a plane of its own.
    """
    for freedom in freedoms:
        x, y, z = freedom.axis
        if not freedom.turns or freedom.spherical or z != 0:
            continue
        if x == 0 or y == 0 or freedom.axis.free_symbols:
            return None
        ways = [sign * sympy.Matrix(way) for way in ((x, y, 0), (-y, x, 0)) for sign in (1, -1)]
        return max(ways, key=lambda way: lengths.number(way.dot(freedoms[0].point)))
    return None


def turned_back(freedoms: Sequence[Freedom], along: sympy.Matrix) -> list[Freedom]:
    """Freedoms in axes whose x is `along`; a spherical joint's columns are about these."""
    c, s = along[0], along[1]
    back = sympy.Matrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return [replace(f, axis=f.axis if f.spherical else back @ f.axis, point=back @ f.point) for f in freedoms]
