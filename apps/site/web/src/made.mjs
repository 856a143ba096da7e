// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pages that are made of what the program, its headers and its data say.
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";
import { coloured, escaped } from "./highlight.mjs";
import { publicNames } from "./headers.mjs";
import { anchor, formula } from "./markdown.mjs";

const heading = (level, id, html) =>
  `<h${level} id="${escaped(id)}">${html}<a class="here" href="#${escaped(id)}" aria-label="Link to this section">#</a></h${level}>\n`;
export const code = (text, language) => `<pre class="example ${language}" tabindex="0"><code>${coloured(text, language)}</code></pre>\n`;
const inline = (text) => escaped(text).replace(/``?([^`]+)``?/g, "<code>$1</code>");
const filter = (words) => `<div class="filters"><input type="search" class="filter" placeholder="${escaped(words)}" aria-label="${escaped(words)}"><span></span></div>\n`;
const labels = (pairs) => {
  const rows = pairs.filter(([, html]) => html).map(([label, html]) => `<dt>${escaped(label)}</dt><dd>${html}</dd>`);
  return rows.length ? `<dl class="labels">${rows.join("")}</dl>\n` : "";
};

/** A command with what it prints. */
export async function tried({ command, run = true }, commands) {
  const printed = run ? await commands.printed(command) : "";
  return code(`${command}${printed ? `\n\n${printed.trimEnd()}` : ""}`, "shell");
}

/** A notebook with what it gave. */
export async function notebook(cells, { markdown, keepPicture }) {
  let html = "";
  for (const cell of cells) {
    if (cell.kind === "text") {
      html += markdown(cell.text);
      continue;
    }
    html += code(cell.code, "python");
    if (cell.printed) html += `<pre class="printed" tabindex="0">${escaped(cell.printed.trimEnd())}</pre>\n`;
    if (cell.shown) html += `<div class="shown"><img src="${escaped(await keepPicture(cell.shown))}" alt="What the last line of this cell shows"></div>\n`;
  }
  return html;
}

/** The gallery. */
export async function gallery(pictures, commands, { markdown, keep }) {
  let html = "<h1 id=\"gallery\">Gallery</h1>\n<p>Each picture was made by the command below it when these pages were built.</p>\n";
  for (const picture of pictures) {
    const source = await keep(picture.name.replace(/\//g, "_"), await commands.picture(picture.command, picture.name));
    html += `<figure>${heading(2, anchor(picture.title), escaped(picture.title))}<img src="${escaped(source)}" alt="${escaped(picture.title)}">` +
      `<figcaption>${markdown(picture.says)}</figcaption>${code(picture.command, "shell")}</figure>\n`;
  }
  return html;
}

const proved = (value) => (value.guaranteed ? "proved" : "estimated");
const parametersOf = (values) => Object.entries(values ?? {}).map(([name, value]) => `${name} = ${value}`).join(", ");

function referenceValue(entry) {
  const value = entry.value;
  const command = `radcert reference ${entry.name}${entry.kind === "mean" ? "" : " --digits 50"}`;
  const rows = value ? [
    ["radius", `<span class="digits">${escaped(value.radius)}</span> (${proved(value)})`],
    ["formula", `<code>${escaped(value.formula)}</code>`],
    ["parameters", escaped(parametersOf(value.parameters))],
    ["source", escaped(value.source)],
    ...value.route_values.map((route, i) => [i ? "checked by" : "route", `${escaped(route.route)}, radius <span class="digits">${escaped(route.radius)}</span>`]),
  ] : [];
  return `<article>${heading(3, entry.name, `<code>${escaped(entry.name)}</code>`)}<p>${escaped(entry.summary)}</p>` +
    (value ? `<p class="digits big">${escaped(value.midpoint)}</p>` : "<p class=\"quiet\">Its digits take seconds, and are left out of this build.</p>") +
    labels([...rows, ["family", entry.kind === "value" ? `<a href="#${escaped(entry.family)}"><code>${escaped(entry.family)}</code></a>` : ""]]) + code(command, "shell") + "</article>\n";
}

/** The catalogue of reference values. */
export function references(entries) {
  const kinds = [
    ["value", "Named values", "Numbers that others may hold theirs against, each enclosed by two routes that share only their arithmetic."],
    ["mean", "Solutions of the continuous equation", "Means over faces, and values at points, of the solution u itself. Each is enclosed by two certificates on different meshes, which are checked when the value is asked for."],
    ["family", "Families", "The same for parameters of your own: the digits are those at the parameters that stand here."],
  ];
  let html = "<h1 id=\"reference-values\">Reference values</h1>\n<p>Every value has a radius, and says whether it is proved. " +
    "Midpoint and radius are decimals that enclose the value together. The program gives up to 1000 digits.</p>\n" + filter("Filter, as in: disk, Howell, proved");
  for (const [kind, title, says] of kinds) {
    const shown = entries.filter((entry) => entry.kind === kind);
    html += heading(2, anchor(title), `${title}`) + `<p>${says} ${shown.length} of them.</p>\n`;
    for (const entry of shown) {
      if (kind !== "family") {
        html += referenceValue(entry);
        continue;
      }
      const parameters = Object.entries(entry.parameters ?? {});

      html += `<article>${heading(3, entry.name, `<code>${escaped(entry.name)}</code>`)}<p>${escaped(entry.summary)}</p>` +
        (entry.value ? `<p class="digits">${escaped(entry.value.midpoint)}</p>` : "") +
        labels([...parameters.map(([name, [usual, allowed]]) => [name, `${escaped(allowed)}; default ${escaped(usual)}`]),
          ...(entry.value ? [["formula", `<code>${escaped(entry.value.formula)}</code>`], ["source", escaped(entry.value.source)],
            ...entry.value.routes.map((route, i) => [i ? "checked by" : "route", escaped(route)])] : [])]) +
        code(`rc.reference(${[`"${entry.name}"`, ...parameters.map(([name, [usual]]) => `${name}="${usual}"`)].join(", ")})`, "python") + "</article>\n";

    }
  }
  return html;
}

/** What `--help` says of each command. */
export async function help(commands) {
  const all = await commands.printed("radcert --help");
  const names = [...all.split("Subcommands:")[1].matchAll(/^ {2}(\w+) {2}/gm)].map((found) => found[1]);
  let html = "<h1 id=\"help-texts-of-the-commands\">Help texts of the commands</h1>\n<p>What each command prints with <code>--help</code>. " +
    "<a href=\"commands.html\">The command line</a> says what it is for, with examples.</p>\n" + heading(2, "radcert", "radcert") + code(`radcert --help\n\n${all.trimEnd()}`, "shell");
  for (const name of names)
    html += heading(2, name, escaped(name)) + code(`radcert ${name} --help\n\n${(await commands.printed(`radcert ${name} --help`)).trimEnd()}`, "shell");
  return html;
}

const alternatives = (types) => {
  const told = [...new Set(types)].filter((type) => type !== "anything");
  return told.length ? told : ["anything"];
};
const typeOf = (schema) => {
  if (schema.const !== undefined) return `<code>${escaped(JSON.stringify(schema.const))}</code>`;
  if (Array.isArray(schema.enum)) return schema.enum.map((value) => `<code>${escaped(JSON.stringify(value))}</code>`).join(", ");
  if (schema.$ref) return `<a href="#${escaped(schema.$ref.split("/").pop())}">${escaped(schema.$ref.split("/").pop())}</a>`;
  for (const key of ["oneOf", "anyOf", "allOf"]) if (schema[key]) return alternatives(schema[key].map(typeOf)).join(key === "allOf" ? " and " : " or ");
  const bounds = [["minimum", "≥"], ["exclusiveMinimum", "&gt;"], ["maximum", "≤"], ["exclusiveMaximum", "&lt;"]]
    .filter(([key]) => schema[key] !== undefined).map(([key, sign]) => ` ${sign} ${schema[key]}`).join(",");
  const type = [schema.type ?? (schema.properties || schema.required ? "object" : "anything")].flat().join(" or ");
  if (schema.items && type === "array") return `array of ${typeOf(schema.items)}`;
  return type + bounds;
};

function keysOf(schema, prefix = "", level = 0, needed = "required") {
  const rows = [];
  for (const [key, each] of Object.entries(schema.properties ?? {})) {
    rows.push(`<tr><td><code>${escaped(prefix + key)}</code></td><td>${typeOf(each)}</td><td>${(schema.required ?? []).includes(key) ? needed : ""}</td><td>${escaped(each.description ?? "")}</td></tr>`);
    const inner = each.items?.properties ? [each.items, `${prefix + key}[].`] : [each, `${prefix + key}.`];
    if (level < 6) rows.push(...keysOf(inner[0], inner[1], level + 1, needed));
  }
  for (const key of ["oneOf", "anyOf", "allOf"])
    for (const each of schema[key] ?? []) if (level < 6) rows.push(...keysOf(each, prefix, level + 1, "in this form"));
  return [...new Set(rows)];
}

/** A file type by its schema. */
export async function schemaPage(name, schema, shown, commands) {
  const table = (from) => {
    const rows = keysOf(from);
    return rows.length ? `<div class="wide" tabindex="0"><table><thead><tr><th>key</th><th>value</th><th></th><th>meaning</th></tr></thead><tbody>${rows.join("\n")}</tbody></table></div>\n` : "";
  };
  let html = heading(1, `file-type-${name}`, `File type: ${escaped(name)}`) + `<p>${escaped(schema.title ?? "")}. ${escaped(schema.description ?? "")} ` +
    `<a href="../formats.html">The file formats</a> says more.</p>\n` + heading(2, "keys", "Keys") + table(schema);
  for (const [part, each] of Object.entries(schema.$defs ?? {}))
    html += heading(3, part, escaped(part)) + `<p>${escaped(each.description ?? "")} ${each.properties ? "" : typeOf(each)}</p>\n` + table(each);
  html += heading(2, "example", "Example") + await tried(shown, commands);
  return html + heading(2, "schema", "The schema") + `<details><summary>radcert schema ${escaped(name)}</summary>${code(await commands.printed(`radcert schema ${name}`), "json")}</details>\n`;
}

/** All file types. */
export async function schemas(names, commands) {
  const rows = [];
  for (const name of names) {
    const schema = JSON.parse(await commands.printed(`radcert schema ${name}`));
    rows.push(`<tr><td><a href="${escaped(name)}.html"><code>${escaped(name)}</code></a></td><td>${escaped(schema.title ?? "")}</td><td>${escaped(schema.description ?? "")}</td></tr>`);
  }
  return "<h1 id=\"file-types-by-their-schemas\">File types by their schemas</h1>\n<p>Every key of every file, from the schemas against which the tests hold what radcert writes. " +
    "<a href=\"../formats.html\">The file formats</a> says what the files are for.</p>\n" +
    `<div class="wide" tabindex="0"><table><thead><tr><th>type</th><th></th><th></th></tr></thead><tbody>${rows.join("\n")}</tbody></table></div>\n` +
    await tried({ command: "radcert schema list" }, commands);
}

/** The surfaces of the catalogue. */
export function surfaces(entries) {
  let html = "<h1 id=\"surfaces-of-the-catalogue\">Surfaces of the catalogue</h1>\n<p>By their names in problems, on the command line and in Python. Numbers are exact.</p>\n" + filter("Filter, as in: convex, closed, disk");
  for (const entry of entries) {
    const call = `rc.${entry.name}(${entry.parameters.map((each) => `${each.name}=${/^\d+$/.test(each.default) ? each.default : `"${each.default}"`}`).join(", ")})`;
    html += `<article>${heading(3, entry.name, `<code>${escaped(entry.name)}</code>`)}<p>${escaped(entry.summary)}${entry.served ? "" : " (not for problems)"}</p>` +
      labels([["pieces", escaped(entry.pieces.join(", "))], ...entry.parameters.map((each) =>
        [each.name, escaped(`${each.meaning || "a parameter"}, ${each.requirement}; default ${each.default}`)])]) + code(`${call}\nradcert surface ${entry.name}`, "python") + "</article>\n";
  }
  return html;
}

/** The words of the glossary, and the other words under which readers look for them. */
export async function glossary(rows, alsoKnownAs, markdown, commands) {
  const entries = rows.map(([word, means]) => ({ word, html: `<p>${markdown(means).replace(/^<p>|<\/p>\n?$/g, "")}</p>` }));
  for (const [word, others] of Object.entries(alsoKnownAs)) {
    if (!rows.some(([each]) => each === word)) throw new Error(`the glossary has no "${word}"`);
    for (const other of others) entries.push({ word: other, html: `<p>see <a href="#${anchor(word)}">${escaped(word)}</a></p>` });
  }
  entries.sort((a, b) => a.word.toLowerCase().localeCompare(b.word.toLowerCase(), "en"));
  return "<h1 id=\"glossary\">Glossary</h1>\n<p>What words mean on these pages. The notation of formulas is <a href=\"theory/notation.html\">a page of its own</a>.</p>\n" +
    filter("Filter, as in: view factor") + entries.map(({ word, html }) => `<article>${heading(3, anchor(word), escaped(word))}${html}</article>\n`).join("") +
    heading(2, "an-example", "An example") + "<p>A configuration factor, its radius proved, by two routes:</p>\n" + await tried({ command: "radcert reference cube_opposite_faces --quiet" }, commands);
}

function docstring(text) {
  return text.split(/\n\s*\n/).map((paragraph) => {
    const out = [];
    for (const line of paragraph.split("\n")) {
      const item = line.match(/^(\w+(?:, \w+)*): (.*)$/);
      if (item) out.push([item[1], item[2]]);
      else if (out.length) out[out.length - 1][1] += ` ${line.trim()}`;
      else out.push([null, line.trim()]);
    }
    return out.map(([label, words]) => (label === null ? `<p>${inline(words)}</p>\n` : labels([[label, inline(words)]]))).join("").replace(/<\/dl>\n<dl class="labels">/g, "");
  }).join("");
}

/** The module of Python. */
export function python(names, example) {
  let html = "<h1 id=\"the-module-radcert\">The module radcert</h1>\n<p>What <code>import radcert as rc</code> gives, from its docstrings and types. " +
    "<a href=\"../python.html\">radcert from Python</a> leads through it with examples.</p>\n" + code(example, "python") + filter("Filter, as in: factors, picture");
  for (const kind of ["function", "class", "value", "exception"]) {
    const shown = names.filter((each) => each.kind === kind);
    html += heading(2, `all-${kind}`, { function: "Functions", class: "Classes", value: "Values", exception: "Exceptions" }[kind]);
    for (const each of shown) {
      html += `<article>${heading(3, each.name, `<code>${escaped(each.name)}</code>`)}`;
      if (each.signature) html += code(`${kind === "class" ? "class " : ""}${each.name}${each.signature}`, "python").replace("example ", "signature ");
      html += docstring(each.doc);
      html += each.members.map((member) => `<h4 id="${escaped(`${each.name}.${member.name}`)}"><code>${escaped(member.name)}</code><span class="quiet"> <code>${escaped(member.signature ?? "")}</code></span></h4>${docstring(member.doc)}`).join("");
      html += "</article>\n";
    }
  }
  return html;
}

async function filesUnder(folder, ending) {
  const found = await readdir(folder, { recursive: true });
  return found.filter((file) => file.endsWith(ending)).sort();
}

/** A test of a layer that shows how it is used: of those of a handful of lines the one with the most to see. */
async function exampleOf(checkout, layer) {
  const folder = path.join(checkout, "tests", layer);
  let best = null;
  for (const file of await filesUnder(folder, "_test.cpp").catch(() => [])) {
    const text = await readFile(path.join(folder, file), "utf8");
    for (const [test] of text.matchAll(/^TEST\([^]*?^\}\n/gm)) {
      const lines = test.trimEnd().split("\n").length;
      const score = lines < 6 || lines > 16 ? -Math.abs(lines - 11) : 100 - lines - (/Refuse|Reject|Throw|Contract|NotFinite/.test(test) ? 50 : 0);
      if (!best || score > best.score) best = { score, test, file: `tests/${layer}/${file}` };
    }
  }
  return best;
}

/** Sources in brackets, as [ac98, (33)], with links to the statements that they name. */
export function cited(html, papers, link) {
  return html.replace(/\[(\w+)((?:, |; )[^\]]*)?\]/g, (whole, key, rest = "") => {
    const paper = papers.find((each) => each.key === key);
    if (!paper) return whole;
    const number = rest.match(/\((\d+)\)/)?.[1];
    const label = rest.match(/(Theorem|Lemma|Corollary) ([\d.]+)/)?.slice(1).join("_").toLowerCase().replace(/\./g, "_");
    const claim = paper.claims.find((each) => each.label === label) ?? paper.claims.find((each) => number && each.covers?.includes(Number(number)));
    return `<a href="${escaped(link(`papers/${key}_statements.html${claim ? `#${claim.label}` : ""}`))}">${whole}</a>`;
  });
}

/** The public headers of a layer. */
export async function layerPage(checkout, layer, says, sourceLink, withCitations, wayToStable) {
  const folder = path.join(checkout, "lib/radcert", layer);
  const all = await readFile(path.join(checkout, "lib/radcert/all.h"), "utf8");
  const stable = new Set([...all.matchAll(/^#include "radcert\/(.+)"$/gm)].map(([, header]) => header));
  let html = heading(1, layer, `Layer <code>${escaped(layer)}</code>`) + (says.holds ? `<p>Holds ${says.holds}. ${says.why}</p>\n` : "");
  const shown = await exampleOf(checkout, layer);
  if (shown)
    html += heading(2, "example", "Example") + `<p>A test of this layer, from <a href="${sourceLink(shown.file)}"><code>${escaped(shown.file)}</code></a>:</p>\n` + code(shown.test.trimEnd(), "cpp");
  const headers = await filesUnder(folder, ".h");
  const isStable = (file) => stable.has(`${layer}/${file}`);
  html += heading(2, "stable", "What is stable") + "<p>" + (headers.some(isStable)
    ? `Of this layer, for programs of yours: ${headers.filter(isStable).map((file) => `<a href="#${file.replace(/\W/g, "_")}"><code>${escaped(file)}</code></a>`).join(", ")}. ` +
      "They come first below. The other headers are the inside of the library and change with any commit."
    : "No header: this layer is the inside of the library, and its headers change with any commit.") +
    ` <a href="${wayToStable}">What stable means</a>.</p>\n`;
  for (const file of [...headers.filter(isStable), ...headers.filter((each) => !isStable(each))]) {
    const names = publicNames(await readFile(path.join(folder, file), "utf8"));
    if (!names.length) continue;
    html += heading(2, file.replace(/\W/g, "_"), `<a href="${sourceLink(`lib/radcert/${layer}/${file}`)}"><code>radcert/${escaped(layer)}/${escaped(file)}</code></a>`) +
      `<p class="quiet">${isStable(file) ? "Stable" : "Internal: changes with any commit"}</p>\n`;
    const taken = new Map();
    for (const each of names) {
      const count = taken.get(each.name) ?? 0;
      taken.set(each.name, count + 1);
      const id = `${file.replace(/\W/g, "_")}-${each.name.replace(/\W+/g, (signs) => [...signs].map((sign) => sign.charCodeAt(0).toString(16)).join(""))}${count ? `-${count}` : ""}`;
      html += `<article>${heading(3, id, `<code>${escaped(each.name)}</code>`)}` + (each.says ? `<p>${inline(each.says)}</p>\n` : "") +
        labels(each.labels.map(([label, text]) => [label, label === "Maths" ? `<code>${escaped(text)}</code>` : withCitations(inline(text))])) +
        code(each.code, "cpp").replace("example ", "signature ") + "</article>\n";
    }
  }
  return html;
}

const tex = (text) => {
  try {
    return `<div class="formula">${formula(text, true)}</div>`;
  } catch {
    return `<pre>${escaped(text)}</pre>`;
  }
};
const listed = (items) => (items?.length ? `<ul>${items.map((item) => `<li>${escaped(item)}</li>`).join("")}</ul>` : "");

/** The statements of a paper. */
export function statements(paper, title) {
  let html = heading(1, paper.key, `Statements of ${escaped(title)}`) + `<p>Every numbered statement, in the order of the paper, with the verdict that a run of ` +
    `<code>radcert verify ${paper.key}</code> must find again. <a href="verification.html">What a verdict means</a>; <a href="${paper.key}_errata.html">errata</a>.</p>\n` +
    code(`radcert verify ${paper.key}`, "shell") + filter("Filter, as in: contradicted, Theorem, interpolation");
  for (const claim of paper.claims) {
    const verdict = typeof claim.verdict === "string" ? claim.verdict : claim.verdict?.quick;
    const word = verdict ? `<span class="verdict ${escaped(verdict)}">${escaped(verdict)}</span>${claim.scope ? ` (${{ all: "for all", family: "for a family", instances: "at instances" }[claim.scope]})` : ""}` : "one for each cell";
    const budgets = claim.verdict && typeof claim.verdict === "object" ? Object.entries(claim.verdict).map(([budget, each]) => `${budget}: ${each}`).join(", ") : "";
    html += `<article>${heading(3, claim.label, escaped(claim.label.replace(/_/g, " ")))}<p>${escaped(claim.says ?? "")}</p>` + (claim.formula ? tex(claim.formula) : "") +
      labels([["verdict", word + (budgets ? ` <span class="quiet">${escaped(budgets)}</span>` : "")], ["equations", (claim.covers ?? []).map((number) => `(${number})`).join(", ")],
        ["page", claim.page ? escaped(claim.page) : ""], ["needs", listed(claim.needs)], ["tried", listed(claim.tried)], ["note", escaped(claim.note ?? "")],
        ["not checked", escaped(claim.unchecked ?? "")], ["erratum", claim.erratum ? `<a href="${paper.key}_errata.html">${escaped(claim.erratum)}</a>` : ""],
        ["run it", `<code>radcert verify ${escaped(`${paper.key}/${claim.label}`)}</code>`]]) + "</article>\n";
  }
  return html;
}
