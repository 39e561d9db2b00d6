"""Target "javascript": functions for a page or Node, which runs them here."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from symscrew.export import print_javascript
from symscrew.generation.target_file import Case, Finding, Order
from symscrew.generation.value_comparison import Results, compare_values, first_path

LIMIT = 120  # seconds for the functions of a model at their test states, which take milliseconds
NODE = """
const model = require(process.argv[1]);
const calls = JSON.parse(require("fs").readFileSync(process.argv[2], "utf8"));
const plain = (value) => typeof value === "object" ? Array.from(value) : value;
const entries = (result) => Object.entries(result).map(([key, value]) => [key, plain(value)]);
const answers = calls.map(([name, given]) => Object.fromEntries(entries(model[name](...given))));
process.stdout.write(JSON.stringify(answers));
"""


def files(order: Order) -> Mapping[str, str]:
    """<name>.js."""
    return print_javascript(order.model)


def compare(case: Case) -> Iterator[Finding]:
    """Values by Node. There is no second path in JavaScript: where the others take it, its status is 1."""
    node = shutil.which("node")
    if node is None:
        yield True, "no Node here (apt install nodejs): JavaScript not run"
        return
    directory, model, expected = case.fresh, case.model, case.expected
    calls = [
        (name, [array[k].tolist() for array in model.test_inputs[name]])
        for name, (_, status) in expected.items()
        for k in range(len(np.ravel(status)))
    ]
    (directory / "calls.json").write_text(json.dumps(calls))
    command = [node, "-e", NODE, str(directory / f"{model.name}.js"), str(directory / "calls.json")]
    try:
        done = subprocess.run(
            command, capture_output=True, encoding="utf-8", errors="replace", check=False, timeout=LIMIT
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        yield False, f"Node does not run {model.name}.js: {error}"
        return
    if done.returncode:
        yield False, f"Node refuses {model.name}.js: {done.stderr.strip()[:300]}"
        return
    answers = iter(json.loads(done.stdout))

    def evaluate(name: str, inputs: Sequence[np.ndarray]) -> Results:
        rows = [next(answers) for _ in np.ravel(expected[name][1])]
        ports = model.programs[name].outputs
        arrays = tuple(np.array([row[p.name] for row in rows], dtype=float).reshape(len(rows), p.size) for p in ports)
        return arrays, np.array([row["status"] for row in rows])

    yield compare_values("JavaScript", model, {name: first_path(*found) for name, found in expected.items()}, evaluate)
