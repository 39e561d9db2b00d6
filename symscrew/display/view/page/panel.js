"use strict";

/* The controls beside the picture. Each function fills a part of the page; texts never become markup. */
const Panel = (() => {
  const { digits } = Layers;
  const find = (selector) => document.querySelector(selector);

  function element(tag, properties = {}, ...children) {
    const made = document.createElement(tag);
    Object.entries(properties).forEach(([key, value]) => {
      if (key in made) {
        made[key] = value;
      } else {
        made.setAttribute(key, value);
      }
    });
    made.append(...children);
    return made;
  }

  /* The mark of a layer as it looks in the picture. */
  function swatch(id, colours) {
    const ns = "http://www.w3.org/2000/svg", svg = document.createElementNS(ns, "svg");
    const colour = colours[id] ?? colours.text;
    const draw = (tag, attributes) => {
      const made = document.createElementNS(ns, tag);
      Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
      svg.append(made);
    };
    svg.setAttribute("viewBox", "0 0 30 16");
    svg.setAttribute("aria-hidden", "true");
    const line = (extra = {}) => draw("line", { x1: 3, y1: 8, x2: 22, y2: 8, stroke: colour, "stroke-width": 2.4, ...extra });
    const head = () => draw("path", { d: "M20 3.5 L29 8 L20 12.5 Z", fill: colour });
    const arc = () => draw("path", { d: "M9 12 A6 6 0 1 1 20 12", fill: "none", stroke: colour, "stroke-width": 2.2 });
    const tails = { constraints: "box", drives: "box", momentum: "ball" };
    if (id === "screws") {
      draw("line", { x1: 1, y1: 8, x2: 29, y2: 8, stroke: colour, "stroke-width": 1.4, "stroke-dasharray": "3 2" });
      arc();
      draw("path", { d: "M16 10.5 L23 10 L19.5 15.5 Z", fill: colour });
    } else if (id === "masses") {
      draw("circle", { cx: 15, cy: 8, r: 6.5, fill: "#ffffff", stroke: "#111111" });
      draw("path", { d: "M15 8 V1.5 A6.5 6.5 0 0 1 21.5 8 Z M15 8 V14.5 A6.5 6.5 0 0 1 8.5 8 Z", fill: "#111111" });
    } else if (id === "points" || id === "joints") {
      draw("text", { x: 15, y: 12.5, "text-anchor": "middle", "font-size": 12, fill: colours.text, "font-style": id === "points" ? "italic" : "normal" });
      svg.lastChild.textContent = id === "points" ? "A₁" : "abc";
    } else if (id === "limits") {
      draw("path", { d: "M4 13 A12 12 0 0 1 26 13", fill: "none", stroke: colour, "stroke-width": 2 });
      draw("path", { d: "M2 11 L6 14 M28 11 L24 14 M15 14 L18 3", fill: "none", stroke: colour, "stroke-width": 2 });
    } else {
      const dashed = id === "constraints" || id === "freedoms";
      line({ "stroke-width": id === "drives" ? 3.6 : 2.4, ...(dashed ? { "stroke-dasharray": "4 2" } : {}) });
      head();
      if (tails[id] === "box") {
        draw("rect", { x: 1, y: 4.5, width: 6, height: 7, fill: colour });
      } else if (tails[id] === "ball") {
        draw("circle", { cx: 4.5, cy: 8, r: 3.6, fill: colour });
      } else if (id === "freedoms") {
        draw("path", { d: "M9 3.5 L0 8 L9 12.5 Z", fill: colour });
      }
    }
    return svg;
  }

  function header(data) {
    find("h1").textContent = data.name;
    find("#about").textContent = data.description;
    find("canvas").setAttribute("aria-label", `${data.name}: the mechanism in three dimensions`);
  }

  function views(names, onView, onTheme) {
    const holder = find(".views");
    names.forEach((name) => holder.append(element("button", { type: "button", textContent: name, onclick: () => onView(name) })));
    holder.append(element("button", { type: "button", id: "theme", textContent: "Dark", onclick: onTheme }));
  }

  /* The assembly modes at the reference: sliders go on from the one that is chosen. */
  function modes(known, onChoose) {
    if (known.length > 1) {
      const choice = element("select", { id: "mode" }, ...known.map(({ name }) => element("option", { value: name, textContent: name })));
      choice.addEventListener("change", () => onChoose(known[choice.selectedIndex].q));
      find("#coordinates > div").append(element("label", { textContent: "Assembly mode " }, choice));
    }
  }

  /* A slider per independent coordinate: angles in degrees, lengths in metres. */
  function sliders(data, ranges, onMove) {
    const holder = find("#coordinates > div");
    if (data.independent.length === 0) {
      holder.append(element("p", { className: "quiet", textContent: "None: the mechanism is a structure." }));
      return [];
    }
    return data.independent.map((entry, k) => {
      const [low, high] = ranges[k], id = `y${k}`;
      const axis = entry.axis === null ? "" : `, ${entry.quaternion === null ? "along" : "rotation about"} ${entry.axis}`;
      const input = element("input", { type: "range", id, min: low, max: high, step: "any", disabled: !(high > low) });
      const shown = element("output", {}), problem = element("p", { className: "problem", hidden: true, role: "alert" });
      shown.htmlFor = id;
      input.addEventListener("input", () => onMove(k, Number(input.value)));
      const label = element("label", { htmlFor: id, textContent: `${entry.name}${axis}` });
      const row = element("div", { className: "slider" }, element("div", { className: "line" }, label, shown), input, problem);
      holder.append(row);
      return {
        set(value) {
          input.value = value;
          const degrees = (value * 180) / Math.PI;
          shown.textContent = entry.kind === "length" ? `${value.toFixed(4)} m` : `${degrees.toFixed(1)}°`;
          input.setAttribute("aria-valuetext", shown.textContent);
        },
        range([low, high]) {
          Object.assign(input, { min: low, max: high, disabled: !(high > low) });
        },
        complain(text) {
          problem.hidden = text === "";
          problem.textContent = text;
        },
      };
    });
  }

  /* A slider per run-time parameter, in its own unit. */
  function parameters(tunable, onMove, onEnd) {
    find("#parameters").hidden = tunable.length === 0;
    return tunable.map((entry, k) => {
      const id = `p${k}`, input = element("input", { type: "range", id, min: entry.low, max: entry.high, step: "any", value: entry.value });
      const shown = element("output", {}), problem = element("p", { className: "problem", hidden: true, role: "alert" });
      shown.htmlFor = id;
      const set = (value) => {
        input.value = value;
        shown.textContent = `${digits(value, 4)} ${entry.unit === "1" ? "" : entry.unit}`;
      };
      input.addEventListener("input", () => onMove(k, Number(input.value)));
      input.addEventListener("change", onEnd);
      const label = element("label", { htmlFor: id, textContent: entry.name, title: entry.description });
      find("#parameters > div").append(element("div", { className: "slider" }, element("div", { className: "line" }, label, shown), input, problem));
      set(entry.value);
      return {
        set,
        complain(text) {
          problem.hidden = text === "";
          problem.textContent = text;
        },
      };
    });
  }

  /* The values of the body that was chosen; null: none is. */
  function body(name, rows) {
    const holder = find("#body > div");
    if (name === null) {
      return;
    }
    const cells = rows.map(([what, value, unit]) => element("tr", {}, element("th", { scope: "row", textContent: what }), element("td", { textContent: value }), element("td", { textContent: unit })));
    holder.replaceChildren(element("p", { textContent: name }), element("table", {}, element("tbody", {}, ...cells)));
  }

  function layers(set, colours, onChange) {
    const holder = find("#layers > div");
    holder.replaceChildren();
    Layers.ALL.forEach(({ id, title, hint }) => {
      const possible = set.available(id);
      const box = element("input", { type: "checkbox", id: `show-${id}`, checked: possible && set.shown.has(id), disabled: !possible });
      box.addEventListener("change", () => {
        set.shown[box.checked ? "add" : "delete"](id);
        onChange();
      });
      holder.append(element("label", { className: `choice${possible ? "" : " off"}`, title: possible ? hint : `${hint}: this model has none` }, box, swatch(id, colours), title, element("small", { id: `scale-${id}` })));
    });
    const size = element("input", { type: "range", id: "boost", min: 0.3, max: 3, step: 0.1, value: set.boost });
    size.addEventListener("input", () => {
      set.boost = Number(size.value);
      onChange();
    });
    holder.append(element("div", { className: "slider" }, element("div", { className: "line" }, element("label", { htmlFor: "boost", textContent: "Length of value arrows" })), size));
  }

  /* What the longest arrow of each layer stands for. */
  function scales(largest) {
    const drive = largest.drive > 0 ? [largest.drive, "N"] : [largest.torque, "N m"];
    const texts = { momentum: [largest.p, "kg m/s"], reactions: [largest.force, "N"], drives: drive };
    Object.entries(texts).forEach(([id, [value, unit]]) => {
      find(`#scale-${id}`).textContent = value > 0 ? `max ${digits(value)} ${unit}` : "";
    });
  }

  function values(rows) {
    const holder = find("#values > div");
    const cells = rows.map(([name, value, unit]) => element("tr", {}, element("th", { scope: "row", textContent: name }), element("td", { textContent: value }), element("td", { textContent: unit })));
    holder.replaceChildren(element("table", {}, element("tbody", {}, ...cells)));
  }

  function listing(entries) {
    const holder = find("#listing > div");
    const text = entries.map((entry) => entry.text).join("\n");
    if (entries.length === 0) {
      holder.replaceChildren(element("p", { className: "quiet", textContent: "Switch on reciprocal wrenches or freedoms." }));
    } else if (holder.dataset.text !== text) {
      holder.replaceChildren(element("ul", {}, ...entries.map((entry) => element("li", { textContent: entry.text }))));
    }
    holder.dataset.text = text;
  }

  function notes(texts) {
    find("#notes > div").replaceChildren(element("ul", {}, ...texts.map((text) => element("li", { textContent: text }))));
  }

  /* How near to a singularity: words and a mark, not only a colour. */
  function margin(found, level) {
    const chip = find("#margin");
    chip.hidden = found === null;
    find("#warning").hidden = found === null;
    if (found !== null) {
      const [state, mark, words] = level >= 1 ? ["none", "✕", "singular"] : level > 0 ? ["low", "▲", "near a singularity"] : ["good", "✓", "no singularity near"];
      chip.dataset.level = state;
      chip.title = "Smallest of the margins from limb, constraint and actuation singularities: 1 in the reference configuration, 0 at a singularity";
      chip.querySelector(".mark").textContent = mark;
      chip.querySelector(".text").textContent = `${words}: margin ${digits(found.value < 1e-9 ? 0 : found.value, 2)} (${found.name})`;
    }
  }

  function trouble(text) {
    find("#trouble").hidden = text === "";
    find("#trouble").textContent = text;
  }

  return { find, element, header, views, modes, sliders, parameters, body, layers, scales, values, listing, notes, margin, trouble };
})();
