"""A shaft in its bush or housing with clearance, by compliance and an active set.

Both arcs are drawn with one radius R, and the gap is that of circles of radii R and R + c that touch at the top, along the normal of the shaft. A
solution on the whole arc says where the contact ends, about; then nodes stand on that part and a little more. The ends are the roots of p^2, and the
largest pressure that of a polynomial through p^2 around it.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
from interface import Interface

# Cells along the contact and a little more; largest cell in the bodies as a share of that.
LEVELS = [(140, 0.07), (200, 0.06)]
FIRST = (60, 0.08)
# How far the nodes reach beyond the contact, as a share of it.
MORE = 0.06
# The part of the contact at an end, as shares of it, whose pressures tell the end.
NEAR_END = (0.012, 0.08)


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    _, _, _, (low, high) = press(scene, surface, sign, *FIRST)
    more = MORE * (high - low)
    surface.range = (low - more, high + more)
    levels = []
    for level in LEVELS:
        pair, p, largest, ends = press(scene, surface, sign, *level)
        levels.append((pair.at(p, c), largest, surface.radius * ends[0], surface.radius * ends[1]))
    low, high = (end / surface.radius for end in levels[1][2:])
    inner = np.abs(c - 0.5 * (low + high)) <= 0.475 * (high - low)
    names = [("pressure_MPa", "MPa", inner), ("p_max_MPa", "MPa", None), ("first_end_mm", "mm", None), ("last_end_mm", "mm", None)]
    found = [common.Quantity(name, unit, levels[0][i], levels[1][i], keep=keep) for i, (name, unit, keep) in enumerate(names)]
    return found, {"half_angle_deg": math.degrees(0.5 * (high - low))}


def gap(surface, clearance, c):
    """Distance (mm) of the circles R and R + clearance along the normal of the inner one, zero at the top."""
    outer = surface.radius + clearance
    return np.sqrt(outer**2 - (clearance * np.sin(c)) ** 2) - clearance * np.cos(c) - surface.radius


def breaks(low, high, cells):
    """Nearly equal cells with a break point at the top, where the outline of a circle has one."""
    before = round(cells * -low / (high - low))
    return np.concatenate([np.linspace(low, 0.0, before + 1), np.linspace(0.0, high, cells - before + 1)[1:]])


def press(scene, surface, sign, cells, coarse):
    """(the pair, nodal pressures, largest pressure, ends of contact as angles)."""
    pair = Interface(scene, surface, breaks(*surface.range, cells), coarse, sign, grade=False)
    clearance = scenes.quantity(scene["contact"]["clearance"])
    goal = np.array([scenes.quantity(scene["load"]["force"])])
    force, _, _ = pair.touch(gap(surface, clearance, pair.c), goal)
    p = pair.pressure(force)
    touched = pair.c[force > 0.0]
    low, high = float(touched.min()), float(touched.max())
    span = high - low
    ends = [root(pair.c, p, low, span, 1.0), root(pair.c, p, high, span, -1.0)]
    top = pair.c[np.argmax(p)]
    use = np.abs(pair.c - top) < 0.08 * span
    fit = np.polynomial.Polynomial.fit(pair.c[use], p[use] ** 2, 4)
    around = np.linspace(top - 0.04 * span, top + 0.04 * span, 2001)
    return pair, p, math.sqrt(float(np.max(fit(around)))), ends


def root(c, p, end, span, inwards):
    """The root of p^2 next to a contact's end."""
    depth = inwards * (c - end) / span
    use = (depth > NEAR_END[0]) & (depth < NEAR_END[1])
    fit = np.polynomial.Polynomial.fit(depth[use], p[use] ** 2, 3)
    real = [r.real for r in fit.roots() if abs(r.imag) < 1e-9]
    return end + inwards * span * min(real, key=abs)


if __name__ == "__main__":
    common.main(__doc__, solve)
