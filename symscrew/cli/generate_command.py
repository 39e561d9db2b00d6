"""`symscrew generate`: a folder of code of a mechanism and its effects.

mechanism, effects --derive--> model --only the chosen functions--> generate --> folder
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from symscrew.cli.help import DONE, UsageError
from symscrew.cli.shared_options import (
    add_effects,
    add_independent,
    add_mechanism,
    add_no_cache,
    check_folder,
    chosen_effects,
    find_mechanism,
)
from symscrew.errors import DescriptionError
from symscrew.garbage import nothing_to_collect
from symscrew.generation import TARGETS, USUAL, apart, printable, with_brought

if TYPE_CHECKING:
    from symscrew.cli.same_files import Outcome
    from symscrew.description import Mechanism
    from symscrew.display import Progress
    from symscrew.effects import Effect
    from symscrew.model import Model

EXAMPLES = (
    "symscrew generate three_ups_upu_s --out seed",
    "symscrew generate wrist.toml --out wrist --target c --derivatives",
    "symscrew generate ur5 --out ur5_single --precision single",
    "symscrew generate delta --out small --profile microcontroller --functions inverse_dynamics",
    "symscrew generate delta --out controller --functions control",
)


PROFILES = ("microcontroller",)  # of options that go together


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of `symscrew generate`."""
    add_mechanism(command)
    command.add_argument("--out", metavar="DIR", required=True, help="a new, empty or earlier generated directory")
    text = "default: c casadi numpy; external: C for casadi.external, with derivatives; fmu: FMI 3.0, sources only"
    command.add_argument("--target", nargs="+", choices=TARGETS, help=text)
    command.add_argument("--precision", choices=("double", "single"), help="single: C of type float, Rust of f32")
    text = (
        "microcontroller: C of type float for one state at a time and one operation mode, no functions of many states"
    )
    command.add_argument("--profile", choices=PROFILES, help=text)
    command.add_argument("--one-file", action="store_true", help="the C in one source, not in several by families")
    command.add_argument(
        "--embedded", nargs="+", choices=("m4f", "m7"), default=[], metavar="CORE",
        help="measure the C on m4f or m7 in QEMU: flash, stack and instructions go into the header and ops.json",
    )  # fmt: skip
    add_effects(command)
    add_independent(command)
    command.add_argument("--length", metavar="METRES", help="characteristic length for norms of mixed quantities")
    command.add_argument("--derivatives", action="store_true", help="also derivatives and the linearisation")
    text = "also Hessians of drives, accelerations, closure and margins, and their products with a direction"
    command.add_argument("--second-derivatives", action="store_true", help=text)
    command.add_argument("--regressor", action="store_true", help="also regressors of the inertial parameters")
    text = "code for the operation mode of the reference configuration only, where coordinates may follow from others"
    command.add_argument("--one-mode", action="store_true", help=text)
    text = "also NAME_checked of every function NAME of q, v or a: fails where these do not close the loops"
    command.add_argument("--checked", action="store_true", help=text)
    text = "write header, counts, manifest and description, of all other files the hashes: enough for symscrew check"
    command.add_argument("--hashes-only", action="store_true", help=text)
    text = (
        "these functions only, or those of kinematics, control, all (the default; README.md of the output has tables)"
    )
    command.add_argument("--functions", nargs="+", metavar="NAME", help=text)
    add_no_cache(command)


def profiled(options: argparse.Namespace) -> argparse.Namespace:
    """The options that a profile stands for put in; those that are given against it are an error."""
    chosen = argparse.Namespace(**vars(options))
    if chosen.profile:
        if chosen.precision == "double":
            raise UsageError(f"--profile {chosen.profile} is of single precision; leave out --precision double")
        chosen.precision, chosen.one_mode = "single", True
    chosen.precision = chosen.precision or "double"
    return chosen


@nothing_to_collect()  # of modules that are imported here neither
def run(options: argparse.Namespace) -> int:
    """Read, derive, measure, write, print; what was printed before of the same input is taken from the cache."""
    from symscrew.cli.kept_outcomes import once
    from symscrew.display import Progress, print_table, print_text
    from symscrew.generation import check_place, write_folder

    options = profiled(options)
    targets = chosen_targets(options)
    check_folder(options.out)
    check_place(options.out)
    progress = Progress()
    with progress.step(f"read {options.mechanism}"):
        mechanism = find_mechanism(options.mechanism, acting=not options.effects)
        effects = chosen_effects(options, mechanism)
    given = (mechanism, effects, targets, {name: getattr(options, name) for name in ASKED})
    key: Sequence[object] = (object(),) if options.embedded else given  # what is measured is measured each time
    made = once("generate", key, lambda: _made(options, mechanism, effects, targets=targets, progress=progress))
    with progress.step(f"write {', '.join(targets)} to {options.out}" + ", as in an earlier run" * made.earlier):
        files = write_folder(made.files, options.out)
    operations = made.facts["operations"]
    count = f"{len(operations)} function{'s' * (len(operations) != 1)}"
    print_text(f"{made.facts['name']}: {count}, {len(files)} files in {options.out}")
    print_table(("function", "operations"), [[name, str(count)] for name, count in operations.items()])
    if made.facts["presets"]:
        print_text(f"fewer of them: {made.facts['presets']}")
    for note in made.facts["notes"]:
        print_text(f"note: {note}")
    return DONE


ASKED = (
    "precision", "profile", "one_file", "independent", "length", "derivatives", "second_derivatives", "regressor",
    "one_mode", "checked", "hashes_only", "functions",
)  # fmt: skip
"""Options that what is written depends on, beside mechanism, effects and targets."""


def _made(
    options: argparse.Namespace,
    mechanism: Mechanism,
    effects: Sequence[Effect],
    *,
    targets: Sequence[str],
    progress: Progress,
) -> Outcome:
    """Derived, measured and printed."""
    from symscrew.cli.same_files import Outcome
    from symscrew.export import Form
    from symscrew.generation import render, with_hashes

    model = _chosen_functions(options, _derived(options, mechanism, effects, progress))
    measured = []
    for core in dict.fromkeys(options.embedded):
        from symscrew.verification import measure

        with progress.step(f"measure on {core}"):
            measured.append(measure(model, core, options.precision))
    form = Form(one_file=options.one_file, batches=options.profile is None)
    with progress.step(f"print {', '.join(targets)}"):
        files = render(
            model, targets, precision=options.precision, measured=measured, form=form, processes=os.cpu_count() or 1
        )
    facts = {
        "name": model.name,
        "operations": {name: p.operations["total"] for name, p in model.programs.items()},
        "presets": "" if model.selected else _presets(model),
        "notes": list(model.notes),
    }
    return Outcome(facts, with_hashes(files) if options.hashes_only else files)


def _presets(model: Model) -> str:
    """The selections by name, with what each takes."""
    from symscrew.functions import PRESETS, preset

    texts = []
    for name in PRESETS:
        functions = preset(name, model.programs)
        operations = sum(model.programs[f].operations["total"] for f in functions)
        texts.append(f"--functions {name} ({len(functions)} functions, {operations} operations)")
    return ", ".join(texts)


def chosen_targets(options: argparse.Namespace) -> list[str]:
    """The targets to write, in the order of the table; those that the other options exclude are an error."""
    single = options.precision == "single"
    targets = [t for t in TARGETS if t in (options.target or (["c"] if single else USUAL))]
    if options.embedded and "c" not in with_brought(targets):
        raise UsageError("--embedded measures C; add it to --target")
    if both := apart(targets):
        raise UsageError(f"--target: {both}")
    possible = printable(options.precision)
    doubles = [t for t in targets if t not in possible]
    if single and doubles:
        raise UsageError(f"--precision single: {doubles[0]} is double only; expected {' or '.join(possible)}")
    return targets


def _derived(options: argparse.Namespace, mechanism: Mechanism, effects: Sequence[Effect], progress: Progress) -> Model:
    """The model with the functions that the options ask for."""
    from symscrew.model import derive

    reduced = "reduced" in (options.target or ())  # which needs both
    with progress.step(f"derive {mechanism.name}"):
        return derive(
            mechanism,
            effects,
            independent=options.independent,
            length=options.length,
            derivatives=options.derivatives or reduced,
            second_derivatives=options.second_derivatives or reduced,
            regressor=options.regressor,
            one_mode=options.one_mode,
            checked=options.checked,
        )


def _chosen_functions(options: argparse.Namespace, model: Model) -> Model:
    """The model with the functions that the options name, by themselves or by presets, or all."""
    from symscrew.functions import ALL, selected

    if not options.functions:
        return model
    try:
        names = selected(options.functions, model.programs, model.name)
    except DescriptionError as error:
        raise UsageError(f"--functions: {error}") from error
    return model if ALL in options.functions else model.only(names)
