// SPDX-License-Identifier: GPL-3.0-or-later
import { enclosing, toDecimals } from "./number_text.js";
import { mathematics } from "./mathematics.js";

/** An element with attributes and children; text children are text, never markup. */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

/** A table: a caption, header texts, rows of cells (nodes or texts). */
export function table(caption, headers, rows, attributes = {}) {
  return element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": caption },
    element("table", { ...attributes, class: "cards" },
      element("caption", {}, prose(caption)),
      element("thead", {}, element("tr", {}, headers.map((text) => element("th", { scope: "col" }, prose(text))))),
      element("tbody", {}, rows.map((cells) => element("tr", {}, cells.map((cell, column) => {
        const made = cell instanceof HTMLTableCellElement ? cell : element("td", {}, cell);
        // On a narrow screen a row is a card, and each of its cells says what it is.
        if (headers[column]) made.setAttribute("data-label", headers[column]);
        return made;
      }))))));
}

export const verdicts = [
  "certified", "reproduced", "supported", "contradicted", "undecided", "definition", "unchecked", "failed",
];

export const meaning = {
  certified: "exact or ball arithmetic proves it for the stated inputs",
  reproduced: "our value, with its radius, rounds to the printed digits",
  supported: "floating-point evidence, with a control that fails",
  contradicted: "proved or measured otherwise",
  undecided: "the evidence does not settle it",
  definition: "nothing to verify",
  unchecked: "not yet looked at",
  failed: "the check threw, or its control was not rejected",
};

// A sign beside the word, so that colour is never all there is.
const signs = {
  certified: "■", reproduced: "◆", supported: "●", contradicted: "✕", undecided: "?", definition: "≔",
  unchecked: "○", failed: "!",
};

export function chip(verdict) {
  return element("span", { class: `chip ${verdict}`, title: meaning[verdict] },
    element("span", { "aria-hidden": "true" }, signs[verdict]), ` ${verdict}`);
}

/** How far a verdict reaches: "for all", "for a family", "at 5 instances". */
export function reach(claim) {
  if (claim.scope === null || claim.printed !== null) return "";
  if (claim.scope === "all") return "for all";
  if (claim.scope === "family") return "for a family";
  return `at ${claim.tried.length} instance${claim.tried.length === 1 ? "" : "s"}`;
}

/** Text in which `code` stands between backquotes, its mathematics set. */
export function prose(text) {
  return text.split(/(`[^`]+`)/).flatMap((part) =>
    part.startsWith("`") && part.endsWith("`") && part.length > 2
      ? [element("code", {}, part.slice(1, -1))]
      : mathematics(part).map(([tag, content]) => (tag === "" ? content : element(tag, {}, content))));
}

/** A number with its radius, rounded outwards. */
export const figure = (ours) => (ours ? enclosing(ours.value, ours.radius) : "");

export const seconds = (time) => (time < 0.05 ? "< 0.1 s" : `${toDecimals(time, 1)} s`);
