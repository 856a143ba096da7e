#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the libraries show to a linker: in the static ones nothing outside the namespace radcert that could clash with a
name of somebody else's, and nothing that a shared object would show; in a shared one the names that match a pattern alone.

    python3 tests/structure/symbols.py FOLDER_OF_ARCHIVES [SHARED_OBJECT PATTERN]...
"""
import pathlib
import re
import subprocess
import sys

# A name of the namespace radcert as compilers mangle it, its tables of types and guards included.
OURS = re.compile(r"^_Z(T[VISTC]|GVN?|GR|Z|N|K|O|R|L)*7radcert")


def defined(file, *options):
    """Binding, visibility and name of each symbol that a file defines for others."""
    done = subprocess.run(["readelf", "-W", *options, str(file)], capture_output=True, text=True, check=True)
    for line in done.stdout.splitlines():
        words = line.split()
        if len(words) >= 8 and words[0].rstrip(":").isdigit() and words[4] != "LOCAL" and words[6] != "UND":
            yield words[4], words[5], words[7].split("@")[0]


def faults_of_archive(file):
    for binding, visibility, name in defined(file, "--syms"):
        # Weak are inline functions and templates, those of std and boost too, of which a program keeps one.
        if binding != "GLOBAL":
            continue
        if visibility == "DEFAULT":
            yield f"{file.name}: {name} is not hidden"
        if not OURS.match(name):
            yield f"{file.name}: {name} is outside radcert"


def faults_of_shared(file, pattern):
    names = list(defined(file, "--dyn-syms"))
    if not names:
        yield f"{file}: shows nothing"
    for binding, _, name in names:
        if not re.fullmatch(pattern, name) and (binding == "GLOBAL" or "7radcert" in name):
            yield f"{file}: shows {name}"


def main():
    folder, *rest = sys.argv[1:]
    archives = sorted(pathlib.Path(folder).glob("libradcert_*.a"))
    faults = [fault for file in archives for fault in faults_of_archive(file)]
    for file, pattern in zip(rest[::2], rest[1::2]):
        faults += faults_of_shared(file, pattern)
    if len(archives) < 20:
        faults.append("too few archives: they are sought in the wrong place")
    if OURS.match("_ZN4CGAL7radcertE") or not OURS.match("_ZNK7radcert4Ball8midpointEv"):
        faults.append("the pattern is wrong")
    print("\n".join(faults) or f"{len(archives)} archives and {len(rest) // 2} shared objects are in order")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
