#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers with a radius, and bounds, are printed by one function that rounds outwards: lib/radcert/scalar/enclosing_text.h, and
number_text.js of the report's page. Nothing else lays out a double in decimal.

A file that writes doubles otherwise stands in a list below, with the reason why what it writes claims no enclosure. A listed file
that no longer does so is a fault as well.
"""
import pathlib
import re
import sys

ONE_PLACE = {"lib/radcert/scalar/enclosing_text.cpp", "lib/radcert/scalar/enclosing_text.h",
             "verification/report/web/src/number_text.js"}

# Files that may use shortest(), the text that reads back as the same double.
READS_BACK = {
    "lib/radcert/core/text.h": "its declaration",
    "lib/radcert/core/text.cpp": "its definition",
    "lib/radcert/core/contract.h": "the caller's own values, in what is thrown",
    "lib/radcert/formats/json/json_value.cpp": "JSON and CSV: programs read the same doubles back",
    "lib/radcert/formats/field/unstructured_grid.cpp": "VTU: doubles that are read back, no radii",
    "lib/radcert/formats/field/ply.cpp": "PLY: doubles that are read back, no radii",
    "lib/radcert/formats/plot/plot.cpp": "ticks of a picture",
    "lib/radcert/formats/plot/svg_elements.cpp": "places of a picture",
    "lib/radcert/formats/plot/latex_plot.cpp": "places and ticks of a picture",
    "lib/radcert/formats/problem/operator.cpp": "constants that are allowed as input",
    "lib/radcert/formats/problem/quadrature.cpp": "constants that are allowed as input",
    "lib/radcert/formats/problem/solver.cpp": "constants that are allowed as input",
    "lib/radcert/certificate/check.cpp": "what a certificate claims",
    "lib/radcert/certificate/ellipsoid/ellipsoid_check.cpp": "what a certificate claims",
    "lib/radcert/formats/result/certificate_parts.cpp": "a certificate, whose means have room for it",
    "lib/radcert/factors/facet_scene.cpp": "coordinates and a length of the input",
    "lib/radcert/geometry/mesh_file/parts.cpp": "a coordinate of the input",
    "lib/radcert/hypotheses/mesh_survey.cpp": "coordinates of the input",
    "lib/radcert/visibility/scene.cpp": "coordinates of the input",
    "lib/radcert/surface/own_surface.cpp": "parameters of the input",
    "lib/radcert/meshless/sampling.cpp": "a parameter of the input",
    "lib/radcert/meshless/light_scene.cpp": "a parameter of the input",
    "lib/radcert/collocation/certified/certified_operator.cpp": "the demand of the caller",
    "lib/radcert/collocation/certified/certified_chart_entries.cpp": "the demand of the caller",
    "lib/radcert/study/collocation/operator_norm.cpp": "what is wrong with an input, no less than 1",
    "lib/radcert/study/collocation/node_data.cpp": "coordinates, and a value of the input there",
    "lib/radcert/study/meshless/meshless_level.cpp": "parameters of the input, and coordinates",
    "lib/radcert/study/collocation/level.cpp": "coordinates",
    "lib/radcert/solve/linear_solver.cpp": "the tolerance of the input",
    "lib/radcert/study/collocation/level_geometry.cpp": "a coordinate",
    "lib/radcert/surface/surface_function.h": "coordinates",
    "lib/radcert/study/collocation/matrix_form.cpp": "constants that are allowed as input, and the input",
    "lib/radcert/study/problem.cpp": "constants that are allowed as input",
    "lib/radcert/factors/input/factor_scene.cpp": "coordinates of the input",
    "lib/radcert/formats/result/factor_remarks.cpp": "the demand of the user",
    "apps/python/bindings/bases.cpp": "a place and a value of the input",
    "apps/python/bindings/exact.cpp": "what is no finite number",
    "apps/python/bindings/factors.cpp": "numbers of the input, and doubles that Python reads back",
    "apps/python/bindings/json.cpp": "what is no finite number",
    "apps/python/bindings/own_functions.cpp": "what a function has given that is no finite number",
    "apps/requests/factor_request.cpp": "the accuracy of the input",
    "apps/requests/solution_at.cpp": "coordinates of the input, and how far they are off",
    "apps/radcert/commands/surface.cpp": "coordinates of the input, and an OFF file, which is read back",
    "verification/framework/stored_finding.cpp": "a store, which is read back",
    "verification/framework/stored_number.cpp": "a store, which is read back",
    "verification/framework/finding.cpp": "the numbers of a statement, and what is not finite",
    "verification/framework/table_check.cpp": "what is not finite",
    "verification/claims/psg10/comparison.cpp": "parameters of the input",
    "verification/claims/psg10/figures/figure_6.cpp": "coefficients, without a radius",
    "verification/claims/psg10/figures/panels.h": "a parameter of the input",
}

# Files that may use std::to_chars or a string stream.
OTHER_TEXT = {
    "lib/radcert/core/text.cpp": "shortest()",
    "lib/radcert/core/memory_plan.cpp": "a file of the system, as text",
    "lib/radcert/factors/factor_matrix.cpp": "the bits of a double in base 16, for a store",
}

SPECIFICATION = re.compile(r"\{\w*:(?:[^{}\"]?[<>^])?[-+ ]?#?0?\d*(?:\.(?:\d+|\{\w*\})[aAeEfFgG]?|[aAeEfFgG])\}")
PRINTF = re.compile(r"\"[^\"]*%[-+ #0]*(?:\d+|\*)?(?:\.(?:\d+|\*))?l?[aAeEfFgG](?![a-zA-Z])")
# The radius of a transfer matrix's spectrum, and members of a structure of that name, are no bounds.
BOUND = r"(?<!spectral_)(?:radius|radii|halfwidth|half_width|error_bound|defect|uncertainty)(?![\w.])"
RULES = [
    (SPECIFICATION, "a format with digits"),
    (re.compile(r"\bchars_format\b|\bsetprecision\b|std::(?:fixed|scientific|hexfloat|defaultfloat)\b"), "a stream's or to_chars' digits"),
]
SCRIPT = re.compile(r"\b(?:toFixed|toExponential|toPrecision|toLocaleString|NumberFormat)\b")


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.DOTALL)
    return re.sub(r"(?m)(^|\s)//.*$", r"\1", text)


def call(text, start):
    """The arguments of a call whose opening parenthesis stands at start."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return text[start + 1:at]
    return text[start + 1:]


def without_text_functions(arguments):
    """Calls of functions that give text are left out: enclosing_text(...), upper_text(...), ..."""
    while match := re.search(r"\b\w*(?:_text|_words|about)(?:_below_one)?\(", arguments):
        inside = call(arguments, match.end() - 1)
        arguments = arguments[:match.start()] + arguments[match.end() + len(inside) + 1:]
    return arguments


def faults_of(name, text):
    """What a source does that it may not, as (line, what)."""
    found = []
    code = without_comments(text)

    def add(at, what):
        found.append((code.count("\n", 0, at) + 1, what))

    if name.endswith(".js"):
        for match in SCRIPT.finditer(code):
            add(match.start(), "a number as text by " + match.group())
        return found
    for rule, what in RULES:
        for match in rule.finditer(code):
            add(match.start(), what)
    for match in re.finditer(r"\b(nearest_text|std::to_string)\(", code):
        if re.search(BOUND, call(code, match.end() - 1)):
            add(match.start(), "a radius or bound by " + match.group(1))
    for match in re.finditer(r"\bdecimal\([^;]*?\)\s*\.midpoint", code):
        add(match.start(), "the midpoint of a ball without its radius")
    for match in PRINTF.finditer(code):
        if re.search(r"printf\s*\([^;]*$", code[max(0, match.start() - 200):match.start()]):
            add(match.start(), "a double by printf")
    for match in re.finditer(r"\bfmt::(?:format|print)\(", code):
        arguments = without_text_functions(re.sub(r'"(?:[^"\\]|\\.)*"', '""', call(code, match.end() - 1)))
        if re.search(r"\.(?:value|upper|lower)\b|" + BOUND, arguments):
            add(match.start(), "a number with a radius, or a bound, by {}")
    if name not in READS_BACK:
        for match in re.finditer(r"\bshortest\(", code):
            add(match.start(), "a double as the text that reads back, by shortest()")
    if name not in OTHER_TEXT:
        for match in re.finditer(r"\bto_chars\(|\bo?stringstream\b(?! lines)", code):
            add(match.start(), "text by " + match.group())
    return found


def controls():
    """Lines that must be found, and lines that must not."""
    bad = ['fmt::format("{:.1e}", row.sum.radius)', 'fmt::format("{:>12.3f} s", x)', 'fmt::format("{} at most", row.radius)',
           'fmt::format("{0:g}", x)', "std::snprintf(b, n, \"%.3e\", x)", 'std::printf("%g\\n", x)',
           "out << std::setprecision(3) << x", "std::to_chars(a, b, x, std::chars_format::scientific, 3)",
           "nearest_text(row.sum.radius, DecimalForm::general(2))", "nearest_text(bound.error_bound, form)",
           "std::to_string(radius)", "value.decimal(6).midpoint", "shortest(row.radius)", "std::ostringstream out;"]
    good = ['fmt::format("{:>3} %", text)', 'fmt::format("{} and {}", names.size(), upper_text(row.radius))',
            "enclosing_text(x.value, x.radius, form)", "nearest_text(mesh_size, DecimalForm::general(4))",
            "// {:.1e} in a comment", "std::to_string(level)"]
    faults = [f"not found: {line}" for line in bad if not faults_of("control.cpp", line)]
    faults += [f"found by mistake: {line}" for line in good if faults_of("control.cpp", line)]
    if not faults_of("control.js", "value.toFixed(2)"):
        faults.append("not found: value.toFixed(2)")
    return faults


def main():
    root = pathlib.Path(sys.argv[1])
    faults = controls()
    seen = set()
    for folder, endings in [("lib/radcert", (".h", ".cpp")), ("apps/radcert", (".h", ".cpp")), ("apps/python", (".h", ".cpp")),
                            ("apps/requests", (".h", ".cpp")), ("apps/c", (".h", ".cpp")), ("verification", (".h", ".cpp", ".js"))]:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix not in endings or "node_modules" in name:
                continue
            text = path.read_text(encoding="utf-8")
            seen.add(name)
            if name in ONE_PLACE:
                continue
            faults += [f"{name}:{line}: {what}" for line, what in faults_of(name, text)]
            code = without_comments(text)
            if name in READS_BACK and "shortest(" not in code:
                faults.append(f"{name} is listed for shortest(), and does not use it")
            if name in OTHER_TEXT and not re.search(r"to_chars\(|stringstream", code):
                faults.append(f"{name} is listed for other text, and has none")
    for name in sorted((ONE_PLACE | READS_BACK.keys() | OTHER_TEXT.keys()) - seen):
        faults.append(f"{name} is listed, and is not there")
    print("\n".join(faults) or f"{len(seen)} sources print through one function")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
