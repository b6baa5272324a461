"""A ball or cylinder pressed on a flat, by compliance and an active set.

The conditions stand on the flat side, as in the scene: n = e_z, gap R - sqrt(R^2 - x^2), pressure
per area of body 2. The contact's end and the largest pressure come from p^2 as a polynomial of x^2.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
from interface import Interface

# Cells over 2.4 contact half-widths, largest cell in the bodies as a share of those.
LEVELS = [(90, 1.5), (140, 1.0)]


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    guess = narrow(scene, surface)
    c = np.asarray(points["x_mm"])
    levels = []
    for level in LEVELS:
        pair, p, largest, width = press(scene, surface, sign, *level)
        levels.append((pair.at(p, c), largest, width))
    inner = np.abs(c) <= 0.95 * levels[1][2]
    if surface.axisymmetric:
        inner &= c >= 0.05 * levels[1][2]
    names = [("pressure_MPa", "MPa", inner), ("p_max_MPa", "MPa", None), ("half_width_mm", "mm", None)]
    found = [common.Quantity(name, unit, levels[0][i], levels[1][i], keep=keep)
             for i, (name, unit, keep) in enumerate(names)]
    return found, {"hertz_half_width_mm": guess}


def narrow(scene, surface):
    """Leaves 1.2 times Hertz' half-width of the surface, which is returned."""
    guess = half_width(scene, surface)
    surface.range = (0.0 if surface.axisymmetric else -1.2 * guess, 1.2 * guess)
    return guess


def half_width(scene, surface):
    """Hertz' half-width on half-spaces: where to put the nodes."""
    (e1, nu1), (e2, nu2) = (scenes.material(scene[f"body{i}"]) for i in (1, 2))
    modulus = 1.0 / ((1.0 - nu1**2) / e1 + (1.0 - nu2**2) / e2)
    force = scenes.quantity(scene["load"]["force"])
    if surface.axisymmetric:
        return (0.75 * force * surface.ball / modulus) ** (1.0 / 3.0)
    return math.sqrt(4.0 * force / surface.thickness * surface.ball / (math.pi * modulus))


def press(scene, surface, sign, cells, coarse):
    """(the pair, nodal pressures, largest pressure, half-width of the contact)."""
    if surface.axisymmetric:
        cells //= 2
    breaks = np.linspace(*surface.range, cells + 1)
    pair = Interface(scene, surface, breaks, coarse, sign, grade=False)
    goal = np.array([scenes.quantity(scene["load"]["force"])])
    force, _, _ = pair.touch(surface.initial_gap(pair.c), goal)
    p = pair.pressure(force)
    end = np.max(np.abs(pair.c[force > 0.0]))
    use = (np.abs(pair.c) < 0.9 * end) & (pair.weight > 0.0)
    fit = np.polynomial.Polynomial.fit(pair.c[use] ** 2, p[use] ** 2, 3)
    roots = fit.roots()
    real = roots[np.abs(roots.imag) < 1e-9 * end**2].real
    width = math.sqrt(real[np.argmin(np.abs(real - end**2))])
    return pair, p, math.sqrt(fit(0.0)), width


if __name__ == "__main__":
    common.main(__doc__, solve)
