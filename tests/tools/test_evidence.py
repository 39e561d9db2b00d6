"""The evidence on generated C: what it finds in good code, and that it finds what is wrong with bad code."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from support.model_states import model

from symscrew.cli.parser import main
from symscrew.export import print_c
from symscrew.verification.embedded import c_evidence as evidence
from symscrew.verification.embedded.c_evidence import DEVIATIONS, collect
from symscrew.verification.embedded.emulation import missing_tools

MISSING = [*missing_tools(), *(tool for tool in ("cppcheck", "gcov", "gcc", "nm") if shutil.which(tool) is None)]
NEEDED = pytest.mark.skipif(bool(MISSING), reason=f"not found: {'; '.join(MISSING)}")
FUNCTIONS = ["velocity", "assemble", "forward_dynamics"]


@NEEDED
def test_what_the_command_says_of_good_code(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = tmp_path / "evidence.md"
    code = main(["embedded", "four_bar", "--core", "m4f", "--function", *FUNCTIONS, "--report", str(report), "--json"])
    found = json.loads(capsys.readouterr().out)
    assert code == 0 and found["ok"] and found["reasons"] == []
    statuses = {name: set(map(int, entry["statuses"])) for name, entry in found["vectors"].items()}
    assert (
        statuses["velocity"] == {0, 1, 2}
        and statuses["assemble"] >= {0, 2, 3, 4}
        and statuses["forward_dynamics"] >= {-2, -1, 0, 2}
    )
    assert sum(entry["not_finite"] for entry in found["vectors"].values()) == 0
    # both paths whole; but the inertia of the crank, which is positive at every state, is never a small pivot
    assert found["branches"]["lines"] == 100 and found["branches"]["branches"] > 99
    assert all("pivot is smaller" in line for line in found["branches"]["missed"])
    assert set(found["misra"]) <= set(DEVIATIONS) and found["loops"]["unbounded"] == []
    text = report.read_text()
    assert "Verdict: **ok**" in text and all(f"| `{name}` |" in text for name in FUNCTIONS)
    assert all(f"- `{line}`" in text for line in found["branches"]["missed"])


BAD = """
static double *symscrew_bad(double x)
{
    while (x > 0.5) {
        x *= 0.5;
    }
    return malloc(8);
}
"""


@NEEDED
def test_what_is_wrong_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """Memory, a loop without a count, a rule without a justification, a number on success that is not finite."""

    def spoilt(*arguments: object, **options: object) -> dict[str, str]:
        files = dict(print_c(*arguments, **options))  # type: ignore[arg-type]
        source = files["four_bar.c"].replace("isfinite(sum) ? 0 : 2", "0")
        files["four_bar.c"] = f"#include <stdlib.h>\n{source}{BAD}double *four_bar_bad(double x);\n" + (
            "double *four_bar_bad(double x)\n{\n    return symscrew_bad(x);\n}\n"
        )
        return files

    monkeypatch.setattr(evidence, "print_c", spoilt)
    monkeypatch.setattr(evidence, "DEVIATIONS", {rule: why for rule, why in DEVIATIONS.items() if rule != "8.14"})
    found = collect(model("four_bar"), "m4f", "double", ["velocity"])
    assert not found.ok
    text = "\n".join(found.reasons)
    assert "rule 8.14: " in text and "the code has the word while" in text and "calls malloc" in text
    assert "velocity: " in text and "not finite on a status up to 0" in text and "**open**" in found.text
