"""Programs joined to one program: outputs of one as inputs of another, shared intermediates computed once.

What a run evaluates at every stage is the forward dynamics behind the scene's controller. Both are programs of
their own; joined, they are one straight-line function without arrays in between.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from symscrew.program import Instruction, Port, Program

Operand = int | float  # a slot, or a number


class Linker:
    """Collects instructions of several programs over common inputs; equal instructions become one."""

    def __init__(self, inputs: Sequence[Port]) -> None:
        """Start a program with the given inputs."""
        self.inputs = tuple(inputs)
        self.entries: dict[str, tuple[Operand, ...]] = {}
        self._next = 0
        for port in inputs:
            self.entries[port.name] = tuple(range(self._next, self._next + port.size))
            self._next += port.size
        self._instructions: list[Instruction] = []
        self._known: dict[tuple[object, ...], int] = {}
        self._guards: dict[tuple[int, float], None] = {}

    def apply(self, op: str, *args: Operand) -> int:
        """The slot of one operation."""
        key = (op, *((type(a).__name__, a) for a in args))  # 2.0 is not slot 2
        if key not in self._known:
            self._known[key] = self._next
            self._instructions.append(Instruction(self._next, op, args))
            self._next += 1
        return self._known[key]

    def sum_of_products(self, left: Sequence[Operand], right: Sequence[Operand]) -> Operand:
        """sum left_k right_k."""
        total: Operand | None = None
        for a, b in zip(left, right, strict=True):
            term = self.apply("mul", a, b)
            total = term if total is None else self.apply("add", total, term)
        return 0.0 if total is None else total

    def call(self, program: Program, arguments: Mapping[str, Sequence[Operand]]) -> dict[str, tuple[Operand, ...]]:
        """Outputs of a program by name; inputs that `arguments` does not name are those of this program."""
        slots: list[Operand | None] = [None] * max(
            program.slots, 1 + max((i.target for i in program.instructions), default=0)
        )
        position = 0
        for port in program.inputs:
            given = arguments.get(port.name, self.entries.get(port.name))
            if given is None or len(given) != port.size:
                raise ValueError(f"{program.name}: nothing given for its input {port.name} of size {port.size}")
            slots[position : position + port.size] = given
            position += port.size

        def value(operand: Operand) -> Operand:
            if not isinstance(operand, int):
                return operand
            found = slots[operand]
            assert found is not None
            return found

        for instruction in program.instructions:
            slots[instruction.target] = self.apply(instruction.op, *[value(a) for a in instruction.args])
        for slot, threshold in program.guards:
            guard = value(slot)
            if isinstance(guard, int):
                self._guards[(guard, threshold)] = None
        return {
            port.name: tuple(value(s) for s in results)
            for port, results in zip(program.outputs, program.results, strict=True)
        }

    def program(self, name: str, description: str, outputs: Sequence[tuple[Port, Sequence[Operand]]]) -> Program:
        """The program with the given outputs."""
        return Program(
            name,
            description,
            self.inputs,
            tuple(port for port, _ in outputs),
            tuple(self._instructions),
            tuple(tuple(values) for _, values in outputs),
            tuple(self._guards),
            (),
            self._next,
        )
