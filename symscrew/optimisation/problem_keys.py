"""Every key of a problem file: unit, default, meaning and an example, as a table that people read and the reader obeys.

The defaults are those of the dataclasses in `symscrew.optimisation.problem`. They end docs/how_to/optimise.md.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import MISSING, Field, dataclass, fields
from typing import Any

from symscrew.optimisation.problem import (
    Bounds,
    Conditions,
    Objective,
    Solver,
    TrajectoryProblem,
    Transcription,
)


@dataclass(frozen=True)
class Key:
    """A key: its unit, what it says, a line of TOML with it, and the field that holds it (default: of its own name)."""

    unit: str
    says: str
    example: str
    field: str = ""


BOTH = "rad, m"
MODE = "[start] and [end] alone: assembly mode, see `symscrew assemble`; else the reference's, or to which it leads"
CONDITIONS: Mapping[str, Key] = {
    "coordinates": Key(
        BOTH,
        "any names that `--at` takes: of joints, passive ones too, of the platform (z, tilt, azimuth, roll, rx, turn) "
        "and of other bodies, with units",
        'coordinates = { x = "100mm", bead.z = 0 }',
    ),
    "rates": Key(
        "rad/s, m/s",
        "of coordinates by any name but tilt, azimuth and turn, with units; not beside at_rest",
        'rates = { x = "10cm/s" }',
    ),
    "points": Key(
        "m", 'named points, absolute axes, "free" for a coordinate that is', 'points = { bead = [0.2, "free", "free"] }'
    ),
    "platform_normal": Key("1", "where z of the platform's reference pose points", "platform_normal = [0, 0, 1]"),
    "platform_position": Key(
        "m", "the platform's displacement from its reference", "platform_position = [0.1, 0, 0.2]"
    ),
    "platform_rotation": Key(
        "rad", "rotation vector of the platform from its reference", "platform_rotation = [0, 0, 0]"
    ),
    "at_rest": Key("", "all rates are zero", "at_rest = true"),
}
SECTIONS: Mapping[str, Mapping[str, Key]] = {
    "problem": {
        "mechanism": Key(
            "", "a name of the catalogue, or a file beside the problem's; this or scene", 'mechanism = "four_bar"'
        ),
        "scene": Key("", "a scene's file: its mechanism, effects, inputs and parameters", 'scene = "fall.toml"', "-"),
        "name": Key("", "of the motion", 'name = "other"'),
        "description": Key("", "for readers; kept with the motion", 'description = "about it"', "-"),
        "duration": Key("s", "a number, or [lower, upper] for one that is chosen; no default", "duration = 2"),
        "periodic": Key("", "the motion ends as it began", "periodic = true"),
        "turns": Key(
            "1",
            "whole turns by which angles of y end further on in a periodic motion",
            "periodic = true\nturns = { hinge = 1 }",
        ),
        "independent": Key(
            "",
            "the independent coordinates y: labels of q, or x, y, z, qx, qy, qz of a platform that hangs on a joint of "
            "the package's own (rz of a planar one); default: the drives' where they are regular",
            'independent = ["z", "x"]',
        ),
        "drive_rule": Key(
            "",
            '"free", or "least_squares" distribution of redundant drives about [preload]',
            'drive_rule = "least_squares"',
        ),
        "accuracy": Key(
            f"{BOTH}; 1",
            "[dynamic, kinematic]: how far a replay may end off the plan, opening of the loops; the mesh is refined "
            "until then, and the verdict asks for it; [inf, inf]: neither",
            "accuracy = [1e-3, 1e-3]",
        ),
        "starts": Key("", "guesses from which it is solved on all cores: the usual one and random ones", "starts = 3"),
        "seed": Key("", "of the random guesses", "seed = 2\nstarts = 3"),
        "violation": Key(
            "1", "the most by which a bound may be broken between the points, as a part of its size", "violation = 1e-3"
        ),
    },
    "start": {
        **CONDITIONS,
        "mode": Key("", MODE, 'mode = "-1"'),
    },
    "end": {**CONDITIONS, "mode": Key("", MODE, 'mode = "-1"\nat_rest = true')},
    "via": {
        **CONDITIONS,
        "time": Key("1", "the part of the duration that has passed, between 0 and 1", "time = 0.25\nat_rest = true"),
    },
    "bounds": {
        "drives": Key("N, N m", 'ranges by labels of u; a number for +-, "*" for all drives', "drives = { x = 3 }"),
        "drive_rates": Key(
            "N/s, N m/s", "of the drives' rates; the drives then have no jumps", "drive_rates = { x = 3 }"
        ),
        "joints": Key(
            BOTH, "of coordinates, by any name as in [start] but azimuth and turn", 'joints = { x = "30cm" }'
        ),
        "speeds": Key("rad/s, m/s", "of their rates, by names as in rates", "speeds = { x = 3 }"),
        "margins": Key("1", "of singularity margins (`symscrew mobility` names them)", "margins = { bead = [1, 2] }"),
        "points": Key("m", "of coordinates of named points", "points = { bead = { x = 1 } }"),
        "reactions": Key(
            "N, N m", "largest force of a joint, and moment about its point", "reactions = { x = { force = 5 } }"
        ),
        "distances": Key("m", "of two named points", 'distances = [{ between = ["bead", "post"], range = [0.01, 9] }]'),
        "obstacles": Key(
            "m",
            "shapes at named points of any body that points, segments between two, or boxes (a corner, its neighbours) "
            "keep off by a distance: sphere (centre), plane (a point, one above), capsule (both ends), box",
            'obstacles = [{ type = "sphere", at = ["post"], points = ["bead"], distance = 0.01 }]',
        ),
        "expressions": Key(
            "",
            "of texts in t, T, q_, v_, u_ of labels, point_x of points, parameters",
            'expressions = { "q_x*u_z" = 2 }',
        ),
    },
    "objectives": {
        "type": Key(
            "",
            "effort: integral of w u^2; time: the duration; energy: integral of the drives' positive "
            "power; electrical: of w u^2 + u rate; jerk: of squared third rates of y; peak: largest "
            "|u / w|; preload: of w (u - preload)^2; expression: of a text",
            'type = "peak"',
        ),
        "weight": Key("", "of this objective in the cost", 'type = "effort"\nweight = 3'),
        "weights": Key(
            "",
            "w by labels of u (default 1; electrical [W/N^2] 0): of effort, electrical, peak, preload",
            'type = "effort"\nweights = { x = 3 }',
        ),
        "preload": Key("N, N m", "by labels of u, of an objective preload", 'type = "preload"\npreload = { x = 3 }'),
        "expression": Key(
            "", "of an objective expression, as under bounds", 'type = "expression"\nexpression = "u_x^4"'
        ),
    },
    "transcription": {
        "method": Key(
            "",
            "radau or gauss collocation, or multiple shooting: drives that are constant in each interval, as a sampled "
            "controller holds them",
            'method = "gauss"',
        ),
        "degree": Key(
            "",
            "points in an interval, more where intervals would be many (shooting: steps of Runge-Kutta)",
            "degree = 2",
        ),
        "intervals": Key("", "of the first mesh", "intervals = 3"),
        "second_order": Key("", "collocation keeps y' the derivative of y between the points", "second_order = false"),
        "formulation": Key(
            "",
            "inverse: projected equations of motion as constraints; forward: accelerations from forward dynamics",
            'formulation = "forward"',
        ),
        "mesh": Key("1", "ends of the intervals in place of equal ones, the last one 1", "mesh = [0.3, 1]"),
    },
    "solver": {
        "name": Key("", "of CasADi's solvers", 'name = "sqpmethod"'),
        "tolerance": Key("1", "IPOPT's", "tolerance = 1e-6"),
        "iterations": Key("", "the most", "iterations = 7"),
        "time_limit": Key("s", "for all that is solved, refinements included; IPOPT's", "time_limit = 5"),
        "options": Key("", "of the solver, by its own names", "options = { mu_init = 1e-3 }"),
    },
}
# Sections whose keys are names of the mechanism or of an effect.
OWN: Mapping[str, Key] = {
    "effects": Key(
        "",
        "tables with type and the effect's own keys, as in scenes; no gravity acts unless named",
        '[[effects]]\ntype = "gravity"',
    ),
    "preload": Key(
        "N, N m",
        "by labels of u: of the rule least_squares and of objectives preload",
        '[preload]\nx = 1\n[[objectives]]\ntype = "preload"',
    ),
    "design": Key("", "parameters of the mechanism that are chosen too, with their ranges", "[design]\nm = [1, 2]"),
    "parameters": Key("", "values of parameters in place of the mechanism's", "[parameters]\nm = 2"),
    "inputs": Key(
        "",
        "constant values of an effect's ports",
        '[[effects]]\ntype = "external_wrench"\npoint = "bead"\n[inputs]\nload_bead = [1, 2, 3, 0, 0, 0]',
    ),
    "guess": Key(
        BOTH,
        "values at equal times, at least two: of every y, or of any coordinates as in [start], from which y follows",
        "[guess]\nx = [0, 1, 0]\nz = [0, 0, 1]",
    ),
}
HOLDERS: Mapping[str, type] = {
    "problem": TrajectoryProblem,
    "start": Conditions,
    "end": Conditions,
    "via": Conditions,
    "bounds": Bounds,
    "objectives": Objective,
    "transcription": Transcription,
    "solver": Solver,
}
SHARED: Mapping[str, Key] = {
    "duration": Key("s", "of this part, in place of [problem]'s", "duration = 0.5"),
    "weight": Key("1", "of its cost in the sum; default 1", "weight = 2"),
    "end": Key("", "as [end]", "end = { coordinates = { x = 0.2 } }"),
    "via": Key("", "as [[via]]", "via = [{ time = 0.5, coordinates = { x = 0.3 } }]"),
    "bounds": Key("", "as [bounds], beside those of all parts", "bounds = { speeds = { x = 2 } }"),
    "objectives": Key("", "as [[objectives]], in place of those of all parts", 'objectives = [{ type = "jerk" }]'),
    "effects": Key("", "as [[effects]], beside those of all parts", 'effects = [{ type = "gravity" }]'),
    "inputs": Key(
        "", "as [inputs]",
        'effects = [{ type = "external_wrench", point = "bead" }]\ninputs = { load_bead = [1, 2, 3, 0, 0, 0] }',
    ),
    "preload": Key("", "as [preload]", 'preload = { x = 1 }\nobjectives = [{ type = "preload" }]'),
    "guess": Key("", "as [guess]", "guess = { x = [0, 1, 0], z = [0, 0, 1] }"),
    "transcription": Key("", "as [transcription]", "transcription = { intervals = 3 }"),
}  # fmt: skip
PARTS: Mapping[str, Mapping[str, Key]] = {
    "phases": {
        **SHARED,
        "impact": Key(
            "1",
            "at its end these freedoms of joints are stopped (0) or thrown back (up to 1), with an impulse along each",
            "impact = { x = 0.5 }",
        ),
        "catches": Key("", "the mass that the next phase has more was at rest; else it moved along", "catches = true"),
    },
    "cases": {
        **SHARED,
        "start": Key("", "as [start]", "start = { coordinates = { x = 0.1, z = 0 } }"),
        "parameters": Key("", "as [parameters]", "parameters = { m = 2 }"),
    },
}
LISTS = ("effects", "via", "objectives")


def default_of(section: str, key: str) -> str:
    """The default of a key, as one writes it; "-" where there is none."""
    known: dict[str, Field[Any]] = {f.name: f for f in fields(HOLDERS[section])}
    name = SECTIONS[section][key].field or key
    if name not in known or (section, key) == ("problem", "duration"):
        return "-"
    given = known[name]
    if given.default is not MISSING:
        return _written(given.default)
    return "-" if given.default_factory is MISSING else _written(given.default_factory())


def _written(value: object) -> str:
    if value is None or value == {} or value == () or value == "":
        return "none"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return "none" if math.isinf(value) else f"{value:g}"
    if isinstance(value, tuple):
        return f"[{', '.join(_written(v) for v in value)}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def tables_of_keys() -> str:
    """All keys as Markdown, a table per section."""
    parts = []
    for section, keys in SECTIONS.items():
        if section == "end":
            continue
        title = TITLES.get(section, f"[{section}]")
        own = {name: key for name, key in keys.items() if section != "via" or name == "time"}
        rows = [_row(f"`{name}`", key, default_of(section, name)) for name, key in own.items()]
        note = "As [start], and:\n\n" if section == "via" else ""
        parts.append(f"## `{title}`\n\n{note}{HEAD}" + "\n".join(rows))
    rows = [_row(f"`[[{name}]]`" if name in LISTS else f"`[{name}]`", key, "none") for name, key in OWN.items()]
    parts.append("## Sections whose keys are names of yours\n\n" + HEAD.replace("key", "section") + "\n".join(rows))
    heads = {
        "phases": "Two or more motions, each from where the one before ends; what stands outside them holds for all, "
        "[start] for the first one, [end] for the last one. Effects may differ; bodies that are there later keep their "
        "rate unless `impact` or `catches` says otherwise.",
        "cases": "Two or more motions that share the parameters under [design] and nothing else; what stands outside "
        "them holds for all.",
    }
    for section, keys in PARTS.items():
        rows = [_row(f"`{name}`", key, "-") for name, key in keys.items()]
        parts.append(f"## `[[{section}]]`\n\n{heads[section]}\n\n{HEAD}" + "\n".join(rows))
    return "\n\n".join(parts) + "\n"


def _row(name: str, key: Key, default: str) -> str:
    return f"| {name} | {key.unit or '-'} | {_cell(default)} | {_cell(key.says)} | {_code(key.example)} |"


TITLES = {"start": "[start], [end]", "via": "[[via]]", "objectives": "[[objectives]]"}
HEAD = "| key | unit | default | says | example |\n|---|---|---|---|---|\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _code(text: str) -> str:
    return "<br>".join(f"`{_cell(line)}`" for line in text.splitlines())
