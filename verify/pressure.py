"""The wanted pressure and what it costs, from the formulas by Gauss quadrature alone."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
from wear import Rule


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    pressure = scenes.Pressure(scene, surface)
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    p = pressure(c)
    rate = Rule(scene, surface).rate(p, surface.sliding_speed(c)) * 1e3
    found = [common.Quantity("pressure_MPa", "MPa", p, p), common.Quantity("wear_rate_um_per_s", "um/s", rate, rate)]
    coarse, fine = (costs(scene, surface, pressure, sign, count) for count in (100, 200))
    found += [common.Quantity(name, "", coarse[name], fine[name]) for name in fine]
    return found, {"multipliers": pressure.multipliers.tolist()}


def costs(scene, surface, pressure, sign, count):
    """Wear volume rate, friction power, wear power, torque about the drum's or disc's axis."""
    c, w = surface.rule(count)
    p, v = pressure(c), surface.sliding_speed(c)
    rate = Rule(scene, surface).rate(p, v)
    power = sign * surface.friction * v * p
    found = {
        "wear_volume_rate_mm3_per_s": np.sum(w * rate),
        "friction_power_mW": np.sum(w * power),
        "wear_power_mW": np.sum(w * rate * p),
    }
    if surface.omega is not None:
        found["torque_Nmm"] = np.sum(w * power) / abs(surface.omega)
    return found


if __name__ == "__main__":
    common.main(__doc__, solve)
