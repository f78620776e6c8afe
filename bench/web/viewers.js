// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Times of one molecule's surface, from text to typed arrays, by us and by the viewers: one page, one run.
import {measure, surface} from "meniscus-surface";
import {getBoundary} from "molstar/mol-math/geometry/boundary.js";
import {calcMolecularSurface} from "molstar/mol-math/geometry/molecular-surface.js";
import {computeMarchingCubesMesh} from "molstar/mol-geo/util/marching-cubes/algorithm.js";
import {computeStructureMolecularSurface} from "molstar/mol-repr/structure/visual/util/molecular-surface.js";
import {Mesh} from "molstar/mol-geo/geometry/mesh/mesh.js";
import {OrderedSet} from "molstar/mol-data/int.js";
import {PhysicalSizeTheme} from "molstar/mol-theme/size/physical.js";
import {Structure} from "molstar/mol-model/structure.js";
import {SyncRuntimeContext as now} from "molstar/mol-task/execution/synchronous.js";
import {parsePDB} from "molstar/mol-io/reader/pdb/parser.js";
import {trajectoryFromPDB} from "molstar/mol-model-formats/structure/pdb.js";

const PROBE = 1.4, SPACING = 0.5;
const molstarOptions = {probeRadius: PROBE, resolution: SPACING, probePositions: 36};  // 36 is Mol*'s default

/**
 * One row per way: {name, ms (median of the turns), best, vertices, triangles, area}.
 * text   a PDB file, of which every program takes the records ATOM
 */
export async function measureAll(text, turns) {
  const atoms = text.replace(/^HETATM.*\n/gm, ""), given = await surface(atoms, {method: "direct"});
  const ours = options => () => surface(atoms, {probe: PROBE, spacing: SPACING, ...options});
  const rows = [];
  for (const [name, run] of [
    ["Meniscus, direct", ours({method: "direct"})],
    ["Meniscus, flow", ours({method: "flow"})],
    ["Meniscus, direct, with exact numbers", ours({method: "direct", exact: true})],
    ["Meniscus, exact numbers alone", () => measure(atoms, {probe: PROBE})],
    ["Mol*", () => molstarFromText(atoms)],
    ["Mol*, without reading, radii as ours", () => molstarFromSpheres(given.atoms)],
    ["NGL (smoothed, its default)", () => ngl(atoms, {type: "ms"})],
    ["NGL, type av", () => ngl(atoms, {type: "av"})],
    ["3Dmol.js (its workers)", () => threeDmol(atoms)],
  ]) rows.push({name, ...await timed(run, turns)});
  return rows;
}

async function timed(run, turns) {
  const times = [];
  let result = await run();  // the first one warms up
  for (let turn = 0; turn < turns; ++turn) {
    await new Promise(resolve => setTimeout(resolve, 50));
    const begin = performance.now();
    result = await run();
    times.push(performance.now() - begin);
  }
  times.sort((a, b) => a - b);
  return {ms: times[turns >> 1], best: times[0], ...sizes(result)};
}

function sizes({positions, indices}) {
  return indices ? {vertices: positions.length / 3, triangles: indices.length / 3, area: areaOf(positions, indices)} : {};
}

function areaOf(p, indices) {
  let area = 0;
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [3 * indices[t], 3 * indices[t + 1], 3 * indices[t + 2]];
    const [u, v] = [b, c].map(to => [p[to] - p[a], p[to + 1] - p[a + 1], p[to + 2] - p[a + 2]]);
    area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return area;
}

async function meshOf({field, idField, transform}) {
  const mesh = await computeMarchingCubesMesh({isoLevel: PROBE, scalarField: field, idField}).runAsChild(now);
  Mesh.transform(mesh, transform);
  return {positions: mesh.vertexBuffer.ref.value.subarray(0, 3 * mesh.vertexCount),
          indices: mesh.indexBuffer.ref.value.subarray(0, 3 * mesh.triangleCount)};
}

async function molstarFromText(text) {
  const pdb = (await parsePDB(text).runInContext(now)).result;
  const trajectory = await trajectoryFromPDB(pdb).runInContext(now);
  const structure = Structure.ofModel(trajectory.representative);
  return meshOf(await computeStructureMolecularSurface(structure, PhysicalSizeTheme({}, {}), molstarOptions).runInContext(now));
}

async function molstarFromSpheres({count, positions, radii}) {
  const [x, y, z] = [0, 1, 2].map(k => Float32Array.from({length: count}, (_, i) => positions[3 * i + k]));
  const radius = Float32Array.from(radii), indices = OrderedSet.ofBounds(0, count), id = Int32Array.from(radius.keys());
  const boundary = getBoundary({x, y, z, radius, indices, id}), enlarged = radius.map(r => r + PROBE);
  return meshOf(await calcMolecularSurface(now, {x, y, z, radius: enlarged, indices, id}, boundary, Math.max(...radius), null,
                                           molstarOptions));
}

async function ngl(text, options) {
  const structure = await NGL.autoLoad(new Blob([text]), {ext: "pdb"});
  const made = new NGL.MolecularSurface(structure).getSurface({probeRadius: PROBE, scaleFactor: 1 / SPACING, smooth: 2, ...options});
  return {positions: made.position, indices: made.index};
}

let viewer = null;

/** It has no way but to draw; its surfaces are in pieces that share no vertices, and are not counted. */
async function threeDmol(text) {
  viewer ??= $3Dmol.createViewer("view");
  viewer.clear();
  viewer.addModel(text, "pdb");
  await viewer.addSurface($3Dmol.SurfaceType.SES, {}, {}, {});
  return {};
}
