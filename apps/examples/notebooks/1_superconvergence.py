# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     text_representation: {extension: .py, format_name: percent}
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # Superconvergence in ten minutes
#
# The radiosity equation on a surface $S$ without occlusion is
#
# $$u(P) - \frac{\rho(P)}{\pi}\int_S G(P,Q)\,u(Q)\,dS_Q = E(P),\qquad
#   G(P,Q) = \frac{[(Q-P)\cdot n_P]\,[(P-Q)\cdot n_Q]}{|P-Q|^4},$$
#
# in short $(I-K)u = E$. Collocation looks for a function $u_n$, linear on each triangle of a triangulation, for which
# the equation holds at the nodes. In general $u_n$ is as far from $u$ as interpolation is, $O(h^2)$. Atkinson and Chandler
# have shown that on a smooth surface it is much closer **at the nodes**, if the nodes stand at the right place. This
# notebook shows the effect, and what it rests on.

# %%
import numpy as np
import radcert as rc

# %% [markdown]
# ## A problem whose solution is known
#
# We choose $u$ and let radcert compute the emission $E = u - Ku$, by a route that shares nothing with the method under
# test. So every error is known, and comes with a radius of its own. Numbers given as texts are exact.

# %%
x, y, z = rc.xyz()
problem = rc.Problem(rc.ellipsoid(1, "3/4", "1/2"), reflectivity="1/2", solution=rc.exp(x/2 + y/3 - z/4),
                     levels=range(4), solver="gmres")

# %% [markdown]
# ## Two places for the nodes
#
# Linear functions need three nodes a triangle. They stand at the barycentric distance $\alpha$ from the sides:
# $(1-2\alpha, \alpha, \alpha)$ and its rotations. Interpolation at these nodes is of the order 2, whatever $\alpha$ is.

# %%
tenth = problem.replace(basis=rc.inset(1, "1/10")).solve()
sixth = problem.replace(basis=rc.inset(1, "1/6")).solve()
for name, found in (("alpha = 1/10", tenth), ("alpha = 1/6", sixth)):
    print(name)
    print("  unknowns           ", found.unknowns)
    print("  max error anywhere ", found.errors["uniform_error"].value.round(5))
    print("  max error at nodes ", found.errors["node_error"].value.round(7))

# %% [markdown]
# Away from the nodes both are alike: the error is divided by four when $h$ is halved. At the nodes they are not.

# %%
print("order at the nodes, alpha = 1/10:", tenth.eoc("node_error")[1:].round(2))
print("order at the nodes, alpha = 1/6: ", sixth.eoc("node_error")[1:].round(2))
assert abs(tenth.eoc("node_error")[-1] - 2) < 0.1
assert sixth.eoc("node_error")[-1] > 3.5
assert sixth.errors["node_error"].value[-1] < tenth.errors["node_error"].value[-1] / 50

# %% [markdown]
# The errors against the mesh size. The triangles have the fitted orders.

# %%
sixth.plot(title="alpha = 1/6")

# %% [markdown]
# ## Why 1/6
#
# The error at a node is $K(I-P_n)u$ there: an integral of an interpolation error. Where the kernel is smooth this integral
# is small if the rule that integrates the interpolant is exact for more than the interpolant itself. radcert decides the
# degree of precision exactly, in rational numbers.

# %%
for alpha in ("0", "1/10", "1/6", "1/4"):
    basis = rc.inset(1, alpha)
    print(f"alpha = {alpha:4}  precision {basis.precision['triangle']} on a triangle, "
          f"{basis.precision['parallelogram']} on two that form a parallelogram")
assert rc.inset(1, "1/6").precision == {"triangle": 2, "parallelogram": 3, "proof": "exact"}

# %% [markdown]
# Of all $\alpha$ it is $1/6$ alone that gives degree 2. On two triangles that together form a parallelogram the rule is
# exact for cubic functions too, since odd parts cancel. Symmetric refinement makes nearly all triangles such pairs, and the
# error at the nodes falls like $h^4 |\log h|$: Theorem 3.7 of the paper. What theory predicts for a basis is a property of
# it:

# %%
print(rc.inset(1, "1/6").orders)
assert rc.inset(1, "1/6").orders["nodes"] == 4 and rc.inset(1, "1/10").orders["nodes"] == 2

# %% [markdown]
# ## Where it ends
#
# The gain needs a kernel that is smooth near the node. On a cube, nodes near an edge see the neighbouring face at a short
# distance, and the orders are 2 for both (`orders["edges"]`).

# %%
cube = rc.Problem("cube", reflectivity="1/2", solution=x*y + z, levels=range(4), basis=rc.inset(1, "1/6")).solve()
print(cube.eoc("node_error")[1:].round(2))
assert abs(cube.eoc("node_error")[-1] - 2) < 0.2

# %% [markdown]
# ## The statement itself
#
# Theorem 3.7 is an entry of radcert's verification of the paper, with a check in code and a verdict that must come out
# again in every run. A row of the paper's first table takes a second:

# %%
report = rc.verify("ac98/table_1.alpha_1_6.n4")
for statement in report.statements:
    print(statement.name, statement.verdict, statement.printed)
report.assert_as_recorded()

# %% [markdown]
# ## Try next
#
# * `rc.symmetric(2)`, quadratic functions at symmetric nodes, converges like $h^5$ at the nodes.
# * `problem.replace(solver="verified", levels=[0, 1])` proves the errors; it takes minutes on an ellipsoid.
# * A basis of your own is the subject of the third notebook.
