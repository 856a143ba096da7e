#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents of the repository: every relative link leads to a file, or to a heading, that is there, prose keeps to 120
columns and comments in sources to 110, and no document or comment cites what is not in the repository.

    python3 tests/structure/documents.py .
"""
import pathlib
import re
import sys

MOST_COLUMNS = 120
# clang-format lays out code and leaves comments as they are.
MOST_COLUMNS_OF_COMMENTS = 110
COMMENT = re.compile(r"^\s*//")
# What has grown and is not laid out anew.
ANY_WIDTH = {"CHANGELOG.md"}
# Folders of documents and sources; what is built is not looked at.
PARTS = ["apps", "lib", "papers", "tests", "verification"]
# What would send a reader to a page outside the repository.
ELSEWHERE = re.compile(r"\bdesign: |(?<![\w/])(?:cli|design|style)\.md\b|\bcontract of the command line\b|(?<![\w/])shared/\w")


def headings(text):
    """The anchors of a page's headings, as they are commonly made of their words."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE):
        words = re.sub(r"[^\w\- ]", "", heading.strip().lower())
        found.add(words.replace(" ", "-"))
    return found


def without_code(text):
    """The text with the same lines, code and output left out."""
    text = re.sub(r"^```.*?^```", lambda match: "\n" * match.group().count("\n"), text, flags=re.MULTILINE | re.DOTALL)
    return "\n".join("" if line.startswith("    ") else line for line in text.split("\n"))


def faults_of_page(root, page):
    text = page.read_text(encoding="utf-8")
    prose = without_code(text)
    name = page.relative_to(root)
    targets = re.findall(r"\]\(([^)\s]+)\)", prose) + re.findall(r"<img[^>]* src=\"([^\"]+)\"", prose)
    for target in targets:
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        # Pages of the site that are made by its build: the site's own test follows these.
        if path.endswith(".html") and "site/pages" in str(name):
            continue
        file = page if not path else page.parent / path
        if not file.exists():
            yield f"{name}: {target} is not there"
        elif anchor and anchor not in headings(file.read_text(encoding="utf-8")):
            yield f"{name}: {target}: no such heading"
    for number, line in enumerate(prose.split("\n"), 1):
        if len(line) > MOST_COLUMNS and not line.startswith("|") and page.name not in ANY_WIDTH:
            yield f"{name}:{number}: {len(line)} columns, at most {MOST_COLUMNS}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = sorted(root.glob("*.md")) + sorted(page for part in PARTS for page in (root / part).rglob("*.md"))
    pages = [page for page in pages if "node_modules" not in page.parts]
    faults = [fault for page in pages for fault in faults_of_page(root, page)]
    sources = [file for part in PARTS for ending in ("*.h", "*.cpp", "*.md") for file in (root / part).rglob(ending)]
    for file in sorted(sources):
        for number, line in enumerate(file.read_text(encoding="utf-8").split("\n"), 1):
            if ELSEWHERE.search(line):
                faults.append(f"{file.relative_to(root)}:{number}: cites what is not in the repository")
            if file.suffix != ".md" and COMMENT.match(line) and len(line) > MOST_COLUMNS_OF_COMMENTS:
                faults.append(f"{file.relative_to(root)}:{number}: {len(line)} columns, at most "
                              f"{MOST_COLUMNS_OF_COMMENTS} in comments")
    # Controls: what must be found.
    if "a-heading-of-code" not in headings("# A heading, of `code`") or not ELSEWHERE.search("Source    design: one"):
        faults.append("a pattern is wrong")
    if len(pages) < 10:
        faults.append("too few pages: they are sought in the wrong place")
    print("\n".join(faults) or f"{len(pages)} pages are in order")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
