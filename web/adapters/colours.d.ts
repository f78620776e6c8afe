// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
import type {Surface} from "meniscus-surface";

export type Scheme = "element" | "chain" | "residue" | "hydrophobicity" | "patch" | "component" | "curvature";

/** A CSS colour, or 0xRRGGBB. */
export type Colour = string | number;

/** A scheme, one colour for all, or a function of the indices of atom and vertex. */
export type Colouring = Scheme | Colour | ((atom: number, vertex: number) => Colour);

/** The names of all schemes. */
export const SCHEMES: readonly Scheme[];

/** A colour per vertex, 0xRRGGBB, the same as the program's. Throws a TypeError if `colouring` is no colouring. */
export function vertexColours(surface: Surface, colouring?: Colouring): Uint32Array;

/** Throws a TypeError if it is no colouring; what a function returns is checked when it is called. */
export function checkColouring(colouring: Colouring): void;
