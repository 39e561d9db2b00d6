"""Radii of the seed by gradients through its loops, over 10,000 poses at once; needs JAX (pip install ".[jax]").

Run it: python examples/jax/design_by_gradient.py

The cost is the mean square of the drive forces [N^2] in poses up to 10 degrees from the upright one, moving, with the
radii R of the base and r of the platform free. Its gradient goes through the assembly of the loops, the rates and the
accelerations, exactly; SciPy's L-BFGS-B takes it, within bounds.
"""

import importlib.util
import tempfile
from dataclasses import replace
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
from scipy.optimize import minimize

import symscrew

jax.config.update("jax_enable_x64", True)
POSES, STEPS = 10_000, 8
mechanism = symscrew.load_catalogue("three_ups_upu_s_physical")
free = {name: replace(p, run_time=name in ("R", "r")) for name, p in mechanism.parameters.items()}
model = symscrew.derive(replace(mechanism, parameters=free))
model = model.only(["assemble", "velocity", "acceleration", "inverse_dynamics"])
with tempfile.TemporaryDirectory() as folder:
    symscrew.generate(model, folder, targets=["jax"])
    spec = importlib.util.spec_from_file_location("seed", Path(folder) / f"{model.name}_jax.py")
    seed = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(seed)

rng = np.random.default_rng(1)
tilt, azimuth = rng.uniform(0, np.radians(10), POSES), rng.uniform(0, 2 * np.pi, POSES)
y = np.sin(tilt / 2)[:, None] * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)  # limb5_S.qx, limb5_S.qy
y_dot, y_ddot = rng.normal(0, 0.3, (POSES, 2)), rng.normal(0, 3.0, (POSES, 2))
guess = model.system.reference


def cost(radii):
    """Mean square of the drives [N^2], and of each pose whether it can be assembled."""
    q = seed.assemble(y, guess, radii)
    v = seed.velocity(q.q, y_dot, radii)
    a = seed.acceleration(q.q, v.v, y_ddot, radii)
    u = seed.inverse_dynamics(q.q, v.v, a.a, radii)
    sound = (q.status == 0) & (u.status == 0)
    return jnp.where(sound[:, None], u.u**2, 0.0).sum() / sound.sum(), sound


priced_by_jax = jax.jit(jax.value_and_grad(cost, has_aux=True))  # compiled once, for all that follows


def priced(x):
    """Cost and gradient by radii in cm, of which SciPy's first step is about one."""
    (found, _), slope = priced_by_jax(x / 100)
    return float(found), np.asarray(slope) / 100


# the gradient against differences of the cost: of fourth order, so that they carry eight digits
radii = np.array([80.0, 50.0])  # R, r [cm]: the paper's
before, slope = priced(radii)
ends = [priced(radii + np.array([moved, 0.0]))[0] for moved in (-0.2, -0.1, 0.1, 0.2)]
differences = (ends[0] - 8 * ends[1] + 8 * ends[2] - ends[3]) / 1.2
assert abs(slope[0] - differences) < 1e-6 * abs(differences)

limits = [(75, 85), (45, 55)]
found = minimize(priced, radii, jac=True, method="L-BFGS-B", bounds=limits, options={"maxiter": STEPS})
(_, sound), _ = priced_by_jax(found.x / 100)
print(f"R = {found.x[0]:.2f} cm, r = {found.x[1]:.2f} cm: mean square {before:.1f} -> {found.fun:.1f} N^2")
print(f"{int(sound.sum())} of {POSES} poses assembled, {found.nfev} gradients")
assert found.fun < before and sound.all()
