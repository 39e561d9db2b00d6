"use strict";

/* The page at work: one state of the mechanism, set by a slider or by the time of a motion, shown everywhere. */
(() => {
  const SAFE = 0.15, SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
  const data = JSON.parse(document.getElementById("data").textContent);
  const { find, element } = Panel;
  const model = Kinematics.make(data, functions);
  const ranges = model.reach();
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
  let sliders = [];

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

  // -- sliders --

  function move(k, value) {
    pause();
    const wanted = model.toSliders(state.q);
    wanted[k] = value;
    const q = model.assemble(wanted, state.q);
    sliders.forEach((slider) => slider.complain(""));
    if (q === null) {
      sliders[k].complain("The loops cannot be closed there; the last pose stays.");
      model.toSliders(state.q).forEach((kept, i) => sliders[i].set(kept));
    } else {
      show(model.rest(q));
    }
  }

  // -- motions --

  const end = () => motion.t[motion.t.length - 1], begin = () => motion.t[0];

  function seek(to) {
    time = Math.max(begin(), Math.min(end(), to));
    sliders.forEach((slider) => slider.complain(""));
    find("#time").value = time;
    find("#clock").textContent = `${time.toFixed(2)} / ${end().toFixed(2)} s`;
    find("#time").setAttribute("aria-valuetext", `${time.toFixed(2)} s`);
    show(model.at(motion, time));
  }

  function choose(which) {
    motion = which === "file" ? model.recording() : model.sweep(Number(which), ranges);
    Panel.trouble(motion === null ? "This coordinate cannot move from here." : "");
    const usable = motion !== null;
    [find("#play"), find("#time")].forEach((control) => { control.disabled = !usable; });
    if (!usable) {
      pause();
      layers.measure({ frames: [state] });
      show(state);
      return;
    }
    layers.measure(motion);
    motion.frames.forEach(({ q }) => model.raise(q));
    stage.frame(layers.passed(motion));
    Panel.scales(layers.largest);
    Object.assign(find("#time"), { min: begin(), max: end() });
    Panel.notes(notes());
    seek(begin());
  }

  function notes() {
    const made = [...data.notes, `effects: ${data.effects.join(", ") || "none"}`];
    if (motion?.recorded) {
      const { recorded, frames } = data.motion;
      made.push(frames < recorded ? `${frames} of the motion's ${recorded} states are in this page` : `all ${recorded} states of the motion are in this page`);
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
    } else if (motion.recorded) {
      seek(end());
      pause();
    } else {
      seek(begin() + ((next - begin()) % (end() - begin())));
    }
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
    }
    requestAnimationFrame(frame);
  }

  layers.measure({ frames: [state] });
  Panel.views(Object.keys(Stage.VIEWS), (name) => stage.see(name), () => paint(stage.theme === "dark" ? "light" : "dark"));
  sliders = Panel.sliders(data, ranges, move);
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
    seek(Number(find("#time").value));
  });
  find("canvas").addEventListener("keydown", keys);
  find("canvas").addEventListener("pointerdown", () => { stage.touched = true; });
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
