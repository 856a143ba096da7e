#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene of section VIII of psg10 by piecewise collocation, against the reference.

    apps/bench/sphere_over_disk.py --sphere 2 --rings 16 --degree 0

Writes meshes of sphere and disk, of the same areas as these, lets `radcert solve` solve the equation on them with the light
that is scattered once as emission, and compares with `radcert reference sphere_over_disk`. Errors are root mean squares by
area, over 300 points a triangle, of the total radiance. With 8 or 16 rings one ends at the shadow's rim.
"""
import argparse
import bisect
import csv
import json
import math
import os
import subprocess
import tempfile

RADIUS, DISK_RADIUS, HEIGHT = 5.0, 40.0, 20.0
INSET = 1 / 6
SAMPLE = 23  # 24 * 25 / 2 = 300 points


def sphere(subdivisions):
    """Triangles of a sphere from an octahedron, counterclockwise from outside, scaled to its area."""
    vertices = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = []
    for a, b in ((0, 2), (2, 1), (1, 3), (3, 0)):
        triangles += [(a, b, 4), (b, a, 5)]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                p = [s + t for s, t in zip(vertices[a], vertices[b])]
                vertices.append(tuple(x / math.hypot(*p) for x in p))
                middles[key] = len(vertices) - 1
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    scale = math.sqrt(4 * math.pi / sum(area([vertices[v] for v in t]) for t in triangles))
    return [tuple(RADIUS * scale * x for x in v) for v in vertices], triangles


def disk(rings):
    """Triangles of a disk in rings of equal width, 6, 12, 18, ... sides, counterclockwise from above, each of its circle's area."""
    vertices, triangles, inner = [(0.0, 0.0, 0.0)], [], [0]
    for k in range(1, rings + 1):
        sides = 6 * k
        step = 2 * math.pi / sides
        radius = DISK_RADIUS * k / rings * math.sqrt(step / math.sin(step))
        outer = list(range(len(vertices), len(vertices) + sides))
        vertices += [(radius * math.cos(j * step), radius * math.sin(j * step), 0.0) for j in range(sides)]
        if len(inner) == 1:
            triangles += [(0, outer[j], outer[(j + 1) % sides]) for j in range(sides)]
        else:
            a = b = 0
            while a < len(inner) or b < sides:
                if b < sides and (a == len(inner) or (b + 1) * len(inner) <= (a + 1) * sides):
                    triangles.append((inner[a % len(inner)], outer[b], outer[(b + 1) % sides]))
                    b += 1
                else:
                    triangles.append((inner[a], outer[b % sides], inner[(a + 1) % len(inner)]))
                    a += 1
        inner = outer
    return vertices, triangles


def area(corners):
    u = [q - p for p, q in zip(corners[0], corners[1])]
    v = [q - p for p, q in zip(corners[0], corners[2])]
    return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2


def scene(subdivisions, rings):
    """Corners of all triangles, sphere first; light is on the side that their cross products point away from."""
    ball, skin = sphere(subdivisions)
    floor, tiles = disk(rings)
    ball = [(x, y, z + HEIGHT) for x, y, z in ball]
    inward = [(a, c, b) for a, b, c in skin]
    downward = [(a + len(ball), c + len(ball), b + len(ball)) for a, b, c in tiles]
    return ball + floor, inward + downward


# 81/100 of the light's cosine where it arrives: above on the sphere, beyond the shadow's rim on the disk.
EMISSION = ("81/100*max(0, (z-20)/sqrt(x^2 + y^2 + (z-20)^2)) * (1 + (z-10)/abs(z-10))/2"
            " + 81/100*(1 + (x^2 + y^2 - 25)/abs(x^2 + y^2 - 25))/2 * (1 - (z-10)/abs(z-10))/2")


def solve(program, folder, vertices, triangles, degree):
    with open(os.path.join(folder, "scene.off"), "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        file.writelines("%.17g %.17g %.17g\n" % v for v in vertices)
        file.writelines("3 %d %d %d\n" % t for t in triangles)
    basis = {"family": "inset", "degree": degree, **({"alpha": "1/6"} if degree else {})}
    problem = {"schema": "radcert/problem/1", "surface": {"file": "scene.off", "angle": 60},
               "triangulation": {"levels": [0]}, "basis": basis, "reflectivity": "9/10", "emission": EMISSION,
               "quadrature": {"tolerance": "1e-6"}}
    with open(os.path.join(folder, "problem.json"), "w", encoding="utf-8") as file:
        json.dump(problem, file)
    environment = {**os.environ, "RADCERT_STORE": folder}
    done = subprocess.run([program, "solve", "problem.json", "--nodes", "nodes.csv", "--json", "-", "--quiet"],
                          cwd=folder, env=environment, check=True, capture_output=True)
    timing = json.loads(done.stdout)["timing"]["levels"][0]
    values = {}
    with open(os.path.join(folder, "nodes.csv"), encoding="utf-8") as file:
        for row in csv.DictReader(file):
            point = tuple(float(row[axis]) for axis in "xyz")
            values.setdefault(int(row["element"]), []).append((point, float(row["u_n"])))
    return values, timing["assembly_seconds"] + timing["solve_seconds"]


def curves(program, folder):
    """B by latitude and D by distance, linear between 2001 points."""
    subprocess.run([program, "reference", "sphere_over_disk", "--curve", "curve.csv", "--points", "2001", "--quiet"],
                   cwd=folder, check=True, capture_output=True)
    tables = {"B": [], "D": []}
    with open(os.path.join(folder, "curve.csv"), encoding="utf-8") as file:
        for row in csv.DictReader(file):
            tables[row["curve"]].append((float(row["place"]), float(row["total"])))

    def value(name, place):
        table = tables[name]
        k = min(max(bisect.bisect_right(table, (place, math.inf)), 1), len(table) - 1)
        (p, f), (q, g) = table[k - 1], table[k]
        return g if p == q else f + (g - f) * min(1, (place - p) / (q - p))

    return value


def at_corners(corners, nodes):
    """The nodes' values in the order of the corners that they are next to."""
    middle = [sum(node[axis] for node, _ in nodes) / len(nodes) for axis in range(3)]
    centroid = [sum(corner[axis] for corner in corners) / 3 for axis in range(3)]
    if math.dist(middle, centroid) > 1e-9 * DISK_RADIUS:
        raise ValueError("the elements of nodes.csv are not in the order of the mesh")
    if len(nodes) == 1:
        return [nodes[0][1]]
    return [min(nodes, key=lambda node: math.dist(node[0], corner))[1] for corner in corners]


def squares(corners, nodal, truth):
    """The mean of the squared error over a triangle; the nodes are the middle, or pulled in from the corners by the inset."""
    total, count = 0.0, 0
    for i in range(SAMPLE + 1):
        for j in range(SAMPLE + 1 - i):
            x = [(i + 1 / 3) / (SAMPLE + 1), (j + 1 / 3) / (SAMPLE + 1)]
            x.append(1 - x[0] - x[1])
            p = [sum(w * corner[axis] for w, corner in zip(x, corners)) for axis in range(3)]
            u = nodal[0]
            if len(nodal) == 3:
                u = sum((w - INSET) / (1 - 3 * INSET) * value for w, value in zip(x, nodal))
            if p[2] > HEIGHT / 2:
                z = p[2] - HEIGHT
                right = truth("B", math.asin(max(-1, min(1, z / math.hypot(p[0], p[1], z)))))
            else:
                right = truth("D", min(DISK_RADIUS, math.hypot(p[0], p[1])))
            total += (u - right) ** 2
            count += 1
    return total / count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--radcert", default="radcert", help="the program")
    parser.add_argument("--sphere", type=int, default=2, help="how often the octahedron is subdivided")
    parser.add_argument("--rings", type=int, default=16, help="rings of the disk")
    parser.add_argument("--degree", type=int, choices=[0, 1], default=0)
    given = parser.parse_args()
    vertices, triangles = scene(given.sphere, given.rings)
    with tempfile.TemporaryDirectory() as folder:
        values, seconds = solve(given.radcert, folder, vertices, triangles, given.degree)
        truth = curves(given.radcert, folder)
    sums = {"sphere": [0.0, 0.0, 0], "disk": [0.0, 0.0, 0]}
    for k, triangle in enumerate(triangles):
        corners = [vertices[v] for v in triangle]
        part = sums["sphere" if corners[0][2] > HEIGHT / 2 else "disk"]
        part[0] += area(corners) * squares(corners, at_corners(corners, values[k]), truth)
        part[1] += area(corners)
        part[2] += 1
    unknowns = sum(len(nodal) for nodal in values.values())
    print(f"degree {given.degree}, {unknowns} unknowns, {seconds:.2f} s")
    for name, (square, size, count) in sums.items():
        print(f"{name}: {count} triangles, root mean square error {math.sqrt(square / size):.5f}")


if __name__ == "__main__":
    main()
