# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     text_representation: {extension: .py, format_name: percent}
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # An experiment with a basis of my own, and its LaTeX
#
# Which functions and which nodes on a triangle are best? This notebook designs a basis with one parameter, lets radcert
# decide exactly what it can do, runs it against known ones on equal terms, and ends with a table for a paper.

# %%
import json
import pathlib
import tempfile

import radcert as rc

# %% [markdown]
# ## A space and its nodes
#
# Linear functions, and the bubble $x_1x_2x_3$, which vanishes on the sides of the triangle: four functions of the barycentric
# coordinates. Four nodes belong to them: the centroid, and the three nodes $(1-2a, a, a)$ and its rotations.

# %%
x1, x2, x3 = rc.barycentric()


def bubble(a):
    return rc.Basis(space=[x1, x2, x3, x1*x2*x3], nodes=[(rc.Q(1, 3),) * 3, *rc.orbit(rc.Q(a))], label=f"bubble {a}")


print(bubble("1/5").nodes)

# %% [markdown]
# ## Which parameter?
#
# The order at the nodes depends on the degree of precision of the rule that integrates the interpolant. It is decided in
# rational numbers, so that "degree 3" means that all cubic polynomials are integrated exactly, not nearly.

# %%
for a in ("0", "1/10", "1/6", "1/5", "1/4"):
    basis = bubble(a)
    print(f"a = {a:4}  precision {basis.precision['triangle']}, order at the nodes {basis.orders['nodes']}, "
          f"weights {[str(w) for w in basis.weights]}")
assert bubble("1/5").precision["triangle"] == 3
assert [str(w) for w in bubble("1/5").weights] == ["-9/32", "25/96", "25/96", "25/96"]

# %% [markdown]
# $a = 1/5$ stands out: the rule is exact for cubic functions with four nodes. It is a classical rule, whose weight at the
# centroid is negative. Precision is not everything: the norm of interpolation tells how errors are amplified.

# %%
for basis in (rc.inset(1, "1/6"), bubble("1/5")):
    print(f"{basis.label:28} norm of interpolation {basis.to_json()['bases'][0]['norm']['upper']:.2f}")

# %% [markdown]
# ## Irrational nodes
#
# Nodes may be zeros of polynomials. Radon's seven nodes have $\sqrt{15}$ in them, which stays the root that it is: the proof
# of degree 5 is algebraic.

# %%
r = rc.sqrt(15)
radon = rc.Basis(space=[x1, x2, x3, x1*x2, x2*x3, x3*x1, 27*x1*x2*x3],
                 nodes=[(rc.Q(1, 3),) * 3, *rc.orbit((6 - r)/21), *rc.orbit((6 + r)/21)], label="Radon")
print(radon.precision)
assert radon.precision["triangle"] == 5 and radon.precision["proof"] == "algebraic"

# %% [markdown]
# ## The experiment
#
# An experiment solves problems that differ in a few parts, here the basis, with everything else equal. Own nodes are files,
# as other programs would write them.

# %%
folder = pathlib.Path(tempfile.mkdtemp())
third, fifth = "1/3", "1/5"
nodes = {"schema": "radcert/nodes/1", "space": ["x1", "x2", "x3", "x1*x2*x3"],
         "nodes": [[third] * 3] + [[fifth] * place + ["3/5"] + [fifth] * (2 - place) for place in range(3)]}
(folder / "bubble.json").write_text(json.dumps(nodes))
(folder / "experiment.json").write_text(json.dumps({
    "schema": "radcert/experiment/1", "name": "bubble",
    "base": {"surface": {"name": "two_piece", "p": 2}, "triangulation": {"levels": [0, 1, 2, 3]},
             "reflectivity": "1/2", "solution": "exp(x/2 + y/3 - z/4)"},
    "vary": {"basis": [{"family": "inset", "degree": 1, "alpha": "1/6"}, {"file": "bubble.json"},
                       {"family": "symmetric", "degree": 2}]}}))
found = rc.experiment(folder / "experiment.json")
for name, solution in zip(found.names, found.solutions):
    print(f"{name:24} {solution.unknowns[-1]:5} unknowns, error at the nodes {solution.errors['node_error'].value[-1]:.2e}, "
          f"orders {solution.eoc('node_error')[1:].round(2)}")

# %% [markdown]
# The order of the bubble is 4, as `orders` predicts, and so is that of linear functions at $\alpha = 1/6$: on two triangles that
# form a parallelogram their rule was exact for cubic functions already. The bubble's error is somewhat smaller, for a third
# more unknowns. Quadratic functions gain an order.

# %%
linear, own, quadratic = found.solutions
assert abs(linear.eoc("node_error")[-1] - 4) < 0.2 and abs(own.eoc("node_error")[-1] - 4) < 0.2
assert quadratic.eoc("node_error")[-1] > 4.8
assert own.errors["node_error"].value[-1] < linear.errors["node_error"].value[-1]

# %% [markdown]
# ## A table for a paper
#
# The radius of each error stands behind its digits, and the observed orders beside them. It compiles with booktabs and
# siunitx.

# %%
found.solutions[1].to_latex(folder / "bubble.tex")
table = (folder / "bubble.tex").read_text()
print(table)
assert table.count("\\\\") > 5 and "\\bottomrule" in table

# %% [markdown]
# ## Try next
#
# * `found.to_latex("all.tex")` is one table of all bases; `found.to_csv("all.csv")` every level of each.
# * `rc.Basis("nodes.json")` reads the file that was written above.
# * `radcert experiment experiment.json --out folder` writes plots against the mesh size, unknowns and seconds.
