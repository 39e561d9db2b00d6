"""Names in Rust: a type for every kind of array, one for the results of every function, and words that are taken.

    port q [rad] -> Q,  y_dot -> YDot;  function velocity -> VelocityOutput

Two ports are of one kind where name, shape, units and labels are the same; others of that name get a number.
"""

from __future__ import annotations

from collections.abc import Iterable

from symscrew.export.c_precision import Precision
from symscrew.model import Model
from symscrew.program import Iteration, Port, Program, RankRevealing

WORDS = "abstract as async await become box break const continue crate do dyn else enum extern false final fn for if"
WORDS += " impl in let loop macro match mod move mut override priv pub ref return self static struct super trait true"
WORDS += " try type typeof union unsafe unsized use virtual where while yield"
LOCALS = "arrays result code status core std given next target start part total cholesky constrained dot internal_load"
LOCALS += " orthogonalise rotate size is_small limited finite"
RESERVED = frozenset(f"{WORDS} {LOCALS}".split())
OWN_TYPES = "Self Box Clone Copy Debug Eq Err Math None Ok Option PartialEq Result Some Status Std"
TYPES = frozenset(f"{OWN_TYPES} Given Real".split())

Kind = tuple[str, tuple[int, ...], tuple[str, ...], tuple[str, ...]]


def real(precision: Precision) -> str:
    """The type of Rust: f32 or f64.

    >>> from symscrew.export.c_precision import SINGLE
    >>> real(SINGLE)
    'f32'
    """
    return "f32" if precision.suffix else "f64"


def safe(name: str) -> str:
    """A name of the model as an identifier of Rust.

    >>> safe("velocity"), safe("move")
    ('velocity', 'move_')
    """
    return f"{name}_" if name in RESERVED else name


def camel(name: str) -> str:
    """The name as that of a type.

    >>> camel("y_dot")
    'YDot'
    """
    return "".join(word[:1].upper() + word[1:] for word in name.split("_"))


class RustNames:
    """The names of one model's crate."""

    def __init__(self, model: Model) -> None:
        """Types of ports first, results of functions after them."""
        self.crate = safe(model.name.lower())
        self.types: dict[Port, str] = {}
        self.outputs: dict[str, str] = {}
        self._kinds: dict[Kind, str] = {}
        taken = set(TYPES)
        for program in model.programs.values():
            for port in (*program.inputs, *program.outputs):
                if _kind(port) not in self._kinds:
                    self.types[port] = self._kinds[_kind(port)] = _unused(camel(port.name), taken)
        for name in model.programs:
            self.outputs[name] = _unused(f"{camel(name)}Output", taken)

    def of(self, port: Port) -> str:
        """The type of a port."""
        return self._kinds[_kind(port)]

    def two_ways(self, program: Program | Iteration) -> bool:
        """Whether the results come with a status: that of the way to them."""
        return isinstance(program, RankRevealing)

    def function(self, name: str) -> str:
        """The function of a program."""
        return safe(name)

    def arguments(self, program: Program | Iteration) -> list[str]:
        """The names of inputs."""
        return arguments(program.inputs)

    def fields(self, program: Program | Iteration) -> list[str]:
        """The names of results."""
        return arguments(program.outputs)


def arguments(ports: Iterable[Port]) -> list[str]:
    """Ports as identifiers."""
    return [safe(port.name) for port in ports]


def _kind(port: Port) -> Kind:
    return port.name, port.shape, port.units, port.labels


def _unused(name: str, taken: set[str]) -> str:
    found, number = name, 2
    while found in taken:
        found, number = f"{name}{number}", number + 1
    taken.add(found)
    return found
