"""One elastic body by dolfinx: plane stress, plane strain, axisymmetric, and torsion.

Displacements in the plane are (x, z); the axisymmetric forms carry the weight r and leave out
2 pi on both sides. Everything is per unit thickness.
"""

import time

import dolfinx.fem.petsc as fem_petsc
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.mesh import locate_entities_boundary, meshtags
from petsc4py import PETSc

# Seconds spent on forms so far: symbolic work and the look-up of compiled code, or its compilation.
FORMS = [0.0]


def form(expression):
    """A form ready for assembly."""
    started = time.perf_counter()
    ready = fem.form(expression)
    FORMS[0] += time.perf_counter() - started
    return ready


class Body:
    """Stiffness, supports and factorisation of one body on one mesh."""

    def __init__(self, mesh, facets, segments, young, poisson, kinematics, degree):
        self.mesh, self.facets, self.segments = mesh, facets, segments
        self.young, self.poisson, self.kinematics = young, poisson, kinematics
        self.axisymmetric = kinematics == "axisymmetric"
        self.space = fem.VectorFunctionSpace(mesh, ("Lagrange", degree))
        self.degree = degree
        mesh.topology.create_connectivity(1, 2)
        mesh.topology.create_connectivity(1, 0)
        mesh.topology.create_connectivity(2, 0)
        mesh.topology.create_connectivity(0, 2)
        metadata = {"quadrature_degree": 2 * degree + 4}
        self.dx = ufl.Measure("dx", domain=mesh, metadata=metadata)
        self.metadata = metadata
        self.x = ufl.SpatialCoordinate(mesh)
        self.supports = []
        self.solver = None

    def tags(self, edge, contact=None):
        """Numbers of the segments of an edge, or of its part that can touch."""
        return tuple(i + 1 for i, s in enumerate(self.segments)
                     if s.edge == edge and (contact is None or s.contact == contact))

    def number(self, value):
        """A number of a form that its code takes as an argument: forms that differ by numbers alone are compiled once."""
        return fem.Constant(self.mesh, float(value))

    def along(self, tags):
        """The measure of these segments, of one name in all forms, so that segments with other numbers have the same code."""
        entities = np.unique(np.concatenate([self.facets.find(tag) for tag in tags])).astype(np.int32)
        marked = meshtags(self.mesh, 1, entities, np.ones(len(entities), dtype=np.int32))
        return ufl.Measure("ds", domain=self.mesh, subdomain_data=marked, metadata=self.metadata)(1)

    def _energy(self, u, v):
        young, nu = self.young, self.poisson
        shear = young / (2.0 * (1.0 + nu))
        lame = young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))
        if self.kinematics == "plane-stress":
            lame = 2.0 * lame * shear / (lame + 2.0 * shear)
        shear, lame = self.number(shear), self.number(lame)
        strain = lambda w: ufl.sym(ufl.grad(w))
        if not self.axisymmetric:
            stress = 2.0 * shear * strain(u) + lame * ufl.tr(strain(u)) * ufl.Identity(2)
            return ufl.inner(stress, strain(v)) * self.dx
        r = self.x[0]
        hoop = lambda w: w[0] / r
        trace = lambda w: ufl.tr(strain(w)) + hoop(w)
        return (2.0 * shear * (ufl.inner(strain(u), strain(v)) + hoop(u) * hoop(v)) + lame * trace(u) * trace(v)) * r * self.dx

    def weight(self):
        """r in axisymmetric bodies (2 pi is left out on both sides)."""
        return self.x[0] if self.axisymmetric else 1.0

    def hold(self, edge, components):
        """Fixes components 0 (x) and 1 (z) on an edge."""
        entities = np.concatenate([self.facets.find(tag) for tag in self.tags(edge)])
        if len(entities) == 0:
            raise ValueError(f"edge {edge!r} is not on the mesh")
        for component in components:
            space = self.space.sub(component)
            dofs = fem.locate_dofs_topological(space, 1, entities)
            self.supports.append(fem.dirichletbc(PETSc.ScalarType(0.0), dofs, space))

    def hold_axis(self):
        """u_r = 0 on the axis of an axisymmetric body."""
        on = [i + 1 for i, s in enumerate(self.segments) if s.a[0] == 0.0 and s.b[0] == 0.0]
        if self.axisymmetric and on:
            entities = np.concatenate([self.facets.find(tag) for tag in on])
            space = self.space.sub(0)
            dofs = fem.locate_dofs_topological(space, 1, entities)
            self.supports.append(fem.dirichletbc(PETSc.ScalarType(0.0), dofs, space))

    def pin(self, point, component):
        """Fixes one component at one corner; free of force when the loads are in balance."""
        near = lambda x: np.hypot(x[0] - point[0], x[1] - point[1]) < 1e-11 * (1.0 + np.hypot(*point))
        vertices = locate_entities_boundary(self.mesh, 0, near)
        if len(vertices) != 1:
            raise ValueError(f"{len(vertices)} corners at {point}")
        space = self.space.sub(component)
        dofs = fem.locate_dofs_topological(space, 0, vertices)
        self.supports.append(fem.dirichletbc(PETSc.ScalarType(0.0), dofs, space))

    def factor(self):
        """Assembles and factorises; call after the supports are set."""
        u, v = ufl.TrialFunction(self.space), ufl.TestFunction(self.space)
        self.matrix = fem_petsc.assemble_matrix(form(self._energy(u, v)), bcs=self.supports)
        self.matrix.assemble()
        self.solver = direct(self.matrix)
        self.held = np.unique(np.concatenate([bc.dof_indices()[0] for bc in self.supports]))

    def load(self, traction, tags):
        """Load vector of a traction field on segments."""
        v = ufl.TestFunction(self.space)
        vector = fem_petsc.assemble_vector(form(ufl.inner(traction, v) * self.weight() * self.along(tags)))
        return vector.array.copy()

    def resultant(self, vector, component):
        """Sum of a load vector over one component: force per unit thickness (over 2 pi)."""
        return float(np.sum(vector[component::2]))

    def solve(self, vector):
        """Displacement of a load vector, as a function."""
        u = fem.Function(self.space)
        b = self.matrix.createVecRight()
        b.array[:] = vector
        b.array[self.held] = 0.0
        self.solver.solve(b, u.vector)
        if self.solver.getConvergedReason() < 0 or not np.all(np.isfinite(u.vector.array)):
            raise ValueError("the factorisation failed")
        return u

    def points(self, u, xz, tags):
        """Values of a function at points of the given boundary segments."""
        return boundary_values(self.mesh, self.facets, u, xz, tags)


def direct(matrix):
    """A factorisation by MUMPS."""
    solver = PETSc.KSP().create(matrix.comm)
    solver.setOperators(matrix)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    solver.getPC().setFactorSolverType("mumps")
    solver.setUp()
    return solver


def boundary_values(mesh, facets, u, xz, tags):
    """u at points of a boundary. The cell is found by the nearest facet's middle: a search by
    cells would lose points that lie a hair outside the curved cells."""
    entities = np.concatenate([facets.find(tag) for tag in tags]).astype(np.int32)
    vertices = mesh.topology.connectivity(1, 0)
    cells = mesh.topology.connectivity(1, 2)
    coordinates = mesh.geometry.x
    corner = _corner_map(mesh)
    ends = np.array([[coordinates[corner[v]][:2] for v in vertices.links(f)] for f in entities])
    found = []
    for p in xz:
        a, b = ends[:, 0] - p, ends[:, 1] - p
        # On a convex curve the facet that holds p is the one whose ends see it at the flattest angle.
        lengths = np.hypot(*a.T) + np.hypot(*b.T) - np.hypot(*(ends[:, 0] - ends[:, 1]).T)
        best = int(np.argmin(lengths / np.hypot(*(ends[:, 0] - ends[:, 1]).T)))
        found.append(cells.links(entities[best])[0])
    at = np.column_stack([xz, np.zeros(len(xz))])
    return u.eval(at, np.array(found, dtype=np.int32)).reshape(len(xz), -1)


def _corner_map(mesh):
    """Geometry node of every vertex."""
    cells = mesh.topology.connectivity(2, 0)
    nodes = mesh.geometry.dofmap
    corner = np.zeros(mesh.topology.index_map(0).size_local, dtype=np.int64)
    for cell in range(mesh.topology.index_map(2).size_local):
        corner[cells.links(cell)] = nodes.links(cell)[:3]
    return corner


class Torsion:
    """u_phi of an axisymmetric body: shear modulus G, energy G ((u_r - u/r) (v_r - v/r) + u_z v_z) r."""

    def __init__(self, body, edge, traction, tags):
        space = fem.FunctionSpace(body.mesh, ("Lagrange", body.degree))
        u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
        shear, r = body.young / (2.0 * (1.0 + body.poisson)), body.x[0]
        shear = body.number(shear)
        twist = lambda w: ufl.grad(w)[0] - w / r
        energy = shear * (twist(u) * twist(v) + ufl.grad(u)[1] * ufl.grad(v)[1]) * r * body.dx
        entities = np.concatenate([body.facets.find(tag) for tag in body.tags(edge)])
        dofs = fem.locate_dofs_topological(space, 1, entities)
        held = fem.dirichletbc(PETSc.ScalarType(0.0), dofs, space)
        matrix = fem_petsc.assemble_matrix(form(energy), bcs=[held])
        matrix.assemble()
        vector = fem_petsc.assemble_vector(form(traction * v * r * body.along(tags)))
        vector.array[dofs] = 0.0
        self.displacement = fem.Function(space)
        direct(matrix).solve(vector, self.displacement.vector)
