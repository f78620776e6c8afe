// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The surface in WebGL: triangles that know their corners' atoms, so that borders between colours are sharp.
"use strict";

const Surface = (() => {
  const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);

  /** Light of an sRGB channel, as in the shaders. */
  const decoded = s => s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;

  /** Twice the sum of all area vectors is zero where a mesh is closed; rounding leaves far less than a triangle. */
  function isClosed({points: p, corners: c}) {
    const sum = [0, 0, 0];
    for (let t = 0; t < c.length; t += 3)
      for (let k = 0; k < 3; ++k) {
        const a = 3 * c[t], b = 3 * c[t + 1], d = 3 * c[t + 2], i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += (p[b + i] - p[a + i]) * (p[d + j] - p[a + j]) - (p[b + j] - p[a + j]) * (p[d + i] - p[a + i]);
      }
    return Math.hypot(...sum) < 0.01;
  }

  /** Six times the signed volume of every component. */
  function volumes(mesh) {
    const sum = [];
    const {points: p, corners: c, component} = mesh;
    for (let t = 0; t < c.length; t += 3) {
      const i = 3 * c[t], j = 3 * c[t + 1], k = 3 * c[t + 2];
      const x = p[j + 1] * p[k + 2] - p[j + 2] * p[k + 1];
      const y = p[j + 2] * p[k] - p[j] * p[k + 2];
      const z = p[j] * p[k + 1] - p[j + 1] * p[k];
      const of = component[c[t]];
      sum[of] = (sum[of] || 0) + p[i] * x + p[i + 1] * y + p[i + 2] * z;
    }
    return sum;
  }

  /** Triangles of outer pieces first, then those of cavities; the number of corners of the former. */
  function outerFirst(mesh, volume) {
    const c = mesh.corners;
    const ordered = new Uint32Array(c.length);
    let low = 0, high = c.length;
    for (let t = 0; t < c.length; t += 3) {
      const place = volume[mesh.component[c[t]]] >= 0 ? (low += 3) - 3 : high -= 3;
      ordered[place] = c[t];
      ordered[place + 1] = c[t + 1];
      ordered[place + 2] = c[t + 2];
    }
    mesh.corners = ordered;
    return low;
  }

  /** For every vertex how much of each kind of patch lies around, 0 to 255: borders run smoothly between triangles. */
  function smoothPatches(mesh) {
    const {patch, corners: c} = mesh, n = patch.length;
    const sum = new Float32Array(3 * n);
    for (let t = 0; t < c.length; t += 3)
      for (let k = 0; k < 3; ++k) {
        const at = 3 * c[t + k];
        sum[at + patch[c[t]]] += 1;
        sum[at + patch[c[t + 1]]] += 1;
        sum[at + patch[c[t + 2]]] += 1;
      }
    const share = new Uint8Array(3 * n);
    for (let v = 0; v < n; ++v) {
      const all = sum[3 * v] + sum[3 * v + 1] + sum[3 * v + 2] || 1;
      for (let k = 0; k < 3; ++k) share[3 * v + k] = Math.round(255 * sum[3 * v + k] / all);
    }
    return share;
  }

  const int16 = value => Math.max(-32768, Math.min(32767, Math.round(value)));

  /**
   * What the graphics card draws: vertices of the mesh, of which some stand twice. Every triangle is to know the atoms of
   * its three corners, and takes them from its last one: so no vertex may be last in triangles with other atoms.
   */
  function drawn({corners: c, atom}, vertices) {
    const most = vertices + c.length / 3, index = new Uint32Array(c.length);
    const source = new Uint32Array(most), next = new Int32Array(most).fill(-1), atoms = new Int32Array(3 * most).fill(-1);
    for (let v = 0; v < vertices; ++v) source[v] = v;
    let count = vertices;
    const claim = (i, low, middle, high) => {
      atoms[3 * i] = low;
      atoms[3 * i + 1] = middle;
      atoms[3 * i + 2] = high;
      return i;
    };
    const find = (v, low, middle, high) => {
      for (let i = v; i >= 0; i = next[i])
        if (atoms[3 * i] === low && atoms[3 * i + 1] === middle && atoms[3 * i + 2] === high) return i;
      return -1;
    };
    const add = v => {
      source[count] = v;
      next[count] = next[v];
      return next[v] = count++;
    };
    for (let t = 0; t < c.length; t += 3) {
      const x = atom[c[t]], y = atom[c[t + 1]], z = atom[c[t + 2]];
      const low = Math.min(x, y, z), high = Math.max(x, y, z), middle = x + y + z - low - high;
      let last = 0, place = -1;
      while (last < 3 && (place = find(c[t + last], low, middle, high)) < 0) ++last;
      for (let k = 0; place < 0 && k < 3; ++k)
        if (atoms[3 * c[t + k]] < 0) place = claim(c[t + (last = k)], low, middle, high);
      if (place < 0) place = claim(add(c[t + (last = 0)]), low, middle, high);
      index[t] = c[t + (last + 1) % 3];
      index[t + 1] = c[t + (last + 2) % 3];
      index[t + 2] = place;
    }
    return {index, source: source.subarray(0, count), atoms: atoms.subarray(0, 3 * count)};
  }

  function attributes(data) {
    const {mesh, info} = data, {index, source, atoms} = drawn(mesh, info.vertices), n = source.length;
    const position = new Float32Array(3 * n), corners = new Float32Array(3 * n);
    const look = new Uint8Array(4 * n), patches = new Uint8Array(4 * n), values = new Int16Array(4 * n);
    const kinds = smoothPatches(mesh), [nu, nv] = mesh.normals;
    for (let i = 0; i < n; ++i) {
      const v = source[i];
      for (let k = 0; k < 3; ++k) {
        position[3 * i + k] = mesh.points[3 * v + k];
        corners[3 * i + k] = atoms[3 * i + k];
        patches[4 * i + k] = kinds[3 * v + k];
      }
      look[4 * i] = nu[v];
      look[4 * i + 1] = nv[v];
      look[4 * i + 2] = mesh.sky ? mesh.sky[v] : 255;
      if (mesh.curvature) values[4 * i] = int16(mesh.curvature[v] / info.curvatureStep);
      if (mesh.depth) values[4 * i + 1] = mesh.depth[v];
      values[4 * i + 2] = int16(mesh.component[v]);
    }
    return {
      source,
      index: new THREE.BufferAttribute(index, 1),
      position: new THREE.BufferAttribute(position, 3),
      corners: new THREE.BufferAttribute(corners, 3),
      look: new THREE.BufferAttribute(look, 4, true),
      patches: new THREE.BufferAttribute(patches, 4, true),
      values: new THREE.BufferAttribute(values, 4),
    };
  }

  /** A texture with one texel per entry of a table of fours. */
  function table(Type, format, entries) {
    const width = Math.max(1, Math.min(1024, entries)), height = Math.max(1, Math.ceil(entries / width));
    const texture = new THREE.DataTexture(new Type(4 * width * height), width, height, THREE.RGBAFormat, format);
    texture.magFilter = texture.minFilter = THREE.NearestFilter;
    texture.needsUpdate = true;
    return texture;
  }

  function sphereTable(atoms) {
    const texture = table(Float32Array, THREE.FloatType, atoms.count);
    for (let i = 0; i < atoms.count; ++i) {
      texture.image.data.set(atoms.points.subarray(3 * i, 3 * i + 3), 4 * i);
      texture.image.data[4 * i + 3] = atoms.radius[i];
    }
    return texture;
  }

  class Surface {
    constructor(data) {
      this.data = data;
      const volume = volumes(data.mesh), outer = outerFirst(data.mesh, volume), all = data.mesh.corners.length;
      this.paint = table(Uint8Array, THREE.UnsignedByteType, data.atoms.count);
      this.components = Math.max(1, volume.length);
      this.uniforms = {
        spheres: {value: sphereTable(data.atoms)}, paint: {value: this.paint},
        ofComponent: {value: table(Uint8Array, THREE.UnsignedByteType, this.components)},
        scheme: {value: 0}, overPatch: {value: [0, 1, 2].map(() => new THREE.Vector4())},
        ramp: {value: Array.from({length: 9}, () => new THREE.Vector3())}, range: {value: new THREE.Vector2(0, 1)},
        value: {value: 0}, scale: {value: new THREE.Vector2(1, 0)}, none: {value: new THREE.Vector3()}, steps: {value: new THREE.Vector2(data.info.curvatureStep, data.info.depthStep)},
        plane: {value: new THREE.Vector4()}, planeInView: {value: new THREE.Vector4()}, cut: {value: false}, inPerspective: {value: false},
        inside: {value: new THREE.Color(0.8, 0.8, 0.8)}, accent: {value: new THREE.Vector3(0.9, 0.05, 0.35)},
        chosen: {value: -1}, choosing: {value: false},
      };
      this.group = new THREE.Group();
      const {source, ...shared} = attributes(data);
      this.source = source;
      this.values = shared.values;
      this.outer = this.layer(shared, 0, outer);
      this.cavities = this.layer(shared, outer, all - outer);
      // The inner side of a closed surface is never seen, unless it is cut: drawing it would cost time.
      this.outerSide = isClosed(data.mesh) ? THREE.FrontSide : THREE.DoubleSide;
      this.setSide(this.outerSide);
      this.setOpacity(1);
    }

    setSide(side) {
      for (const {material} of [this.outer.first, this.outer.second]) material.side = side;
    }

    /** A range of the triangles, drawn twice where they are transparent: depths first, then colours. */
    layer(shared, start, count) {
      const geometry = new THREE.BufferGeometry();
      const {index, ...attributes} = shared;
      geometry.setIndex(index);
      for (const name in attributes) geometry.setAttribute(name, attributes[name]);
      geometry.setDrawRange(start, count);
      const material = options => new THREE.ShaderMaterial({
        vertexShader: Shaders.surfaceVertex, fragmentShader: Shaders.surfaceFragment, side: THREE.DoubleSide,
        uniforms: {...this.uniforms, opacity: {value: 1}}, ...options,
      });
      const first = new THREE.Mesh(geometry, material({colorWrite: false}));
      const second = new THREE.Mesh(geometry, material({depthFunc: THREE.LessEqualDepth}));
      for (const mesh of [first, second]) {
        mesh.frustumCulled = false;
        this.group.add(mesh);
      }
      return {first, second, count};
    }

    /** beside: whether ligands are shown, which the walls of cavities do not hide */
    setBeside(beside) {
      this.beside = beside;
      this.setOpacity(this.opacity);
    }

    /** filled: whether bodies are shown that fill the cavities, and would be seen through their walls in patches */
    setFilled(filled) {
      this.filled = filled;
      this.setOpacity(this.opacity);
    }

    setOpacity(opacity) {
      this.opacity = opacity;
      const set = ({first, second, count}, value, order) => {
        const clear = value < 1;
        first.visible = clear && value > 0 && count > 0;
        second.visible = value > 0 && count > 0;
        second.material.transparent = clear;
        second.material.depthWrite = !clear;
        second.material.uniforms.opacity.value = value;
        first.renderOrder = order;
        second.renderOrder = order + 1;
      };
      set(this.outer, opacity, 10);
      // Solid, as what one looks for in there, unless that may be a ligand in one of them.
      this.cavityOpacity = this.filled ? 0 : this.beside ? Math.max(0.4, opacity) : 1;
      set(this.cavities, this.cavityOpacity, 0);
    }

    /** Colours by a scheme of the page; nothing is computed again. */
    setScheme(scheme) {
      const u = this.uniforms;
      u.scheme.value = {atom: 0, component: 1, value: 2, class: 3}[scheme.kind];
      this.colours = null;
      if (scheme.kind === "atom") this.paintAtoms(scheme);
      if (scheme.kind === "component") this.paintComponents(scheme);
      if (scheme.kind === "class") this.paintClasses(scheme);
      if (scheme.kind === "value") {
        u.value.value = scheme.values === "curvature" ? 0 : scheme.values === "depth" ? 1 : 2;
        if (u.value.value === 2) this.showValues(this.data.info.values.findIndex(v => v.name === scheme.values), scheme);
        u.range.value.fromArray(scheme.range);
        scheme.ramp.forEach((colour, i) => u.ramp.value[i].fromArray(rgb(colour)));
      }
    }

    /** Puts an array from elsewhere before the graphics card; there is room for one at a time. */
    showValues(i, scheme) {
      const {step, low} = this.data.info.values[i], steps = this.data.mesh.values[i], to = this.values.array;
      this.source.forEach((v, k) => to[4 * k + 3] = steps[v] < 0 ? -32768 : steps[v]);
      this.values.needsUpdate = true;
      this.uniforms.scale.value.set(step, low);
      if (scheme.legend.entries.length) this.uniforms.none.value.fromArray(rgb(scheme.legend.entries[0][1]));
    }

    paintAtoms(scheme) {
      const n = this.data.atoms.count, planes = this.data.stream(scheme.stream), paint = this.paint.image.data;
      for (let i = 0; i < n; ++i)
        for (let k = 0; k < 3; ++k) paint[4 * i + k] = planes[k * n + i];
      this.paint.needsUpdate = true;
      scheme.patches.forEach((colour, k) =>
        this.uniforms.overPatch.value[k].fromArray(colour ? [...rgb(colour).map(decoded), 1] : [0, 0, 0, 0]));
    }

    /** Colours of the vertices, by whole numbers that they have. */
    paintClasses(scheme) {
      const {values, mesh} = {values: this.data.info.values, mesh: this.data.mesh};
      const i = values.findIndex(v => v.name === scheme.values), {step, low} = values[i], of = mesh.values[i];
      const none = rgb(scheme.none), colours = {};
      for (const number in scheme.colours) colours[number] = rgb(scheme.colours[number]);
      const tint = new Uint8Array(4 * this.source.length);
      this.source.forEach((v, k) => {
        const colour = of[v] < 0 ? none : colours[Math.round(of[v] * step + low)] || none;
        for (let c = 0; c < 3; ++c) tint[4 * k + c] = Math.round(255 * colour[c]);
      });
      for (const {first} of [this.outer, this.cavities])
        first.geometry.setAttribute("tint", new THREE.BufferAttribute(tint, 4, true));
    }

    paintComponents(scheme) {
      const texture = this.uniforms.ofComponent.value;
      scheme.colours.forEach((colour, i) => texture.image.data.set(rgb(colour).map(c => 255 * c), 4 * i));
      texture.needsUpdate = true;
    }

    /** Marks the atoms for which chosen(i) is true, or none. */
    mark(chosen) {
      const paint = this.paint.image.data;
      for (let i = 0; i < this.data.atoms.count; ++i) paint[4 * i + 3] = chosen && chosen(i) ? 255 : 0;
      this.paint.needsUpdate = true;
      this.uniforms.choosing.value = Boolean(chosen);
    }

    /** Gives back what the graphics card holds beside geometry and materials. */
    dispose() {
      for (const texture of [this.paint, this.uniforms.spheres.value, this.uniforms.ofComponent.value]) texture.dispose();
    }

    /** Shows a component of the mesh, or none (null), in the accent colour. */
    markComponent(component) { this.uniforms.chosen.value = component === null ? -1 : component; }

    /** Cuts away what lies before a plane (normal, constant), or nothing (null). */
    setPlane(plane) {
      const cut = Boolean(plane);
      if (cut !== this.uniforms.cut.value)
        for (const {first, second} of [this.outer, this.cavities])
          for (const {material} of [first, second]) {
            material.defines = cut ? {CUT: 1} : {};
            material.needsUpdate = true;
          }
      this.setSide(cut ? THREE.DoubleSide : this.outerSide);
      this.uniforms.cut.value = cut;
      if (plane) this.uniforms.plane.value.set(plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
    }
  }

  Surface.rgb = rgb;
  return Surface;
})();
