"use strict";

/* The picture: renderer, camera, light, bodies and joints in their poses, and text labels over it. */
const Stage = (() => {
  const L = library;
  const VIEWS = { Oblique: [-0.95, -1.6, 0.85], Front: [0, -1, 0], Side: [1, 0, 0], Top: [0, -1e-4, 1] };

  /* Labels are texts over the picture; of those that would overlap the more important one stays. */
  class Labels {
    constructor(holder) {
      this.holder = holder;
      this.wanted = [];
      this.pool = [];
      this.pen = document.createElement("canvas").getContext("2d");
      this.widths = new Map();
    }

    /* Width of a label with its margins [px]. */
    width(text) {
      if (!this.widths.has(text)) {
        this.pen.font = `12px ${getComputedStyle(document.body).fontFamily}`;
        this.widths.set(text, this.pen.measureText(text).width + 12);
      }
      return this.widths.get(text);
    }

    begin() {
      this.wanted = [];
    }

    add(text, at, id, priority) {
      this.wanted.push({ text, at, id, priority });
    }

    end(camera, width, height) {
      const frame = this.holder.getBoundingClientRect();
      const taken = Array.from(this.holder.parentElement.querySelectorAll(".views, .chip:not([hidden])"), (item) => {
        const box = item.getBoundingClientRect();
        return { x: box.left - frame.left, y: box.top - frame.top, wide: box.width, high: box.height };
      });
      let used = 0;
      for (const label of this.wanted.sort((a, b) => b.priority - a.priority)) {
        const seen = Shapes.vector(label.at).project(camera);
        if (Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1 || seen.z > 1) {
          continue;
        }
        const wide = this.width(label.text), high = 19;
        const place = [[10, -20], [10, 6], [-10 - wide, -20], [-10 - wide, 6]].map(([dx, dy]) => ({
          x: ((seen.x + 1) / 2) * width + dx, y: ((1 - seen.y) / 2) * height + dy, wide, high,
        })).find((box) => box.x >= 2 && box.y >= 2 && box.x + wide <= width - 2 && box.y + high <= height - 2
          && taken.every((t) => box.x + wide < t.x || t.x + t.wide < box.x || box.y + high < t.y || t.y + t.high < box.y));
        if (!place) {
          continue;
        }
        taken.push(place);
        const item = this.item(used++);
        if (item.textContent !== label.text) {
          item.textContent = label.text;
        }
        item.className = `label label-${label.id}`;
        item.style.transform = `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px)`;
        item.hidden = false;
      }
      for (let k = used; k < this.pool.length; ++k) {
        this.pool[k].hidden = true;
      }
    }

    item(k) {
      if (k === this.pool.length) {
        const made = document.createElement("div");
        this.holder.append(made);
        this.pool.push(made);
      }
      return this.pool[k];
    }
  }

  class Picture {
    constructor(holder, canvas, data, theme) {
      Object.assign(this, { holder, data });
      this.renderer = new L.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
      this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      this.scene = new L.Scene();
      this.overlay = new L.Scene();  // screws, arrows, centres of mass: in front of all bodies
      this.camera = new L.PerspectiveCamera(32, 1, 0.01, 100);
      this.camera.up.set(0, 0, 1);
      this.controls = new L.OrbitControls(this.camera, canvas);
      this.controls.addEventListener("change", () => { this.dirty = true; });
      this.labels = new Labels(holder.querySelector(".labels"));
      this.extent();
      this.paint(theme);
      this.first = this.plane();
      this.see(this.first);
    }

    /* Middle and size of the mechanism in its reference configuration. */
    extent() {
      const all = this.data.bodies.flatMap((b) => [...b.plate, ...b.bar, ...b.struts.flat()]).concat(this.data.points.map((p) => p.at));
      this.places = all.length ? all : [[0, 0, 0]];
      this.frame([]);
      this.size = this.spread;
      this.camera.near = 0.01 * this.size;
      this.camera.far = 60 * this.size;
      this.controls.minDistance = 0.15 * this.size;
      this.controls.maxDistance = 20 * this.size;
    }

    /* What has to be in the picture: the reference configuration and further points. */
    frame(points) {
      this.framed = [...this.places, ...points];
      const low = [0, 1, 2].map((k) => Math.min(...this.framed.map((p) => p[k])));
      const high = [0, 1, 2].map((k) => Math.max(...this.framed.map((p) => p[k])));
      this.middle = [0, 1, 2].map((k) => (low[k] + high[k]) / 2);
      this.spread = Math.hypot(...[0, 1, 2].map((k) => high[k] - low[k])) || this.data.length;
      this.lowest = low[2];
      if (this.view) {
        this.lay();
        if (!this.touched) {
          this.see(this.view);
        }
      }
    }

    /* The grid below everything that is framed. */
    lay() {
      this.grid.position.set(this.middle[0], this.middle[1], this.lowest - 0.045 * this.size);
    }

    /* The view along the axes where all joints turn about parallel ones, as those of a planar mechanism do. */
    plane() {
      const axes = this.data.joints.filter(({ type }) => type !== "fixed").map(({ type, axes: own }) => (type === "R" ? own[0] : null));
      const views = { Side: 0, Front: 1, Top: 2 };
      return Object.keys(views).find((view) => axes.every((axis) => axis && Math.abs(axis[views[view]]) > 1 - 1e-9)) ?? "Oblique";
    }

    /* Everything in the colours of a theme. */
    paint(theme) {
      this.theme = theme;
      this.colours = Shapes.PALETTE[theme];
      this.scene.clear();
      this.scene.background = new L.Color(this.colours.background);
      for (const scene of [this.scene, this.overlay]) {
        scene.children.filter((item) => item.isLight).forEach((light) => scene.remove(light));
        const sun = new L.DirectionalLight("#ffffff", 1.6);
        sun.position.set(-0.6, -1, 1.6);
        scene.add(new L.HemisphereLight("#ffffff", theme === "light" ? "#9aa0a6" : "#50565c", 2.2), sun);
      }
      this.grid = new L.GridHelper(3 * this.size, 24, this.colours.grid, this.colours.grid);
      this.grid.rotation.x = Math.PI / 2;
      this.scene.add(this.grid);
      this.lay();
      this.build();
      this.dirty = true;
    }

    build() {
      const colours = this.colours, paint = {};
      for (const kind of ["ground", "link", "platform"]) {
        paint[kind] = Shapes.material(colours[kind]);
        paint[`${kind}_sheet`] = Shapes.material(colours[kind], { side: L.DoubleSide, transparent: true, opacity: kind === "ground" ? 0.22 : 0.38, depthWrite: false });
      }
      paint.joint = Shapes.material(colours.joint);
      paint.driven = Shapes.material(colours.driven);
      paint.rod = Shapes.material(colours.rod);
      paint.chosen = Shapes.material(colours.chosen);
      paint.chosen_sheet = Shapes.material(colours.chosen, { side: L.DoubleSide, transparent: true, opacity: 0.5, depthWrite: false });
      this.paints = paint;
      this.groups = this.data.bodies.map((body, k) => {
        const kind = k === 0 ? "ground" : k === this.data.platform && this.data.platform_named ? "platform" : "link";
        const group = new L.Group();
        group.matrixAutoUpdate = false;
        group.add(Shapes.body(body, kind, this.size, k === this.chosen ? { ...paint, [kind]: paint.chosen, [`${kind}_sheet`]: paint.chosen_sheet } : paint));
        this.scene.add(group);
        return group;
      });
      this.slides = [];
      this.data.joints.forEach((joint) => {
        const made = Shapes.joint(joint, this.size, paint);
        this.groups[joint.parent].add(made.parent);
        this.groups[joint.child].add(made.child);
        if (made.slide) {
          const rod = new L.Mesh(new L.CylinderGeometry(0.0085 * this.size, 0.0085 * this.size, 1, 18), paint.rod);
          this.scene.add(rod);
          this.slides.push({ joint, rod });
        }
      });
    }

    /* All bodies anew: another one is chosen, or their shapes have changed. */
    rebuild() {
      this.groups.forEach((group) => this.scene.remove(group));
      this.slides.forEach(({ rod }) => this.scene.remove(rod));
      this.build();
    }

    /* The body that is drawn nearest to a place of the picture [px]; -1 where there is none. */
    pick(x, y) {
      const seen = (at, k) => {
        const p = Shapes.vector(at).applyMatrix4(this.groups[k].matrix).project(this.camera);
        return [((p.x + 1) / 2) * this.width, ((1 - p.y) / 2) * this.height];
      };
      const distanceTo = this.camera.position.distanceTo(this.controls.target), half = Math.tan((this.camera.fov * Math.PI) / 360);
      const thick = (0.02 * this.size * this.height) / (2 * half * distanceTo);  // pixels: half of what a joint is wide
      let best = -1, least = 12;  // pixels: as wide as a finger's middle
      this.data.bodies.forEach((body, k) => {
        const rods = [...body.struts, ...body.bar.slice(1).map((to, i) => [body.bar[i], to])];
        const corners = body.plate.map((corner) => seen(corner, k)), edges = body.plate.map((_, i) => [body.plate[i], body.plate[(i + 1) % body.plate.length]]);
        const lengths = [...rods, ...edges].map(([from, to]) => Math.max(0, distance([x, y], seen(from, k), seen(to, k)) - thick));
        const points = body.bar.length === 1 ? [Math.hypot(...seen(body.bar[0], k).map((p, i) => p - [x, y][i]))] : [];
        const found = Math.min(...lengths, ...points, corners.length > 2 && within([x, y], corners) ? 6 : Infinity);
        if (found < least || (found === least && k !== 0)) {
          [best, least] = [k, found];
        }
      });
      return best;
    }

    /* The picture again so that these points are in it, where nobody has turned it; whether it had to change. */
    keep(points) {
      const out = points.some((at) => {
        const p = Shapes.vector(at).project(this.camera);
        return Math.abs(p.x) > 0.97 || Math.abs(p.y) > 0.97;
      });
      if (out && !this.touched) {
        this.frame([...this.framed.slice(this.places.length), ...points]);
      }
      return out;
    }

    /* Bodies in their poses: 12 numbers each, rotation by columns and translation. */
    pose(poses) {
      poses.forEach((p, k) => {
        this.groups[k + 1].matrix.set(p[0], p[3], p[6], p[9], p[1], p[4], p[7], p[10], p[2], p[5], p[8], p[11], 0, 0, 0, 1);
      });
      for (const { joint, rod } of this.slides) {
        const [from, to] = [joint.parent, joint.child].map((body) => Shapes.vector(joint.point).applyMatrix4(this.groups[body].matrix));
        Shapes.place(rod, from.toArray(), to.clone().sub(from));
      }
      this.dirty = true;
    }

    /* The platform in the colour of a warning: 0 none, 1 at the singularity; any warning is at once yellow. */
    warn(level) {
      const colour = new L.Color(level > 0 ? this.colours.warn : this.colours.platform);
      colour.lerp(new L.Color(this.colours.danger), Math.max(0, level));
      this.paints.platform.color.copy(colour);
      this.paints.platform_sheet.color.copy(colour);
    }

    /* A view by name, from as near as everything framed allows. */
    see(name) {
      const towards = Shapes.vector(VIEWS[name]).normalize();
      const right = new L.Vector3(0, 0, 1).cross(towards).normalize(), up = towards.clone().cross(right);
      const room = 0.1 * this.size, half = Math.tan((this.camera.fov * Math.PI) / 360);
      const seen = this.framed.map((p) => Shapes.vector(p)).map((p) => [p.dot(right), p.dot(up), p.dot(towards)]);
      const middle = [0, 1, 2].map((k) => (Math.min(...seen.map((p) => p[k])) + Math.max(...seen.map((p) => p[k]))) / 2);
      const distance = Math.max(...seen.map(([x, y, z]) => Math.max(
        (Math.abs(x - middle[0]) + room) / (half * (this.camera.aspect || 1)), (Math.abs(y - middle[1]) + room) / half,
      ) + z - middle[2]));
      this.controls.target.set(0, 0, 0);
      [right, up, towards].forEach((axis, k) => this.controls.target.addScaledVector(axis, middle[k]));
      this.camera.position.copy(this.controls.target).addScaledVector(towards, 1.06 * distance);
      this.controls.update();
      this.view = name;
      this.dirty = true;
    }

    /* Turn by angles [rad], come nearer by a factor, move across by parts of the distance. */
    turn(right, up) {
      const arm = this.camera.position.clone().sub(this.controls.target), distance = arm.length();
      const azimuth = Math.atan2(arm.y, arm.x) + right;
      const elevation = Math.max(-1.55, Math.min(1.55, Math.asin(arm.z / distance) + up));
      arm.set(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
      this.camera.position.copy(this.controls.target).addScaledVector(arm, distance);
      this.controls.update();
      this.dirty = true;
    }

    zoom(factor) {
      const arm = this.camera.position.clone().sub(this.controls.target);
      const distance = Math.max(this.controls.minDistance, Math.min(this.controls.maxDistance, arm.length() * factor));
      this.camera.position.copy(this.controls.target).addScaledVector(arm.normalize(), distance);
      this.controls.update();
      this.dirty = true;
    }

    pan(right, up) {
      const distance = this.camera.position.distanceTo(this.controls.target), e = this.camera.matrix.elements;
      const step = new L.Vector3(e[0], e[1], e[2]).multiplyScalar(right * distance).add(new L.Vector3(e[4], e[5], e[6]).multiplyScalar(up * distance));
      this.camera.position.add(step);
      this.controls.target.add(step);
      this.controls.update();
      this.dirty = true;
    }

    resize() {
      const { clientWidth: width, clientHeight: height } = this.holder;
      if (width === this.width && height === this.height) {
        return;
      }
      Object.assign(this, { width, height });
      this.camera.aspect = width / Math.max(height, 1);
      this.camera.updateProjectionMatrix();
      this.renderer.setSize(width, height, false);
      if (this.view !== undefined && !this.touched) {
        this.see(this.view);
      }
      this.dirty = true;
    }

    render() {
      this.renderer.autoClear = true;
      this.renderer.render(this.scene, this.camera);
      this.renderer.autoClear = false;
      this.renderer.clearDepth();
      this.renderer.render(this.overlay, this.camera);
      this.labels.end(this.camera, this.width, this.height);
      this.dirty = false;
    }
  }

  /* From a point to a piece of a line, in the plane. */
  function distance([x, y], [ax, ay], [bx, by]) {
    const [dx, dy] = [bx - ax, by - ay], size = dx * dx + dy * dy;
    const t = size > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / size)) : 0;
    return Math.hypot(x - ax - t * dx, y - ay - t * dy);
  }

  /* Whether a point of the plane is inside a polygon. */
  function within([x, y], corners) {
    let inside = false;
    corners.forEach(([ax, ay], k) => {
      const [bx, by] = corners[(k + 1) % corners.length];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) {
        inside = !inside;
      }
    });
    return inside;
  }

  return { Picture, VIEWS };
})();
