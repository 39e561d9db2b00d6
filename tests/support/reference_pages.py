"""Pages of the reference that are made of the code: every kind of file with its keys, every effect with its own.

`PYTHONPATH=.:tests python -m support.reference_pages` writes them; a test compares.
"""

from __future__ import annotations

import dataclasses
import inspect
import re
from collections.abc import Mapping
from pathlib import Path

import symscrew
from support.effect_keys import COMMON, EFFECT_KEYS
from symscrew.description.toml_file import KEYS as MECHANISM_KEYS
from symscrew.description.toml_file import REQUIRED
from symscrew.effects import known_effects
from symscrew.scene.contents import Integrator
from symscrew.scene.scene_file import KEYS as SCENE_KEYS
from symscrew.studies.given_motion.wanted_motion import DEFAULT_RATE
from symscrew.studies.given_motion.wanted_motion import KEYS as MOTION_KEYS

DOCS = Path(__file__).parents[2] / "docs"
Meaning = tuple[str, str, str]  # unit, default, what it is


def effects_page() -> str:
    """A section per effect: what it is, its keys, an example."""
    lines = [
        "# Effects",
        "",
        "What acts on a mechanism, one file of the package each. An effect stands in a scene or in a file for",
        "`--effects` as a table `[[effects]]` with its `type`; in Python as `symscrew.effects.Name(...)` with the same",
        "keys. Numbers may be texts with expressions of the parameters. This page is made of the code.",
        "",
    ]
    for name, kind in known_effects().items():
        words, example = _parts(inspect.getdoc(kind) or "")
        lines += [f"## {name}", "", words, ""]
        fields = dataclasses.fields(kind)
        if fields:
            lines += ["| key | unit | default | meaning |", "|---|---|---|---|", *(row(name, f) for f in fields)]
            lines.append("")
        if example:
            lines += ["```toml", example, "```", ""]
    return "\n".join([*lines, *API, ""])


API = (
    "## In Python",
    "",
    "::: symscrew.effects.effect.Effect",
    "::: symscrew.effects.acting.Acting",
    "::: symscrew.effects.registry",
    "    options: {members: [known_effects, load_effects]}",
)


def public_page() -> str:
    """Every name that `import symscrew` gives, by the path that users type, in the order of the package's own page."""
    text = (inspect.getdoc(symscrew) or "").partition("The names")[2].partition("The map:")[0]
    lines = [
        "# Public names",
        "",
        "What `import symscrew` gives, by the names that you type. Parts of the package that are named elsewhere in",
        "these pages by longer paths are for those who build on its inside; they may change. This page is made of the",
        "code.",
    ]
    for line in text.splitlines():
        if heading := re.fullmatch(r"  (to .*)", line):
            lines += [f"## {heading[1][0].upper()}{heading[1][1:]}", ""]
        elif (name := re.match(r"    (\w+)(?:\(.*?\))? {2,}\S", line)) and name[1] != "__version__":
            lines += [f"::: symscrew.{name[1]}"]
    return "\n".join([*lines, ""]).replace("\n##", "\n\n##")


def _parts(text: str) -> tuple[str, str]:
    """Words, with their formulas, and the example of a docstring."""
    found = re.search(r"\n\n((?:    .*\n?|\n)*    \[\[effects\]\]\n(?:    .*\n?|\n)*)", text + "\n")
    if found is None:
        return text, ""
    return (text + "\n").replace(found[1], "").strip(), inspect.cleandoc("\n" + found[1]).strip()


def _default(f: dataclasses.Field) -> str:
    if f.default is dataclasses.MISSING and f.default_factory is dataclasses.MISSING:
        return "needed"
    return "none" if f.default in (None, "", ()) else f"`{f.default!r}`"


def row(effect: str, f: dataclasses.Field) -> str:
    """A line of the table of an effect's keys."""
    unit, words = {**COMMON, **EFFECT_KEYS[effect]}[f.name]
    return f"| `{f.name}` | {unit} | {_default(f)} | {words} |"


INTEGRATOR = {f.name: f.default for f in dataclasses.fields(Integrator)}
MECHANISM: Mapping[str, Mapping[str, Meaning]] = {
    "mechanism": {
        "name": ("", "needed", "letters, digits, _; the prefix of generated functions"),
        "ground": ("", '"base"', "the body that does not move"),
        "platform": ("", "none", "the body whose motion is looked at"),
        "description": ("", "none", "a line of text"),
        "source": ("", "none", "where the numbers come from"),
        "characteristic_length": ("m", "of the geometry", "divides lengths where they meet angles"),
    },
    "parameters": {
        "value": ("its unit", "needed", "a number, or an expression of parameters above it"),
        "unit": ("", '"1"', "as it is shown"),
        "description": ("", "none", "as it is shown"),
        "run_time": ("", "false", "true: an input of every generated function instead of a number in it"),
    },
    "bodies": {
        "mass": ("kg", "none", "without it the body has no inertia"),
        "com": ("m", "none", "centre of mass in the reference configuration, absolute axes"),
        "inertia": ("kg m^2", "0", "about the centre of mass, absolute axes: three numbers, or a symmetric matrix"),
    },
    "joints": {
        "type": ("", "needed", "R, P, H, C, U, S, E, fixed or free"),
        "parent": ("", "needed", "the body that it is on; its coordinates count from there"),
        "child": ("", "needed", "the body that it carries"),
        "point": ("m", "needed", "its point in the reference configuration, absolute axes"),
        "axes": ("1", "as its type has", "unit vectors, or any that are divided by their length"),
        "pitch": ("m/rad", "needed for H", "how far it slides per radian"),
        "driven": ("", "false", "true, or the numbers of the driven freedoms from 0"),
        "reference": ("rad, m", "0", "values of its coordinates in the reference configuration"),
        "child_point": ("m", "`point`", "the child's point, where it is described apart from the parent's"),
        "child_axes": ("1", "`axes`", "the child's axes, likewise"),
    },
    "points": {
        "body": ("", "needed", "the body that it is fixed to"),
        "at": ("m", "needed", "its place in the reference configuration, absolute axes"),
    },
    "couplings": {"terms": ("", "needed", "coordinate -> factor, or the coefficients of its powers")},
    "limbs": {
        "type": ("", "letters or `joints`", 'joint types from base to tip, "UPS": joints and bodies are made of it'),
        "base": ("", "the ground", "the body that the limb begins on"),
        "tip": ("", "the platform", "the body that it ends on"),
        "points": ("m", "needed with type", "points of its joints, in order"),
        "axes": ("1", "as its type has", "axes of its joints, in order"),
        "joints": ("", "made of the type", "names of its joints, in order"),
        "bodies": ("", "made of its name", "names of its bodies, in order"),
        "driven": ("", "none", "which of its joints are driven"),
        "pitch": ("m/rad", "needed with H", "of its screw joints"),
        "reference": ("rad, m", "0", "of its joints' coordinates"),
        "mass": ("kg", "none", "of its bodies"),
        "com": ("m", "none", "of its bodies"),
        "inertia": ("kg m^2", "0", "of its bodies"),
        "tip_point": ("m", "the last point", "where it holds the tip"),
    },
}
SCENE: Mapping[str, Mapping[str, Meaning]] = {
    "scene": {
        "name": ("", "the file's name", "as it is shown"),
        "mechanism": ("", "needed", "a name of the catalogue, or a file beside the scene's"),
        "description": ("", "none", "a line of text"),
        "duration": ("s", "needed", "how long it lasts"),
        "rate": ("1/s", "100", "outputs per second"),
        "reactions": ("", "false", "true: reactions of all joints are recorded"),
    },
    "initial": {
        "coordinates": ("rad, m", "the reference", "label -> value"),
        "rates": ("rad/s, m/s", "0", "name -> value; of any joint, or of a body's pose"),
        "hold": ("", "all given", "labels of the given values that are kept while the loops are closed"),
        "mode": ("", "the reference's", "assembly mode with the given coordinates; `symscrew assemble` lists them"),
    },
    "integrator": {
        "method": ("", f"`{INTEGRATOR['method']!r}`", "as `symscrew simulate --help` and the theory name them"),
        "tolerance": ("1", f"`{INTEGRATOR['tolerance']!r}`", "largest error that is asked for"),
        "step": ("s", "chosen", "a fixed step in place of a tolerance"),
        "longest_step": ("s", "none", "no step is longer"),
        "most_steps": ("", f"`{INTEGRATOR['most_steps']!r}`", "after so many it ends with a status"),
    },
}
MOTION: Mapping[str, Mapping[str, Meaning]] = {
    "motion": {
        "duration": ("s", "needed", "how long it lasts"),
        "rate": ("1/s", f"{DEFAULT_RATE:g}", "samples per second"),
        "description": ("", "none", "a line of text"),
    }
}
FREE_SCENE = (
    "| `[[effects]]` | `type` and the keys of the [effect](effects.md) |",
    '| `[parameters]` | NAME = value of a run-time parameter, in SI units or with its unit, "200 mm"; needed where '
    "the description counts in another |",
    '| `[tables.NAME]` | times [s], values, interpolation: "linear" or "cubic" |',
    "| `[signals]` | NAME = expression, for use in later ones |",
    "| `[states.NAME]` | rate = expression, initial: a state of the controller |",
    "| `[drives]` | LABEL of u = expression; drives that are not named are 0 |",
    "| `[inputs]` | PORT = [expressions]: inputs of effects, such as load_<point> |",
)


def files_page() -> str:
    """Every kind of file that people write, with its keys."""
    lines = [*FILES_HEAD]
    kinds = (("A mechanism", MECHANISM), ("A scene", SCENE), ("A motion", MOTION))
    for title, sections in kinds:
        lines += [f"## {title}", "", *WORDS[title], ""]
        for section, keys in sections.items():
            lines += [f"### [{section}]", "", "| key | unit | default | meaning |", "|---|---|---|---|"]
            lines += [f"| `{key}` | {unit} | {default} | {text} |" for key, (unit, default, text) in keys.items()]
            lines.append("")
        if title == "A scene":
            lines += ["### Further sections", "", "| section | holds |", "|---|---|", *FREE_SCENE, ""]
    return "\n".join([*lines, *FILES_API, ""])


FILES_HEAD = (
    "# Files that you write",
    "",
    "Keys are fixed: an unknown one is an error that names the nearest. This page is made of the code. What a",
    "problem of optimisation may hold: `symscrew optimise --keys` and [its page](../how_to/optimise.md).",
    "",
)
WORDS = {
    "A mechanism": (
        "Sections but `[mechanism]` are tables by name, `[joints.hip]`. Numbers may be texts with expressions; all are",
        "read exactly. Examples: [your own mechanism](../how_to/own_mechanism.md), the catalogue.",
    ),
    "A scene": (
        "What `symscrew simulate`, `cost` and `fmu` read. Expressions know `t`, `q_LABEL` and `v_LABEL` (dots of a",
        "label become _, or __ where a joint is called so), parameters, tables, signals and states. Examples:",
        "`examples/scenes/`.",
    ),
    "A motion": (
        "What `symscrew drives --motion` reads, with `[coordinates]` or `[twist]`, NAME = expression, and",
        "`[loads.POINT]`, fx ... mz = expression: [a motion in, tables out](../how_to/drives.md).",
    ),
}
FILES_API = (
    "## In Python",
    "",
    "::: symscrew.scene.contents",
    "    options: {members: [Scene, Initial, Integrator, Table]}",
)


PAGES = {
    "reference/effects.md": effects_page,
    "reference/files.md": files_page,
    "reference/public.md": public_page,
}
OF_CODE = {"mechanism": (MECHANISM, MECHANISM_KEYS), "scene": (SCENE, SCENE_KEYS), "motion": (MOTION, MOTION_KEYS)}
NEEDED = {section: set(keys) for section, keys in REQUIRED.items()}

if __name__ == "__main__":
    for place, made in PAGES.items():
        (DOCS / place).write_text(made(), encoding="utf-8")
