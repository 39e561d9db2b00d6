"""C of all assembly modes and of the one that a motion stays on: tables of a structure, then parts that all have alike.

    Structure, start system --tables--> <name>_modes.c:  numbers with bounds, certificates, nearest mode (modes_balls,
    modes_solver); numbers in lanes, all modes (modes_paths, modes_search); closure_equations for both kinds

Nothing is allocated, no state is kept, work is bounded. The start system is among the tables.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from typing import Any

import numpy as np

from symscrew.assembly.all_modes import known_zero, structure_of
from symscrew.assembly.batch_equations import BatchEquations
from symscrew.assembly.c_tables import LINE, Step, c_array, held_steps
from symscrew.assembly.closed_zeros import closed_form
from symscrew.assembly.closure_structure import Structure
from symscrew.assembly.coupled_columns import coupled_columns
from symscrew.assembly.equal_axes import ASIDE, axis_pairs, spinors
from symscrew.assembly.families import AllNumbers
from symscrew.assembly.start_system import StartSystem, start_system
from symscrew.assembly.what_is_held import Held, held_by, singles
from symscrew.description import Mechanism
from symscrew.export import decimal, wrapped
from symscrew.mobility import NotAlgebraicError

Array = np.ndarray[Any, Any]

KINDS = ("turn", "slide", "ball", "planar", "free")
FORMS = ("distance", "angle", "meeting", "parallel", "crossing")
SLOTS = ("point", "axis", "number", "distance")
COUPLED = ("turned", "slid")
"""Further kinds of slots and forms, and of groups, of mechanisms whose couplings tie what is free."""
SEED = 20231009
"""Of the planes in which coordinates stay and of the rows that are mixed: equal input gives equal bytes."""
MOST_PATHS = 96
"""Of the C, whose arrays for them lie on the stack: 40 are those of a platform on six legs, 84 of a 3-UPU."""
LAYOUT = {
    "MOST_STEPS": 2000,  # of a path; those of random platforms take sixty, of loops of seven hinges up to 450
    "MOST_CRAWL": 60,  # near its end, to get over half of what is left: of more, rounding leaves luck every other one
    "MOST_NEWTON": 12,
    "MOST_PARTS": 64,  # steps, and halvings, of one call along a motion
}
NUMBERS = {
    "TOLERANCE": 1e-3,  # longest first correction of a path over its point's length; retried at a thirtieth
    "LONGEST_STEP": 0.15,
    "SHORTEST_STEP": 1e-6,  # of what is left: a shorter one means a singular end
    "CRAWL": 1e-3,  # of the way that is left, from which on steps are counted
    "BEHIND": 1e-2,  # of the way: a path with more left stays at a singular place of it, not at an end
    "DIFFERENCE": 1e-3,  # of rates along a path: equations are almost quadratic in s
    "LEAST_BOX": 1e-7,  # that a certificate is first tried with; most zeros are farther apart
}


@dataclass(frozen=True)
class ModesModel:
    """What the tables are made of. `drives`: (label, reference, unit [m or 1 rad], whether it is a length)."""

    name: str
    held: Held
    structure: Structure
    equations: BatchEquations
    start: StartSystem
    drives: tuple[tuple[str, float, float, bool], ...]


def modes_model(mechanism: Mechanism) -> ModesModel:
    """What the C of a mechanism is made of; raises DescriptionError, which says why there is none."""
    return held_modes_model(held_by(mechanism, {}, {}))


def held_modes_model(held: Held) -> ModesModel:
    """The same of a mechanism with these coordinates as arguments."""
    mechanism = held.mechanism
    try:
        structure = structure_of(held)
        if structure.equations > structure.unknowns:
            held = held.fewer()
            structure = structure_of(held)
    except NotAlgebraicError as error:
        raise held.error(f"no C of them: {error}") from error
    equations = BatchEquations(structure)
    if not structure.groups or structure.unknowns != structure.equations:
        raise held.error("no C of them: only of mechanisms with loops whose equations are as many as their unknowns")
    tied = coupled_columns(mechanism, held.network, held.drives).met
    if tied:
        raise held.error(f"no C of them: the coupling {next(iter(tied))} ties its arguments; hold fewer")
    if not held.drives:
        raise held.error("no C of them: nothing moves the mechanism")
    start = start_system(AllNumbers(equations), known_zero(equations))
    if not start.complete or len(start.zeros) > MOST_PATHS:
        raise held.error(f"no C of them: {len(start.zeros)} zeros of a general mechanism are known; {start.why}")
    length = float(held.network.length)
    known = {column: (name, reference, slides)
             for name, column, reference, slides in singles(held.mechanism, held.network)}  # fmt: skip
    drives = tuple((known[c][0], known[c][1], length if known[c][2] else 1.0, known[c][2]) for c in held.drives)
    return ModesModel(mechanism.name, held, structure, equations, start, drives)


def print_modes(model: ModesModel, top: Sequence[str] = ()) -> dict[str, str]:
    """<name>_modes.h and <name>_modes.c; `top`: lines of the banner."""
    name = model.name
    comment = ["/*", *(f" * {line}".rstrip() for line in top), " */"]
    parts = [*comment, f'#include "{name}_modes.h"', "", "#include <math.h>", "", *_tables(model), ""]
    balls, paths, equations = (_text(f) for f in ("modes_balls.c", "modes_paths.c", "closure_equations.c"))
    parts += [*balls, ""]
    for prefix, of in (("ball", "Ball"), ("plain", "double")):
        parts += [*_kind(prefix, of), *equations, *_UNDEFINED, ""]
    form = closed_form(model.structure, model.held.drives)
    parts += [*_text("modes_solver.c"), "", *_text(form.zeros), ""]
    parts += [*paths, "", *_kind("lanes", "Lanes"), *equations, *_UNDEFINED, "", *_text("modes_search.c"), ""]
    parts += [*form.tables, *_text(form.more), ""] if form.more else []
    return {f"{name}_modes.h": "\n".join(_header(model, comment)), f"{name}_modes.c": "\n".join(parts)}


def has_level_modes(model: ModesModel) -> bool:
    """Whether the C has the closed form of modes with the platform turned as in the reference."""
    return bool(closed_form(model.structure, model.held.drives).more)


def _text(file: str) -> list[str]:
    return resources.files("symscrew.assembly").joinpath(file).read_text("utf-8").splitlines()


def _kind(prefix: str, of: str) -> list[str]:
    made = [f"#define NUM {of}", f"#define FN(name) {prefix}_##name"]
    made += [f"#define {m}(a, b) {prefix}_{m.lower()}(a, b)" for m in ("ADD", "SUB", "MUL", "TIMES")]
    return [*made, f"#define OF(a) {prefix}_of(a)", ""]


_UNDEFINED = ["", *(f"#undef {name}" for name in ("NUM", "FN", "ADD", "SUB", "MUL", "TIMES", "OF"))]

HEADER = """#ifndef GUARD_MODES_H
#define GUARD_MODES_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
    NAME_MODES_DRIVES = DRIVES,
    NAME_MODES_MOST = PATHS,
    NAME_MODES_COORDINATES = WIDTH,
    NAME_MODES_OK = 0,
    NAME_MODES_NOT_FINITE = 2,
    NAME_MODES_INCOMPLETE = 100, /* a path was lost, or comes to a solution that is singular or almost */
    NAME_MODES_REFUSED = 101, /* no steps are proved to stay on the mode: a singularity is near, or lies between */
    NAME_MODES_NOT_CERTIFIED = 102 /* the mode that was given is none of these functions' */
};

/* One solution of the closure. Drives in the order
TOLD   pose: of PLATFORM, displacement from the reference: rotation by columns, then of what is at O [m].
   z: coordinates of the closure, of size 1; one solution lies within `error` of them where `certified` is 1. */
typedef struct {
    double drives[DRIVES];
    double pose[12];
    double z[WIDTH];
    double error;
    int certified;
} NAME_mode;

/* All modes for these drives: `modes` has room for NAME_MODES_MOST, `count` says how many. Numbers of zeros that are
   certified are right; that there are no others rests on paths that were followed in doubles. */
int NAME_assembly_modes(const double *drives, NAME_mode *modes, int *count);

/* The mode led to other drives, by steps of which each is proved to stay on it: for all drives between, one solution
   lies in a box around it, bounded in doubles with their rounding: not to be compiled with -ffast-math. Refused, the
   mode stays as it was. */
int NAME_nearest_mode(NAME_mode *mode, const double *drives);
LEVEL_MODES
#ifdef __cplusplus
}
#endif

#endif
"""


LEVEL_MODES = """
/* Those modes whose platform is turned as in the reference, two at most, in closed form: `modes` has room for two. What
   is certified is that one solution so turned lies within `error`. Status 100: two are almost one, or may be. */
int NAME_level_modes(const double *drives, NAME_mode *modes, int *count);
"""


def _header(model: ModesModel, comment: Sequence[str]) -> list[str]:
    labels = ", ".join(f"{name} [{'m' if slides else 'rad'}]" for name, _, _, slides in model.drives)
    more = [
        name for name, column, *_ in singles(model.held.mechanism, model.held.network) if column in model.held.extra
    ]
    rest = f" Not looked at: {', '.join(more)}, which follow from the pose." if more else ""
    settled = [name for name, column, *_ in singles(model.held.mechanism, model.held.network)
               if column in {f.column for f in model.held.followers}]  # fmt: skip
    rest += f" Couplings settle {', '.join(settled)}." if settled else ""
    told = "".join(f"   {line}\n" for line in wrapped(f"{labels}.{rest}", width=LINE))
    level = LEVEL_MODES if closed_form(model.structure, model.held.drives).more else ""
    text = (
        HEADER.replace("LEVEL_MODES\n", f"{level}\n")
        .replace("TOLD", told)
        .replace("PLATFORM", model.held.body)
        .replace("GUARD", model.name.upper())
    )
    text = text.replace("NAME_MODES", f"{model.name.upper()}_MODES").replace("NAME_", f"{model.name}_")
    text = text.replace("DRIVES]", f"{len(model.drives)}]").replace("= DRIVES", f"= {len(model.drives)}")
    text = text.replace("WIDTH]", f"{model.equations.width}]").replace("= WIDTH", f"= {model.equations.width}")
    return [*comment, *text.replace("= PATHS", f"= {len(model.start.zeros)}").splitlines(), ""]


def _tables(model: ModesModel) -> list[str]:
    structure, equations, name = model.structure, model.equations, model.name
    bodies = list(structure.graph.cluster)
    steps = held_steps(structure)
    rows = [sum(_rows(structure, form.kind) for form in loop.forms) for loop in structure.loops]
    ways = [[(f.motion, f.back) for f in way] for way in equations.ways]
    hub, pairs = structure.graph.cluster[model.held.body], len(axis_pairs(structure))
    sizes = {
        "N_DRIVES": len(model.drives), "N_BODIES": len(bodies), "N_STEPS": len(steps),
        "N_SLOTS": len(structure.slots), "N_GROUPS": len(structure.groups), "N_LOOPS": len(structure.loops),
        "N_PAIRS": pairs, "N_NUMBERS": len(structure.slots) + 2 * pairs,
        "WIDTH": equations.width, "UNKNOWNS": equations.width - len(structure.groups),
        "LONGEST": max(map(len, ways)), "LARGEST_LOOP": max(rows), "N_PATHS": len(model.start.zeros),
        "N_FOLLOWERS": len(model.held.followers), "CROSSINGS": int(structure.crossings),
        "N_CHAIN": len(structure.chains.get(hub, ())), "PLATFORM_BODY": bodies.index(model.held.body),
        "PLANAR": int(structure.planar), "ONE_OF_EACH": int(bool(model.held.mechanism.limbs)),
        **LAYOUT,
    }  # fmt: skip
    lines = [f"#define {key} {value}" for key, value in sizes.items()]
    lines += [f"#define {key} {decimal(value)}" for key, value in NUMBERS.items()]
    lines += [f"#define SIZE {decimal(float(model.held.network.length))}", f"#define MODE {name}_mode"]
    lines += [f"#define MODES {name}_assembly_modes", f"#define NEAREST {name}_nearest_mode"]
    lines += [f"#define LEVEL {name}_level_modes"] if closed_form(structure, model.held.drives).more else []
    lines += [f"#define MODES_{status} {name.upper()}_MODES_{status}"
              for status in ("INCOMPLETE", "REFUSED", "NOT_CERTIFIED")]  # fmt: skip
    more = COUPLED if structure.spins else ()
    lines += [f"#define COUPLINGS {len(structure.spins)}"] if more else []
    for prefix, kinds in (("GROUP", (*KINDS, *more)), ("FORM", (*FORMS, *more)), ("SLOT", (*SLOTS, *more)),
                          ("STEP", ("turn", "slide", "still"))):  # fmt: skip
        lines.append(f"enum {{ {', '.join(f'{prefix}_{kind.upper()}' for kind in kinds)} }};")
    lines += [*c_array("int", "planar_place", [0, 3, 5, 6])]
    lines += _of_groups(structure, equations) + _of_loops(structure, ways)
    lines += _of_slots(structure, bodies, model.held.chosen) + _of_steps(structure, steps, bodies, model.held.chosen)
    lines += c_array("double", "drive_reference", [d[1] for d in model.drives])
    lines += c_array("double", "drive_unit", [d[2] for d in model.drives])
    lines += _of_followers(model.held) if model.held.followers else []
    lines += c_array("double", "frame", [[float(c) for c in row] for row in structure.frame])
    lines += c_array("double", "centre", [float(c) for c in structure.centre])
    lines += c_array("int", "platform_chain", structure.chains.get(hub, ()))
    return lines + _of_start(model)


def _rows(structure: Structure, kind: str) -> int:
    return {"meeting": 2 if structure.planar else 3, "parallel": 2}.get(kind, 1)


def _of_groups(structure: Structure, equations: BatchEquations) -> list[str]:
    """What couplings tie comes after the groups, with the coordinates of its own."""
    spins = [COUPLED[not spin.turning] for spin in structure.spins]
    kinds = [*(group.kind for group in structure.groups), *spins]
    lines = c_array("int", "group_kind", [(*KINDS, *COUPLED).index(kind) for kind in kinds])
    lines += c_array("int", "group_start", [part.start for part in equations.made_of])
    lines += c_array("int", "group_width", [part.stop - part.start for part in equations.made_of])
    lines += c_array("double", "spin_size", [float(spin.size) for spin in structure.spins]) if spins else []
    return lines + c_array("int", "group_slots", [[*g.slots, 0, 0][:2] for g in structure.groups])


def _of_loops(structure: Structure, ways: Sequence[Sequence[tuple[int, bool]]]) -> list[str]:
    forms = [form for loop in structure.loops for form in loop.forms]
    lines = c_array("int", "loop_first", np.cumsum([0, *map(len, ways)]).tolist())
    lines += c_array("int", "way_group", [group for way in ways for group, _ in way])
    lines += c_array("int", "way_back", [int(back) for way in ways for _, back in way])
    lines += c_array("int", "form_first", np.cumsum([0, *(len(loop.forms) for loop in structure.loops)]).tolist())
    lines += c_array("int", "form_kind", [(*FORMS, *COUPLED).index(form.kind) for form in forms])
    return lines + c_array("int", "form_slots", [[*form.slots, 0, 0, 0][:4] for form in forms])


def _of_slots(structure: Structure, bodies: Sequence[str], chosen: Sequence[int]) -> list[str]:
    own, second, at, other = list[int](), list[int](), list[list[float]](), list[list[float]]()
    for slot in structure.slots:
        ends = [(slot.body or bodies[0], slot.at), (bodies[0], None)]
        if slot.rod is not None:
            ends = [(body, place) for body, place in slot.rod]
        coupled = slot.kind in COUPLED
        own.append(bodies.index(ends[0][0]))
        second.append(chosen.index(slot.at) if coupled else bodies.index(ends[1][0]))
        at.append(_place(structure, slot.kind, None if coupled else ends[0][1]))
        other.append(_place(structure, slot.kind, ends[1][1]))
    lines = c_array("int", "slot_kind", [(*SLOTS, *COUPLED).index(slot.kind) for slot in structure.slots])
    lines += c_array("int", "slot_body", own) + c_array("int", "slot_second", second)
    return lines + c_array("double", "slot_at", at) + c_array("double", "slot_other", other)


def _place(structure: Structure, kind: str, at: Any) -> list[float]:
    if at is None:
        return [0.0, 0.0, 0.0]
    if kind == "number":
        return [float(at), 0.0, 0.0]
    return _axis(structure, at) if kind == "axis" else [float(c) for c in structure.local(at)]


def _axis(structure: Structure, axis: Any) -> list[float]:
    """As `Displacements` has it: the axis of a planar mechanism's hinge is its normal."""
    found = [float(c) for c in structure.turned(axis)]
    if structure.planar and not any(abs(c) > 0.5 for c in found):
        found = [0.0, 0.0, float(sum(a * b for a, b in zip(structure.frame[2], axis, strict=True)))]
    return found


def _of_steps(structure: Structure, steps: Sequence[Step], bodies: Sequence[str], chosen: Sequence[int]) -> list[str]:
    kinds = [2 if step.edge is None else int(step.edge.kind == "slide") for step in steps]
    held = [chosen.index(step.edge.columns[0]) if step.edge and step.edge.columns[0] in chosen else -1
            for step in steps]  # fmt: skip
    axes = [[0.0] * 3 if step.edge is None else _axis(structure, step.edge.axis) for step in steps]
    points = [
        [0.0] * 3 if step.edge is None else [float(c) for c in structure.local(step.edge.point)] for step in steps
    ]
    lines = c_array("int", "step_near", [bodies.index(step.near) for step in steps])
    lines += c_array("int", "step_far", [bodies.index(step.far) for step in steps])
    lines += c_array("int", "step_kind", kinds) + c_array("int", "step_held", held)
    lines += c_array("double", "step_sign", [float(step.sign) for step in steps])
    return lines + c_array("double", "step_axis", axes) + c_array("double", "step_point", points)


def _of_followers(held: Held) -> list[str]:
    """What couplings settle: sums of polynomials of displacements that come before."""
    terms = [(held.chosen.index(column), powers) for f in held.followers for column, powers in f.terms.items()]
    most = max((len(powers) for _, powers in terms), default=1)
    rows = [[*map(float, powers), *[0.0] * most][:most] for _, powers in terms]
    firsts = np.cumsum([0, *(len(f.terms) for f in held.followers)]).tolist()
    lines = [f"#define MOST_POWERS {most}", *c_array("int", "follower_first", firsts)]
    lines += c_array("int", "term_held", [place for place, _ in terms])
    return lines + c_array("double", "term_powers", rows or [[0.0]])


def _of_start(model: ModesModel) -> list[str]:
    """The general mechanism, its zeros in planes of their own, and how rows of points that meet are mixed."""
    structure, equations = model.structure, model.equations
    numbers = np.random.default_rng(SEED)
    patch = numbers.normal(size=equations.width) + 1j * numbers.normal(size=equations.width)
    zeros = model.start.zeros.copy()
    for part in equations.parts:
        patch[part] /= np.linalg.norm(patch[part])
        zeros[:, part] /= (zeros[:, part] @ patch[part])[:, None]
    slots = []
    for slot, value in zip(structure.slots, model.start.member, strict=True):
        if slot.kind == "distance":  # the square of the rod's length in place of |p|^2 + |a|^2 - L^2
            p, a = (np.asarray(model.start.member[k]) for k in slot.of)
            value = p @ p + a @ a - value
        slots.append(np.asarray(value) if np.ndim(value) else np.array([value, 0, 0]))
    pairs = axis_pairs(structure)
    slots += [p[:3] for w, u in pairs for p in spinors(slots[w], slots[u])]
    mixes = [np.linalg.qr(numbers.normal(size=(4, 4)))[0][:3].tolist() for _ in range(len(structure.loops) + 1)]
    lines = c_array("double", "path_mix", mixes) + c_array("double", "patch", _pairs(patch))
    lines += c_array("int", "pair_slots", [list(pair) for pair in pairs]) if pairs else []
    lines += c_array("double", "aside", ASIDE.tolist()) if pairs else []
    return (
        lines
        + c_array("double", "start_slots", _pairs(np.array(slots)))
        + c_array("double", "start_zeros", _pairs(zeros))
    )


def _pairs(values: Array) -> list[Any]:
    return list(np.stack([values.real, values.imag], axis=-1).tolist())
