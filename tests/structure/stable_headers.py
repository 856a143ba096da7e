#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of stable headers of lib/README.md names what radcert/all.h includes.

    python3 tests/structure/stable_headers.py .
"""
import pathlib
import re
import sys


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
    if len(included) < 20:
        faults.append("too few headers: the pattern is wrong")
    print("\n".join(faults) or f"{len(included)} headers are stable")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
