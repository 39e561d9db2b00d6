"""What a wheel ships against its bill of materials: nothing of others is in it that the bill does not name.

python .ci/bill.py WHEEL
"""

import hashlib
import json
import sys
import zipfile

OURS = (
    ".py",
    ".toml",
    ".h",
    ".hpp",
    ".c",
    ".cpp",
    ".rs",
    ".css",
    ".html",
    ".js",
    ".json",
    ".typed",
    ".ld",
    ".s",
    ".S",
    ".md",
    ".txt",
)

with zipfile.ZipFile(sys.argv[1]) as wheel:
    names = [name for name in wheel.namelist() if ".dist-info/" not in name and not name.endswith("/")]
    bill = json.loads(wheel.read("symscrew/sbom.cdx.json"))
    files = {p["value"]: c for c in bill["components"] for p in c.get("properties", ()) if p["name"] == "symscrew:file"}
    for file, component in files.items():
        (digest,) = (entry["content"] for entry in component["hashes"] if entry["alg"] == "SHA-256")
        assert hashlib.sha256(wheel.read(file)).hexdigest() == digest, f"{file} is not what the bill names"
    others = [name for name in names if ".min." in name or "/assets/" in name]
    assert set(files) <= set(others)
    assert all(name in files or name.endswith(("LICENSE", "README.md", "entry.js")) for name in others)
    assert any(name.endswith("assets/LICENSE") for name in names)
    strange = [name for name in names if name not in others and not name.endswith(OURS)]
    assert not strange, f"what are these? {strange}"
print(f"{len(names)} files, {len(files)} of others: {', '.join(files)}")
