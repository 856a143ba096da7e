// SPDX-License-Identifier: GPL-3.0-or-later
import { chip, element, figure, meaning, prose, reach, seconds, verdicts } from "./dom.js";
import { claimsOf, counts, paper, report, spoken, statements } from "./data.js";

// What is shown survives going to a statement and back.
const chosen = { text: "", verdicts: new Set(), paper: "" };

const matches = (entry) =>
  (chosen.paper === "" || entry.paper === chosen.paper) &&
  (chosen.verdicts.size === 0 || claimsOf(entry).some((claim) => chosen.verdicts.has(claim.verdict))) &&
  chosen.text.toLowerCase().split(/\s+/).every((word) =>
    `${entry.key} ${spoken(entry.label)} ${entry.claim.says} ${entry.claim.note}`.toLowerCase().includes(word));

function verdictCell(entry) {
  if (!entry.cells)
    return element("span", {}, chip(entry.claim.verdict), " ", element("span", { class: "quiet" }, reach(entry.claim)));
  const found = counts(entry.cells);
  return element("span", { class: "chips" }, verdicts.filter((verdict) => found.has(verdict)).map((verdict) =>
    element("span", {}, `${found.get(verdict)} × `, chip(verdict))));
}

function evidenceCell(entry) {
  const claims = claimsOf(entry);
  const evidence = claims.flatMap((claim) => claim.evidence);
  const controls = evidence.filter((line) => line.control).length;
  if (entry.cells) return `${entry.cells.length} cells`;
  if (evidence.length === 0) return "";
  const proved = evidence.filter((line) => line.proved && !line.control).length;
  return `${evidence.length - controls} observed${proved ? `, ${proved} proved` : ""}; ${controls} control${controls === 1 ? "" : "s"}`;
}

function row(entry) {
  const differs = claimsOf(entry).some((claim) => !claim.as_recorded);
  return element("tr", { class: differs ? "differs" : undefined },
    element("th", { scope: "row" }, element("a", { href: `#/${entry.key}` }, spoken(entry.label))),
    element("td", { class: "says" }, prose(entry.claim.says)),
    element("td", { "data-label": "Verdict" }, verdictCell(entry), differs ? element("strong", {}, " not as recorded") : null),
    element("td", { "data-label": "Evidence" }, evidenceCell(entry)),
    element("td", { class: "number", "data-label": "Ours" }, entry.cells ? "" : figure(entry.claim.ours)),
    element("td", { class: "number", "data-label": "Time" }, seconds(entry.seconds)));
}

function section(key) {
  const rows = statements.filter((entry) => entry.paper === key && matches(entry));
  if (rows.length === 0) return null;
  const about = paper(key);
  return element("section", { "aria-labelledby": `paper-${key}` },
    element("h2", { id: `paper-${key}` }, about.title),
    element("p", { class: "quiet" }, about.reference ?? "",
      about.errata ? element("span", {}, about.reference ? " · " : "", element("a", { href: `#/${key}/errata` }, "What we found to be misprinted or wrong")) : null),
    element("table", { class: "statements" },
      element("caption", {}, `Statements of ${key}, in the paper's order`),
      element("thead", {}, element("tr", {}, ["Statement", "What it says", "Verdict", "Evidence", "Our figure", "Time"]
        .map((text) => element("th", { scope: "col" }, text)))),
      element("tbody", {}, rows.map(row))));
}

export function indexView() {
  const list = element("div");
  const shown = element("p", { role: "status", class: "quiet" });
  const keys = [...new Set(statements.map((entry) => entry.paper))];
  const show = () => {
    list.replaceChildren(...keys.map(section).filter(Boolean));
    const left = statements.filter(matches).length;
    shown.textContent = left === statements.length ? `${left} statements` : `${left} of ${statements.length} statements`;
  };
  const all = counts(report.claims);
  const buttons = verdicts.filter((verdict) => all.has(verdict)).map((verdict) => {
    const button = element("button", {
      type: "button", class: "filter", "data-verdict": verdict, "aria-pressed": String(chosen.verdicts.has(verdict)), title: meaning[verdict],
      onclick: () => {
        if (!chosen.verdicts.delete(verdict)) chosen.verdicts.add(verdict);
        button.setAttribute("aria-pressed", String(chosen.verdicts.has(verdict)));
        show();
      },
    }, chip(verdict), element("span", { class: "count" }, String(all.get(verdict))));
    return button;
  });
  const search = element("input", {
    type: "search", id: "search", value: chosen.text, placeholder: "theorem 3.7, edge, norm …",
    oninput: () => { chosen.text = search.value; show(); },
  });
  const select = element("select", { id: "paper", onchange: () => { chosen.paper = select.value; show(); } },
    element("option", { value: "" }, "all papers"),
    keys.map((key) => element("option", { value: key, selected: chosen.paper === key }, paper(key).title)));
  show();
  return [
    element("h1", {}, "What the papers say, and what a run found"),
    element("p", { class: report.as_recorded ? "verdict-line good" : "verdict-line bad" },
      `${report.claims.length} statements and cells of tables, budget ${report.budget}. `,
      report.as_recorded ? "Every verdict is as recorded."
        : `${report.claims.filter((claim) => !claim.as_recorded).length} differ from the record.`),
    element("div", { class: "filters" },
      element("div", { role: "group", "aria-label": "Show only these verdicts", class: "buttons" }, buttons),
      element("label", { for: "search" }, "Find ", search),
      keys.length > 1 ? element("label", { for: "paper" }, "In ", select) : null),
    shown, list,
    element("p", { class: "quiet" }, "Made by ", element("code", {}, report.command), `, radcert ${report.radcert}. `,
      `The checks took ${Math.round(report.timing.total_seconds)} s; the page shows what was stored and computes nothing.`),
  ];
}
