"""Writes the gmsh meshes of this folder: python3 meshes.py (needs Debian's python3-gmsh).

punch.msh   the punch of translating-punch, unstructured quadrilaterals of order 1, MSH 4.1 text
shoe.msh    the shoe of drum-brake-block, quadrilaterals of order 2, MSH 4.1 binary: its arc is recognised as one
fine-shoe.msh  the same with 323 cells, as meshes for other programs have, for measurements of speed
cylinder.msh, block.msh  the bodies of hertz-cylinder, quadrilaterals of order 2 and 1, MSH 4.1 text
lining.msh  the shoe of lining-on-back, two physical surfaces, quadrilaterals and triangles of order 3, MSH 2.2 text
"""

from math import cos, pi, sin

import gmsh


def begin(size, recombination=3):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.RecombineAll", 1)
    gmsh.option.setNumber("Mesh.RecombinationAlgorithm", recombination)


def end(name, order, version=4.1, binary=0):
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order)
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.write(name)
    gmsh.finalize()


def group(dimension, name, tags):
    gmsh.model.setPhysicalName(dimension, gmsh.model.addPhysicalGroup(dimension, tags), name)


def polygon(points, centre=None):
    """Lines between points, the first one an arc if there is a centre."""
    tags = [gmsh.model.geo.addPoint(x, y, 0) for x, y in points]
    ends = list(zip(tags, tags[1:] + tags[:1]))
    if centre is None:
        return [gmsh.model.geo.addLine(*e) for e in ends]
    middle = gmsh.model.geo.addPoint(*centre, 0)
    first = gmsh.model.geo.addCircleArc(ends[0][0], middle, ends[0][1])
    return [first] + [gmsh.model.geo.addLine(*e) for e in ends[1:]]


def surface(lines):
    return gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])


def punch():
    begin(48)
    lines = polygon([(-30, 100), (30, 100), (30, 200), (-30, 200)])
    body = surface(lines)
    gmsh.model.geo.synchronize()
    for name, line in zip(["bottom", "right", "top", "left"], lines):
        group(1, name, [line])
    group(2, "steel", [body])
    end("punch.msh", 1)


def shoe(name="shoe.msh", size=120):
    begin(size)
    x, z = 200 * sin(pi / 6), 200 * cos(pi / 6)
    lines = polygon([(-x, z), (x, z), (x, 300), (-x, 300)], (0, 0))
    body = surface(lines)
    gmsh.model.geo.synchronize()
    for name, line in zip(["inner", "right", "top", "left"], lines):
        group(1, name, [line])
    group(2, "steel", [body])
    end(name, 2, binary=1)


def lining():
    begin(30, recombination=1)
    geo = gmsh.model.geo
    centre = geo.addPoint(0, 0, 0)
    on = lambda r, a: geo.addPoint(r * sin(a), r * cos(a), 0)
    a, b, c, d = on(200, -pi / 6), on(200, pi / 6), on(210, pi / 6), on(210, -pi / 6)
    e, f = geo.addPoint(105, 240, 0), geo.addPoint(-105, 240, 0)
    face, bond = geo.addCircleArc(a, centre, b), geo.addCircleArc(d, centre, c)
    ends = [geo.addLine(b, c), geo.addLine(d, a)]
    left, top, right = geo.addLine(f, d), geo.addLine(e, f), geo.addLine(c, e)
    soft = geo.addPlaneSurface([geo.addCurveLoop([face, ends[0], -bond, ends[1]])])
    stiff = geo.addPlaneSurface([geo.addCurveLoop([bond, right, top, left])])
    geo.synchronize()
    for name, line in [("face", face), ("left", left), ("right", right), ("top", top)]:
        group(1, name, [line])
    group(2, "lining", [soft])
    group(2, "steel", [stiff])
    end("lining.msh", 3, version=2.2)


def cylinder():
    begin(40)
    geo = gmsh.model.geo
    middle, low = geo.addPoint(0, 50, 0), geo.addPoint(0, 0, 0)
    left, right = geo.addPoint(-50, 50, 0), geo.addPoint(50, 50, 0)
    arcs = [geo.addCircleArc(left, middle, low), geo.addCircleArc(low, middle, right)]
    tops = [geo.addLine(right, middle), geo.addLine(middle, left)]
    centre = geo.addLine(low, middle)
    halves = [[arcs[1], tops[0], -centre], [arcs[0], centre, tops[1]]]
    body = [surface(half) for half in halves]
    geo.synchronize()
    for name, lines in [("arc", arcs), ("top", tops), ("centre", [centre])]:
        group(1, name, lines)
    group(2, "steel", body)
    end("cylinder.msh", 2)


def block():
    begin(80)
    lines = polygon([(-100, -200), (100, -200), (100, 0), (-100, 0)])
    body = surface(lines)
    gmsh.model.geo.synchronize()
    for name, line in zip(["bottom", "right", "top", "left"], lines):
        group(1, name, [line])
    group(2, "aluminium", [body])
    end("block.msh", 1)


punch()
shoe()
shoe("fine-shoe.msh", 10)
lining()
cylinder()
block()
