// SPDX-License-Identifier: GPL-3.0-or-later
import katex from "katex";
import "katex/dist/katex.min.css";
import { element } from "./dom.js";

/** A displayed formula with MathML for those who listen. What KaTeX cannot read stands as its source. */
export function formula(tex) {
  const box = element("div", { class: "formula" });
  try {
    katex.render(tex, box, { displayMode: true, output: "htmlAndMathml", throwOnError: true, strict: false });
  } catch (error) {
    box.append(element("code", {}, tex));
  }
  return box;
}
