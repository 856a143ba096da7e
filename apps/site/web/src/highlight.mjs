// SPDX-License-Identifier: GPL-3.0-or-later
import { parser as cpp } from "@lezer/cpp";
import { classHighlighter, highlightCode } from "@lezer/highlight";
import { parser as json } from "@lezer/json";
import { parser as python } from "@lezer/python";

const PARSERS = { cpp, c: cpp, h: cpp, json, python, py: python };

export const escaped = (text) => String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/** Source text as HTML with the classes of its words. */
export function coloured(text, language) {
  const parser = PARSERS[language];
  if (!parser) return language === "shell" ? shell(text) : escaped(text);
  let html = "";
  highlightCode(text, parser.parse(text), classHighlighter,
    (part, classes) => { html += classes ? `<span class="${classes}">${escaped(part)}</span>` : escaped(part); },
    () => { html += "\n"; });
  return html;
}

/** Commands and what they print: a command stands out. */
function shell(text) {
  return text.split("\n").map((line) => (/^(build\/release\/bin\/)?radcert |^(\.\/run|cmake|ctest|python3|apt-get|export|pip|diff|git)\b/.test(line)
    ? `<span class="command">${escaped(line)}</span>` : escaped(line))).join("\n");
}
