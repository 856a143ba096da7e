#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of stable headers of lib/README.md names what radcert/all.h includes, and what stands in a namespace `detail` is
used by its own layer alone.

    python3 tests/structure/stable_headers.py .
"""
import pathlib
import re
import sys


def uses_of_detail(root):
    """Where code names the namespace `detail` of a layer from outside of that."""
    layers = {path.name for path in (root / "lib" / "radcert").iterdir() if path.is_dir()
              and any("namespace detail" in each.read_text(encoding="utf-8") for each in path.rglob("*.h"))}
    for folder in ("lib/radcert", "apps", "verification"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp") or "node_modules" in path.parts:
                continue
            layer = path.relative_to(root / folder).parts[0] if folder == "lib/radcert" else None
            if layer not in layers and re.search(r"(?<!py::)\bdetail::", path.read_text(encoding="utf-8")):
                yield f"{path.relative_to(root)} uses a namespace detail, which is for its own layer"


def main():
    library = pathlib.Path(sys.argv[1]) / "lib"
    included = set(re.findall(r'^#include "radcert/(.+)"$', (library / "radcert" / "all.h").read_text(encoding="utf-8"),
                              re.MULTILINE))
    page = (library / "README.md").read_text(encoding="utf-8")
    table = page.split("| layer | headers |", 1)[1].split("\n\n", 1)[0]
    named = {f"{layer}/{header}" for layer, cell in re.findall(r"^\| `(\w+)` \| (.+) \|$", table, re.MULTILINE)
             for header in re.findall(r"`([^`]+)`", cell)}
    faults = [f"lib/README.md leaves out {header}" for header in sorted(included - named)]
    faults += [f"radcert/all.h does not include {header}" for header in sorted(named - included)]
    faults += uses_of_detail(library.parent)
    if len(included) < 20:
        faults.append("too few headers: the pattern is wrong")
    print("\n".join(faults) or f"{len(included)} headers are stable")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
