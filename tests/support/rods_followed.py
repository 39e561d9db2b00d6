"""A platform on rods led along a motion in small steps, by points alone: what a certified step is held against."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]


def turned_by(v: Array) -> Array:
    """Rodrigues' formula."""
    angle = float(np.linalg.norm(v))
    hat = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * hat + 0.5 * np.sinc(angle / 2 / np.pi) ** 2 * hat @ hat)


@dataclass(frozen=True)
class Rods:
    """`ends`: of drives, (ends of rods (n, 3), their lengths); `tips`: on the platform in the reference."""

    ends: Callable[[Array], tuple[Array, Array]]
    tips: Array
    planar: bool

    def equations(self, turn: Array, shift: Array, drives: Array) -> tuple[Array, Array]:
        """Half the squares of distances less those of lengths, and their derivative by the platform's twist."""
        ends, lengths = self.ends(drives)
        arm = self.tips @ turn.T
        way = arm + shift - ends
        slopes = np.hstack([way, np.cross(arm, way)])
        return 0.5 * ((way**2).sum(axis=1) - lengths**2), slopes[:, [0, 1, 5]] if self.planar else slopes

    def follow(self, turn: Array, shift: Array, start: Array, goal: Array) -> tuple[Array, Array, bool]:
        """(turn, shift, whether no singularity was met) at the end of a straight motion of the drives."""
        size, sign = np.abs(self.tips).max(), np.sign(np.linalg.det(self.equations(turn, shift, start)[1]))
        done, step = 0.0, 0.02
        while done < 1 and step > 1e-7:
            step = min(step, 1 - done)
            new, steps = (turn, shift), list[float]()
            for _ in range(4):
                value, slopes = self.equations(*new, start + (goal - start) * (done + step))
                change = np.zeros(6)
                change[[0, 1, 5] if self.planar else slice(6)] = -np.linalg.solve(slopes, value)
                steps.append(float(np.abs(change).max() / size))
                if steps[0] > 0.01:
                    break
                new = turned_by(change[3:]) @ new[0], new[1] + change[:3]
            good = steps[0] <= 0.01 and steps[1] < 0.05 * steps[0] + 1e-13 and steps[-1] < 1e-10
            good = good and np.sign(np.linalg.det(slopes)) == sign
            if good:
                (turn, shift), done, step = new, done + step, 1.7 * step
            else:
                step *= 0.4
        return turn, shift, done >= 1

    def worst(self, turn: Array, shift: Array, drives: Array) -> Array:
        """The direction of drives in which the platform moves most: towards or away from a singularity."""
        left = np.linalg.svd(self.equations(turn, shift, drives)[1])[0][:, -1]
        rates = [
            (self.equations(turn, shift, drives + d)[0] - self.equations(turn, shift, drives - d)[0]) @ left
            for d in 1e-6 * np.eye(len(drives))
        ]
        return np.asarray(rates / np.linalg.norm(rates))


def delta() -> Rods:
    """`delta` of the catalogue."""
    turns = 2 * np.pi * np.repeat(np.arange(3), 2) / 3
    out = np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    across = 0.04 * np.tile([1, -1], 3)[:, None] * np.stack([-np.sin(turns), np.cos(turns), 0 * turns], axis=1)
    down = np.array([0.0, 0.0, 1.0])

    def ends(d: Array) -> tuple[Array, Array]:
        a = np.repeat(d, 2)[:, None]
        return (0.2 + 0.3 * np.cos(a)) * out + across - 0.3 * np.sin(a) * down, np.full(6, 0.7)

    return Rods(ends, 0.05 * out + across - np.sqrt(0.7**2 - 0.45**2) * down, False)
