// SPDX-License-Identifier: GPL-3.0-or-later
import path from "node:path";
import { escaped } from "./highlight.mjs";

/** The way from one page to another: both are names relative to the site's folder, the second perhaps with an anchor. */
export function wayTo(from, to) {
  const [file, hash] = to.split("#");
  const way = file === from && hash !== undefined ? "" : path.posix.relative(path.posix.dirname(from), file);
  return way + (hash === undefined ? "" : `#${hash}`);
}

const words = (html) => html.replace(/<math[^]*?<\/math>/g, "").replace(/<[^>]*>/g, " ")
  .replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, "\"").replace(/&amp;/g, "&").replace(/\s+/g, " ").trim();

/** The sections of a page, each from a heading to the next: [{anchor, title, level, text}]. */
export function sections(html) {
  const marks = [...html.matchAll(/<h([1-4]) id="([^"]+)"[^>]*>([^]*?)<\/h\1>/g)];
  return marks.map((mark, i) => ({
    level: Number(mark[1]),
    anchor: mark[2],
    title: words(mark[3].replace(/<a class="here"[^]*?<\/a>/, "")),
    text: words(html.slice(mark.index + mark[0].length, marks[i + 1]?.index ?? html.length)),
  }));
}

function navigation(page, groups) {
  return groups.map((group) => {
    const isHere = group.pages.some((each) => each.name === page.name);
    const links = group.pages.filter((each) => !each.isHidden).map((each) =>
      `<li><a href="${escaped(wayTo(page.name, each.name))}"${each.name === page.name ? " aria-current=\"page\"" : ""}>${escaped(each.short ?? each.title)}</a></li>`);
    return `<details${isHere ? " open" : ""}><summary>${escaped(group.title)}</summary><ul>${links.join("")}</ul></details>`;
  }).join("\n");
}

function contents(html) {
  const found = sections(html).filter((section) => section.level === 2);
  if (found.length < 4) return "";
  const links = found.map((section) => `<li><a href="#${escaped(section.anchor)}">${escaped(section.title)}</a></li>`);
  return `<details class="contents"${found.length < 20 ? " open" : ""}><summary>On this page</summary><ul>${links.join("")}</ul></details>`;
}

function neighbours(page, groups) {
  const group = groups.find((each) => each.pages.includes(page));
  if (!group) return "";
  const shown = group.pages.filter((each) => !each.isHidden);
  const at = shown.indexOf(page);
  const link = (to, before, after) => (to ? `<a href="${escaped(wayTo(page.name, to.name))}">${before}${escaped(to.short ?? to.title)}${after}</a>` : "<span></span>");
  return at < 0 ? "" : `<nav class="neighbours" aria-label="Neighbouring pages">${link(shown[at - 1], "← ", "")}${link(shown[at + 1], "", " →")}</nav>`;
}

/** A whole page. */
export function pageText(page, groups, version) {
  const root = wayTo(page.name, "index.html").replace(/index\.html$/, "");
  const group = groups.find((each) => each.pages.includes(page));
  const first = page.html.match(/^[^]*?<\/h1>\n?/)?.[0] ?? "";
  const rest = page.html.slice(first.length);
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(page.title)}${page.name === "index.html" ? "" : " · radcert"}</title>
<link rel="stylesheet" href="${root}style.css">
<script src="${root}site.js" data-root="${root}" defer></script>
</head>
<body>
<a class="skip" href="#main">To the text</a>
<header>
<a class="home" href="${root}index.html">radcert <span>${escaped(version)}</span></a>
<form role="search" action="${root}search.html"><input type="search" name="q" placeholder="Search, as in: view factor" aria-label="Search" autocomplete="off"><div class="found" hidden></div></form>
<button type="button" class="theme" aria-label="Light or dark">◐</button>
</header>
<div class="columns">
<nav class="side" aria-label="All pages"><details class="all"><summary>All pages</summary>${navigation(page, groups)}</details></nav>
<main id="main">
${group ? `<p class="group">${escaped(group.title)}</p>` : ""}
${first}${page.isPlain ? "" : contents(rest)}
${rest}
${neighbours(page, groups)}
</main>
</div>
<footer>radcert ${escaped(version)}, GPL-3.0-or-later. <a href="${root}licences.html">Licences</a> of what these pages are made with.</footer>
</body>
</html>
`;
}
