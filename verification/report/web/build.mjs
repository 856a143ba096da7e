// SPDX-License-Identifier: GPL-3.0-or-later
//
// node build.mjs OUTPUT
// Bundles the page of a report into one HTML file: scripts, styles and fonts inside, a gap for the data.

import { build } from "esbuild";
import { readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";

const here = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const output = process.argv[2];
if (!output) {
  console.error("usage: node build.mjs OUTPUT");
  process.exit(2);
}

// KaTeX offers each font three times; a browser that runs this page takes the first.
const firstFontOnly = {
  name: "first-font-only",
  setup(bundle) {
    bundle.onLoad({ filter: /katex(\.min)?\.css$/ }, async ({ path: file }) => {
      const css = await readFile(file, "utf8");
      return {
        loader: "css",
        contents: css.replace(/,url\([^)]*\.woff\) format\("woff"\)|,url\([^)]*\.ttf\) format\("truetype"\)/g, ""),
      };
    });
  },
};

const bundled = await build({
  entryPoints: [path.join(here, "src/main.js")],
  bundle: true,
  minify: true,
  write: false,
  outdir: "out",
  target: "es2022",
  format: "iife",
  legalComments: "none",
  loader: { ".woff2": "dataurl" },
  plugins: [firstFontOnly],
});
const text = (ending) => bundled.outputFiles.find((file) => file.path.endsWith(ending)).text;

async function licences() {
  const listed = JSON.parse(await readFile(path.join(here, "package.json"), "utf8"));
  const notices = [];
  for (const name of Object.keys(listed.dependencies).sort()) {
    const folder = path.join(here, "node_modules", name);
    const about = JSON.parse(await readFile(path.join(folder, "package.json"), "utf8"));
    const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
    const licence = file ? await readFile(path.join(folder, file), "utf8") : about.license;
    notices.push({ name, version: about.version, licence: about.license, text: licence });
  }
  return notices;
}

// In a script element "</" would end it, and "<!--" would change how the rest is read.
const inScript = (code) => code.replace(/<\/(script)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");

const template = await readFile(path.join(here, "src/page.html"), "utf8");
const parts = {
  "/*STYLE*/": text(".css"),
  "/*LICENCES*/": JSON.stringify(await licences()).replace(/</g, "\\u003c"),
  "/*SCRIPT*/": inScript(text(".js")),
};
const page = template.replace(/\/\*(STYLE|LICENCES|SCRIPT)\*\//g, (gap) => parts[gap]);
await writeFile(output, page);
