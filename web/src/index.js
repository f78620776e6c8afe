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

  constructor({wasm, worker} = {}) {
    this.#files = {wasm, worker};
  }

  async measure(input, options = {}) {
    return this.#ask(callFor("measure", input, options));
  }

  async estimate(input, options = {}) {
    return this.#ask(callFor("estimate", input, options));
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
    const {signal} = call, abort = () => this.#abort(call);
    if (signal?.aborted) throw signal.reason;
    const answer = new Promise((resolve, reject) => Object.assign(call, {resolve, reject}));
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
  #abort(call) {
    if (this.#calls[0] === call) call.worker.end(aborted());
    call.reject(call.signal.reason);
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

  constructor({report, ...arrays}, ask) {
    Object.assign(this, arrays);
    this.report = report;
    this.notes = report.input.notes;
    this.warnings = report.input.warnings;
    this.cavities = report.cavities;
    this.interfaces = report.interfaces ?? [];
    this.#ask = ask;
  }

  async page({colour} = {}) {
    const {data} = await this.#ask({what: "page", colour});
    const info = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + new DataView(data.buffer).getUint32(0, true))));
    return {data, title: info.name + " · Meniscus", rows: info.rows ?? []};
  }

  async file(kind) {
    if (kind === "report.json") return new TextEncoder().encode(JSON.stringify(this.report, null, 2) + "\n");
    return this.#ask({what: "file", kind});
  }

  close() {
    this.#ask({what: "close"}).catch(() => {});   // of a worker that has ended there is nothing to free
  }
}

let shared = null;

/** measure() of an engine that all callers share. */
export const measure = (input, options) => (shared ??= new Meniscus()).measure(input, options);

/** surface() of that engine. */
export const surface = (input, options) => (shared ??= new Meniscus()).surface(input, options);

const aborted = () => Object.assign(new Error("stopped"), {name: "AbortError"});

/** What is asked of the engine. The input is copied: it is the caller's, who may change it while the call waits. */
function callFor(what, input, {name, signal, progress, interfaces, ...options}) {
  if (interfaces) options.between = interfaces === true ? "all" : interfaces;
  const copy = copyOf(input), buffers = copy instanceof Uint8Array ? [copy.buffer] : [copy.positions.buffer, copy.radii.buffer];
  return {message: {what, input: copy, name, options}, buffers, signal, progress};
}

function copyOf(input) {
  if (typeof input === "string") return new TextEncoder().encode(input);
  if (input instanceof Uint8Array) return new Uint8Array(input);
  if (input instanceof ArrayBuffer) return new Uint8Array(input.slice(0));
  if (input?.positions && input?.radii)
    return {positions: new Float64Array(input.positions), radii: new Float64Array(input.radii)};
  throw Object.assign(new Error("give the text or the bytes of a structure file, or {positions, radii}"), {code: 2});
}

const whereFilesLie = "it has to lie beside index.js, or be given to new Meniscus()";

async function moduleOf(wasm) {
  if (wasm instanceof WebAssembly.Module) return wasm;
  const bytes = wasm ?? await fileBeside("meniscus.wasm");
  return WebAssembly.compile(bytes).catch(error => {
    throw new Error(`meniscus.wasm cannot be used: ${error.message}; ${whereFilesLie}`);
  });
}

async function fileBeside(name) {
  const url = new URL(name, import.meta.url);
  try {
    if (isNode) return await (await import("node:fs/promises")).readFile(url);
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`.trim());
    return await answer.arrayBuffer();
  } catch (error) {
    throw new Error(`${url} cannot be loaded: ${error.message}; ${whereFilesLie}`);
  }
}

async function startWorker(script) {
  if (isNode) return nodeWorker(script ?? String(await fileBeside("meniscus-worker.js")));
  if (script === undefined) return new Worker(new URL("./meniscus-worker.js", import.meta.url));
  const url = URL.createObjectURL(new Blob([script], {type: "text/javascript"}));
  const worker = new Worker(url);
  URL.revokeObjectURL(url);
  return worker;
}

/** With the members of a browser's Worker. It keeps the program from ending only while it is asked something. */
async function nodeWorker(script) {
  const threads = await import("node:worker_threads");
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
