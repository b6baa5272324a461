"""The gap that leaves two bodies just touching under wanted tractions, by dolfinx.

Each body is solved by itself under p n + mu p tau (body 2: the opposite) and its loads;
g = (u2 - u1) . n, up to the free rigid motion of body 1.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import common
import numpy as np
import scene as scenes
import ufl
from body import Body, Torsion
from mesh import centre_line, mark, outline, split, triangulate

# Largest cell as a share of the contact, smallest cell likewise, slope of the grading. Curved
# edges need smaller cells: their cubic geometry is the coarser part.
LEVELS = {"curved": [(0.06, 1e-6, 0.25), (0.045, 1e-6, 0.25)], "straight": [(0.2, 1e-6, 0.4), (0.14, 1e-6, 0.3)]}
DEGREE = 4


def solve(scene, points, sign):
    surface = scenes.Surface(scene)
    pressure = scenes.Pressure(scene, surface)
    c = surface.coordinate(points["x_mm"], points["z_mm"])
    off = np.max(np.hypot(*(surface.point(c) - np.column_stack([points["x_mm"], points["z_mm"]])).T))
    if off > 1e-9 * (surface.radius or surface.range[1]):
        raise ValueError(f"a sample point lies {off} mm off the surface")
    levels = [displacements(scene, surface, pressure, c, sign, *level) for level in LEVELS["straight" if surface.radius is None else "curved"]]
    n = surface.normal(c)
    rigid = [phi(c) for phi, _ in pressure.modes]
    normal = [np.sum((u2 - u1) * n, axis=1) * 1e3 for u1, u2, _, _ in levels]
    found = [common.Quantity("pressure_MPa", "MPa", pressure(c), pressure(c)),
             common.Quantity("gap_um", "um", normal[0], normal[1], rigid),
             common.Quantity("jump_um", "um", normal[0], normal[1])]
    if levels[0][2] is not None:
        turn = [(u1 - u2) * 1e3 for _, _, u1, u2 in levels]
        found.append(common.Quantity("uphi_um", "um", turn[0], turn[1]))
    extra = {"coordinate": c.tolist(), "multipliers": pressure.multipliers.tolist()}
    return found, extra


def displacements(scene, surface, pressure, c, sign, size, sharp_size, slope):
    """(u1, u2, u_phi1, u_phi2) at the points c, mm."""
    span = surface.range[1] - surface.range[0]
    span *= surface.radius or 1.0
    grading = (size * span, sharp_size * span, slope)
    found = []
    for number in (1, 2):
        body, tags = build(scene, surface, number, grading)
        found.append(respond(scene, surface, pressure, c, sign, number, body, tags))
    (u1, t1), (u2, t2) = found
    return u1, u2, t1, t2


def build(scene, surface, number, grading, degree=DEGREE, near=None):
    """Body 1 or 2 on a graded mesh, with its supports; and the tags of its contact segments.
    `near`: largest cell along the contact, when smaller than elsewhere."""
    part = scene[f"body{number}"]
    template, values = scenes.geometry(part)
    ends = [tuple(surface.point(c)) for c in surface.range]
    breaks = ends + (load_ends(scene, surface) if number == 1 else [])
    loops = split(outline(template, values, surface.axisymmetric), breaks)
    mark(loops, scene["contact"]["edges"][number - 1], lambda x, z: contact_middle(surface, x, z))
    corners = {s.a for loop in loops for s in loop if template != "ring"} | set(ends)
    cut = centre_line(template, values) if "centre" in part.get("support", {}) else None
    if cut is not None:
        loops = split(loops, [cut.a, cut.b])
        corners |= {cut.a, cut.b}
    mesh, facets, segments = triangulate(loops, grading[0], 3, sorted(corners), grading[1], grading[2], cut=cut, near=near)
    young, nu = scenes.material(part)
    body = Body(mesh, facets, segments, young, nu, scene["kinematics"], degree)
    support(body, scene, number)
    body.factor()
    return body, body.tags(scene["contact"]["edges"][number - 1], True)


def support(body, scene, number):
    """Supports of body 1 or 2; a floating body 1 is pinned where no force arises, for its loads
    are in balance."""
    for edge, components in scene[f"body{number}"].get("support", {}).items():
        body.hold(edge, [{"x": 0, "z": 1}[k] for k in components if k != "phi"])
    body.hold_axis()
    if number == 2:
        return
    load = scene["load"]
    first = next(s for s in body.segments if s.edge == load["edge"])
    if load["as"] == "rigid":
        body.hold(load["edge"], [1])
    else:
        body.pin(first.a, 1)


def contact_middle(surface, x, z, number=2):
    """Whether a point of the contact edge of a body lies within the contact."""
    c = float(surface.coordinate(x, z))
    inside = surface.range[0] < c < surface.range[1]
    return inside and math.dist(surface.on_body(c, number), (x, z)) < 1e-6 * (1.0 + abs(z))


def load_ends(scene, surface):
    """Where a load of limited width begins and ends on body 1."""
    load = scene["load"]
    if load["as"] != "vertical" or "width" not in load:
        return []
    _, values = scenes.geometry(scene["body1"])
    return [(x, math.sqrt(values["outer"] ** 2 - x * x)) for x in load_range(load)]


def load_range(load):
    half, centre = 0.5 * scenes.quantity(load["width"]), scenes.quantity(load.get("centre", 0.0))
    return centre - half, centre + half


def respond(scene, surface, pressure, c, sign, number, body, tags):
    """Displacements at the points c under the contact tractions and the body's own load."""
    at, mu = surface.point(c), friction(surface, sign)
    u = body.points(body.solve(loads(scene, surface, pressure, sign, number, body, tags)), at, tags)
    if not surface.axisymmetric or mu == 0.0:
        return u, None
    side = 1.0 if number == 1 else -1.0
    held = next(edge for edge, k in scene[f"body{number}"]["support"].items() if "phi" in k)
    turn = Torsion(body, held, body.number(side * mu * surface.sense) * pressure.field(ufl, body.x, body.number), tags)
    return u, body.points(turn.displacement, at, tags)[:, 0]


def friction(surface, sign):
    """mu on the bodies, reversed by a fault."""
    return surface.friction * sign if surface.shear else 0.0


def loads(scene, surface, pressure, sign, number, body, tags):
    """Load vector of the contact tractions and the body's own load."""
    p = pressure.field(ufl, body.x, body.number)
    side = 1.0 if number == 1 else -1.0
    if surface.radius is None:
        n, along = ufl.as_vector((0.0, 1.0)), ufl.as_vector((1.0, 0.0))
    else:
        n = ufl.as_vector([(body.x[i] - body.number(surface.centre[i])) / body.number(surface.radius) for i in range(2)])
        along = ufl.as_vector((-n[1], n[0]))
    in_plane = 0.0 if surface.axisymmetric else friction(surface, sign) * surface.sense
    vector = body.load(p * (body.number(side) * n + body.number(side * in_plane) * along), tags)
    if number == 1 and scene["load"]["as"] != "rigid":
        own = own_load(scene, body)
        vector += own * (-body.resultant(vector, 1) / body.resultant(own, 1))
    return vector


def own_load(scene, body):
    """Load vector of the shape of body 1's own load; its size follows from balance."""
    load = scene["load"]
    normal = ufl.FacetNormal(body.mesh)
    if load["as"] == "pressure":
        return body.load(-normal, body.tags(load["edge"]))
    tags = body.tags(load["edge"])
    if "width" in load:
        low, high = load_range(load)
        inside = lambda s: low - 1e-9 < min(s.a[0], s.b[0]) and max(s.a[0], s.b[0]) < high + 1e-9
        tags = [i + 1 for i, s in enumerate(body.segments) if s.edge == load["edge"] and inside(s)]
    return body.load(ufl.as_vector((0.0, -1.0)) * normal[1], tags)


if __name__ == "__main__":
    common.main(__doc__, solve)
