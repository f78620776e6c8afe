// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface in 3Dmol.js (2.0 or later): one or several of its shapes, whose meshes have at most 64,000 vertices each.
import {vertexColours} from "./colours.js";

const MOST_VERTICES = 63990;  // 3Dmol.js numbers vertices by 16 bits, and itself splits meshes wrongly from 64,000 on
const FRONT = 0;              // $3Dmol.FrontSide

/**
 * @param {object} viewer 3Dmol.js's GLViewer
 * @param {import("meniscus-surface").Surface} surface
 * @param {import("./3dmol.js").Mol3dOptions} options
 * @returns {import("./3dmol.js").Mol3dHandle}
 */
export function addSurface(viewer, surface, options = {}) {
  const {colour = "element", opacity = 1, hover, ...more} = options;
  const colours = vertexColours(surface, colour), parts = partsOf(surface.indices, surface.positions.length / 3);
  const shapes = parts.map(part => {
    const shape = viewer.addShape({opacity, side: FRONT, ...more, color: part.vertices.map(vertex => colours[vertex])});
    shape.addCustom({vertexArr: points(surface.positions, part.vertices), normalArr: points(surface.normals, part.vertices),
                     faceArr: part.faces, color: shape.color});
    return shape;
  });
  return new Handle({viewer, surface, parts, shapes}, hover);
}

class Handle {
  constructor(members, hover) {
    Object.assign(this, members, {listening: new AbortController()});
    if (hover) this.listen(hover);
    this.viewer.render();
  }

  listen(hover) {
    const canvas = this.viewer.getCanvas(), {signal} = this.listening;
    canvas.addEventListener("mousemove", event => event.buttons || hover(this.atomAt(event.pageX, event.pageY), event), {signal});
    canvas.addEventListener("mouseleave", event => hover(null, event), {signal});
  }

  update({colour, ...style}) {
    const colours = colour === undefined ? null : vertexColours(this.surface, colour);
    this.shapes.forEach((shape, i) => shape.updateStyle(
      colours ? {...style, color: this.parts[i].vertices.map(vertex => colours[vertex])} : style));
    this.viewer.render();
  }

  /** The index of the atom whose surface is in front at a point of the page (pageX, pageY of a mouse event), or null. */
  atomAt(x, y) {
    const {indices, atom} = this.surface, {screen, depth} = this.projected();
    let best = -Infinity, found = null;
    for (let t = 0; t < indices.length; t += 3) {
      const shares = sharesAt(screen[indices[t]], screen[indices[t + 1]], screen[indices[t + 2]], {x, y});
      if (!shares) continue;
      const z = shares.reduce((sum, share, k) => sum + share * depth[indices[t + k]], 0);
      if (z > best) [best, found] = [z, atom[indices[t + shares.indexOf(Math.max(...shares))]]];
    }
    return found;
  }

  /** Where the vertices are on the page, and how near to the reader (growing towards him); kept until the view changes. */
  projected() {
    const view = this.viewer.getView(), {width, height, left, top} = this.viewer.getCanvas().getBoundingClientRect();
    const key = [...view, width, height, left + scrollX, top + scrollY].join();
    if (this.seen?.key !== key) {
      const all = points(this.surface.positions, Array.from(this.surface.atom.keys()));
      this.seen = {key, screen: this.viewer.modelToScreen(all), depth: all.map(depthIn(view))};
    }
    return this.seen;
  }

  remove() {
    this.listening.abort();
    for (const shape of this.shapes) this.viewer.removeShape(shape);
    this.viewer.render();
  }
}

/** Triangles in parts with few vertices each: {vertices: which of the surface's, faces: corners among these}. */
function partsOf(indices, count) {
  const parts = [], place = new Int32Array(count);
  let part = null;
  for (let t = 0; t < indices.length; t += 3) {
    if (!part || part.vertices.length > MOST_VERTICES - 3) {
      place.fill(-1);
      parts.push(part = {vertices: [], faces: []});
    }
    for (const corner of indices.subarray(t, t + 3)) {
      if (place[corner] < 0) place[corner] = part.vertices.push(corner) - 1;
      part.faces.push(place[corner]);
    }
  }
  return parts;
}

const points = (values, vertices) =>
  vertices.map(vertex => ({x: values[3 * vertex], y: values[3 * vertex + 1], z: values[3 * vertex + 2]}));

/** Along the line of sight: the third row of the rotation by the view's quaternion. */
function depthIn([dx, dy, dz, , qx, qy, qz, qw]) {
  const row = [2 * (qx * qz - qw * qy), 2 * (qy * qz + qw * qx), 1 - 2 * (qx * qx + qy * qy)];
  return ({x, y, z}) => row[0] * (x + dx) + row[1] * (y + dy) + row[2] * (z + dz);
}

/** The barycentric coordinates of a point in a triangle that faces the reader, or null. */
function sharesAt(a, b, c, {x, y}) {
  const whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (whole >= 0) return null;  // y grows downwards on a page
  const u = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / whole, v = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / whole;
  return u >= 0 && v >= 0 && u + v <= 1 ? [u, v, 1 - u - v] : null;
}
