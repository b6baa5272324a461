"""Two bodies reduced to their contact nodes: compliance at matching P2 nodes, and contact on it.

Both meshes have the same vertices along the contact. A nodal force f_j acts on body 1 along
n + mu tau and on body 2 against it; opening = g0 + C f + external - sum_k phi_k delta_k.
"""

import math

import numpy as np
import scene as scenes
from body import Body
from dolfinx import fem
from gap import contact_middle, load_ends, own_load, support
from mesh import centre_line, mark, outline, split, triangulate
from petsc4py import PETSc


def division(low, high, cells, smallest, slope):
    """Break points of [low, high]: cells of (high - low)/cells, shrinking towards both ends."""
    span = high - low
    half = [0.0]
    while half[-1] < 0.5 * span:
        half.append(half[-1] + min(span / cells, max(smallest * span, slope * half[-1])))
    half = np.array(half) * (0.5 * span / half[-1])
    return np.concatenate([low + half, (high - half[:-1])[::-1]])


class Interface:
    """Compliance of the pair at the contact nodes.

    c: coordinate of the nodes; weight: area of the nodes (mm^2); compliance: opening per force
    (mm/N); external: opening by body 1's own load (mm); modes phi, psi at the nodes.
    """

    def __init__(self, scene, surface, breaks, coarse, sign=1.0, grade=True):
        self.surface, self.breaks = surface, np.asarray(breaks)
        self.modes = scenes.modes(scene, surface)
        middles = 0.5 * (self.breaks[:-1] + self.breaks[1:])
        self.c = np.sort(np.concatenate([self.breaks, middles]))
        self.friction = sign * surface.friction if surface.shear and not surface.axisymmetric else 0.0
        self.weight = self._weights()
        load = scene["load"]
        self.rigid = load["as"] == "rigid"
        self.given = "approach" in load
        # One radian of an axisymmetric body, one millimetre of a plane one.
        self.depth = 2.0 * math.pi if surface.axisymmetric else surface.thickness
        responses = [self._response(scene, number, coarse, grade) for number in (1, 2)]
        self.compliance = (responses[0][0] + responses[1][0]) / self.depth
        self.external = responses[0][1]

    def _weights(self):
        simpson = np.zeros(len(self.c))
        for i, length in enumerate(np.diff(self.breaks)):
            simpson[2 * i:2 * i + 3] += length / 6.0 * np.array([1.0, 4.0, 1.0])
        return simpson * self.surface.area(self.c)

    def _response(self, scene, number, coarse, grade):
        """(normal displacement per unit nodal force, normal displacement under the own load)."""
        body, nodes = self._build(scene, number, coarse, grade)
        n, tau = self.surface.normal(self.c), self.surface.drag(self.c)
        pull = n + self.friction * tau
        size, count = body.matrix.getSize()[0], len(self.c)
        loads = np.zeros((size, count), order="F")
        for i in range(2):
            loads[2 * nodes + i, np.arange(count)] = pull[:, i]
        loads[body.held, :] = 0.0
        right = PETSc.Mat().createDense((size, count), array=loads, comm=PETSc.COMM_SELF)
        left = PETSc.Mat().createDense((size, count), comm=PETSc.COMM_SELF)
        left.setUp()
        body.solver.getPC().getFactorMatrix().matSolve(right, left)
        found = left.getDenseArray()
        along = lambda u: n[:, :1] * u[2 * nodes] + n[:, 1:] * u[2 * nodes + 1]
        external = np.zeros(count)
        if number == 1 and not self.rigid:
            own = own_load(scene, body)
            force = scenes.quantity(scene["load"]["force"]) / self.depth
            own *= -force / body.resultant(own, 1)
            displacement = body.solve(own)  # named: its memory goes with it
            external = along(displacement.vector.array.copy()[:, None])[:, 0]
        return along(found), external

    def _build(self, scene, number, coarse, grade):
        surface, part = self.surface, scene[f"body{number}"]
        template, values = scenes.geometry(part)
        points = [tuple(p) for p in surface.on_body(self.breaks, number)]
        loops = split(outline(template, values, surface.axisymmetric), points + (load_ends(scene, surface) if number == 1 else []))
        edge = scene["contact"]["edges"][number - 1]
        mark(loops, edge, lambda x, z: contact_middle(surface, x, z, number))
        ends = [points[0], points[-1]]
        cut = centre_line(template, values) if "centre" in part.get("support", {}) else None
        if cut is not None:
            loops = split(loops, [cut.a, cut.b])
        corners = {s.a for loop in loops for s in loop if not s.contact and template != "ring"}
        sharp = sorted((corners | set(ends)) if grade else corners)
        cells = [1 if s.contact else None for loop in loops for s in loop]
        widths = np.hypot(*np.diff(np.array(points), axis=0).T)
        mesh, facets, segments = triangulate(
            loops, coarse * (widths.sum()), 3, sharp, float(widths.min()), 0.4, divisions=cells, near=float(widths.max()), cut=cut)
        young, nu = scenes.material(part)
        body = Body(mesh, facets, segments, young, nu, scene["kinematics"], 2)
        support(body, scene, number)
        body.factor()
        entities = np.concatenate([facets.find(tag) for tag in body.tags(edge, True)])
        dofs = fem.locate_dofs_topological(body.space, 1, entities)
        where = body.space.tabulate_dof_coordinates()[dofs]
        order = np.argsort(surface.coordinate(where[:, 0], where[:, 1]))
        if len(dofs) != len(self.c):
            raise ValueError(f"body {number}: {len(dofs)} contact nodes, {len(self.c)} wanted")
        return body, dofs[order]

    def touch(self, gap, goal, active=None, given=None):
        """Signorini on the compliance by a primal-dual active set.

        `gap`: unloaded gap at the nodes (mm); `goal`: resultants (N, N mm) of the modes, or
        `given`: prescribed closings (mm). Returns (forces in N, closings, active set)."""
        phi = np.column_stack([m[0](self.c) for m in self.modes])
        psi = np.column_stack([m[1](self.c) for m in self.modes])
        counts = self.weight > 0.0
        active = counts.copy() if active is None else active & counts
        loose = gap + self.external
        for _ in range(100):
            a = np.flatnonzero(active)
            if given is not None:
                closing = np.atleast_1d(given)
                found = np.linalg.solve(self.compliance[np.ix_(a, a)], phi[a] @ closing - loose[a])
            else:
                k = phi.shape[1]
                matrix = np.block([[self.compliance[np.ix_(a, a)], -phi[a]], [psi[a].T, np.zeros((k, k))]])
                scale = np.concatenate([np.ones(len(a)), np.full(k, np.abs(matrix[: len(a), : len(a)]).max())])
                whole = np.linalg.solve(matrix * scale[:, None], np.concatenate([-loose[a], goal]) * scale)
                found, closing = whole[: len(a)], whole[len(a):]
            force = np.zeros(len(self.c))
            force[a] = found
            opening = loose + self.compliance @ force - phi @ closing
            following = counts & np.where(active, force > 0.0, opening < -1e-14 * (1.0 + np.abs(closing).max()))
            if np.array_equal(following, active):
                return force, closing, active
            active = following
        raise ValueError("the active set does not settle")

    def pressure(self, force):
        """Nodal pressures of nodal forces, N/mm^2; 0 where a node has no area (on the axis)."""
        return np.divide(force, self.weight, out=np.zeros_like(force), where=self.weight > 0.0)

    def at(self, values, c):
        """Quadratic interpolation of nodal values at coordinates c."""
        cell = np.clip(np.searchsorted(self.breaks, c, side="right") - 1, 0, len(self.breaks) - 2)
        t = (c - self.breaks[cell]) / (self.breaks[cell + 1] - self.breaks[cell])
        v = np.stack([values[2 * cell], values[2 * cell + 1], values[2 * cell + 2]])
        return v[0] * (1 - t) * (1 - 2 * t) + v[1] * 4 * t * (1 - t) + v[2] * t * (2 * t - 1)
