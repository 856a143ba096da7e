# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a notebook, a script with cells, as Jupyter would: what each cell prints, and what its last line shows.

    python3 notebook.py NOTEBOOK.py [OUT.json]

A cell that raises ends the run with exit code 1. The file has a list of cells, each {"kind": "text", "text": Markdown} or
{"kind": "code", "code": ..., "printed": ..., "shown": SVG or null}.
"""
import ast
import contextlib
import io
import json
import os
import pathlib
import re
import sys
import tempfile
import traceback

MARK = re.compile(r"^# %%(.*)$", re.MULTILINE)


def cells(text):
    """The cells of a script in the percent format: (whether it is text, its source)."""
    marks = list(MARK.finditer(text))
    for mark, following in zip(marks, marks[1:] + [None]):
        source = text[mark.end():following.start() if following else len(text)].strip("\n")
        if mark.group(1).strip() == "[markdown]":
            yield True, "\n".join(re.sub(r"^# ?", "", line) for line in source.split("\n"))
        else:
            yield False, source


def run_cell(source, names, place):
    """Runs a cell; gives what it printed and what its last expression shows."""
    tree = ast.parse(source, place)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed, shown = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, place, "exec"), names)  # noqa: S102
        if last is not None:
            value = eval(compile(ast.Expression(last.value), place, "eval"), names)  # noqa: S307
            if hasattr(value, "_repr_svg_"):
                shown = value._repr_svg_()
            elif value is not None:
                print(repr(value))
    return printed.getvalue(), shown


def run(notebook):
    """The cells of a notebook with what they gave."""
    names = {"__name__": "__main__"}
    out = []
    for number, (is_text, source) in enumerate(cells(notebook.read_text(encoding="utf-8")), 1):
        if is_text:
            out.append({"kind": "text", "text": source})
        elif source:
            printed, shown = run_cell(source, names, f"{notebook.name}, cell {number}")
            out.append({"kind": "code", "code": source, "printed": printed, "shown": shown})
    return out


def main():
    notebook = pathlib.Path(sys.argv[1]).resolve()
    out = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory(prefix="radcert-notebook-") as folder:
        os.chdir(folder)
        try:
            found = run(notebook)
        except Exception:  # noqa: BLE001
            traceback.print_exc()
            return 1
        finally:
            os.chdir("/")
    if out:
        out.write_text(json.dumps(found, indent=1), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
