// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms beneath or beside the surface, as spheres, sticks, or sticks and balls, made when they are first shown.
"use strict";

const Atoms = (() => {
  // Cordero et al., Dalton Trans. 2008, 2832; of what is most common.
  const covalent = {H: 0.31, D: 0.31, C: 0.76, N: 0.71, O: 0.66, F: 0.57, P: 1.07, S: 1.05, CL: 1.02, BR: 1.20, I: 1.39,
                    SE: 1.20, B: 0.84, SI: 1.11, FE: 1.32, ZN: 1.22, MG: 1.41, CA: 1.76, MN: 1.39, CU: 1.32, CO: 1.26,
                    NI: 1.24, NA: 1.66, K: 2.03};
  const tolerance = 0.4;   // Å

  /** Pairs of atoms that are near enough to be bonded. */
  function bonds({atoms, info}) {
    const {points: p, count} = atoms;
    const size = Array.from(atoms.element, (e, i) =>
      covalent[info.atoms.elements[e].toUpperCase()] || 0.45 * atoms.radius[i]);
    const cell = 2 * Math.max(0.5, ...new Set(size)) + tolerance;
    const at = (i, k) => Math.floor(p[3 * i + k] / cell);
    const key = (x, y, z) => x + "," + y + "," + z;
    const cells = new Map(), found = [];
    for (let i = 0; i < count; ++i) {
      const [x, y, z] = [at(i, 0), at(i, 1), at(i, 2)];
      for (let dx = -1; dx <= 1; ++dx) for (let dy = -1; dy <= 1; ++dy) for (let dz = -1; dz <= 1; ++dz)
        for (const j of cells.get(key(x + dx, y + dy, z + dz)) || []) {
          const d = Math.hypot(p[3 * i] - p[3 * j], p[3 * i + 1] - p[3 * j + 1], p[3 * i + 2] - p[3 * j + 2]);
          if (d > 0.4 && d < size[i] + size[j] + tolerance) found.push([j, i]);
        }
      const home = key(x, y, z);
      cells.has(home) ? cells.get(home).push(i) : cells.set(home, [i]);
    }
    return found;
  }

  const pairsOf = ends => Array.from({length: ends.length / 2}, (_, b) => [ends[2 * b], ends[2 * b + 1]]);

  const perInstance = (array, size) => new THREE.InstancedBufferAttribute(array, size);

  class Atoms {
    /**
     * data    {atoms, info}, and perhaps bonds: the ends of each; without them, near atoms are bonded
     * shared  uniforms that all materials have (the cut, the projection)
     * planes  of bytes, three: the colours
     * stick   radius of sticks, Å
     */
    constructor(data, shared, planes, stick = Atoms.thickness) {
      this.stick = stick;
      this.data = data;
      this.shared = shared;
      this.group = new THREE.Group();
      const n = data.atoms.count;
      this.colour = i => [planes[i] / 255, planes[n + i] / 255, planes[2 * n + i] / 255];
    }

    material(vertexShader, fragmentShader, uniforms) {
      return new THREE.ShaderMaterial({vertexShader, fragmentShader, uniforms: {...this.shared, ...uniforms}});
    }

    add(geometry, material) {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = -1;
      this.group.add(mesh);
      return mesh;
    }

    makeBalls() {
      const {points, radius, count} = this.data.atoms;
      const square = new THREE.InstancedBufferGeometry();
      square.setAttribute("position", new THREE.BufferAttribute(
        new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
      const ball = new Float32Array(4 * count), colour = new Float32Array(3 * count);
      for (let i = 0; i < count; ++i) {
        ball.set([points[3 * i], points[3 * i + 1], points[3 * i + 2], radius[i]], 4 * i);
        colour.set(this.colour(i), 3 * i);
      }
      square.setAttribute("ball", perInstance(ball, 4));
      square.setAttribute("colour", perInstance(colour, 3));
      square.maxInstancedCount = count;
      this.sizes = {size: {value: Atoms.scale}, fixedSize: {value: 0}};
      this.balls = this.add(square, this.material(Shaders.ballVertex, Shaders.ballFragment, this.sizes));
    }

    makeSticks() {
      const pairs = this.data.bonds ? pairsOf(this.data.bonds) : bonds(this.data);
      const {points: p} = this.data.atoms, n = 2 * pairs.length;
      this.pairs = pairs;
      const cylinder = new THREE.InstancedBufferGeometry();
      const shape = new THREE.CylinderBufferGeometry(1, 1, 1, 14, 1, true);
      cylinder.setIndex(shape.index);
      cylinder.setAttribute("position", shape.attributes.position);
      cylinder.setAttribute("normal", shape.attributes.normal);
      const start = new Float32Array(3 * n), end = new Float32Array(3 * n), colour = new Float32Array(3 * n);
      pairs.forEach((pair, b) => pair.forEach((i, half) => {
        const j = pair[1 - half], to = 3 * (2 * b + half);
        for (let k = 0; k < 3; ++k) {
          start[to + k] = p[3 * i + k];
          end[to + k] = 0.5 * (p[3 * i + k] + p[3 * j + k]);
        }
        colour.set(this.colour(i), to);
      }));
      cylinder.setAttribute("start", perInstance(start, 3));
      cylinder.setAttribute("end", perInstance(end, 3));
      cylinder.setAttribute("colour", perInstance(colour, 3));
      cylinder.maxInstancedCount = n;
      this.sticks = this.add(cylinder, this.material(Shaders.stickVertex, Shaders.stickFragment,
                                                     {thickness: {value: this.stick}}));
    }

    /** how: none, sticks, spheres, or both: sticks and balls of the atoms' radii */
    show(how) {
      this.shown = how;
      const withSticks = how === "sticks" || how === "both";
      if (how !== "none" && !this.balls) this.makeBalls();
      if (withSticks && !this.sticks) this.makeSticks();
      if (this.balls) {
        this.balls.visible = how !== "none";
        this.sizes.size.value = how === "both" ? 1 : Atoms.scale;
        this.sizes.fixedSize.value = how === "sticks" ? this.stick : 0;
      }
      if (this.sticks) this.sticks.visible = withSticks;
    }

    /** Makes those atoms vanish for which isThere(i) is false; balls and sticks must have been made. */
    restrict(isThere) {
      const {points: p, radius, count} = this.data.atoms, {ball} = this.balls.geometry.attributes;
      const {end} = this.sticks.geometry.attributes;
      for (let i = 0; i < count; ++i) ball.array[4 * i + 3] = isThere(i) ? radius[i] : 0;
      this.pairs.forEach((pair, b) => pair.forEach((i, half) => {
        const share = isThere(i) ? 0.5 : 1e-6, j = pair[1 - half];
        for (let k = 0; k < 3; ++k)
          end.array[3 * (2 * b + half) + k] = p[3 * i + k] + share * (p[3 * j + k] - p[3 * i + k]);
      }));
      ball.needsUpdate = end.needsUpdate = true;
    }
  }

  Atoms.thickness = 0.22;   // Å, of sticks
  Atoms.scale = 0.95;       // of spheres, which the surface's triangles would cut otherwise
  return Atoms;
})();
