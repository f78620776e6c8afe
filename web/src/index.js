// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Solvent-excluded surfaces in the browser and in Node: the program's core in a worker. index.d.ts has the types.

const isNode = typeof process !== "undefined" && Boolean(process.versions?.node) && typeof Worker === "undefined";

/** Computes in a worker; calls are answered one after the other. */
export class Meniscus {
  #files;
  #module = null;   // promise of the compiled module, which every worker gets
  #worker = null;
  #calls = [];      // the first is the one that runs; the worker knows of no other

  constructor(given = {}) {
    this.#files = plain("the files of the engine", given, "{wasm, worker}");
  }

  async measure(input, options = {}) {
    return this.#ask(callFor("measure", input, options));
  }

  async estimate(input, options = {}) {
    return this.#ask(callFor("estimate", input, options));
  }

  async pockets(input, options = {}) {
    return this.#ask(callFor("pockets", input, options, asFitted));
  }

  async surface(input, options = {}) {
    const call = callFor("surface", input, options), {number, ...parts} = await this.#ask(call);
    return new Surface(parts, message => this.#ask({message: {...message, number}, worker: call.worker}));
  }

  stop() {
    this.#worker?.end(aborted());
    for (const call of this.#calls.splice(0)) call.reject(aborted());
  }

  async #ask(call) {
    const {signal, progress} = call, abort = () => this.#abort(call, signal.reason);
    if (signal?.aborted) throw signal.reason;
    const answer = new Promise((resolve, reject) => Object.assign(call, {resolve, reject}));
    if (progress) call.progress = at => new Promise(done => done(progress(at))).catch(error => this.#abort(call, error));
    signal?.addEventListener("abort", abort);
    this.#calls.push(call);
    if (this.#calls.length === 1) this.#run(call);
    try {
      return await answer;
    } finally {
      signal?.removeEventListener("abort", abort);
    }
  }

  async #run(call) {
    try {
      call.worker ??= this.#liveWorker();
      call.resolve(await call.worker.ask(call));
    } catch (error) {
      call.reject(error);
    }
    this.#leave(call);
  }

  /** Makes room for the next call, unless this one has been aborted or stopped meanwhile. */
  #leave(call) {
    const place = this.#calls.indexOf(call);
    if (place >= 0) this.#calls.splice(place, 1);
    if (place === 0 && this.#calls.length > 0) this.#run(this.#calls[0]);
  }

  /** A computation cannot be interrupted: its worker is ended. Calls that wait are not concerned. */
  #abort(call, reason) {
    if (this.#calls[0] === call) call.worker.end(aborted());
    call.reject(reason);
    this.#leave(call);
  }

  #liveWorker() {
    if (!this.#worker || this.#worker.ended) this.#worker = new EngineWorker(this.#compiled(), this.#files.worker);
    return this.#worker;
  }

  #compiled() {
    return this.#module ??= moduleOf(this.#files.wasm).catch(error => {
      this.#module = null;   // the next call tries again
      throw error;
    });
  }
}

/** A worker with the engine, from its start to its end. It is asked one thing at a time. */
class EngineWorker {
  ended = null;      // the error that has ended it
  #port = null;
  #loaded;
  #pending = null;   // of what it is asked: {resolve, reject, progress}

  /** module: promise of a WebAssembly.Module */
  constructor(module, script) {
    this.#loaded = Promise.all([module, this.#start(script)]).then(([wasm]) => this.#send({message: {what: "load", wasm}}));
    this.#loaded.catch(error => this.end(error));
  }

  async ask(call) {
    await this.#loaded;
    return this.#send(call);
  }

  /** What it is asked is rejected with the error, now and from now on. */
  end(error) {
    this.ended ??= error;
    this.#port?.terminate();
    this.#pending?.reject(this.ended);
  }

  async #start(script) {
    const port = this.#port = await startWorker(script);
    port.onmessage = ({data}) => this.#hear(data);
    port.onerror = ({message}) => this.end(new Error(message || `meniscus-worker.js cannot be loaded; ${whereFilesLie}`));
    if (this.ended) port.terminate();
  }

  #send({message, buffers = [], progress}) {
    if (this.ended) throw this.ended;
    return new Promise((resolve, reject) => {
      this.#pending = {resolve, reject, progress};
      this.#port.postMessage(message, buffers);
    });
  }

  #hear({result, error, broken, progress}) {
    if (progress) return this.#pending.progress?.(progress);
    if (!error) return this.#pending.resolve(result);
    const said = Object.assign(new Error(error.message), {code: error.code});
    this.#pending.reject(said);
    if (broken) this.end(said);
  }
}

/** A surface: arrays of its own, and the means to ask the engine for more until close(). */
class Surface {
  #ask;
  #closed = false;

  constructor({report, ...arrays}, ask) {
    Object.assign(this, arrays);
    this.report = report;
    this.notes = report.input.notes;
    this.warnings = report.input.warnings;
    this.cavities = report.cavities;
    this.interfaces = report.interfaces ?? [];
    this.#ask = ask;
  }

  async page(options = {}) {
    const {colour = "", ...others} = plain("options", options, '{colour: "element"}'), [other] = Object.keys(others);
    this.#checkOpen();
    if (other !== undefined) throw usage(`there is no option '${other}' of a page; give {colour}`);
    if (typeof colour !== "string") throw usage(`colour: must be the name of a scheme such as "element", not ${said(colour)}`);
    const {data} = await this.#ask({what: "page", colour});
    const info = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + new DataView(data.buffer).getUint32(0, true))));
    return {data, title: info.name + " · Meniscus", rows: info.rows ?? []};
  }

  async file(kind) {
    this.#checkOpen();
    if (!fileKinds.includes(kind)) throw usage(`kind: there is no file ${said(kind)}; choose one of ${fileKinds.join(", ")}`);
    if (kind === "report.json") return new TextEncoder().encode(JSON.stringify(this.report, null, 2) + "\n");
    return this.#ask({what: "file", kind});
  }

  close() {
    if (this.#closed) return;
    this.#closed = true;
    this.#ask({what: "close"}).catch(() => {});   // of a worker that has ended there is nothing to free
  }

  #checkOpen() {
    if (this.#closed) throw usage("this surface has been closed; ask for pages and files before close(), or compute it again");
  }
}

let shared = null;

/** measure() of an engine that all callers share. */
export const measure = (input, options) => (shared ??= new Meniscus()).measure(input, options);

/** pockets() of that engine. */
export const pockets = (input, options) => (shared ??= new Meniscus()).pockets(input, options);

/** surface() of that engine. */
export const surface = (input, options) => (shared ??= new Meniscus()).surface(input, options);

const fileKinds = ["ply", "obj", "stl", "off", "glb", "vtp", "report.json",
                   ...["atoms", "residues", "chains", "cavities"].flatMap(table => [table + ".csv", table + ".json"])];

const asFitted = {radii: "united", hetero: "none"};   // as the ranking of pockets was

const aborted = () => Object.assign(new Error("stopped"), {name: "AbortError"});

/** What is asked of the engine. The input is copied: it is the caller's, who may change it while the call waits. */
function callFor(what, input, given, usual = {}) {
  const {name, signal, progress, interfaces, ...options} = {...usual, ...checkedOptions(given)};
  if (interfaces) options.between = interfaces === true ? "all" : interfaces;
  const copy = copyOf(input), buffers = copy instanceof Uint8Array ? [copy.buffer] : [copy.positions.buffer, copy.radii.buffer];
  return {message: {what, input: copy, name, options}, buffers, signal, progress};
}

function copyOf(input) {
  const type = typeOf(input);
  if (type === "String") return new TextEncoder().encode(checkedText(input));
  if (type === "Uint8Array") return new Uint8Array(input);
  if (type === "ArrayBuffer") return new Uint8Array(input.slice(0));
  if (type === "Object" && ("positions" in input || "radii" in input)) return copyOfSpheres(input);
  const hint = type === "Promise" ? "; await it" : typeof input?.arrayBuffer === "function" ? "; await its arrayBuffer()" : "";
  throw usage(`input: must be the text or the bytes of a structure file, or {positions, radii}, not ${said(input)}${hint}`);
}

function copyOfSpheres(input) {
  const radii = numbersOf("radii", input.radii, radius => radius > 0, "a finite number above 0");
  const positions = numbersOf("positions", input.positions, () => true, "a finite number; write x, y, z of each sphere in a row");
  const count = radii.length;
  if (count === 0) throw usage("radii: must be those of at least one sphere");
  if (positions.length !== 3 * count)
    throw usage(`positions: must have x, y, z for each of ${count} radii, ${3 * count} numbers, not ${positions.length}`);
  return {positions, radii};
}

function numbersOf(name, given, isRight, rule) {
  if (typeof given !== "object" || !(given?.length >= 0)) throw usage(`${name}: must be an array of numbers, not ${said(given)}`);
  return Float64Array.from(given, (value, i) => {
    if (!Number.isFinite(value) || !isRight(value)) throw usage(`${name}: item ${i} is ${said(value)}; it must be ${rule}`);
    return value;
  });
}

// What callers may give. Errors say what they have given instead.

const usage = message => Object.assign(new Error(message), {code: 2});

/** "String", "Object", "Promise" ..., also of another page's or context's values. */
const typeOf = value => Object.prototype.toString.call(value).slice(8, -1);

function said(value) {
  if (typeof value === "string") return JSON.stringify(value.length > 40 ? value.slice(0, 40) + "…" : value);
  if (value === null || !["object", "function"].includes(typeof value)) return String(value);
  return (/^[AEIO]/.test(typeOf(value)) ? "an " : "a ") + typeOf(value);
}

function plain(name, value, example) {
  if (typeOf(value) !== "Object") throw usage(`${name}: must be an object such as ${example}, not ${said(value)}`);
  const above = Object.getPrototypeOf(value);
  if (above !== null && Object.getPrototypeOf(above) !== null)
    throw usage(`${name}: must be a plain object such as ${example}; what it inherits would be overlooked`);
  return value;
}

const optionRules = {
  name: [value => typeof value === "string" && value !== "", 'the name of a file such as "1ubq.pdb"'],
  signal: [value => typeof value.aborted === "boolean" && typeof value.addEventListener === "function", "an AbortSignal"],
  progress: [value => typeof value === "function", "a function"],
  interfaces: [value => ["boolean", "string"].includes(typeof value), 'true or the names of chains such as "A,B:C"'],
};
const otherRule = [value => ["string", "number", "boolean"].includes(typeof value) || Array.isArray(value),
                   "a text, a number, true or false"];

/** A copy of options without those that are undefined or null. */
function checkedOptions(given) {
  const all = Object.entries(plain("options", given, "{spacing: 0.5}"));
  const options = all.filter(([, value]) => value !== undefined && value !== null);
  for (const [name, value] of options) {
    const [isRight, rule] = Object.hasOwn(optionRules, name) ? optionRules[name] : otherRule;
    if (!isRight(value)) throw usage(`${name}: must be ${rule}, not ${said(value)}`);
  }
  return Object.fromEntries(options);
}

/** A text is what a file holds; beginners give its name. */
function checkedText(text) {
  if (text === "" || /\s/.test(text)) return text;
  throw usage(`input: ${said(text)} is not the text of a structure file; read or fetch the file first, and give what it holds`);
}

// Bundlers know these expressions, as they stand here, and take the files along. The worker's is not within new Worker():
// there they would build it anew as a module of theirs, which it is not.
const files = {
  "meniscus.wasm": () => new URL("./meniscus.wasm", import.meta.url),
  "meniscus-worker.js": () => new URL("./meniscus-worker.js", import.meta.url),
};
const whereFilesLie = "it has to lie beside index.js or the bundle that holds it, or be given to new Meniscus()";

/** A module of Node; its name is no literal, lest bundlers for browsers look for it. */
const nodeModule = name => import(/* webpackIgnore: true */ /* @vite-ignore */ "node:" + name);

async function moduleOf(wasm) {
  if (wasm instanceof WebAssembly.Module) return wasm;
  const bytes = wasm ?? await loadedFile("meniscus.wasm");
  return WebAssembly.compile(bytes).catch(error => {
    throw new Error(`meniscus.wasm cannot be used: ${error.message}; ${whereFilesLie}`);
  });
}

async function loadedFile(name) {
  let place = name;
  try {
    const url = place = files[name]();
    if (isNode) return await (await nodeModule("fs/promises")).readFile(url);
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`.trim());
    return await answer.arrayBuffer();
  } catch (error) {
    throw new Error(`${place} cannot be loaded: ${error.message}; ${whereFilesLie}`);
  }
}

async function startWorker(script) {
  if (isNode) return nodeWorker(script ?? String(await loadedFile("meniscus-worker.js")));
  if (script === undefined) return new Worker(files["meniscus-worker.js"]());
  const url = URL.createObjectURL(new Blob([script], {type: "text/javascript"}));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}

/** With the members of a browser's Worker. It keeps the program from ending only while it is asked something. */
async function nodeWorker(script) {
  const threads = await nodeModule("worker_threads");
  const worker = new threads.Worker(script, {eval: true});
  const port = {
    postMessage: (message, buffers) => {
      worker.ref();
      worker.postMessage(message, buffers);
    },
    terminate: () => worker.terminate(),
  };
  worker.on("message", data => {
    if (!data.progress) worker.unref();
    port.onmessage({data});
  });
  worker.on("error", error => port.onerror({message: error.message}));
  worker.unref();
  return port;
}
