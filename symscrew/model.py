"""The pipeline on one page: from a mechanism and its effects to a model, a set of named programs.

mechanism --System--> tape, tree, frames, closure
          --functions of kinematics, momentum, dynamics--> nodes
          --lower, each when it is asked for--> straight-line programs --> export
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pickle import PicklingError
from typing import Any

import numpy as np

from symscrew import notebook
from symscrew.algebra import TapeMark, tape_mark
from symscrew.description import Mechanism, Reader
from symscrew.effects import Effect, Gravity, given_effects, system_under
from symscrew.errors import DescriptionError, did_you_mean, expect, shorten
from symscrew.functions import (
    SUFFIX,
    Assembly,
    Motion,
    SecondPath,
    assembly,
    ball_notes,
    checked_functions,
    closing_functions,
    closure_functions,
    coupling_functions,
    derivative_functions,
    dynamic_functions,
    effect_functions,
    fewest_in_mode,
    fewest_operations,
    forward_functions,
    kinematic_functions,
    known_function,
    left_out,
    loop_notes,
    margin_functions,
    momentum_functions,
    moves_mass,
    platform_functions,
    regressor_functions,
    rolling_functions,
    second_order_functions,
    second_paths,
    untried_notes,
)
from symscrew.garbage import nothing_to_collect
from symscrew.kinematics import System
from symscrew.loops import hub_links, operation_mode
from symscrew.program import (
    Asked,
    Function,
    Iteration,
    Program,
    RankRevealing,
    evaluate,
    evaluate_iteration,
    evaluate_rank_revealing,
    lower,
)

Declared = Function | Assembly | Program | Iteration


@dataclass(frozen=True, repr=False)
class Model:
    """Named programs of a mechanism with the effects that were asked for.

    `programs` of `derive` are lowered one by one when somebody asks for them, and are the same in any order; `declared`
    says what is known of a function without its program. `test_inputs[name]` holds, per input of function `name`, an
    array (states, size) of consistent states; `notes` says what a user must know (redundant constraints, passive
    freedoms, warnings of the description);
    `one_mode`: functions of closed loops are for the operation mode of the reference configuration only;
    `independent`: labels of the independent coordinates of a mechanism with loops; `selected`: the model has been
    left with some of its functions; `options`: how `derive` was asked, None of a model that it did not make.
    """

    name: str
    mechanism: Mechanism
    effects: tuple[Effect, ...]
    programs: Mapping[str, Program | Iteration]
    test_inputs: Mapping[str, tuple[np.ndarray, ...]]
    system: System
    notes: tuple[str, ...] = ()
    one_mode: bool = False
    independent: tuple[str, ...] = ()
    selected: bool = False
    options: Mapping[str, Any] | None = field(default=None, compare=False)

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy, in another process as well, is derived again: from mechanism and effects the same functions follow.

        Raises:
            PicklingError: a model whose functions others made than `derive`.
        """
        own = isinstance(self.programs, Asked) and isinstance(self.test_inputs, Asked)
        if self.options is None or not own or self.name != self.mechanism.name:
            raise PicklingError(
                f"{self.name}: expected a model as `derive` gives it, or less of it by `only`; others cannot be "
                "copied or sent to another process: derive it there"
            )
        names = tuple(self.programs) if self.selected else None
        return _again, (self.mechanism, self.effects, dict(self.options), names)

    def __repr__(self) -> str:
        """One line: the mechanism's size, the functions, and what they leave out."""
        bodies = sum(name != self.mechanism.ground for name in self.mechanism.bodies)
        free = len(self.independent) or len(self.system.tree.v)
        sizes = [(bodies, "body", "bodies"), (len(self.mechanism.joints), "joint", "joints")]
        sizes += [(free, "freedom", "freedoms"), (len(self.programs), "function", "functions")]
        parts = [f"{count} {one if count == 1 else many}" for count, one, many in sizes]
        parts += ["one operation mode"] if self.one_mode else []
        parts += ["a selection"] if self.selected else []
        return f"Model({self.name!r}, {', '.join(parts)})"

    def _repr_html_(self) -> str:
        rows = [
            (name, *(", ".join(f"{p.name}[{p.size}]" for p in ports) for ports in (f.inputs, f.outputs)), _total(f))
            for name, f in self.programs.items()
        ]
        return notebook.table(repr(self), ("function", "of", "gives", "operations"), rows)

    def only(self, names: Sequence[str]) -> Model:
        """The model with those functions of these names that it has, and no others.

        Names of functions that only other mechanisms have are passed over.

        Raises:
            DescriptionError: a name that no function has, or one text in place of names.
        """
        if isinstance(names, str):
            raise DescriptionError(f"expected names of functions, ({names!r},), got the text {names!r}")
        for name in names:
            if name not in self.programs and not (isinstance(name, str) and known_function(name)):
                near = did_you_mean(str(name), self.programs)
                raise DescriptionError(f"no function {shorten(name)} in {self.name}; {near}")
        if isinstance(self.programs, Asked):
            return replace(self, programs=self.programs.only(names), selected=True)
        kept = {name: program for name, program in self.programs.items() if name in names}
        return replace(self, programs=kept, selected=True)

    def declared(self, name: str) -> Declared:
        """Ports, notes and limbs out of reach of a function, for which nothing is lowered that was not yet."""
        known = self.programs.given.get(name) if isinstance(self.programs, Asked) else None
        return known if isinstance(known, Function | Assembly) else self.programs[name]

    @property
    def sample_q(self) -> np.ndarray:
        """q (samples, nq) at the system's sample states, from the functions' inputs: finding them again takes long."""
        at = self.test_inputs.get("closure_jacobian")
        return np.asarray(at[0]) if at is not None else self.system.sample_states[0]

    def __call__(self, function: str, *arguments: object) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
        """Evaluate a function on NumPy arrays (*batch, size): its results and the status.

        Raises:
            DescriptionError: a function that the model does not have.
        """
        if function not in self.programs:
            near = did_you_mean(str(function), self.programs)
            raise DescriptionError(f"no function {shorten(function)} in {self.name}; {near}")
        program = self.programs[function]
        if isinstance(program, Iteration):
            return evaluate_iteration(program, arguments)
        if isinstance(program, RankRevealing):
            return evaluate_rank_revealing(program, arguments)
        return evaluate(program, arguments)


def _again(
    mechanism: Mechanism, effects: tuple[Effect, ...], options: dict[str, Any], names: tuple[str, ...] | None
) -> Model:
    """A model as it was derived once, or some of it."""
    model = derive(mechanism, effects, **options)
    return model if names is None else model.only(names)


@nothing_to_collect()
def derive(
    mechanism: Mechanism,
    effects: Sequence[Effect] = (Gravity(),),
    *,
    independent: Sequence[str] | None = None,
    length: Any = None,
    derivatives: bool = False,
    second_derivatives: bool = False,
    regressor: bool = False,
    one_mode: bool = False,
    checked: bool = False,
) -> Model:
    """The model of a mechanism: every function, for every mechanism, by the same path.

    `independent` names the independent coordinates y by labels of q (default: the platform's own where it
    hangs on one joint, else the drives). `length` [m] is the characteristic length by which norms of mixed
    quantities divide lengths: a number or text with an expression of the parameters, in place of the description's.
    `derivatives` adds the derivatives of the dynamic functions, the larger part of the code where it is given,
    `second_derivatives` products with the Hessians of drives, accelerations, closure and margins, and these Hessians,
    `regressor` the regressors of the inertial parameters. `one_mode`: functions of closed loops for the operation
    mode of the reference configuration only, where coordinates that follow from others are not read; they fail
    elsewhere (see `symscrew.loops.modes`). `checked` adds `<function>_checked`, which look whether q, v and a are of
    the mechanism, and fail where they are not (see `symscrew.functions.checked`).
    A simplification that is only wanted where it saves operations is undone where it does not, see `Effect.undone`.
    Raises DescriptionError for names that do not exist and for a length that is not positive.
    """
    expect(mechanism, Mechanism)
    if length is not None:
        read = Reader(dict(mechanism.parameters)).characteristic_length(length)
        mechanism = replace(mechanism, characteristic_length=read)
    known = given_effects(effects)
    further = {
        "derivatives": derivatives, "second_derivatives": second_derivatives, "regressor": regressor,
        "one_mode": one_mode, "checked": checked,
    }  # fmt: skip
    options = {"independent": None if independent is None else tuple(independent), **further}
    plain = _where_they_save(mechanism, known, independent) if any(effect.undone() for effect in known) else None
    if plain and not any(further.values()):
        return replace(plain, options=options)
    made = _derived(mechanism, plain.effects if plain else known, independent=independent, **further)
    return replace(made, options=options)


def _where_they_save(mechanism: Mechanism, effects: tuple[Effect, ...], independent: Sequence[str] | None) -> Model:
    """The model, with what effects leave out left in if any function takes more operations without it."""
    undone = tuple(effect.undone() or effect for effect in effects)
    less, whole = (_derived(mechanism, some, independent=independent) for some in (effects, undone))
    sizes = [(_total(p), _total(whole.programs[name])) for name, p in less.programs.items() if name in whole.programs]
    return less if all(without <= before for without, before in sizes) else whole


def _total(program: Program | Iteration) -> int:
    return program.operations["total"]


def _derived(
    mechanism: Mechanism,
    effects: tuple[Effect, ...],
    *,
    independent: Sequence[str] | None,
    derivatives: bool = False,
    second_derivatives: bool = False,
    regressor: bool = False,
    one_mode: bool = False,
    checked: bool = False,
) -> Model:
    system = system_under(mechanism, effects)
    if system.structure.rolled and (derivatives or second_derivatives):
        raise DescriptionError(
            "effects: derivatives along the independent coordinates are not known where rolling constrains rates "
            "alone; derive without them, or take 'rolling_contact'"
        )
    system.use_samples()
    ways = fewest_operations(system, effects, independent)
    loops = ways.plain
    mode = operation_mode(system, loops.free)
    if one_mode:
        ways = fewest_in_mode(ways, mode, effects, independent)
    motion = Motion(system)
    functions = [
        *kinematic_functions(system, motion),
        *closure_functions(system, ways.rates, loop_notes(loops)),
        *momentum_functions(system, motion, effects),
        *dynamic_functions(system, effects, ways.rates),
        *coupling_functions(system, effects, ways.dynamics),
        *rolling_functions(system, effects, ways.dynamics),
        *forward_functions(system, effects, ways.dynamics),
        *closing_functions(system, loops),
        *platform_functions(system, effects, loops, checked=checked),
        *effect_functions(system, effects, loops),
    ]
    if regressor:
        functions += regressor_functions(system, effects, loops)
    if derivatives:
        functions += derivative_functions(system, effects, loops, functions)
    if second_derivatives:
        functions += second_order_functions(system, loops, [*functions, *margin_functions(system)])
    if checked:
        functions += checked_functions(system, functions)
    if one_mode:
        functions = [mode.alone(function) for function in functions]
    declared: dict[str, Function | Assembly] = {f.name: f for f in functions}
    seconds: dict[str, SecondPath] = {}
    if system.cuts:
        declared["assemble"] = assembly(system, loops)
        seconds = second_paths(system, effects, loops)
    declared |= {f.name: f for f in margin_functions(system)}
    entries, states = [entry.q for entry in loops.entries], system.sample_states
    inputs = Asked(declared, lambda function: inputs_at(system, function, states, entries))
    moves = "forward_dynamics" in declared or moves_mass(system, effects, loops)
    massless = () if moves else (left_out(system),)
    notes = (*mechanism.warnings, *massless, *ball_notes(system), *untried_notes(system))
    notes = (*notes, *mode.notes(alone=one_mode))
    notes = (*notes, *(note for effect in effects for note in effect.notes))
    notes = (*notes, *dict.fromkeys(n for p in declared.values() for n in p.notes))
    labels = tuple(system.tree.q[k].label for k in entries) if system.cuts else ()
    programs = Asked(declared, partial(_lowered, tape_mark(system.tape), seconds))
    return Model(mechanism.name, mechanism, effects, programs, inputs, system, notes, one_mode, labels)


@nothing_to_collect()
def _lowered(mark: TapeMark, seconds: Mapping[str, SecondPath], function: Function | Assembly) -> Program | Iteration:
    """The program of a function, with its second path if it has one; as if nothing had been made after the mark."""
    if isinstance(function, Assembly):
        return function.lowered(mark)
    second = seconds.get(function.name.removesuffix(SUFFIX))
    program = lower(function, mark)
    return second.behind(program, mark) if second else program


def _hub_entries(system: System, of_q: bool) -> list[int]:
    links = hub_links(system) or ()
    slices = [link.q if of_q else link.v for link in links]
    return [k for part in slices for k in range(part.start, part.stop)]


def inputs_at(
    system: System,
    function: Declared,
    states: tuple[np.ndarray, np.ndarray, np.ndarray],
    independent: Sequence[int] = (),
) -> tuple[np.ndarray, ...]:
    """Every input of a function at consistent states (q, v, a) of the tree; what is free is random, but repeatable.

    `independent`: indices of y in q, for functions that take y.
    """
    q, v, a = states
    random = np.random.default_rng(7)
    known = {
        "q": q,
        "v": v,
        "a": a,
        "y": q[:, list(independent)],
        "guess": np.repeat(system.reference[None, :], len(q), 0),
    }
    for name, source in (("pose", known["q"]), ("rate", v), ("acceleration", a)):
        known[name] = source[:, _hub_entries(system, name == "pose")]
    known["p"] = np.repeat(system.parameter_values[None, :], len(q), 0)
    if function.name in ("closure", "close_position"):  # on the manifold: rounding noise
        known["q"] = system.advance(q, 0.1 * random.uniform(-1, 1, v.shape))
    result = []
    for port in function.inputs:
        if port.name not in known:
            low = 0.5 if port.name == "weights" else -1.0
            known[port.name] = random.uniform(low, 1.5, (len(q), port.size))
        result.append(known[port.name])
    return tuple(result)
