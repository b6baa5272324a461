"""Temperatures of a contact under the wanted pressure, the displacements they make, and the cold gap.

Congruent bodies with a share or a conductance; a ring that revolves under body 1 with a share or a finite conductance:
its temperature is even along its circle, fed by the mean of its heat along the whole of it; fresh body 2.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import dolfinx.fem.petsc as fem_petsc
import numpy as np
import scene as scenes
import ufl
from body import form
from conduction import Conductor, beside_ring, matching_body, temperatures
from gap import respond
from interface import division

# Cells along the contact, smallest cell as a share of it, largest cell in the bodies likewise. Curved edges need smaller
# cells: their cubic geometry is the coarser part.
LEVELS = {"curved": [(24, 1e-6, 0.06), (34, 1e-6, 0.045)], "straight": [(24, 1e-6, 0.12), (34, 1e-6, 0.085)]}
SLOPE = 0.4
DEGREE = 4


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    pressure = scenes.Pressure(scene, surface)
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    levels = [hot(scene, surface, pressure, c, sign, *level) for level in LEVELS["straight" if surface.radius is None else "curved"]]
    rigid = [phi(c) for phi, _ in pressure.modes]
    names = [("temperature1_degC", "degC", ()), ("temperature2_degC", "degC", ()), ("heat1_mW_mm2", "mW/mm^2", ()),
             ("heat2_mW_mm2", "mW/mm^2", ()), ("unth1_um", "um", rigid), ("unth2_um", "um", ()), ("gap_um", "um", rigid),
             ("friction_power_mW", "mW", ()), ("into_body1_mW", "mW", ()), ("into_body2_mW", "mW", ())]
    found = [common.Quantity(name, unit, levels[0][name], levels[1][name], modes) for name, unit, modes in names if name in levels[0]]
    return found, {"coordinate": c.tolist(), "multipliers": pressure.multipliers.tolist()}


def hot(scene, surface, pressure, c, sign, cells, smallest, coarse):
    """All quantities of one level by name."""
    breaks = division(*surface.range, cells, smallest, SLOPE)
    bodies, contacts = zip(*(matching_body(scene, surface, k, breaks, coarse, DEGREE) for k in (1, 2)))
    meeting = scene["heat"].get("counterface") or scene.get("wear", {}).get("counterface", "congruent")
    pair, fields, found = conduct(scene, surface, pressure, bodies, contacts, meeting)
    at, n = surface.point(c), surface.normal(c)
    normal = []
    for number, body in enumerate(bodies):
        along = lambda u: np.sum(body.points(u, at, contacts[number]) * n, axis=1) * 1e3
        elastic, _ = respond(scene, surface, pressure, c, sign, number + 1, body, contacts[number])
        thermal = np.zeros(len(c))
        if fields[number] is not None:
            thermal = along(body.solve(thermal_load(scene, body, scene[f"body{number + 1}"], fields[number])))
            found[f"temperature{number + 1}_degC"] = body.points(fields[number], at, contacts[number])[:, 0]
        found[f"unth{number + 1}_um"] = thermal
        normal.append(np.sum(elastic * n, axis=1) * 1e3 + thermal)
    found["gap_um"] = normal[1] - normal[0]
    local_heat(scene, surface, pressure, c, found)
    return found


def conduct(scene, surface, pressure, bodies, contacts, meeting):
    """(conductors, fields of temperature or none, powers by name)."""
    split, conductance = scene["heat"].get("share"), scene["heat"].get("conductance")
    conductance = None if conductance is None else scenes.quantity(conductance)
    edges = scene["contact"]["edges"]
    depth = 2.0 * math.pi if surface.axisymmetric else surface.thickness
    covered = 0.0
    if meeting == "revolving":
        covered = (surface.range[1] - surface.range[0]) / (2.0 * math.pi)
    pair = [Conductor(body, scene[f"body{k + 1}"], edges[k], contacts[k], 1.0 - covered if k == 1 else 1.0)
            for k, body in enumerate(bodies)]
    shares = (split, 1.0 - split) if conductance is None else (0.5, 0.5)
    sources = [one.heat(share * friction_heat(surface, pressure, one.body), one.contact) for one, share in zip(pair, shares)]
    power = sum(float(np.sum(source)) for source in sources)
    if meeting == "revolving" and conductance is None:
        circle = 2.0 * math.pi * surface.radius
        sources[1] = pair[1].heat(float(np.sum(sources[1])) / circle, bodies[1].tags(edges[1]))
    nodes = [one.in_order(surface) for one in pair]
    into_ring = None
    if meeting == "revolving" and conductance is not None:
        values, into_ring = beside_ring(pair, sources, conductance, bodies[1].tags(edges[1]))
    elif meeting == "fresh":
        if conductance is not None:
            raise ValueError("a fresh body 2 is known here with a share alone")
        values = temperatures(pair[:1], nodes, sources[:1], None) + [None]
    else:
        values = temperatures(pair, nodes, sources, conductance)
    fields = [None if v is None else one.field(v) for one, v in zip(pair, values)]
    found = {"friction_power_mW": depth * power}
    if conductance is None:
        into = [shares[0] * power, shares[1] * power]
    else:
        rest = [one.matrix @ v - one.own for one, v in zip(pair, values)]
        into = [float(np.sum(r[node])) for r, node in zip(rest, nodes)]
        into[1] = into[1] if into_ring is None else into_ring
    for number, heat in enumerate(into):
        found[f"into_body{number + 1}_mW"] = depth * heat
    return pair, fields, found


def friction_heat(surface, pressure, body):
    """mu p v, mW/mm^2, as an expression."""
    if surface.axisymmetric and surface.omega is not None:
        rubbed = body.number(surface.friction * abs(surface.omega)) * body.x[0]
    else:
        rubbed = body.number(surface.friction * float(surface.sliding_speed(np.zeros(1))[0]))
    return rubbed * pressure.field(ufl, body.x, body.number)


def local_heat(scene, surface, pressure, c, found):
    """Heat into both bodies at the points; none by an infinite conductance, where it is singular at the ends."""
    heat, conductance = surface.friction * pressure(c) * surface.sliding_speed(c), scene["heat"].get("conductance")
    if conductance is None:
        found["heat1_mW_mm2"] = scene["heat"]["share"] * heat
        found["heat2_mW_mm2"] = (1.0 - scene["heat"]["share"]) * heat
    elif not math.isinf(scenes.quantity(conductance)):
        across = scenes.quantity(conductance) * (found["temperature2_degC"] - found["temperature1_degC"])
        found["heat1_mW_mm2"], found["heat2_mW_mm2"] = 0.5 * heat + across, 0.5 * heat - across


def thermal_load(scene, body, part, temperature):
    """int C : alpha (T - T_r) (1, 1, 1) : strain(v), the third direction being free in plane stress."""
    expansion = scenes.quantity(part["material"]["expansion"])
    hindered = 1.0 - body.poisson if body.kinematics == "plane-stress" else 1.0 - 2.0 * body.poisson
    reference = body.number(scenes.quantity(scene["heat"].get("reference", 20.0)))
    stress = body.number(body.young * expansion / hindered) * (temperature - reference)
    v = ufl.TestFunction(body.space)
    volume = ufl.div(v) + (v[0] / body.x[0] if body.axisymmetric else 0.0)
    return fem_petsc.assemble_vector(form(stress * volume * body.weight() * body.dx)).array.copy()


if __name__ == "__main__":
    common.main(__doc__, solve)
