// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The surface in WebGL: triangles that know their corners' atoms, so that borders between colours are sharp.
"use strict";

const Surface = (() => {
  const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);

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

  function attributes(data) {
    const {mesh, info} = data, c = mesh.corners, n = c.length;
    const position = new Float32Array(3 * n), corners = new Float32Array(3 * n);
    const look = new Uint8Array(4 * n), patches = new Uint8Array(4 * n), values = new Int16Array(4 * n);
    const kinds = smoothPatches(mesh), [nu, nv] = mesh.normals;
    for (let i = 0; i < n; ++i) {
      const v = c[i], t = i - i % 3;
      for (let k = 0; k < 3; ++k) {
        position[3 * i + k] = mesh.points[3 * v + k];
        corners[3 * i + k] = mesh.atom[c[t + k]];
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
        value: {value: 0}, steps: {value: new THREE.Vector2(data.info.curvatureStep, data.info.depthStep)},
        plane: {value: new THREE.Vector4()}, planeInView: {value: new THREE.Vector4()}, cut: {value: false}, inPerspective: {value: false},
        inside: {value: new THREE.Color(0.8, 0.8, 0.8)}, accent: {value: new THREE.Vector3(0.9, 0.05, 0.35)},
        chosen: {value: -1}, choosing: {value: false},
      };
      this.group = new THREE.Group();
      const shared = attributes(data);
      this.outer = this.layer(shared, 0, outer);
      this.cavities = this.layer(shared, outer, all - outer);
      this.setOpacity(1);
    }

    /** A range of the triangles, drawn twice where they are transparent: depths first, then colours. */
    layer(shared, start, count) {
      const geometry = new THREE.BufferGeometry();
      for (const name in shared) geometry.setAttribute(name, shared[name]);
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
      set(this.cavities, 1, 0);   // always solid: they are what one looks for in there
    }

    /** Colours by a scheme of the page; nothing is computed again. */
    setScheme(scheme) {
      const u = this.uniforms;
      u.scheme.value = {atom: 0, component: 1, value: 2}[scheme.kind];
      this.colours = null;
      if (scheme.kind === "atom") this.paintAtoms(scheme);
      if (scheme.kind === "component") this.paintComponents(scheme);
      if (scheme.kind === "value") {
        u.value.value = scheme.values === "depth" ? 1 : 0;
        u.range.value.fromArray(scheme.range);
        scheme.ramp.forEach((colour, i) => u.ramp.value[i].fromArray(rgb(colour)));
      }
    }

    paintAtoms(scheme) {
      const n = this.data.atoms.count, planes = this.data.stream(scheme.stream), paint = this.paint.image.data;
      for (let i = 0; i < n; ++i)
        for (let k = 0; k < 3; ++k) paint[4 * i + k] = planes[k * n + i];
      this.paint.needsUpdate = true;
      scheme.patches.forEach((colour, k) =>
        this.uniforms.overPatch.value[k].fromArray(colour ? [...rgb(colour), 1] : [0, 0, 0, 0]));
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
      this.uniforms.cut.value = cut;
      if (plane) this.uniforms.plane.value.set(plane.normal.x, plane.normal.y, plane.normal.z, plane.constant);
    }
  }

  Surface.rgb = rgb;
  return Surface;
})();
