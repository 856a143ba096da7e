// SPDX-License-Identifier: GPL-3.0-or-later

const data = JSON.parse(document.getElementById("data").textContent);

/** Of an experiment the page holds the result alone; of a verification the report, its papers and pictures. */
export const experiment = data.experiment ?? null;
export const report = data.report ?? { claims: [], problems: [], timing: { claims: [] } };
export const papers = data.papers ?? [];
export const pictures = data.pictures ?? [];
/** SVG by the error, the problems and the axis: "node_error:0,2:mesh_size". */
export const plots = data.plots ?? {};
export const licences = JSON.parse(document.getElementById("licences").textContent);

const timing = new Map(report.timing.claims.map((each) => [`${each.paper}/${each.label}`, each.seconds]));

/** The paper's entry with title, bibliography and errata; a user's own folder has its key alone. */
export const paper = (key) => papers.find((each) => each.key === key) ?? { key, title: key, folder: "", errata: "" };

/** "table_1.alpha_1_6.n4.node_error" is a cell of table_1; any other label is a statement. */
const tableOf = (claim) => (claim.printed === null ? null : claim.label.split(".")[0]);

/** One entry a statement, in the papers' order; a table gathers its cells. */
export const statements = (() => {
  const list = [];
  const tables = new Map();
  for (const claim of report.claims) {
    const time = timing.get(`${claim.paper}/${claim.label}`) ?? 0;
    const table = tableOf(claim);
    const key = `${claim.paper}/${table ?? claim.label}`;
    if (table && tables.has(key)) {
      const entry = tables.get(key);
      entry.cells.push(claim);
      entry.seconds += time;
      continue;
    }
    const entry = {
      key, paper: claim.paper, label: table ?? claim.label, claim, cells: table ? [claim] : null, seconds: time,
    };
    if (table) tables.set(key, entry);
    list.push(entry);
  }
  return list;
})();

export const statement = (key) => statements.find((entry) => entry.key === key);

/** How often each verdict was found, cells of tables counted one by one. */
export function counts(claims) {
  const found = new Map();
  for (const claim of claims) found.set(claim.verdict, (found.get(claim.verdict) ?? 0) + 1);
  return found;
}

export const claimsOf = (entry) => entry.cells ?? [entry.claim];

/** The name by which a reader knows a statement: "Theorem 3.7", "(26)". */
export function spoken(label) {
  const kinds = { lemma: "Lemma", theorem: "Theorem", corollary: "Corollary", table: "Table", section: "Section",
    figure: "Figure", remark: "Remark", abstract: "Abstract" };
  const words = label.split("_");
  const kind = words.shift();
  const numbers = [];
  while (words.length > 0 && /^[0-9]+$/.test(words[0])) numbers.push(words.shift());
  const part = words.length > 0 && /^[a-z]$/.test(words[0]) ? ` (${words.shift()})` : "";
  const rest = words.length > 0 ? `, ${words.join(" ")}` : "";
  if (kind === "equation" && numbers.length > 0) return `Equation (${numbers.join(".")})${part}${rest}`;
  if (kinds[kind]) return `${kinds[kind]}${numbers.length > 0 ? ` ${numbers.join(".")}` : ""}${part}${rest}`;
  return label.replaceAll("_", " ");
}
