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
  /** Name of the file, which tells its format and stands in messages; without it the content tells the format. */
  name?: string;
  radii?: "auto" | "bondi" | "united" | "protor" | "naccess" | "parse";
  hydrogens?: "auto" | "keep" | "drop";
  hetero?: "none" | "ligands" | "all";
  waters?: boolean;
  /** Position of the model in the file, from 1, or all models together. */
  model?: number | "join";
  assembly?: string;
  altloc?: string;
  /** Chains to keep. */
  chains?: string | string[];
  /** Atoms to keep, in gemmi's syntax: "//A/10-50". */
  select?: string;
  strict_radii?: boolean;
}

// made by tools/make-reference
/** Options of a surface by their names in the program's report. */
export interface SurfaceOptions {
  /** Probe radius, Å; 0 gives the van der Waals surface. Default: 1.4. */
  probe?: number;
  /** flow: a smooth surface, the steady state of the anchored flow, found in one solve; twice differentiable, with ridges
   *  rounded at the scale of the grid. direct: the exact distance, with sharp ridges. gaussian: only the envelope of the
   *  Gaussian map, which is not the solvent-excluded surface. Default: flow. */
  method?: "flow" | "direct" | "gaussian";
  /** Which surface: solvent-excluded, solvent-accessible (traced by the centre of the probe), or van der Waals (the same as
   *  probe 0). With method="flow" or direct. Default: ses. */
  surface?: "ses" | "sas" | "vdw";
  /** Grid spacing, Å; time and memory grow as 1/H². With edge and without spacing, small surfaces whose corrected area would
   *  be more than 0.5 % off are computed at 0.25 or 0.125 Å, unless their flow does not converge; summary and report say so.
   *  Default: 0.5. */
  spacing?: number;
  /** Which closed pieces the mesh keeps. Default: all. */
  components?: "all" | "outer" | "cavities";
  /** Drop cavities that enclose less than V Å³ and what lies in them; outer pieces stay. Default: 0. */
  min_cavity?: number;
  /** Drop cavities that enclose less than V Å³, and count their space as inside in volumes. Default: 0. */
  fill_cavities?: number;
  /** Constant of the Gaussian map, Å⁻², negative; for method="gaussian", and for flows that start from the map (flow="paper",
   *  flow="parallel" or a finite time_step). Default: -0.5. */
  density?: number;
  /** Which flow; the options below modify it. Only anchored ends at the solvent-excluded surface; paper is the flow of Pan
   *  and Tai. Default: anchored. */
  flow?: "anchored" | "parallel" | "paper";
  /** The curvature field: parallel, or paper for flow="paper". */
  curvature?: "parallel" | "sharp" | "paper" | "paper-literal";
  /** Strength of the anchor in units of 1/H²: 16 for anchored, else 0 (none). */
  anchor?: number;
  /** What makes the level set a signed distance again before each step: none for anchored, closest-point for parallel, paper
   *  for paper. */
  reinitialise?: "none" | "closest-point" | "paper" | "paper-literal" | "godunov";
  /** Solver of the linear systems: richardson, or gmres for flow="paper". */
  solver?: "richardson" | "cg" | "gmres";
  /** The factor |∇Φ| of the curvature: unit, or computed for flow="paper". */
  slope?: "unit" | "computed";
  /** Time step in units of H²: inf (one solve) for anchored, else 1. */
  time_step?: number | "inf";
  /** Half-width of the band: unknowns are the nodes within K spacings of the surface; 3, or 4 for flow="paper". */
  half_width?: number;
  /** Maximum number of steps: 30 for anchored, else 100. */
  max_steps?: number;
  /** Stop when E spacings are left to go (anchored, 10⁻⁴), or when the speed is down to E (else, 10⁻² Å⁻¹). */
  tolerance?: number;
  /** Even triangles with edges near L Å, instead of those of the grid, whose spacing is at most 0.5 Å then; at least 97 % of
   *  the edges are between 0.6 and 1.5 L. The topology stays that of the grid's mesh. A surface with folds narrower than L
   *  all over (van der Waals surfaces with 2 Å, envelopes of gaussian) is refused: choose a smaller L. */
  edge?: number;
  /** The same as edge, given as vertices per Å²; use only one of the two. */
  vertex_density?: number;
  /** With edge: shorter edges where the surface bends more. */
  adaptive?: boolean;
  /** With edge: edges run along the creases of the surface. */
  keep_ridges?: boolean;
  /** With edge: where vertices lie. near: as near to the surface as keeps the triangles within 0.03 L² Å of it on average
   *  (with 1 Å on molecules, vertices are 0.01 Å off on average), or balanced where nothing else is near enough. on-surface:
   *  on the surface, wherever the triangles then are (0.037 Å off with 1 Å); with keep_ridges or method="gaussian", near
   *  means this. balanced: so that the triangles lie on both sides of the surface (0.019 Å off; vertices 0.03 Å off).
   *  Default: near. */
  corners?: "near" | "on-surface" | "balanced";
  /** With edge: cut handles, close tunnels and drop pieces narrower than an edge. */
  simplify_topology?: boolean;
  /** Keep a record of every step of the flow. */
  history?: boolean;
  /** Measure the area of the Gaussian map, too, where the flow can do without it. */
  initial_area?: boolean;
  /** Also find the angles, edges and aspect ratios of the triangles. */
  quality?: boolean;
  /** Measure how far mesh and exact surface are from each other between vertices, too. */
  two_sided_distance?: boolean;
  /** Refuse, before it starts, a run that would need more (exit code 5), in M or G; by default, the limit is the free memory
   *  of the machine. */
  memory?: number | string;
  /** Also make the expensive self-checks: the mesh nowhere passes through itself, 20,000 points are on the correct side, the
   *  exact measures are evaluated twice; exit code 6 if one fails. */
  verify?: boolean;
}
// end

export interface Options extends ReadOptions, SurfaceOptions {
  /** Also find the exact areas, volumes and cavities, each with its error; false. */
  exact?: boolean;
  /** Also measure interfaces: true for all chains that touch, or "A,B:C". */
  interfaces?: boolean | string;
  /** Stops the computation, which is rejected with the signal's reason (an error named "AbortError" unless it was given
   *  another one). Others that wait go on; surfaces that the engine keeps are lost as by stop() if it was running. */
  signal?: AbortSignal | null;
  /** Called while a surface is computed: the stage, and the fraction of it that is done, 0 to 1. What it throws stops the
   *  computation as a signal does, and is what the call is rejected with. */
  progress?: (at: {stage: string; fraction: number}) => void;
}

/** Options of pockets, as those of `meniscus pockets`. The ranking was fitted to structures read with radii "united" and
 *  hetero "none", which are the defaults here. */
export interface PocketOptions extends ReadOptions {
  /** Radius of the probe that reaches into pockets, Å. Default: 1.4. */
  probe?: number;
  /** Radius of the probe that closes pockets off from the bulk, Å. Default: 10. */
  large_probe?: number;
  /** Grid spacing, Å, at most 2. Default: 1. */
  spacing?: number;
  /** Number of pockets looked for; closed cavities come in addition. Default: 10. */
  count?: number;
  /** What pockets are sorted by. Default: score. */
  rank?: "score" | "volume" | "depth";
  signal?: AbortSignal | null;
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
  /** A file as the program writes it. Rejected as page(); both also after close(). */
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
  /** Pockets and cavities, ranked and measured: the report of `meniscus pockets` (docs/reference/pockets.md). */
  pockets(input: Input, options?: PocketOptions): Promise<Report>;
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
/** pockets() of that engine. */
export function pockets(input: Input, options?: PocketOptions): Promise<Report>;
/** surface() of that engine. Call close() of the surface where only its arrays are needed. */
export function surface(input: Input, options?: Options): Promise<Surface>;
