// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Solvent-excluded surfaces in the browser and in Node: the program's core in a worker. index.d.ts has the types.

const isNode = typeof process !== "undefined" && Boolean(process.versions?.node) && typeof Worker === "undefined";

/** Runs the engine in one worker; calls are answered one after the other. */
export class Meniscus {
  #wasm;
  #script;
  #worker = null;
  #loaded = null;
  #calls = new Map();
  #next = 1;

  /** wasm: the bytes or the module of meniscus.wasm; worker: the text of meniscus-worker.js; both may be left out where
   *  these files lie beside this one */
  constructor({wasm, worker} = {}) {
    this.#wasm = wasm;
    this.#script = worker;
  }

  /** Areas and volumes with their errors, and areas of atoms, without a mesh. */
  async measure(input, options = {}) {
    return this.#ask({what: "measure", ...await request(input, options)}, options);
  }

  /** What a surface would take: {atoms, seconds, megabytes}. */
  async estimate(input, options = {}) {
    return this.#ask({what: "estimate", ...await request(input, options)}, options);
  }

  /** The surface as a mesh in typed arrays, with its report. */
  async surface(input, options = {}) {
    const given = await request(input, options);
    const answer = await this.#ask({what: "surface", ...given}, options);
    return new Surface(answer, (what, more) => this.#ask({what, number: answer.number, ...more}, {}), this.#worker,
                       () => this.#worker);
  }

  /** Ends what is running: its calls are rejected with the name "AbortError". Surfaces keep their arrays, and nothing
   *  else. The next call starts a new worker. */
  stop() {
    this.#worker?.terminate();
    this.#forget(aborted());
  }

  async #ask(message, {signal, progress}) {
    if (signal?.aborted) throw aborted();
    await (this.#loaded ??= this.#load());
    return this.#call(message, {signal, progress});
  }

  #call(message, {signal, progress} = {}) {
    const call = this.#next++;
    return new Promise((resolve, reject) => {
      const stop = () => this.stop();
      signal?.addEventListener("abort", stop, {once: true});
      const done = f => value => {
        signal?.removeEventListener("abort", stop);
        f(value);
      };
      this.#calls.set(call, {resolve: done(resolve), reject: done(reject), progress});
      this.#worker.postMessage({...message, call});
    });
  }

  async #load() {
    const [wasm, worker] = await Promise.all([moduleOf(this.#wasm), startWorker(this.#script)]);
    this.#wasm = wasm;
    this.#worker = worker;
    worker.onmessage = ({data}) => this.#hear(data);
    worker.onerror = event => this.#forget(new Error(event.message || "the worker has ended"));
    await this.#call({what: "load", wasm});
  }

  #hear({call, result, error, progress}) {
    if (progress) return this.#calls.values().next().value?.progress?.(progress);   // the first is the one that runs
    const waiting = this.#calls.get(call);
    this.#calls.delete(call);
    if (error) waiting?.reject(Object.assign(new Error(error.message), {code: error.code}));
    else waiting?.resolve(result);
  }

  #forget(error) {
    const waiting = [...this.#calls.values()];
    this.#calls.clear();
    this.#worker = this.#loaded = null;
    for (const {reject} of waiting) reject(error);
  }
}

/** A surface: arrays of its own, and the means to ask the engine for more until close(). */
class Surface {
  #ask;
  #home;
  #now;

  constructor({number, report, ...arrays}, ask, home, now) {
    Object.assign(this, arrays);
    this.report = report;
    this.notes = report.input.notes;
    this.warnings = report.input.warnings;
    this.cavities = report.cavities;
    this.interfaces = report.interfaces ?? [];
    this.#ask = ask;
    this.#home = home;
    this.#now = now;
  }

  /** What a page shows: {data, title, rows}; data is what the viewer decodes. */
  async page({colour} = {}) {
    const {data} = await this.#more("page", {colour});
    const info = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + new DataView(data.buffer).getUint32(0, true))));
    return {data, title: info.name + " · Meniscus", rows: info.rows ?? []};
  }

  /** A file as the program writes it, as bytes: "ply", "glb", "stl", "obj", "off", "vtp", "atoms.csv", "residues.csv",
   *  "chains.csv", "cavities.csv", "report.json". */
  async file(kind) {
    if (kind === "report.json") return new TextEncoder().encode(JSON.stringify(this.report, null, 2) + "\n");
    return this.#more("file", {kind});
  }

  /** Frees what the engine keeps for page() and file(). */
  close() {
    if (this.#now() === this.#home) this.#more("close", {}).catch(() => {});
  }

  #more(what, more) {
    return this.#now() === this.#home ? this.#ask(what, more) : Promise.reject(aborted());
  }
}

let shared = null;

/** measure() of an engine that all callers share. */
export const measure = (input, options) => (shared ??= new Meniscus()).measure(input, options);

/** surface() of that engine. Its memory is freed at once where only the arrays are needed: call close(). */
export const surface = (input, options) => (shared ??= new Meniscus()).surface(input, options);

const aborted = () => Object.assign(new Error("stopped"), {name: "AbortError"});

/** What the worker is told of an input and options; the caller keeps its arrays. */
async function request(input, {name, signal, progress, interfaces, ...options}) {
  if (interfaces) options.between = interfaces === true ? "all" : interfaces;
  if (typeof input === "string") input = new TextEncoder().encode(input);
  if (input instanceof ArrayBuffer) input = new Uint8Array(input);
  if (input instanceof Uint8Array) {
    const plain = await unzipped(input);
    return {input: plain, name: (name ?? guessed(plain)).replace(/\.gz$/i, ""), options};
  }
  if (input?.positions && input?.radii) return {input, name: name ?? "spheres", options};
  throw Object.assign(new Error("give the text or the bytes of a structure file, or {positions, radii}"), {code: 2});
}

/** The name of a file whose content tells its format. */
function guessed(bytes) {
  const head = new TextDecoder("latin1").decode(bytes.subarray(0, 4096));
  if (/^\s*(#[^\n]*\n\s*)*data_/.test(head)) return "structure.cif";
  return bytes[0] >= 0x80 ? "structure.bcif" : "structure.pdb";
}

async function unzipped(bytes) {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw Object.assign(new Error("the gzip data are damaged; fetch the file again"), {code: 3});
  }
}

async function moduleOf(wasm) {
  if (wasm instanceof WebAssembly.Module) return wasm;
  return WebAssembly.compile(wasm ?? await fileBeside("meniscus.wasm"));
}

async function fileBeside(name) {
  const url = new URL(name, import.meta.url);
  if (isNode) return (await import("node:fs/promises")).readFile(url);
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}; it has to lie beside index.js`);
  return answer.arrayBuffer();
}

async function startWorker(script) {
  if (isNode) return nodeWorker(script ?? String(await fileBeside("meniscus-worker.js")));
  if (script === undefined) return new Worker(new URL("./meniscus-worker.js", import.meta.url));
  const url = URL.createObjectURL(new Blob([script], {type: "text/javascript"}));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}

async function nodeWorker(script) {
  const threads = await import("node:worker_threads");
  const worker = new threads.Worker(script, {eval: true});
  worker.unref();
  const port = {postMessage: (message, transfer) => worker.postMessage(message, transfer),
                terminate: () => worker.terminate()};
  worker.on("message", data => port.onmessage({data}));
  worker.on("error", error => port.onerror({message: error.message}));
  return port;
}
