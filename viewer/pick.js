// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What lies under a point of the window: rays against the triangles, or the atoms.
"use strict";

const Pick = (() => {
  const bundle = 96;   // triangles that share a box: neighbours in the file are neighbours in space

  /** Boxes around bundles of triangles: six numbers each. */
  function boxesOf(mesh) {
    const {corners: c, points: p} = mesh, boxes = new Float32Array(6 * Math.ceil(c.length / (3 * bundle)));
    for (let b = 0; b < boxes.length / 6; ++b) {
      boxes.set([Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity], 6 * b);
      const end = Math.min(c.length, 3 * bundle * (b + 1));
      for (let i = 3 * bundle * b; i < end; ++i)
        for (let k = 0; k < 3; ++k) {
          const s = p[3 * c[i] + k];
          boxes[6 * b + k] = Math.min(boxes[6 * b + k], s);
          boxes[6 * b + 3 + k] = Math.max(boxes[6 * b + 3 + k], s);
        }
    }
    return boxes;
  }

  function meets(boxes, at, origin, inverse) {
    let near = -Infinity, far = Infinity;
    for (let k = 0; k < 3; ++k) {
      const a = (boxes[at + k] - origin[k]) * inverse[k], b = (boxes[at + 3 + k] - origin[k]) * inverse[k];
      near = Math.max(near, Math.min(a, b));
      far = Math.min(far, Math.max(a, b));
    }
    return near <= far && far >= 0;
  }

  class Pick {
    constructor(data) {
      this.data = data;
      this.boxes = boxesOf(data.mesh);
    }

    /**
     * The first triangle that is hit: {triangle, u, v, distance, front}, or null.
     * from, to   range of corners that are looked at
     * plane      {normal, constant}: what lies before it is not there; or null
     */
    surface({origin, direction}, {from = 0, to = this.data.mesh.corners.length, plane = null} = {}) {
      const o = origin.toArray(), d = direction.toArray(), inverse = d.map(x => 1 / (x || 1e-12));
      let best = null;
      const first = Math.floor(from / (3 * bundle)), last = Math.ceil(to / (3 * bundle));
      for (let b = first; b < last; ++b) {
        if (!meets(this.boxes, 6 * b, o, inverse)) continue;
        const end = Math.min(to, 3 * bundle * (b + 1));
        for (let i = Math.max(from, 3 * bundle * b); i < end; i += 3) {
          const hit = this.triangle(i, o, d);
          if (hit && (!best || hit.distance < best.distance) && !this.isCut(hit, o, d, plane)) best = hit;
        }
      }
      return best;
    }

    isCut(hit, o, d, plane) {
      if (!plane) return false;
      const n = plane.normal, t = hit.distance;
      return n.x * (o[0] + t * d[0]) + n.y * (o[1] + t * d[1]) + n.z * (o[2] + t * d[2]) + plane.constant > 0;
    }

    /** Möller & Trumbore, J. Graphics Tools 2, 1997, 21. */
    triangle(i, o, d) {
      const {corners: c, points: p} = this.data.mesh, a = 3 * c[i], b = 3 * c[i + 1], e = 3 * c[i + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[e] - p[a], vy = p[e + 1] - p[a + 1], vz = p[e + 2] - p[a + 2];
      const hx = d[1] * vz - d[2] * vy, hy = d[2] * vx - d[0] * vz, hz = d[0] * vy - d[1] * vx;
      const det = ux * hx + uy * hy + uz * hz;
      if (det === 0) return null;
      const sx = o[0] - p[a], sy = o[1] - p[a + 1], sz = o[2] - p[a + 2];
      const u = (sx * hx + sy * hy + sz * hz) / det;
      if (u < 0 || u > 1) return null;
      const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
      const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
      if (v < 0 || u + v > 1) return null;
      const distance = (vx * qx + vy * qy + vz * qz) / det;
      return distance > 0 ? {triangle: i, u, v, distance, front: det > 0} : null;
    }

    /** The corner of a hit triangle that is nearest. */
    corner({triangle, u, v}) {
      const w = 1 - u - v, c = this.data.mesh.corners;
      return c[triangle + (w >= u && w >= v ? 0 : u >= v ? 1 : 2)];
    }

    /** Interpolates an array of the vertices at a hit. */
    at({triangle, u, v}, values) {
      const c = this.data.mesh.corners;
      return (1 - u - v) * values[c[triangle]] + u * values[c[triangle + 1]] + v * values[c[triangle + 2]];
    }

    /** The corners' atom whose sphere is nearest to a point, as the colours have it. */
    atomAt(hit, point) {
      const {corners: c, atom} = this.data.mesh, {points: p, radius} = this.data.atoms;
      let best = -1, least = Infinity;
      for (let k = 0; k < 3; ++k) {
        const a = atom[c[hit.triangle + k]];
        const gap = Math.hypot(p[3 * a] - point.x, p[3 * a + 1] - point.y, p[3 * a + 2] - point.z) - radius[a];
        if (gap < least) [best, least] = [a, gap];
      }
      return best;
    }

    /**
     * The first of some atoms that is hit by a ray: {atom, distance}, or null.
     * scale, fixed  how large atoms are shown
     * isThere       whether atom i is shown at all
     */
    atom({origin, direction}, atoms, {scale = 1, fixed = 0, plane = null, isThere = () => true} = {}) {
      const {points: p, radius, count} = atoms;
      let best = null;
      for (let i = 0; i < count; ++i) {
        const x = p[3 * i] - origin.x, y = p[3 * i + 1] - origin.y, z = p[3 * i + 2] - origin.z;
        const along = x * direction.x + y * direction.y + z * direction.z;
        const r = fixed || scale * radius[i], left = r * r - (x * x + y * y + z * z - along * along);
        if (left < 0 || along < 0 || !isThere(i)) continue;
        const n = plane && plane.normal;
        if (n && n.x * p[3 * i] + n.y * p[3 * i + 1] + n.z * p[3 * i + 2] + plane.constant > 0) continue;
        const distance = along - Math.sqrt(left);
        if (!best || distance < best.distance) best = {atom: i, distance};
      }
      return best;
    }
  }

  return Pick;
})();
