// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lists and tables of the panel: files, numbers with their errors, interfaces, what was noted. Only ever text.
"use strict";

const Tables = (() => {
  const {$, element, grouped} = Panel;

  /** 3.5e-6 as "3.5·10⁻⁶" */
  function scientific(value) {
    const [digits, power] = (+value).toExponential(1).split("e");
    return digits + "·10" + power.replace("+", "").replace(/./g, c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]);
  }

  // Which error of the report belongs to which row of the page.
  const errorOf = {
    "Solvent-excluded surface, exact": {area: "ses_area", volume: "ses_volume", contact: "contact_area",
                                        toroidal: "toroidal_area", reentrant: "reentrant_area"},
    "Solvent-accessible surface, exact": {area: "sas_area", volume: "sas_volume"},
  };

  /** The rows of a page, section by section, with the errors of what is exact. */
  function numbers(rows, errors = {}) {
    const box = $("tables");
    box.replaceChildren();
    let section = null, body = null;
    for (const [name, label, value] of rows) {
      if (name !== section) {
        const table = element("table");
        body = table.createTBody();
        box.append(element("h3", section = name), table);
      }
      const row = body.insertRow(), error = errors[(errorOf[name] || {})[label]];
      const cell = element("td", value);
      if (error !== undefined) cell.append(element("span", " ± " + scientific(error), {class: "error"}));
      row.append(element("th", label, {scope: "row"}), cell);
    }
  }

  /** What most want to know, beneath the name. */
  function keyNumbers({exact, mesh}, cavities) {
    const [area, volume] = exact ? [exact.ses_area, exact.ses_volume] : [mesh.area, mesh.volume];
    const numbers = [[exact ? "SES area" : "area of the mesh", grouped(area, 1) + " Å²"],
                     [exact ? "SES volume" : "its volume", grouped(volume, 1) + " Å³"]];
    numbers.push(["cavities", String(cavities)]);
    $("key-numbers").replaceChildren(...numbers.map(([label, value]) => {
      const pair = element("div");
      pair.append(element("dt", label), element("dd", value));
      return pair;
    }));
  }

  function interfaces(list = []) {
    $("interfaces").hidden = list.length === 0;
    $("interface-list").replaceChildren(...list.map(pair => {
      const row = element("tr");
      row.append(element("td", `${pair.a} – ${pair.b}`), element("td", grouped(pair.interface_area, 1)),
                 element("td", grouped(pair.buried_ses, 1)));
      return row;
    }));
  }

  function remarks({notes, warnings}) {
    $("remarks").hidden = notes.length + warnings.length === 0;
    const entry = (text, attributes) => element("li", Settings.inFields(text), attributes);
    $("remark-list").replaceChildren(...warnings.map(text => entry(text, {class: "warning"})), ...notes.map(text => entry(text)));
  }

  /** items: {name, state, text}; marked: number of one; chosen(i) when one is picked */
  function files(items, marked, chosen) {
    $("files").hidden = items.length === 0;
    $("file-list").replaceChildren(...items.map((item, i) => {
      const entry = element("li"), button = element("button", undefined, {type: "button", class: item.state});
      button.append(element("span", item.name), element("span", item.text));
      if (i === marked) button.setAttribute("aria-current", "true");
      button.addEventListener("click", () => chosen(i));
      entry.append(button);
      return entry;
    }));
  }

  return {numbers, keyNumbers, interfaces, remarks, files};
})();
