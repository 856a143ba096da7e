// SPDX-License-Identifier: GPL-3.0-or-later
import { marked } from "marked";
import { element } from "./dom.js";
import { paper } from "./data.js";

// Errata may be a user's own text: it is parsed as Markdown without HTML, links and images, in a document that loads nothing.
const withoutHtml = (text) => text.replace(/<!--[\s\S]*?-->/g, "").replace(/<(?=[a-z/!])/gi, "&lt;");

function rendered(markdown) {
  const inert = document.createElement("template");
  inert.innerHTML = marked.parse(withoutHtml(markdown), { gfm: true });
  for (const image of inert.content.querySelectorAll("img")) image.replaceWith(image.alt);
  const holder = element("div", { class: "markdown" });
  holder.append(inert.content);
  for (const each of holder.querySelectorAll("table")) {
    const wrap = element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "errata" });
    each.replaceWith(wrap);
    wrap.append(each);
  }
  for (const link of holder.querySelectorAll("a[href]")) link.replaceWith(...link.childNodes);
  return holder;
}

/** The lines of errata whose first column is `place`, below the heads of their tables. */
export function errataRows(markdown, place) {
  if (!place || !markdown) return [];
  const lines = markdown.split("\n");
  const headOf = (at) => {
    let head = at;
    while (head > 0 && lines[head - 1].startsWith("|")) --head;
    return head;
  };
  const found = new Map();
  lines.forEach((line, at) => {
    if (!line.startsWith("|") || line.slice(1).split("|")[0].trim() !== place) return;
    const head = [lines[headOf(at)], lines[headOf(at) + 1]].join("\n");
    found.set(head, [...(found.get(head) ?? []), line]);
  });
  return [...found].map(([head, rows]) => rendered([head, ...rows].join("\n")));
}

export function errataView(key) {
  const about = paper(key);
  const page = rendered(about.errata.replace(/^# .*$/m, ""));
  return [element("h1", {}, `Errata of ${about.title}`), page];
}
