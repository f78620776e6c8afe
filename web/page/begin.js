// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Unpacks what the file holds and begins.
"use strict";

(() => {
  const {$} = Panel;

  /** The example: a structure file, deflated. */
  const example = async () => new File([await Decode.embedded("example-file")], Built.exampleName);

  function setTheme() {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const set = () => { document.documentElement.dataset.theme = dark.matches ? "dark" : "light"; };
    dark.addEventListener("change", set);
    set();
    $("theme").addEventListener("click", e => {
      if (!document.body.classList.contains("empty")) return;   // the page does it
      document.documentElement.dataset.theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    });
    $("toggle").addEventListener("click", () => {
      if (document.body.classList.contains("empty")) document.body.classList.toggle("folded");
    });
  }

  /** Licences are long: they are unpacked for those who want to read them. */
  function offerNotices() {
    $("notices").parentElement.addEventListener("toggle", async () => {
      $("notices").textContent ||= new TextDecoder().decode(await Decode.embedded("notices-file"));
    });
  }

  async function start() {
    if (matchMedia("(max-width: 45rem)").matches) document.body.classList.add("folded");
    setTheme();
    offerNotices();
    if (!window.DecompressionStream || !window.WebAssembly) throw new Error("this browser is too old for it");
    const [wasm] = await Promise.all([Decode.embedded("wasm"), Page.loadThree()]);
    const files = {wasm: await WebAssembly.compile(wasm), worker: $("worker").textContent};
    for (const id of ["wasm", "worker"]) $(id).remove();   // a megabyte of text
    window.meniscus = new App(() => new Meniscus(files), example);
  }

  start().catch(error => {
    $("drop").replaceChildren(`This page cannot work here: ${error.message}.`);
    console.error(error);
  });
})();
