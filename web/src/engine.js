// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The engine: the C interface (meniscus.h) as the worker calls it. Runs in a worker, behind the script that Emscripten has
// made, which defines MeniscusModule().
"use strict";

class Engine {
  /** wasm: WebAssembly.Module; told({stage, fraction}) while a surface is computed */
  static async load(wasm, told) {
    const module = await MeniscusModule({
      progress: (stage, fraction) => { told({stage, fraction}); return 0; },
      instantiateWasm: (imports, ready) => {
        WebAssembly.instantiate(wasm, imports).then(instance => ready(instance, wasm));
        return {};
      },
    });
    return new Engine(module);
  }

  constructor(module) {
    this.module = module;
    this.held = new Map();   // what surfaces keep open, by number
    this.next = 1;
  }

  // Memory of the module.

  /** Calls f with the address of a text, of an array's copy, or of `size` zero bytes, which are freed afterwards. */
  withText(text, f) { return this.withBytes(new TextEncoder().encode(text + "\0"), f); }

  withBytes(bytes, f) {
    const at = this.module._malloc(Math.max(bytes.byteLength, 1));
    if (at === 0) throw failure(5, "not enough memory in the browser for this input");
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
    return at === 0 ? new Type(count) : new Type(this.module.HEAPU8.buffer, at, count).slice();
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
        if (value !== undefined && value !== null) this.set(handle, inC[name] || name, value);
      return f(handle);
    } finally {
      this.module._meniscus_options_free(handle);
    }
  }

  set(handle, name, value) {
    const text = Array.isArray(value) ? value.join(",") : String(value);
    this.withText(name, n => this.withText(text, v => this.check(this.module._meniscus_options_set(handle, n, v))));
  }

  /** input: bytes of a file, or {positions, radii} */
  structure(input, name, options) {
    const m = this.module;
    if (input instanceof Uint8Array)
      return this.withBytes(input, bytes => this.withText(name, n =>
        this.made(at => m._meniscus_parse(bytes, input.byteLength, n, options, at))));
    const {positions, radii} = input;
    if (positions.length !== 3 * radii.length)
      throw failure(2, `positions: ${positions.length} numbers for ${radii.length} radii; give x, y, z of each atom`);
    return this.withBytes(Float64Array.from(positions), p => this.withBytes(Float64Array.from(radii), r =>
      this.made(at => m._meniscus_from_spheres(radii.length, p, r, at))));
  }

  /** Calls f(structure, exact, options), and frees both afterwards unless f throws nothing and keeps them. */
  opened(input, name, given, f) {
    const m = this.module;
    return this.withOptions(given, options => {
      const structure = this.structure(input, name, options);
      let exact = 0;
      try {
        exact = this.made(at => m._meniscus_exact_new(structure, options, at));
        return f(structure, exact, options);
      } catch (error) {
        m._meniscus_exact_free(exact);
        m._meniscus_structure_free(structure);
        throw error;
      }
    });
  }

  // What the worker is asked for.

  estimate({input, name, options}) {
    return this.opened(input, name, options, (structure, exact, handle) => {
      const [seconds, megabytes] = this.written(Float64Array, 2, at =>
        this.check(this.module._meniscus_web_estimate(structure, handle, at, at + 8)));
      const atoms = this.module._meniscus_atom_count(structure);
      this.free({structure, exact, surface: 0});
      return {atoms, seconds, megabytes};
    });
  }

  measure({input, name, options}) {
    return this.opened(input, name, options, (structure, exact, handle) => {
      const report = this.json(at => this.module._meniscus_measure_report(exact, handle, at));
      const atoms = this.module._meniscus_atom_count(structure);
      const areas = this.written(Float64Array, 2 * atoms, at =>
        this.check(this.module._meniscus_atom_areas(exact, at, at + 8 * atoms)));
      this.free({structure, exact, surface: 0});
      return {report, sas: areas.slice(0, atoms), ses: areas.slice(atoms)};
    });
  }

  surface({input, name, options}) {
    return this.opened(input, name, options, (structure, exact, handle) => {
      const surface = this.made(at => this.module._meniscus_web_surface(exact, handle, at));
      const number = this.next++;
      this.held.set(number, {structure, exact, surface});
      const report = this.json(at => this.module._meniscus_surface_report(surface, at));
      if (options.between) report.interfaces = this.json(at =>
        this.module._meniscus_measure_report(exact, handle, at)).interfaces;
      return {number, report, ...this.arrays(surface), atoms: this.atoms(structure)};
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
    const {surface} = this.of(number);
    const [at, size] = this.written(Uint32Array, 2, place =>
      this.check(this.withText(colour, c => this.module._meniscus_web_page(surface, c, place, place + 4))));
    const data = this.copy(Uint8Array, at, size);
    this.module._free(at);
    return {data};
  }

  /** A file as the program writes it: "ply", "glb" ..., "atoms.csv", "residues.json", "report.json". */
  file({number, kind}) {
    const {surface, exact} = this.of(number), m = this.module;
    const table = /^(atom|residue|chain)s\.(csv|json)$|^(cavit)ies\.(csv|json)$/.exec(kind);
    const path = "/" + (table ? "table." + (table[2] || table[4]) : "mesh." + kind);
    const per = table && (table[1] || "cavity");
    this.check(this.withText(path, p => table ? this.withText(per, w => m._meniscus_write_table(exact, w, p))
                                              : m._meniscus_web_write_mesh(surface, p)));
    const bytes = m.FS.readFile(path);
    m.FS.unlink(path);
    return bytes;
  }

  close({number}) {
    this.free(this.of(number));
    this.held.delete(number);
  }

  of(number) {
    const held = this.held.get(number);
    if (!held) throw failure(2, "this surface has been closed");
    return held;
  }

  free({structure, exact, surface}) {
    this.module._meniscus_surface_free(surface);
    this.module._meniscus_exact_free(exact);
    this.module._meniscus_structure_free(structure);
  }
}

// Names of options in JavaScript that differ from those of the C interface.
const inC = {keep_waters: "waters"};

const atomBytes = 56;   // meniscus_atom: six words of four bytes, two letters, three doubles

const failure = (code, message) => Object.assign(new Error(message), {code});

/** The array buffers of an answer, which are handed over rather than copied. */
function buffersOf(value, found = []) {
  if (ArrayBuffer.isView(value)) found.push(value.buffer);
  else if (value && typeof value === "object" && !Array.isArray(value))
    for (const part of Object.values(value)) buffersOf(part, found);
  return found;
}

/** Answers messages {call, what, ...} by {call, result} or {call, error}; the first brings the module. */
function serve(port) {
  let engine = null;
  port.onmessage = async ({data}) => {
    const {call, what} = data;
    try {
      if (what === "load") {
        engine = await Engine.load(data.wasm, progress => port.postMessage({progress}));
        return port.postMessage({call});
      }
      const result = engine[what](data);
      port.postMessage({call, result}, buffersOf(result));
    } catch (error) {
      port.postMessage({call, error: {message: error.message, code: error.code ?? 1}});
    }
  };
}

serve(typeof self !== "undefined" ? self : nodePort());

/** In Node a worker speaks through parentPort; the shape of messages is made that of browsers. */
function nodePort() {
  const {parentPort} = require("worker_threads");
  const port = {postMessage: (message, transfer) => parentPort.postMessage(message, transfer)};
  parentPort.on("message", data => port.onmessage({data}));
  return port;
}
