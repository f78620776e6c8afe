// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lists and tables of the panel: files, numbers with their errors, interfaces, what was noted. Only ever text.
"use strict";

const Tables = (() => {
  const {$, element, plain} = Panel;

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
    const grouped = value => Number(plain(value, 1)).toLocaleString("en", {minimumFractionDigits: 1});
    const numbers = exact ? [["area", grouped(exact.ses_area) + " Å²"], ["volume", grouped(exact.ses_volume) + " Å³"]]
                          : [["area of the mesh", grouped(mesh.area) + " Å²"], ["its volume", grouped(mesh.volume) + " Å³"]];
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
      row.append(element("td", `${pair.a} – ${pair.b}`), element("td", plain(pair.interface_area, 1)),
                 element("td", plain(pair.buried_ses, 1)));
      return row;
    }));
  }

  // The engine names options as its callers set them; here they are fields.
  const fields = [["waters = true", "“waters, too”"], ["hetero = ligands", "“also ligands”"],
                  ["hetero = all", "“also ions and all else”"]];
  const inFields = text => fields.reduce((changed, [option, field]) => changed.replace(option, field), text);

  function remarks({notes = [], warnings = []}) {
    $("remarks").hidden = notes.length + warnings.length === 0;
    $("remark-list").replaceChildren(...warnings.map(text => element("li", inFields(text), {class: "warning"})),
                                     ...notes.map(text => element("li", inFields(text))));
  }

  /** items: {name, state, text}; chosen(i) when one is picked */
  function files(items, current, chosen) {
    $("files").hidden = items.length === 0;
    $("file-list").replaceChildren(...items.map((item, i) => {
      const entry = element("li"), button = element("button", undefined, {type: "button", class: item.state});
      button.append(element("span", item.name), element("span", item.text));
      if (item === current) button.setAttribute("aria-current", "true");
      button.addEventListener("click", () => chosen(items[i]));
      entry.append(button);
      return entry;
    }));
  }

  return {numbers, keyNumbers, interfaces, remarks, files};
})();
