// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
import type {Surface} from "meniscus-surface";
import type {Colouring} from "./colours.js";

export interface Mol3dOptions {
  /** Default: "element". */
  colour?: Colouring;
  /** From 0 to 1, which is the default. */
  opacity?: number;
  /** Called with the index of the atom under the pointer, or null, whenever the pointer moves over the canvas. */
  hover?: (atom: number | null, event: MouseEvent) => void;
  /** Any other member of 3Dmol.js's ShapeSpec, as `wireframe`. */
  [style: string]: unknown;
}

export interface Mol3dHandle {
  readonly surface: Surface;
  /** 3Dmol.js's GLShapes. */
  readonly shapes: readonly any[];
  /** Other colours, opacity or members of the ShapeSpec. */
  update(options: Pick<Mol3dOptions, "colour" | "opacity"> & {[style: string]: unknown}): void;
  /** The index of the atom whose surface is in front at a point of the page (pageX, pageY of a mouse event), or null. */
  atomAt(x: number, y: number): number | null;
  remove(): void;
}

/** Adds the surface to a GLViewer and renders it. */
export function addSurface(viewer: object, surface: Surface, options?: Mol3dOptions): Mol3dHandle;
