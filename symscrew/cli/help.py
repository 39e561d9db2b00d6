"""How the command line speaks: its parser, examples for every command, and what it says to bad options."""

from __future__ import annotations

import argparse
import sys
from typing import Any, NoReturn

from symscrew.errors import did_you_mean

FAILED = 1

OVER = (
    "an axis: an independent coordinate, a parameter, tilt (of the platform's z-axis) or azimuth (of the tilt's "
    "axis); numbers in m, mm, rad, deg"
)
LIMIT = (
    "what is allowed of a joint (limb1_P=-50mm:50mm), a drive at rest ('drive limb1_P=-500:500' [N, N m]), "
    "condition, margin or another result"
)
TOLERANCE = "a parameter with the standard deviation of its normal distribution"

EXAMPLES = {
    "list": ("symscrew list", "symscrew list --json | jq -r '.[].name'"),
    "demo": ("symscrew demo", "symscrew demo --out figures"),
    "new": (
        "symscrew new wrist --limbs 3-UPS+UPU+S",
        "symscrew new arm --limbs RRRRRR",
        "symscrew new table --limbs 3-RRR",
    ),
    "generate": (
        "symscrew generate three_ups_upu_s --out seed",
        "symscrew generate wrist.toml --out wrist --target c --derivatives",
        "symscrew generate ur5 --out ur5_single --precision single",
    ),
    "benchmark": (
        "symscrew benchmark ur5 --against pinocchio mujoco --plot times.png",
        "symscrew benchmark three_ups_upu_s --function inverse_dynamics --throughput",
    ),
    "embedded": ("symscrew embedded three_ups_upu_s --core m4f --out embedded.json",),
    "check": ("symscrew check seed", "symscrew check generated/"),
    "mobility": (
        "symscrew mobility three_ups_upu_s",
        "symscrew mobility wrist.toml --at R=0.6 --out wrist.html",
        "symscrew mobility wrist.toml --expect 2 && echo as designed",
    ),
    "cost": ("symscrew cost examples/scenes/falling_platform.toml", "symscrew cost scene.toml --plot bill.png"),
    "convert": ("symscrew convert robot.urdf --out robot.toml", "symscrew convert ur5 --out ur5.xml"),
    "simulate": (
        "symscrew simulate examples/scenes/falling_platform.toml --out run.npz --plot run.png",
        "symscrew simulate scene.toml --emit-c loop",
    ),
    "fmu": (
        "symscrew fmu examples/scenes/hanging_platform.toml --out platform.fmu",
        "symscrew fmu ur5 --out ur5.fmu --fmi 2",
    ),
    "accuracy": (
        "symscrew accuracy three_ups_upu_s --study precision --out study",
        "symscrew accuracy examples/benchmarks --out problems",
        "symscrew accuracy examples/benchmarks/n_four_bar.toml --study growth --out growth",
    ),
    "optimise": ("symscrew optimise examples/optimisation/seed_rest_to_rest.toml --out motion.npz --plot motion.png",),
    "draw": ("symscrew draw three_ups_upu_s --out seed.png",),
    "view": ("symscrew view three_ups_upu_s", "symscrew view run.npz --out run.html"),
    "report": (
        "symscrew report three_ups_upu_s --out seed.html",
        "symscrew report wrist.toml --out wrist.md --scene scene.toml --accuracy study",
    ),
    "workspace": (
        "symscrew workspace three_ups_upu_s --over tilt=0:20deg:21 azimuth=0:360deg:73 --expect-tilt 10deg --out seed",
        "symscrew workspace ur5 --over elbow=-150deg:150deg:121 --out elbow.csv",
        "symscrew workspace wrist.toml --over R=0.4:0.6:21 --tolerance r=1mm --samples 1000 --out study",
    ),
    "doctor": ("symscrew doctor", "symscrew doctor --json"),
}
"""Command lines that show what a command is for; shown below its options."""


class UsageError(ValueError):
    """Bad input that the command line itself finds."""


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line on stderr and exit code 2, with the nearest names of commands and choices."""

    def error(self, message: str) -> NoReturn:
        """End with the message."""
        raise UsageError(
            f"{message.removesuffix('?')}{'? See' if message.endswith('?') else '; see'} {self.prog} --help"
        )

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """As usual, but an option that does not exist is the first thing said, with the nearest that do."""
        for word in sys.argv[1:] if args is None else args:
            option = word.partition("=")[0]
            if word == "--" or (self._subparsers is not None and not word.startswith("-")):
                break
            known = self._option_string_actions
            if option.startswith("--") and not any(name.startswith(option) for name in known):
                self.error(
                    f"unknown option {option[:60]!r}; {did_you_mean(option, [n for n in known if n[:2] == '--'])}"
                )
        return super().parse_known_args(args, namespace)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            what = "/".join(action.option_strings) or action.metavar or action.dest
            near = did_you_mean(str(value), [str(c) for c in action.choices])
            raise argparse.ArgumentError(None, f"{what}: unknown {str(value)[:60]!r}; {near}")

    def add_examples(self, name: str) -> None:
        """Show the examples of a command below its help."""
        self.formatter_class = argparse.RawDescriptionHelpFormatter
        if name in EXAMPLES:
            self.epilog = "examples:\n" + "\n".join(f"  {line}" for line in EXAMPLES[name])


def complete(parser: argparse.ArgumentParser) -> None:
    """Answer the shell's question for completions, if argcomplete is installed."""
    try:
        import argcomplete
    except ImportError:
        return
    argcomplete.autocomplete(parser)
