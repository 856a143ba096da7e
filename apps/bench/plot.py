#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots and summarises what radcert_bench has measured.

    radcert_bench --benchmark_out=bench.json --benchmark_out_format=json --benchmark_repetitions=5
    apps/bench/plot.py bench.json [--svg bench.svg]

Prints the ratios that README.md beside it quotes (medians of the repetitions, all of one run) and, with --svg, draws the rates of
the kernel and of the entries by distance. Drawing needs matplotlib (Debian: python3-matplotlib).
"""
import argparse
import json
import statistics
import sys
from collections import defaultdict


def read_runs(path):
    """The median of every figure of every benchmark, by its name."""
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    figures = defaultdict(lambda: defaultdict(list))
    for run in document["benchmarks"]:
        if run.get("run_type") == "aggregate":
            continue
        seconds_per_unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[run["time_unit"]]
        name = run["run_name"]
        figures[name]["seconds"].append(run["real_time"] * seconds_per_unit)
        for key, value in run.items():
            if key in COUNTERS:
                figures[name][key].append(value)
    return {name: {key: statistics.median(values) for key, values in by_key.items()}
            for name, by_key in figures.items()}


COUNTERS = {"flops", "evaluations", "entries", "points_per_entry", "unknowns", "assembly", "operator", "solve",
            "bytes_per_unknown"}


def arguments_of(name):
    """The arguments of a benchmark, {'degree': 1, ...}, from a name like entries/degree:1."""
    return {part.split(":")[0]: int(part.split(":")[1]) for part in name.split("/") if ":" in part}


def kernel_share(run, runs, threads):
    """How the far evaluations of G an assembly makes a second compare with the kernel's own rate."""
    kernel = runs.get("kernel/functions:3", {}).get("evaluations")
    if not kernel or "evaluations" not in run:
        return ""
    return f", at least {100 * run['evaluations'] / (threads * kernel):.0f} % of the kernel's own rate"


def summary(runs):
    lines = []
    peak = runs.get("multiply_add_peak", {}).get("flops")
    if peak:
        lines.append(f"multiply-add peak of one core: {peak / 1e9:.1f} Gflop/s")
    for name, run in runs.items():
        if name.startswith("kernel/") and peak:
            lines.append(f"{name}: {run['evaluations'] / 1e9:.2f}e9 evaluations of G a second, "
                         f"{100 * run['flops'] / peak:.0f} % of the peak")
    for name, run in sorted(runs.items()):
        if "entries/" in name:
            points = f", {run['points_per_entry']:.1f} points an entry" if "points_per_entry" in run else ""
            lines.append(f"{name}: {run['entries'] / 1e6:.2f}e6 entries a second{points}")
    plain = {name.split("/")[1]: run for name, run in runs.items() if name.startswith("plain_assembly/")}
    for name, run in sorted(runs.items()):
        if name.startswith("assembly/"):
            subject = name.split("/")[1]
            ratio = f", {plain[subject]['seconds'] / run['seconds']:.0f} times the plain program" if subject in plain else ""
            rate = kernel_share(run, runs, arguments_of(name).get("threads", 1))
            lines.append(f"{name}: {run['seconds']:.3f} s, {run['entries'] / 1e6:.1f}e6 entries a second{rate}{ratio}")
        if name.startswith("plain_assembly/"):
            lines.append(f"{name}: {run['seconds']:.3f} s, {run['entries'] / 1e6:.2f}e6 entries a second")
        if name.startswith("study/"):
            lines.append(f"{name}: {run['seconds']:.3f} s (assembly {run['assembly']:.3f}, Ku {run['operator']:.3f}, "
                         f"solution {run['solve']:.3f}), {run['bytes_per_unknown']:.0f} bytes an unknown")
    return lines


def draw(runs, path):
    try:
        import matplotlib
    except ImportError:
        sys.exit("plot.py: drawing needs matplotlib (Debian: python3-matplotlib); the summary above does not")
    matplotlib.use("svg")
    from matplotlib import pyplot

    figure, (by_distance, by_tolerance) = pyplot.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for kind, style in (("plane_entries", "-o"), ("curved_entries", "--s")):
        for degree, colour in ((0, "tab:blue"), (1, "tab:orange"), (2, "tab:green"), (4, "tab:red")):
            points = sorted((arguments_of(name)["tenths_of_radius"] / 10, run["entries"]) for name, run in runs.items()
                            if name.startswith(kind) and arguments_of(name)["degree"] == degree
                            and arguments_of(name)["digits"] == 13)
            if points:
                by_distance.loglog(*zip(*points), style, color=colour, label=f"{kind.split('_')[0]}, degree {degree}")
        for digits, colour in ((6, "tab:cyan"), (10, "tab:purple"), (13, "tab:orange")):
            points = sorted((arguments_of(name)["tenths_of_radius"] / 10, run["points_per_entry"])
                            for name, run in runs.items() if name.startswith(kind) and "points_per_entry" in run
                            and arguments_of(name)["degree"] == 1 and arguments_of(name)["digits"] == digits)
            if points:
                by_tolerance.loglog(*zip(*points), style, color=colour, label=f"{kind.split('_')[0]}, 1e-{digits}")
    by_distance.set(xlabel="distance in radii of the element", ylabel="entries a second, one core",
                    title="entries to 1e-13")
    by_tolerance.set(xlabel="distance in radii of the element", ylabel="evaluations of G an entry",
                     title="points an entry, degree 1")
    for axes in (by_distance, by_tolerance):
        axes.grid(True, which="both", linewidth=0.3)
        axes.legend(fontsize=7)
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("measurements", help="JSON written by radcert_bench")
    parser.add_argument("--svg", help="draw the rates into this file")
    arguments = parser.parse_args()
    runs = read_runs(arguments.measurements)
    print("\n".join(summary(runs)))
    if arguments.svg:
        draw(runs, arguments.svg)


if __name__ == "__main__":
    main()
