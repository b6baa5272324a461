"""The field files opened by VTK, and their numbers against contact.csv.

usage: outputs_vtk.py <folder of a run> <tolerance of the stress> <tolerance of the displacement>

Prints one line a check; ends with 1 if one of them fails. In the inner 80 % of the contact the stress of both bodies
along the normal is minus the pressure, and their displacement along the normal is that of the table.
"""

import csv
import math
import pathlib
import sys
import tomllib
import xml.etree.ElementTree as ElementTree

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
import numpy

FAILED = []

# VTK's numbers of Lagrange cells.
TRIANGLE, QUADRILATERAL = 69, 70


def check(what, value, limit):
    good = value <= limit
    print(f"  {what:<58} {value:9.2e} <= {limit:.0e} {'ok' if good else 'FAILED'}")
    if not good:
        FAILED.append(what)


def opened(path):
    reader = vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    check(f"{path.name}: errors of the reader", len(errors), 0)
    check(f"{path.name}: is empty", float(grid.GetNumberOfCells() == 0), 0)
    return grid


def arrays(grid):
    data = grid.GetPointData()
    found = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    return vtk_to_numpy(grid.GetPoints().GetData()), found


def area(grid):
    """Sum of the areas of the Lagrange cells, by their own shape functions in VTK: a wrong order of nodes folds them."""
    total = 0.0
    for number in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(number)
        count = cell.GetNumberOfPoints()
        places = numpy.array([cell.GetPoints().GetPoint(i) for i in range(count)])[:, [0, 2]]
        slopes = [0.0] * (2 * count)
        for r, s, weight in rule(cell):
            cell.InterpolateDerivs([r, s, 0.0], slopes)
            # VTK's triangles list the derivatives by r first, its quadrilaterals both of each node.
            pairs = numpy.array(slopes)
            pairs = pairs.reshape(2, count) if cell.GetCellType() == TRIANGLE else pairs.reshape(count, 2).T
            (a, b), (c, d) = pairs @ places
            if a * d - b * c <= 0:
                print(f"  cell {number} is folded")
                FAILED.append("folded")
            total += weight * (a * d - b * c)
    return total


def rule(cell):
    """Gauss points and weights of VTK's unit square or triangle, exact for the Jacobian of the cell."""
    triangle = cell.GetCellType() == TRIANGLE
    points, weights = numpy.polynomial.legendre.leggauss(math.ceil(math.sqrt(2 * cell.GetNumberOfPoints())) + 1)
    points, weights = 0.5 + 0.5 * points, 0.5 * weights
    for r, v in zip(points, weights):
        for s, w in zip(points, weights):
            yield (r, s, v * w) if not triangle else (r, s * (1 - r), v * w * (1 - r))


def expected_area(body, axisymmetric):
    (name, keys), = body["geometry"].items()
    if name == "rectangle":
        return (keys["x"][1] - keys["x"][0]) * (keys["z"][1] - keys["z"][0])
    if name == "ring":
        return math.pi * (keys["outer"] ** 2 - keys["inner"] ** 2)
    if name == "shoe-block":
        r, a = keys["radius"], keys["half_angle"]
        return 2 * r * math.sin(a) * keys["top"] - r * r * (a + math.sin(a) * math.cos(a))
    if name == "mesh":
        # The shoe of data/meshes/lining.msh: a lining from 200 to 210 mm, its back up to z = 240 mm, within 30 degrees of the axis.
        a = math.pi / 6
        return a * (210**2 - 200**2) + 210 * 240 - 210**2 * (a + math.sin(a) * math.cos(a))
    return None


def main(folder, stress_limit, displacement_limit):
    fields = folder / "fields"
    series = ElementTree.parse(fields / "fields.pvd").getroot().findall("./Collection/DataSet")
    listed = sorted(entry.get("file") for entry in series)
    there = sorted(path.name for path in fields.glob("*.vtu") if ".lagrange." not in path.name)
    check("fields.pvd: files that it lists and are not there, or the reverse", len(set(listed) ^ set(there)), 0)
    with open(folder / "contact.csv", newline="") as text:
        rows = list(csv.DictReader(text))
    table = {key: numpy.array([float(row[key]) for row in rows]) for key in rows[0] if key != "status"}
    scene = tomllib.loads((folder / "scene.resolved.toml").read_text())
    axisymmetric = scene["kinematics"] == "axisymmetric"
    for number, name in enumerate(["body1", "body2"], start=1):
        flat, whole = opened(fields / f"{name}.vtu"), opened(fields / f"{name}.lagrange.vtu")
        places, values = arrays(flat)
        same, others = arrays(whole)
        check(f"{name}: points of both files differ", numpy.abs(places - same).max(), 0)
        check(f"{name}: values of both files differ", max(numpy.abs(numpy.nan_to_num(values[k]) - numpy.nan_to_num(others[k])).max() for k in values), 0)
        kinds = [whole.GetCellType(i) for i in range(whole.GetNumberOfCells())]
        check(f"{name}: cells that are no Lagrange cells", sum(kind not in (TRIANGLE, QUADRILATERAL) for kind in kinds), 0)
        triangles = "mesh" in scene[name]["geometry"]
        check(f"{name}: {kinds.count(TRIANGLE)} triangles, wanted {'some' if triangles else 'none'}", float((TRIANGLE in kinds) != triangles), 0)
        full = expected_area(scene[name], axisymmetric)
        check(f"{name}: area of the {len(kinds)} Lagrange cells", abs(area(whole) / full - 1), 1e-9)
        first = "r" if axisymmetric else "x"
        hoop = "hoop" if axisymmetric else "y"
        x, z = values[f"sigma_{first}_MPa"], values["sigma_z_MPa"]
        y, t = values[f"sigma_{hoop}_MPa"], values[f"tau_{first}z_MPa"]
        rphi, phiz = (values.get(f"tau_{k}_MPa", numpy.zeros(len(x))) for k in ["rphi", "phiz"])
        mises = numpy.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3 * (t**2 + rphi**2 + phiz**2))
        check(f"{name}: von Mises stress", numpy.abs(values["von_mises_MPa"] / mises - 1).max(), 1e-12)
        principal = sum(values[f"principal_{k}_MPa"] for k in [1, 2, 3])
        check(f"{name}: sum of the principal stresses", numpy.abs(principal - x - y - z).max() / mises.max(), 1e-12)
        # Points on the contact surface: those that have a neighbour in the table closer than a little.
        s = along(scene, places)
        on = numpy.abs(distance(scene, places)) < 1e-8
        span = table["s_mm"][-1] - table["s_mm"][0]
        on &= (s > table["s_mm"][0] + 0.1 * span) & (s < table["s_mm"][-1] - 0.1 * span)
        check(f"{name}: fewer than 20 points on the contact", float(on.sum() < 20), 0)
        at = lambda key: numpy.interp(s[on], table["s_mm"], table[key])
        nx, nz = at("nx"), at("nz")
        normal = x[on] * nx**2 + 2 * t[on] * nx * nz + z[on] * nz**2
        pressure = at("pressure_MPa")
        check(f"{name}: normal stress is minus the pressure ({on.sum()} points)", numpy.abs(normal + pressure).max() / pressure.max(), stress_limit)
        u = values["displacement_mm"][on]
        un = table[f"un{number}_um"]
        difference = 1e3 * (u[:, 0] * nx + u[:, 2] * nz) - at(f"un{number}_um")
        check(f"{name}: displacement along the normal", numpy.abs(difference).max() / numpy.abs(un).max(), displacement_limit)
        if axisymmetric and not numpy.isnan(table[f"uphi{number}_um"]).any():
            difference = 1e3 * u[:, 1] - at(f"uphi{number}_um")
            largest = numpy.abs(table[f"uphi{number}_um"]).max()
            check(f"{name}: displacement around the axis", numpy.abs(difference).max() / largest, displacement_limit)


def surface(scene):
    """Radius of a contact arc about the origin, or height of a contact line."""
    (name, keys), = scene["body2"]["geometry"].items()
    return ("arc", keys["outer"]) if name == "ring" else ("line", keys["z"][1])


def along(scene, places):
    kind, size = surface(scene)
    if kind == "arc":
        return size * numpy.arctan2(places[:, 0], places[:, 2])
    middle = 0.0 if scene["kinematics"] == "axisymmetric" else 0.5 * sum(scene["body1"]["geometry"]["rectangle"]["x"])
    return places[:, 0] - middle


def distance(scene, places):
    kind, size = surface(scene)
    return numpy.hypot(places[:, 0], places[:, 2]) - size if kind == "arc" else places[:, 2] - size


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3]))
    sys.exit(1 if FAILED else 0)
