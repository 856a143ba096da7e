// SPDX-License-Identifier: GPL-3.0-or-later
import { element, figure, table } from "./dom.js";
import { experiment } from "./data.js";
import { about, toPower } from "./number_text.js";
import { convergence } from "./plot.js";

const quantities = { node_error: "error at the nodes", discretisation_error: "E_n = max |K(u - P_n u)|", uniform_error: "error over a sample of S" };

const named = (index) => experiment.combinations[index].name;

/** Who comes first at one cost: the largest that all of a group pay at some level. */
function ranking(group, quantity, cost, unit) {
  const { ranking: places, [cost]: paid } = group[quantity];
  const rated = places.filter((place) => place.error !== null);
  if (rated.length < 2) return null;
  const best = rated[0].error;
  return table(`${quantities[quantity]} at ${paid === null ? "one cost" : `${about(paid, 4)} ${unit}`}, smallest first`,
    ["", "combination", "error", "times the smallest"],
    rated.map((place, i) => [String(i + 1), named(place.combination),
      element("td", { class: "number" }, toPower(place.error, 4)),
      element("td", { class: "number" }, best > 0 ? about(place.error / best, 3) : "")]));
}

function group(byUnknowns, bySeconds, number, many) {
  const combinations = byUnknowns.combinations.map((index) => experiment.combinations[index]);
  const shown = Object.keys(quantities).filter((quantity) => byUnknowns[quantity].ranking.some((place) => place.error !== null));
  return element("section", {},
    many ? element("h2", {}, `Group ${number + 1}: one surface, reflectivity and solution`) : null,
    shown.map((quantity) => element("section", {},
      element("h2", {}, quantities[quantity]),
      convergence(combinations, byUnknowns.combinations, quantity), convergence(combinations, byUnknowns.combinations, quantity, "unknowns"),
      ranking(byUnknowns, quantity, "unknowns", "unknowns"), ranking(bySeconds, quantity, "seconds", "seconds of assembly and solution"))));
}

function levels(combination) {
  return element("details", {}, element("summary", {}, combination.name),
    table(`Levels of ${combination.name}`, ["level", "elements", "unknowns", "h", "E_n", "error at the nodes", "error over S"],
      combination.levels.map((level) => [String(level.level), String(level.elements), String(level.unknowns), about(level.mesh_size, 4),
        figure(level.discretisation_error), figure(level.node_error), figure(level.uniform_error)])),
    element("pre", {}, JSON.stringify(combination.problem, null, 1)));
}

export function experimentView() {
  const groups = experiment.at_equal_unknowns;
  return [
    element("h1", {}, experiment.name.replaceAll("_", " ")),
    element("p", { class: "quiet" }, `${experiment.combinations.length} problems that differ in ${experiment.varied.join(", ")}.`),
    ...groups.map((each, i) => group(each, experiment.timing.at_equal_seconds[i], i, groups.length > 1)),
    element("section", {}, element("h2", {}, "Level by level"), experiment.combinations.map(levels)),
    element("p", { class: "quiet" }, "Made by ", element("code", {}, experiment.command), `, radcert ${experiment.radcert}. `,
      "The page shows what was stored and computes nothing but these quotients."),
  ];
}
