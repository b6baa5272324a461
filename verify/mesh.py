"""Outlines of the bodies and their meshes by gmsh: curved triangles, graded towards points.

An outline is a list of closed loops of segments; a segment is a straight line or a circular arc
below 180 degrees with the name of its edge. Every segment gets a number of its own on the mesh.
"""

import math
from dataclasses import dataclass, replace

import gmsh
import numpy as np
from dolfinx.io import gmshio
from mpi4py import MPI


DELAUNAY = 5  # the frontal algorithm (6) left flat triangles beside strongly graded straight lines


@dataclass
class Segment:
    """From a to b, about centre when it is an arc; `contact` marks the part that can touch."""

    a: tuple
    b: tuple
    edge: str
    centre: tuple | None = None
    contact: bool = False

    def split(self, point):
        """The two parts at a point strictly inside, or the segment itself."""
        ax, bx = self._parameter(self.a), self._parameter(self.b)
        if self.centre is not None:
            on = abs(math.dist(point, self.centre) - math.dist(self.a, self.centre)) < 1e-9 * math.dist(self.a, self.centre)
            turn = lambda t: math.remainder(t - ax, 2.0 * math.pi)
            share = turn(self._parameter(point)) / turn(bx)
        else:
            length = math.dist(self.a, self.b)
            d = ((self.b[0] - self.a[0]) / length, (self.b[1] - self.a[1]) / length)
            off = (point[0] - self.a[0]) * d[1] - (point[1] - self.a[1]) * d[0]
            on = abs(off) < 1e-9 * length
            share = ((point[0] - self.a[0]) * d[0] + (point[1] - self.a[1]) * d[1]) / length
        if not on or not 1e-9 < share < 1.0 - 1e-9:
            return [self]
        return [replace(self, b=tuple(point)), replace(self, a=tuple(point))]

    def _parameter(self, point):
        if self.centre is None:
            return 0.0
        return math.atan2(point[1] - self.centre[1], point[0] - self.centre[0])


def polar(centre, radius, angle):
    """The point at an angle from the vertical, positive towards +x."""
    return (centre[0] + radius * math.sin(angle), centre[1] + radius * math.cos(angle))


def outline(template, values, axisymmetric=False):
    """Loops of segments of a template, counter-clockwise outside. Other loops are holes."""
    if template == "rectangle":
        (x0, x1), (z0, z1) = values["x"], values["z"]
        p = [(x0, z0), (x1, z0), (x1, z1), (x0, z1)]
        return [[Segment(p[0], p[1], "bottom"), Segment(p[1], p[2], "right"),
                 Segment(p[2], p[3], "top"), Segment(p[3], p[0], "left")]]
    if template == "shoe-block":
        radius, half, top = values["radius"], values["half_angle"], values["top"]
        left, right = polar((0.0, 0.0), radius, -half), polar((0.0, 0.0), radius, half)
        return [[Segment(left, right, "inner", (0.0, 0.0)), Segment(right, (right[0], top), "right"),
                 Segment((right[0], top), (left[0], top), "top"), Segment((left[0], top), left, "left")]]
    if template == "ring-segment":
        inner, outer, (left, right) = values["inner"], values["outer"], values["x"]
        o = (0.0, 0.0)
        at = lambda radius, x: (x, math.sqrt(radius**2 - x**2))
        return [[Segment(at(inner, left), at(inner, right), "inner", o), Segment(at(inner, right), at(outer, right), "right"),
                 Segment(at(outer, right), at(outer, left), "outer", o), Segment(at(outer, left), at(inner, left), "left")]]
    if template == "ring":
        centre = tuple(values.get("centre", [0.0, 0.0]))
        loops = []
        for edge, radius in (("outer", values["outer"]), ("inner", values["inner"])):
            p = [polar(centre, radius, -0.5 * math.pi * i) for i in range(4)]
            loops.append([Segment(p[i], p[(i + 1) % 4], edge, centre) for i in range(4)])
        return loops
    if template == "half-disc":
        radius = values["radius"]
        c = tuple(values.get("centre", [0.0, radius]))
        bottom, left, right = (c[0], c[1] - radius), (c[0] - radius, c[1]), (c[0] + radius, c[1])
        if axisymmetric:
            return [[Segment(bottom, right, "arc", c), Segment(right, c, "top"), Segment(c, bottom, "axis")]]
        return [[Segment(left, bottom, "arc", c), Segment(bottom, right, "arc", c), Segment(right, left, "top")]]
    raise ValueError(f"template {template!r} is not known here")


def centre_line(template, values):
    """The line x = 0 through the thickness, named `centre`, or None where there is none."""
    if template == "ring-segment":
        return Segment((0.0, values["inner"]), (0.0, values["outer"]), "centre")
    if template == "half-disc":
        (x, z), radius = values.get("centre", [0.0, values["radius"]]), values["radius"]
        return Segment((x, z - radius), (x, z), "centre")
    return None


def mark(loops, edge, inside):
    """Marks as contact the segments of an edge whose middle satisfies `inside(x, z)`."""
    for loop in loops:
        for segment in loop:
            middle = _middle(segment)
            segment.contact = segment.edge == edge and inside(*middle)


def _middle(segment):
    m = (0.5 * (segment.a[0] + segment.b[0]), 0.5 * (segment.a[1] + segment.b[1]))
    if segment.centre is None:
        return m
    radius, length = math.dist(segment.a, segment.centre), math.dist(m, segment.centre)
    return tuple(c + (x - c) * radius / length for x, c in zip(m, segment.centre))


def split(loops, points):
    """The same loops with break points where a point lies on a segment."""
    for point in points:
        loops = [[part for segment in loop for part in segment.split(point)] for loop in loops]
    return loops


def triangulate(loops, size, order=3, sharp=(), sharp_size=1e-5, slope=0.4, divisions=None, cut=None, near=None):
    """Meshes the outline. Returns (mesh, facet tags, segments), tag i + 1 for segments[i].

    `size` is the largest cell, `sharp` the points towards which cells shrink to `sharp_size` with
    size = slope * distance. `divisions`: for each segment None or its number of cells; `near`: the
    cell size along those segments, growing away from them. `cut`: a segment through the body whose
    nodes must lie on it.
    """
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.CharacteristicLengthExtendFromBoundary", 0)
    gmsh.option.setNumber("Mesh.CharacteristicLengthFromPoints", 0)
    gmsh.option.setNumber("Mesh.CharacteristicLengthFromCurvature", 0)
    gmsh.option.setNumber("Mesh.Algorithm", DELAUNAY)
    gmsh.model.add("body")
    geo, points = gmsh.model.geo, {}

    def point(p):
        key = (round(p[0], 12), round(p[1], 12))
        if key not in points:
            points[key] = geo.addPoint(p[0], p[1], 0.0)
        return points[key]

    def curve(segment):
        if segment.centre is None:
            return geo.addLine(point(segment.a), point(segment.b))
        return geo.addCircleArc(point(segment.a), point(segment.centre), point(segment.b))

    segments = [segment for loop in loops for segment in loop]
    tags = [curve(segment) for segment in segments]
    fixed = []
    if divisions:
        for tag, count in zip(tags, divisions):
            if count:
                geo.mesh.setTransfiniteCurve(tag, count + 1)
                fixed.append(tag)
    at, wires = 0, []
    for loop in loops:
        wires.append(geo.addCurveLoop(tags[at:at + len(loop)]))
        at += len(loop)
    surface = geo.addPlaneSurface(wires)
    geo.synchronize()
    if cut is not None:
        line = geo.addLine(point(cut.a), point(cut.b))
        geo.synchronize()
        gmsh.model.mesh.embed(1, [line], 2, surface)
        segments, tags = segments + [cut], tags + [line]
    for i, tag in enumerate(tags):
        gmsh.model.addPhysicalGroup(1, [tag], i + 1)
    gmsh.model.addPhysicalGroup(2, [surface], 1)
    lines = fixed or [tag for tag, segment in zip(tags, segments) if segment.contact]
    _grade([points[(round(p[0], 12), round(p[1], 12))] for p in sharp], lines if near else [], size, sharp_size, near, slope)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order)
    mesh, _, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    worst = flatness(mesh)
    if worst < 0.05:
        raise ValueError(f"gmsh made a flat cell, quality {worst:.1e}")
    return mesh, facets, segments


def flatness(mesh):
    """The smallest quality of all cells: 1 for an equilateral triangle, 0 for a flat one."""
    corners = mesh.geometry.dofmap.array.reshape(mesh.topology.index_map(2).size_local, -1)[:, :3]
    a, b, c = (mesh.geometry.x[corners[:, i], :2] for i in range(3))
    area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2.0
    longest = np.max([np.sum((p - q) ** 2, axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    return float(np.min(area / longest) * 4.0 / math.sqrt(3.0))


def _grade(nodes, curves, size, sharp_size, near, slope):
    field = gmsh.model.mesh.field
    last = field.add("MathEval")
    field.setString(last, "F", repr(float(size)))
    fields = [last]
    for kind, tags, smallest in (("NodesList", nodes, sharp_size), ("EdgesList", curves, near)):
        if tags:
            distance = field.add("Distance")
            field.setNumbers(distance, kind, tags)
            if kind == "EdgesList":
                field.setNumber(distance, "NNodesByEdge", max(3, 400 // len(tags)))
            ramp = field.add("Threshold")
            field.setNumber(ramp, "IField", distance)
            field.setNumber(ramp, "LcMin", smallest)
            field.setNumber(ramp, "LcMax", size)
            field.setNumber(ramp, "DistMin", smallest)
            field.setNumber(ramp, "DistMax", smallest + max(size - smallest, 0.0) / slope)
            fields.append(ramp)
    smallest_of_all = field.add("Min")
    field.setNumbers(smallest_of_all, "FieldsList", fields)
    field.setAsBackgroundMesh(smallest_of_all)
