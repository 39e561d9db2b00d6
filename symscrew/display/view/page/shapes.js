"use strict";

/* Solid shapes of bodies, joints and arrows. Lengths are multiples of the mechanism's size. */
const Shapes = (() => {
  const L = library;
  const UP = new L.Vector3(0, 1, 0);

  /* Colours of Okabe and Ito, told apart without colour vision too; what matters also differs in shape. */
  const PALETTE = {
    light: {
      background: "#f6f6f3", text: "#16181a", grid: "#d6d6d0", ground: "#85888c", link: "#4d5257", rod: "#8d949a",
      platform: "#0072b2", joint: "#f4f4f2", driven: "#d55e00", warn: "#f0c808", danger: "#9c0038",
      screws: "#56b4e9", constraints: "#009e73", freedoms: "#cc79a7", momentum: "#e69f00", reactions: "#16181a",
      drives: "#d55e00", axes: "#6b4fa0", limits: "#7a5c00", chosen: "#7b3fe4", com_dark: "#111111", com_light: "#ffffff",
    },
    dark: {
      background: "#14171a", text: "#eceff1", grid: "#2d3236", ground: "#7d8388", link: "#b6bcc2", rod: "#7f868c",
      platform: "#4aa3df", joint: "#e9ecee", driven: "#e8752a", warn: "#f0e442", danger: "#e0105c",
      screws: "#8fd0f5", constraints: "#1ec796", freedoms: "#e3a0c4", momentum: "#f0e442", reactions: "#eceff1",
      drives: "#ff8a4c", axes: "#b9a5e6", limits: "#e0c060", chosen: "#b48cff", com_dark: "#111111", com_light: "#ffffff",
    },
  };

  const vector = (a) => new L.Vector3(a[0], a[1], a[2]);

  function material(colour, options = {}) {
    return new L.MeshLambertMaterial({ color: colour, ...options });
  }

  /* A cylinder between two points. */
  function rod(from, to, radius, made) {
    const span = vector(to).sub(vector(from)), mesh = new L.Mesh(new L.CylinderGeometry(radius, radius, 1, 20), made);
    place(mesh, from, span);
    return mesh;
  }

  /* Put something that reaches from 0 to 1 ... or -1/2 to 1/2 along y between `from` and `from + span`. */
  function place(mesh, from, span) {
    const length = span.length();
    mesh.scale.set(1, Math.max(length, 1e-9), 1);
    mesh.quaternion.setFromUnitVectors(UP, length > 0 ? span.clone().divideScalar(length) : UP);
    mesh.position.copy(vector(from).addScaledVector(span, 0.5));
  }

  function along(object, direction) {
    object.quaternion.setFromUnitVectors(UP, vector(direction).normalize());
    return object;
  }

  /* A flat plate with these corners, visible from both sides, and its rim. */
  function plate(corners, made, rim, radius) {
    const group = new L.Group(), positions = [];
    for (let k = 1; k + 1 < corners.length; ++k) {
      positions.push(...corners[0], ...corners[k], ...corners[k + 1]);
    }
    const geometry = new L.BufferGeometry();
    geometry.setAttribute("position", new L.BufferAttribute(new Float32Array(positions), 3));
    geometry.computeVertexNormals();
    group.add(new L.Mesh(geometry, made));
    corners.forEach((corner, k) => {
      group.add(rod(corner, corners[(k + 1) % corners.length], radius, rim));
      const ball = new L.Mesh(new L.SphereGeometry(radius, 14, 10), rim);
      ball.position.copy(vector(corner));
      group.add(ball);
    });
    return group;
  }

  /* Triangles, their corners as singles in Base64. */
  function picture(text, made) {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)), geometry = new L.BufferGeometry();
    geometry.setAttribute("position", new L.BufferAttribute(new Float32Array(bytes.buffer), 3));
    geometry.computeVertexNormals();
    return new L.Mesh(geometry, made);
  }

  /* A body in the reference configuration. */
  function body(data, kind, size, paint) {
    const group = new L.Group();
    if (data.picture) {
      group.add(picture(data.picture, paint[`${kind}_sheet`]));
      return group;
    }
    const solid = paint[kind], sheet = paint[`${kind}_sheet`];
    const radius = size * (kind === "link" ? (data.outer ? 0.014 : 0.0085) : 0.007);
    if (data.plate.length > 2) {
      group.add(plate(data.plate, sheet, solid, radius));
      data.struts.forEach(([from, to]) => group.add(rod(from, to, 0.7 * radius, solid)));
    } else if (kind !== "ground") {
      for (let k = 0; k + 1 < data.bar.length; ++k) {
        group.add(rod(data.bar[k], data.bar[k + 1], Math.max(radius, 0.0085 * size), solid));
      }
    }
    if (kind === "ground" && data.plate.length <= 2) {
      data.bar.forEach((at) => {
        const foot = new L.Mesh(new L.CylinderGeometry(0.03 * size, 0.04 * size, 0.012 * size, 28), solid);
        foot.rotation.x = Math.PI / 2;
        foot.position.copy(vector(at)).z -= 0.03 * size;
        group.add(foot);
      });
    }
    return group;
  }

  /* A joint's two halves, by type: pins for R, sleeves for P, crosses for U, balls for S. */
  function joint(data, size, paint) {
    const parent = new L.Group(), child = new L.Group();
    const r = 0.0165 * size, colour = data.driven.length ? paint.driven : paint.joint;
    const put = (group, mesh, axis) => {
      if (axis) {
        along(mesh, axis);
      }
      mesh.position.copy(vector(data.point));
      group.add(mesh);
    };
    const pin = (group, axis, radius, length, made = colour) =>
      put(group, new L.Mesh(new L.CylinderGeometry(radius, radius, length, 24), made), axis);
    const [axis, other] = data.axes;
    if (data.type === "R") {
      pin(parent, axis, r, 3.2 * r);
      pin(child, axis, 0.55 * r, 4.6 * r, paint.link);
      if (data.driven.length) {
        [-0.7, 0.7].forEach((at) => collar(parent, data.point, axis, at * r, 1.12 * r, 0.3 * r, paint.link));
      }
    } else if (data.type === "P" || data.type === "C" || data.type === "H") {
      const sleeve = data.type === "P" ? new L.BoxGeometry(2.3 * r, 5 * r, 2.3 * r) : new L.CylinderGeometry(1.25 * r, 1.25 * r, 5 * r, 24);
      put(parent, new L.Mesh(sleeve, colour), axis);
      if (data.driven.length) {
        [-1.6, 1.6].forEach((at) => collar(parent, data.point, axis, at * r, 1.75 * r, 0.35 * r, paint.link));
      }
      if (data.type === "H") {
        [-1.5, -0.5, 0.5, 1.5].forEach((at) => collar(parent, data.point, axis, at * r, 1.4 * r, 0.18 * r, paint.link));
      }
    } else if (data.type === "U") {
      pin(parent, axis, 0.55 * r, 4.4 * r, colour);
      pin(child, other, 0.55 * r, 4.4 * r, colour);
      put(parent, new L.Mesh(new L.SphereGeometry(0.85 * r, 18, 12), paint.link));
    } else if (data.type === "S") {
      put(child, new L.Mesh(new L.SphereGeometry(1.35 * r, 26, 18), colour));
    } else if (data.type === "E") {
      put(parent, new L.Mesh(new L.CylinderGeometry(2.2 * r, 2.2 * r, 0.5 * r, 4), colour), axis);
    } else if (data.type === "fixed") {
      put(parent, new L.Mesh(new L.BoxGeometry(1.6 * r, 1.6 * r, 1.6 * r), paint.link));
    }
    return { parent, child, slide: ["P", "C", "H", "E"].includes(data.type) };
  }

  function turned(mesh) {
    const holder = new L.Group();
    mesh.rotation.x = Math.PI / 2;
    holder.add(mesh);
    return holder;
  }

  /* A ring about an axis, moved along it from a point. */
  function collar(group, point, axis, offset, radius, thickness, made) {
    const ring = along(turned(new L.Mesh(new L.TorusGeometry(radius, thickness, 10, 28), made)), axis);
    ring.position.copy(vector(point)).addScaledVector(vector(axis), offset);
    group.add(ring);
  }

  /* The sign of a centre of mass: a ball in quarters, dark and light. */
  function centre(radius, dark, light) {
    const group = new L.Group();
    for (let k = 0; k < 4; ++k) {
      for (let half = 0; half < 2; ++half) {
        const piece = new L.SphereGeometry(radius, 10, 8, (k * Math.PI) / 2, Math.PI / 2, (half * Math.PI) / 2, Math.PI / 2);
        group.add(new L.Mesh(piece, (k + half) % 2 ? dark : light));
      }
    }
    return group;
  }

  /*
   * Arrows, arcs and axes that are drawn anew for every state: `begin`, then any number of each, then `end`.
   * `look`: { dashed, tail } where tail is "none", "ball" or "box".
   */
  class Pen {
    constructor(scene, colour, size, look = {}) {
      this.group = new L.Group();
      this.size = size;
      this.look = look;
      this.solid = new L.MeshBasicMaterial({ color: colour });
      this.pools = { arrow: [], arc: [], axis: [], stroke: [] };
      this.used = { arrow: 0, arc: 0, axis: 0, stroke: 0 };
      scene.add(this.group);
    }

    begin() {
      this.used = { arrow: 0, arc: 0, axis: 0, stroke: 0 };
    }

    end() {
      for (const [kind, pool] of Object.entries(this.pools)) {
        pool.forEach((item, k) => { item.visible = k < this.used[kind]; });
      }
    }

    take(kind, make) {
      const pool = this.pools[kind];
      if (this.used[kind] === pool.length) {
        const item = make();
        pool.push(item);
        this.group.add(item);
      }
      return pool[this.used[kind]++];
    }

    /* An arrow of a length along a unit direction; `both` puts a head on either end. */
    arrow(from, direction, length, { both = false, thick = 1 } = {}) {
      const r = 0.0048 * this.size * thick, head = Math.min(4.6 * 0.0048 * this.size * thick, 0.5 * length);
      const item = this.take("arrow", () => this.newArrow());
      const [shaft, tip, back, tail] = item.children;
      along(item, direction);
      item.position.copy(vector(from));
      const start = both ? head : 0;
      shaft.scale.set(r, Math.max(length - head - start, 1e-9), r);
      shaft.position.y = start + (length - head - start) / 2;
      [tip, back].forEach((cone) => cone.scale.set(0.42 * head, head, 0.42 * head));
      tip.position.y = length - head / 2;
      back.position.y = head / 2;
      back.visible = both;
      tail.visible = !both && tail.userData.kind !== "none";
      tail.scale.setScalar((tail.userData.kind === "box" ? 1.5 : 2.1) * r);
    }

    newArrow() {
      const item = new L.Group();
      const shaft = new L.Mesh(this.look.dashed ? dashes(5) : new L.CylinderGeometry(1, 1, 1, 12), this.solid);
      const tip = new L.Mesh(new L.ConeGeometry(1, 1, 18), this.solid);
      const back = new L.Mesh(new L.ConeGeometry(1, 1, 18), this.solid);
      back.rotation.x = Math.PI;
      const kind = this.look.tail ?? "none";
      const tail = new L.Mesh(kind === "box" ? new L.BoxGeometry(2, 0.8, 2) : new L.SphereGeometry(1, 14, 10), this.solid);
      tail.userData.kind = kind;
      item.add(shaft, tip, back, tail);
      return item;
    }

    /* An arc with a head about a unit direction: three quarters of a circle. */
    arc(centre, direction, radius, { thick = 1 } = {}) {
      const item = this.take("arc", () => this.newArc());
      along(item, direction);
      item.position.copy(vector(centre));
      item.scale.setScalar(radius);
      item.children[0].children.forEach((part) => { part.visible = true; });
      item.userData.head.scale.setScalar(Math.min(1.7, (0.032 * this.size * thick) / radius));
    }

    newArc() {
      const item = new L.Group(), flat = new L.Group();
      flat.rotation.x = -Math.PI / 2;
      const bow = new L.Mesh(new L.TorusGeometry(1, 0.05, 10, 48, 1.5 * Math.PI), this.solid);
      const head = new L.Group(), cone = new L.Mesh(new L.ConeGeometry(0.34, 0.8, 16), this.solid);
      cone.position.x = 0.3;
      cone.rotation.z = -Math.PI / 2;
      head.position.y = -1;
      head.add(cone);
      flat.add(bow, head);
      item.add(flat);
      item.userData.head = head;
      return item;
    }

    /* A thin rod between two points. */
    stroke(from, to, thick = 1) {
      const item = this.take("stroke", () => new L.Mesh(new L.CylinderGeometry(1, 1, 1, 8), this.solid));
      const r = 0.0026 * this.size * thick, span = vector(to).sub(vector(from));
      place(item, from, span);
      item.scale.set(r, item.scale.y, r);
    }

    /* A thin line through a point, to both sides. */
    axis(point, direction, length) {
      const item = this.take("axis", () => new L.Mesh(dashes(13), this.solid));
      const r = 0.0021 * this.size;
      along(item, direction);
      item.position.copy(vector(point));
      item.scale.set(r, length, r);
    }
  }

  /* A dashed cylinder from -1/2 to 1/2 along y. */
  function dashes(count) {
    const pieces = [], pitch = 1 / (count - 0.4);
    for (let k = 0; k < count; ++k) {
      pieces.push(new L.CylinderGeometry(1, 1, 0.6 * pitch, 10).translate(0, -0.5 + (k + 0.3) * pitch, 0));
    }
    return L.mergeGeometries(pieces);
  }

  return { PALETTE, Pen, vector, material, place, rod, body, joint, centre };
})();
