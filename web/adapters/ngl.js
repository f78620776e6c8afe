// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface in NGL (2.0 or later): a component of the stage with one mesh. Hovering and clicking name the atom.
import {vertexColours} from "./colours.js";
import {atomName} from "./names.js";

/**
 * @param {object} stage NGL's Stage
 * @param {import("meniscus-surface").Surface} surface
 * @param {import("./ngl.js").NglOptions} options
 * @returns {import("./ngl.js").NglHandle}
 */
export function addSurface(stage, surface, options = {}) {
  const {NGL = globalThis.NGL, colour = "element", opacity = 1, label = "Meniscus surface", ...more} = options;
  if (!NGL) throw new TypeError("NGL is not there; load it first, or give it as options.NGL");
  const mesh = pickableMesh(surface), shape = new NGL.Shape(label);
  const color = coloursOf(surface, colour, mesh.vertices);
  const buffer = new NGL.MeshBuffer({...mesh, color, picking: new AtomOfSurface(surface, shape)});
  shape.addBuffer(buffer);
  const component = stage.addComponentFromObject(shape);
  const representation = component.addRepresentation("buffer", {opacity, side: "front", ...more});
  return new Handle({stage, surface, component, representation, buffer, vertices: mesh.vertices});
}

class Handle {
  constructor(parts) {
    Object.assign(this, parts);
  }

  update({colour, ...parameters}) {
    if (colour !== undefined) this.buffer.setAttributes({color: coloursOf(this.surface, colour, this.vertices)});
    this.representation.setParameters(parameters);
    this.stage.viewer.requestRender();
  }

  remove() {
    this.stage.removeComponent(this.component);
  }
}

/** What NGL asks a mesh for when it is pointed at (the interface of its Picker); the identifiers are those of atoms. */
class AtomOfSurface {
  constructor(surface, shape) {
    Object.assign(this, {surface, data: shape, type: "mesh"});
  }

  getObject(atom) {
    return {atom, name: atomName(this.surface, atom), shape: this.data, surface: this.surface, serial: atom};
  }

  getPosition(atom, instance, component) {
    const position = this.data.center.clone().fromArray(this.surface.atoms.positions, 3 * atom);
    if (instance) position.applyMatrix4(instance.matrix);
    return component ? position.applyMatrix4(component.matrix) : position;
  }
}

/**
 * NGL interpolates identifiers between the vertices of a triangle, so all three must have the same: the atom that two of
 * them are nearest to, or the first one's. Vertices of other atoms are doubled there.
 */
function pickableMesh({positions, normals, indices, atom}) {
  const vertices = Array.from(atom.keys()), atoms = Array.from(atom), doubles = new Map();
  const index = indices.slice();
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map(k => atom[indices[t + k]]), chosen = b === c ? b : a;
    for (let i = t; i < t + 3; ++i) if (atom[index[i]] !== chosen) index[i] = double(index[i], chosen);
  }
  function double(vertex, chosen) {
    const key = vertex * 0x1000000 + chosen;
    if (!doubles.has(key)) {
      doubles.set(key, vertices.push(vertex) - 1);
      atoms.push(chosen);
    }
    return doubles.get(key);
  }
  return {vertices, index, position: gathered(positions, vertices), normal: gathered(normals, vertices),
          primitiveId: Float32Array.from(atoms)};
}

function gathered(values, vertices) {
  const result = new Float32Array(3 * vertices.length);
  vertices.forEach((vertex, i) => result.set(values.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return result;
}

/** Three numbers from 0 to 1 per vertex. */
function coloursOf(surface, colour, vertices) {
  const colours = vertexColours(surface, colour), result = new Float32Array(3 * vertices.length);
  vertices.forEach((vertex, i) => {
    for (let k = 0; k < 3; ++k) result[3 * i + k] = (colours[vertex] >> (16 - 8 * k) & 255) / 255;
  });
  return result;
}
