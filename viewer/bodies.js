// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Bodies beside the surface: pockets, clear, so that ligands are seen in them, and tunnels.
"use strict";

const Bodies = (() => {
  class Bodies {
    /**
     * mesh      of Decode.decode()
     * colourOf  tells the colour of a vertex, three bytes
     * shared    uniforms that the surface has, too
     */
    constructor(mesh, colourOf, opacity, shared) {
      const n = mesh.component.length, look = new Uint8Array(2 * n);
      this.component = mesh.component;
      this.tint = new THREE.BufferAttribute(new Uint8Array(4 * n), 4, true);
      for (let v = 0; v < n; ++v) {
        look[2 * v] = mesh.normals[0][v];
        look[2 * v + 1] = mesh.normals[1][v];
        this.tint.array.set(colourOf(v), 4 * v);
      }
      const geometry = new THREE.BufferGeometry();
      geometry.setIndex(new THREE.BufferAttribute(mesh.corners, 1));
      geometry.setAttribute("position", new THREE.BufferAttribute(mesh.points, 3));
      geometry.setAttribute("look", new THREE.BufferAttribute(look, 2, true));
      geometry.setAttribute("tint", this.tint);
      this.group = new THREE.Group();
      // Depths first, then colours: of each body only what is nearest is seen. Both among what is solid, where the order
      // of drawing is free; blending must be asked for there.
      const blending = {blending: THREE.CustomBlending, blendSrcAlpha: THREE.OneFactor,
                        blendDstAlpha: THREE.OneMinusSrcAlphaFactor};
      [{colorWrite: false}, {depthFunc: THREE.LessEqualDepth, depthWrite: false, ...blending}].forEach((options, i) => {
        const material = new THREE.ShaderMaterial({
          vertexShader: Shaders.bodyVertex, fragmentShader: Shaders.bodyFragment,
          uniforms: {inPerspective: shared.inPerspective, opacity: {value: opacity}}, ...options,
        });
        const body = new THREE.Mesh(geometry, material);
        body.frustumCulled = false;
        this.group.add(body);
      });
    }

    show(shown) { this.group.visible = shown; }

    order(first) { this.group.children.forEach((body, i) => body.renderOrder = first + i); }

    /** Shows one more solidly than the others, or none (-1). */
    mark(chosen) {
      this.component.forEach((c, v) => this.tint.array[4 * v + 3] = c === chosen ? 255 : 0);
      this.tint.needsUpdate = true;
    }
  }

  return Bodies;
})();
