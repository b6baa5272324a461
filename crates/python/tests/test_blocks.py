"""The building blocks: pressures on points of one's own, bodies as matrices."""

import dataclasses
from pathlib import Path
from typing import Any

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


@pytest.mark.parametrize(
    ("argument", "value", "message"),
    [
        ("position", np.full((20, 3), np.nan), r"position\[0, 0\] = nan is not finite"),
        ("position", "far", "position is no array of numbers"),
        ("normal", np.zeros((20, 3)), r"normal\[0\] = \[0.0, 0.0, 0.0\] is no unit vector"),
        ("normal", 2 * np.asarray(arc(20).normal), r"normal\[0\] = .* is no unit vector"),
        ("normal", np.zeros((19, 3)), r"normal has the shape \(19, 3\)"),
        ("drag", np.full((20, 3), np.inf), r"drag\[0, 0\] = inf is not finite"),
        ("drag", 0.5 * np.asarray(arc(20).drag), r"drag\[0\] = .* is neither a unit vector nor zero"),
        ("drag", np.asarray(arc(20).normal), r"drag\[0\] = .* is no tangent"),
        ("weight", 1j * np.ones(20), "weight is no array of numbers: they are complex"),
        ("weight", np.linspace(1, -0.25, 20), r"weight\[16\] = .* is negative"),
        ("weight", None, "weight"),
        ("sliding_speed", np.linspace(3, -1, 20), r"sliding_speed\[15\] = .* is negative"),
        ("sliding_speed", [500.0] * 19 + [np.nan], r"sliding_speed\[19\] = nan is not finite"),
    ],
)
def test_points_that_make_no_surface_are_refused_by_their_argument(argument: str, value: Any, message: str) -> None:
    with pytest.raises(Error, match=message) as raised:
        wear.optimal_pressure(dataclasses.replace(arc(20), **{argument: value}), wear.Law(1e-6), [wear.Press(5)])
    assert raised.value.key == argument
    assert raised.value.remedy.startswith("give ")


def test_motions_that_are_none_are_refused_by_their_place() -> None:
    for motion, message in (
        (wear.Press(np.nan), r"motions\[1\].force = nan is not finite"),
        (wear.Press(5, (0, 0, -2)), r"motions\[1\].direction = .* is no unit vector"),
        (wear.Press(5, (0, -1)), r"motions\[1\].direction has the shape \(2,\)"),
        (wear.Tilt(5, about=(0, np.inf, 0)), r"motions\[1\].about\[1\] = inf is not finite"),
    ):
        with pytest.raises(Error, match=message):
            wear.optimal_pressure(arc(20), wear.Law(1e-6), [wear.Press(5), motion])


def test_arguments_of_a_wrong_type_are_named_as_they_were_given() -> None:
    def pressed(surface: Any = arc(20), law: Any = wear.Law(1e-6), motions: Any = (wear.Press(5),), **more: Any) -> Any:
        return lambda: wear.optimal_pressure(surface, law, motions, **more)

    def body(keep: Any = "bottom", materials: Any = {"steel": (1000, 0.25)}, **more: Any) -> Any:
        return lambda: hpfem.Mesh(MESHES / "punch.msh").interface(keep, materials, **more)

    for call, message in (
        (pressed(surface=5), "surface must be a wearshape.wear.Surface, not 5"),
        (pressed(law=1e-6), "law must be a wearshape.wear.Law, not 1e-06"),
        (pressed(law=wear.Law(1e-6, a="one")), "law.a must be a number, not 'one'"),  # type: ignore[arg-type]
        (pressed(motions=wear.Press(5)), "motions must be a list of wearshape.wear.Press and Tilt, not "),
        (pressed(motions=[5]), "motions[0] must be a wearshape.wear.Press or Tilt, not 5"),
        (pressed(motions=[wear.Press("5")]), "motions[0].force must be a number, not '5'"),  # type: ignore[arg-type]
        (pressed(friction="low"), "friction must be a number, not 'low'"),
        (pressed(functional=3), "functional must be a word, not 3"),
        (pressed(q=None), "q must be a number, not None"),
        (body(keep=3), "keep must be the name of a boundary, not 3"),
        (body(materials=[(1000, 0.25)]), "materials must be a mapping of names to moduli, not "),
        (body(degree="4"), "degree must be a whole number, not '4'"),
        (body(thickness="thin"), "thickness must be a number, not 'thin'"),
        (body(supports={"top": 3}), "supports['top'] must be a list of directions, not 3"),
        (body(loads={"pull": {3: (0, 1)}}), "a boundary in loads['pull'] must be a name, not 3"),
        (lambda: hpfem.Mesh(5), "source must be a path or the bytes of a file, not 5"),  # type: ignore[arg-type]
    ):
        with pytest.raises(TypeError) as raised:
            call()
        assert str(raised.value).startswith(message)
    with pytest.raises(Error, match=r"materials\['steel'\] has the shape \(3,\)"):
        body(materials={"steel": (1, 2, 3)})()
    with pytest.raises(Error, match="degree = -4 is out of range"):
        body(degree=-4)()


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
