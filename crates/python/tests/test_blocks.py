"""The building blocks: pressures on points of one's own, bodies as matrices."""

from pathlib import Path

import numpy as np
import pytest
from wearshape import Error, hpfem, wear

MESHES = Path(__file__).parents[3] / "data" / "meshes"


def arc(count: int) -> wear.Surface:
    """A shoe of 60 degrees on a drum of 200 mm, 10 mm thick, by Gauss's rule."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    angle = np.pi / 6 * nodes
    normal = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
    drag = np.stack([-np.cos(angle), 0 * angle, np.sin(angle)], axis=1)
    return wear.Surface(200 * normal, normal, weights * np.pi / 6 * 200 * 10, np.full(count, 500.0), drag)


def test_a_worn_in_shoe_has_a_pressure_of_cosine_squared() -> None:
    surface = arc(20)
    law = wear.Law(2e-4 * 0.25**0.5, a=1, b=0.5)
    found = wear.optimal_pressure(surface, law, [wear.Press(1e4)], friction=0.25)
    cosine = np.asarray(surface.normal)[:, 2]
    assert found.pressure / cosine**2 == pytest.approx(np.full(20, found.pressure[0] / cosine[0] ** 2), rel=1e-12)
    assert found.resultants[0] == pytest.approx(1e4)
    assert found.steadiness_residual is not None
    assert found.steadiness_residual < 1e-12
    assert found.feed is not None
    assert not found.pressure.flags.owndata


def test_a_moment_tilts_the_pressure() -> None:
    nodes, weights = np.polynomial.legendre.leggauss(12)
    flat = wear.Surface(
        np.stack([30 * nodes, 0 * nodes, 0 * nodes], axis=1),
        np.tile([0.0, 0.0, 1.0], (12, 1)),
        300 * weights,
        np.full(12, 5.0),
        np.tile([1.0, 0.0, 0.0], (12, 1)),
    )
    found = wear.optimal_pressure(flat, wear.Law(1e-6), [wear.Press(1000), wear.Tilt(3000)])
    x = np.asarray(flat.position)[:, 0]
    assert found.pressure == pytest.approx(1000 / 600 + 3000 * x / (10 * 60**3 / 12), rel=1e-10)


def test_what_no_pressure_carries_is_refused() -> None:
    with pytest.raises(Error) as raised:
        wear.optimal_pressure(arc(20), wear.Law(1e-6), [wear.Press(-5)])
    assert raised.value.code == "pressure"
    with pytest.raises(Error, match="no functional"):
        wear.optimal_pressure(arc(20), wear.Law(1e-6), [wear.Press(5)], functional="lowest")
    with pytest.raises(Error, match=r"weight has the shape \(3,\)"):
        flat = arc(4)
        wear.optimal_pressure(wear.Surface(flat.position, flat.normal, [1, 2, 3], flat.sliding_speed, flat.drag), wear.Law(1), [])


def test_a_block_under_uniform_tension_stretches_as_it_must() -> None:
    mesh = hpfem.Mesh(MESHES / "punch.msh")
    x, z = mesh.vertices.T
    (height, width) = (np.ptp(z), np.ptp(x))
    young, poisson = 1000.0, 0.25
    materials = {name: (young, poisson) for name in mesh.materials}
    body = mesh.interface(
        "bottom", materials, degree=3, kinematics="plane-stress", thickness=10, supports={"top": ["z"]}, loads={"pull": {"bottom": (0, -2)}}
    )
    assert body.load_cases == ["pull"]
    stiffness = body.stiffness
    assert stiffness.shape == (len(stiffness), len(stiffness))
    assert np.abs(stiffness - stiffness.T).max() < 1e-9 * np.abs(stiffness).max()
    assert body.weight.sum() == pytest.approx(10 * width)
    # Free along x: one rigid mode, which the stiffness does not resist.
    assert body.rigid_modes.shape[1] == 1
    assert np.abs(stiffness @ body.rigid_modes).max() < 1e-8 * np.abs(stiffness).max()
    u = np.linalg.lstsq(stiffness, body.loads[:, 0], rcond=1e-12)[0]
    assert body.normal_rows @ u == pytest.approx(np.full(len(body.arc), 2 / young * height), rel=1e-8)
    along, _ = body.displacement_rows
    shrunk = along @ u
    assert np.ptp(shrunk) == pytest.approx(poisson * 2 / young * width, rel=1e-8)
    assert body.outward == pytest.approx(np.tile([0.0, -1.0], (len(body.arc), 1)))


def test_a_mesh_has_names_and_wrong_ones_are_refused() -> None:
    mesh = hpfem.Mesh((MESHES / "lining.msh").read_bytes())
    assert set(mesh.materials) == {"lining", "steel"}
    assert mesh.cells.shape == (len(mesh.cell_materials), 4)
    assert not mesh.vertices.flags.owndata
    moduli = {name: (1e3, 0.3) for name in mesh.materials}
    with pytest.raises(Error, match="nowhere"):
        mesh.interface("nowhere", moduli)
    with pytest.raises(Error, match="'steel'"):
        mesh.interface(mesh.boundaries[0], {"lining": (1e3, 0.3)})
    with pytest.raises(Error) as raised:
        hpfem.Mesh(b"$MeshFormat\n")
    assert raised.value.code == "mesh-file"
