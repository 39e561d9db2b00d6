"""What `symscrew mobility` does."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from symscrew.errors import DescriptionError, shorten
from symscrew.mobility import (
    Mobility,
    analyse_mobility,
    mobility_latex,
    mobility_markdown,
    mobility_page,
    mobility_text,
    mobility_values,
    verify,
)
from symscrew.whole_files import write_text

FORMATS = {".md": mobility_markdown, ".html": mobility_page, ".tex": mobility_latex}


def run(options: argparse.Namespace) -> int:
    """Analyse, print, write; 1 when a claim is not verified."""
    from symscrew import catalogue

    writer = None
    if options.out:
        writer = FORMATS.get(Path(options.out).suffix)
        if writer is None:
            raise DescriptionError(f"--out: expected a file name in {', '.join(FORMATS)}, got {shorten(options.out)}")
    mechanism = catalogue.find(options.mechanism)
    found = analyse_mobility(mechanism, body=options.body, at=dict(_setting(text) for text in options.at))
    failed = [check.claim for check in verify(found) if not check.holds]
    verdict = _verdict(found, options.expect, failed)
    if options.json:
        values = {**mobility_values(found), "verified": not failed, "expected": options.expect}
        print(json.dumps(values, indent=1))
    else:
        print(found.report().splitlines()[0])  # the rest of it follows in more words
        print(mobility_text(found))
        print(verdict)
    if writer is not None:
        _write(Path(options.out), writer(found))
    return 1 if failed or (options.expect is not None and found.finite.dof != options.expect) else 0


def _write(path: Path, content: str) -> None:
    try:
        write_text(path, content)
    except OSError as error:
        raise DescriptionError(f"--out {shorten(str(path))}: cannot be written ({error.strerror})") from error


def _setting(text: str) -> tuple[str, str]:
    name, mark, value = text.partition("=")
    if not mark or not name or not value:
        raise DescriptionError(f"--at: expected KEY=VALUE, got {shorten(text)}")
    return name.strip(), value.strip()


def _verdict(found: Mobility, expect: int | None, failed: list[str]) -> str:
    if failed:
        return f"NOT VERIFIED: {'; '.join(failed)}"
    if expect is None:
        return "verified by another route"
    if found.finite.dof == expect:
        return f"verified: finite mobility {expect}"
    return f"NOT as expected: finite mobility {found.finite.dof}, expected {expect}"
