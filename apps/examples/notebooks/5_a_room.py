# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     text_representation: {extension: .py, format_name: percent}
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # A room, its factors, its radiosity, its picture
#
# A room of 4 m x 3 m x 2.5 m with a table in it, whose ceiling shines. From the corners of the room to a picture of its
# light, with a check at each step that the numbers are right.

# %%
import numpy as np
import radcert as rc

# %% [markdown]
# ## The room as a mesh
#
# A box seen from inside, and a table top seen from outside. Corners run counterclockwise as seen from where the light is.

# %%
points, triangles, names = [], [], []
sides = {"west": (0, 2, 3, 1), "east": (4, 5, 7, 6), "south": (0, 1, 5, 4),
         "north": (2, 6, 7, 3), "floor": (0, 4, 6, 2), "ceiling": (1, 3, 7, 5)}


def add_box(low, high, inside, name=None):
    first = len(points)
    points.extend((x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2]))
    for side, corners in sides.items():
        a, b, c, d = (first + corner for corner in (corners if inside else corners[::-1]))
        triangles.extend([(a, b, c), (a, c, d)])
        names.extend([name or side] * 2)


add_box((0, 0, 0), (4, 3, 2.5), inside=True)
add_box((1.25, 1, 0.75), (2.75, 2, 0.875), inside=False, name="table")
room = rc.Mesh((np.array(points), triangles, names))
for group in room.groups:
    print(f"{group.name:8} {group.area:7.4f} m2")
assert abs(sum(group.area for group in room.groups) - (2*(12 + 10 + 7.5) + 2*1.5 + 2*0.125*(1.5 + 1))) < 1e-12

# %% [markdown]
# ## Its factors
#
# $F_{ij}$ is the part of the light from $i$ that arrives at $j$. The table hides parts of the room from each other; what is
# seen is cut out exactly. In a closed room every row sums to 1.

# %%
F = room.factors(by="group", accuracy=1e-4)
i, j = F.names.index("floor"), F.names.index("ceiling")
print(f"floor to ceiling {F.value[i, j]:.4f}, without the table 0.2921")
print("rows sum to 1 within 1e-4:", bool((np.abs(F.value.sum(axis=1) - 1) < 1e-4).all()))
assert F.value[i, j] < 0.2921 - 0.01 and (np.abs(F.value.sum(axis=1) - 1) < 1e-4).all()

# %% [markdown]
# ## A first answer from factors alone
#
# If every group had one radiosity $B_i$, it would satisfy $B_i = E_i + \rho_i\sum_j F_{ij}B_j$. This is what zonal programs
# compute.

# %%
rho = np.array([{"floor": 0.3, "ceiling": 0.8}.get(name, 0.5) for name in F.names])
emission = np.array([1.0 if name == "ceiling" else 0.0 for name in F.names])
lumped = np.linalg.solve(np.eye(len(rho)) - rho[:, None] * F.value, emission)
print({name: round(float(b), 3) for name, b in zip(F.names, lumped)})

# %% [markdown]
# ## Radiosity as a function
#
# In truth $u$ varies over each face: under the table it is dark. radcert solves
# $u - \frac{\rho}{\pi}\int_S G\,V\,u\,dS = E$ by collocation, refining the mesh.

# %%
problem = rc.Problem(room, reflectivity={"floor": "0.3", "ceiling": "0.8", "*": "1/2"}, emission={"ceiling": 1, "*": 0},
                     levels=[0, 1, 2])
found = problem.solve()
for piece in ("floor", "ceiling", "west", "table_5", "table_6"):
    print(f"{piece:8}", found.means[piece].value.round(4))

# %% [markdown]
# The two faces `table_5` and `table_6` are the bottom and the top of the table: the lumped answer gave both the same value.
# A check that needs no other program is the balance of power: what the ceiling emits is absorbed somewhere,
#
# $$\sum_i A_i E_i = \sum_i \frac{1-\rho_i}{\rho_i} A_i\,(\bar u_i - E_i).$$

# %%
area = {piece.name: piece.area for piece in room.pieces}
share = {piece: {"floor": 0.3, "ceiling": 0.8}.get(piece, 0.5) for piece in area}
shines = {piece: 1.0 if piece == "ceiling" else 0.0 for piece in area}
absorbed = sum((1 - share[p]) / share[p] * area[p] * (found.means[p].value[-1] - shines[p]) for p in area)
print(f"emitted {area['ceiling']:.4f} W, absorbed {absorbed:.4f} W")
assert abs(absorbed - area["ceiling"]) < 0.005 * area["ceiling"]
assert found.means["table_6"].value[-1] > 5 * found.means["table_5"].value[-1]

# %% [markdown]
# ## Its picture
#
# Faces are seen from their lit side alone, so that a camera outside looks into the room. The scale ends at 0.4, and the
# ceiling is not in the picture.

# %%
found.picture(position=(-4.5, -4, 4.2), look_at=(2, 1.5, 0.9), angle=0.62, size=(720, 540), low=0, high=0.4)

# %% [markdown]
# ## Try next
#
# * `rc.Mesh("room.stl")`, `.obj`, `.gltf`: a room of your own; `room.survey()` says what is wrong with it.
# * `found.to_vtu("room.vtu")` opens in ParaView.
# * `problem.guarantee("0.2")` proves means of $u$ itself, also where parts hide each other; it takes minutes for a room
#   with a table, seconds for an empty one.
