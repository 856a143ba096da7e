// SPDX-License-Identifier: GPL-3.0-or-later
//
// The public names of a header, each with its comment. Headers are laid out by clang-format, which a test holds, so that
// indentation and blank lines mean what they seem to.

const LABELS = ["Maths", "Source", "Requires", "Result", "Limits"];

/** A comment as sentences and labelled lines: {says, labels: [[label, text]]}. */
export function comment(lines) {
  const says = [];
  const labels = [];
  for (const line of lines) {
    const found = line.match(/^(\w+)\s{2,}(.*)$/);
    if (found && LABELS.includes(found[1])) labels.push([found[1], found[2]]);
    else if (labels.length && /^\s{2,}/.test(line)) labels[labels.length - 1][1] += " " + line.trim();
    else (labels.length && line.trim() ? labels[labels.length - 1][1] += " " + line.trim() : says.push(line.trim()));
  }
  return { says: says.join("\n").trim(), labels };
}

// Brackets outside of literals and comments.
const bare = (line) => line.replace(/"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)'/g, "\"\"").replace(/\/\/.*$/, "");
const depth = (line, open, close) => {
  let sum = 0;
  for (const letter of bare(line)) sum += open.includes(letter) ? 1 : close.includes(letter) ? -1 : 0;
  return sum;
};

/** The lines of one declaration that begins at `at`: to its semicolon, or to the end of its braces. */
function declarationEnd(lines, at) {
  let round = 0;
  for (let i = at; i < lines.length; ++i) {
    round += depth(lines[i], "([{", ")]}");
    if (round <= 0 && /[;}]\s*$/.test(bare(lines[i]).trimEnd())) return i + 1;
  }
  return lines.length;
}

/** A declaration as it is shown: of a class its public part, of a function no body. */
function shown(lines) {
  const text = lines.join("\n");
  const head = bare(lines[0]).startsWith("template") ? lines.findIndex((line) => !/^(template|\s|requires)/.test(line)) : 0;
  const first = lines[Math.max(0, head)];
  if (/^(class|struct|union)\b/.test(first) || /^enum\b/.test(first)) {
    const out = [];
    let hidden = false;
    for (let i = 0; i < lines.length; ++i) {
      const access = lines[i].match(/^(public|protected|private):/);
      if (access) hidden = access[1] !== "public";
      if (i === lines.length - 1) hidden = false;
      if (!hidden) out.push(lines[i]);
    }
    return out.join("\n").replace(/\n\n+(?=};?$)/, "\n");
  }
  if (/^(using|inline constexpr|constexpr|static|typedef|concept|extern)\b/.test(first) || / concept /.test(text) ||
      /^template[^;{]*\nconcept /.test(text)) return text;
  // A function: what stands before its body.
  let round = 0;
  for (let i = 0; i < text.length; ++i) {
    if ("([".includes(text[i])) ++round;
    if (")]".includes(text[i])) --round;
    if (text[i] === "{" && round === 0) {
      return text.slice(0, i).replace(/\n?\s*:\s[^;]*$/, (list) => (list.includes("(") || list.includes("{") ? "" : list)).trimEnd() + ";";
    }
  }
  return text;
}

/** The name that a declaration declares. */
export function declaredName(text) {
  const plain = bare(text.replace(/\/\/.*$/gm, "")).replace(/^(template\s*<(?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*>\s*(requires[^\n]*\n)?)+/, "")
    .replace(/\[\[[^\]]*\]\]/g, "").trim();
  const type = plain.match(/^(?:class|struct|union|enum(?: class| struct)?|concept)\s+(\w+)/);
  if (type) return type[1];
  const using = plain.match(/^using\s+(\w+)/);
  if (using) return using[1];
  const operator = plain.match(/\b(operator\s*[^\s\w(]+|operator\(\))\s*\(/);
  if (operator) return operator[1];
  const called = plain.match(/([~\w]+)\s*\(/);
  if (called) return called[1];
  const variable = plain.match(/(\w+)\s*(?:=|\{|;|\[)/);
  return variable ? variable[1] : plain.slice(0, 30);
}

/** The public names of a header in their order: [{name, says, labels, code}]. */
export function publicNames(text) {
  const lines = text.split("\n");
  const out = [];
  let spaces = [];
  let about = [];
  for (let i = 0; i < lines.length;) {
    const line = lines[i];
    const space = line.match(/^(?:inline )?namespace ([\w:]*)\s*\{$/);
    if (space) {
      spaces.push(space[1]);
      ++i;
      if (about.length) out.push({ name: space[1], ...comment(about), code: `namespace ${space[1]}`, end: -1 });
      about = [];
      continue;
    }
    if (/^\}\s*\/\/ namespace/.test(line)) {
      spaces.pop();
      ++i;
      about = [];
      continue;
    }
    if (/^\/\/\/(?!<)/.test(line)) {
      about.push(line.replace(/^\/\/\/ ?/, ""));
      ++i;
      continue;
    }
    if (/^\/\/ clang-format /.test(line)) {
      ++i;
      continue;
    }
    if (line.trim() === "" || /^(#|\/\/|\}|extern )/.test(line)) {
      const end = /^extern /.test(line) ? declarationEnd(lines, i) : i + 1;
      about = [];
      i = end;
      continue;
    }
    const end = declarationEnd(lines, i);
    const isInside = spaces.some((name) => name.split("::").includes("detail"));
    const code = shown(lines.slice(i, end));
    const isForward = /^(class|struct|enum class) \w+( : [\w:]+)?;$/.test(code);
    // A member that its class declares.
    const isMember = /[\w>]::[~\w]+(?:<[^()]*>)?\s*$/.test(code.replace(/^ +requires.*$/m, "").split("(")[0].replace(/operator.*$/, "")) && code.includes("(") &&
      !/^(template[^;{(]*\n)?(class|struct|union|enum|using)\b/.test(code);
    if (spaces.length && !isInside && !isForward && !isMember) {
      const previous = out[out.length - 1];
      const follows = previous && !about.length && previous.end === i;
      // What stands directly below belongs to the comment above.
      if (follows) {
        previous.code += "\n" + code;
        previous.end = end;
      } else {
        out.push({ name: declaredName(code), ...comment(about), code, end });
      }
    }
    about = [];
    i = end;
  }
  return out;
}
