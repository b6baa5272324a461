"""Results: arrays without copies, files, pictures."""

import copy
import csv
import gc
import io
import json
import pickle
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import wearshape


@pytest.fixture(scope="module")
def drum() -> wearshape.Result:
    return wearshape.Scene("drum-brake-block").run()


def test_five_lines_give_a_shape() -> None:
    scene = wearshape.Scene("drum-brake-block")
    result = scene.set(**{"contact.friction": 0.1}, accuracy=1e-4).run()
    assert result.ok
    assert 0.1 < result.gap.max() < 10
    assert result.pressure @ result.weight == pytest.approx(result.summary["pressure"]["normal_force_N"], rel=1e-6)


def test_arrays_are_views_of_the_solvers_memory(drum: wearshape.Result) -> None:
    for name in ("s", "pressure", "gap", "weight", "wear_rate", "position"):
        array, again = getattr(drum, name), getattr(drum, name)
        assert not array.flags.owndata
        assert not array.flags.writeable
        assert array.__array_interface__["data"] == again.__array_interface__["data"]
    assert drum.position.shape == (len(drum.s), 3)
    assert np.shares_memory(drum.profile["gap_um"], drum.profile)


def test_arrays_outlive_their_result() -> None:
    result = wearshape.Scene("drum-brake-block").set(tasks=["pressure"]).run()
    pressure, profile = result.pressure, result.profile
    copy, gaps = pressure.copy(), profile["pressure_MPa"].copy()
    del result
    gc.collect()
    for _ in range(5):
        wearshape.Scene("drum-brake-block").set(tasks=["pressure"]).run()
    assert (pressure == copy).all()
    assert (profile["pressure_MPa"] == gaps).all()


def test_the_profile_is_contact_csv_bit_for_bit(drum: wearshape.Result) -> None:
    rows = list(csv.DictReader(io.StringIO(drum.files()["contact.csv"].decode())))
    names = drum.profile.dtype.names
    assert names is not None
    assert tuple(rows[0]) == names
    assert len(rows) == len(drum.profile)
    for name in names[:-1]:
        assert np.array_equal(drum.profile[name], [float(row[name]) for row in rows], equal_nan=True), name
    assert drum.profile["status"].tolist() == [row["status"] for row in rows]
    assert (drum.profile["gap_um"] == drum.gap).all()
    frame = drum.profile.to_pandas()
    assert list(frame.columns) == list(names)
    assert frame["gap_um"].max() == drum.gap.max()


def test_files_are_those_of_a_folder_and_are_saved(drum: wearshape.Result, tmp_path: Path) -> None:
    files = drum.files()
    assert {"report.html", "contact.csv", "summary.json", "scene.resolved.toml", "profile.dxf", "plots/gap.svg"} <= set(files)
    assert json.loads(files["summary.json"]) == drum.summary
    paths = drum.save(tmp_path / "out")
    assert {path.relative_to(tmp_path / "out").as_posix(): path.read_bytes() for path in paths} == files


def test_the_summary_says_what_came_of_it(drum: wearshape.Result) -> None:
    assert drum.status == "ok"
    assert drum.verdict == drum.summary["verdict"]
    assert drum.error["gap_relative"] < 1e-6
    assert drum.seconds["factor"] > 0
    assert len(drum.history) == 0


def test_a_run_in_time_has_a_history() -> None:
    result = wearshape.Scene("punch-wear").set(accuracy=1e-2).run()
    time_s = result.history["time_s"]
    assert len(time_s) > 3
    assert (np.diff(time_s) > 0).all()
    assert result.history.to_pandas()["time_s"].iloc[-1] == result.summary["wear"]["time_s"]


def test_a_run_without_an_answer_says_why() -> None:
    moment = wearshape.Scene("translating-punch").set({"load.moment": 1e6})
    result = moment.run()
    assert result.status == "refused"
    assert not result.ok
    with pytest.raises(wearshape.Error, match="no profile") as raised:
        _ = result.pressure
    assert raised.value.code == "no-profile"
    assert result.verdict in str(raised.value)


def test_points_of_the_table_are_chosen() -> None:
    scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
    assert len(scene.run(sample=11).s) == 11
    for sample, threads in ((1, None), (-3, None), (None, 0), (None, 10**30)):
        with pytest.raises(wearshape.Error, match="out of range") as raised:
            scene.run(sample=sample, threads=threads)
        assert raised.value.code == "wrong-argument"
        assert raised.value.place is None


def test_arguments_of_a_wrong_type_are_named_as_they_were_given() -> None:
    scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
    wrong: list[tuple[Any, str]] = [
        (lambda: scene.run(sample=1.5), "sample must be a whole number, not 1.5"),  # type: ignore[arg-type]
        (lambda: scene.run(threads="2"), "threads must be a whole number, not '2'"),  # type: ignore[arg-type]
        (lambda: scene.run(bodies=3), "bodies must be a wearshape.Bodies, not 3"),  # type: ignore[arg-type]
        (lambda: scene.run(resume="x"), "resume must be a wearshape.Result, not 'x'"),  # type: ignore[arg-type]
        (lambda: scene.set(5), "changes must be a mapping of keys to values, not 5"),  # type: ignore[arg-type]
        (lambda: wearshape.Scene(5), "source must be a name, a path, a text or a mapping, not 5"),  # type: ignore[arg-type]
        (lambda: wearshape.Scene("punch-wear", folder=5), "folder must be a path, not 5"),  # type: ignore[arg-type]
    ]
    for call, message in wrong:
        with pytest.raises(TypeError) as raised:
            call()
        assert str(raised.value) == message


def test_any_number_of_threads_gives_the_same_bits(drum: wearshape.Result) -> None:
    one = wearshape.Scene("drum-brake-block").run(threads=1)
    assert (one.gap == drum.gap).all()
    assert one.files() == drum.files()


def test_shared_bodies_are_factorised_once(drum: wearshape.Result) -> None:
    bodies = wearshape.Bodies()
    scene = wearshape.Scene("drum-brake-block")
    scene.set({"contact.friction": 0.2}).run(bodies=bodies)
    made = bodies.factorisations
    result = scene.run(bodies=bodies)
    assert bodies.factorisations == made
    assert bodies.reused > 0
    assert (result.gap == drum.gap).all()


def test_the_lock_is_released_while_it_computes() -> None:
    count = 0
    done = threading.Event()

    def run() -> None:
        wearshape.Scene("drum-brake-block").set(accuracy=1e-8).run()
        done.set()

    thread = threading.Thread(target=run)
    start = time.perf_counter()
    thread.start()
    while not done.is_set():
        count += 1
        time.sleep(0.001)
    # A lock that was held would have let this thread on a few times at most.
    assert count > 50 * (time.perf_counter() - start)


def test_pictures_for_a_notebook(drum: wearshape.Result) -> None:
    page = drum._repr_html_()
    assert drum.verdict in page
    assert page.count("<svg") == 2
    assert (drum._repr_svg_() or "").startswith("<svg")
    assert "<table" in drum.profile._repr_html_()


def test_plot_draws_pressure_and_gap(drum: wearshape.Result) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = drum.plot()
    assert [axes.get_ylabel() for axes in figure.axes] == ["pressure (MPa)", "gap (um)"]
    assert figure.axes[1].get_xlabel() == "angle (\u00b0)"


@pytest.mark.parametrize("name", ["rectangular-punch", "elliptic-punch", "disc-pad"])
def test_a_surface_of_two_dimensions_is_drawn_as_a_map(name: str) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    result = wearshape.Scene(name).run()
    surface, colours = result.plot().axes
    assert (surface.get_xlabel(), surface.get_ylabel(), colours.get_ylabel()) == ("x (mm)", "y (mm)", "pressure (MPa)")
    assert not surface.lines
    [drawn] = surface.collections
    low, high = drawn.get_clim()
    assert low <= result.pressure.min() and result.pressure.max() <= high < 1.02 * result.summary["pressure"]["p_max_MPa"]
    corners = drawn.get_datalim(surface.transData).get_points()
    assert (corners[0] <= result.position.min(axis=0)[:2]).all() and (result.position.max(axis=0)[:2] <= corners[1]).all()
    files = result.files()
    assert result._repr_svg_() == files["plots/map.svg"].decode()
    assert files["plots/map.svg"].decode() in result._repr_html_()
    assert files["plots/pressure.svg"].decode() not in result._repr_html_()


def test_a_pressure_on_points_or_lines_is_drawn_at_its_points() -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    found = wearshape.Scene("disc-pad").set({"optimum.functional": "wear-volume", "wear.b": 1.0}).run()
    assert found.summary["pressure"]["regime"] == "singular"
    assert np.shape(found.plot().axes[0].collections[0].get_offsets()) == (len(found.s), 2)


def test_a_copy_has_the_same_numbers_and_a_pickle_is_refused(drum: wearshape.Result) -> None:
    for again in (copy.copy(drum), copy.deepcopy(drum)):
        assert np.shares_memory(again.gap, drum.gap)
        assert again.summary == drum.summary and again.summary is not drum.summary
    with pytest.raises(TypeError, match=r"cannot be pickled\n  remedy: keep `result.summary`"):
        pickle.dumps(drum)
    kept = pickle.loads(pickle.dumps(drum.profile))
    assert (kept["gap_um"] == drum.gap).all()


WITHOUT = """
import sys
sys.modules[sys.argv[1]] = None  # as if it were not installed
import wearshape
scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
told = []
try:
    eval(sys.argv[2])
except ModuleNotFoundError as error:
    print(error, error.name, told)
"""


@pytest.mark.parametrize(
    ("module", "call", "extra"),
    [
        ("pandas", "scene.run().profile.to_pandas()", "pandas"),
        ("matplotlib", "scene.run().plot()", "plot"),
        ("xarray", "wearshape.sweep(scene, {'wear.b': [1, 2]}, progress=lambda share, words: told.append(share))", "sweep"),
        ("distributed", "wearshape.sweep(scene, {'wear.b': [1, 2]}, client=3)", "dask"),
        ("scipy", "wearshape.fit(scene, [], {})", "fit"),
        ("umbridge", "wearshape.umbridge(scene, ['wear.b'], ['pressure.p_max_MPa'])", "umbridge"),
    ],
)
def test_a_module_that_is_missing_is_named_with_its_extra_before_anything_is_computed(module: str, call: str, extra: str) -> None:
    done = subprocess.run([sys.executable, "-c", WITHOUT, module, call], capture_output=True, text=True, check=True)
    assert f"needs {module}" in done.stdout
    assert f"its extra `{extra}`" in done.stdout
    assert done.stdout.endswith("[]\n")


def test_a_column_is_an_array_like_any_other(drum: wearshape.Result) -> None:
    pressure = drum.profile["pressure_MPa"]
    assert type(pressure) is np.ndarray and isinstance(float(pressure.max()), float)
    assert not pressure.flags.writeable and np.shares_memory(pressure, drum.profile)
    assert type(drum.profile[["s_mm", "gap_um"]]) is type(drum.profile[1:3]) is type(drum.profile)


def test_a_pressure_alone_has_no_levels() -> None:
    assert wearshape.Scene("disc-pad").forecast() == []
    assert wearshape.Scene("drum-brake-block").set(tasks=["pressure"]).forecast() == []
