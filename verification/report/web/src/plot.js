// SPDX-License-Identifier: GPL-3.0-or-later
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { element, figure, table } from "./dom.js";
import { about, enclosingOrder, toDecimals, toPower } from "./number_text.js";

const quantities = {
  node_error: "max |u − uₙ| over the nodes",
  discretisation_error: "max |K(u − Pₙu)| over the nodes",
  uniform_error: "max |u − uₙ| over a sample of S",
};

// Okabe and Ito's colours: told apart by most eyes, and on light and dark ground.
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

// What an error is drawn against: its words, the key of a level, and the sign of the order's exponent.
const axes = {
  mesh_size: { words: "mesh size h", short: "h", power: 1, orders: "orders" },
  unknowns: { words: "unknowns", short: "n", power: -1, orders: "orders_in_unknowns" },
};

const points = (problem, quantity, key) => problem.levels
  .filter((level) => level[quantity] && level[quantity].value > 0)
  .map((level) => ({ h: level[key], error: level[quantity] }));

export const hasConvergence = (problem) =>
  Object.keys(quantities).some((quantity) => points(problem, quantity, "mesh_size").length >= 2);

/** The fitted order that the report stores of an error. */
function fittedOrder(problem, quantity, key) {
  const stored = problem[axes[key].orders] ?? [];
  const list = Array.isArray(stored) ? stored : Object.entries(stored).map(([name, fit]) => ({ quantity: name, ...fit }));
  return list.find((fit) => fit.quantity === quantity && fit.order !== null) ?? null;
}

function slope(order, problems, quantity, key) {
  const { power } = axes[key];
  const list = problems.flatMap((problem) => points(problem, quantity, key));
  const coarsest = list.reduce((a, b) => (power * b.h > power * a.h ? b : a));
  return (h) => 2 * coarsest.error.value * (h / coarsest.h) ** (power * order);
}

// Powers of ten; where these are few also 2 and 5 times, or 2, 3, 4, 5, 6 and 8 times.
function ticks(least, most) {
  const decades = Math.log10(most / least);
  const factors = decades > 3 ? [1] : decades > 1 ? [1, 2, 5] : [1, 2, 3, 4, 5, 6, 8];
  const places = [];
  for (let power = Math.floor(Math.log10(least)); power <= Math.log10(most); ++power)
    for (const factor of factors) {
      const place = factor * 10 ** power;
      if (least <= place && place <= most) places.push(place);
    }
  return places;
}

// uPlot would round a logarithmic axis out to whole powers of ten, and leave much of the plot empty.
const between = (margin) => (_, least, most) => [least / margin, most * margin];

/** Errors over mesh sizes, or unknowns, on logarithmic axes, with lines of whole orders; the numbers in a table below. A problem has a name,
 * levels and, if it is known, orders. */
export function convergence(problems, quantity, key = "mesh_size") {
  const { words, short, power } = axes[key];
  const drawn = problems.filter((problem) => points(problem, quantity, key).length >= 2);
  if (drawn.length === 0) return null;
  const sizes = [...new Set(drawn.flatMap((problem) => points(problem, quantity, key).map((point) => point.h)))].sort((a, b) => a - b);
  const orders = drawn.map((problem) => fittedOrder(problem, quantity, key));
  const known = orders.filter((fit) => fit !== null).map((fit) => fit.order);
  const references = [...new Set(known.map((order) => (power > 0 ? Math.round(order) : Math.round(2 * order) / 2)))].filter((order) => order > 0).slice(0, 3);
  // Two levels have one slope, and no spread.
  const order = (fit) => (fit.levels?.length < 3 ? `${toDecimals(fit.order, 2)} from two levels`
    : fit.halfwidth === null ? toDecimals(fit.order, 2) : enclosingOrder(fit.order, fit.halfwidth));
  const label = (problem, fit) => (fit === null ? problem.name : `${problem.name}: order ${order(fit)}`);
  const columns = [sizes,
    ...drawn.map((problem) => {
      const at = new Map(points(problem, quantity, key).map((point) => [point.h, point.error.value]));
      return sizes.map((h) => at.get(h) ?? null);
    }),
    ...references.map((order) => sizes.map(slope(order, drawn, quantity, key)))];
  const lines = [{ label: short, value: (_, h) => (h === null || h === undefined ? "" : about(h, 4)) },
    ...drawn.map((problem, i) => ({
      label: label(problem, orders[i]), stroke: colours[i % colours.length], width: 2, spanGaps: true,
      points: { show: true, size: 7 }, value: (_, error) => (error === null || error === undefined ? "" : toPower(error, 4)),
    })),
    ...references.map((order) => ({
      label: `${short}^${power * order}`, stroke: "#888888", width: 1, dash: [6, 4], points: { show: false }, value: () => "",
    }))];
  const holder = element("div", { class: "plot", role: "img", "aria-label": `${quantities[quantity]} against the ${words}; the numbers are in the table below` });
  const ink = () => getComputedStyle(document.documentElement).getPropertyValue("--ink");
  const faint = () => getComputedStyle(document.documentElement).getPropertyValue("--line");
  const axis = (text) => ({ label: text, stroke: ink, grid: { stroke: faint, width: 1 }, ticks: { stroke: faint, width: 1 } });
  const draw = () => {
    const plot = new uPlot({
      width: Math.max(280, holder.clientWidth), height: 380,
      scales: { x: { time: false, distr: 3, range: between(1.2) }, y: { distr: 3, range: between(2) } },
      axes: [{ ...axis(words), splits: (_, __, least, most) => ticks(least, most), filter: (_, places) => places, values: (_, places) => places.map((place) => about(place, 2)) },
        { ...axis(quantities[quantity]), size: 76, values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : toPower(tick, 1))) }],
      series: lines, legend: { live: true },
    }, columns, holder);
    new ResizeObserver(() => plot.setSize({ width: Math.max(280, holder.clientWidth), height: 380 })).observe(holder);
    addEventListener("radcert-theme", () => plot.redraw());
  };
  // A canvas needs to know its width, and has none before it is in the page.
  requestAnimationFrame(draw);
  const numbers = drawn.flatMap((problem) => points(problem, quantity, key).map((point) =>
    [problem.name, about(point.h, 4), figure(point.error)]));
  return element("figure", {}, holder,
    element("figcaption", {}, quantities[quantity]),
    element("details", {}, element("summary", {}, "The numbers"), table(quantities[quantity], ["problem", short, "error"], numbers)));
}
