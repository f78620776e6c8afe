// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options of the surface, as the form has them.
"use strict";

const Settings = (() => {
  const {$} = Panel;
  const numbers = ["probe", "spacing", "model"];
  const words = ["radii", "method", "hetero", "waters", "hydrogens", "altloc", "assembly", "select"];

  /** What the engine is asked for; a field that is empty is left to the engine. Throws an Error with one line. */
  function read() {
    const options = {exact: $("exact").checked, interfaces: $("between").checked && $("exact").checked};
    for (const id of numbers.filter(id => !$(id).disabled)) {
      if (!$(id).checkValidity() || $(id).value === "") {
        reveal($(id));
        throw new Error(`${$(id).labels[0].textContent}: ${$(id).validationMessage || "a number is needed"}`);
      }
      options[id] = +$(id).value;
    }
    for (const id of words)
      if ($(id).value.trim() !== "") options[id] = $(id).value.trim();
    const chains = $("chains").value.split(",").map(c => c.trim()).filter(Boolean);
    if (chains.length > 0) options.chains = chains;
    if ($("join").checked) options.model = "join";
    return options;
  }

  /** What the engine says, which names options as its callers set them; here they are fields. */
  function inFields(text) {
    const field = (_, id, value) => `“${fieldOf(id, value)}”`;
    return text.replace(/; give others with radii = FILE|, or allow more memory/, "")
               .replace(/\b(select) = (\([^)]*\)|.+?(?=: understood as ))/g, field)
               .replace(/\b(radii|hydrogens|hetero|waters|model|altloc|method) = ([^\s,;:)]+)/g, field);
  }

  function fieldOf(id, value) {
    const label = $(id).labels[0].textContent, choice = [...$(id).options || []].find(option => option.value === value);
    if (id === "model" && value === "join") return `${label}: ${$("join").labels[0].textContent.trim()}`;
    return ["N", "ID"].includes(value) ? label : `${label}: ${choice ? choice.textContent : value}`;
  }

  /** Unfolds what hides a field and goes there. */
  function reveal(field) {
    for (let e = field.parentElement; e; e = e.parentElement) if (e.tagName === "DETAILS") e.open = true;
    field.focus();
  }

  /** changed() after every change, submitted() where the form is sent off. */
  function listen({changed, submitted}) {
    $("options").addEventListener("input", () => {
      $("model").disabled = $("join").checked;
      changed();
    });
    $("options").addEventListener("submit", e => {
      e.preventDefault();
      submitted();
    });
  }

  return {read, inFields, listen};
})();
