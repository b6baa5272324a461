"""Scenes: where they come from, what changes them, what is wrong with them."""

import pickle
from pathlib import Path

import numpy as np
import pytest
import wearshape

MESHES = Path(__file__).parents[3] / "data" / "meshes"

PUNCH = {
    "units": "N-mm",
    "kinematics": "plane-stress",
    "thickness": 10,
    "tasks": ["pressure"],
    "body1": {
        "geometry": {"rectangle": {"x": [-30, 30], "z": [100, 200]}},
        "material": {"young": "210 GPa", "poisson": 0.3},
        "support": {"top": ["x"]},
    },
    "body2.geometry.rectangle": {"x": [-60, 60], "z": [0, 100]},
    "body2.material": {"young": "210 GPa", "poisson": 0.3},
    "body2.support.bottom": ["x", "z"],
    "contact": {"edges": ["bottom", "top"], "friction": np.float64(0.25)},
    "sliding.speed": "5 mm/s",
    "load": {"edge": "top", "as": "rigid", "force": "1 kN"},
    "wear": {"beta": np.array([2e-4, 0.0]), "a": 1, "b": np.int64(2)},
}


def test_a_name_a_file_a_text_and_a_mapping_are_scenes(tmp_path: Path) -> None:
    assert "drum-brake-block" in wearshape.scenes()
    text = wearshape.Scene("translating-punch").resolved
    (tmp_path / "mine.toml").write_text(text)
    scenes = [wearshape.Scene(source) for source in ("translating-punch", text, tmp_path / "mine.toml", str(tmp_path / "mine.toml"))]
    pressures = [scene.set(tasks=["pressure"]).run().pressure for scene in scenes]
    assert all((pressure == pressures[0]).all() for pressure in pressures)
    assert scenes[2].name == "mine"
    own = wearshape.Scene(PUNCH).run()
    assert own.status == "ok"
    assert own.summary["pressure"]["force_N"] == pytest.approx(1000)


def test_set_returns_another_scene_and_leaves_the_first_alone() -> None:
    scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
    other = scene.set({"contact.friction": 0.1}, **{"load.force": "5 kN"})
    both = [each.run().summary["pressure"]["torque_Nmm"] for each in (scene, other)]
    assert both[1] < 0.3 * both[0]
    assert "contact.friction=0.1" in repr(other)
    assert "friction = 0.25" in scene.resolved
    # Alternatives replace each other; numpy's numbers and arrays are values.
    worn = scene.set({"wear.k": np.array([1e-7, 0.0])})
    assert "beta" not in worn.resolved


def test_the_summary_of_a_scene_is_that_of_its_resolved_text() -> None:
    scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
    again = wearshape.Scene(scene.resolved)
    first, second = scene.run().summary, again.run().summary
    assert first["scene_sha256"] == second["scene_sha256"]
    assert first["pressure"] == second["pressure"]


@pytest.mark.parametrize(
    ("source", "code", "key", "line"),
    [
        ("units = \"N-mm\"\nthicknes = 3\n", "unknown-key", "thicknes", 2),
        ("a = 1\nb", "syntax", None, 2),
        ("drum-break", "no-scene", None, None),
        ("", "empty-scene", None, None),
        (" ", "empty-scene", None, None),
    ],
)
def test_what_cannot_be_read_is_an_error_with_its_place(source: str, code: str, key: str | None, line: int | None) -> None:
    with pytest.raises(wearshape.Error) as raised:
        wearshape.Scene(source)
    error = raised.value
    assert (error.code, error.key) == (code, key)
    assert error.remedy
    assert (error.place.line if error.place else None) == line


def test_a_wrong_value_is_an_error_that_names_the_change() -> None:
    with pytest.raises(wearshape.Error) as raised:
        wearshape.Scene("drum-brake-block").set({"contact.friction": -1}).check()
    error = raised.value
    assert error.key == "contact.friction"
    assert error.place == wearshape.Place("set()", None, None, "contact.friction=-1")
    assert "friction" in str(error)
    assert error.remedy in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (again.code, again.place, str(again)) == (error.code, error.place, str(error))


def test_a_value_that_is_none_of_tomls_is_refused() -> None:
    with pytest.raises(TypeError, match="numbers, texts"):
        wearshape.Scene("drum-brake-block").set(title=object())
    with pytest.raises(TypeError, match="^load.force: a scene holds numbers, texts"):
        wearshape.Scene("drum-brake-block").set({"load.force": b"10 kN"})
    with pytest.raises(TypeError, match="^load.force: a whole number of a scene has 64 bits"):
        wearshape.Scene("drum-brake-block").set({"load.force": 10**5000})
    with pytest.raises(TypeError, match="^a key must be a text, not 3$"):
        wearshape.Scene({3: 1})  # type: ignore[dict-item]


def test_check_tells_stages_lints_and_unused_keys() -> None:
    check = wearshape.Scene("drum-brake-block").set({"contact.friction": 0, "optimum.q": 3}).check()
    assert any(stage.name == "shape" and stage.runs for stage in check.stages)
    assert all(stage.because for stage in check.stages)
    assert check.lints
    assert check.unused_keys == ["optimum.q"]


def test_forecast_has_a_level_for_each_degree() -> None:
    levels = wearshape.Scene("drum-brake-block").set(accuracy=1e-3).forecast()
    assert [level.degree for level in levels[:3]] == [4, 6, 8]
    assert all(level.about_seconds > 0 and level.dofs > level.trace_dofs for level in levels)


def test_a_pickled_scene_brings_its_files_along() -> None:
    scene = wearshape.Scene(MESHES / "lining.toml").set(accuracy=1e-2)
    packed = pickle.dumps(scene)
    assert len(packed) > (MESHES / "lining.msh").stat().st_size
    again = pickle.loads(packed)
    again._folder = Path("nowhere")
    assert again.run().summary == scene.run().summary


def test_a_scene_draws_itself() -> None:
    assert wearshape.Scene("drum-brake-block")._repr_svg_().startswith("<svg")
