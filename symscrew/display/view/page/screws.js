"use strict";

/*
 * Screw systems as numbers. A screw is six numbers (first ; second at O): a twist (omega ; v_O) or a wrench
 * (f ; m_O). Lengths are divided by a characteristic length before ranks are decided.
 */
const Screws = (() => {
  const RANK = 1e-7;
  const { Matrix, SingularValueDecomposition, EigenvalueDecomposition } = library;

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const add = (a, b) => a.map((x, k) => x + b[k]);
  const subtract = (a, b) => a.map((x, k) => x - b[k]);
  const scale = (s, a) => a.map((x) => s * x);
  const norm = (a) => Math.hypot(...a);
  const unit = (a) => scale(1 / (norm(a) || 1), a);
  const first = (screw) => Array.from(screw.slice(0, 3));
  const second = (screw) => Array.from(screw.slice(3, 6));

  /* Singular values and all right singular vectors of rows of length n, largest first. */
  function decompose(rows, n) {
    const padded = rows.map((row) => Array.from(row));
    while (padded.length < n) {
      padded.push(new Array(n).fill(0));
    }
    const found = new SingularValueDecomposition(new Matrix(padded), { computeLeftSingularVectors: false });
    const vectors = found.rightSingularVectors;
    return { values: found.diagonal.slice(0, n), vectors: [...Array(n).keys()].map((k) => vectors.getColumn(k)) };
  }

  /* An orthonormal basis of the null space of rows of length n, and the rank. */
  function nullSpace(rows, n) {
    if (n === 0 || rows.length === 0) {
      return { basis: [...Array(n).keys()].map((k) => [...Array(n).keys()].map((i) => +(i === k))), rank: 0 };
    }
    const { values, vectors } = decompose(rows, n);
    const rank = values.filter((value) => value > RANK * Math.max(values[0], 1e-300)).length;
    return { basis: vectors.slice(rank), rank };
  }

  /* The screws reciprocal to all given ones: f . v + m . omega = 0. Serves twists and wrenches alike. */
  function reciprocal(screws, length) {
    const rows = screws.map((screw) => {
      const row = [...second(screw), ...scale(length, first(screw))];
      return scale(1 / (norm(row) || 1), row);
    });
    return nullSpace(rows, 6).basis.map((found) => [...found.slice(0, 3), ...scale(length, found.slice(3, 6))]);
  }

  /* Orthonormal vectors that span the same space as given orthonormal ones, as near to the absolute axes as can be. */
  function aligned(basis) {
    const made = [];
    while (made.length < basis.length) {
      let best = null;
      for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
        let image = [0, 0, 0];
        basis.forEach((b) => { image = add(image, scale(dot(b, axis), b)); });
        made.forEach((m) => { image = subtract(image, scale(dot(m, image), m)); });
        if (best === null || norm(image) > norm(best) + 1e-9) {
          best = image;
        }
      }
      made.push(unit(best));
    }
    return made;
  }

  function positive(direction) {
    const sizes = direction.map(Math.abs);
    const largest = sizes.findIndex((x) => x > Math.max(...sizes) - 1e-9);
    return direction[largest] < 0 ? -1 : 1;
  }

  /*
   * Principal screws of the system that `screws` span: { direction, point, pitch } for lines, where `point` is the
   * point of the axis next to `near`, and { direction, pitch: Infinity } for couples or translations.
   */
  function principal(screws, near, length) {
    if (screws.length === 0) {
      return [];
    }
    const shifted = screws.map((s) => [...first(s), ...scale(1 / length, subtract(second(s), cross(near, first(s))))]);
    const all = decompose(shifted, 6);
    const span = all.vectors.filter((_, k) => all.values[k] > RANK * all.values[0]);
    const parts = decompose([0, 1, 2].map((i) => span.map((s) => s[i])), span.length);
    const combine = (weights) => {
      let sum = [0, 0, 0, 0, 0, 0];
      weights.forEach((weight, k) => { sum = add(sum, scale(weight, span[k])); });
      return sum;
    };
    const lines = [], free = [];
    parts.vectors.forEach((weights, k) => {
      const screw = combine(weights);
      if (k < 3 && parts.values[k] > RANK) {
        lines.push(scale(1 / parts.values[k], screw));
      } else {
        free.push(unit(second(screw)));
      }
    });
    const couples = aligned(free).map((direction) => ({ direction: scale(positive(direction), direction), pitch: Infinity }));
    return [...lineScrews(lines, couples, near, length), ...couples];
  }

  function lineScrews(lines, couples, near, length) {
    if (lines.length === 0) {
      return [];
    }
    const seconds = lines.map((line) => {
      let moment = second(line);
      couples.forEach(({ direction }) => { moment = subtract(moment, scale(dot(moment, direction), direction)); });
      return moment;
    });
    const form = lines.map((a, i) => lines.map((b, k) => (dot(first(a), seconds[k]) + dot(first(b), seconds[i])) / 2));
    const eigen = new EigenvalueDecomposition(new Matrix(form), { assumeSymmetric: true });
    const mixed = lines.map((_, k) => {
      const weights = eigen.eigenvectorMatrix.getColumn(k);
      return weights.reduce((sum, w, i) => add(sum, scale(w, first(lines[i]))), [0, 0, 0]);
    });
    return grouped(eigen.realEigenvalues, mixed).map((towards) => {
      const direction = scale(positive(towards), towards);
      const weights = lines.map((line) => dot(first(line), direction));
      const moment = weights.reduce((sum, w, i) => add(sum, scale(w, seconds[i])), [0, 0, 0]);
      const pitch = dot(direction, moment);
      const point = add(near, scale(length, cross(direction, moment)));
      return { direction, point, pitch: Math.abs(pitch) < 1e-6 ? 0 : pitch * length };
    });
  }

  /* Directions of equal pitch replaced by others of the same space that are next to the absolute axes. */
  function grouped(pitches, directions) {
    const order = pitches.map((_, k) => k).sort((i, k) => pitches[i] - pitches[k]);
    const made = [];
    for (let start = 0; start < order.length;) {
      let stop = start + 1;
      while (stop < order.length && pitches[order[stop]] - pitches[order[start]] < 1e-6) {
        stop += 1;
      }
      made.push(...aligned(order.slice(start, stop).map((k) => unit(directions[k]))));
      start = stop;
    }
    return made;
  }

  /* The axis of one screw next to `near`: { direction, point, size, pitch }; pitch is Infinity for a couple. */
  function axis(screw, near, negligible) {
    const force = first(screw), moment = subtract(second(screw), cross(near, force));
    const size = norm(force);
    if (size <= negligible) {
      return { direction: unit(moment), point: near, size: norm(moment), pitch: Infinity };
    }
    const direction = scale(1 / size, force);
    return { direction, point: add(near, scale(1 / size, cross(direction, moment))), size, pitch: dot(direction, moment) / size };
  }

  return { dot, cross, add, subtract, scale, norm, unit, first, second, decompose, nullSpace, reciprocal, principal, axis };
})();
