// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
import type {Surface} from "meniscus-surface";
import type {Colouring} from "./colours.js";

export interface NglOptions {
  /** Default: "element". */
  colour?: Colouring;
  /** From 0 to 1, which is the default. */
  opacity?: number;
  /** The name of the component. */
  label?: string;
  /** The module of NGL; the default is the global that its script makes. */
  NGL?: any;
  /** Any parameter of NGL's buffer representation, as `wireframe` or `clipNear`. */
  [parameter: string]: unknown;
}

export interface NglHandle {
  readonly surface: Surface;
  /** NGL's ShapeComponent and its representation. */
  readonly component: any;
  readonly representation: any;
  /** Other colours, opacity or parameters of the representation. */
  update(options: Pick<NglOptions, "colour" | "opacity"> & {[parameter: string]: unknown}): void;
  remove(): void;
}

/**
 * Adds the surface to a stage as a component. Where it is pointed at, `mesh` of NGL's PickingProxy (of
 * `stage.signals.hovered` and `clicked`) is {atom, name, surface}: `atom` is an index among `surface.atoms`.
 */
export function addSurface(stage: object, surface: Surface, options?: NglOptions): NglHandle;
