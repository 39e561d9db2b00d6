"""The C of a run: generated functions, sizes and units as constants, and the kernels that march with them.

Plant --print_c--> functions --constants, adapters--> one file with the kernels of `simulation/kernels`
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from symscrew.export import banner, decimal, print_c
from symscrew.model import Model
from symscrew.runtime import entry, key_of, version
from symscrew.scene import Table
from symscrew.simulation.complementarity import SHARED
from symscrew.simulation.contacts import HELD, HELD_WITH, LATE, SMALL_ANSWER, Law, laws
from symscrew.simulation.fronts import layouts, paths
from symscrew.simulation.state_programs import Plant
from symscrew.simulation.turned_rounding import Trial, first_path, trial, trial_constants

KERNELS = Path(__file__).parent / "kernels"
# Distances from singular configurations, as parts of the smallest pivot that the closure has in regular ones.
PIVOTS = {
    "PIVOT": 1.0,
    # Nearer, nothing is corrected or evaluated, for it would be noise: interpolated from both sides. At 0.03 four-bars
    # in a row take a tenth of the noise from a crossing; interpolating then costs three digits of a platform's energy.
    "ZONE": 0.02,
    "CAREFUL": 0.25,  # nearer, steps follow the branch on charts; farther, they are projected, which is cheaper
    "LOOK": 1e-3,  # a least pivot below it is a crossing that is reported, and rows with such pivots are its lost rows
}
# Without units: lengths are divided by the characteristic length.
THRESHOLDS = {
    "RANK_FLOOR": 1e-10,  # what is left of a row below it depends on the rows before; above, it is a row of its own
    # Of the square of a row: where less is left across the rows before, it is made orthogonal to them once more. With
    # more, rounding tilts it by ten units in the last place, which corrections do not notice; all rows twice cost a
    # fifth of a run of the seed.
    "TILTED": 1e-2,
    # Opening of the loops from which one more correction leaves nothing but rounding; it is always made. Where openings
    # below 1e-14 are left as they are, they are the same to the same side for many steps: errors of 1e-12 came of it.
    "CLOSED": 1e-13,
    "SETTLED": 1e-9,  # rates that miss the loops by less, of the largest one, need one correction, others a second one
    # An opening that no longer halves is good enough below it; above it the run stops. Coordinates of more than a
    # hundred lengths or radians leave more, in proportion (nearly_closed).
    "NEARLY_CLOSED": 1e-12,
    "STRIDE": 0.05,  # of a chart's scale: longest stride along a branch between two corrections
    # Of a chart's scale: least distance of the places between which the zone is interpolated. Closer together they
    # enlarge what rounding leaves at them, and a run gets stuck (seen at 0.002).
    "SPACING": 0.015,
    "SHARED": SHARED,
    "SMALL_ANSWER": SMALL_ANSWER,
    "HELD": HELD,
    "HELD_WITH": HELD_WITH,
    "LATE": LATE,
    # The instant of an event is that of the step's polynomial; putting the state onto the loops moves it by that
    # polynomial's error. A margin that is off zero by less at the start of its new mode counts as zero.
    "MOST_MOVED": 1e-5,
    "REACH": 0.6,  # longest step in local coordinates: a chart is a good one within about half a radian
    "CAREFUL_TOLERANCE": 4e-13,  # least local tolerance of careful steps: near the zone accelerations are noise
    # The same where the branch is computed with a rounding below the second number (5e-20 of 80 bits, 1e-34 of 128):
    # what is noise in double precision is smooth by three digits more, and a step can be as exact as elsewhere.
    "PRECISE_TOLERANCE": 1e-14,
    "ROUNDING_OF_PRECISE": 1e-18,
    # A repeated step whose error does not fall, as that of a smooth motion would, is rounding of the accelerations: its
    # local tolerance is raised from the first to at most the second, tenfold each time. Without, steps shrink without
    # end and a tighter tolerance ends in a stopped run (governor at 1e-11); the second is what a run may lose there.
    "LEAST_NOISE": 2e-14,
    "MOST_NOISE": 2e-12,
    # Of the time until the end: a step below it leads nowhere; of a thousand in a row (MOST_CRAWLING) the run does not
    # end. A stop met exactly where branches cross left steps of 1e-14 s, ten million of them.
    "CRAWL": 1e-12,
    "DUST": 1e-150,  # slopes below it count as zero: their products would be denormal numbers, twelve times as slow
}
# Newton steps onto the loops, each of which doubles the digits; a step of the run that needs more is repeated, shorter
# or with care.
MOST_CORRECTIONS = 12
MOST_CRAWLING = 1000  # steps in a row that lead nowhere; onto a knot or an impact a few may be as short
# Intervals of time, on each of which inputs are polynomials of order 8 to the tolerance, that a step may span: it is of
# order 8 itself and would resolve about two. More: short features are seen late; fewer: steps shorter than errors ask.
SPAN = 4
# what stands for the tables of a scene that has none
NO_TABLES = "static void tables_at(double t, double *s)\n{\n    (void)t;\n    (void)s;\n}\n"
# The type of a file that computes in extended precision: kernels and generated functions say `double` of whatever they
# compute with, and <tgmath.h> takes the functions of that type. Its literals are those of double precision, so that
# both are of the same mechanism. Vectors are of four numbers in double precision: without them.
EXTENDED = """#include <math.h>
#include <stddef.h>
#include <string.h>
#include <tgmath.h>
typedef double Rounded;
#define double long double"""


def generated(plant: Plant, chosen: Trial | None = None) -> dict[str, str]:
    """The plant's functions as C, printed once and then read from the user's cache; `chosen`: see `Trial`."""
    reduced = _reduced(plant, chosen)
    about = ["C of a plant", version(), *banner(reduced), *(p.hash for p in reduced.programs.values())]
    with entry(key_of(*(text.encode("utf-8") for text in about))) as kept:
        found = kept.read()
        if found is None:
            found = json.dumps(print_c(reduced, batches=False)).encode("ascii")
            kept.write(found)
    texts: dict[str, str] = json.loads(found)
    return texts


def _reduced(plant: Plant, chosen: Trial | None) -> Model:
    """The model with what a run calls, and nothing else."""
    programs = {"slopes": plant.slopes, "inputs": plant.inputs, "forward_dynamics": plant.forward}
    if chosen is not None:
        programs |= {"slopes": chosen.slopes, "slopes_turned": chosen.turned}
    if plant.rates is not None and plant.sizes["x"]:
        programs["state_rates"] = plant.rates
    if plant.switches is not None:
        programs["switches"] = plant.switches
    if plant.starts is not None:
        programs["states_at_start"] = plant.starts
    if plant.closure is not None:
        programs["closure_both"] = replace(plant.closure, name="closure_both")
    return Model(plant.model.name, plant.model.mechanism, plant.model.effects, programs, {}, plant.system)


def kernel_text(name: str) -> str:
    """A kernel's text with the files that it includes put in."""
    lines = []
    for line in (KERNELS / name).read_text(encoding="utf-8").splitlines():
        if line.startswith('#include "dop853_'):
            lines.append(kernel_text(line.split('"')[1]).rstrip("\n"))
        else:
            lines.append(line)
    return "\n".join([*lines, ""])


def _table(name: str, rows: Sequence[tuple[int, int]]) -> str:
    body = ", ".join(f"{{{a}, {b}}}" for a, b in rows) or "{0, 0}"
    return f"static const int {name}[{max(len(rows), 1)}][2] = {{{body}}};"


def _vector(name: str, values: np.ndarray, storage: str = "static const") -> str:
    body = ", ".join(decimal(float(v)) for v in values) or "1.0"
    return f"{storage} double {name}[{max(len(values), 1)}] = {{{body}}};"


def constants(plant: Plant) -> str:
    """Sizes, units and thresholds that the kernels read."""
    tree, sizes = plant.system.tree, plant.sizes
    spheres, plain = tree.spheres, tree.plain
    nq, nv, nx, nr = sizes["q"], sizes["v"], sizes["x"], len(plant.rows)
    passive = int(plant.works)
    numbers = {
        "NQ": nq, "NV": nv, "NX": nx, "NU": sizes["u"], "NS": plant.tables, "NR": nr, "RANK": plant.rank,
        "FREE": nv - plant.rank, "NY": 2 * nv + nx, "PASSIVE": passive, "PLAIN_COUNT": len(plain),
        "SPHERE_COUNT": len(spheres), "NQ1": max(nq, 1), "NV1": max(nv, 1), "NX1": max(nx, 1), "NR1": max(nr, 1),
        "NY1": max(2 * nv + nx, 1), "RANK1": max(plant.rank, 1), "ENTRIES": len(plant.entries),
        "ENTRIES1": max(len(plant.entries), 1), "MOST_CORRECTIONS": MOST_CORRECTIONS, "SPAN": SPAN,
        "MOST_CRAWLING": MOST_CRAWLING,
        "FAILED": 1001, "IN_ZONE": 1002, "AT_REST": 1003, "LEAST_SQUARES": 5,
    }  # fmt: skip
    reals = {
        **{name: part * plant.pivot for name, part in PIVOTS.items()},
        **THRESHOLDS,
    }
    lines = [f"#define {name} {value}" for name, value in numbers.items()]
    lines += [f"#define {name} {decimal(float(value))}" for name, value in reals.items()]
    lines += [
        _table("PLAIN", plain),
        _table("SPHERES", spheres),
        _vector("UNIT", plant.units),
        _vector("ROW_SCALE", plant.rows),
        *(_pattern(plant) if nr else ()),
        "#if !defined(PARAMETERS_STORAGE)",
        "#define PARAMETERS_STORAGE static const",
        "#endif",
        _vector("PARAMETERS", plant.parameters, "PARAMETERS_STORAGE"),
    ]
    return "\n".join([*lines, ""])


def _integers(name: str, values: Sequence[int]) -> str:
    return f"static const int {name}[{max(len(values), 1)}] = {{{', '.join(map(str, values)) or '0'}}};"


def _pattern(plant: Plant) -> list[str]:
    """Where the closure's Jacobian has entries, and the fronts of its rows."""
    fronts = plant.fronts
    places, through = layouts(fronts), paths(fronts, plant.entries)
    live = [row for front in fronts for row in front.rows]
    coordinates = [(k, column) for k, front in enumerate(fronts) for column in front.columns]
    column_at = [-1] * sum(place.width for place in places)
    spots = [-1] * plant.sizes["v"]
    for k, column in coordinates:
        spots[column] = places[k].at + fronts[k].columns.index(column)
        column_at[spots[column]] = column
    lower = [
        sum(fronts[j].rank for j in through[row]) + front.rank for front in fronts for row in front.rows
    ]  # parts of a row along the pivots below, then along those of its own front
    starts = np.searchsorted(plant.entries[:, 0], np.arange(len(plant.rows) + 1)).tolist()
    table = ", ".join(
        f"{{{p.row}, {len(f.rows)}, {p.pivot}, {f.rank}, {p.at}, {p.width}, {len(f.columns)}, {f.parent}, {p.up}, "
        f"{p.turn}}}"
        for f, p in zip(fronts, places, strict=True)
    )
    sizes = {
        "FRONTS": max(len(fronts), 1), "LIVE1": max(len(live), 1), "WIDTHS": max(len(column_at), 1),
        "TURNS": max(sum(p.width**2 for p in places), 1), "LOWERS": max(sum(lower), 1),
        "MOST_ROWS": max((len(f.rows) for f in fronts), default=1),
        "MOST_WIDTH": max((p.width for p in places), default=1),
    }  # fmt: skip
    return [
        *(f"#define {name} {value}" for name, value in sizes.items()),
        f"#define FRONT_TABLE {{{table or '{0, 0, 0, 0, 0, 0, 0, -1, 0, 0}'}}}",
        _table("ENTRY", [(row, column) for row, column in plant.entries.tolist()]),
        _integers("ENTRY_START", starts),
        _integers("LIVE_ROW", live),
        _integers("LOWER_AT", _sums(lower)),
        _integers("PATH_START", _sums([len(through[row]) for row in live])),
        _integers("PATH", [front for row in live for front in through[row]]),
        _integers("SPOT", spots),
        _integers("COLUMN", column_at),
    ]


def _sums(counts: Sequence[int]) -> list[int]:
    return [0, *itertools.accumulate(counts)]


def contact_numbers(rule: Law) -> list[float]:
    """The numbers of a contact that parameters can change; there are no infinities in C99's text."""
    reals = (rule.coulomb, rule.static, rule.stribeck, rule.lower, rule.upper)
    return [float(np.clip(value, -1e300, 1e300)) for value in reals]


def contact_constants(rules: Sequence[Law]) -> str:
    """The contacts of a run as constant data; "" for none."""
    if not rules:
        return ""

    def entry(rule: Law) -> str:
        numbers = [decimal(value) for value in contact_numbers(rule)]
        return f"{{{int(rule.contact.kind == 'stop')}, {rule.v}, {rule.q}, {', '.join(numbers)}}}"

    table = ", ".join(entry(rule) for rule in rules)
    return (
        f"#define CONTACTS {len(rules)}\n#define CONTACT_TABLE {{{table}}}\n"
        f"static double CONTACT_FORCE[CONTACTS];\n#define OUTSIDE_INPUTS CONTACT_FORCE\n"
    )


def adapters(plant: Plant, forces: str = "forces_at", chosen: Trial | None = None) -> str:
    """C that calls the generated functions by the names that the kernels use; `forces`: that of the accelerations."""
    name = plant.model.name
    commanded = list(plant.inputs.outputs)
    outside = next((port.size for port in plant.slopes.inputs if port.name == "s"), 0) - plant.tables
    lines = [
        f"static int {forces}(double t, const double *q, const double *v, const double *x, const double *u, double *a,",
        f"{' ' * len(f'static int {forces}(')}double *x_dot)",
        "{",
        f"    double s[NS + {outside + 1}] = {{0.0}};",
        "    tables_at(t, s);",
        *(f"    s[NS + {k}] = OUTSIDE_INPUTS[{k}];" for k in range(outside)),
        *first_path(name, chosen),
        *(f"    double {port.name}[{max(port.size, 1)}];" for port in commanded),
    ]
    if commanded:
        given = ", ".join(p.name for p in commanded)
        lines.append(f"    if ({name}_inputs(&t, q, v, x, u, s, PARAMETERS, {given}) != 0) {{")
        lines += ["        return 2;", "    }"]
    known = {"q": "q", "v": "v", "x": "x", "t": "&t", "p": "PARAMETERS"}
    arguments = [known.get(p.name, f"{p.name}_command") for p in plant.forward.inputs]
    results = ["a" if p.name == "a" else "spare" for p in plant.forward.outputs]
    spare = max([p.size for p in plant.forward.outputs if p.name != "a"], default=0)
    if spare:
        lines.append(f"    double spare[{spare}];")
    if plant.rates is not None and plant.sizes["x"]:
        lines += [
            f"    if ({name}_state_rates(&t, q, v, x, u, s, PARAMETERS, x_dot) > 0) {{",
            "        return 2;",
            "    }",
        ]
    lines += [f"    return {name}_forward_dynamics({', '.join([*arguments, *results])});", "}"]
    lines += _beside_slopes(plant, outside)
    if plant.closure is not None:
        p = ", PARAMETERS" if any(port.name == "p" for port in plant.closure.inputs) else ""
        lines += [
            "static int closure_at(const double *q, double *residual, double *jacobian)",
            "{",
            f"    return {name}_closure_both(q{p}, residual, jacobian);",
            "}",
        ]
    return "\n".join([*lines, ""])


def _beside_slopes(plant: Plant, outside: int) -> list[str]:
    """What steps watch beside slopes, where there is some: conditions of laws, and the work of drives."""
    name, lines = plant.model.name, list[str]()
    if plant.switches is not None:
        lines += [
            f"#define SWITCHES {plant.switches.outputs[0].size}",
            "static int switches_at(double t, const double *q, const double *v, const double *x, double *g)",
            "{",
            f"    double s[NS + {outside + 1}] = {{0.0}};",
            f"    const double u[{max(plant.sizes['u'], 1)}] = {{0.0}};",
            "    tables_at(t, s);",
            *(f"    s[NS + {k}] = OUTSIDE_INPUTS[{k}];" for k in range(outside)),
            f"    return {name}_switches(&t, q, v, x, u, s, PARAMETERS, g);",
            "}",
        ]
    if plant.works and plant.rates is not None and not outside:
        lines += [
            "#define WORKS 1",
            "static int rates_at(double t, const double *q, const double *v, const double *x, double *x_dot)",
            "{",
            "    double s[NS + 1] = {0.0};",
            f"    const double u[{max(plant.sizes['u'], 1)}] = {{0.0}};",
            "    tables_at(t, s);",
            f"    return {name}_state_rates(&t, q, v, x, u, s, PARAMETERS, x_dot);",
            "}",
        ]
    return lines


def source(plant: Plant, tables: str = "") -> str:
    """The whole C file of a run."""
    return sources(plant, tables)[0]


def sources(plant: Plant, tables: str = "") -> tuple[str, str]:
    """The C file of a run, and the one that follows branches near singular configurations in extended precision."""
    varied = len(plant.parameters)  # they are put in when the library is there, so that one serves all values
    functions = _functions(replace(plant, parameters=plant.system.parameter_values), tables)
    near = ("rows.c", "manifold.c", "contacts.c", "chart.c", "branch.c", "anchor.c")
    steps = ("steps.c", "adaptive.c", "polynomials.c", "events.c", "switches.c", "start.c", "simulation.c")
    head = ["#include <math.h>", "#include <stddef.h>", "#include <string.h>"]
    scalar = f"#define {plant.model.name.upper()}_SCALAR 1"
    run = [*head, *_storage(varied), *functions, *map(kernel_text, (*near, *steps))]
    precise = [EXTENDED, scalar, *_storage(varied), *functions, *map(kernel_text, (*near, "precise.c"))]
    if varied:
        run += _put("simulation_parameters", "double")
        precise += _put("precise_parameters", "Rounded")
    return "\n".join(run), "\n".join(precise)


def _storage(varied: int) -> list[str]:
    """What makes variables of the parameters, and of what follows from them."""
    if not varied:
        return []
    return [f"#define VARIED {varied}", "#define PARAMETERS_STORAGE static", "#define CONTACT_STORAGE static"]


def _put(symbol: str, given: str) -> list[str]:
    """The function that puts values in; its arguments are of the type `given`."""
    return [f"#define PUT_PARAMETERS {symbol}", f"#define GIVEN {given}", kernel_text("parameters.c")]


def rules_of(plant: Plant) -> tuple[Law, ...]:
    """The contacts of a run with numbers, at the plant's parameters."""
    found = [c for e in plant.model.effects for c in e.contacts()] if plant.outside else []
    return laws(plant.model, found, plant.parameters)


def _functions(plant: Plant, tables: str) -> list[str]:
    """What the kernels call: generated functions, constants, adapters."""
    chosen = trial(plant)
    files = generated(plant, chosen)
    name = plant.model.name
    code = files[f"{name}.c"].replace(f'#include "{name}.h"', files[f"{name}.h"])
    rules = rules_of(plant)
    head = [code, constants(plant)]
    head += ["static long evaluations;", "#define COUNT_EVALUATION ++evaluations", contact_constants(rules)]
    if chosen is not None:
        head += [trial_constants(chosen), kernel_text("roundings.c")]
    plain = adapters(plant, "plain_forces_at" if rules else "forces_at", chosen)
    return [*head, kernel_text("dop853_error.h"), tables or NO_TABLES, plain]


def table_code(tables: Sequence[Table]) -> str:
    """`tables_at(t, s)` in C: the polynomial pieces of every table as constant data; "" for none."""
    if not tables:
        return ""
    lines = []
    for k, table in enumerate(tables):
        body = ", ".join(decimal(t) for t in table.times)
        lines.append(f"static const double TABLE_{k}_TIMES[{len(table.times)}] = {{{body}}};")
        rows = ", ".join("{" + ", ".join(decimal(float(c)) for c in row) + "}" for row in table.pieces())
        lines.append(f"static const double TABLE_{k}_PIECES[{len(table.times) - 1}][4] = {{{rows}}};")
    lines += [
        "static double table_at(double t, int count, const double *times, const double (*pieces)[4])",
        "{",
        "    int low = 0, high = count - 1;",
        "    t = t < times[0] ? times[0] : t > times[count - 1] ? times[count - 1] : t;",
        "    while (high - low > 1) {",
        "        const int middle = (low + high) / 2;",
        "        if (t >= times[middle]) {",
        "            low = middle;",
        "        } else {",
        "            high = middle;",
        "        }",
        "    }",
        "    const double d = t - times[low], *c = pieces[low];",
        "    return c[0] + d * (c[1] + d * (c[2] + d * c[3]));",
        "}",
        "static void tables_at(double t, double *s)",
        "{",
    ]
    for k, table in enumerate(tables):
        lines.append(f"    s[{k}] = table_at(t, {len(table.times)}, TABLE_{k}_TIMES, TABLE_{k}_PIECES);")
    return "\n".join([*lines, "}", ""])
