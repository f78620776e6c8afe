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
  const cavities = surface.cavities.map(cavity => cavity.component).filter(Number.isInteger).sort((a, b) => a - b);
  return vertex => {
    const cavity = cavities.indexOf(surface.component[vertex]);
    return cavity < 0 ? PLAIN : DISTINCT[(cavity + 1) % DISTINCT.length];
  };
}

function hydropathyColour({residue}, atom) {
  const value = HYDROPATHIES[kindOfResidue(residue?.[atom])];
  return value === undefined ? NEUTRAL : rampColour(GREEN_BROWN, placeIn(HYDROPATHY, value));
}

function byCurvature({values: {mean_curvature: curvatures}}) {
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
 * @param {import("meniscus-surface").Surface} surface
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
