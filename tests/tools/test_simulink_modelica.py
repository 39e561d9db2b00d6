"""Simulink's S-function by a stub of its header, and the Modelica package as a parser that is not ours reads it."""

from __future__ import annotations

import ctypes
import dataclasses
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.model_states import model

from symscrew.export import print_modelica
from symscrew.generation import generate, modelica_target, simulink_target
from symscrew.verification import check

FUNCTIONS = ["velocity", "assemble", "forward_dynamics", "inverse_kinematics", "closure"]


def test_blocks_of_simulink_give_what_the_evaluator_gives(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = model("four_bar").only(["velocity", "assemble"])
    generate(found, tmp_path / "out", ["simulink"])
    lines = check(tmp_path / "out").lines
    assert any("S-function, by a stub of Simulink, agrees with the evaluator" in line for line in lines)
    assert simulink_target.build(found, tmp_path / "out") == ""
    main = tmp_path / "out" / simulink_target.PLACE / "main"
    done = subprocess.run([str(main), "nothing"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "expected as its parameter the name of a function" in done.stderr
    assert "velocity, assemble" in done.stderr
    swapped = simulink_target.MAIN.replace("fwrite(values[1][port]", "values[1][port][0] += 1; fwrite(values[1][port]")
    monkeypatch.setattr(simulink_target, "MAIN", swapped)
    assert not check(tmp_path / "out").ok


def external_calls(text: str) -> dict[str, tuple[str, list[str], list[str]]]:
    """Function of the package -> what its external part calls, its result, its arguments: by pymoca's grammar."""
    pytest.importorskip("pymoca", reason="needs the extra 'modelica'")
    import antlr4
    from pymoca.generated.ModelicaLexer import ModelicaLexer
    from pymoca.generated.ModelicaListener import ModelicaListener
    from pymoca.generated.ModelicaParser import ModelicaParser

    found: dict[str, tuple[str, list[str], list[str]]] = {}

    class Calls(ModelicaListener):  # type: ignore[misc]
        def __init__(self) -> None:
            self.names: list[str] = []

        def enterClass_spec_comp(self, ctx: Any) -> None:  # noqa: N802
            self.names.append(ctx.IDENT()[0].getText())

        def exitClass_spec_comp(self, ctx: Any) -> None:  # noqa: N802
            self.names.pop()

        def enterExternal_function_call(self, ctx: Any) -> None:  # noqa: N802
            given = ctx.expression_list()
            arguments = [x.getText() for x in given.expression()] if given is not None else []
            result = ctx.component_reference()
            found[self.names[-1]] = (ctx.IDENT().getText(), [result.getText()] if result else [], arguments)

    parser = ModelicaParser(antlr4.CommonTokenStream(ModelicaLexer(antlr4.InputStream(text))))
    tree = parser.stored_definition()
    assert parser.getNumberOfSyntaxErrors() == 0
    antlr4.ParseTreeWalker().walk(Calls(), tree)
    return found


def test_the_modelica_package_calls_what_the_library_has(tmp_path: Path) -> None:
    """The C library, called as the parsed declarations and calls of the package say: values of the evaluator."""
    pymoca = pytest.importorskip("pymoca.parser", reason="needs the extra 'modelica'")
    found = model("four_bar").only(FUNCTIONS)
    generate(found, tmp_path / "out", ["modelica"])
    text = (tmp_path / "out" / "four_bar.mo").read_text()
    package, calls = pymoca.parse(text).classes["four_bar"], external_calls(text)
    assert modelica_target.library(found, tmp_path / "out") == ""
    library = ctypes.CDLL(str(tmp_path / "out" / "libfour_bar.so"))
    for name in FUNCTIONS:
        program, symbols = found.programs[name], package.classes[name].symbols
        kinds = {key: symbol.prefixes[0] for key, symbol in symbols.items()}
        sizes = {key: symbol.dimensions[0][0].value or 1 for key, symbol in symbols.items()}
        called, result, arguments = calls[name]
        assert result == ["status"] and sizes["status"] == 1 and symbols["status"].type.name == "Integer"
        given = [key for key in arguments if kinds[key] == "input"]
        made = [key for key in arguments if kinds[key] == "output"]
        assert [sizes[key] for key in given] == [p.size for p in program.inputs]
        expected, wanted = found(name, *found.test_inputs[name])
        for k in range(len(wanted)):
            arrays = {key: np.array(x[k], float) for key, x in zip(given, found.test_inputs[name], strict=True)}
            arrays |= {key: np.zeros(sizes[key]) for key in made}
            status = library[called](*[ctypes.c_void_p(arrays[key].ctypes.data) for key in arguments])
            assert status == wanted[k]
            for key, array in zip(made, expected, strict=True):
                assert np.allclose(arrays[key], array[k], rtol=0, atol=1e-12 * max(1.0, np.abs(array[k]).max()))
        block = package.classes[f"{name}_block"]
        equation = block.equations[0]
        assert str(equation.right.operator) == name and [str(x) for x in equation.right.operands] == given
        assert [str(x) for x in equation.left] == [*made, "status"]


def test_names_that_are_words_of_modelica(tmp_path: Path) -> None:
    pytest.importorskip("pymoca.parser", reason="needs the extra 'modelica'")
    found = model("four_bar").only(["velocity"])
    program = found.programs["velocity"]
    ports = [dataclasses.replace(p, name=n) for p, n in zip(program.inputs, ("der", "time"), strict=True)]
    made = [dataclasses.replace(p, name="status") for p in program.outputs]
    renamed = dataclasses.replace(program, inputs=tuple(ports), outputs=tuple(made))
    (text,) = print_modelica(dataclasses.replace(found, programs={"connect": renamed})).values()
    calls = external_calls(text)
    expected = ["der_of_model", "time_of_model", "status_of_model"]
    assert calls == {"connect_of_model": ("four_bar_connect", ["status"], expected)}
