// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours of a surface's vertices, the same as the program's (--color), for every viewer.
import {DISTINCT, ELEMENTS, GREEN_BROWN, HYDROPATHIES, NEUTRAL, PATCHES, PLAIN, RED_BLUE, RESIDUES, kindOfResidue,
        rampColour} from "./palettes.js";

const HYDROPATHY = [-4.5, 4.5], CURVATURE = [-0.7, 0.7];  // Å⁻¹: from a probe's sphere to an atom of 1.43 Å
const placeIn = ([low, high], value) => (value - low) / (high - low);

const byAtom = colourOf => surface => {
  const colours = Array.from({length: surface.atoms.count}, (_, atom) => colourOf(surface.atoms, atom));
  return vertex => colours[surface.atom[vertex]];
};

function byChain(surface) {
  const chains = new Map();
  for (const chain of surface.atoms.chain ?? []) if (!chains.has(chain)) chains.set(chain, chains.size);
  return byAtom((atoms, atom) => DISTINCT[chains.get(atoms.chain?.[atom]) % DISTINCT.length] ?? NEUTRAL)(surface);
}

function byComponent(surface) {
  const cavities = surface.cavities.map(cavity => cavity.component).sort((a, b) => a - b);
  return vertex => {
    const cavity = cavities.indexOf(surface.component[vertex]);
    return cavity < 0 ? PLAIN : DISTINCT[(cavity + 1) % DISTINCT.length];
  };
}

function hydropathyColour({residue}, atom) {
  const value = HYDROPATHIES[kindOfResidue(residue?.[atom])];
  return value === undefined ? NEUTRAL : rampColour(GREEN_BROWN, placeIn(HYDROPATHY, value));
}

function byCurvature(surface) {
  const curvatures = meanCurvatures(surface);
  return vertex => rampColour(RED_BLUE, placeIn(CURVATURE, curvatures[vertex]));
}

const schemes = {
  element: byAtom(({element}, atom) => ELEMENTS[element?.[atom]?.toUpperCase()] ?? NEUTRAL),
  chain: byChain,
  residue: byAtom(({residue}, atom) => RESIDUES[kindOfResidue(residue?.[atom])] ?? NEUTRAL),
  hydrophobicity: byAtom(hydropathyColour),
  patch: surface => vertex => PATCHES[surface.patch[vertex]],
  component: byComponent,
  curvature: byCurvature,
};

/** The schemes that vertexColours knows by name. */
export const SCHEMES = Object.keys(schemes);

/**
 * A colour per vertex, 0xRRGGBB.
 * @param {import("../src/index.js").Surface} surface
 * @param {import("./colours.js").Colouring} colouring a scheme, one colour (a CSS colour or 0xRRGGBB), or a function of
 *     the indices of atom and vertex that returns one
 * @throws {TypeError} if it is none of these
 */
export function vertexColours(surface, colouring = "element") {
  const colourOf = colourFunction(surface, colouring);
  return Uint32Array.from(surface.atom, (_, vertex) => colourOf(vertex));
}

/** Throws a TypeError if it is no colouring; what a function returns is checked when it is called. */
export function checkColouring(colouring) {
  if (!Object.hasOwn(schemes, colouring) && typeof colouring !== "function") rgb(colouring);
}

function colourFunction(surface, colouring) {
  if (Object.hasOwn(schemes, colouring)) return schemes[colouring](surface);
  if (typeof colouring === "function") return vertex => rgb(colouring(surface.atom[vertex], vertex));
  const one = rgb(colouring);
  return () => one;
}

const parsed = new Map();

function rgb(colour) {
  if (Number.isInteger(colour) && colour >= 0 && colour <= 0xffffff) return colour;
  if (!parsed.has(colour)) parsed.set(colour, parse(colour));
  return parsed.get(colour);
}

/** As the browser reads it: a canvas ignores what it does not know, and keeps the colour that it had before. */
function parse(text) {
  if (/^#[0-9a-f]{6}$/i.test(text)) return parseInt(text.slice(1), 16);
  const canvas = new OffscreenCanvas(1, 1).getContext("2d");
  const read = [0x000000, 0xffffff].map(before => {
    canvas.fillStyle = `#${before.toString(16).padStart(6, "0")}`;
    canvas.fillStyle = String(text);
    return canvas.fillStyle;
  });
  if (read[0] !== read[1]) throw new TypeError(`'${text}' is no colour; use ${SCHEMES.join(", ")}, a CSS colour, ` +
                                               "0xRRGGBB or a function");
  canvas.fillRect(0, 0, 1, 1);
  const [red, green, blue] = canvas.getImageData(0, 0, 1, 1).data;
  return red << 16 | green << 8 | blue;
}

/**
 * Mean curvature at each vertex, Å⁻¹, positive on a sphere: half of the divergence of the normals, which are taken to be
 * linear in each triangle. It is smoothed over the triangles around a vertex, 0.5 Å or so.
 */
export function meanCurvatures({positions, normals, indices}) {
  const divergences = new Float64Array(positions.length / 3), areas = new Float64Array(positions.length / 3);
  for (let t = 0; t < indices.length; t += 3) {
    const [twiceArea, sum] = ofTriangle(positions, normals, [3 * indices[t], 3 * indices[t + 1], 3 * indices[t + 2]]);
    for (let corner = t; corner < t + 3; ++corner) {
      divergences[indices[corner]] += sum;
      areas[indices[corner]] += twiceArea;
    }
  }
  return Float32Array.from(divergences, (sum, vertex) => areas[vertex] > 0 ? sum / (2 * areas[vertex]) : 0);
}

/** Twice the area of a triangle, and that times the divergence in it: (v × (nᵢ - nⱼ) + u × (nₖ - nᵢ)) · (u × v) / |u × v|. */
function ofTriangle(p, n, [i, j, k]) {
  const difference = (values, to, from) =>
    [values[to] - values[from], values[to + 1] - values[from + 1], values[to + 2] - values[from + 2]];
  const u = difference(p, j, i), v = difference(p, k, i), across = product(u, v), twiceArea = Math.sqrt(dot(across, across));
  const sum = dot(across, product(v, difference(n, i, j))) + dot(across, product(u, difference(n, k, i)));
  return [twiceArea, twiceArea > 0 ? sum / twiceArea : 0];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const product = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
