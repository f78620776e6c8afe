// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The molecular surface of Mol* in Node: spheres ("x y z radius" per line) in, a binary PLY with vertices and triangles out.
//
// usage: NODE_PATH=FOLDER/node_modules node molstar.js SPHERES.xyzr SPACING OUT.ply     after: npm install molstar
"use strict";
const fs = require("fs");
const lib = "molstar/lib/commonjs/";
const { OrderedSet } = require(lib + "mol-data/int");
const { getBoundary } = require(lib + "mol-math/geometry/boundary");
const { calcMolecularSurface } = require(lib + "mol-math/geometry/molecular-surface");
const { computeMarchingCubesMesh } = require(lib + "mol-geo/util/marching-cubes/algorithm");
const { Vec3 } = require(lib + "mol-math/linear-algebra");
const { SyncRuntimeContext } = require(lib + "mol-task/execution/synchronous");

const kProbe = 1.4;

function readSpheres(path) {
  const rows = fs.readFileSync(path, "utf8").split("\n").map(line => line.trim().split(/\s+/).map(Number));
  const spheres = rows.filter(row => row.length >= 4 && row.every(Number.isFinite));
  return [0, 1, 2, 3].map(column => Float32Array.from(spheres, row => row[column]));
}

function writePly(path, mesh, transform) {
  const n = mesh.vertexCount;
  const m = mesh.triangleCount;
  const position = new Float32Array(3 * n);
  const point = Vec3();
  for (let i = 0; i < n; ++i) {
    Vec3.transformMat4(point, Vec3.fromArray(point, mesh.vertexBuffer.ref.value, 3 * i), transform);
    Vec3.toArray(point, position, 3 * i);
  }
  const index = mesh.indexBuffer.ref.value;
  const faces = Buffer.alloc(13 * m);
  for (let t = 0; t < m; ++t) {
    faces.writeUInt8(3, 13 * t);
    for (let k = 0; k < 3; ++k) faces.writeUInt32LE(index[3 * t + k], 13 * t + 1 + 4 * k);
  }
  const header = "ply\nformat binary_little_endian 1.0\nelement vertex " + n +
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " + m +
    "\nproperty list uchar int vertex_indices\nend_header\n";
  fs.writeFileSync(path, Buffer.concat([Buffer.from(header), Buffer.from(position.buffer), faces]));
}

async function main(input, spacing, output) {
  const [x, y, z, r] = readSpheres(input);
  const indices = OrderedSet.ofBounds(0, x.length);
  const position = { x, y, z, radius: r.map(radius => radius + kProbe), indices, id: Int32Array.from(x, (_, i) => i) };
  const boundary = getBoundary({ ...position, radius: r });
  const maxRadius = r.reduce((a, b) => Math.max(a, b), 0);
  const props = { probeRadius: kProbe, resolution: Number(spacing), probePositions: 36 };
  const surface = await calcMolecularSurface(SyncRuntimeContext, position, boundary, maxRadius, null, props);
  const mesh = await computeMarchingCubesMesh(
    { isoLevel: kProbe, scalarField: surface.field, idField: surface.idField }).runAsChild(SyncRuntimeContext);
  writePly(output, mesh, surface.transform);
}

main(...process.argv.slice(2)).catch(error => {
  console.error(error.stack);
  process.exit(1);
});
