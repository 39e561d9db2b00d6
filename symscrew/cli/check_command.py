"""`symscrew check`: whether folders of generated code are what the tool would write today, and agree by number.

Of a certificate of `symscrew workspace --certify`: whether it is a proof of the mechanism that it names.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import add_no_cache
from symscrew.whole_files import only_file

EXAMPLES = (
    "symscrew check seed",
    "symscrew check generated/",
    "symscrew check proof/certificate.json --mechanism three_ups_upu_s",
)
LARGEST = 1_000_000_000  # bytes of a certificate: that of 200,000 boxes of a mechanism of 30 joints has 100 MB


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew check`."""
    command.add_argument(
        "directory", metavar="DIR|FILE", help="generated output, or a directory of such; a certificate"
    )
    text = "that a certificate has to be of: a catalogue name or a file"
    command.add_argument("--mechanism", metavar="NAME|FILE", help=text)
    command.add_argument("--json", action="store_true", help="as JSON")
    add_no_cache(command)


def run(options: argparse.Namespace) -> int:
    """Check, print; 1 where a check failed."""
    from symscrew.display import Progress, print_text
    from symscrew.verification import check

    if Path(options.directory).is_file():
        return _run_certificate(options)
    if options.mechanism:
        raise UsageError(f"--mechanism is for a certificate, a file; {options.directory} is none")
    progress = Progress()
    with progress.step(f"check {options.directory}"):
        result = check(options.directory)
    if options.json:
        told = {"ok": result.ok, "verdict": result.verdict, "skipped": result.skipped, "lines": result.lines}
        print(json.dumps(told, indent=1, ensure_ascii=False))
    else:
        print_text("\n".join([*result.lines, result.verdict]))
    return DONE if result.ok else FAILED


def _run_certificate(options: argparse.Namespace) -> int:
    """Whose proof a certificate is; 1 where it is not one of the mechanism that it names."""
    from symscrew import catalogue
    from symscrew.studies.certificate import UnreadableError, proof_of_mechanism

    values = _read(Path(options.directory))
    mechanism = catalogue.find(options.mechanism) if options.mechanism else None
    try:
        found = proof_of_mechanism(values, mechanism)
    except UnreadableError as error:
        raise UsageError(f"{options.directory}: not a certificate that can be read: {error}") from error
    if options.json:
        told = {
            "ok": found.ok, "mechanism": found.mechanism, "description": found.digest,
            "proved": list(found.verdict.proved), "refused": [*found.refused, *found.verdict.refused],
            "assumed": list(found.left),
        }  # fmt: skip
        print(json.dumps(told, indent=1, ensure_ascii=False))
    else:
        print(found)
    return DONE if found.ok else FAILED


def _read(file: Path) -> Any:
    from symscrew.studies.certificate import UnreadableError, is_certificate, values_of

    what = "expected a folder of generated code, or a certificate of `symscrew workspace --certify`"
    if only_file(file).stat().st_size > LARGEST:
        raise UsageError(f"{file}: {what}, got a file of {file.stat().st_size} bytes")
    try:
        values = values_of(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError, UnreadableError) as error:
        raise UsageError(f"{file}: {what}; it is no JSON that can be read: {error}") from error
    if not is_certificate(values):
        raise UsageError(f"{file}: {what}, got other JSON")
    return values
