// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The engine: the C interface (meniscus.h) as the worker (worker.js) calls it. tools/make-web puts both behind the script that
// Emscripten has made, which defines MeniscusModule().
"use strict";

class Engine {
  /** wasm: WebAssembly.Module; told({stage, fraction}) while a surface is computed */
  static load(wasm, told) {
    return new Promise((resolve, reject) => {
      const module = MeniscusModule({
        progress: (stage, fraction) => { told({stage, fraction}); return 0; },
        instantiateWasm: (imports, ready) => {
          WebAssembly.instantiate(wasm, imports).then(instance => ready(instance, wasm)).catch(reject);
          return {};
        },
      });
      module.then(made => resolve(new Engine(made)), reject);
    });
  }

  constructor(module) {
    this.module = module;
    this.held = new Map();   // what surfaces keep open, by number
    this.next = 1;
  }

  // Memory of the module. Its addresses, up to 4 GB, come out of it as signed numbers: `>>> 0` makes them what they are.

  /** Calls f with the address of a text, which is freed afterwards; with 0 for a text that is not given. */
  withText(text, f) { return text === undefined ? f(0) : this.withBytes(new TextEncoder().encode(text + "\0"), f); }

  /** Calls f with the address of a copy of an array, which is freed afterwards. */
  withBytes(bytes, f) {
    const at = this.module._malloc(Math.max(bytes.byteLength, 1)) >>> 0;
    if (at === 0) throw outOfMemory();
    try {
      this.module.HEAPU8.set(new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength), at);
      return f(at);
    } finally {
      this.module._free(at);
    }
  }

  /** The numbers that f(address) has written to a place of its own. */
  written(Type, count, f) {
    return this.withBytes(new Uint8Array(count * Type.BYTES_PER_ELEMENT), at => {
      f(at);
      return this.copy(Type, at, count);
    });
  }

  copy(Type, at, count) {
    try {
      return at === 0 ? new Type(count) : new Type(this.module.HEAPU8.buffer, at >>> 0, count).slice();
    } catch {   // the module's memory has room for the array, that of JavaScript has none for the copy
      throw outOfMemory();
    }
  }

  text(at) { return this.module.UTF8ToString(at); }

  /** Throws what the library says of a status that is not 0. */
  check(status) {
    if (status !== 0) throw failure(status, this.text(this.module._meniscus_last_error()));
  }

  /** What make(address of a pointer) has put there. */
  made(make) { return this.written(Uint32Array, 1, at => this.check(make(at)))[0]; }

  json(make) { return JSON.parse(this.text(this.made(make))); }

  // Objects of the C interface.

  withOptions(options, f) {
    const handle = this.module._meniscus_options_new();
    try {
      for (const [name, value] of Object.entries(options))
        if (value !== undefined && value !== null) this.set(handle, name, value);
      return f(handle);
    } finally {
      this.module._meniscus_options_free(handle);
    }
  }

  set(handle, name, value) {
    const text = Array.isArray(value) ? value.join(",") : String(value);
    this.withText(name, n => this.withText(text, v => this.check(this.module._meniscus_options_set(handle, n, v))));
  }

  /** input: bytes of a file, whose content tells its format if it has no name, or {positions, radii} as Float64Array */
  structure(input, name, options) {
    const m = this.module;
    if (input instanceof Uint8Array)
      return this.withBytes(input, bytes => this.withText(name, n =>
        this.made(at => m._meniscus_parse(bytes, input.byteLength, n, options, at))));
    const {positions, radii} = input;
    return this.withBytes(positions, p => this.withBytes(radii, r =>
      this.made(at => m._meniscus_from_spheres(radii.length, p, r, at))));
  }

  /** What f({structure, exact, surface}, options) gives. Afterwards what these handles stand for is freed, unless it is held. */
  opened({input, name, options: given}, f) {
    const m = this.module, handles = {structure: 0, exact: 0, surface: 0, held: false};
    try {
      return this.withOptions(given, options => {
        handles.structure = this.structure(input, name, options);
        handles.exact = this.made(at => m._meniscus_exact_new(handles.structure, options, at));
        return f(handles, options);
      });
    } finally {
      if (!handles.held) this.free(handles);
    }
  }

  // What the worker is asked for.

  estimate(request) {
    const m = this.module;
    return this.opened(request, ({structure}, options) => {
      const [seconds, megabytes, vertices] = this.written(Float64Array, 3, at =>
        this.check(m._meniscus_web_estimate(structure, options, at)));
      return {atoms: m._meniscus_atom_count(structure), vertices, seconds, megabytes};
    });
  }

  measure(request) {
    const m = this.module;
    return this.opened(request, ({structure, exact}, options) => {
      const report = this.json(at => m._meniscus_measure_report(exact, options, at));
      const atoms = m._meniscus_atom_count(structure);
      const areas = this.written(Float64Array, 2 * atoms, at =>
        this.check(m._meniscus_atom_areas(exact, at, at + 8 * atoms)));
      return {report, sas: areas.slice(0, atoms), ses: areas.slice(atoms)};
    });
  }

  pockets(request) {
    const m = this.module;
    return this.opened(request, ({exact}, options) => this.json(at => m._meniscus_pockets_report(exact, options, at)));
  }

  surface(request) {
    const m = this.module;
    return this.opened(request, (handles, options) => {
      const {structure, exact} = handles;
      const surface = handles.surface = this.made(at => m._meniscus_web_surface(exact, options, at));
      const report = this.json(at => m._meniscus_surface_report(surface, at));
      if (request.options.between)
        report.interfaces = this.json(at => m._meniscus_measure_report(exact, options, at)).interfaces;
      const result = {number: this.next++, report, ...this.arrays(surface), atoms: this.atoms(structure)};
      handles.held = true;
      this.held.set(result.number, handles);
      return result;
    });
  }

  arrays(surface) {
    const m = this.module;
    const vertices = m._meniscus_vertex_count(surface), triangles = m._meniscus_triangle_count(surface);
    const values = {};
    for (const name of ["mean_curvature", "gaussian_curvature", "shape_index", "area"]) {
      const at = this.withText(name, n => m._meniscus_vertex_values(surface, n));
      if (at !== 0) values[name] = this.copy(Float32Array, at, vertices);
    }
    return {
      positions: this.written(Float32Array, 3 * vertices, at => m._meniscus_web_positions(surface, at)),
      normals: this.copy(Float32Array, m._meniscus_vertex_normals(surface), 3 * vertices),
      indices: this.copy(Uint32Array, m._meniscus_triangles(surface), 3 * triangles),
      atom: this.copy(Uint32Array, m._meniscus_vertex_atoms(surface), vertices),
      patch: this.copy(Uint8Array, m._meniscus_vertex_patches(surface), vertices),
      component: this.copy(Uint32Array, m._meniscus_vertex_components(surface), vertices),
      values,
    };
  }

  /** The kept atoms, with the columns of their names. */
  atoms(structure) {
    const m = this.module, count = m._meniscus_atom_count(structure);
    const atoms = {
      count,
      positions: this.copy(Float64Array, m._meniscus_atom_centres(structure), 3 * count),
      radii: this.copy(Float64Array, m._meniscus_atom_radii(structure), count),
      serial: new Int32Array(count), number: new Int32Array(count),
      name: [], element: [], residue: [], chain: [],
    };
    const texts = new Map();   // names that repeat are read once
    const read = at => texts.get(at) ?? (texts.set(at, this.text(at)), texts.get(at));
    this.withBytes(new Uint8Array(atomBytes), at => {
      for (let i = 0; i < count; ++i) {
        this.check(m._meniscus_atom_label(structure, i, at));
        const words = new Uint32Array(m.HEAPU8.buffer, at, 6);
        atoms.name.push(read(words[0]));
        atoms.element.push(read(words[1]));
        atoms.residue.push(read(words[2]));
        atoms.chain.push(read(words[3]));
        atoms.number[i] = words[4];
        atoms.serial[i] = words[5];
      }
    });
    return atoms;
  }

  page({number, colour = ""}) {
    const {surface} = this.held.get(number);
    const [at, size] = this.written(Uint32Array, 2, place =>
      this.check(this.withText(colour, c => this.module._meniscus_web_page(surface, c, place, place + 4))));
    try {
      return {data: this.copy(Uint8Array, at, size)};
    } finally {
      this.module._free(at);
    }
  }

  /** A file as the program writes it: "ply", "glb" ..., "atoms.csv", "residues.json", "report.json". */
  file({number, kind}) {
    const {surface, exact} = this.held.get(number), m = this.module;
    const [stem, suffix] = kind.split("."), per = tables[stem], path = "/" + (per ? "table." + suffix : "mesh." + kind);
    this.check(this.withText(path, p => per ? this.withText(per, w => m._meniscus_write_table(exact, w, p))
                                            : m._meniscus_web_write_mesh(surface, p)));
    try {
      return m.FS.readFile(path);
    } finally {
      m.FS.unlink(path);
    }
  }

  close({number}) {
    this.free(this.held.get(number));
    this.held.delete(number);
  }

  free({structure, exact, surface}) {
    this.module._meniscus_surface_free(surface);
    this.module._meniscus_exact_free(exact);
    this.module._meniscus_structure_free(structure);
  }
}

// What a table has a row for, by the name of its file.
const tables = {atoms: "atom", residues: "residue", chains: "chain", cavities: "cavity"};

const atomBytes = 56;   // sizeof(meniscus_atom); exports.cpp checks it, and where its first members lie

const failure = (code, message) => Object.assign(new Error(message), {code});

const outOfMemory = () => failure(5, "not enough memory in the browser; use a larger spacing or fewer atoms");
