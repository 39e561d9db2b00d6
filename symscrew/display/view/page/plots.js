"use strict";

/* Curves of a motion below one another with the time of the picture: a click in them seeks. */
const Plots = (() => {
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#7a5c00", "#808080"];
  const WIDE = 320, HIGH = 150, LEFT = 46, RIGHT = 8, TOP = 8, BOTTOM = 20, MOST = 8;

  /* What can be drawn of a motion: name -> curves { name, values } in one unit. */
  function kinds(data, model, motion) {
    const of = (unit, curves) => ({ unit, curves: curves.slice(0, MOST), more: Math.max(0, curves.length - MOST) });
    const made = {}, drives = data.drives.map((drive, k) => ({ ...drive, k }));
    for (const [unit, title] of [["N", "drive forces"], ["N m", "drive torques"]]) {
      const own = drives.filter((drive) => drive.unit === unit);
      if (own.length) {
        made[title] = () => of(unit, own.map(({ label, k }) => ({ name: label, values: motion.frames.map((f) => f.u?.[k] ?? NaN) })));
      }
    }
    for (const [kind, unit, factor, title] of [["turn", "°", 180 / Math.PI, "coordinates, angles"], ["angle", "°", 180 / Math.PI, "coordinates, angles"], ["length", "m", 1, "coordinates, lengths"]]) {
      const own = data.independent.map((entry, k) => ({ ...entry, k })).filter((entry) => entry.kind === kind);
      if (own.length) {
        made[title] = () => {
          const all = motion.frames.map(({ q }) => model.toSliders(q));
          return of(unit, own.map(({ name, k }) => ({ name, values: all.map((row) => factor * row[k]) })));
        };
      }
    }
    if (model.has("energy")) {
      made.energy = () => {
        const all = motion.frames.map((frame) => model.call("energy", frame).energy);
        return of("J", ["kinetic", "potential"].map((name, k) => ({ name, values: all.map((row) => row[k]) })));
      };
    }
    if (model.margin(motion.frames[0].q) !== null) {
      made["margin from singularities"] = () => of("1", [{ name: "smallest margin", values: motion.frames.map(({ q }) => model.margin(q)?.value ?? NaN) }]);
    }
    return made;
  }

  function piece(tag, attributes, text = "") {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    made.textContent = text;
    return made;
  }

  /* Round numbers for an ordinate, about four. */
  function ticks(low, high) {
    const raw = (high - low) / 4 || Math.abs(high) || 1, unit = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((x) => x * unit).find((x) => x >= raw);
    const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
    return [...Array(Math.max(0, last - first + 1)).keys()].map((k) => (first + k) * step);
  }

  class Panel {
    constructor(data, model, onSeek) {
      Object.assign(this, { data, model });
      this.holder = document.querySelector("#plots");
      this.choice = this.holder.querySelector("select");
      this.svg = this.holder.querySelector("svg");
      this.names = this.holder.querySelector(".names");
      this.svg.setAttribute("viewBox", `0 0 ${WIDE} ${HIGH}`);
      const seek = (event) => {
        const box = this.svg.getBoundingClientRect(), part = ((event.clientX - box.left) / box.width) * WIDE;
        const [first, last] = [this.motion.t[0], this.motion.t.at(-1)];
        onSeek(first + Math.max(0, Math.min(1, (part - LEFT) / (WIDE - LEFT - RIGHT))) * (last - first));
      };
      this.svg.addEventListener("pointerdown", (event) => {
        this.svg.setPointerCapture(event.pointerId);
        seek(event);
      });
      this.svg.addEventListener("pointermove", (event) => { if (event.buttons) { seek(event); } });
      this.choice.addEventListener("change", () => this.draw());
      this.holder.addEventListener("toggle", () => this.draw());
    }

    /* The curves of another motion; null: there is none. */
    set(motion) {
      this.motion = motion;
      this.kinds = motion === null ? {} : kinds(this.data, this.model, motion);
      this.holder.hidden = Object.keys(this.kinds).length === 0;
      const before = this.choice.value;
      this.choice.replaceChildren(...Object.keys(this.kinds).map((name) => {
        const option = document.createElement("option");
        option.textContent = option.value = name;
        return option;
      }));
      this.choice.value = before in this.kinds ? before : Object.keys(this.kinds)[0] ?? "";
      this.draw();
    }

    draw() {
      if (this.motion === null || this.holder.hidden || !this.holder.open) {
        return;
      }
      const { unit, curves, more } = this.kinds[this.choice.value](), all = curves.flatMap(({ values }) => values).filter(Number.isFinite);
      const [low, high] = all.length ? [Math.min(...all), Math.max(...all)] : [0, 1], span = high - low || Math.abs(high) || 1;
      const [from, to] = [low - 0.04 * span, high + 0.04 * span], t = this.motion.t;
      this.x = (time) => LEFT + ((time - t[0]) / (t.at(-1) - t[0])) * (WIDE - LEFT - RIGHT);
      const y = (value) => HIGH - BOTTOM - ((value - from) / (to - from)) * (HIGH - TOP - BOTTOM);
      const every = Math.max(1, Math.floor(t.length / 400)), parts = [];
      for (const value of ticks(from, to)) {
        parts.push(piece("line", { x1: LEFT, x2: WIDE - RIGHT, y1: y(value), y2: y(value), class: "rule" }));
        parts.push(piece("text", { x: LEFT - 4, y: y(value) + 3.5, "text-anchor": "end" }, Layers.digits(Math.abs(value) < 1e-9 * span ? 0 : value)));
      }
      [t[0], (t[0] + t.at(-1)) / 2, t.at(-1)].forEach((time, k) => parts.push(piece("text", { x: this.x(time), y: HIGH - 6, "text-anchor": ["start", "middle", "end"][k] }, `${Layers.digits(time)}${k === 2 ? " s" : ""}`)));
      curves.forEach(({ values }, k) => {
        const points = values.map((value, i) => [this.x(t[i]), y(value), i]).filter(([, v, i]) => Number.isFinite(v) && (i % every === 0 || i === t.length - 1));
        parts.push(piece("polyline", { points: points.map(([a, b]) => `${a.toFixed(1)},${b.toFixed(1)}`).join(" "), stroke: COLOURS[k], class: "curve" }));
      });
      this.cursor = piece("line", { y1: TOP, y2: HIGH - BOTTOM, class: "cursor" });
      this.svg.replaceChildren(...parts, this.cursor);
      this.svg.setAttribute("aria-label", `${this.choice.value} over time`);
      this.names.replaceChildren(...curves.map(({ name }, k) => {
        const item = document.createElement("span");
        item.textContent = name;
        item.style.setProperty("--curve", COLOURS[k]);
        return item;
      }), `[${unit}]${more ? `, ${more} more` : ""}`);
      this.at(this.time ?? t[0]);
    }

    /* The line at a time. */
    at(time) {
      this.time = time;
      if (this.cursor && this.x) {
        this.cursor.setAttribute("x1", this.x(time));
        this.cursor.setAttribute("x2", this.x(time));
      }
    }
  }

  return { Panel };
})();
