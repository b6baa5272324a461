"""Wear in time by explicit Euler steps on the same compliance as contact.py.

Each step solves the contact of the worn surfaces and removes w'(p) dt. The step is a share of the
stability bound: the least 2 Re(l)/|l|^2 over the eigenvalues of the linearised wear operator.
"""

import os
import sys
from dataclasses import dataclass

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
from interface import Interface

# Cells along the contact, largest cell in the bodies as a share of it, share of the stable step.
LEVELS = [(44, 0.1, 0.8), (64, 0.08, 0.8)]
MOST_STEPS = 20000
STEADY = 1e-6


class Rule:
    """Sum of the wear rates of both bodies in the gap, mm/s: sum_i factor_i (mu (p - p0_i))^b_i v^a_i above p0_i."""

    def __init__(self, scene, surface):
        wear = scene["wear"]
        name = "beta" if "beta" in wear else "k"
        factor = wear[name] if isinstance(wear[name], list) else [wear[name], 0.0]
        self.factor = [scenes.quantity(f) for f in factor]
        if wear.get("counterface") == "fresh":
            self.factor[1] = 0.0
        elif wear.get("counterface") == "revolving" and self.factor[1] != 0.0:
            raise ValueError("a revolving counter-face that wears is not known here")
        self.a, self.b = scenes.pair(wear.get("a", 1.0)), scenes.pair(wear.get("b", 1.0))
        self.threshold = scenes.pair(wear.get("threshold", 0.0))
        if name == "beta":
            self.factor = [f * surface.friction**b for f, b in zip(self.factor, self.b)]

    def rate(self, p, v):
        return sum(f * np.maximum(p - p0, 0.0) ** b * v**a for f, a, b, p0 in self.terms())

    def slope(self, p, v):
        def one(f, a, b, p0):
            over = np.where(p > p0, p - p0, 1.0)
            return np.where(p > p0, f * b * over ** (b - 1.0) * v**a, 0.0)

        return sum(one(*term) for term in self.terms())

    def terms(self):
        return zip(self.factor, self.a, self.b, self.threshold)


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    if scene["contact"].get("gap", 0) not in (0, 0.0):
        raise ValueError("only a start without gap is known here")
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    levels = [evolve(scene, surface, c, sign, *level) for level in LEVELS]
    span = surface.range[1] - surface.range[0]
    inner = np.abs(c - np.mean(surface.range)) <= 0.475 * span * (1.0 + 1e-9)
    rigid = [phi(c) for phi, _ in scenes.modes(scene, surface)]
    gap = [level[0] * 1e3 for level in levels]
    found = [common.Quantity("gap_um", "um", gap[0], gap[1], rigid),
             common.Quantity("gap_um within 95 %", "um", gap[0], gap[1], rigid, keep=inner),
             common.Quantity("pressure_MPa", "MPa", levels[0][1], levels[1][1], keep=inner),
             common.Quantity("volume_mm3", "mm^3", levels[0][2], levels[1][2])]
    return found, {"steps": [level[3] for level in levels], "time_s": [level[4] for level in levels]}


def evolve(scene, surface, c, sign, cells, coarse, share):
    """(gap, pressure at c, worn volume, steps, time) at the end of the run."""
    pair = Interface(scene, surface, np.linspace(*surface.range, cells + 1), coarse, sign, grade=False)
    until = scene["wear"].get("until", "steady")
    end = np.inf if until == "steady" else scenes.quantity(until)
    for state in steps(scene, surface, pair, share, end):
        if state.time >= end or (state.residual <= STEADY and end == np.inf):
            break
    return pair.at(state.gap, c), pair.at(state.pressure, c), state.volume, state.step, state.time


@dataclass
class State:
    """The worn pair after some steps: gap (mm) and pressure at the nodes, distance from the steady state."""

    step: int
    time: float
    gap: np.ndarray
    pressure: np.ndarray
    volume: float
    residual: float


def steps(scene, surface, pair, share, end=np.inf):
    """States of an explicit run from a closed start, at most to the time `end`."""
    rule, v = Rule(scene, surface), surface.sliding_speed(pair.c)
    load = scene["load"]
    goal = np.array([scenes.quantity(load["force"]), scenes.quantity(load.get("moment", 0.0))])[: len(pair.modes)]
    phi = np.column_stack([m[0](pair.c) for m in pair.modes])
    psi = np.column_stack([m[1](pair.c) for m in pair.modes])
    root = np.sqrt(pair.weight)
    gap, active = np.zeros(len(pair.c)), None
    time, volume = 0.0, 0.0
    for step in range(MOST_STEPS):
        force, _, active = pair.touch(gap, goal, active)
        p = pair.pressure(force)
        rate = rule.rate(p, v)
        rest = rate - phi @ np.linalg.lstsq(phi * root[:, None], rate * root, rcond=None)[0]
        yield State(step, time, gap, p, volume, np.linalg.norm(rest * root) / np.linalg.norm(rate * root))
        length = min(share * stable_step(pair, phi, psi, active, rule.slope(p, v)), end - time)
        gap = gap + length * rate
        volume += length * float(pair.weight @ rate)
        time += length
    raise ValueError(f"no end after {MOST_STEPS} steps, {time} s")


def stable_step(pair, phi, psi, active, slope):
    """Largest stable explicit step, s: d gap' = slope / weight * (d force / d gap) d gap."""
    a = np.flatnonzero(active)
    k = phi.shape[1]
    matrix = np.block([[pair.compliance[np.ix_(a, a)], -phi[a]], [psi[a].T, np.zeros((k, k))]])
    scale = np.abs(matrix[: len(a), : len(a)]).max()
    matrix[len(a):, :] *= scale
    stiffness = np.linalg.inv(matrix)[: len(a), : len(a)]
    values = np.linalg.eigvals((slope[a] / pair.weight[a])[:, None] * stiffness)
    values = values[np.abs(values) > 1e-9 * np.abs(values).max()]
    return float(np.min(2.0 * values.real / np.abs(values) ** 2))


if __name__ == "__main__":
    common.main(__doc__, solve)
