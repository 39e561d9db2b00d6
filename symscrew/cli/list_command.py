"""`symscrew list`: the mechanisms of the catalogue, with their sizes."""

from __future__ import annotations

import argparse
import json

from symscrew.cli.help import DONE

EXAMPLES = ("symscrew list", "symscrew list --json | jq -r '.[].name'")


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew list`."""
    command.add_argument("--json", action="store_true", help="as JSON")


def run(options: argparse.Namespace) -> int:
    """Read all, print."""
    from symscrew import catalogue
    from symscrew.display import print_table

    found = [catalogue.load(name) for name in catalogue.names()]
    rows = [
        {
            "name": m.name,
            "bodies": len(m.bodies) - (m.ground in m.bodies),
            "joints": len(m.joints),
            "driven": sum(len(j.driven) for j in m.joints.values()),
            "description": m.description,
            "source": m.source,
        }
        for m in found
    ]
    if options.json:
        print(json.dumps(rows, indent=1, ensure_ascii=False))
    else:
        header = ("name", "bodies", "joints", "driven", "description")
        print_table(header, [[str(row[key]) for key in header] for row in rows])
    return DONE
