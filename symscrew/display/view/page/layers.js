"use strict";

/* What can be shown beside the bodies: screws, wrenches, freedoms, momentum, reactions, drives, centres of mass. */
const Layers = (() => {
  const { vector } = Shapes;

  const digits = (value, count = 3) => {
    const size = Math.abs(value);
    if (!Number.isFinite(value)) {
      return "–";
    }
    return size > 0 && (size < 1e-3 || size >= 1e5) ? value.toExponential(count - 1) : Number(value.toPrecision(count)).toString();
  };

  /* A direction across another, the same for the same. */
  function across(axis) {
    const sizes = axis.map(Math.abs), k = sizes.indexOf(Math.min(...sizes));
    return Screws.cross(axis, [0, 1, 2].map((i) => +(i === k)));
  }

  const pitchText = (pitch) => `h = ${digits(pitch)} m/rad`;

  /* `id`, `title`, `hint`, whether it is drawn in dashes, the mark at an arrow's tail, what it needs. */
  const ALL = [
    { id: "screws", title: "Joint screws", hint: "unit screws of all joints: arc = turning, double arrow = sliding", look: { dashed: false } },
    { id: "constraints", title: "Reciprocal wrenches", hint: "constraints that each limb puts on the platform: arrow = force, arc = couple", look: { dashed: true, tail: "box" } },
    { id: "freedoms", title: "Freedoms", hint: "what the platform can do here: arc = turning, double arrow = translation", look: { dashed: true } },
    { id: "momentum", title: "Momentum screws", hint: "momentum on the axis of each body's momentum screw, arc = moment about it; a dashed line leads to the centre of mass", look: { tail: "ball" }, unit: "kg m/s" },
    { id: "reactions", title: "Joint reactions", hint: "force and moment from parent on child at each joint", look: { tail: "none" }, unit: "N" },
    { id: "drives", title: "Drive forces", hint: "arrow = force, arc = torque, at the driven joints", look: { tail: "box" }, unit: "N" },
    { id: "limits", title: "Joint limits", hint: "how far a joint may turn or slide; the needle is where it is", look: {} },
    { id: "masses", title: "Centres of mass", hint: "balls in quarters; the largest is that of all bodies", look: {} },
    { id: "axes", title: "Axes x, y, z at O", hint: "the absolute axes: screws stand at O, points and directions are given in them", look: { tail: "none" } },
    { id: "points", title: "Names of points", hint: "the named points of the description", look: {} },
    { id: "joints", title: "Names of joints", hint: "the joints of the description", look: {} },
  ];

  class Set {
    constructor(data, model, stage) {
      Object.assign(this, { data, model, stage });
      this.shown = new globalThis.Set(["points", "axes", "constraints", "freedoms", "limits"].filter((id) => this.available(id)));
      this.size = stage.size;
      this.boost = 1;
      this.listing = [];
      this.pens = {};
      this.balls = [];
      this.paint();
    }

    available(id) {
      const needs = {
        momentum: this.model.has("momentum_screws"), reactions: this.model.has("joint_reactions") || this.data.motion !== null,
        drives: this.data.drives.length > 0, masses: this.data.bodies.some((body) => body.mass !== null),
        points: this.data.points.length > 0, freedoms: this.model.has("platform_jacobian"),
        constraints: this.model.has("platform_jacobian") && this.model.has("joint_screws"), screws: this.model.has("joint_screws"),
        limits: this.data.limits.length > 0,
      };
      return needs[id] ?? true;
    }

    /* New pens in the colours of the theme. */
    paint() {
      Object.values(this.pens).forEach((pen) => this.stage.overlay.remove(pen.group));
      this.balls.forEach(({ mesh }) => this.stage.overlay.remove(mesh));
      const colours = this.stage.colours;
      this.pens = Object.fromEntries(
        ALL.filter(({ id }) => colours[id]).map(({ id, look }) => [id, new Shapes.Pen(this.stage.overlay, colours[id], this.size, look)]),
      );
      const dark = Shapes.material(colours.com_dark), light = Shapes.material(colours.com_light);
      this.balls = this.data.bodies.filter((body) => body.mass !== null).map((body) => this.ball(0.016, dark, light, body));
      if (this.balls.length > 1) {
        this.balls.push(this.ball(0.024, dark, light, null));
      }
    }

    ball(radius, dark, light, body) {
      const mesh = Shapes.centre(radius * this.size, dark, light);
      this.stage.overlay.add(mesh);
      return { mesh, body };
    }

    /* The largest values of a motion: arrows are drawn in proportion to them. */
    measure(motion) {
      const largest = { force: 0, moment: 0, drive: 0, torque: 0, p: 0, spin: 0 };
      const every = Math.max(1, Math.floor(motion.frames.length / 60));
      const grow = (key, value) => { largest[key] = Math.max(largest[key], Number.isFinite(value) ? value : 0); };
      for (let k = 0; k < motion.frames.length; k += every) {
        const state = motion.frames[k];
        this.reactionsOf(state).forEach(({ force, moment }) => { grow("force", Screws.norm(force)); grow("moment", Screws.norm(moment)); });
        this.data.drives.forEach((drive, i) => grow(this.slides(drive) ? "drive" : "torque", Math.abs(state.u?.[i] ?? 0)));
        this.momentaOf(state).forEach(({ screw, com }) => {
          grow("p", Screws.norm(Screws.first(screw)));
          grow("spin", Screws.norm(Screws.subtract(Screws.second(screw), Screws.cross(com, Screws.first(screw)))));
        });
      }
      this.largest = largest;
    }

    /* Joints and named points in all frames of a motion. */
    passed(motion) {
      return motion.frames.flatMap((state) => {
        const poses = this.posesOf(state);
        const named = this.data.points.map(({ body, at }) => this.carried(at, body, poses));
        return [...this.model.columns(this.model.call("joint_points", state).points, 3), ...named];
      });
    }

    slides(drive) {
      return this.data.joints[drive.joint].kinds[drive.freedom] === "slide";
    }

    /* Everything that is shown, for a state of the mechanism. */
    draw(state) {
      this.state = state;
      this.points = this.model.columns(this.model.call("joint_points", state).points, 3);
      const poses = this.posesOf(state);
      this.seats = this.data.joints.map((joint) => this.carried(joint.point, joint.parent, poses));
      this.listing = [];
      for (const { id } of ALL) {
        const pen = this.pens[id];
        pen?.begin();
        if (this.shown.has(id) && this.available(id)) {
          this[`draw_${id}`](state, pen);
        }
        pen?.end();
      }
      this.balls.forEach(({ mesh }) => { mesh.visible = this.shown.has("masses"); });
    }

    label(text, at, id, priority) {
      this.stage.labels.add(text, at, id, priority);
    }

    /* Where something about a joint's sliding is drawn: beside its sleeve, on the side away from the middle. */
    beside(j, direction) {
      const seat = this.seats[j], away = Screws.subtract(seat, this.stage.middle);
      const across = Screws.subtract(away, Screws.scale(Screws.dot(away, direction), direction));
      const side = Screws.norm(across) > 1e-3 * this.size ? Screws.unit(across) : Screws.unit(Screws.cross(direction, [0.3, 0.5, 0.8]));
      return Screws.add(seat, Screws.scale(0.05 * this.size, side));
    }

    // -- screws --

    screwsOf(state) {
      return this.model.columns(this.model.call("joint_screws", state).screws, 6);
    }

    draw_screws(state, pen) {
      const screws = this.screwsOf(state);
      this.data.joints.forEach((joint, j) => {
        joint.kinds.forEach((kind, k) => {
          const screw = screws[joint.screws + k], at = this.points[j];
          if (kind === "slide") {
            const direction = Screws.unit(Screws.second(screw));
            const seat = this.beside(j, direction);
            pen.arrow(Screws.add(seat, Screws.scale(-0.09 * this.size, direction)), direction, 0.18 * this.size, { both: true, thick: 0.9 });
            this.label(`${joint.freedoms[k]}: h = ∞`, Screws.add(seat, Screws.scale(0.09 * this.size, direction)), "screws", 2);
            return;
          }
          const direction = Screws.unit(Screws.first(screw));
          pen.axis(at, direction, 0.2 * this.size);
          pen.arc(Screws.add(at, Screws.scale(0.055 * this.size, direction)), direction, 0.034 * this.size);
          const pitch = kind === "screw" ? pitchText(joint.pitch) : "h = 0";
          this.label(`${joint.freedoms[k]}: ${pitch}`, Screws.add(at, Screws.scale(0.1 * this.size, direction)), "screws", 2);
        });
      });
    }

    /* The absolute axes at O. */
    draw_axes(_, pen) {
      ["x", "y", "z"].forEach((name, k) => {
        const direction = [0, 1, 2].map((i) => (i === k ? 1 : 0));
        pen.arrow([0, 0, 0], direction, 0.17 * this.size, { thick: 0.7 });
        this.label(name, Screws.scale(0.17 * this.size, direction), "axes", 0.5);
      });
    }

    /* Where the platform is: the mean of its joints' points. */
    middle() {
      const own = this.points.filter((_, j) => [this.data.joints[j].parent, this.data.joints[j].child].includes(this.data.platform));
      return Screws.scale(1 / own.length, own.reduce(Screws.add, [0, 0, 0]));
    }

    /* A principal screw of a system, as force or couple, or as turning or translation. */
    principal(found, pen, names, id, length, owner) {
      const { direction, pitch } = found, at = found.point ?? found.near;
      const of = Number.isFinite(pitch) ? (pitch === 0 ? "h = 0" : pitchText(pitch)) : "h = ∞";
      const name = Number.isFinite(pitch) ? names.zero : names.infinite, title = `${name}, ${of}`;
      const end = Screws.add(at, Screws.scale(length, direction));
      if (names.turning === Number.isFinite(pitch)) {
        const from = Screws.add(at, Screws.scale(-0.5 * length, direction));
        if (names.turning) {
          pen.axis(at, direction, 2 * length);
        }
        pen.arc(names.turning ? Screws.add(at, Screws.scale(0.8 * length, direction)) : at, direction, 0.075 * this.size);
        this.label(`${owner}${title}`, names.turning ? end : Screws.add(at, Screws.scale(0.09 * this.size, direction)), id, 3);
        if (names.turning && pitch !== 0) {
          pen.arrow(from, direction, length, { both: false });
        }
      } else {
        const back = names.turning ? 0.5 * length : 0;
        pen.arrow(Screws.add(at, Screws.scale(-back, direction)), direction, length, { both: names.turning });
        if (!names.turning && pitch !== 0) {
          pen.arc(Screws.add(at, Screws.scale(0.5 * length, direction)), direction, 0.05 * this.size);
        }
        this.label(`${owner}${title}`, Screws.add(at, Screws.scale(length - back, direction)), id, 3);
      }
      const numbers = (a) => `(${a.map((x) => digits(Math.abs(x) < 5e-5 ? 0 : x)).join(", ")})`;
      const through = Number.isFinite(pitch) ? ` through ${numbers(found.point)} m` : "";
      this.listing.push({ id, text: `${owner}${name} along ${numbers(direction)}${through}, ${of}` });
    }

    draw_constraints(state, pen) {
      const names = { zero: "force", infinite: "couple", turning: false };
      const screws = this.screwsOf(state);
      const limbs = this.data.limbs.length ? this.data.limbs : null;
      if (limbs === null) {
        const free = this.model.freedoms(state.q);
        // seen from a point on an axis of turning, the forces that meet it have no pitch
        const near = Screws.principal(free, this.middle(), this.data.length).find(({ pitch }) => pitch === 0)?.point ?? this.middle();
        const wrenches = Screws.reciprocal(free, this.data.length);
        Screws.principal(wrenches, near, this.data.length).forEach((found) =>
          this.principal({ ...found, near }, pen, names, "constraints", 0.2 * this.size, ""));
        return;
      }
      for (const limb of limbs) {
        const own = limb.joints.flatMap((j) => this.data.joints[j].kinds.map((_, k) => screws[this.data.joints[j].screws + k]));
        const near = this.points[limb.joints[limb.joints.length - 1]];
        Screws.principal(Screws.reciprocal(own, this.data.length), near, this.data.length).forEach((found) =>
          this.principal({ ...found, near }, pen, names, "constraints", 0.2 * this.size, limbs.length > 1 ? `${limb.name}: ` : ""));
      }
    }

    draw_freedoms(state, pen) {
      const near = this.middle();
      const found = Screws.principal(this.model.freedoms(state.q), near, this.data.length);
      if (found.length === 6) {
        this.label("all six freedoms", near, "freedoms", 3);
        this.listing.push({ id: "freedoms", text: "all six freedoms" });
        return;
      }
      found.forEach((screw) =>
        this.principal({ ...screw, near }, pen, { zero: "rotation", infinite: "translation", turning: true }, "freedoms", 0.22 * this.size, ""));
    }

    // -- limits --

    /* A sector or a track from the lower to the upper limit, and a needle or a mark where the joint is. */
    draw_limits(state, pen) {
      const screws = this.screwsOf(state), poses = this.posesOf(state), now = this.model.displacements(state.q);
      this.data.limits.forEach(({ joint: j, freedom, at, low, high, start, label }) => {
        const joint = this.data.joints[j], screw = screws[joint.screws + freedom];
        const slides = joint.kinds[freedom] === "slide", seat = slides ? this.seats[j] : this.points[j];
        const direction = Screws.unit(slides ? Screws.second(screw) : Screws.first(screw));
        const reach = slides ? this.size : Math.PI, from = low ?? Math.min(now[at], start) - 0.3 * reach, to = high ?? Math.max(now[at], start) + 0.3 * reach;
        const side = this.turned(across(joint.axes[Math.min(freedom, joint.axes.length - 1)] ?? [0, 0, 1]), joint.parent, poses);
        const flat = Screws.unit(Screws.subtract(side, Screws.scale(Screws.dot(side, direction), direction)));
        const other = Screws.cross(direction, flat), r = 0.085 * this.size;
        const place = slides
          ? (s, out = 0.03) => Screws.add(seat, Screws.add(Screws.scale(s - start, direction), Screws.scale(out * this.size, flat)))
          : (s, out = 1) => Screws.add(seat, Screws.add(Screws.scale(out * r * Math.cos(s), flat), Screws.scale(out * r * Math.sin(s), other)));
        const count = slides ? 1 : 24, part = (k) => from + ((to - from) * k) / count;
        for (let k = 0; k < count; ++k) {
          pen.stroke(place(part(k)), place(part(k + 1)), 1);
        }
        const [inner, outer] = slides ? [0.018, 0.042] : [0.8, 1.2];
        [[low, from], [high, to]].filter(([given]) => given !== null).forEach(([, s]) => pen.stroke(place(s, inner), place(s, outer), 1.6));
        pen.stroke(slides ? place(now[at], 0.012) : seat, place(now[at], slides ? 0.05 : 1.1), 0.9);
        const text = (s) => (slides ? `${digits(s)} m` : `${digits((s * 180) / Math.PI)}°`);
        this.label(`${label}: ${low === null ? "" : text(low)} … ${high === null ? "" : text(high)}`, place(to, slides ? 0.05 : 1.15), "limits", 1.5);
      });
    }

    /* A direction of a body in the reference configuration, turned with it. */
    turned(direction, body, poses) {
      return body === 0 ? direction : Screws.subtract(this.carried(direction, body, poses), this.carried([0, 0, 0], body, poses));
    }

    // -- values: arrows in proportion --

    share(value, key) {
      const largest = this.largest[key];
      return largest > 0 ? (Math.abs(value) / largest) * 0.3 * this.size * this.boost : 0;
    }

    /* A value as text, 0 where it is rounding noise beside the largest of its kind. */
    amount(value, key, count = 3) {
      return digits(Math.abs(value) < 1e-11 * this.largest[key] ? 0 : value, count);
    }

    comOf(body, poses) {
      return this.carried(body.com, this.data.bodies.indexOf(body), poses);
    }

    /* A point of a body (its index; 0 is the ground), carried from the reference configuration. */
    carried(at, body, poses) {
      if (body === 0) {
        return at;
      }
      const pose = poses[body - 1];
      return [0, 1, 2].map((i) => pose[i] * at[0] + pose[3 + i] * at[1] + pose[6 + i] * at[2] + pose[9 + i]);
    }

    posesOf(state) {
      return this.model.columns(this.model.call("body_poses", state).poses, 12);
    }

    momentaOf(state) {
      if (!this.model.has("momentum_screws")) {
        return [];
      }
      const poses = this.posesOf(state), momenta = this.model.columns(this.model.call("momentum_screws", state).momenta, 6);
      return this.data.bodies.filter((body) => body.mass !== null).map((body, k) => ({ body, screw: momenta[k], com: this.comOf(body, poses) }));
    }

    draw_momentum(state, pen) {
      this.momentaOf(state).forEach(({ screw, com }) => {
        const axis = Screws.axis(screw, com, 1e-9 * (this.largest.p || 1));
        const away = Screws.norm(Screws.subtract(axis.point, com));
        if (!Number.isFinite(axis.pitch) || away > 1.5 * this.size) {
          // almost a couple, its axis far outside the picture: momentum at the centre of mass and moment about it
          const p = Screws.first(screw), about = Screws.subtract(Screws.second(screw), Screws.cross(com, p));
          pen.arrow(com, Screws.unit(p), Math.max(this.share(Screws.norm(p), "p"), 1e-6 * this.size));
          this.moment(pen, com, about, "spin");
          return;
        }
        if (away > 0.03 * this.size) {
          pen.axis(Screws.scale(0.5, Screws.add(axis.point, com)), Screws.unit(Screws.subtract(axis.point, com)), away);
        }
        const length = this.share(axis.size, "p");
        if (length > 0.004 * this.size) {
          pen.arrow(axis.point, axis.direction, length);
          this.label(`${digits(axis.size)} kg m/s`, Screws.add(axis.point, Screws.scale(length, axis.direction)), "momentum", axis.size / this.largest.p);
        }
        this.moment(pen, axis.point, Screws.scale(axis.size * axis.pitch, axis.direction), "spin");
      });
    }

    moment(pen, at, moment, key) {
      const size = Screws.norm(moment), radius = 0.28 * this.share(size, key);
      if (radius > 0.009 * this.size) {
        pen.arc(at, Screws.unit(moment), radius);
      }
    }

    reactionsOf(state) {
      if (!state.reactions) {
        return [];
      }
      const points = this.model.columns(this.model.call("joint_points", state).points, 3);
      return this.model.columns(state.reactions, 6).map((wrench, j) => {
        const force = Screws.first(wrench);
        return { force, moment: Screws.subtract(Screws.second(wrench), Screws.cross(points[j], force)), at: points[j] };
      });
    }

    draw_reactions(state, pen) {
      this.reactionsOf(state).forEach(({ force, moment, at }) => {
        const size = Screws.norm(force), length = this.share(size, "force");
        if (length > 0.01 * this.size) {
          const direction = Screws.unit(force);
          pen.arrow(at, direction, length);
          this.label(`${digits(size)} N`, Screws.add(at, Screws.scale(length, direction)), "reactions", size / this.largest.force);
        }
        this.moment(pen, at, moment, "moment");
      });
    }

    draw_drives(state, pen) {
      if (!state.u) {
        return;
      }
      const screws = this.screwsOf(state);
      this.data.drives.forEach((drive, k) => {
        const screw = screws[this.data.joints[drive.joint].screws + drive.freedom];
        const slide = this.slides(drive), value = state.u[k], length = this.share(value, slide ? "drive" : "torque");
        const direction = Screws.scale(value < 0 ? -1 : 1, Screws.unit(slide ? Screws.second(screw) : Screws.first(screw)));
        const at = slide ? this.beside(drive.joint, direction) : this.points[drive.joint];
        if (slide && length > 0.004 * this.size) {
          pen.arrow(at, direction, length, { thick: 1.5 });
        } else if (length > 0.02 * this.size) {
          pen.arc(at, direction, Math.max(0.03 * this.size, 0.4 * length), { thick: 1.3 });
        }
        this.label(`${this.amount(value, slide ? "drive" : "torque")} ${drive.unit}`, Screws.add(at, Screws.scale(slide ? length : 0.04 * this.size, direction)), "drives", 4);
      });
    }

    // -- centres of mass and names --

    draw_masses(state) {
      const poses = this.posesOf(state);
      let total = 0, sum = [0, 0, 0];
      for (const { mesh, body } of this.balls) {
        const at = body === null ? Screws.scale(1 / total, sum) : this.comOf(body, poses);
        if (body !== null) {
          total += body.mass;
          sum = Screws.add(sum, Screws.scale(body.mass, at));
        } else {
          this.label(`total ${digits(total)} kg`, at, "masses", 2);
        }
        mesh.position.copy(vector(at));
      }
    }

    draw_points(state) {
      const poses = this.posesOf(state);
      this.data.points.forEach(({ name, body, at }) => {
        this.label(name, this.carried(at, body, poses), "points", 1);
      });
    }

    draw_joints() {
      this.data.joints.forEach((joint, j) => this.label(joint.name, this.points[j], "joints", 0.5));
    }
  }

  return { ALL, Set, digits };
})();
