"""Contacts of a compiled run: the loop finds where a mode ends, the laws say what happens there, and it goes on.

loop --EVENT--> state, contact --mode_changes--> rates, modes --> loop
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.scene import Scene
from symscrew.simulation.complementarity import UndecidedError
from symscrew.simulation.contacts import ContactState, Law, Modes, forces, laws, start_modes
from symscrew.simulation.mode_changes import Change, beginning, change, onto_stops
from symscrew.simulation.recording import State, shown_time
from symscrew.simulation.start_branch import OF_NO_BRANCH, impact_leaves_every_branch
from symscrew.simulation.state_programs import Plant

MOST_EVENTS = 10_000  # a run with more changes of contact is stopped and says so: chattering, not motion
OVERRUN, BROKEN, UNDECIDED = 9, 5, 10  # outcomes: too many changes, no accelerations at one, no rates behind one


class NoAccelerationsError(ArithmeticError):
    """The state has no accelerations, so that no law of a contact says anything there."""


class Loop(Protocol):
    """What is asked of a compiled loop."""

    plant: Plant

    def accelerations(self, t: float, state: State, forces: np.ndarray) -> np.ndarray:
        """Accelerations (nv,) by given forces of the contacts."""

    def change(self, q: np.ndarray, v: np.ndarray, modes: tuple[int, ...]) -> int:
        """Go on from another state and other modes."""

    def report(self) -> tuple[float, State, dict[str, float]]:
        """Time, state and counters now."""


class NativeContacts:
    """Modes of the contacts of one run over time, and what happened."""

    def __init__(self, library: Loop, scene: Scene, start: State) -> None:
        """Modes at the start; stops that the joints move into are met at once: `start` is the state behind that.

        Raises:
            DescriptionError: a joint starts beyond its stop, or a method that does not look for events.
        """
        self.library, self.start = library, start
        plant = library.plant
        found = [c for e in plant.model.effects for c in e.contacts()] if plant.outside else []
        self.rules: tuple[Law, ...] = laws(plant.model, found, plant.parameters)
        self.modes = Modes(())
        self.course: list[tuple[float, Modes]] = []
        self.events: tuple[str, ...] = ()
        self.losses: tuple[tuple[float, str, float], ...] = ()
        if self.rules and scene.integrator.method != "dop853":
            raise DescriptionError(
                f"integrator.method: contacts with events need dop853 or radau, got {scene.integrator.method}"
            )

    def at(self, t: float, state: State) -> ContactState:
        """The contacts at a state."""
        q, v, x = state

        def answers(v: np.ndarray, force: np.ndarray) -> np.ndarray:
            found = self.library.accelerations(t, (q, v, x), force)
            if not np.isfinite(found).all():
                raise NoAccelerationsError
            return found

        return ContactState(self.rules, q, v, self.library.plant.units, answers)

    def begun(self, going_on: int) -> int:
        """Modes and rates at the start, handed to the loop; the outcome."""
        if not self.rules:
            return going_on
        self.modes = start_modes(self.at(0.0, self.start))
        return self._behind(0.0, self.start, lambda at: beginning(at, self.modes), going_on)

    def met(self, going_on: int) -> int:
        """What follows the end of a mode, handed to the loop; the outcome."""
        t, state, counters = self.library.report()
        if len(self.course) > MOST_EVENTS:
            return OVERRUN
        return self._behind(t, state, lambda at: change(at, self.modes, int(counters["event"])), going_on)

    def _behind(self, t: float, state: State, law: Callable[[ContactState], Change], going_on: int) -> int:
        try:
            found = law(self.at(t, state))
            if found.losses and impact_leaves_every_branch(self.library.plant, state[0], found.v):
                raise UndecidedError(OF_NO_BRANCH)
        except UndecidedError as error:
            self.events += (f"t = {shown_time(t)} s: {error}",)
            return UNDECIDED
        except NoAccelerationsError:
            return BROKEN
        return self._adopted(t, state, found, going_on)

    def _adopted(self, t: float, state: State, found: Change, going_on: int) -> int:
        if not np.isfinite(found.v).all():
            return BROKEN
        self.modes = found.modes
        self.course.append((t, found.modes))
        self.events += tuple(f"t = {shown_time(t)} s: {text}" for text in found.texts)
        self.losses += tuple((t, name, loss) for name, loss in found.losses.items())
        q = onto_stops(self.at(t, state), found.modes.values, state[0])
        return going_on if self.library.change(q, found.v, found.modes.values) == 0 else BROKEN

    def forces(self, times: np.ndarray, q: np.ndarray, v: np.ndarray, x: np.ndarray) -> np.ndarray | None:
        """Contact forces (n, contacts) at samples, in the modes of their times; at an instant those before it."""
        if not self.rules:
            return None
        if not self.course:  # it could not begin
            return np.full((len(times), len(self.rules)), np.nan)
        ends = np.array([t for t, _ in self.course[1:]] + [np.inf])
        result = []
        for t, *state in zip(times, q, v, x, strict=True):
            modes = self.course[int(np.searchsorted(ends, t, side="left"))][1]
            try:
                result.append(forces(self.at(float(t), (state[0], state[1], state[2])), modes))
            except NoAccelerationsError:  # where the run stopped
                result.append(np.full(len(self.rules), np.nan))
        return np.array(result).reshape(len(times), len(self.rules))
