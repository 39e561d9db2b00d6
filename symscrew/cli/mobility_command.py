"""`symscrew mobility`: constraints and freedoms, verified by another route, as text, JSON or a document."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symscrew.cli.help import DONE, FAILED, UsageError
from symscrew.cli.shared_options import (
    add_mechanism,
    add_no_cache,
    check_expected,
    check_folder,
    find_mechanism,
    settings,
)
from symscrew.errors import shorten
from symscrew.garbage import nothing_to_collect
from symscrew.whole_files import destination, write_text

if TYPE_CHECKING:
    from symscrew.cli.same_files import Outcome
    from symscrew.description import Mechanism
    from symscrew.mobility import AllowedTime, Connections, Mobility

EXAMPLES = (
    "symscrew mobility three_ups_upu_s",
    "symscrew mobility wrist.toml --at R=60cm tilt=10deg azimuth=45deg --out wrist.html",
    "symscrew mobility bennett.toml --tolerance 1e-6",
    "symscrew mobility wrist.toml --expect 2 && echo as designed",
    "symscrew mobility wrist.toml --proof wrist.json && python -m symscrew.mobility.proofs.proof_checker wrist.json",
)


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew mobility`."""
    add_mechanism(command)
    command.add_argument(
        "--at", nargs="+", default=[], metavar="KEY=VALUE",
        help="parameters and coordinates with units (z=10mm tilt=30deg): joint, joint.i, joint.rx, and of a body, by "
        "default the platform, x, rx, roll, pitch, yaw, tilt, azimuth, torsion, turn='30deg about 1,1,0'; all others "
        "follow and are listed",
    )  # fmt: skip
    command.add_argument(
        "--tolerance", type=float, metavar="LENGTH",
        help="take special geometry within LENGTH [m] of the numbers typed as meant",
    )  # fmt: skip
    command.add_argument("--body", metavar="NAME", help="whose freedoms; default: the platform")
    command.add_argument(
        "--along", action="store_true",
        help="also what holds along the motion, and the singular poses on the coordinate lines (seconds)",
    )  # fmt: skip
    command.add_argument(
        "--components", action="store_true",
        help="also the operation modes: components of the configuration space, exact by Singular, or numerical",
    )  # fmt: skip
    command.add_argument(
        "--seconds", type=float, default=SECONDS, metavar="N",
        help=f"of the processor that --components may take; what was found by then is said (default {SECONDS:g})",
    )  # fmt: skip
    command.add_argument(
        "--connections", action="store_true",
        help="also the assembly modes at the drives of the reference, and paths between them without a singularity",
    )  # fmt: skip
    command.add_argument("--expect", type=int, metavar="N", help="exit 1 unless the finite mobility is N, verified")
    command.add_argument("--full", action="store_true", help="all of a long text; without it, it is cut to 5 kB")
    command.add_argument("--json", action="store_true", help="as JSON")
    command.add_argument("--out", metavar="FILE", help="write the report: .md, .html or .tex")
    command.add_argument(
        "--proof", metavar="FILE", help="write what is proved with its evidence, as JSON that a checker judges alone"
    )
    add_no_cache(command)


NO_FORMS = "operation modes not told apart: where a screw joint moves, no polynomials in Study's parameters need vanish"
"""Random poses of one smooth curve showed another number of quadrics from each start, and counted as several modes."""
SECONDS = 75.0
"""Of the processor, for components: of 70 mechanisms of the literature none took more when stages had times of their
own."""
ALGEBRA, NUMBERS = 1 / 5, 4 / 15
"""Parts of this time for exact algebra and for the numerical decomposition; what is left is for given coordinates."""
KEPT = 2 / 15
"""Part of it that is left for configurations with zero parameters."""
SHORTLY = 1 / 15
"""Part of it for both where modes are known: wholes that are decomposed at all then take a second or two."""
Parts = tuple[list[str], dict[str, Any]]
"""Components in words and as JSON values."""
ASKED = ("tolerance", "body", "along", "connections", "expect", "full", "json")
"""Options that what is said depends on, beside mechanism, configuration and the report's form."""


def run(options: argparse.Namespace) -> int:
    """Analyse, print, write; 1 when a claim is not verified. What was found before of the same is in the cache."""
    _one_thread()
    from symscrew.cli.kept_outcomes import once
    from symscrew.display import print_text
    from symscrew.kinematics import angle_notices
    from symscrew.mobility import mobility_latex, mobility_markdown, mobility_page

    writers = {".md": mobility_markdown, ".html": mobility_page, ".tex": mobility_latex}
    suffix = Path(options.out).suffix if options.out else None
    if suffix is not None and suffix not in writers:
        raise UsageError(f"--out: expected a file name in {', '.join(writers)}, got {shorten(options.out)}")
    for file, option in ((options.out, "--out"), (options.proof, "--proof")):
        if file:
            check_folder(Path(file).parent, option)
    check_expected(options)
    if not options.seconds > 0:
        raise UsageError(f"--seconds: expected seconds above 0, got {options.seconds:g}")
    if options.proof:
        destination(options.proof, (".json",), "--proof")
    mechanism = find_mechanism(options.mechanism)
    at = settings("at", options.at)
    for notice in angle_notices(mechanism, at):
        print(f"note: {notice}", file=sys.stderr)
    given = (mechanism, at, suffix, {name: getattr(options, name) for name in ASKED})
    # A proof is made and judged each time; components are found by a program that may be there or not.
    anew = options.proof or options.components
    writer = writers[suffix] if suffix is not None else None

    def made() -> Outcome:
        with nothing_to_collect():
            return _made(options, mechanism, at, writer)

    found = made() if anew else once("mobility", given, made)
    if options.json:
        print(found.facts["text"])
    else:
        print_text(found.facts["text"])
    if options.out:
        _write(Path(options.out), found.files["report"].decode())
    return int(found.facts["code"])


def _one_thread() -> None:
    """Linear algebra on one thread, unless the user says otherwise; NumPy reads it when it is first imported.

    Matrices here have a hundred rows: threads that wait for each other take more of all cores than they bring.
    """
    for name in ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"):
        os.environ.setdefault(name, "1")


def _made(
    options: argparse.Namespace,
    mechanism: Mechanism,
    at: Mapping[str, str],
    writer: Callable[[Mobility], str] | None,
) -> Outcome:
    """Analysed and verified: what is said, the exit code and the report."""
    from symscrew.cli.same_files import Outcome
    from symscrew.mobility import (
        AllowedTime,
        analyse_mobility,
        judged_connections,
        verified,
        with_rechecked_parts,
    )

    found, checks = verified(analyse_mobility(mechanism, body=options.body, at=at, tolerance=options.tolerance))
    failed = [check.claim for check in checks if not check.holds]
    allowed = AllowedTime(options.seconds)
    if options.components:
        found = with_rechecked_parts(found)
    ways = judged_connections(found) if options.connections else None
    proved = not options.proof or _proved(found, Path(options.proof), ways)
    parts: Parts | None = None
    if options.components:
        found, parts = _components(found, allowed)
    more = _more(found, options, parts, ways)
    text = _json(found, failed, options, more) if options.json else _words(found, failed, options, more)
    files = {} if writer is None else {"report": writer(found).encode()}
    unexpected = options.expect is not None and found.finite.dof != options.expect
    code = FAILED if failed or unexpected or not proved else DONE
    return Outcome({"text": text, "code": code}, files, good=not failed)


def _more(
    found: Mobility, options: argparse.Namespace, parts: Parts | None, ways: Connections | str | None
) -> dict[str, tuple[str, Parts]]:
    """What was asked for beside the verdict: key in the JSON -> (title, words and values)."""
    from symscrew.mobility import connection_lines, connection_values

    more = dict[str, tuple[str, Parts]]()
    if options.along:
        more["along"] = ("Along the motion", (_along_lines(found), _along_values(found)))
    if parts is not None:
        more["components"] = ("Components of the configuration space", parts)
    if ways is not None:
        more["assembly_modes"] = ("Assembly modes", (connection_lines(ways), connection_values(ways)))
    return more


def _json(
    found: Mobility, failed: list[str], options: argparse.Namespace, more: Mapping[str, tuple[str, Parts]]
) -> str:
    from symscrew.mobility import mobility_values

    values = {**mobility_values(found), "verified": not failed, "expected": options.expect}
    return json.dumps({**values, **{key: parts[1] for key, (_, parts) in more.items()}}, indent=1)


def _words(
    found: Mobility, failed: list[str], options: argparse.Namespace, more: Mapping[str, tuple[str, Parts]]
) -> str:
    from symscrew.mobility import mobility_text

    lines = [found.report().splitlines()[0], mobility_text(found, full=options.full)]  # the rest follows in more words
    lines += ["\n    ".join([title, *parts[0]]) for title, parts in more.values()]
    return "\n".join([*lines, _verdict(found, options.expect, failed)])


def _components(found: Mobility, allowed: AllowedTime) -> tuple[Mobility, Parts]:
    """(the result with what components prove of its branches, the components in words and as JSON values).

    Four-bars have a way of their own, which needs no program. Modes with parallel axes are soon found: where they are
    known the whole, which rarely ends then, is tried for a shorter time. What exact algebra does not divide is
    decomposed numerically.
    """
    from symscrew.mobility import (
        component_lines,
        component_values,
        components_of,
        configuration_space,
        judged_modes,
        mode_lines,
        mode_values,
        numerical_components,
        numerical_lines,
        numerical_values,
        pose_lines,
        pose_modes,
        pose_values,
        sampled_modes,
        space_lines,
        space_values,
        with_components,
        with_zero_parameters,
        zero_lines,
        zero_values,
    )

    curves = components_of(found.mechanism, found.network)
    if not isinstance(curves, str):
        return found, (component_lines(curves), component_values(curves))
    several, known = len(found.network.chords) > 1, "not decided: one loop"
    whole = allowed.seconds
    modes = pose_modes(found.mechanism, found.network, allowed.at_most(whole / 6)) if several else known
    algebra, numbers = (ALGEBRA, NUMBERS) if isinstance(modes, str) else (SHORTLY, SHORTLY)
    space = configuration_space(found.mechanism, found.network, allowed.at_most(algebra * whole))
    if not found.network.chords:
        return found, ([str(space)], {"decided": False, "why": str(space)})
    if not isinstance(space, str) and space.proved:
        return with_components(found, space), (space_lines(space), space_values(space))
    sets = () if isinstance(modes, str) else (*(mode.part for mode in modes.modes), *modes.unseen)
    first = allowed.at_most(numbers * whole)
    over = max(0.0, allowed.left - first - KEPT * whole)
    numerical = numerical_components(
        found.mechanism, found.network, first, over=over, beside=sets
    )  # fmt: skip
    divided = [numerical] if isinstance(numerical, str) else numerical_lines(numerical)
    counted = numerical if isinstance(numerical, str) else numerical_values(numerical)
    if not isinstance(space, str):
        parts = [*space_lines(space), *divided], {**space_values(space), "numerical": counted}
        return with_components(found, space), parts
    if allowed.over():
        divided.append(f"the {whole:g} s of the processor are over; --seconds gives more")
    lines, values = [space, *divided], {"decided": False, "why": space, "numerical": counted}
    if isinstance(modes, str) and not several and not allowed.over():
        modes = pose_modes(found.mechanism, found.network, allowed.at_most(whole / 6))
    if not isinstance(modes, str):
        modes = replace(modes, others=judged_modes(found, modes.others)) if found.in_reference else modes
        return found, ([*lines, *pose_lines(modes)], {**values, "pose_modes": pose_values(modes)})
    if any(motion.helical for edge in found.network.edges.values() for motion, _ in edge.motions):
        return found, ([*lines, NO_FORMS], {**values, "operation_modes": {"decided": False, "why": NO_FORMS}})
    seen = sampled_modes(found.network, found.platform.body)
    seen = judged_modes(found, seen) if found.in_reference else seen
    held = with_zero_parameters(found.mechanism, found.network, seen, allowed.at_most(algebra * whole))
    lines = [*lines, *mode_lines(seen), *zero_lines(held)]
    return found, (lines, {**values, "operation_modes": mode_values(seen), "zero_parameters": zero_values(held)})


def _along_lines(found: Mobility) -> list[str]:
    from symscrew.mobility import motion_lines

    if isinstance(found.along, str):
        return [found.along]
    return motion_lines(found.along, found.network, found.mechanism, found.platform.body)


def _along_values(found: Mobility) -> dict[str, Any]:
    from symscrew.mobility import motion_values

    if isinstance(found.along, str):
        return {"reason": found.along}
    return motion_values(found.along, found.network, found.mechanism)


def _proved(found: Mobility, path: Path, ways: Connections | str | None) -> bool:
    """Writes the proof file and says on stderr what it proves; whether its checker takes every claim."""
    from symscrew.mobility import write_proof

    try:
        verdict = write_proof(found, path, None if ways is None or isinstance(ways, str) else ways.evidence.entry)
    except OSError as error:
        raise UsageError(f"--proof {shorten(str(path))}: cannot be written ({error.strerror})") from error
    counts = (len(verdict.proved), len(verdict.refused), len(verdict.not_proved))
    head = "{}: {} claims proved, {} refused, {} not proved".format(path, *counts)
    print("\n".join([head, *(f"    refused: {text}" for text in verdict.refused)]), file=sys.stderr)
    return verdict.holds


def _write(path: Path, content: str) -> None:
    try:
        write_text(path, content)
    except OSError as error:
        raise UsageError(f"--out {shorten(str(path))}: cannot be written ({error.strerror})") from error


def _verdict(found: Mobility, expect: int | None, failed: list[str]) -> str:
    if failed:
        return f"NOT VERIFIED: {'; '.join(failed)}"
    judged = found.finite.judgement
    if found.taken is not None:
        judged += f" as meant within {found.taken.distance:.1e} m; as typed {found.taken.typed.finite.dof}"
    if found.near is not None:
        judged += f" as typed; mobility {found.near.meant.finite.dof} within {found.near.distance:.1e} m"
    if found.nearly_singular:
        judged += " as typed, almost singular"
    if expect is None:
        return f"verified by another route; finite mobility {judged}"
    if found.finite.dof == expect:
        return f"verified: finite mobility {expect}, {judged}"
    from symscrew.mobility import named_spins

    spins = len(named_spins(found.network))
    passive = f", of it {spins} passive spin{'s' * (spins > 1)} (a U for one of two S takes it away)" if spins else ""
    return f"NOT as expected: finite mobility {found.finite.dof}{passive}, expected {expect}"
