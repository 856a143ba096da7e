#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""No folder of sources has more than thirty files.

    python3 tests/structure/folders.py .
"""
import collections
import pathlib
import subprocess
import sys

MOST = 30


def main():
    root = pathlib.Path(sys.argv[1])
    listed = subprocess.run(["git", "ls-files", "lib", "apps", "tests", "verification"], cwd=root, capture_output=True,
                            text=True, check=False)
    if listed.returncode != 0:
        print("no checkout of git: folders were not counted")
        return 0
    counts = collections.Counter(str(pathlib.PurePosixPath(file).parent) for file in listed.stdout.splitlines())
    full = [f"{folder}: {count} files, at most {MOST}" for folder, count in sorted(counts.items()) if count > MOST]
    print("\n".join(full) or f"{len(counts)} folders are small")
    return 1 if full else 0


sys.exit(main())
