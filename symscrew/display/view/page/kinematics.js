"use strict";

/* The mechanism as it moves: the generated functions called by name, assembly from sliders, sweeps, recordings. */
const Kinematics = (() => {
  const PERIOD = 6, FRAMES = 60;

  function make(data, functions) {
    const independent = data.independent;
    const reference = Float64Array.from(data.reference);
    const rates = data.v_kinds.length;

    /* A generated function with its arguments by name; what is not given is a parameter or zero. */
    function call(name, values) {
      const ports = data.functions[name].inputs;
      return functions[name](
        ...ports.map(([port, size]) => values[port] ?? (port === "p" ? data.parameters : new Float64Array(size))),
      );
    }
    const has = (name) => name in data.functions;

    // -- limits of joints: { at: entry of the displacements, label, low, high }, kept by sliders and sweeps --

    const displacements = (q) => (has("joint_displacements") ? call("joint_displacements", { q }).displacements : []);

    /* The first limit that a configuration leaves, or null. */
    function left(q) {
      if (data.limits.length === 0) {
        return null;
      }
      const found = displacements(q), within = 1e-9 * Math.max(1, data.length);
      return data.limits.find(({ at, low, high }) => found[at] < (low ?? -Infinity) - within || found[at] > (high ?? Infinity) + within) ?? null;
    }

    /* Columns of `size` numbers of an output. */
    function columns(array, size) {
      const made = [];
      for (let k = 0; k < array.length; k += size) {
        made.push(Array.from(array.slice(k, k + size)));
      }
      return made;
    }

    // -- sliders: angles and lengths as they are; components of a quaternion as those of a rotation vector --

    const groups = new Map();
    independent.forEach((entry, k) => {
      if (entry.quaternion !== null) {
        groups.set(entry.quaternion, [...(groups.get(entry.quaternion) ?? []), k]);
      }
    });

    function fromSliders(sliders) {
      const y = Array.from(sliders);
      for (const members of groups.values()) {
        const angle = Math.hypot(...members.map((k) => sliders[k]));
        const factor = angle > 1e-9 ? Math.sin(angle / 2) / angle : 0.5;
        members.forEach((k) => { y[k] = factor * sliders[k]; });
      }
      return y;
    }

    function toSliders(q) {
      const sliders = independent.map((entry) => q[entry.q]);
      for (const [start, members] of groups) {
        const sign = q[start] < 0 ? -1 : 1;
        const sine = Math.min(1, Math.hypot(...members.map((k) => sliders[k])));
        const factor = sine > 1e-9 ? (2 * Math.asin(sine)) / sine : 2;
        members.forEach((k) => { sliders[k] *= sign * factor; });
      }
      return sliders;
    }

    /* The configuration at slider values, from a guess; null where the loops do not close. */
    function assemble(sliders, guess) {
      const y = fromSliders(sliders);
      if (has("assemble")) {
        const found = call("assemble", { y, guess });
        return found.status === 0 ? found.q : null;
      }
      const q = Float64Array.from(guess);
      independent.forEach((entry, k) => { q[entry.q] = y[k]; });
      for (const [start, members] of groups) {
        q[start] = Math.sqrt(Math.max(0, 1 - members.reduce((sum, k) => sum + y[k] * y[k], 0)));
      }
      return q;
    }

    /* How far each slider goes from the reference with the others at rest: [low, high]; margins on the way. */
    function reach() {
      passed.length = 0;
      const free = left(reference) === null;  // a reference outside its limits keeps none on the way back to them
      const home = toSliders(reference);
      raise(reference);
      return independent.map((entry, k) => {
        const most = entry.quaternion !== null ? Math.PI / 2 : entry.kind === "length" ? data.length : Math.PI;
        const steps = entry.quaternion !== null ? 36 : 48;
        const ends = [-1, 1].map((side) => {
          let q = reference, last = home[k];
          const at = (value) => assemble(home.map((start, i) => (i === k ? value : start)), q);
          for (let step = 1; step <= steps; ++step) {
            const value = home[k] + (side * most * step) / steps, next = at(value);
            if (next === null) {
              break;
            }
            if (free && left(next) !== null) {
              last = limit(at, last, value);
              break;
            }
            [q, last] = [next, value];
            if (step % 4 === 0) {
              raise(q);
            }
          }
          passed.push(q);
          return last;
        });
        return ends;
      });
    }

    /* Where a slider meets the first limit, from a value within to one beyond. */
    function limit(at, within, beyond) {
      for (let step = 0; step < 40; ++step) {
        const middle = (within + beyond) / 2, q = at(middle);
        [within, beyond] = q !== null && left(q) === null ? [middle, beyond] : [within, middle];
      }
      return within;
    }

    const passed = [];  // configurations at the ends of all sliders

    // -- motions: { t, q, v, a, u, reactions } as arrays of frames --

    /* Drives and reactions of a state; null where the equilibrium is singular. */
    function loads(q, v, a) {
      if (!has("joint_reactions")) {
        return null;
      }
      const found = call("joint_reactions", { q, v, a });
      return found.status === 0 ? { u: found.u ?? new Float64Array(0), reactions: found.reactions } : null;
    }

    const still = () => new Float64Array(rates);

    /* The state at rest in a configuration. */
    function rest(q) {
      const found = loads(q, still(), still());
      return { q, v: still(), a: still(), u: found?.u ?? null, reactions: found?.reactions ?? null };
    }

    /* A periodic motion of one slider through its range (`which` = its index) or of all sliders (-1). */
    function sweep(which, ranges) {
      for (let amplitude = 0.85; amplitude > 0.01; amplitude *= 0.75) {
        const made = trySweep(sliderMotion(which, ranges, amplitude));
        if (made !== null) {
          return made;
        }
      }
      return null;
    }

    function sliderMotion(which, ranges, amplitude) {
      const home = toSliders(reference), omega = (2 * Math.PI) / PERIOD;
      return (t) => home.map((start, k) => {
        const [low, high] = ranges[k];
        if (which >= 0) {
          const middle = start + amplitude * ((low + high) / 2 - start), half = (amplitude * (high - low)) / 2;
          const phase = half > 0 ? Math.asin(Math.max(-1, Math.min(1, (start - middle) / half))) : 0;
          return k === which ? middle + half * Math.sin(omega * t + phase) : start;
        }
        const most = data.independent[k].kind === "length" ? Infinity : Math.PI / 4;
        const half = 0.6 * amplitude * Math.min(start - low, high - start, most);
        return start + half * Math.sin(omega * t + (Math.PI * k) / home.length);
      });
    }

    /* The motion that sliders as functions of time give; null where the loops do not close all the way. */
    function trySweep(sliders) {
      const h = PERIOD * 1e-4;
      const exact = (time, guess) => {
        const q = assemble(sliders(time), guess);
        if (q === null) {
          return null;
        }
        const [before, now, after] = [time - h, time, time + h].map((s) => fromSliders(sliders(s)));
        const y_dot = now.map((_, k) => (after[k] - before[k]) / (2 * h));
        const y_ddot = now.map((y, k) => (after[k] - 2 * y + before[k]) / (h * h));
        const v = call("velocity", { q, y_dot }).v;
        const a = call("acceleration", { q, v, y_ddot }).a;
        const found = loads(q, v, a);
        return { q, v, a, u: found?.u ?? null, reactions: found?.reactions ?? null };
      };
      const t = [...Array(FRAMES + 1).keys()].map((k) => (PERIOD * k) / FRAMES), frames = [];
      for (const time of t) {
        const state = exact(time, frames.at(-1)?.q ?? reference);
        if (state === null || (left(state.q) !== null && left(reference) === null)) {
          return null;
        }
        frames.push(state);
      }
      return { t, frames, exact, recorded: false };
    }

    /* The recorded motion of the page's data, accelerations by differences of its rates. */
    function recording() {
      const { arrays, frames: count } = data.motion;
      const read = (name) => {
        if (!(name in arrays)) {
          return null;
        }
        const bytes = Uint8Array.from(atob(arrays[name]), (c) => c.charCodeAt(0));
        const flat = new Float64Array(bytes.buffer), width = flat.length / count;
        return [...Array(count).keys()].map((k) => Float64Array.from(flat.slice(k * width, (k + 1) * width)));
      };
      const t = read("t").map((row) => row[0]), q = read("q"), v = read("v"), u = read("u"), reactions = read("reactions");
      const frames = t.map((_, k) => {
        const low = Math.max(0, k - 1), high = Math.min(count - 1, k + 1);
        const a = v[k].map((_, i) => (v[high][i] - v[low][i]) / (t[high] - t[low]));
        const found = reactions === null || u === null ? loads(q[k], v[k], a) : null;
        return { q: q[k], v: v[k], a, u: u?.[k] ?? found?.u ?? null, reactions: reactions?.[k] ?? found?.reactions ?? null };
      });
      return { t, frames, recorded: true, computed: { u: u === null, reactions: reactions === null } };
    }

    /* The state of a motion at a time: solved there, or between two recorded frames. */
    function at(motion, time) {
      const { t, frames } = motion;
      let high = t.findIndex((x) => x >= time);
      high = high < 0 ? t.length - 1 : Math.max(1, high);
      const low = high - 1, part = Math.max(0, Math.min(1, (time - t[low]) / (t[high] - t[low])));
      const mix = (name) => {
        const from = frames[low][name], to = frames[high][name];
        return from === null || to === null ? null : from.map((x, k) => x + part * (to[k] - x));
      };
      const solved = motion.exact?.(time, frames[part < 0.5 ? low : high].q);
      if (solved) {
        return solved;
      }
      const state = { q: mix("q"), v: mix("v"), a: mix("a"), u: mix("u"), reactions: mix("reactions") };
      for (const start of data.quaternions) {
        const size = Math.hypot(...state.q.slice(start, start + 4)) || 1;
        for (let k = start; k < start + 4; ++k) {
          state.q[k] /= size;
        }
      }
      return state;
    }

    // -- screws of a configuration --

    /* Rates of the tree that the closed loops allow, columns of length nv, decided by singular values. */
    function allowedRates(q) {
      const units = data.v_kinds.map((kind) => (kind === "length" ? data.length : 1));
      if (!has("closure_jacobian")) {
        return units.map((size, k) => units.map((_, i) => (i === k ? size : 0)));
      }
      const jacobian = columns(call("closure_jacobian", { q }).jacobian, data.functions.closure.outputs.residual.length);
      const rows = (jacobian[0] ?? []).map((_, i) => {
        const row = units.map((size, k) => jacobian[k][i] * size);
        return Screws.scale(1 / (Screws.norm(row) || 1), row);
      });
      return Screws.nullSpace(rows, rates).basis.map((column) => column.map((x, k) => x * units[k]));
    }

    /* Twists of the platform that the configuration allows, and their reciprocal wrenches. */
    function freedoms(q) {
      const jacobian = columns(call("platform_jacobian", { q }).jacobian, 6);
      return allowedRates(q)
        .map((rate) => jacobian.reduce((sum, column, k) => Screws.add(sum, Screws.scale(rate[k], column)), [0, 0, 0, 0, 0, 0]))
        .filter((twist) => Screws.norm([...Screws.scale(data.length, Screws.first(twist)), ...Screws.second(twist)]) > 1e-7 * data.length);
    }

    // -- margins from singularities: volumes as parts of those in the reference configuration, as in maps and reports;
    // one that is zero there has nothing to be compared with but the largest met in this page --

    const largest = data.margins.map(({ start }) => Math.abs(start));

    /* Everything that was known of the reference, anew: a parameter has changed. */
    function restart() {
      const found = margins(reference);
      data.margins.forEach((margin, k) => {
        margin.start = found[k] > 1e-9 ? found[k] : 0;
        largest[k] = margin.start;
      });
    }

    function margins(q) {
      return data.margins.map(({ function: name, entry }) => Math.abs(call(name, { q }).margins[entry]));
    }

    function raise(q) {
      margins(q).forEach((value, k) => { largest[k] = data.margins[k].start === 0 ? Math.max(largest[k], value) : largest[k]; });
    }

    /* The smallest margin: { value (1: as in the reference, 0: singular), name }; null if there is none. */
    function margin(q) {
      if (data.margins.length > 0) {
        raise(q);
        const parts = margins(q).map((value, k) => (largest[k] > 1e-12 ? value / largest[k] : 0));
        const value = Math.min(...parts);
        return { value, name: data.margins[parts.indexOf(value)].name };
      }
      if (has("assemble") && independent.length > 0) {
        const found = call("velocity", { q });
        const value = found.status === 1 ? 0 : found.guard * data.threshold;
        return Number.isFinite(value) ? { value, name: "pivots" } : null;
      }
      return null;
    }

    return {
      call, has, columns, reference, toSliders, assemble, reach, rest, sweep, recording, at, freedoms, raise, margin,
      displacements, left, passed, restart,
    };
  }

  return { make };
})();
