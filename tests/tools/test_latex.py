"""LaTeX of the report of mobility, compiled."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.mobility import findings
from symscrew.mobility.analysis import analyse_mobility


@pytest.mark.parametrize("name", ["three_ups_upu_s", "bennett"])
def test_latex_compiles(name: str, tmp_path: Path) -> None:
    compiler = shutil.which("pdflatex")
    if compiler is None:
        pytest.skip("pdflatex is not installed (texlive-latex-base, texlive-latex-recommended)")
    (tmp_path / "report.tex").write_text(findings.mobility_latex(analyse_mobility(catalogue.load(name))))
    command = [compiler, "-interaction=nonstopmode", "-halt-on-error", "report.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, errors="replace", timeout=120)
    assert done.returncode == 0, done.stdout[-2000:]
    assert (tmp_path / "report.pdf").stat().st_size > 10_000
