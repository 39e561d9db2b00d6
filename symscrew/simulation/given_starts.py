"""Starts of many runs of one scene: arrays by name, checked as a whole before anything is computed.

    archive (.npz) --read_archive--> arrays by name --starts_of--> Starts --scene_of(k)--> one run

    initial.coordinates.LABEL, initial.rates.LABEL   (n,): in place of, or beside, those of the scene, in SI units
    parameters.NAME                                  (n,): run-time parameters in place of the scene's
    q, v, x   (n, nq), (n, nv), (n, nx): whole states on the closed loops, in place of coordinates and rates

What a scene says by expressions in parameters (a start, a table) was read with the scene's own values of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from symscrew.errors import DescriptionError, did_you_mean, shorten
from symscrew.kinematics import coordinate_units, full_name, nearest_names, typable_names
from symscrew.model import Model
from symscrew.scene import Scene
from symscrew.simulation.state_programs import Plant

COORDINATES, RATES, PARAMETERS = "initial.coordinates.", "initial.rates.", "parameters."
WHOLE = ("q", "v", "x")
# Opening of the loops, rates that miss them and lengths of quaternions, without units, up to which a whole state is
# taken as one on the loops: what a file of seven digits leaves. The loop takes the rest away; more would be another
# start than the one that was given.
ON_THE_LOOPS = 1e-6


@dataclass(frozen=True)
class Starts:
    """What differs from run to run, n of them: values by label (n,), whole states by letter (n, size)."""

    scene: Scene
    count: int
    coordinates: Mapping[str, np.ndarray] = field(default_factory=dict)
    rates: Mapping[str, np.ndarray] = field(default_factory=dict)
    parameters: Mapping[str, np.ndarray] = field(default_factory=dict)
    whole: Mapping[str, np.ndarray] = field(default_factory=dict)

    def scene_of(self, k: int) -> Scene:
        """The scene of run k, as it would stand in a file of its own."""
        initial = self.scene.initial
        at = {label: float(values[k]) for label, values in self.coordinates.items()}
        rates = {label: float(values[k]) for label, values in self.rates.items()}
        initial = replace(initial, coordinates={**initial.coordinates, **at}, rates={**initial.rates, **rates})
        given = {name: float(values[k]) for name, values in self.parameters.items()}
        return replace(self.scene, initial=initial, parameters={**self.scene.parameters, **given})

    def parameters_of(self, k: int, plant: Plant) -> np.ndarray:
        """Values of the run-time parameters of run k (np,), in the program's order."""
        names = [p.name for p in plant.model.mechanism.parameters.values() if p.run_time]
        values = np.array(plant.parameters)
        for name, given in self.parameters.items():
            values[names.index(name)] = given[k]
        return values

    def whole_state(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """q and v of run k, where they are given."""
        return np.array(self.whole["q"][k]), np.array(self.whole["v"][k])


def starts_of(scene: Scene, model: Model, plant: Plant, arrays: Mapping[str, np.ndarray]) -> Starts:
    """The starts that arrays by name say, see the module.

    Raises:
        DescriptionError: no arrays, one that this scene has no use for, one of another shape, with other than real
            finite numbers, or of another number of runs than those before it.
    """
    known = _sizes(scene, model, plant)
    if not arrays:
        raise DescriptionError(f"starts: expected arrays such as {next(iter(known))}, got none")
    found: dict[str, np.ndarray] = {}
    count, first = 0, ""
    for name, given in arrays.items():
        where = f"starts: `{shorten(name)[1:-1]}`"
        values = _numbers(given, where)
        columns = known.get(name, -1) if name in known else _named(model, name, known)
        if values.ndim != (1 if columns == 0 else 2) or (columns and values.shape[1] != columns):
            wanted = "(runs,)" if columns == 0 else f"(runs, {columns})"
            raise DescriptionError(f"{where}: expected an array {wanted}, got one of {values.shape}")
        if first and len(values) != count:
            raise DescriptionError(f"{where}: expected {count} runs as in `{first}`, got {len(values)}")
        if not len(values):
            raise DescriptionError(f"{where}: expected at least one run, got none")
        bad = np.flatnonzero(~np.isfinite(values.reshape(len(values), -1)).all(axis=1))
        if len(bad):
            raise DescriptionError(f"{where}: expected finite numbers, got {values[bad[0]]} in run {bad[0]}")
        count, first, found[name] = len(values), first or name, values
    _together(found)

    def those(start: str) -> dict[str, np.ndarray]:
        return {name.removeprefix(start): values for name, values in found.items() if name.startswith(start)}

    whole = {name: values for name, values in found.items() if name in WHOLE}
    return Starts(scene, count, those(COORDINATES), those(RATES), those(PARAMETERS), whole)


def _sizes(scene: Scene, model: Model, plant: Plant) -> dict[str, int]:
    """Names of arrays and how many columns they have; 0: none, one value a run."""
    tree = model.system.tree
    names = [COORDINATES + c.label for c in tree.q] + [RATES + c.label for c in tree.v]
    names += [PARAMETERS + p.name for p in model.mechanism.parameters.values() if p.run_time]
    sizes = dict.fromkeys(names, 0) | {"q": plant.sizes["q"], "v": plant.sizes["v"]}
    states = plant.sizes["x"] - int(plant.works)
    return sizes | ({"x": states} if states else {})


def _named(model: Model, name: str, known: Mapping[str, int]) -> int:
    """0 for a coordinate or a rate of one that is not of the tree, such as a pose of the platform; else an error."""
    for start, what in ((COORDINATES, "coordinate"), (RATES, "rate")):
        if name.startswith(start):
            label, own = name.removeprefix(start), [n.removeprefix(start) for n in known if n.startswith(start)]
            if full_name(model.mechanism, label) in coordinate_units(model.mechanism):
                return 0
            near = nearest_names(label, [*own, *typable_names(model.mechanism)])
            raise DescriptionError(f"starts: there is no {what} {shorten(label)}; {near}")
    raise DescriptionError(f"starts: this scene has no use for an array {shorten(name)}; {did_you_mean(name, known)}")


def _numbers(given: object, where: str) -> np.ndarray:
    values = np.asarray(given)
    if values.dtype.kind not in "biuf":
        raise DescriptionError(f"{where}: expected real numbers, got {shorten(str(values.dtype))}")
    return np.asarray(values, dtype=float)


def _together(found: Mapping[str, np.ndarray]) -> None:
    """Raises DescriptionError where arrays contradict each other."""
    if ("q" in found) != ("v" in found):
        one, other = ("q", "v") if "q" in found else ("v", "q")
        raise DescriptionError(
            f"starts: `{one}` is there without `{other}`: a whole state is both, rates of rest are 0"
        )
    if "x" in found and "q" not in found:
        raise DescriptionError(
            "starts: `x` goes with whole states `q` and `v`; without, states begin as the scene says"
        )
    more = [name for name in found if name.startswith((COORDINATES, RATES))]
    if "q" in found and more:
        raise DescriptionError(f"starts: `q` and `v` say all of a start; leave `{more[0]}` out, or them")


def off_the_loops(plant: Plant, q: np.ndarray, v: np.ndarray) -> str:
    """Why a whole state is none of the mechanism; "" where it is one."""
    tree, units = plant.system.tree, plant.units
    for start, _ in tree.spheres:
        size = float(np.linalg.norm(q[start : start + 4]))
        if abs(size - 1) > ON_THE_LOOPS:
            return f"the quaternion {tree.q[start].label.rpartition('.')[0]} has the length {size:.9g}, not 1"
    if plant.closure is None:
        return ""
    given = [plant.parameters] if len(plant.closure.inputs) > 1 else []
    (residual,), _ = plant.model("closure", q, *given)
    opening = float(np.abs(residual * plant.rows).max(initial=0.0))
    if not opening <= ON_THE_LOOPS:
        return f"the loops are open by {opening:.3g} (lengths by the characteristic length)"
    (jacobian,), _ = plant.model("closure_jacobian", q, *given)
    matrix = jacobian.reshape(len(units), len(plant.rows)).T * plant.rows[:, None] * units
    missed = float(np.abs(matrix @ (v / units)).max(initial=0.0))
    if not missed <= ON_THE_LOOPS * max(1.0, float(np.abs(v / units).max(initial=0.0))):
        return f"the loops do not allow these rates: they miss by {missed:.3g} without units"
    return ""
