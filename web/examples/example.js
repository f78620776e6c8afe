// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the example pages share: the molecule to begin with, a file that is dropped or chosen, colour, opacity, the line of
// text. What is special to a viewer stands in its page.
import {SCHEMES} from "../adapters/colours.js";

const FIRST = new URL("1ubq.pdb", import.meta.url);
const element = id => document.getElementById(id);

document.querySelector("header").insertAdjacentHTML("beforeend", `
  <label>Colour <select id="colour">${SCHEMES.map(scheme => `<option>${scheme}</option>`).join("")}</select></label>
  <label>Opacity <input id="opacity" type="range" min="0.1" max="1" step="0.05" value="0.7"></label>
  <label class="button">Open a file<input id="file" type="file" accept=".pdb,.ent,.cif,.mmcif,.gz"></label>`);
document.querySelector("footer").innerHTML = '<span id="status" role="status"></span><span id="atom"></span>';

const style = () => ({colour: element("colour").value, opacity: Number(element("opacity").value)});

/** The line of text at the right: what the pointer is on. */
export function say(text) {
  element("atom").textContent = text ?? "";
}

/**
 * Shows the first molecule, then every file that is dropped or chosen.
 * show   ({name, text, format}, style) => handle of the surface, which has `update`; format is "pdb" or "cif"
 */
export function start(show) {
  let handle = null;
  const change = () => handle?.update(style());
  element("colour").addEventListener("change", change);
  element("opacity").addEventListener("input", change);
  element("file").addEventListener("change", event => open(event.target.files[0]));
  acceptDrops(open);
  fetchFirst().then(open).catch(complain);

  async function open(file) {
    delete document.body.dataset.ready;
    tell(`Computing the surface of ${file.name} …`);
    const begin = performance.now();
    try {
      handle = await show(await read(file), style());
      const {atoms, positions, indices} = handle.surface, seconds = ((performance.now() - begin) / 1000).toFixed(1);
      tell(`${file.name}: ${atoms.count} atoms, ${positions.length / 3} vertices, ${indices.length / 3} triangles in ${seconds} s`);
      document.body.dataset.ready = file.name;
    } catch (error) {
      complain(error);
    }
  }
}

async function fetchFirst() {
  const answer = await fetch(FIRST);
  if (!answer.ok) throw new Error("Drop a structure here, or open a file.");
  return new File([await answer.blob()], "1ubq.pdb");
}

/** Both the viewer and the surface get the text. */
async function read(file) {
  const zipped = /\.gz$/i.test(file.name), name = file.name.replace(/\.gz$/i, "");
  const stream = zipped ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file.stream();
  return {name, text: await new Response(stream).text(), format: /\.(mm)?cif$/i.test(name) ? "cif" : "pdb"};
}

/** Before the viewer, which may take dropped files, too. */
function acceptDrops(open) {
  const over = state => document.body.classList.toggle("over", state);
  const on = (type, act) => addEventListener(type, event => {
    event.preventDefault();
    event.stopPropagation();
    act(event);
  }, {capture: true});
  on("dragenter", () => over(true));
  on("dragover", () => over(true));
  on("dragleave", event => event.relatedTarget || over(false));
  on("drop", event => {
    over(false);
    if (event.dataTransfer.files.length > 0) open(event.dataTransfer.files[0]);
  });
}

function tell(text, wrong = false) {
  element("status").textContent = text;
  element("status").classList.toggle("wrong", wrong);
}

const complain = error => tell(error.message, true);
