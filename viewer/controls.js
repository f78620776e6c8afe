// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The camera and what moves it: mouse, fingers, keys, and flights from one view to another.
"use strict";

const Controls = (() => {
  const slope = Math.tan(15 * Math.PI / 180);   // of pictures in perspective: 30 degrees high
  const filled = 0.92;                          // share of the window that the surface fills at first
  const flight = 700;                           // ms

  const ease = t => t * t * (3 - 2 * t);

  class View {
    constructor(centre, turn, half) {
      this.centre = centre;   // Vector3 that is looked at
      this.turn = turn;       // Quaternion, from the viewer's frame to the molecule's
      this.half = half;       // half the height of what is seen at the centre, Å
    }
    clone() { return new View(this.centre.clone(), this.turn.clone(), this.half); }
    axis(x, y, z) { return new THREE.Vector3(x, y, z).applyQuaternion(this.turn); }
  }

  class Controls {
    /**
     * points   of the surface, which the first view fits into the window, with a margin around (Å)
     * frame    {right, up, towards} of the first view
     * changed  is called after every move
     * signal   ends it
     */
    constructor(canvas, {points, margin}, frame, changed, signal) {
      this.canvas = canvas;
      this.points = points;
      this.margin = margin;
      this.changed = changed;
      this.inPerspective = Boolean(frame.perspective);
      const matrix = new THREE.Matrix4().makeBasis(...["right", "up", "towards"].map(
        name => new THREE.Vector3(...frame[name])));
      this.firstTurn = new THREE.Quaternion().setFromRotationMatrix(matrix);
      this.flat = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
      this.deep = new THREE.PerspectiveCamera(30, 1, 0.1, 1000);
      this.fingers = new Map();
      this.view = this.firstView();
      this.radius = this.reach();
      this.atFirst = true;
      this.listen(signal);
    }

    get camera() { return this.inPerspective ? this.deep : this.flat; }
    get aspect() { return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight); }

    /** Extent of the points along a direction: [lowest, highest]. */
    extent(axis) {
      let low = Infinity, high = -Infinity;
      for (let i = 0; i < this.points.length; i += 3) {
        const s = axis.x * this.points[i] + axis.y * this.points[i + 1] + axis.z * this.points[i + 2];
        if (s < low) low = s;
        if (s > high) high = s;
      }
      return [low, high];
    }

    /** All of the surface, as large as fits, as in pictures. */
    firstView(aspect = this.aspect) {
      const view = new View(new THREE.Vector3(), this.firstTurn.clone(), 1);
      const halves = [view.axis(1, 0, 0), view.axis(0, 1, 0), view.axis(0, 0, 1)].map(axis => {
        const [low, high] = this.extent(axis);
        view.centre.addScaledVector(axis, (low + high) / 2);
        return (high - low) / 2;
      });
      view.half = (Math.max(halves[1], halves[0] / aspect, 1) + this.margin) / filled;
      if (this.inPerspective) view.half += halves[2] * slope;
      return view;
    }

    /** After the window has changed: all of the surface again, unless one has moved. */
    refit() {
      if (this.atFirst) this.view = this.firstView();
      this.changed();
    }

    /** The farthest point from the middle, Å. */
    reach() {
      const c = this.view.centre;
      let most = 0;
      for (let i = 0; i < this.points.length; i += 3)
        most = Math.max(most, (this.points[i] - c.x) ** 2 + (this.points[i + 1] - c.y) ** 2 +
                              (this.points[i + 2] - c.z) ** 2);
      this.middle = c.clone();
      return Math.sqrt(most) + 3;
    }

    /** Puts the camera where the view says. */
    place(aspect = this.aspect) {
      const {view, camera} = this, towards = view.axis(0, 0, 1);
      const back = towards.dot(this.middle.clone().sub(view.centre));   // of the middle, from what is looked at
      const distance = this.inPerspective ? view.half / slope : Math.max(0, back) + 2 * this.radius;
      camera.position.copy(view.centre).addScaledVector(towards, distance);
      camera.quaternion.copy(view.turn);
      camera.near = Math.max(distance - back - this.radius, this.inPerspective ? 0.02 * view.half : 0);
      camera.far = Math.max(distance - back + this.radius, camera.near + 1);
      if (this.inPerspective) {
        camera.aspect = aspect;
      } else {
        camera.top = view.half;
        camera.bottom = -view.half;
        camera.right = view.half * aspect;
        camera.left = -camera.right;
      }
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
    }

    /** Å that a pixel covers at the centre. */
    get pixel() { return 2 * this.view.half / Math.max(1, this.canvas.clientHeight); }

    rotate(dx, dy) {
      const angle = Math.hypot(dx, dy) * 0.006;
      if (angle === 0) return;
      this.stop();
      const axis = this.view.axis(-dy, -dx, 0).normalize();
      this.view.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(axis, angle)).normalize();
      this.changed();
    }

    roll(angle) {
      this.view.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(this.view.axis(0, 0, 1), angle)).normalize();
    }

    pan(dx, dy) {
      this.stop();
      this.view.centre.addScaledVector(this.view.axis(1, 0, 0), -dx * this.pixel)
                      .addScaledVector(this.view.axis(0, 1, 0), dy * this.pixel);
      this.changed();
    }

    /** Keeps the point under (x, y), pixels of the window from its middle, y upwards. */
    zoom(factor, x = 0, y = 0) {
      this.stop();
      const half = Math.min(Math.max(this.view.half * factor, 0.5), 20 * this.radius);
      const share = 1 - half / this.view.half;
      this.view.centre.addScaledVector(this.view.axis(1, 0, 0), share * x * this.pixel)
                      .addScaledVector(this.view.axis(0, 1, 0), share * y * this.pixel);
      this.view.half = half;
      this.changed();
    }

    /** Moves to another view, at once for those who want no motion. */
    fly(target) {
      this.stop();
      if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
        this.view = target;
        return this.changed();
      }
      const from = this.view.clone(), begin = performance.now();
      const step = now => {
        const t = ease(Math.min(1, Math.max(0, (now - begin) / flight)));
        this.view.centre.lerpVectors(from.centre, target.centre, t);
        THREE.Quaternion.slerp(from.turn, target.turn, this.view.turn, t);
        this.view.half = from.half * Math.pow(target.half / from.half, t);
        this.flying = t < 1 ? requestAnimationFrame(step) : 0;
        this.changed();
      };
      this.flying = requestAnimationFrame(step);
    }

    stop() {
      this.atFirst = false;
      if (this.flying) cancelAnimationFrame(this.flying);
      this.flying = 0;
    }

    reset() {
      this.fly(this.firstView());
      this.atFirst = true;
    }

    /** Looks at a point of the molecule and what lies within `half` Å of it, from the same side as now or another. */
    lookAt(point, half, turn = this.view.turn) { this.fly(new View(point.clone(), turn.clone(), half || this.view.half)); }

    /** The turn that is nearest to now's and sees a direction from the side. */
    aside(direction) {
      const towards = this.view.axis(0, 0, 1), along = direction.clone().normalize();
      const across = towards.clone().addScaledVector(along, -along.dot(towards));
      if (across.length() < 1e-3) across.copy(this.view.axis(1, 0, 0));
      return new THREE.Quaternion().setFromUnitVectors(towards, across.normalize()).multiply(this.view.turn);
    }

    /** The ray through a point of the window: {origin, direction} in the molecule's frame. */
    ray(clientX, clientY) {
      const box = this.canvas.getBoundingClientRect();
      const x = (clientX - box.left - box.width / 2) * this.pixel, y = (box.height / 2 - clientY + box.top) * this.pixel;
      const target = this.view.centre.clone().addScaledVector(this.view.axis(1, 0, 0), x)
                                             .addScaledVector(this.view.axis(0, 1, 0), y);
      const eye = this.camera.position.clone();
      const direction = this.inPerspective ? target.clone().sub(eye).normalize() : this.view.axis(0, 0, -1);
      const origin = this.inPerspective ? eye : target.addScaledVector(direction, -4 * this.radius);
      return {origin, direction};
    }

    listen(signal) {
      const on = (name, f, options) => this.canvas.addEventListener(name, f, {signal, ...options});
      on("pointerdown", e => this.down(e));
      on("pointermove", e => this.move(e));
      for (const name of ["pointerup", "pointercancel"]) on(name, e => this.up(e));
      on("contextmenu", e => e.preventDefault());
      on("wheel", e => this.wheel(e), {passive: false});
      on("keydown", e => this.key(e));
    }

    down(e) {
      this.canvas.setPointerCapture(e.pointerId);
      this.fingers.set(e.pointerId, {x: e.clientX, y: e.clientY});
      this.moved = this.fingers.size === 1 ? 0 : Infinity;   // only one finger clicks
      this.canvas.classList.add("dragging");
    }

    move(e) {
      const finger = this.fingers.get(e.pointerId);
      if (!finger) return;
      const before = this.grip();
      const dx = e.clientX - finger.x, dy = e.clientY - finger.y;
      finger.x = e.clientX;
      finger.y = e.clientY;
      this.moved += Math.abs(dx) + Math.abs(dy);
      if (this.fingers.size > 1) return this.pinch(before, this.grip());
      if (this.moved < 4) return;
      if (e.buttons === 1 && !e.shiftKey && !e.ctrlKey && !e.metaKey) this.rotate(dx, dy);
      else this.pan(dx, dy);
    }

    /** Middle, distance and direction of the first two fingers. */
    grip() {
      const [a, b] = [...this.fingers.values()];
      if (!b) return null;
      return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, span: Math.hypot(a.x - b.x, a.y - b.y) || 1,
              angle: Math.atan2(b.y - a.y, b.x - a.x)};
    }

    pinch(before, after) {
      const box = this.canvas.getBoundingClientRect();
      this.pan(after.x - before.x, after.y - before.y);
      this.roll(after.angle - before.angle);
      this.zoom(before.span / after.span, after.x - box.left - box.width / 2, box.height / 2 - after.y + box.top);
    }

    up(e) {
      if (!this.fingers.delete(e.pointerId)) return;
      if (this.fingers.size === 0) this.canvas.classList.remove("dragging");
      if (e.type === "pointerup" && this.moved < 4 && e.button === 0 && this.clicked) this.clicked(e);
    }

    wheel(e) {
      e.preventDefault();
      const box = this.canvas.getBoundingClientRect();
      const lines = e.deltaMode === 1 ? 30 * e.deltaY : e.deltaY;
      this.zoom(Math.exp(Math.max(-100, Math.min(100, lines)) * (e.ctrlKey ? 0.01 : 0.0015)),
                e.clientX - box.left - box.width / 2, box.height / 2 - e.clientY + box.top);
    }

    key(e) {
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
      const way = arrows[e.key];
      if (way && e.shiftKey) this.pan(20 * way[0], 20 * way[1]);
      else if (way) this.rotate(20 * way[0], 20 * way[1]);
      else if (e.key === "+" || e.key === "=") this.zoom(0.9);
      else if (e.key === "-") this.zoom(1 / 0.9);
      else return;
      e.preventDefault();
    }
  }

  return Controls;
})();
