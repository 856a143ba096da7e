# SPDX-License-Identifier: GPL-3.0-or-later
"""What the site tells of radcert that only Python can read: the module itself, the claims, the reference values.

    python3 collect.py CHECKOUT OUT.json [--quick]

PYTHONPATH is where the module is. --quick leaves out the digits of values that take seconds.
"""
import ast
import inspect
import json
import pathlib
import re
import sys
import tomllib

import radcert

# Families whose routes are cubatures, and solutions whose certificates are checked: seconds each.
SLOW = ("continuous_", "sphere_power", "sphere_z", "_total", "two_squares_", "near_the_")
DIGITS = 30
# As the package itself abbreviates them.
ALIASES = (("Union[str, ForwardRef('os.PathLike[str]')]", "Path"), ("str, ForwardRef('os.PathLike[str]')", "Path"),
           ("Union[NoneType, bool, Path]", "Store"), ("Union[None, bool, Path]", "Store"), ("Optional[Callable[[float, str], Any]]", "Listener"))


def signature(function):
    """A signature with the types as they are written."""
    try:
        text = str(inspect.signature(function))
    except (TypeError, ValueError):
        return None
    text = re.sub(r"\b(?:typing|fractions|radcert|_core|expression|basis|edge|numbers|guarantee|factors|problem|mesh|surfaces|"
                  r"verification)\.", "", text.replace("numpy.", "np."))
    for long, short in ALIASES:
        text = text.replace(long, short)
    return text


def members_of_stub(node):
    """The members of a class of the compiled part, as its stubs have them."""
    for member in node.body:
        if isinstance(member, ast.FunctionDef) and (not member.name.startswith("_") or member.name == "__init__"):
            is_property = any(ast.unparse(each) == "property" for each in member.decorator_list)
            returns = ast.unparse(member.returns) if member.returns else "None"
            call = "" if is_property else f"({ast.unparse(member.args)})"
            yield {"name": member.name, "signature": f"{call} -> {returns}", "doc": ""}
        elif isinstance(member, ast.AnnAssign):
            yield {"name": ast.unparse(member.target), "signature": f": {ast.unparse(member.annotation)}", "doc": ""}


def members_of_class(kind):
    for name, value in vars(kind).items():
        if name.startswith("_"):
            continue
        if isinstance(value, property):
            yield {"name": name, "signature": (signature(value.fget) or "()")[len("(self)"):], "doc": inspect.getdoc(value) or ""}
        elif callable(getattr(kind, name)):
            yield {"name": name, "signature": signature(getattr(kind, name)), "doc": inspect.getdoc(value) or ""}


def python_module():
    """The public names of the package, each with its members."""
    stubs = pathlib.Path(radcert.__file__).with_name("_core.pyi").read_text(encoding="utf-8")
    compiled = {node.name: node for node in ast.parse(stubs).body if isinstance(node, ast.ClassDef)}
    shown = {name: value for name, value in vars(radcert).items() if not name.startswith("_") and not inspect.ismodule(value)}
    # Types that users are given and do not make.
    for name in ("Route", "FactorPair", "Statement", "BasisFacts"):
        shown.setdefault(name, getattr(radcert._core, name))
    for name in ("Proved", "OfEmission"):
        shown.setdefault(name, getattr(radcert.guarantee, name))
    shown["Picture"] = radcert.problem.Picture
    for name, value in sorted(shown.items(), key=lambda item: item[0].lower()):
        if name in ("Callable", "surface_function"):
            continue
        if not inspect.isclass(value):
            yield {"name": name, "kind": "function" if inspect.isroutine(value) else "value",
                   "signature": signature(value) if inspect.isroutine(value) else None, "doc": inspect.getdoc(value) or "",
                   "members": []}
            continue
        if value.__module__.startswith("radcert._core") or name in compiled and value.__module__ == "radcert":
            node = compiled[name]
            yield {"name": name, "kind": "exception" if issubclass(value, BaseException) else "class", "signature": None,
                   "doc": inspect.getdoc(value) or "", "members": list(members_of_stub(node))}
        else:
            kind = "exception" if issubclass(value, BaseException) else "class"
            yield {"name": name, "kind": kind, "signature": None if kind == "exception" else signature(value),
                   "doc": inspect.getdoc(value) or "", "members": list(members_of_class(value))}


def papers(checkout):
    """The statements of each paper in their order."""
    for folder in sorted((checkout / "papers").iterdir()):
        if not (folder / "claims.toml").exists():
            continue
        claims = tomllib.loads((folder / "claims.toml").read_text(encoding="utf-8"))
        yield {"key": folder.name, "claims": [{"label": label, **{key: entry[key] for key in entry
                                              if not isinstance(entry[key], dict) or key == "verdict"}}
                                              for label, entry in claims.items()]}


def values(quick):
    """The named reference values with their digits, and the families with their parameters."""
    for entry in radcert.references():
        entry = json.loads(json.dumps(entry, default=str))
        if quick and any(part in entry["name"] for part in SLOW) or entry["name"] == "sphere_over_disk":
            yield entry
            continue
        is_mean = entry["name"].startswith("continuous_")
        found = radcert.reference(entry["name"], None if is_mean else DIGITS).to_json()
        yield {**entry, "value": {key: found[key] for key in (
            "midpoint", "radius", "guaranteed", "formula", "source", "routes", "route_values", "parameters")}}


def main():
    checkout, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    facts = {"version": radcert.__version__, "python": list(python_module()), "papers": list(papers(checkout)),
             "references": list(values("--quick" in sys.argv)), "surfaces": radcert.surfaces()}
    out.write_text(json.dumps(facts, indent=1, default=str), encoding="utf-8")


if __name__ == "__main__":
    main()
