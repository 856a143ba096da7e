// SPDX-License-Identifier: GPL-3.0-or-later

// The mathematics in the sentences of claims, which are plain text, as it is printed: letters of formulas slanted, indices and
// powers set, Greek letters and signs in place of their names. What is not recognised stays as it is.

const greek = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", epsilon: "ε", eta: "η", theta: "θ", kappa: "κ", lambda: "λ", mu: "μ", nu: "ν",
  xi: "ξ", pi: "π", rho: "ρ", sigma: "σ", tau: "τ", phi: "φ", psi: "ψ", omega: "ω", infinity: "∞", Omega: "Ω", Delta: "Δ", Gamma: "Γ",
};

const names = Object.keys(greek).join("|");
// What may stand below or above a letter: a word, a number, or what parentheses hold.
const script = String.raw`-?(?:[A-Za-z]+(?![A-Za-z_])|\d+(?:\/\d+)?)|\([^()]*\)|\{[^{}]*\}`;
const rules = [
  // A letter, or two as in dS, with an index: not a part of a name as theorem_3.
  ["index", String.raw`(?<![A-Za-z0-9_])(?:${names}|Int|sup|max|min|sum|lim|[A-Za-z]{1,2})'?_(?:${script})`],
  ["power", String.raw`\^(?:${script})`],
  ["greek", String.raw`(?<![A-Za-z_])(?:${names})(?![A-Za-z_])`],
  ["root", String.raw`(?<![A-Za-z_])sqrt(?=\()`],
  ["integral", String.raw`(?<![A-Za-z_])Int(?![A-Za-z_])(?=[ (])`],
  ["sign", String.raw`<=|>=|!=|->|\+-| - (?=[\w(|])|(?<=[(=,] ?)-(?=[\w(|])`],
  // A letter that is a word in English only in other places.
  ["letter", String.raw`(?:(?<=(?<![A-Za-z_.])\d)(?!e)[a-z]|(?<![A-Za-z0-9_'’.])(?:[b-zB-HJ-Z]|I(?= ?[-+)])|[aA](?= ?(?:[=<>^]|[-+] [\w(]))))(?![A-Za-z0-9_'’])(?!\.[a-z])`],
];
const any = new RegExp(rules.map(([name, rule]) => `(?<${name}>${rule})`).join("|"), "g");
const signs = { "<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "+-": "±", " - ": " − ", "-": "−" };

/** What stands below or above, without the parentheses that hold it together. */
function held(text) {
  const inner = /^[({].*[)}]$/.test(text) ? text.slice(1, -1) : text;
  return inner.replace(new RegExp(`(?<![A-Za-z])(?:${names})(?![A-Za-z])`, "g"), (name) => greek[name]).replace(/-/g, "−");
}

/** The parts of a text: [tag, content], the tag empty for plain text. */
export function mathematics(text) {
  const parts = [];
  let done = 0;
  for (const match of text.matchAll(any)) {
    if (match.index > done) parts.push(["", text.slice(done, match.index)]);
    const { index, power, greek: name, letter, root, integral, sign } = match.groups;
    if (index) {
      const at = index.indexOf("_");
      const base = index.slice(0, at);
      const upright = { Int: "∫", sup: "sup", max: "max", min: "min", sum: "Σ", lim: "lim" }[base];
      parts.push(upright ? ["", upright] : ["i", greek[base] ?? base], ["sub", held(index.slice(at + 1))]);
    } else if (power) parts.push(["sup", held(power.slice(1))]);
    else if (name) parts.push(["", greek[name]]);
    else if (letter) parts.push(["i", letter]);
    else if (root) parts.push(["", "√"]);
    else if (integral) parts.push(["", "∫"]);
    else parts.push(["", signs[sign]]);
    done = match.index + match[0].length;
  }
  if (done < text.length) parts.push(["", text.slice(done)]);
  return parts;
}
