// SPDX-License-Identifier: GPL-3.0-or-later
import { element, figure, table } from "./dom.js";
import { plots } from "./data.js";
import { about } from "./number_text.js";

const quantities = {
  node_error: "max |u − uₙ| over the nodes",
  discretisation_error: "max |K(u − Pₙu)| over the nodes",
  uniform_error: "max |u − uₙ| over a sample of S",
};

// What an error is drawn against: its words, and the letter of a table.
const axes = { mesh_size: { words: "mesh size h", short: "h" }, unknowns: { words: "unknowns", short: "n" } };

const points = (problem, quantity, key) => problem.levels
  .filter((level) => level[quantity] && level[quantity].value > 0)
  .map((level) => ({ h: level[key], error: level[quantity] }));

/** Errors of problems over mesh sizes, or unknowns: the plot that the program has drawn, and the numbers in a table below.
 * `places` are those of the problems in the list that the page holds. */
export function convergence(problems, places, quantity, key = "mesh_size") {
  const drawn = plots[`${quantity}:${places.join(",")}:${key}`];
  if (!drawn) return null;
  const { words, short } = axes[key];
  const picture = document.importNode(new DOMParser().parseFromString(drawn, "image/svg+xml").documentElement, true);
  const numbers = problems.map((problem) => [problem, points(problem, quantity, key)])
    .filter(([, list]) => list.length >= 2)
    .flatMap(([problem, list]) => list.map((point) => [problem.name, about(point.h, 4), figure(point.error)]));
  return element("figure", {},
    element("div", { class: "plot", tabindex: "0", role: "region", "aria-label": `${quantities[quantity]} against the ${words}; the numbers are in the table below` }, picture),
    element("details", {}, element("summary", {}, "The numbers"), table(quantities[quantity], ["problem", short, "error"], numbers)));
}
