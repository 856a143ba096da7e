// SPDX-License-Identifier: GPL-3.0-or-later
import katex from "katex";
import { Marked } from "marked";
import { coloured, escaped } from "./highlight.mjs";

/** A formula as HTML with MathML for those who listen. */
export const formula = (tex, displayMode) =>
  katex.renderToString(tex, { displayMode, output: "htmlAndMathml", throwOnError: true, strict: "ignore" });

/** The anchor of a heading, as the pages' own links have it. */
export const anchor = (heading) =>
  heading.replace(/<[^>]*>/g, "").replace(/&[a-z#0-9]+;/g, "").trim().toLowerCase().replace(/[^\p{L}\p{N}_\- ]/gu, "").replace(/ /g, "-");

const mathematics = {
  extensions: [
    {
      name: "display", level: "block", start: (text) => text.indexOf("$$"),
      tokenizer(text) {
        const found = text.match(/^\$\$([^$]+)\$\$(?:\n|$)/) ?? text.match(/^\$\$([^$]+)\$\$/);
        return found ? { type: "display", raw: found[0], tex: found[1].trim() } : undefined;
      },
      renderer: ({ tex }) => `<div class="formula">${formula(tex, true)}</div>\n`,
    },
    {
      name: "inline", level: "inline", start: (text) => text.indexOf("$"),
      tokenizer(text) {
        const found = text.match(/^\$([^$\s](?:[^$]*[^$\s])?)\$/);
        return found ? { type: "inline", raw: found[0], tex: found[1] } : undefined;
      },
      renderer: ({ tex }) => formula(tex, false),
    },
  ],
};

/** Whether an indented block is Python or C++, or commands and what they print. */
function languageOf(text) {
  if (/^\s*(#include|template|struct |class |\/\/)/m.test(text)) return "cpp";
  return "shell";
}

/**
 * Markdown as HTML: `link(href)` gives where a link leads, `image(src)` where a picture is; `withFormulas` takes $ as the
 * mark of TeX.
 */
export function render(text, { link, image, withFormulas }) {
  const taken = new Map();
  const marked = new Marked({ gfm: true });
  if (withFormulas) marked.use(mathematics);
  marked.use({
    renderer: {
      heading({ tokens, depth }) {
        const inner = this.parser.parseInline(tokens);
        let id = anchor(inner);
        const before = taken.get(id) ?? 0;
        taken.set(id, before + 1);
        if (before) id = `${id}-${before}`;
        return `<h${depth} id="${id}">${inner}<a class="here" href="#${id}" aria-label="Link to this section">#</a></h${depth}>\n`;
      },
      code({ text: code, lang }) {
        const language = lang || languageOf(code);
        return `<pre class="example ${language}" tabindex="0"><code>${coloured(code, language)}</code></pre>\n`;
      },
      link({ href, title, tokens }) {
        const to = link(href);
        return `<a href="${escaped(to)}"${title ? ` title="${escaped(title)}"` : ""}>${this.parser.parseInline(tokens)}</a>`;
      },
      image({ href, text: words }) {
        return `<img src="${escaped(image(href))}" alt="${escaped(words)}">`;
      },
      html({ text: html }) {
        return html.startsWith("<!--") ? "" : html.replace(/src="([^"]+)"/g, (_, from) => `src="${escaped(image(from))}"`);
      },
      table(token) {
        const cell = (each, tag) => `<${tag}>${this.parser.parseInline(each.tokens)}</${tag}>`;
        const head = token.header.map((each) => cell(each, "th")).join("");
        const rows = token.rows.map((row) => `<tr>${row.map((each) => cell(each, "td")).join("")}</tr>`).join("\n");
        return `<div class="wide" tabindex="0"><table><thead><tr>${head}</tr></thead><tbody>${rows}</tbody></table></div>\n`;
      },
    },
  });
  return marked.parse(text);
}
