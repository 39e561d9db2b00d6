"""The Panda's dynamics as a good engineer writes them by hand in CasADi."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from symscrew import catalogue


def newton_euler(q: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
    """Torques of the Panda by the recursive Newton-Euler algorithm in link frames (Featherstone 2008, table 5.1)."""
    mechanism = catalogue.load("panda")
    joints = list(mechanism.joints.values())

    def number(x: Any) -> float:
        return float(mechanism.number(x))

    points = [np.array([number(c) for c in j.point]) for j in joints]
    axes = [np.array([number(c) for c in j.axes[0]]) for j in joints]
    angular, linear, turn = ca.SX.zeros(3), ca.SX([0, 0, 9.81]), []
    omega = ca.SX.zeros(3)
    forces, moments = [], []
    for k, joint in enumerate(joints):
        body = mechanism.bodies[joint.child]
        c, s, e = ca.cos(q[k]), ca.sin(q[k]), ca.DM(axes[k])
        cross = ca.DM([[0, -axes[k][2], axes[k][1]], [axes[k][2], 0, -axes[k][0]], [-axes[k][1], axes[k][0], 0]])
        rotation = ca.DM.eye(3) + s * cross + (1 - c) * (cross @ cross)
        turn.append(rotation)
        arm = ca.DM(points[k] - (points[k - 1] if k else np.zeros(3)))
        moved = linear + ca.cross(angular, arm) + ca.cross(omega, ca.cross(omega, arm))
        linear, before = rotation.T @ moved, rotation.T @ omega
        angular = rotation.T @ angular + ca.cross(before, e * v[k]) + e * a[k]
        omega = before + e * v[k]
        com = ca.DM([number(x) for x in body.com]) - ca.DM(points[k])
        inertia = ca.DM(np.array([[number(x) for x in row] for row in body.inertia]))
        mass = number(body.mass)
        force = mass * (linear + ca.cross(angular, com) + ca.cross(omega, ca.cross(omega, com)))
        forces.append(force)
        moments.append(inertia @ angular + ca.cross(omega, inertia @ omega) + ca.cross(com, force))
    torques = [None] * len(joints)
    force, moment = ca.SX.zeros(3), ca.SX.zeros(3)
    for k in reversed(range(len(joints))):
        force, moment = force + forces[k], moment + moments[k]
        torques[k] = ca.dot(ca.DM(axes[k]), moment)
        arm = ca.DM(points[k] - (points[k - 1] if k else np.zeros(3)))
        force = turn[k] @ force
        moment = turn[k] @ moment + ca.cross(arm, force)
    return ca.vertcat(*torques)
