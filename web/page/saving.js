// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A page to keep, put together from the same parts as the program's (src/page/html.cpp).
"use strict";

const Saving = (() => {
  const escaped = text => text.replace(/[&<>"']/g, c => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})[c]);

  function tables(rows) {
    let html = "", section = null;
    for (const [name, label, value] of rows) {
      if (name !== section) html += (section === null ? "" : "</tbody></table>\n") +
                                    `<h3>${escaped(name)}</h3>\n<table><tbody>\n`;
      section = name;
      html += `<tr><th scope="row">${escaped(label)}</th><td>${escaped(value)}</td></tr>\n`;
    }
    return section === null ? "" : html + "</tbody></table>\n";
  }

  async function base64(blob) {
    const url = await new Promise((resolve, reject) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result);
      reader.onerror = () => reject(reader.error);
      reader.readAsDataURL(blob);
    });
    return url.slice(url.indexOf(",") + 1);
  }

  async function packed(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
    return base64(await new Response(stream).blob());
  }

  /**
   * A page as a file of its own, as `meniscus surface -o FILE.html` makes it.
   * title, name  plain text
   * picture      Blob, PNG
   * Built        what the build has put beside the scripts: template, values that no molecule changes
   */
  async function page({title, name, data, rows, picture}) {
    const values = {
      ...Built.page, title: escaped(title), description: escaped(name), tables: tables(rows),
      style: document.getElementById("viewer-style").textContent, data: await packed(data),
      three: document.getElementById("three").textContent,
      script: document.getElementById("viewer").textContent + Built.begin,
      picture: `<img id="picture" alt="The surface of ${escaped(name)}" src="data:image/png;base64,${await base64(picture)}">`,
    };
    return Built.template.replace(/\{\{(.*?)\}\}/g, (_, key) => values[key]);
  }

  return {page};
})();
