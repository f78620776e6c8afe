// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the worker hears and answers; engine.js, which stands before it in the same script, computes.

/** The bytes of a file, unzipped, and its name, if it has one. */
async function fileOf({input, name}) {
  if (!(input instanceof Uint8Array)) return {input, name};
  const bytes = await unzipped(input);
  return {input: bytes, name: name?.replace(/\.gz$/i, "")};
}

async function unzipped(bytes) {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw failure(3, "the gzip data are damaged; fetch the file again");
  }
}

/** The array buffers of an answer, which are handed over rather than copied. */
function buffersOf(value, found = []) {
  if (ArrayBuffer.isView(value)) found.push(value.buffer);
  else if (value && typeof value === "object" && !Array.isArray(value))
    for (const part of Object.values(value)) buffersOf(part, found);
  return found;
}

/** An error as a message. What has no code is a mistake in the module, whose memory cannot be trusted any more. */
function messageOf({message, code}) {
  const inOurWords = message.replace(/^between: /, "interfaces: ");   // which is what the package calls this option
  if (code !== undefined) return {error: {message: inOurWords, code}};
  return {error: {message: `the engine has failed: ${message || "an unknown exception"}; please report it`, code: 1}, broken: true};
}

/** Answers messages {what, ...} by {result} or {error}, and by {progress} before; the first, "load", brings the module. */
function serve(port) {
  let engine = null;
  const answer = async request => {
    if (request.what !== "load") return engine[request.what]({...request, ...await fileOf(request)});
    engine = await Engine.load(request.wasm, progress => port.postMessage({progress}));
  };
  port.onmessage = async ({data}) => {
    try {
      const result = await answer(data);
      port.postMessage({result}, buffersOf(result));
    } catch (error) {
      port.postMessage(messageOf(error));
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
