# SPDX-License-Identifier: GPL-3.0-or-later
# ---
# jupyter:
#   jupytext:
#     text_representation: {extension: .py, format_name: percent}
#   kernelspec: {display_name: Python 3, language: python, name: python3}
# ---

# %% [markdown]
# # A reference value into mpmath and python-flint
#
# A reference value is of use where it can be used: with all of its digits, and with its radius. This notebook takes one from
# radcert into Python's own fractions, into mpmath and into python-flint, checks it there by routes that radcert does not
# take, and computes with it without losing the proof.

# %%
from fractions import Fraction

import radcert as rc

# %% [markdown]
# ## As many digits as wanted
#
# Two unit squares with a common edge at a right angle. The value comes from two routes that share only their arithmetic.

# %%
value = rc.reference("cube_adjacent_faces", digits=50)
print(value.midpoint, "+-", value.radius)
for route in value.routes:
    print("*", route.how)
assert value.guaranteed and Fraction(value.radius) < Fraction(1, 10**50)

# %% [markdown]
# `midpoint` and `radius` are decimals that enclose the value: the radius was rounded up after the midpoint was rounded. So
# exact arithmetic may go on from there. In a cube a face sees one opposite face and four adjacent ones, hence
# $F_\text{opposite} = 1 - 4 F_\text{adjacent}$:

# %%
opposite = rc.reference("cube_opposite_faces", digits=50)
gap = Fraction(opposite.midpoint) - (1 - 4*Fraction(value.midpoint))
allowed = Fraction(opposite.radius) + 4*Fraction(value.radius)
print(f"the two enclosures differ by {float(abs(gap)):.1e}, and may by {float(allowed):.1e}")
assert abs(gap) <= allowed

# %% [markdown]
# ## mpmath
#
# `to_mpf()` is the midpoint, every bit of it, whatever `mp.prec` is at the time; `to_iv()` is an interval that contains the
# value. A check: for two unit squares with a common edge the closed form of perpendicular rectangles comes down to
#
# $$F = \frac1\pi\Bigl(\frac\pi2 - \sqrt2\,\arctan\frac1{\sqrt2} + \frac14\ln\frac34\Bigr).$$

# %%
try:
    import mpmath
except ImportError:
    mpmath = None
    print("mpmath is not there")

if mpmath:
    mpmath.mp.dps = 60
    root = mpmath.sqrt(2)
    closed = (mpmath.pi/2 - root*mpmath.atan(1/root) + mpmath.log(mpmath.mpf(3)/4)/4) / mpmath.pi
    print("mpmath ", mpmath.nstr(closed, 50))
    print("radcert", mpmath.nstr(value.to_mpf(), 50))
    assert abs(closed - value.to_mpf()) < mpmath.mpf(10)**-50

# %% [markdown]
# A closed form may have been copied from the same book. A quadrature has not: the contour integral
#
# $$F = \frac{1}{2\pi A}\oint\oint \ln r\;\mathrm d\mathbf r_1\cdot\mathrm d\mathbf r_2$$
#
# runs over pairs of parallel edges. With $g(a) = \int_0^1\!\int_0^1 \ln\sqrt{(s-t)^2 + a}\;ds\,dt
# = \int_0^1 (1-w)\ln(w^2 + a)\,dw$ for edges at the distance $\sqrt a$, the two squares need $g(0)$, $g(1)$ and $g(2)$.

# %%
if mpmath:
    mpmath.mp.dps = 30
    g = [mpmath.quad(lambda w: (1 - w)*mpmath.log(w*w + a), [0, 1]) for a in (0, 1, 2)]
    contour = (2*g[1] - g[0] - g[2]) / (2*mpmath.pi)
    print(mpmath.nstr(contour, 25))
    assert abs(contour - value.to_mpf()) < mpmath.mpf(10)**-25

# %% [markdown]
# ## Intervals
#
# An interval of mpmath keeps the proof: whatever is computed with it encloses the true result. The net heat flow between two
# black unit squares at 300 K and 400 K, in W, with $\sigma = 5.670374419\cdot10^{-8}$ as a decimal interval:

# %%
if mpmath:
    mpmath.iv.dps = 30
    sigma = mpmath.iv.mpf("5.670374419e-8")
    flow = sigma * value.to_iv() * (mpmath.iv.mpf(400)**4 - mpmath.iv.mpf(300)**4)
    print("flow from", mpmath.nstr(mpmath.mpf(flow.a), 20), "to", mpmath.nstr(mpmath.mpf(flow.b), 20))
    assert flow.delta < mpmath.mpf(10)**-24 and 198 < flow.a < 199

# %% [markdown]
# ## python-flint
#
# python-flint wraps Arb, the library of balls that radcert itself proves with. `to_arb()` is a ball that contains the value.

# %%
try:
    import flint
except ImportError:
    flint = None
    print("python-flint is not there")

if flint:
    flint.ctx.dps = 60
    ball = value.to_arb()
    arb = flint.arb
    own = (arb.pi()/2 - arb(2).sqrt()*(1/arb(2).sqrt()).atan() + (arb(3)/4).log()/4) / arb.pi()
    print(ball)
    assert ball.overlaps(own) and ball.rad() < arb(10)**-50

# %% [markdown]
# ## Plain floats
#
# `float(value)` is the nearest double, and `value.ball.bounds()` are two doubles between which the value lies.

# %%
low, high = value.ball.bounds()
print(low, high)
assert low <= float(value) <= high and high - low < 1e-16

# %% [markdown]
# ## Try next
#
# * `rc.references()` lists all names; a family takes parameters, `rc.reference("coaxial_disks", distance="1/3")`.
# * `value.to_json()` is what other programs read, every bit of midpoint and radius in it.
