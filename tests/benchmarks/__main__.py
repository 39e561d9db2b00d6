"""`python -m tests.benchmarks NAME [--out DIR] [--repeats N]` from the repository's root."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from symscrew.studies.benchmark.pinocchio_build import CPP_FLAGS
from symscrew.studies.this_machine import machine

from . import (
    arrays,
    attacks,
    controllers,
    derivatives,
    forward_dynamics,
    generation,
    growth,
    invented,
    inverse_dynamics,
    jax_modules,
    kernels,
    lean,
    lean_instructions,
    many_steps,
    mjx,
    mobility,
    optimisation,
    reposed,
    rust_beside_c,
    simulation,
    size_of_c,
    starts,
    work_precision,
)
from .tables import table

BENCHMARKS = {
    "inverse_dynamics": (inverse_dynamics.run, 25),
    "forward_dynamics": (forward_dynamics.run, 25),
    "derivatives": (derivatives.run, 25),
    "growth": (growth.run, 3),
    "lean": (lean.run, 50),
    "lean_instructions": (lean_instructions.run, 1),
    "size_of_c": (size_of_c.run, 3),
    "arrays": (arrays.run, 25),
    "simulation": (simulation.run, 25),
    "work_precision": (work_precision.run, 5),
    "generation": (generation.run, 5),
    "optimisation": (optimisation.run, 3),
    "mobility": (mobility.run, 1),
    "invented": (invented.run, 1),
    "starts": (starts.run, 30),
    "reposed": (reposed.run, 1),
    "attacks": (attacks.run, 1),
    "jax": (jax_modules.run, 5),
    "kernels": (kernels.run, 5),
    "steps": (many_steps.run, 3),
    "mjx": (mjx.run, 5),
    "controllers": (controllers.run, 1),
    "rust": (rust_beside_c.run, 7),
}


def main() -> None:
    """Run a benchmark, print Markdown, write raw JSON on request."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__)
    parser.add_argument("name", choices=[*BENCHMARKS, "all"])
    parser.add_argument("--out", type=Path, help="folder for raw numbers, NAME.json each")
    parser.add_argument("--repeats", type=int, help="repeats of every measurement")
    parser.add_argument("--seed", type=int, help="reposed: pose all mechanisms anew, from this seed on")
    arguments = parser.parse_args()
    if arguments.seed is not None and arguments.name != "reposed":
        parser.error("--seed is an option of reposed")
    options = {} if arguments.seed is None else {"seed": arguments.seed}
    facts = {**machine("pin"), "C++ flags": " ".join(CPP_FLAGS)}
    print(table(["machine", ""], list(facts.items())))
    for name in BENCHMARKS if arguments.name == "all" else [arguments.name]:
        run, repeats = BENCHMARKS[name]
        text, raw = run(repeats=arguments.repeats or repeats, **options)
        print(f"\n## {name}\n\n{text}", flush=True)
        if arguments.out is not None:
            arguments.out.mkdir(parents=True, exist_ok=True)
            content = json.dumps({"machine": facts, **raw}, indent=1)
            (arguments.out / f"{name}.json").write_text(content + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
