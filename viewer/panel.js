// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What is read beside the surface: names, legend, cavities, what was clicked. Text from the input is only ever text.
"use strict";

const Panel = (() => {
  const $ = id => document.getElementById(id);

  function element(tag, text, attributes = {}) {
    const e = document.createElement(tag);
    if (text !== undefined) e.textContent = text;
    for (const name in attributes) e.setAttribute(name, attributes[name]);
    return e;
  }

  const plain = (value, digits) => (+value).toFixed(digits).replace("-", "−");
  /** With its thousands apart, as the tables have it. */
  const grouped = (value, digits = 0) => plain(value, digits).replace(/\d+/, n => n.replace(/\B(?=(\d{3})+$)/g, ","));
  const short = value => String(+(+value).toPrecision(4)).replace("-", "−");

  /** "LEU 43" and "A" of an atom's residue. */
  function residueOf(data, atom) {
    const residue = data.info.residues.list[data.atoms.residue[atom]];
    if (!residue) return {name: "", chain: ""};
    const [chain, name, number, code] = residue;
    const {chains, names} = data.info.residues;
    return {name: [names[name], number + code].filter(Boolean).join(" "), chain: chains[chain]};
  }

  const atomName = (data, atom) => data.info.atoms.names[data.atoms.name[atom]];

  function atomTitle(data, atom) {
    const {name, chain} = residueOf(data, atom);
    return [name, atomName(data, atom)].filter(Boolean).join(" ") + (chain ? " · chain " + chain : "");
  }

  /** Koenderink & van Doorn's words. */
  function shapeWord(index) {
    const words = [[-0.875, "cup"], [-0.625, "trough"], [-0.375, "rut"], [-0.125, "saddle rut"], [0.125, "saddle"],
                   [0.375, "saddle ridge"], [0.625, "ridge"], [0.875, "dome"], [Infinity, "cap"]];
    return words.find(([end]) => index < end)[1];
  }

  function swatch(colour) {
    const dot = element("i");
    dot.style.background = colour;
    return dot;
  }

  function rampStrip(ramp) {
    const strip = element("canvas");
    strip.width = 256;
    strip.height = 1;
    const context = strip.getContext("2d"), fill = context.createLinearGradient(0, 0, 256, 0);
    ramp.forEach((colour, i) => fill.addColorStop(i / (ramp.length - 1), colour));
    context.fillStyle = fill;
    context.fillRect(0, 0, 256, 1);
    return strip;
  }

  /** Ends and middle of a scale to a hundredth of its length, all with the same decimals, and no more than they need. */
  function ticks({min, max}) {
    const values = [min, (min + max) / 2, max].map(Number);
    const most = max > min ? Math.min(20, Math.max(0, 2 - Math.floor(Math.log10(max - min)))) : 4;
    const inDigits = digits => values.map(value => value.toFixed(digits));
    let digits = most;
    while (digits > 0 && inDigits(digits).every(text => text.endsWith("0"))) --digits;
    return inDigits(digits).map(text => text.replace("-", "−"));
  }

  function showLegend(legend) {
    const box = $("legend");
    box.replaceChildren();
    box.hidden = legend.ramp.length === 0 && legend.entries.length === 0;
    if (legend.title) box.append(element("h2", legend.title));
    if (legend.ramp.length > 0) {
      const ends = element("div", undefined, {class: "ends"});
      ends.append(...ticks(legend).map(tick => element("span", tick)));
      box.append(rampStrip(legend.ramp), ends);
    }
    const list = element("ul", undefined, {class: legend.entries.length > 8 ? "many" : ""});
    for (const [label, colour] of legend.entries) {
      const item = element("li");
      item.append(swatch(colour), element("span", label));
      list.append(item);
    }
    if (legend.entries.length > 0) box.append(list);
  }

  function showFacts(title, facts) {
    $("picked-name").textContent = title;
    $("picked-facts").replaceChildren();
    for (const [label, value] of facts)
      if (value !== null && value !== "") $("picked-facts").append(element("dt", label), element("dd", value));
    $("picked").hidden = false;
  }

  function fillCavities(cavities, ligandsLeftOut, chosen) {
    $("cavities").hidden = cavities.length === 0;
    $("left-out").hidden = ligandsLeftOut === "";
    $("left-out").textContent = "Ligands that may fill them were left out: " + ligandsLeftOut;
    $("cavity-list").replaceChildren();
    cavities.forEach((cavity, i) => {
      const row = element("tr"), first = element("td"), button = element("button", String(i + 1), {type: "button"});
      button.setAttribute("aria-label", "Go to cavity " + (i + 1));
      first.append(button);
      row.append(first, element("td", grouped(cavity.volume, 1)), element("td", grouped(cavity.area, 1)));
      row.addEventListener("click", () => chosen(i));
      $("cavity-list").append(row);
    });
  }

  function markCavity(chosen) {
    [...$("cavity-list").rows].forEach((row, i) => row.classList.toggle("chosen", i === chosen));
  }

  function fillPockets(pockets, chosen) {
    $("pockets").hidden = pockets.length === 0;
    $("pocket-list").replaceChildren();
    pockets.forEach((pocket, i) => {
      const row = element("tr"), first = element("td"), button = element("button", undefined, {type: "button"});
      button.append(swatch(pocket.colour), element("span", pocket.name));
      button.setAttribute("aria-label", "Go to pocket " + pocket.name);
      first.append(button);
      const numbers = [plain(pocket.score, 2), grouped(pocket.volume), plain(pocket.depth, 1),
                       pocket.cavity ? "closed" : String(pocket.mouths)];
      row.append(first, ...numbers.map(text => element("td", text)));
      row.addEventListener("click", () => chosen(i));
      $("pocket-list").append(row);
    });
  }

  function markPocket(chosen) {
    [...$("pocket-list").rows].forEach((row, i) => row.classList.toggle("chosen", i === chosen));
  }

  function fillSchemes(schemes, first) {
    $("scheme").replaceChildren();
    for (const scheme of schemes) $("scheme").append(element("option", scheme.label, {value: scheme.id}));
    $("scheme").value = first;
  }

  function showTip(text, x, y) {
    const tip = $("tip"), box = $("stage").getBoundingClientRect();
    tip.hidden = !text;
    if (!text) return;
    tip.textContent = text;
    tip.style.left = Math.min(x - box.left + 14, box.width - tip.offsetWidth - 4) + "px";
    tip.style.top = Math.min(y - box.top + 16, box.height - tip.offsetHeight - 4) + "px";
  }

  /** Hands a blob to the browser's downloads. */
  function download(blob, name) {
    const link = element("a", undefined, {href: URL.createObjectURL(blob), download: name});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  return {$, element, plain, grouped, short, residueOf, atomName, atomTitle, shapeWord, showLegend, showFacts, fillCavities, markCavity,
          fillPockets, markPocket,
          fillSchemes, showTip, download};
})();
