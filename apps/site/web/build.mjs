// SPDX-License-Identifier: GPL-3.0-or-later
//
// node build.mjs --checkout DIR --program FILE --python FILE --module DIR --cache DIR --out DIR [--quick]
//
// Makes the pages. The program and the module of Python are asked for all that they know; what they answered is kept in the
// cache for as long as they stay the same. --quick leaves out the pictures, and the
// digits of reference values, that take seconds.

import { build as bundle } from "esbuild";
import MiniSearch from "minisearch";
import { mkdir, readdir, readFile, rename, rm, stat, writeFile } from "node:fs/promises";
import path from "node:path";
import { Commands } from "./src/commands.mjs";
import { coloured, escaped } from "./src/highlight.mjs";
import { indexing } from "./src/indexing.mjs";
import { pageText, sections, wayTo } from "./src/layout.mjs";
import * as made from "./src/made.mjs";
import { render } from "./src/markdown.mjs";
import { alsoKnownAs, groups, pictures, schemaExamples } from "./src/site.mjs";

const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const given = {};
for (let i = 2; i < process.argv.length; ++i) {
  const word = process.argv[i].replace(/^--/, "");
  given[word] = word === "quick" ? true : process.argv[++i];
}
for (const word of ["checkout", "program", "python", "module", "cache", "out"]) {
  if (!given[word]) {
    console.error(`build.mjs: --${word} is missing`);
    process.exit(2);
  }
}
const { checkout } = given;
const out = `${given.out}.new`;
const read = (name) => readFile(path.join(checkout, name), "utf8");
const commands = new Commands(given);
await commands.begin();
await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });

async function write(name, content) {
  const file = path.join(out, name);
  await mkdir(path.dirname(file), { recursive: true });
  await writeFile(file, content);
}

// What a change of the module of Python makes out of date.
const compiled = (await readdir(path.join(given.module, "radcert"))).filter((file) => /\.(so|py|pyi)$/.test(file)).sort();
const moduleState = await Promise.all(compiled.map((file) => readFile(path.join(given.module, "radcert", file))));
const claimState = await Promise.all(["ac98", "m06", "psg10"].map((key) => read(`papers/${key}/claims.toml`)));
const facts = await commands.json(path.join(checkout, "apps/site/collect.py"), [checkout, ...(given.quick ? ["--quick"] : [])],
  [...moduleState, ...claimState, given.quick ? "quick" : ""]);

// Which page a file of the repository became.
const pageOf = new Map();
const notebooks = (await readdir(path.join(checkout, "apps/examples/notebooks"))).filter((file) => file.endsWith(".py")).sort();
const schemas = (await readdir(path.join(checkout, "lib/radcert/formats/schema"))).filter((file) => file.endsWith(".json"))
  .map((file) => file.replace(".json", "")).sort();
const declared = [...(await read("lib/CMakeLists.txt")).matchAll(/^radcert_layer\((\w+)/gm)].map((found) => found[1]);
const contributing = await read("CONTRIBUTING.md");
const layerRows = new Map([...contributing.matchAll(/^\| `(\w+)` \|([^|]*)\|([^|]*)\|$/gm)]
  .map(([, name, holds, why]) => [name, { holds: holds.trim(), why: why.trim() }]));
const titles = { ac98: "Atkinson and Chandler 1998", m06: "Micula 2006", psg10: "Pereira, Stolfi and Gomide 2010" };

const expansions = {
  notebooks: () => notebooks.map((file) => ({ name: `tutorials/${file.replace(".py", ".html")}`, from: `apps/examples/notebooks/${file}`, kind: "notebook" })),
  schemas: () => schemas.map((schema) => ({ name: `schema/${schema}.html`, from: `lib/radcert/formats/schema/${schema}.json`, kind: "schema", schema,
    title: `File type: ${schema}`, short: `Schema of ${schema}`, isHidden: true })),
  layers: () => declared.map((layer) => ({ name: `api/cpp/${layer}.html`, kind: "layer", layer, title: `Layer ${layer}`, short: layer })),
  papers: () => facts.papers.flatMap((paper) => [
    { name: `papers/${paper.key}.html`, from: `papers/${paper.key}/README.md`, short: titles[paper.key], tries: [{ command: `radcert list claims --quiet`, run: false }] },
    { name: `papers/${paper.key}_statements.html`, kind: "statements", paper, from: `papers/${paper.key}/claims.toml`,
      title: `Statements of ${titles[paper.key]}`, short: `Its statements (${paper.key})` },
    { name: `papers/${paper.key}_errata.html`, from: `papers/${paper.key}/errata.md`, title: `Errata of ${titles[paper.key]}`, short: `Its errata (${paper.key})`,
      tries: [{ command: `radcert verify ${paper.key}`, run: false }] },
  ]),
};
const site = groups.map((group) => ({ title: group.title,
  pages: group.pages.flatMap((page) => (expansions[page.made]?.() ?? [{ kind: page.made, ...page }]).map((each) => ({ ...each, kind: each.kind ?? "markdown" }))) }));
const pages = site.flatMap((group) => group.pages);
for (const page of pages) if (page.from) pageOf.set(page.from, page.name);
for (const page of pages)
  if (page.from?.endsWith("/README.md")) pageOf.set(page.from.replace("/README.md", ""), page.name);

// Files that pages link to, and that are no pages themselves, are shown as sources.
const sources = new Map();
function sourcePage(file) {
  const name = `source/${file}.html`;
  sources.set(file, name);
  return name;
}

async function exists(file) {
  return stat(path.join(checkout, file)).then((found) => (found.isDirectory() ? "folder" : "file"), () => null);
}

const linkTargets = new Map();
/** Looks at every link of a page before it is rendered, since rendering does not wait. */
async function lookAt(text, from) {
  for (const [, href] of text.matchAll(/\]\(([^)\s]+)\)/g)) {
    if (/^[a-z]+:/.test(href)) continue;
    const file = path.posix.normalize(path.posix.join(path.posix.dirname(from), href.split("#")[0])).replace(/\/$/, "");
    linkTargets.set(file, await exists(file));
  }
}

function linker(page, from = page.from) {
  return (href) => {
    if (/^[a-z]+:/.test(href)) return href;
    const [way, hash] = href.split("#");
    const file = way ? path.posix.normalize(path.posix.join(path.posix.dirname(from), way)).replace(/\/$/, "") : from;
    // Pages of the site itself, which sources name as they will be.
    const asPage = pages.find((each) => each.name === path.posix.normalize(path.posix.join(path.posix.dirname(page.name), way || page.name)));
    if (way.endsWith(".html") && asPage) return wayTo(page.name, asPage.name + (hash ? `#${hash}` : ""));
    const to = pageOf.get(file) ?? (linkTargets.get(file) === "file" ? sourcePage(file) : null);
    if (!to) throw new Error(`${from}: ${href} leads to no page`);
    return wayTo(page.name, to + (hash ? `#${hash}` : ""));
  };
}

const images = new Map();
function imager(page, from = page.from) {
  return (source) => {
    const file = path.posix.normalize(path.posix.join(path.posix.dirname(from), source));
    images.set(file, `files/${path.posix.basename(file)}`);
    return wayTo(page.name, images.get(file));
  };
}
const markdown = (text, page, withFormulas, from = page.from) => render(text, { link: linker(page, from), image: imager(page, from), withFormulas });
const titleOf = (text) => text.match(/^# (.*)$/m)?.[1].replace(/[`*]/g, "");

for (const page of pages) if (page.from && !page.from.endsWith(".json")) await lookAt(await read(page.from), page.from);
// Pages of the repository that others link to and that site.mjs does not name: examples among the tutorials, the rest at
// the end.
for (let found = true; found;) {
  found = false;
  for (const [target, kind] of [...linkTargets].sort()) {
    const file = kind === "folder" ? `${target}/README.md` : target;
    if (!kind || !file.endsWith(".md") || pageOf.has(file) || await exists(file) !== "file") continue;
    const group = site.find(({ title }) => title === (file.startsWith("apps/examples/") ? "Tutorials" : "Project"));
    const page = { name: `more/${file.replace(/\/README\.md$|\.md$/, "").replace(/\//g, "_")}.html`, from: file, kind: "markdown" };
    group.pages.push(page);
    pages.push(page);
    pageOf.set(file, page.name);
    if (file.endsWith("/README.md")) pageOf.set(file.replace("/README.md", ""), page.name);
    await lookAt(await read(file), file);
    found = true;
  }
}
for (const picture of pictures) await lookAt(picture.says, "gallery.md");

const makers = {
  async markdown(page) {
    const text = await read(page.from);
    page.title ??= titleOf(text);
    let html = markdown(text, page, page.from.startsWith("apps/site/"));
    // Names that have a page: layers where they are listed, and the statements that errata name.
    if (page.from === "CONTRIBUTING.md")
      html = html.replace(/<td><code>(\w+)<\/code><\/td>/g, (whole, name) => (declared.includes(name)
        ? `<td><a href="${wayTo(page.name, `api/cpp/${name}.html`)}"><code>${name}</code></a></td>` : whole));
    // A link of the theory to a statement says what its check found.
    if (page.from.startsWith("apps/site/pages/theory"))
      html = html.replace(/<a href="[^"]*papers\/(\w+)_statements\.html#(\w+)">[^]*?<\/a>/g, (whole, key, label) => {
        const verdict = facts.papers.find((each) => each.key === key).claims.find((claim) => claim.label === label)?.verdict;
        const word = typeof verdict === "string" ? verdict : verdict?.quick;
        return word ? `${whole} <small class="${word}">${word}</small>` : whole;
      });
    const paper = facts.papers.find(({ key }) => page.from === `papers/${key}/errata.md`);
    if (paper)
      html = html.replace(/<code>(\w+)((?:\.\w+)*)<\/code>/g, (whole, label) => (paper.claims.some((claim) => claim.label === label)
        ? `<a href="${wayTo(page.name, `papers/${paper.key}_statements.html#${label}`)}">${whole}</a>` : whole));
    for (const each of page.tries ?? []) html += `<h2 id="try-it">Try it</h2>\n${await made.tried(each, commands)}`;
    return html;
  },
  async notebook(page) {
    const cells = await commands.json(path.join(checkout, "apps/site/notebook.py"), [path.join(checkout, page.from)],
      [await read(page.from), ...moduleState]);
    page.title = titleOf(cells[0].text);
    page.short = page.title;
    let count = 0;
    return made.notebook(cells, {
      markdown: (text) => markdown(text, page, true),
      keepPicture: async (svg) => {
        const name = `files/${path.basename(page.from, ".py")}_${++count}.svg`;
        await write(name, svg);
        return wayTo(page.name, name);
      },
    }).then((html) => `${html}<p>The script of this page is <a href="${wayTo(page.name, sourcePage(page.from))}"><code>${page.from}</code></a>; <code>python3</code> runs it, VS Code and, by jupytext, Jupyter open it.</p>\n`);
  },
  gallery: (page) => made.gallery(pictures.filter((each) => !given.quick || !each.isSlow), commands, {
    markdown: (text) => markdown(text, page, false, "gallery.md"),
    keep: async (name, bytes) => {
      await write(`files/${name}`, bytes);
      return wayTo(page.name, `files/${name}`);
    },
  }),
  references: () => made.references(facts.references),
  help: () => made.help(commands),
  schemaIndex: () => made.schemas(schemas, commands),
  surfaces: () => made.surfaces(facts.surfaces),
  schema: async (page) => {
    return made.schemaPage(page.schema, JSON.parse(await commands.printed(`radcert schema ${page.schema}`)),
      schemaExamples[page.schema] ?? { command: `radcert schema ${page.schema}`, run: false }, commands);
  },
  async glossary(page) {
    const rows = [...contributing.split(/^## Glossary$/m)[1].matchAll(/^\| ([^|]+) \| (.+) \|$/gm)].map(([, word, means]) => [word.trim(), means])
      .filter(([word]) => word !== "word" && !/^-+$/.test(word));
    await lookAt(rows.map((row) => row[1]).join("\n"), "CONTRIBUTING.md");
    return made.glossary(rows, alsoKnownAs, (text) => markdown(text, page, false, "CONTRIBUTING.md").replace(/href="#/g, `href="${wayTo(page.name, "contributing.html")}#`), commands);
  },
  python: async () => made.python(facts.python, (await read("apps/python/radcert/__init__.py")).match(/^ {4}import radcert as rc\n[^]*?(?=\n\n[A-Z])/m)[0].replace(/^ {4}/gm, "")),
  async layer(page) {
    const row = layerRows.get(page.layer) ?? { holds: "", why: "" };
    const words = (text) => markdown(text, page, false, "CONTRIBUTING.md").replace(/^<p>|<\/p>\n?$/g, "");
    return made.layerPage(checkout, page.layer, { holds: row.holds && words(row.holds), why: row.why ? `Its place among the layers: ${words(row.why)}.` : "" },
      (file) => wayTo(page.name, sourcePage(file)), (html) => made.cited(html, facts.papers, (to) => wayTo(page.name, to)),
      wayTo(page.name, `${pageOf.get("lib/README.md")}#what-is-stable`));
  },
  statements: (page) => made.statements(page.paper, titles[page.paper.key]),
};

for (const page of pages) {
  page.html = await makers[page.kind](page);
  page.title ??= titleOf(page.html);
}
// Titles are known now, which the navigation of every page shows.
for (const page of pages) await write(page.name, pageText(page, site, facts.version));

const listOfLicences = JSON.parse(await readFile(path.join(here, "package.json"), "utf8"));
let licences = "<h1 id=\"licences\">Licences</h1>\n<p>These pages are made with, and their scripts, styles and fonts hold parts of, these libraries.</p>\n";
for (const library of Object.keys(listOfLicences.dependencies).sort()) {
  const folder = path.join(here, "node_modules", library);
  const about = JSON.parse(await readFile(path.join(folder, "package.json"), "utf8"));
  const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
  licences += `<h2 id="${escaped(library.replace(/\W/g, "_"))}">${escaped(library)} ${escaped(about.version)}</h2>\n<pre>${escaped(file ? await readFile(path.join(folder, file), "utf8") : about.license)}</pre>\n`;
}
const extras = [
  { name: "licences.html", title: "Licences", html: licences, isPlain: true },
  { name: "search.html", title: "Search", html: "<h1 id=\"search\">Search</h1>\n<p id=\"count\" class=\"quiet\">Words of which a page has all; the first letters of a word will do.</p>\n<div id=\"results\"></div>\n", isPlain: true },
];
for (const page of extras) await write(page.name, pageText(page, site, facts.version));

const languages = { ".cpp": "cpp", ".h": "cpp", ".json": "json", ".py": "python" };
for (const [file, name] of [...sources].sort()) {
  const page = { name, title: file, isPlain: true,
    html: `<h1 id="source">${escaped(file)}</h1>\n<pre class="listing" tabindex="0"><code>${coloured(await read(file), languages[path.extname(file)])}</code></pre>\n` };
  await write(name, pageText(page, site, facts.version));
}
for (const [file, name] of images) await write(name, await readFile(path.join(checkout, file)));

// The index of the search: a document a section.
const index = new MiniSearch(indexing);
for (const page of pages) {
  const parts = sections(page.html);
  for (const part of parts.length ? parts : [{ anchor: "main", title: page.title, text: "" }]) {
    const id = `${page.name}#${part.anchor}`;
    if (!index.has(id)) index.add({ id, title: part.title, page: page.title, text: part.text.slice(0, 4000), start: part.text.slice(0, 110) });
  }
}
await write("search_index.js", `window.radcertIndex = ${JSON.stringify(index.toJSON())};\n`);

// KaTeX offers each font three times; a browser that shows these pages takes the first.
const firstFontOnly = {
  name: "first-font-only",
  setup(run) {
    run.onLoad({ filter: /katex(\.min)?\.css$/ }, async ({ path: file }) => ({ loader: "css",
      contents: (await readFile(file, "utf8")).replace(/,url\([^)]*\.woff\) format\("woff"\)|,url\([^)]*\.ttf\) format\("truetype"\)/g, "") }));
  },
};
const options = { bundle: true, minify: true, write: false, outdir: "out", target: "es2022", format: "iife", legalComments: "none",
  loader: { ".woff2": "dataurl" }, plugins: [firstFontOnly] };
const style = await bundle({ ...options, stdin: { contents: "@import \"katex/dist/katex.min.css\"; @import \"./src/style.css\";", resolveDir: here, loader: "css" } });
await write("style.css", style.outputFiles[0].contents);
const script = await bundle({ ...options, entryPoints: [path.join(here, "src/client.js")] });
await write("site.js", script.outputFiles[0].contents);

await rm(given.out, { recursive: true, force: true });
await rename(out, given.out);
console.log(`${pages.length + sources.size + extras.length} pages in ${given.out}/index.html`);
