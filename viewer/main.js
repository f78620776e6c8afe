// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Begins: unpacks what the page holds and shows it.
"use strict";

(() => {
  const {$} = Panel;

  async function start() {
    const narrow = matchMedia("(max-width: 45rem)").matches;
    if (narrow) document.body.classList.add("folded");
    if (!window.DecompressionStream) throw new Error("this browser is too old to decompress it");
    if (!$("view").getContext("webgl2", Page.context)) throw new Error("this browser has no WebGL 2");
    $("notice").textContent = "Loading …";
    const [bytes] = await Promise.all([Decode.embedded("data"), Page.loadThree()]);
    document.body.classList.replace("plain", "live");
    const page = new Page(Decode.decode(bytes), Page.renderer());
    page.drawNow();
    for (const id of ["data", "three"]) $(id).remove();   // some megabytes of text
    window.meniscus = page;
    document.body.dataset.ready = "true";
    performance.mark("meniscus-ready");
  }

  start().catch(error => {
    document.body.className = "plain";
    $("notice").textContent = $("picture") ? "This is a picture of the surface; it cannot be rotated here (" + error.message + ")."
                                           : "The surface cannot be shown here (" + error.message + ").";
    console.error(error);
  });
})();
