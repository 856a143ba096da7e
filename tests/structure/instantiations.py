#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lib/instantiations.md says what the library compiles, and nothing else is compiled.

Every `extern template` of a public header has a "yes" in the table, and every "yes" a declaration.
"""
import pathlib
import re
import sys


def table_of(text):
    """{(name, arithmetic): cell} of the table's rows; names are those in backquotes."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")]
            for line in text.splitlines() if line.startswith("|")]
    arithmetics = rows[0][1:]
    cells = {}
    for row in rows[2:]:
        if len(row) != len(rows[0]):
            sys.exit(f"a row of {len(row)} cells, {len(rows[0])} are needed: {row[0]}")
        for name in re.findall(r"`(\w+)(?:::\w+)?`", row[0].split("(")[0]):
            for arithmetic, cell in zip(arithmetics, row[1:]):
                cells[name, arithmetic] = cell
    return cells, arithmetics


def compiled(headers, arithmetics):
    """The pairs that the headers declare to be compiled elsewhere."""
    pairs = set()
    for text in headers:
        for declaration in re.findall(r"extern template ([^;]*);", text):
            head = declaration.split("(")[0]
            for arithmetic in arithmetics:
                for name in re.findall(rf"(\w+)<{re.escape(arithmetic)}>$", head.strip()):
                    pairs.add((name, arithmetic))
        for name, arithmetic in re.findall(r"&\s*(\w+)::in<(.+?)>\(\) const", text):
            pairs.add((name, arithmetic))
        for arithmetic, name in re.findall(r"^(?:\[\[nodiscard\]\] )?(\w+(?:<\d+>)?) (\w+)\(", text, re.MULTILINE):
            pairs.add((name, arithmetic))
    return pairs


def main():
    root = pathlib.Path(sys.argv[1])
    cells, arithmetics = table_of((root / "lib/instantiations.md").read_text(encoding="utf-8"))
    headers = [path.read_text(encoding="utf-8") for path in sorted((root / "lib/radcert").rglob("*.h"))]
    pairs = compiled(headers, arithmetics)
    declared = "\n".join(re.sub(r"\s+", " ", text) for text in headers)
    faults = []
    for name, arithmetic in sorted(pairs):
        is_template = re.search(rf"extern template [^;(]*\b{name}<{re.escape(arithmetic)}>", declared) or \
            f"{name}::in<{arithmetic}>" in declared
        if is_template and cells.get((name, arithmetic)) != "yes":
            faults.append(f"{name} is compiled in {arithmetic}, and the table does not say so")
    own = {"Ball": {"Ball"}, "Mpfr": {"Mpfr<50>", "Mpfr<100>"}}
    for (name, arithmetic), cell in sorted(cells.items()):
        if cell == "yes" and name not in own and (name, arithmetic) not in pairs:
            faults.append(f"the table says that {name} is compiled in {arithmetic}, and no header declares it")
    if not pairs:
        faults.append("no header declares anything: the pattern is wrong")
    print("\n".join(faults) or f"{len(pairs)} pairs agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
