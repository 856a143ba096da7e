# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     text_representation: {extension: .py, format_name: percent}
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # My view factors against proof
#
# A configuration factor (view factor, form factor) $F_{ij}$ is the part of the light that leaves surface $i$ evenly in all
# directions and arrives at surface $j$:
#
# $$F_{ij} = \frac{1}{\pi A_i}\int_{A_i}\int_{A_j}
#   \frac{\cos\theta_i\cos\theta_j}{|P-Q|^2}\,V(P,Q)\,dA_j\,dA_i .$$
#
# Many programs compute them. This notebook holds factors of a program, here a small Monte Carlo of our own, against factors
# whose radii are proved: which of our numbers are right, which are wrong, and of which can that not be said?

# %%
import numpy as np
import radcert as rc

# %% [markdown]
# ## A room as arrays
#
# Points, triangles that count them from 0, and a name for each triangle. Light travels where the corners run
# counterclockwise. The room is 4 x 3 x 2.5.

# %%
points = np.array([(x, y, z) for x in (0, 4) for y in (0, 3) for z in (0, 2.5)])
quads = {"west": (0, 2, 3, 1), "east": (4, 5, 7, 6), "south": (0, 1, 5, 4),
         "north": (2, 6, 7, 3), "floor": (0, 4, 6, 2), "ceiling": (1, 3, 7, 5)}
triangles = [t for a, b, c, d in quads.values() for t in ((a, b, c), (a, c, d))]
names = [name for name in quads for _ in range(2)]
room = rc.Mesh((points, triangles, names))

# %% [markdown]
# ## Factors with a proof
#
# `certified=True` means that each radius is a theorem: $|F_{ij} - \text{value}| \le \text{radius}$, rounding included.

# %%
F = room.factors(by="group", certified=True)
print(F.names)
print(F.value.round(6))
print("largest radius below 1e-12:", F.radius.max() < 1e-12, " proved:", F.guaranteed)
assert F.guaranteed and F.radius.max() < 1e-12

# %% [markdown]
# Three laws hold for every closed scene, and are the first thing to try on factors of any program: rows sum to 1 (closure),
# $A_i F_{ij} = A_j F_{ji}$ (reciprocity), and no factor is negative.

# %%
exchange = F.area.value[:, None] * F.value
print("rows sum to 1 to 1e-12:  ", np.abs(F.value.sum(axis=1) - 1).max() < 1e-12)
print("reciprocity to 1e-12:    ", np.abs(exchange - exchange.T).max() < 1e-12)
assert (F.closure <= F.row_sum.radius).all()

# %% [markdown]
# The laws are necessary and not sufficient. What settles a factor is a second route: two perpendicular rectangles with a
# common edge have a closed form, and the factor from floor to east wall must be that value.

# %%
known = rc.reference("perpendicular_rectangles", edge=3, from_width=4, to_width="5/2", digits=20)
i, j = F.names.index("floor"), F.names.index("east")
print(f"matrix {F.value[i, j]:.15f}")
print(f"value  {known.midpoint}")
assert abs(F.value[i, j] - float(known)) <= F.radius[i, j] + 1e-16

# %% [markdown]
# ## Factors of our own
#
# Points spread evenly over a face, directions by Lambert's law, and a count of where the rays arrive. With $N$ rays the
# standard error of a factor is $\sqrt{F(1-F)/N}$.

# %%
def monte_carlo(rays, seed):
    random = np.random.default_rng(seed)
    low, high = np.zeros(3), np.array([4, 3, 2.5])
    sides = {"west": (0, 0), "east": (0, 1), "south": (1, 0), "north": (1, 1), "floor": (2, 0), "ceiling": (2, 1)}
    out = np.zeros((6, 6))
    for row, name in enumerate(F.names):
        axis, upper = sides[name]
        start = random.uniform(low, high, (rays, 3))
        start[:, axis] = (low, high)[upper][axis]
        sine, turn = np.sqrt(random.random(rays)), 2*np.pi*random.random(rays)
        direction = np.empty((rays, 3))
        direction[:, axis] = np.sqrt(1 - sine**2) * (-1 if upper else 1)
        direction[:, (axis + 1) % 3] = sine * np.cos(turn)
        direction[:, (axis + 2) % 3] = sine * np.sin(turn)
        with np.errstate(divide="ignore"):
            distance = (np.where(direction > 0, high, low) - start) / direction
        distance[:, axis] = high[axis] / np.abs(direction[:, axis])
        hit = distance.argmin(axis=1)
        for column, other in enumerate(F.names):
            along, end = sides[other]
            out[row, column] = np.mean((hit == along) & ((direction[:, along] > 0) == bool(end)))
    return out


rays = 200_000
mine = monte_carlo(rays, seed=7)
error = np.sqrt(F.value * (1 - F.value) / rays)
print("largest difference in standard errors:", (np.abs(mine - F.value) / np.where(error > 0, error, 1)).max().round(1))

# %% [markdown]
# `compare` decides pair by pair. `halfwidth` is how far our numbers may be from what they stand for, here four standard
# errors. A verdict is `agrees` where every number within both radii does, `differs` where none does.

# %%
comparison = F.compare(mine, halfwidth=4 * error.max())
print(comparison.counts())
assert comparison.agrees

# %% [markdown]
# ## A mistake
#
# A wrong number that looks right is the worst of all. We exchange two factors of a row: no row sum tells.

# %%
wrong = mine.copy()
a, b = F.names.index("west"), F.names.index("south")
wrong[i, a], wrong[i, b] = wrong[i, b], wrong[i, a]
print("row sums still 1:", np.allclose(wrong.sum(axis=1), 1))
comparison = F.compare(wrong, halfwidth=4 * error.max())
for pair in comparison.differing:
    print(f"{pair.from_} to {pair.to}: proved {pair.ours:.5f}, theirs {pair.theirs:.5f}: {pair.verdict}")
assert {(pair.from_, pair.to) for pair in comparison.differing} == {("floor", "west"), ("floor", "south")}

# %% [markdown]
# ## Try next
#
# * `F.compare("factors.csv")` reads from, to, factor, a matrix with names about it, or the output of View3D.
# * `rc.Mesh("building.stl").factors(by="group")` for a mesh of your own; `rays=True` for thousands of triangles.
# * Where parts hide each other nothing changes but the time: the last notebook has a table in the room.
