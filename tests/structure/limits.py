#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lib/limits.md names the limits of work that the sources of the library and of the claims define, and no others.

That the rows say what the limits say, and that each is lowered, test_limits sees; here none is missed for not being linked.
"""
import pathlib
import re
import sys


def main():
    root = pathlib.Path(sys.argv[1])
    defined = set()
    faults = []
    sources = [(path, base) for base in (root / "lib/radcert", root / "verification/claims")
               for path in sorted(base.rglob("*.cpp"))]
    for path, base in sources:
        text = path.read_text(encoding="utf-8")
        place = path.relative_to(base).with_suffix("").as_posix()
        for name in re.findall(r'const WorkLimit \w+\(\s*"([^"]*)"', text):
            defined.add(name)
            # A limit of a header without a source of its own is defined in another source of the layer.
            if name.split(":")[0].split("/")[0] != place.split("/")[0]:
                faults.append(f"{name} is defined in {place}.cpp")
    table = (root / "lib/limits.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\| `([^`]*)` \|", table, re.MULTILINE))
    faults += [f"{name} is not in lib/limits.md" for name in sorted(defined - listed)]
    faults += [f"{name} is in lib/limits.md and in no source" for name in sorted(listed - defined)]
    if not defined:
        faults.append("no source defines a limit: the pattern is wrong")
    print("\n".join(faults) or f"{len(defined)} limits agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
