"""Steady temperatures of two bodies that friction heats, by dolfinx, on meshes that match along the contact.

div(k grad T) = 0; edges are held, cooled by convection or insulated. Friction makes q = mu p v. By a
share, q_1 = s q and q_2 = (1 - s) q; by a conductance h, q_1 = q/2 + h (T_2 - T_1) and q_2 the rest, at
the contact; by an infinite one both bodies have one temperature there. A ring that revolves has one temperature
along its circle, fed by all that goes into it, evenly. Heat is per unit thickness or radian.
"""

import math

import dolfinx.fem.petsc as fem_petsc
import numpy as np
import scene as scenes
import scipy.sparse as sparse
import ufl
from body import Body, form
from dolfinx import fem
from gap import contact_middle, load_ends, support
from mesh import centre_line, mark, outline, split, triangulate
from scipy.sparse.linalg import splu


def matching_body(scene, surface, number, breaks, coarse, degree):
    """Body 1 or 2 with one cell between any two neighbouring breaks of the contact, and the tags of the contact."""
    part = scene[f"body{number}"]
    template, values = scenes.geometry(part)
    points = [tuple(p) for p in surface.on_body(breaks, number)]
    loops = split(outline(template, values, surface.axisymmetric), points + (load_ends(scene, surface) if number == 1 else []))
    edge = scene["contact"]["edges"][number - 1]
    mark(loops, edge, lambda x, z: contact_middle(surface, x, z, number))
    cut = centre_line(template, values) if "centre" in part.get("support", {}) else None
    if cut is not None:
        loops = split(loops, [cut.a, cut.b])
    corners = {s.a for loop in loops for s in loop if not s.contact and template != "ring"}
    sharp = sorted(corners | {points[0], points[-1]})
    cells = [1 if s.contact else None for loop in loops for s in loop]
    widths = np.hypot(*np.diff(np.array(points), axis=0).T)
    mesh, facets, segments = triangulate(
        loops, coarse * widths.sum(), 3, sharp, float(widths.min()), 0.3, divisions=cells, near=float(widths.max()), cut=cut)
    young, nu = scenes.material(part)
    body = Body(mesh, facets, segments, young, nu, scene["kinematics"], degree)
    support(body, scene, number)
    body.factor()
    return body, body.tags(edge, True)


class Conductor:
    """Conduction in one body: the matrix without held temperatures, its own heat, and what is held."""

    def __init__(self, body, part, edge, contact, outside=1.0):
        """`outside`: the part of a revolving body's touching circle that its convection acts on."""
        self.body, self.contact = body, contact
        self.space = fem.FunctionSpace(body.mesh, ("Lagrange", body.degree))
        self.test = ufl.TestFunction(self.space)
        trial, weight = ufl.TrialFunction(self.space), body.weight()
        conductivity = scenes.quantity(part["material"]["conductivity"])
        self.matrix = sparse_matrix(body.number(conductivity) * ufl.inner(ufl.grad(trial), ufl.grad(self.test)) * weight * body.dx)
        self.own = np.zeros(self.space.dofmap.index_map.size_local)
        self.held = {}
        for name, heat in part.get("heat", {}).items():
            tags = body.tags(name, False) if name == edge and outside == 1.0 else body.tags(name)
            share = outside if name == edge else 1.0
            if "convection" in heat:
                film = share * scenes.quantity(heat["convection"])
                self.matrix += sparse_matrix(body.number(film) * trial * self.test * weight * body.along(tags))
                self.own += self.heat(film * scenes.quantity(heat["ambient"]), tags)
            elif "flux" in heat:
                self.own += self.heat(scenes.quantity(heat["flux"]), tags)
            else:
                found = np.concatenate([body.facets.find(tag) for tag in tags])
                dofs = fem.locate_dofs_topological(self.space, 1, found)
                self.held.update(dict.fromkeys(dofs.tolist(), scenes.quantity(heat["temperature"])))
        # Nodes of the contact in order, and int u v on them.
        found = np.concatenate([body.facets.find(tag) for tag in contact])
        dofs = fem.locate_dofs_topological(self.space, 1, found)
        self.touching = dofs
        self.surface = sparse_matrix(trial * self.test * weight * body.along(contact))

    def heat(self, flux, tags):
        """Nodal heat of a flux into the body on segments."""
        flux = self.body.number(flux) if isinstance(flux, (int, float)) else flux
        return fem_petsc.assemble_vector(form(flux * self.test * self.body.weight() * self.body.along(tags))).array.copy()

    def in_order(self, surface):
        """Nodes of the contact in the order of the coordinate."""
        where = self.space.tabulate_dof_coordinates()[self.touching]
        return self.touching[np.argsort(surface.coordinate(where[:, 0], where[:, 1]))]

    def field(self, values):
        temperature = fem.Function(self.space)
        temperature.vector.array[:] = values
        return temperature


def sparse_matrix(bilinear):
    """An assembled matrix for scipy."""
    matrix = fem_petsc.assemble_matrix(form(bilinear))
    matrix.assemble()
    rows, columns, values = matrix.getValuesCSR()
    return sparse.csr_matrix((values, columns, rows), shape=matrix.getSize())


def fixed(matrix, right, held):
    """The solution of a system with held unknowns."""
    values = np.zeros(len(right))
    dofs = np.array(sorted(held), dtype=int)
    if len(dofs):
        values[dofs] = [held[d] for d in dofs]
    free = np.setdiff1d(np.arange(len(right)), dofs)
    rest = right[free] - (matrix @ values)[free]
    values[free] = splu(matrix[free][:, free].tocsc()).solve(rest)
    return values


def temperatures(pair, nodes, sources, conductance):
    """Nodal temperatures of both bodies; `sources`: nodal heat into each by its share, or of each half of the friction."""
    right = [c.own + f for c, f in zip(pair, sources)]
    if conductance is None:
        return [fixed(c.matrix, r, c.held) for c, r in zip(pair, right)]
    first, second = pair
    n = len(right[0])
    # Body 2's contact nodes in the numbering of body 1's.
    size = (len(right[0]), len(right[1]))
    match = sparse.csr_matrix((np.ones(len(nodes[0])), (nodes[0], nodes[1])), shape=size)
    if math.isinf(conductance):
        # One unknown for both: body 2's contact nodes are those of body 1.
        others = np.setdiff1d(np.arange(size[1]), nodes[1])
        rows = np.concatenate([np.arange(n), n + nodes[1], n + others])
        columns = np.concatenate([np.arange(n), nodes[0], n + np.arange(len(others))])
        take = sparse.csr_matrix((np.ones(len(rows)), (rows, columns)), shape=(n + size[1], n + len(others)))
        whole = sparse.block_diag([first.matrix, second.matrix]).tocsr()
        position = dict(zip(others.tolist(), range(n, n + len(others)))) | dict(zip(nodes[1].tolist(), nodes[0].tolist()))
        held = dict(first.held) | {position[d]: v for d, v in second.held.items()}
        found = take @ fixed((take.T @ whole @ take).tocsr(), take.T @ np.concatenate(right), held)
        return [found[:n], found[n:]]
    across = conductance * (first.surface @ match)
    whole = sparse.bmat([[first.matrix + conductance * first.surface, -across],
                         [-across.T, second.matrix + conductance * second.surface]]).tocsr()
    held = dict(first.held) | {n + d: v for d, v in second.held.items()}
    found = fixed(whole, np.concatenate(right), held)
    return [found[:n], found[n:]]


def beside_ring(pair, sources, conductance, circle):
    """Nodal temperatures of body 1 and of a ring that revolves under it, and the heat into the ring. `sources`: nodal heat of each half of
    the friction; `circle`: the segments of the ring's touching circle."""
    first, ring = pair
    if math.isinf(conductance):
        raise ValueError("a revolving ring is known here with a finite conductance alone")
    along = ring.heat(1.0, circle)
    length = float(np.sum(along))
    # The ring without heat from the contact and with a unit of it spread along the circle: its mean temperature there is a + b Q.
    still = fixed(ring.matrix, ring.own, ring.held)
    unit = fixed(ring.matrix, along / length, dict.fromkeys(ring.held, 0.0))
    a, b = along @ still / length, along @ unit / length
    # Body 1 beside a ring at 0, and what a degree more of the ring adds.
    touching = conductance * first.heat(1.0, first.contact)
    matrix = (first.matrix + conductance * first.surface).tocsr()
    cool = fixed(matrix, first.own + sources[0], first.held)
    degree = fixed(matrix, touching, dict.fromkeys(first.held, 0.0))
    # Q = F + h int (T_1 - T), T = a + b Q.
    half, crossing = float(np.sum(sources[1])), float(touching @ degree - np.sum(touching))
    heat = (half + touching @ cool + a * crossing) / (1.0 - b * crossing)
    return [cool + (a + b * heat) * degree, still + heat * unit], float(heat)
