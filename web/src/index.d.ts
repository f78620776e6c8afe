// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0

/** The text of a structure file (PDB, mmCIF, GROMACS, PDBQT, PQR, xyzr), its bytes (also gzipped, also BinaryCIF), or
 *  spheres: x, y, z of each centre and radii, Å. */
export type Input = string | Uint8Array | ArrayBuffer | Spheres;

export interface Spheres {
  /** 3 per sphere. */
  positions: ArrayLike<number>;
  /** 1 per sphere, above 0. */
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
  /** Grid spacing, Å; 0.5. Half of it makes 4 times as many triangles. */
  spacing?: number;
  /** Even triangles with edges of this length, Å. */
  edge?: number;
  keep_ridges?: boolean;
  adaptive?: boolean;
  components?: "all" | "outer" | "cavities";
  /** Smaller cavities are left out, Å³. */
  min_cavity?: number;
  /** Smaller cavities are filled, Å³. */
  fill_cavities?: number;
  /** Also find the exact areas, volumes and cavities, each with its error; false. */
  exact?: boolean;
  verify?: boolean;
  /** Also measure interfaces: true for all chains that touch, or "A,B:C". */
  interfaces?: boolean | string;
  /** Further options of the program by their names in its reports. */
  [option: string]: unknown;
  /** Stops the computation, which is rejected with the signal's reason (an error named "AbortError" unless it was given
   *  another one). Others that wait go on; surfaces that the engine keeps are lost as by stop() if it was running. */
  signal?: AbortSignal;
  /** Called while a surface is computed: the stage, and the fraction of it that is done, 0 to 1. */
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

/** One entry per atom; texts are empty where the input has none. */
export interface AtomColumns {
  /** The number of atoms. */
  count: number;
  /** x, y, z of each, Å. */
  positions: Float64Array;
  /** Å */
  radii: Float64Array;
  /** As in the file. */
  serial: Int32Array;
  /** The author's number of the residue. */
  number: Int32Array;
  /** "CA" */
  name: string[];
  element: string[];
  /** The name of the residue, "ALA". */
  residue: string[];
  /** The author's name of the chain. */
  chain: string[];
}

export interface Measures {
  /** input, exact, components, cavities, and interfaces if asked for. */
  report: Report;
  /** SAS area of every kept atom, Å². */
  sas: Float64Array;
  /** SES area of every kept atom, Å². */
  ses: Float64Array;
}

export interface Estimate {
  atoms: number;
  /** Of the mesh, mostly within a quarter; as are memory and time. */
  vertices: number;
  /** What surface() takes, without reading the file, on the machine of docs/benchmarks.md. */
  seconds: number;
  /** Memory of the worker, in units of 2^20 bytes; it has 4096 at most. */
  megabytes: number;
}

/** What viewer/ shows in the pages of the program. */
export interface PageContent {
  /** For Decode.decode() of viewer/decode.js. */
  data: Uint8Array;
  /** Of the page. */
  title: string;
  /** Section, label and value of each row of the table of numbers. */
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
  /** What a page of the program shows, for its viewer; colour: the scheme that it begins with, "element" or another one of
   *  --color. Rejected with "AbortError" once the worker that computed the surface has been stopped. */
  page(options?: {colour?: string}): Promise<PageContent>;
  /** A file as the program writes it. Rejected as page(). */
  file(kind: FileKind): Promise<Uint8Array>;
  /** Frees what the engine keeps for page() and file(), which is as much memory as the mesh again; arrays and report stay. */
  close(): void;
}

/** What promises are rejected with: one line that says what is wrong and what to do. */
export interface MeniscusError extends Error {
  /** As the program's exit codes: 1 a mistake in the library, 2 an option or argument, 3 the input, 5 memory; none where the
   *  files of the engine cannot be loaded. */
  code?: number;
}

/**
 * An engine in a worker of its own, which the first call starts. Calls are answered one after the other. Input is copied. An
 * engine that could not be loaded, or has failed, is started anew by the next call.
 */
export class Meniscus {
  /** wasm: bytes or module of meniscus.wasm; worker: the text of meniscus-worker.js. Where they are left out, the files lie
   *  beside index.js. */
  constructor(files?: {wasm?: BufferSource | WebAssembly.Module; worker?: string});
  /** Exact areas and volumes with their errors, and the areas of atoms, without a mesh. */
  measure(input: Input, options?: Options): Promise<Measures>;
  /** The surface as a mesh in typed arrays, with its report. */
  surface(input: Input, options?: Options): Promise<Surface>;
  /** What surface() would take; in a fraction of a second. */
  estimate(input: Input, options?: Options): Promise<Estimate>;
  /** Ends the worker: all calls that are not answered yet are rejected with "AbortError", surfaces keep their arrays and report,
   *  and nothing else. The next call starts a new worker. */
  stop(): void;
}

/** measure() of one engine that all callers share. */
export function measure(input: Input, options?: Options): Promise<Measures>;
/** surface() of that engine. Call close() of the surface where only its arrays are needed. */
export function surface(input: Input, options?: Options): Promise<Surface>;
