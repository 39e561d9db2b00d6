"""The machine that something was measured on: all that times depend on, as far as it can be asked."""

from __future__ import annotations

import os
import platform
import subprocess
from importlib import metadata
from pathlib import Path

from symscrew.runtime import FLAGS, find_compiler

ANSWER = 20  # seconds to say a version: an installed compiler takes some milliseconds
PACKAGES = ("symscrew", "sympy", "numpy", "scipy", "casadi", "matplotlib")


def machine(*packages: str) -> dict[str, str]:
    """Processor, system, compiler, flags and versions: those of the usual and of further packages."""
    compiler = find_compiler()
    facts = {
        "processor": _processor(),
        "system": platform.platform(terse=True) + " " + platform.machine(),
        "load": " ".join(f"{load:.2f}" for load in os.getloadavg()) if hasattr(os, "getloadavg") else "unknown",
        "compiler": _first_line([compiler, "--version"]) if compiler else "none: no curves of generated C",
        "flags": " ".join([*(f for f in FLAGS if f not in ("-shared", "-fPIC")), "-march=native"]),
        "python": platform.python_version(),
    }
    for package in (*PACKAGES, *packages):
        try:
            facts[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            facts[package] = "not installed"
    return facts


def _first_line(command: list[str]) -> str:
    try:
        answer = subprocess.run(
            command, capture_output=True, encoding="utf-8", errors="replace", check=True, timeout=ANSWER
        )
    except (OSError, subprocess.SubprocessError):
        return "unknown"
    return answer.stdout.splitlines()[0] if answer.stdout else "unknown"


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.is_file() else []
    fields = {key.strip(): value.strip() for key, _, value in (line.partition(":") for line in lines)}
    name = fields.get("model name") or platform.processor() or "unknown"
    if "cpu family" in fields:
        name += f", family {fields['cpu family']} model {fields['model']}, {fields.get('cpu MHz', '?')} MHz"
    return f"{name}, {os.cpu_count()} cores; one thread used"
