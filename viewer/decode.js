// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From the block of bytes in the page to arrays: what src/page/page_data.cpp has written.
"use strict";

const Decode = (() => {
  function fromBase64(text) {
    const raw = atob(text);
    const bytes = new Uint8Array(raw.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = raw.charCodeAt(i);
    return bytes;
  }

  async function inflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  /** The bytes of a script element that holds base64 of zlib's format. */
  const embedded = id => inflated(fromBase64(document.getElementById(id).textContent));

  /** Calls take(number) for every varint. */
  function eachVarint(bytes, take) {
    for (let i = 0; i < bytes.length;) {
      let value = 0, factor = 1, byte;
      do {
        byte = bytes[i++];
        value += (byte & 127) * factor;
        factor *= 128;
      } while (byte > 127);
      take(value);
    }
  }

  /** Sums of zigzag differences, times a factor, plus an offset, into an array of the given type. */
  function sums(bytes, count, Type, factor = 1, offset = 0) {
    const values = new Type(count);
    let i = 0, sum = 0;
    eachVarint(bytes, code => {
      sum += code % 2 ? -(code + 1) / 2 : code / 2;
      values[i++] = sum * factor + offset;
    });
    return values;
  }

  function byteSums(bytes) {
    const values = new Uint8Array(bytes.length);
    let sum = 0;
    for (let i = 0; i < bytes.length; ++i) values[i] = sum = (sum + bytes[i]) & 255;
    return values;
  }

  /** Corners as numbers of vertices: each code counts down from the next number that is new. */
  function corners(bytes, triangles) {
    const values = new Uint32Array(3 * triangles);
    let i = 0, next = 0;
    eachVarint(bytes, code => {
      values[i++] = next - code;
      if (code === 0) ++next;
    });
    return values;
  }

  function interleaved(x, y, z) {
    const points = new Float32Array(3 * x.length);
    for (let i = 0; i < x.length; ++i) {
      points[3 * i] = x[i];
      points[3 * i + 1] = y[i];
      points[3 * i + 2] = z[i];
    }
    return points;
  }

  /** All that the page knows, from its bytes: {info, mesh, atoms, stream(name)}. Positions are relative to info.low. */
  function decode(bytes) {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
    const info = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
    const has = name => name in info.streams;
    const stream = name => {
      const [offset, size] = info.streams[name];
      return bytes.subarray(4 + length + offset, 4 + length + offset + size);
    };
    const n = info.vertices, q = info.quantum;
    const axis = (name, count, shift) => sums(stream(name), count, Float32Array, q, shift);
    /** kind: how the names of the streams begin */
    const atoms = (kind, {count, low, valueStep}) => {
      const shift = [0, 1, 2].map(k => low[k] - info.low[k]);
      const of = (name, Type = Uint32Array, factor = 1) => sums(stream(kind + name), count, Type, factor);
      return {
        count,
        points: interleaved(...["x", "y", "z"].map((name, k) => axis(kind + name, count, shift[k]))),
        radius: of("radius", Float32Array, q),
        name: of("name"), element: of("element"), residue: of("residue"),
        serial: of("serial", Int32Array), bFactor: of("bfactor", Float64Array, valueStep),
      };
    };
    const mesh = {
      corners: corners(stream("triangles"), info.triangles),
      points: interleaved(axis("x", n), axis("y", n), axis("z", n)),
      normals: [byteSums(stream("nu")), byteSums(stream("nv"))],
      atom: sums(stream("atom"), n, Uint32Array),
      patch: byteSums(stream("patch")),
      component: has("component") ? sums(stream("component"), n, Uint32Array) : new Uint32Array(n),
      curvature: has("curvature") ? sums(stream("curvature"), n, Float32Array, info.curvatureStep) : null,
      shape: has("shape") ? sums(stream("shape"), n, Float32Array, info.shapeStep) : null,
      depth: has("depth") ? byteSums(stream("depth")) : null,
      sky: has("sky") ? byteSums(stream("sky")) : null,
      values: info.values.map((_, i) => sums(stream("value-" + i), n, Int32Array)),   // in steps, -1: none
    };
    // Atoms of their own, with what `info` is to those of the surface; undefined where there are none.
    const ligands = info.ligands && {
      info: {...info.ligands, low: info.low},
      atoms: atoms("ligand-", info.ligands.atoms),
      bonds: sums(stream("ligand-bonds"), 2 * info.ligands.bonds, Uint32Array),
    };
    /** Meshes beside the surface, each a component. */
    const beside = (kind, {triangles, vertices}) => ({
      corners: corners(stream(kind + "triangles"), triangles),
      points: interleaved(...["x", "y", "z"].map(name => axis(kind + name, vertices))),
      normals: [byteSums(stream(kind + "nu")), byteSums(stream(kind + "nv"))],
      component: sums(stream(kind + "component"), vertices, Uint32Array),
    });
    // Pockets, and tunnels as tubes; undefined where there are none.
    const bodies = info.bodies && beside("body-", info.bodies);
    const tubes = info.tubes && beside("tube-", info.tubes);
    return {info, bodies, tubes, mesh, stream, atoms: atoms("atom-", info.atoms), ligands};
  }

  return {decode, embedded};
})();
