"""Bodies of p-version finite elements reduced to a part of their boundary, as numpy arrays.

``S u = f`` with the condensed stiffness ``S`` of the kept boundary: small, dense, and all that contact, wear and coupling need of a linear
body. The method: the README of the crate ``hpfem``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from wearshape import _core
from wearshape._arguments import array, instance, number, whole
from wearshape._error import Error
from wearshape._table import numbers

__all__ = ["Interface", "Mesh"]


class Mesh:
    """A plane mesh from a file of gmsh (4.1 or 2.2, text or binary, orders 1 to 4): quadrilaterals and triangles with curved edges.

    Physical curves name the boundaries, physical surfaces the materials. Raises :class:`wearshape.Error` for what is not such a file.
    """

    __slots__ = ("_mesh",)

    def __init__(self, source: str | PathLike[str] | bytes) -> None:
        instance("source", source, (str, PathLike, bytes), "a path or the bytes of a file")
        self._mesh = _core.Mesh(source if isinstance(source, bytes) else Path(source).read_bytes())

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions (x, z) or (r, z) of the vertices. Shape (vertices, 2), mm."""
        return numbers(self._mesh.vertices)

    @property
    def cells(self) -> NDArray[np.intp]:
        """Corner vertices of the cells, anti-clockwise; a triangle repeats its last one. Shape (cells, 4)."""
        return np.array(self._mesh.cells, dtype=np.intp).reshape(-1, 4)

    @property
    def cell_materials(self) -> NDArray[np.intp]:
        """Index into ``materials`` of each cell. Shape (cells,)."""
        return np.array(self._mesh.cell_materials, dtype=np.intp)

    @property
    def materials(self) -> list[str]:
        """Names of the materials."""
        return self._mesh.materials

    @property
    def boundaries(self) -> list[str]:
        """Names of the boundaries."""
        return self._mesh.boundaries

    def interface(
        self,
        keep: str,
        materials: Mapping[str, tuple[float, float]],
        *,
        degree: int = 4,
        kinematics: str = "plane-strain",
        thickness: float = 1.0,
        supports: Mapping[str, Sequence[str]] | None = None,
        loads: Mapping[str, Mapping[str, tuple[float, float]]] | None = None,
    ) -> Interface:
        """The body of this mesh reduced to the boundary ``keep``.

        :param materials: Young's modulus (MPa) and Poisson's ratio of each material by name.
        :param degree: degree of the cells, 1 to 24.
        :param kinematics: ``plane-stress``, ``plane-strain`` or ``axisymmetric``.
        :param thickness: mm; not used by axisymmetric bodies.
        :param supports: directions ``x`` and ``z`` in which boundaries are held, by boundary. A body that floats is welcome.
        :param loads: tractions (x, z) in MPa by boundary, of each load case by its name.

        Raises :class:`wearshape.Error` for names that are not there and for what cannot be meshed, held or loaded.
        """
        instance("keep", keep, str, "the name of a boundary")
        instance("materials", materials, Mapping, "a mapping of names to moduli")
        whole("degree", degree, 1, 24, "as the degree")
        instance("kinematics", kinematics, str, "a word")
        missing = [name for name in self.materials if name not in materials]
        if missing:
            raise Error(f"the material {missing[0]!r} of the mesh is not given", "no-material", None, "give young and poisson of each material")
        given: _core.BodyGiven = {
            "degree": degree,
            "kinematics": kinematics,
            "thickness": number("thickness", thickness),
            "materials": [array(f"materials[{name!r}]", materials[name], (2,)).tolist() for name in self.materials],
            "supports": _held(supports or {}),
            "loads": _cases(loads or {}),
            "keep": keep,
        }
        return Interface(self._mesh.interface(given))


def _held(supports: Mapping[str, Sequence[str]]) -> list[tuple[str, str]]:
    """Boundary and direction of each support."""
    instance("supports", supports, Mapping, "a mapping of boundaries to directions")
    held = []
    for name, directions in supports.items():
        instance("a boundary in supports", name, str, "a name")
        instance(f"supports[{name!r}]", directions, Iterable, "a list of directions")
        for direction in directions:
            instance(f"a direction in supports[{name!r}]", direction, str, "x or z")
            held.append((name, direction))
    return held


def _cases(loads: Mapping[str, Mapping[str, tuple[float, float]]]) -> list[tuple[str, str, list[float]]]:
    """Load case, boundary and traction of each load."""
    instance("loads", loads, Mapping, "a mapping of load cases to tractions by boundary")
    cases = []
    for case, edges in loads.items():
        instance("a load case in loads", case, str, "a name")
        instance(f"loads[{case!r}]", edges, Mapping, "a mapping of boundaries to tractions")
        for edge, traction in edges.items():
            instance(f"a boundary in loads[{case!r}]", edge, str, "a name")
            cases.append((case, edge, array(f"loads[{case!r}][{edge!r}]", traction, (2,)).tolist()))
    return cases


class Interface:
    """A body reduced to a kept boundary: ``S u = f + loads @ factors``.

    ``u`` are the coefficients of the boundary's displacement (mm), n of them; ``m`` is the number of points of the boundary. Matrices are
    views of the solver's own memory, by columns, for reading alone.
    """

    __slots__ = ("_interface",)

    def __init__(self, interface: _core.Interface) -> None:
        self._interface = interface

    @property
    def stiffness(self) -> NDArray[np.float64]:
        """Condensed stiffness S, symmetric; singular exactly for the rigid modes. Shape (n, n), N/mm."""
        return numbers(self._interface.stiffness)

    @property
    def loads(self) -> NDArray[np.float64]:
        """Condensed load of each load case. Shape (n, cases), N."""
        return numbers(self._interface.loads)

    @property
    def load_cases(self) -> list[str]:
        """Names of the load cases, in the order of the columns of ``loads``."""
        return self._interface.load_cases

    @property
    def rigid_modes(self) -> NDArray[np.float64]:
        """Rigid motions that the supports leave free. Shape (n, motions), mm."""
        return numbers(self._interface.rigid_modes)

    @property
    def arc(self) -> NDArray[np.float64]:
        """Arc length of the points from the start of the boundary. Shape (m,), mm."""
        return numbers(self._interface.arc)

    @property
    def weight(self) -> NDArray[np.float64]:
        """Area weights of the points. Shape (m,), mm^2."""
        return numbers(self._interface.weight)

    @property
    def position(self) -> NDArray[np.float64]:
        """Positions of the points. Shape (m, 2), mm."""
        return numbers(self._interface.position)

    @property
    def outward(self) -> NDArray[np.float64]:
        """Unit normals out of the body. Shape (m, 2)."""
        return numbers(self._interface.outward)

    @property
    def normal_rows(self) -> NDArray[np.float64]:
        """``normal_rows @ u`` is the displacement along the outward normal at the points. Shape (m, n)."""
        return numbers(self._interface.normal_rows)

    @property
    def displacement_rows(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """``rows @ u`` for the displacements along x (or r) and z at the points. Shapes (m, n)."""
        return numbers(self._interface.first_rows), numbers(self._interface.second_rows)
