"""What is shipped and needed stands in three places that must agree: pyproject.toml, the tested versions, the bill."""

from __future__ import annotations

import hashlib
import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import symscrew

ROOT = Path(__file__).parents[2]
PACKAGE = Path(symscrew.__file__).parent
ASSETS = PACKAGE / "display" / "view" / "assets"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
BOUND = re.compile(r"([\w-]+)>=([\d.]+),<(\d+)")
BOUNDS = {m[1]: (m[2], m[3]) for m in map(BOUND.fullmatch, PROJECT["dependencies"]) if m}
BILL: dict[str, Any] = json.loads((PACKAGE / "sbom.cdx.json").read_text(encoding="utf-8"))


def numbers(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in re.findall(r"\d+", version)[:3])


def test_every_dependency_has_both_bounds_and_a_tested_version_within() -> None:
    assert len(BOUNDS) == len(PROJECT["dependencies"])
    lines = (ROOT / ".ci" / "tested.txt").read_text(encoding="utf-8").splitlines()
    tested = dict(line.split("==") for line in lines if not line.startswith("#"))
    for name, (oldest, next_major) in BOUNDS.items():
        assert numbers(oldest) <= numbers(tested[name]) < (int(next_major),), name
    for extra in ("test", "lint"):
        named = {re.split(r"[<>=\[]", entry)[0].lower() for entry in PROJECT["optional-dependencies"][extra]}
        assert named <= {name.lower() for name in tested}


def test_the_oldest_versions_are_those_of_the_bounds() -> None:
    done = subprocess.run([sys.executable, ROOT / ".ci" / "oldest.py"], capture_output=True, text=True, check=True)
    assert done.stdout.split() == [f"{name}=={oldest}" for name, (oldest, _) in BOUNDS.items()]


def test_the_bill_names_the_package_and_what_it_needs() -> None:
    assert BILL["bomFormat"] == "CycloneDX" and BILL["specVersion"] == "1.5"
    assert BILL["metadata"]["component"]["version"] == symscrew.__version__ == PROJECT["version"]
    needed = {c["name"]: c for c in BILL["components"] if c.get("scope") == "required"}
    assert needed.keys() == BOUNDS.keys()
    for name, (oldest, next_major) in BOUNDS.items():
        assert needed[name]["properties"] == [{"name": "symscrew:versions", "value": f">={oldest},<{next_major}"}]


def test_the_bill_names_what_others_wrote_with_licence_and_version() -> None:
    shipped = {p["value"]: c for c in BILL["components"] for p in c["properties"] if p["name"] == "symscrew:file"}
    assert shipped.keys() == {f"symscrew/{path.relative_to(PACKAGE)}" for path in PACKAGE.rglob("*.min.*")}
    (library,) = shipped.values()
    digest = hashlib.sha256((ASSETS / "library.min.js").read_bytes()).hexdigest()
    assert library["hashes"] == [{"alg": "SHA-256", "content": digest}]
    licences = re.findall(r"(?m)^([a-z][a-z-]+) (\d+\.\d+\.\d+)$", (ASSETS / "LICENSE").read_text(encoding="utf-8"))
    assert [(c["name"], c["version"]) for c in library["components"]] == licences and len(licences) == 6
    assert all(c["licenses"] == [{"license": {"id": "MIT"}}] for c in (library, *library["components"]))
    known = {BILL["metadata"]["component"]["bom-ref"]}
    known |= {c["bom-ref"] for part in BILL["components"] for c in (part, *part.get("components", ()))}
    assert {ref for d in BILL["dependencies"] for ref in (d["ref"], *d["dependsOn"])} <= known
