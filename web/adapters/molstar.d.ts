// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
import type {Surface} from "meniscus-surface";
import type {Colouring} from "./colours.js";

export interface MolstarOptions {
  /** Default: "element". */
  colour?: Colouring;
  /** From 0 to 1, which is the default. */
  opacity?: number;
  /** The name of the node in the state tree, and the beginning of what hovering shows. */
  label?: string;
  /**
   * Parts of Mol*: PluginStateObject, PluginStateTransform and StateTransforms, as `molstar.lib.plugin` of the ready-made
   * viewer has them (the default). With a bundler, from molstar/lib/mol-plugin-state/objects.js and .../transforms.js.
   */
  molstar?: {PluginStateObject: any; PluginStateTransform: any; StateTransforms: any};
  /** Any parameter of Mol*'s meshes, as `xrayShaded` or `material`. */
  [parameter: string]: unknown;
}

export interface MolstarHandle {
  readonly surface: Surface;
  /** The reference of the node in the state tree, and of the mesh below it. */
  readonly ref: string;
  readonly representation: string;
  /** Other colours, opacity or parameters of the mesh. */
  update(options: Pick<MolstarOptions, "colour" | "opacity"> & {[parameter: string]: unknown}): Promise<void>;
  /** The index of the atom that a loci is about (of `plugin.behaviors.interaction.hover`), or null. */
  atomOf(loci: {kind: string}): number | null;
  remove(): Promise<void>;
}

/** Adds the surface to Mol*'s state tree. `plugin` is a PluginContext, as `viewer.plugin`. */
export function addSurface(plugin: object, surface: Surface, options?: MolstarOptions): Promise<MolstarHandle>;
