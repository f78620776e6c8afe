// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0

/** The text of a structure file (PDB, mmCIF, GROMACS, PDBQT, PQR, xyzr), its bytes (also gzipped, also BinaryCIF), or
 *  spheres: x, y, z of each centre and radii, Å. */
export type Input = string | Uint8Array | ArrayBuffer | Spheres;
export interface Spheres {
  positions: ArrayLike<number>;
  radii: ArrayLike<number>;
}

/** Which atoms are read, and with which radii; as the options of the program. */
export interface ReadOptions {
  /** Name of the file, which tells its format; else its content does. */
  name?: string;
  radii?: "auto" | "bondi" | "united" | "protor" | "naccess" | "parse";
  hydrogens?: "auto" | "keep" | "drop";
  hetero?: "none" | "ligands" | "all";
  waters?: boolean;
  /** Position of the model in the file, from 1, or all models together. */
  model?: number | "join";
  assembly?: string;
  altloc?: string;
  chains?: string[];
  select?: string;
  strict_radii?: boolean;
}

export interface Options extends ReadOptions {
  /** Probe radius, Å; 1.4. */
  probe?: number;
  surface?: "ses" | "sas" | "vdw";
  /** flow: smooth (the default); direct: sharp ridges, faster; gaussian: the envelope of the Gaussian map. */
  method?: "flow" | "direct" | "gaussian";
  /** Grid spacing, Å; 0.5. */
  spacing?: number;
  /** Even triangles with edges of this length, Å. */
  edge?: number;
  keep_ridges?: boolean;
  adaptive?: boolean;
  components?: "all" | "outer" | "cavities";
  min_cavity?: number;
  fill_cavities?: number;
  /** Also find the exact areas, volumes and cavities, each with its error; false. */
  exact?: boolean;
  verify?: boolean;
  /** Also measure interfaces: true for all chains that touch, or "A,B:C". */
  interfaces?: boolean | string;
  /** Further options of the program by their names in its reports. */
  [option: string]: unknown;
  /** Stops the computation. */
  signal?: AbortSignal;
  /** Called while it runs: the stage, and the fraction of it that is done. */
  progress?: (at: {stage: string; fraction: number}) => void;
}

export interface Cavity {
  /** Å³ */
  volume: number;
  /** Å² */
  area: number;
  centre: [number, number, number];
  /** Of a ball around the centre that holds it, Å. */
  radius: number;
  /** Number of its wall in Surface.component; null if the mesh has no such piece. */
  component: number | null;
  /** Residues around it, "A:LEU12, A:VAL30"; empty without `exact`. */
  lining: string;
}

/** The keys of the program's report (docs/reference/report.md). */
export type Report = Record<string, any>;

export interface AtomColumns {
  count: number;
  positions: Float64Array;
  radii: Float64Array;
  serial: Int32Array;
  number: Int32Array;
  name: string[];
  element: string[];
  residue: string[];
  chain: string[];
}

export interface Measures {
  report: Report;
  /** SAS area of every kept atom, Å². */
  sas: Float64Array;
  /** SES area of every kept atom, Å². */
  ses: Float64Array;
}

export interface PageContent {
  data: Uint8Array;
  title: string;
  rows: [string, string, string][];
}

export type FileKind = "ply" | "obj" | "stl" | "off" | "glb" | "vtp" | "report.json" |
  `${"atoms" | "residues" | "chains" | "cavities"}.${"csv" | "json"}`;

export interface Surface {
  /** 3 per vertex, Å. */
  positions: Float32Array;
  /** 3 per vertex: unit vectors into the solvent. */
  normals: Float32Array;
  /** 3 per triangle, counter-clockwise seen from the solvent. */
  indices: Uint32Array;
  /** Per vertex: index of the nearest atom. */
  atom: Uint32Array;
  /** Per vertex: 0 contact, 1 toroidal, 2 reentrant. */
  patch: Uint8Array;
  /** Per vertex: number of the closed piece; 0 is the largest outer one. */
  component: Uint32Array;
  /** Per vertex: mean_curvature (Å⁻¹), gaussian_curvature (Å⁻²), shape_index, area (Å²). */
  values: Record<string, Float32Array>;
  /** The kept atoms. */
  atoms: AtomColumns;
  report: Report;
  cavities: Cavity[];
  interfaces: Report[];
  notes: string[];
  warnings: string[];
  /** What a page of the program shows, for its viewer. */
  page(options?: {colour?: string}): Promise<PageContent>;
  /** A file as the program writes it. */
  file(kind: FileKind): Promise<Uint8Array>;
  /** Frees what the engine keeps for page() and file(). */
  close(): void;
}

/** Errors that are the caller's have `code`: 2 an option or argument, 3 the input, 5 memory. */
export interface MeniscusError extends Error {
  code?: number;
}

/** An engine in a worker of its own. */
export class Meniscus {
  constructor(files?: {wasm?: BufferSource | WebAssembly.Module; worker?: string});
  measure(input: Input, options?: Options): Promise<Measures>;
  surface(input: Input, options?: Options): Promise<Surface>;
  estimate(input: Input, options?: Options): Promise<{atoms: number; seconds: number; megabytes: number}>;
  /** Ends what is running. */
  stop(): void;
}

export function measure(input: Input, options?: Options): Promise<Measures>;
export function surface(input: Input, options?: Options): Promise<Surface>;
