// SPDX-License-Identifier: GPL-3.0-or-later
//
// What runs in the reader's browser: search, filters, light and dark. Nothing is asked of a network; the index is a script,
// since a page from disk may not read other files.

import MiniSearch from "minisearch";
import { indexing } from "./indexing.mjs";

const script = document.currentScript;
const root = script.dataset.root;
const make = (tag, properties, ...children) => {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children);
  return node;
};

let loading;
function index() {
  loading ??= new Promise((resolve, reject) => {
    const source = make("script", { src: `${root}search_index.js` });
    source.onload = () => resolve(MiniSearch.loadJS(window.radcertIndex, indexing));
    source.onerror = reject;
    document.head.append(source);
  });
  return loading;
}

function line(result) {
  const link = make("a", { href: root + result.id }, make("strong", {}, result.title));
  if (result.page !== result.title) link.append(make("span", { className: "quiet" }, ` ${result.page}`));
  if (result.start) link.append(make("span", { className: "start" }, result.start));
  return make("li", {}, link);
}

async function show(words, place, most) {
  const found = words.trim() ? (await index()).search(words) : [];
  if (words.trim() && !found.length) place.replaceChildren(make("p", {}, `Nothing has the words “${words}”.`));
  else place.replaceChildren(make("ul", {}, ...found.slice(0, most).map(line)));
  place.hidden = !words.trim();
  return found.length;
}

function theme(wanted) {
  if (wanted) document.documentElement.dataset.theme = wanted;
  try {
    if (wanted) localStorage.setItem("radcert-theme", wanted);
    return localStorage.getItem("radcert-theme");
  } catch {
    return wanted;
  }
}

function start() {
  const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  document.querySelector("button.theme").addEventListener("click", () => {
    const now = document.documentElement.dataset.theme ?? (dark ? "dark" : "light");
    theme(now === "dark" ? "light" : "dark");
  });

  const all = document.querySelector("details.all");
  const wide = window.matchMedia("(min-width: 62rem)");
  const open = () => { all.open = wide.matches; };
  wide.addEventListener("change", open);
  open();

  const input = document.querySelector("header input");
  const place = document.querySelector(".found");
  input.addEventListener("input", () => show(input.value, place, 8));
  input.addEventListener("keydown", (event) => { if (event.key === "Escape") place.hidden = true; });
  document.addEventListener("click", (event) => { if (!event.target.closest("header form")) place.hidden = true; });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.target.matches("input, textarea")) return;
    event.preventDefault();
    input.focus();
  });

  const results = document.getElementById("results");
  if (results) {
    const words = new URLSearchParams(location.search).get("q") ?? "";
    input.value = words;
    show(words, results, 60).then((count) => {
      if (words) document.getElementById("count").textContent = `${count} places have “${words}”`;
    });
  }

  for (const filter of document.querySelectorAll("input.filter")) {
    const entries = [...document.querySelectorAll("main article")];
    const count = filter.nextElementSibling;
    const apply = () => {
      const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const entry of entries) {
        const text = entry.textContent.toLowerCase();
        entry.hidden = !words.every((word) => text.includes(word));
        shown += entry.hidden ? 0 : 1;
      }
      count.textContent = `${shown} of ${entries.length}`;
    };
    filter.addEventListener("input", apply);
    apply();
  }
}

const chosen = theme();
if (chosen) document.documentElement.dataset.theme = chosen;
if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
