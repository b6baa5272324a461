"""Contact of two elastic bodies, frictionless or sliding, by compliance and an active set.

Pressures at the singular ends are not compared: the points within 95 % of the contact count.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
from interface import Interface, division

# Cells along the contact, smallest cell as a share of it, largest cell in the bodies likewise. The
# cells are equal but for the last few per cent: where they change, the nodal pressure is rougher.
LEVELS = [(100, 1e-5, 0.1), (140, 1e-5, 0.1)]


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    levels = [full(scene, surface, c, sign, *level) for level in LEVELS]
    span = surface.range[1] - surface.range[0]
    within = lambda share: np.abs(c - np.mean(surface.range)) <= 0.5 * share * span * (1.0 + 1e-9)
    names = [("pressure_MPa", "MPa", 0, within(0.95)), ("pressure_MPa within 80 %", "MPa", 0, within(0.8)),
             ("approach_mm", "mm", 1, None), ("force_x_N", "N", 2, None)]
    found = [common.Quantity(name, unit, levels[0][i], levels[1][i], keep=keep) for name, unit, i, keep in names]
    return found, {}


def full(scene, surface, c, sign, cells, smallest, coarse):
    """(pressures at c, approach, force on body 1 along x) of a contact that starts without gap."""
    breaks = division(*surface.range, cells, smallest, 0.8)
    pair = Interface(scene, surface, breaks, coarse, sign)
    load = scene["load"]
    goal = np.array([scenes.quantity(load.get("force", 0.0)), scenes.quantity(load.get("moment", 0.0))])
    given = scenes.quantity(load["approach"]) if pair.given else None
    force, closing, _ = pair.touch(np.zeros(len(pair.c)), goal[: len(pair.modes)], given=given)
    pull = surface.normal(pair.c) + pair.friction * surface.drag(pair.c)
    return pair.at(pair.pressure(force), c), closing[0], float(force @ pull[:, 0])


if __name__ == "__main__":
    common.main(__doc__, solve)
