"use strict";

/* The page at work: one state of the mechanism, set by a slider or by the time of a motion, shown everywhere. */
(() => {
  const SAFE = 0.15, CLICK = 4, SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
  const data = JSON.parse(document.getElementById("data").textContent);
  const { find, element } = Panel;
  const model = Kinematics.make(data, functions);
  let ranges = model.reach();
  const started = { theme: matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light" };
  let stage;
  Panel.header(data);
  try {
    stage = new Stage.Picture(find(".picture"), find("canvas"), data, started.theme);
  } catch (error) {
    Panel.trouble(`This browser cannot draw in three dimensions (WebGL): ${error.message}`);
    return;
  }
  const layers = new Layers.Set(data, model, stage);
  let motion = null, state = model.rest(model.reference), time = 0, playing = false, last = 0;
  let sliders = [], tuned = [], film = null, pressed = null;
  const plots = new Plots.Panel(data, model, (to) => {
    pause();
    seek(to, true);
  });

  // -- showing a state --

  function show(next) {
    state = next;
    stage.labels.begin();
    stage.pose(model.columns(model.call("body_poses", state).poses, 12));
    layers.draw(state);
    const found = model.margin(state.q);
    const level = found === null ? 0 : found.value <= 1e-6 ? 1 : Math.max(0, Math.min(0.98, 1 - found.value / SAFE));
    stage.warn(level);
    Panel.margin(found, level);
    Panel.values(rows());
    chosen();
    Panel.listing(layers.listing);
    model.toSliders(state.q).forEach((value, k) => sliders[k]?.set(value));
    stage.dirty = true;
  }

  function rows() {
    const made = data.drives.map((drive, k) => [`drive ${drive.label}`, state.u ? layers.amount(state.u[k], drive.unit === "N" ? "drive" : "torque", 4) : "–", drive.unit]);
    if (model.has("energy")) {
      const [kinetic, potential] = model.call("energy", state).energy;
      made.push(["kinetic energy", Layers.digits(kinetic, 4), "J"], ["potential energy", Layers.digits(potential, 4), "J"]);
    }
    if (model.has("closure")) {
      made.push(["opening of the loops", Math.max(0, ...model.call("closure", state).residual.map(Math.abs)).toExponential(1), "m, rad"]);
    }
    return made;
  }

  /* What the chosen body does. */
  function chosen() {
    const k = stage.chosen ?? -1, body = data.bodies[k];
    if (!body) {
      return;
    }
    const vector = (a, count = 4) => `(${Array.from(a, (x) => Layers.digits(Math.abs(x) < 1e-12 * data.length ? 0 : x, count)).join(", ")})`;
    const made = body.mass === null ? [["mass", "none given", ""]] : [["mass", Layers.digits(body.mass, 4), "kg"]];
    if (k === 0) {
      Panel.body(`${body.name}: does not move`, []);
      return;
    }
    const pose = model.columns(model.call("body_poses", state).poses, 12)[k - 1], com = layers.carried(body.com ?? data.joints.find(({ child }) => child === k)?.point ?? [0, 0, 0], k, layers.posesOf(state));
    const cosine = Math.max(-1, Math.min(1, (pose[0] + pose[4] + pose[8] - 1) / 2));
    made.push([body.mass === null ? "joint's point" : "centre of mass", vector(com), "m"], ["turned from the reference by", ((Math.acos(cosine) * 180) / Math.PI).toFixed(2), "°"]);
    if (model.has("body_twists")) {
      const twist = model.columns(model.call("body_twists", state).twists, 6)[k - 1], omega = Screws.first(twist);
      made.push(["angular velocity", vector(omega), "rad/s"], ["its velocity", vector(Screws.add(Screws.second(twist), Screws.cross(omega, com))), "m/s"]);
    }
    const own = layers.momentaOf(state).find((entry) => entry.body === body);
    if (own) {
      made.push(["momentum", vector(Screws.first(own.screw)), "kg m/s"], ["angular momentum about it", vector(Screws.subtract(Screws.second(own.screw), Screws.cross(own.com, Screws.first(own.screw)))), "kg m²/s"]);
    }
    Panel.body(body.name, made);
  }

  function choose_body(x, y) {
    const found = stage.pick(x, y);
    if (found >= 0) {
      stage.chosen = found;
      stage.rebuild();
      show(state);
    }
  }

  // -- run-time parameters --

  /* Shapes, joints and points at the parameters as they are now. */
  function reshape() {
    if (!model.has("outline")) {
      return;
    }
    const points = model.columns(model.call("outline", {}).points, 3), at = (k) => points[k];
    const middle = (corners) => corners.reduce(Screws.add, [0, 0, 0]).map((x) => x / corners.length);
    data.bodies.forEach((body) => {
      body.plate = body.outline.plate.map(at);
      body.bar = body.outline.bar.map(at);
      body.struts = body.outline.struts.map((k) => [middle(body.plate), at(k)]);
      body.com = body.outline.com === null ? body.com : at(body.outline.com);
    });
    data.joints.forEach((joint) => {
      joint.point = at(joint.outline.point);
      joint.axes = joint.outline.axes.map((k) => Screws.unit(at(k)));
    });
    data.points.forEach((point) => { point.at = at(point.outline); });
    stage.rebuild();
  }

  function tune(k, value) {
    pause();
    const before = data.parameters[k], sliderValues = model.toSliders(state.q);
    data.parameters[k] = value;
    const q = model.assemble(sliderValues, state.q);
    tuned.forEach((slider) => slider.complain(""));
    if (q === null) {
      data.parameters[k] = before;
      tuned[k].set(before);
      tuned[k].complain("The loops cannot be closed there; the last value stays.");
      return;
    }
    tuned[k].set(value);
    model.restart();
    reshape();
    show(model.rest(q));
    stage.keep(layers.points);
  }

  /* After a parameter has come to rest: how far the sliders go now, and the motion again. */
  function tuned_anew() {
    const q = state.q;
    ranges = model.reach();
    sliders.forEach((slider, k) => slider.range(ranges[k]));
    if (!data.motion) {
      choose(find("#motion").value);
    }
    show(model.rest(q));
  }

  // -- sliders --

  function move(k, value) {
    pause();
    const wanted = model.toSliders(state.q);
    wanted[k] = value;
    const q = model.assemble(wanted, state.q);
    sliders.forEach((slider) => slider.complain(""));
    const left = q === null ? null : model.left(q);
    if (q === null || (left !== null && model.left(state.q) === null)) {
      sliders[k].complain(q === null ? "The loops cannot be closed there; the last pose stays." : `${left.label} would leave its limits; the last pose stays.`);
      model.toSliders(state.q).forEach((kept, i) => sliders[i].set(kept));
    } else {
      show(model.rest(q));
      stage.keep(layers.points);
    }
  }

  // -- motions --

  const end = () => motion.t[motion.t.length - 1], begin = () => motion.t[0];

  /* A time of the motion; `recorded`: the recorded one next to it, whose numbers are those of the file. */
  function seek(to, recorded = false) {
    time = Math.max(begin(), Math.min(end(), to));
    if (recorded && motion.recorded) {
      const high = Math.max(1, motion.t.findIndex((t) => t >= time)), low = high - 1;
      time = time - motion.t[low] < motion.t[high] - time ? motion.t[low] : motion.t[high];
    }
    sliders.forEach((slider) => slider.complain(""));
    find("#time").value = time;
    find("#clock").textContent = `${time.toFixed(2)} / ${end().toFixed(2)} s`;
    find("#time").setAttribute("aria-valuetext", `${time.toFixed(2)} s`);
    show(model.at(motion, time));
    plots.at(time);
  }

  function choose(which) {
    motion = which === "file" ? model.recording() : model.sweep(Number(which), ranges);
    Panel.trouble(motion === null ? "This coordinate cannot move from here." : "");
    const usable = motion !== null;
    [find("#play"), find("#time")].forEach((control) => { control.disabled = !usable; });
    if (!usable) {
      pause();
      layers.measure({ frames: [state] });
      plots.set(null);
      show(state);
      return;
    }
    layers.measure(motion);
    motion.frames.forEach(({ q }) => model.raise(q));
    stage.frame(layers.passed(motion));
    Panel.scales(layers.largest);
    Object.assign(find("#time"), { min: begin(), max: end() });
    Panel.notes(notes());
    plots.set(motion);
    seek(begin());
  }

  function notes() {
    const made = [...data.notes, `effects: ${data.effects.join(", ") || "none"}`];
    if (motion?.recorded) {
      const { recorded, frames } = data.motion;
      made.push(frames < recorded ? `${frames} of the motion's ${recorded} states are in this page, those with the least and the largest values among them; --frames all takes all` : `all ${recorded} states of the motion are in this page`);
      const computed = Object.entries(motion.computed).filter(([, is]) => is).map(([name]) => ({ u: "drives", reactions: "reactions" })[name]);
      if (computed.length) {
        made.push(`the motion's file has no ${computed.join(" and no ")}: computed here from the model's effects and differences of the rates`);
      }
    } else if (motion) {
      made.push("the motion is a sweep for demonstration; moved by a slider, the mechanism is at rest");
    }
    return made;
  }

  function pause() {
    playing = false;
    find("#play").textContent = "▶";
    find("#play").setAttribute("aria-label", "Play");
  }

  function toggle() {
    if (motion === null) {
      return;
    }
    if (playing) {
      pause();
      return;
    }
    if (motion.recorded && time >= end()) {
      time = begin();
    }
    playing = true;
    last = performance.now();
    find("#play").textContent = "⏸";
    find("#play").setAttribute("aria-label", "Pause");
  }

  function advance(now) {
    const next = time + ((now - last) / 1000) * Number(find("#speed").value);
    last = now;
    if (next < end()) {
      seek(next);
    } else if (film !== null) {
      seek(end());
      pause();
      record();
    } else if (motion.recorded) {
      seek(end());
      pause();
    } else {
      seek(begin() + ((next - begin()) % (end() - begin())));
    }
  }

  /* Begin a film of the motion, once through, or end it. */
  function record() {
    const button = find("#film");
    if (film !== null) {
      const done = film;
      film = null;
      button.textContent = "Film";
      stage.render();
      done.take();
      setTimeout(() => done.stop(), 100);
      return;
    }
    pause();
    seek(begin());
    stage.render();
    film = Records.film(stage, data.name);
    if (film === null) {
      Panel.trouble("This browser records no films; symscrew view --mp4 or --gif writes one.");
      return;
    }
    button.textContent = "Stop";
    toggle();
  }

  // -- the page --

  function paint(theme) {
    document.documentElement.dataset.theme = theme;
    find("#theme").textContent = theme === "dark" ? "Light" : "Dark";
    if (stage.theme !== theme) {
      stage.paint(theme);
      layers.paint();
    }
    Panel.layers(layers, stage.colours, () => show(state));
    if (layers.largest) {
      Panel.scales(layers.largest);
    }
    show(state);
  }

  function keys(event) {
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (x !== 0 || y !== 0) {
      if (event.shiftKey) {
        stage.pan(-0.04 * x, -0.04 * y);
      } else {
        stage.turn(0.08 * x, 0.08 * y);
      }
    } else if (event.key === "+" || event.key === "=") {
      stage.zoom(1 / 1.12);
    } else if (event.key === "-") {
      stage.zoom(1.12);
    } else if (event.key === "Home") {
      stage.see(stage.first);
    } else if (event.key === " ") {
      toggle();
    } else {
      return;
    }
    event.preventDefault();
  }

  function frame(now) {
    if (playing) {
      advance(now);
    }
    stage.resize();
    if (stage.dirty) {
      stage.render();
      film?.take();
    }
    requestAnimationFrame(frame);
  }

  layers.measure({ frames: [state] });
  Panel.views(Object.keys(Stage.VIEWS), (name) => stage.see(name), () => paint(stage.theme === "dark" ? "light" : "dark"));
  sliders = Panel.sliders(data, ranges, move);
  tuned = Panel.parameters(data.tunable, tune, tuned_anew);
  if (location.hash === "#embed") {
    document.documentElement.dataset.embedded = "yes";
  }
  SPEEDS.forEach((speed) => find("#speed").append(element("option", { value: speed, textContent: `${speed} ×`, selected: speed === 1 })));
  const options = data.motion ? [["file", "recorded"]] : [];
  if (data.independent.length > 1) {
    options.push(["-1", "sweep: all together"]);
  }
  data.independent.forEach((entry, k) => options.push([String(k), `sweep: ${entry.name}`]));
  options.forEach(([value, textContent]) => find("#motion").append(element("option", { value, textContent })));
  find("#motion").addEventListener("change", () => choose(find("#motion").value));
  find("#play").addEventListener("click", toggle);
  find("#time").addEventListener("input", () => {
    pause();
    seek(Number(find("#time").value), true);
  });
  find("#still").addEventListener("click", () => Records.picture(stage, data.name));
  find("#film").addEventListener("click", record);
  find("canvas").addEventListener("keydown", keys);
  find("canvas").addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
  find("canvas").addEventListener("pointermove", (event) => {
    stage.touched ||= pressed !== null && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > CLICK;
  });
  find("canvas").addEventListener("wheel", () => { stage.touched = true; }, { passive: true });
  find("canvas").addEventListener("pointerup", (event) => {
    const frame = find("canvas").getBoundingClientRect();
    if (pressed !== null && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) <= CLICK) {
      choose_body(event.clientX - frame.left, event.clientY - frame.top);
    }
    pressed = null;
  });
  stage.resize();
  stage.see(stage.first);
  paint(started.theme);
  if (options.length) {
    choose(options[0][0]);
    if (!data.motion) {
      show(model.rest(model.reference));
    }
  } else {
    find(".transport").hidden = true;
    Panel.notes(notes());
  }
  requestAnimationFrame(frame);
  document.documentElement.dataset.ready = "yes";
})();
