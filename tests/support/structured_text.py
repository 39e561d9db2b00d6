"""Structured text run by a parser that is not ours: tree-sitter's grammar of IEC 61131-3, its tree as Python.

text --tree_sitter_iec61131_3_st--> tree --source--> Python, a class per function block
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any


def of_doubles(of: Callable[[float], float]) -> Callable[[float], float]:
    """A function of Python's `math`, which raises where those of C give NaN or infinity."""

    def called(x: float) -> float:
        try:
            return of(x)
        except OverflowError:
            return math.inf
        except ValueError:
            return math.nan

    return called


OPERATORS = {"=": "==", "<>": "!=", "AND": "and", "OR": "or"}
FUNCTIONS = {
    **{of.__name__.upper(): of_doubles(of) for of in (math.sin, math.cos, math.tan, math.atan, math.exp, math.sqrt)},
    "ABS": abs, "SEL": lambda choice, no, yes: yes if choice else no,
    "INT_TO_LREAL": float,
}  # fmt: skip


class Number(float):
    """A double whose division by zero is that of the standard for floating point."""

    def __truediv__(self, other: float) -> float:
        if other == 0.0:
            return math.nan if self == 0.0 or self != self else math.copysign(math.inf, self) * math.copysign(1, other)
        return float(self) / other


def blocks(text: str) -> dict[str, Any]:
    """Name in lower case to what makes a function block; calls take arrays, results are attributes."""
    import tree_sitter_iec61131_3_st as grammar
    from tree_sitter import Language, Parser

    root = Parser(Language(grammar.language())).parse(text.encode()).root_node
    assert not root.has_error, first_error(root)
    types = {}
    made: dict[str, Any] = {"Number": Number, **{f"f_{name.lower()}": f for name, f in FUNCTIONS.items()}}
    lines = ["import copy"]
    for part in root.named_children:
        if part.type == "type_declaration":
            types |= {word(d.named_children[0]): length(d) for d in part.named_children}
        elif part.type == "function_block_declaration":
            lines += block(part, types)
        elif part.type == "function_declaration":
            lines += function(part)
    exec(compile("\n".join(lines), "structured text", "exec"), made)  # what the grammar made of our own text
    return {name: made[name] for name in made if isinstance(made[name], type) and name != "Number"}


def first_error(node: Any) -> str:
    return next((f"{n.start_point}: {n.text!r:.80}" for n in walk(node) if n.type == "ERROR" or n.is_missing), "")


def walk(node: Any) -> Iterator[Any]:
    yield node
    for child in node.children:
        yield from walk(child)


def word(node: Any) -> str:
    text: str = node.text.decode().lower()
    return text


def length(node: Any) -> int:
    (found,) = [n for n in walk(node) if n.type == "subrange"]
    low, high = (int(n.text) for n in found.named_children)
    return high - low + 1


def block(node: Any, types: dict[str, int]) -> list[str]:
    """A class: fields are set when it is made, inputs when it is called."""
    name, *parts = node.named_children
    fields, statements = [], []
    for part in parts:
        if part.type in ("var_input", "var_output", "var_block"):
            for declared in (child for child in part.named_children if child.type == "variable_declaration"):
                field, kind, *initial = declared.named_children
                start = word(initial[0]) if initial else {"lreal": "0.0", "int": "0", "bool": "False"}.get(word(kind))
                if word(kind) in types:
                    start = f"[0.0] * {types[word(kind)]}"
                fields.append(f"        self.{word(field)} = {start or f'{word(kind)}()'}")
        else:
            statements += statement(part, "self.", " " * 8)
    return [
        f"class {word(name)}:",
        "    def __init__(self):",
        *fields,
        "    def __call__(self, **given):",
        "        for name, value in given.items():",
        "            setattr(self, name, copy.copy(value))",
        *statements,
    ]


def function(node: Any) -> list[str]:
    name, _, *parts = node.named_children
    given = [word(d.named_children[0]) for p in parts if p.type == "var_input" for d in p.named_children]
    body = [line for p in parts if p.type != "var_input" for line in statement(p, "", "    ")]
    return [f"def f_{word(name)}({', '.join(given)}):", *body, f"    return {word(name)}"]


def statement(node: Any, own: str, indent: str) -> list[str]:
    if node.type in ("empty_statement", "comment"):
        return []
    if node.type == "assignment_statement":
        left, right = node.named_children
        return [f"{indent}{value(left, own)} = copy.copy({value(right, own)})"]
    if node.type == "invocation_statement":
        called, *given = node.named_children[0].named_children
        pairs = [x.named_children for arguments in given for x in arguments.named_children]
        text = ", ".join(f"{word(a)}={value(b, own)}" for a, b in pairs)
        return [f"{indent}{value(called, own)}({text})"]
    if node.type == "if_statement":
        condition, *parts = node.named_children
        lines = [f"{indent}if {value(condition, own)}:"]
        for part in parts:
            if part.type == "elsif_clause":
                test, *inner = part.named_children
                lines += [f"{indent}elif {value(test, own)}:", *several(inner, own, indent)]
            elif part.type == "else_clause":
                lines += [f"{indent}else:", *several(part.named_children, own, indent)]
            else:
                lines += statement(part, own, indent + "    ")
        return [*lines[:1], f"{indent}    pass", *lines[1:]]
    if node.type == "while_statement":
        condition, *inner = node.named_children
        return [f"{indent}while {value(condition, own)}:", *several(inner, own, indent)]
    raise AssertionError(f"a statement {node.type}: {node.text!r:.60}")


def several(nodes: Any, own: str, indent: str) -> list[str]:
    return [f"{indent}    pass", *(line for n in nodes for line in statement(n, own, indent + "    "))]


def value(node: Any, own: str) -> str:
    parts = node.named_children
    if node.type == "identifier":
        return f"{own}{word(node)}"
    if node.type == "boolean_literal" or node.text in (b"TRUE", b"FALSE"):
        return node.text.decode().capitalize()
    if node.type == "real_literal":
        return f"Number({node.text.decode()})"
    if node.type == "integer_literal":
        return str(node.text.decode())
    if node.type == "index_expression":
        return f"{value(parts[0], own)}[{value(parts[1], own)}]"
    if node.type == "member_access_expression":
        return f"{value(parts[0], own)}.{word(parts[1])}"
    if node.type == "parenthesized_expression":
        return f"({value(parts[0], own)})"
    if node.type == "unary_expression":
        sign = node.children[0].text.decode().upper()
        return f"({'not ' if sign == 'NOT' else sign}{value(parts[0], own)})"
    if node.type == "binary_expression":
        sign = next(c.text.decode() for c in node.children if not c.is_named)
        left, right = value(parts[0], own), value(parts[1], own)
        return f"(Number({left}) / {right})" if sign == "/" else f"({left} {OPERATORS.get(sign, sign)} {right})"
    if node.type == "call_expression":
        name, *given = parts
        return f"f_{word(name)}({', '.join(value(x, own) for g in given for x in g.named_children)})"
    raise AssertionError(f"an expression {node.type}: {node.text!r:.60}")
