// SPDX-License-Identifier: GPL-3.0-or-later
import { chip, element, figure, meaning, prose, reach, seconds, table } from "./dom.js";
import { paper, pictures, report, spoken, statements } from "./data.js";
import { errataRows } from "./errata_view.js";
import { formula } from "./formula.js";
import { convergence } from "./plot.js";
import { tableParts } from "./table_view.js";

function evidenceTable(caption, lines) {
  return table(caption, ["observed", "value", "allowed", "standing"], lines.map((line) => [
    element("td", {}, prose(line.what.replace(/^control: /, ""))),
    element("td", { class: "number" }, line.radius === null || line.radius === "0" ? line.value : `${line.value} ± ${line.radius}`,
      line.proved ? element("span", { class: "quiet" }, " proved") : null),
    element("td", {}, prose(line.allowed)),
    element("td", { class: line.standing }, line.standing),
  ]));
}

function hypotheses(claim) {
  if (claim.needs.length === 0) return null;
  return element("section", {}, element("h2", {}, "Hypotheses"),
    table("What the statement needs, and how it is met where it was checked", ["needed", "how it is met"],
      claim.needs.map((need, i) => [need, claim.met[i] ?? "not said"].map(prose))));
}

function tried(claim) {
  if (claim.tried.length === 0) return null;
  return element("section", {}, element("h2", {}, claim.scope === "family" ? "Family" : "Tried"),
    element("ul", {}, claim.tried.map((each) => element("li", {}, prose(each)))));
}

function evidence(claim) {
  const of = (role) => claim.evidence.filter((line) => line.role === role);
  const [observed, instead, controls] = [of("requirement"), of("instead"), of("control")];
  return [
    observed.length > 0 ? element("section", {}, element("h2", {}, "Evidence"), evidenceTable("What was observed", observed)) : null,
    instead.length > 0 ? element("section", {}, element("h2", {}, "What holds instead"),
      evidenceTable("The corrected statement: each must hold", instead)) : null,
    controls.length > 0 ? element("section", {}, element("h2", {}, "Control"),
      element("p", {}, "What the statement must reject. A control that it fits would make the check worthless."),
      evidenceTable("Controls: each must be violated", controls)) : null,
    claim.remarks.length > 0 ? element("section", {}, element("h2", {}, "Remarks"),
      element("ul", {}, claim.remarks.map((remark) => element("li", {}, prose(remark))))) : null,
  ];
}

function plots(claim) {
  const problems = claim.problems.map((index) => report.problems[index]);
  const drawn = convergence(problems, claim.problems, "node_error") ?? convergence(problems, claim.problems, "discretisation_error");
  return drawn ? element("section", {}, element("h2", {}, "Convergence"), drawn) : null;
}

function views(claim) {
  const drawn = claim.problems.filter((index) => pictures[index]);
  if (drawn.length === 0) return null;
  return element("section", {}, element("h2", {}, "What was solved"),
    element("ul", {}, drawn.map((index) => element("li", {},
      element("a", { href: `#/view/${index}` }, prose(report.problems[index].name))))));
}

function reproduce(entry) {
  const budget = report.budget === "quick" ? "" : ` --budget ${report.budget}`;
  // A folder of the user's own is run as a whole.
  const { folder } = paper(entry.claim.paper);
  const what = folder ? (/^[\w./-]+$/.test(folder) ? folder : `'${folder.replaceAll("'", "'\\''")}'`) : entry.key;
  const command = `radcert verify ${what}${budget}`;
  const said = element("span", { role: "status", class: "quiet" });
  const button = element("button", {
    type: "button",
    onclick: async () => {
      try {
        await navigator.clipboard.writeText(command);
        said.textContent = " copied";
      } catch {
        said.textContent = " copying is not allowed here";
      }
    },
  }, "Copy");
  return element("section", {}, element("h2", {}, "Reproduce"),
    element("p", { class: "command" }, element("code", {}, command), " ", button, said));
}

function neighbours(entry) {
  const place = statements.indexOf(entry);
  const link = (other, rel, text) => (other
    ? element("a", { href: `#/${other.key}`, rel }, `${text} ${spoken(other.label)}`) : element("span"));
  return element("nav", { class: "neighbours", "aria-label": "Neighbouring statements" },
    link(statements[place - 1], "prev", "←"), link(statements[place + 1], "next", "→"));
}

export function claimView(entry) {
  const { claim } = entry;
  const found = errataRows(paper(claim.paper).errata, claim.erratum);
  return [
    element("h1", {}, spoken(entry.label)),
    element("p", { class: "quiet" }, paper(claim.paper).title, claim.page ? `, about page ${claim.page}` : "",
      claim.covers.length > 0 ? ` · equations ${claim.covers.map((number) => `(${number})`).join(", ")}` : ""),
    element("p", { class: "says" }, prose(claim.says)),
    claim.formula ? formula(claim.formula) : null,
    entry.cells ? null : element("p", { class: "verdict-line" }, chip(claim.verdict), " ", reach(claim) ? element("strong", {}, reach(claim), " ") : "",
      element("span", { class: "quiet" }, meaning[claim.verdict]),
      claim.as_recorded ? "" : element("strong", {}, ` The record says ${claim.recorded}.`),
      claim.ours ? element("span", { class: "ours" }, " Ours: ", element("strong", {}, figure(claim.ours)), claim.ours.guaranteed ? " (proved)" : "") : ""),
    claim.note && !entry.cells ? element("p", { class: "note" }, prose(claim.note)) : null,
    claim.failure && !entry.cells ? element("p", { class: "note bad" }, claim.failure) : null,
    found.length > 0 ? element("section", { class: "erratum" }, element("h2", {}, "Erratum"), found,
      element("p", {}, element("a", { href: `#/${claim.paper}/errata` }, "All errata of this paper"))) : null,
    hypotheses(claim),
    entry.cells ? null : tried(claim),
    entry.cells ? tableParts(entry) : [evidence(claim), plots(claim)],
    claim.unchecked ? element("section", {}, element("h2", {}, "Not checked"), element("p", {}, prose(claim.unchecked))) : null,
    views(claim),
    reproduce(entry),
    element("p", { class: "quiet" }, `Took ${seconds(entry.seconds)}.`),
    neighbours(entry),
  ].flat(2).filter(Boolean);
}
