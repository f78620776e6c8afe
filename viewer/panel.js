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
                       pocket.cavity ? "closed" : grouped(pocket.mouthArea + pocket.openingArea)];
      row.append(first, ...numbers.map(text => element("td", text)));
      row.addEventListener("click", () => chosen(i));
      $("pocket-list").append(row);
    });
  }

  function markPocket(chosen) {
    [...$("pocket-list").rows].forEach((row, i) => row.classList.toggle("chosen", i === chosen));
  }

  /** A list of tunnels and pores. */
  function fillWays(ways, chosen) {
    $("ways").hidden = ways.length === 0;
    const pores = ways.filter(way => way.from === "pore").length;
    $("ways-title").textContent = pores === 0 ? "Tunnels" : pores === ways.length ? "Pore" : "Tunnels and pore";
    $("way-list").replaceChildren();
    ways.forEach((way, i) => {
      const row = element("tr"), first = element("td"), button = element("button", undefined, {type: "button"});
      if (way.colour) button.append(swatch(way.colour));
      button.append(element("span", way.from));
      button.setAttribute("aria-label", "Go to the narrowest place of " + way.name);
      first.append(button);
      const numbers = [way.rank ? String(way.rank) : "", plain(way.radius, 2), plain(way.length, 1)];
      row.append(first, ...numbers.map(text => element("td", text)));
      row.addEventListener("click", () => chosen(i));
      $("way-list").append(row);
    });
  }

  function markWay(chosen) {
    [...$("way-list").rows].forEach((row, i) => row.classList.toggle("chosen", i === chosen));
  }

  /** 0 and round numbers up to `most`, about `count` of them. */
  function roundNumbers(most, count) {
    const rough = most / count, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find(s => s * power >= rough);
    return Array.from({length: Math.floor(most / step * (1 + 1e-9)) + 1}, (_, i) => +(i * step).toPrecision(6));
  }

  /**
   * Plots the radius along a tunnel, in the colours of its tube.
   *
   * scale   radii and their colours, in rising order
   */
  function plotWay(way, scale) {
    const svg = $("profile"), [wide, high] = [300, 170], [left, right, top, bottom] = [34, 292, 26, 132];
    const svgElement = (tag, attributes, text) => {
      const e = document.createElementNS("http://www.w3.org/2000/svg", tag);
      for (const name in attributes) e.setAttribute(name, attributes[name]);
      if (text !== undefined) e.textContent = text;
      return e;
    };
    const length = Math.max(way.length, 1e-3), most = 1.08 * Math.max(...way.profile.map(([, radius]) => radius));
    const x = distance => +(left + (right - left) * distance / length).toFixed(2);
    const y = radius => +(bottom - (bottom - top) * radius / most).toFixed(2);
    const line = (from, to, kind) => svgElement("line", {x1: from[0], y1: from[1], x2: to[0], y2: to[1], class: kind});
    const text = (at, anchor, words, kind = "") => svgElement("text", {x: at[0], y: at[1], "text-anchor": anchor, class: kind}, words);
    const said = plain(way.radius, 2) + " Å";
    $("profile-title").textContent = "Radius along " + (way.name === "pore" ? "the pore" : way.name);
    const about = svgElement("desc", {id: "profile-text"}, `narrowest: ${said} at ${plain(way.distance, 1)} Å of ${plain(way.length, 1)} Å`);
    svg.setAttribute("viewBox", `0 0 ${wide} ${high}`);
    svg.replaceChildren(about);
    const shades = svgElement("linearGradient", {id: "shades", gradientUnits: "userSpaceOnUse", x1: 0, y1: y(0), x2: 0, y2: y(most)});
    for (const [radius, colour] of scale)
      if (radius <= most) shades.append(svgElement("stop", {offset: radius / most, "stop-color": colour}));
    svg.append(shades);
    for (const radius of roundNumbers(most, 4))
      svg.append(line([left, y(radius)], [right, y(radius)], "grid"), text([left - 6, y(radius) + 4], "end", short(radius)));
    for (const distance of roundNumbers(length, 5))
      svg.append(line([x(distance), bottom], [x(distance), bottom + 4], "axis"), text([x(distance), bottom + 16], "middle", short(distance)));
    const curve = way.profile.map(([distance, radius]) => x(distance) + " " + y(radius)).join("L");
    svg.append(
      svgElement("path", {d: `M${x(0)} ${bottom}L${curve}L${right} ${bottom}Z`, fill: "url(#shades)"}),
      svgElement("path", {d: "M" + curve, class: "curve", fill: "none"}),
      line([left, bottom], [right, bottom], "axis"),
      text([left - 26, top - 6], "start", "radius, Å"), text([(left + right) / 2, high - 4], "middle", "distance, Å"));
    const at = [x(way.distance), y(way.radius)], isRight = at[0] > (left + right) / 2;
    svg.append(line([at[0], top - 2], at, "mark"), svgElement("circle", {cx: at[0], cy: at[1], r: 3.5}),
               text([at[0] + (isRight ? -4 : 4), top + 5], isRight ? "end" : "start", said, "of-bottleneck"));
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
          fillPockets, markPocket, fillWays, markWay, plotWay,
          fillSchemes, showTip, download};
})();
