"""What the index has newer of our dependencies than `tested.txt` says, a requirement a line; nothing where nothing is.

python .ci/newer.py WHEEL      by an interpreter that has pip
"""

import json
import subprocess
import sys
from pathlib import Path

TESTED = Path(__file__).with_name("tested.txt").read_text(encoding="utf-8").lower().splitlines()
PIP = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--dry-run"]

wanted = subprocess.run(
    [*PIP, "--ignore-installed", "--report", "-", *sys.argv[1:]], capture_output=True, text=True, check=True
)
for entry in json.loads(wanted.stdout)["install"]:
    name, version = entry["metadata"]["name"].lower(), entry["metadata"]["version"]
    if name != "symscrew" and f"{name.replace('-', '_')}=={version}" not in [line.replace("-", "_") for line in TESTED]:
        print(f"{name}=={version}")
