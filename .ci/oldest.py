"""The oldest versions that pyproject.toml allows, one requirement a line: what `pip install` of them must work with."""

import re
import tomllib
from pathlib import Path

project = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]
for entry in project["dependencies"]:
    name, oldest = re.fullmatch(r"([\w-]+)>=([\d.]+),<\d+", entry).groups()
    print(f"{name}=={oldest}")
