// SPDX-License-Identifier: GPL-3.0-or-later
import { chip, element, figure, prose, table } from "./dom.js";
import { convergence } from "./plot.js";
import { report } from "./data.js";
import { toDecimals, toPower } from "./number_text.js";

const names = {
  discretisation_error: "E_n", discretisation_ratio: "ratio of E_n", node_error: "max |u - u_n|",
  node_ratio: "ratio of max |u - u_n|",
};

/** "table_1.alpha_1_6.n4.node_error" into its parts; a table of one series has no second part. */
function parts(cell) {
  const words = cell.label.split(".");
  return { series: words.slice(1, -2).join("."), row: words.at(-2), figure: words.at(-1) };
}

/** Our value to the digits of the print: "7.18E-7" has two decimals. */
export function roundedLike(printed, value) {
  const [mantissa, exponent] = printed.toUpperCase().split("E");
  const decimals = (mantissa.split(".")[1] ?? "").length;
  if (exponent === undefined) return toDecimals(value, decimals);
  const [digits, power] = toPower(value, decimals + 1).split("e");
  return `${digits}E${Number(power)}`;
}

/** The printed text, the digits in which ours differs marked: from the first of the mantissa, and the exponent if it is another. */
function marked(printed, ours) {
  if (!ours) return [printed];
  const rounded = roundedLike(printed, ours.value);
  const [mantissa, exponent] = printed.split(/E/i);
  const [ourMantissa, ourExponent] = rounded.split("E");
  const mark = (text) => (text === "" ? "" : element("mark", { title: `ours rounds to ${rounded}` }, text));
  const from = [...mantissa].findIndex((digit, place) => digit !== ourMantissa[place]);
  const kept = from < 0 ? mantissa.length : from;
  const power = exponent === undefined ? "" : `E${exponent}`;
  const samePower = exponent === undefined || Number(exponent) === Number(ourExponent);
  return [mantissa.slice(0, kept), mark(mantissa.slice(kept)), samePower ? power : mark(power)];
}

/** "alpha_1_6" is alpha = 1/6, "alpha_0_1" is alpha = 0.1. */
const seriesName = (name) => name.replace(/_0_(\d+)$/, " = 0.$1").replace(/_(\d+)_(\d+)$/, " = $1/$2").replaceAll("_", " ");

function series(name, cells) {
  const rows = [...new Set(cells.map((cell) => parts(cell).row))];
  const figures = [...new Set(cells.map((cell) => parts(cell).figure))];
  const find = (row, wanted) => cells.find((cell) => parts(cell).row === row && parts(cell).figure === wanted);
  const headers = (shown) => ["n", ...shown.flatMap((each) => [`${names[each] ?? each}, printed`, "ours", "verdict"])];
  const body = (shown) => rows.map((row) => [
    element("th", { scope: "row" }, row.replace(/^n/, "")),
    ...shown.flatMap((wanted) => {
      const cell = find(row, wanted);
      if (!cell) return ["", "", ""];
      return [element("td", { class: "number" }, marked(cell.printed, cell.ours)),
        element("td", { class: "number" }, figure(cell.ours)),
        element("td", {}, chip(cell.verdict))];
    }),
  ]);
  const title = name === "" ? "All rows" : seriesName(name);
  // An error and its ratio side by side, and one such pair below the other: more would not fit a page.
  const pairs = [figures.filter((each) => each.startsWith("discretisation")), figures.filter((each) => !each.startsWith("discretisation"))];
  return element("section", {}, element("h2", {}, title), pairs.filter((shown) => shown.length > 0)
    .map((shown) => table(`Printed and ours: ${names[shown[0]] ?? shown[0]}`, headers(shown), body(shown))));
}

export function tableParts(entry) {
  const groups = [...new Set(entry.cells.map((cell) => parts(cell).series))];
  const told = entry.cells.filter((cell) => cell.note || !cell.as_recorded || cell.failure);
  const problems = entry.claim.problems.map((index) => report.problems[index]);
  const drawn = ["discretisation_error", "node_error"].map((quantity) => convergence(problems, entry.claim.problems, quantity)).filter(Boolean);
  return [
    ...groups.map((name) => series(name, entry.cells.filter((cell) => parts(cell).series === name))),
    drawn.length > 0 ? element("section", {}, element("h2", {}, "Convergence"), drawn) : null,
    told.length > 0 ? element("section", {}, element("h2", {}, "Cells that differ"),
      element("dl", {}, told.flatMap((cell) => [
        element("dt", {}, element("code", {}, cell.label), " ", chip(cell.verdict)),
        element("dd", {}, cell.failure ?? prose(cell.note)),
      ]))) : null,
  ];
}
