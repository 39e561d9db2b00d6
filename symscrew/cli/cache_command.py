"""`symscrew cache`: what is kept between runs, where, and how much; or nothing any more."""

from __future__ import annotations

import argparse
import json

from symscrew.cli.help import DONE

EXAMPLES = ("symscrew cache", "symscrew cache --clear", "symscrew cache --json")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew cache`."""
    command.add_argument("--clear", action="store_true", help="remove all entries")
    command.add_argument("--json", action="store_true", help="as JSON")


def run(options: argparse.Namespace) -> int:
    """Clear on request, print."""
    from symscrew.runtime import cache_state, clear_cache

    before = clear_cache() if options.clear else cache_state()
    found = cache_state()
    removed = before.entries - found.entries
    if options.json:
        facts = {"path": str(found.path), "entries": found.entries, "bytes": found.size, "removed": removed}
        print(json.dumps({**facts, "unused_because": found.unused}, indent=1))
        return DONE
    if options.clear:
        print(f"removed {removed} entries, {(before.size - found.size) / 1e6:.1f} MB")
    print(f"{found.path}: {found.entries} entries, {found.size / 1e6:.1f} MB")
    if found.unused:
        print(f"not used: {found.unused}")
    return DONE
