"""Sweeps: on threads, and on a cluster of two processes."""

import os
import platform
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import wearshape

xarray = pytest.importorskip("xarray")
distributed = pytest.importorskip("distributed")

DRUM = wearshape.Scene("drum-brake-block").set(accuracy=1e-3)
GRID = {"contact.friction": np.linspace(0.05, 0.4, 8), "wear.b": [0.5, 1.0, 2.0]}


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def bare() -> Any:
    return wearshape.sweep(DRUM, GRID)


def test_a_sweep_is_a_dataset_over_its_keys(bare: Any) -> None:
    assert bare["pressure.torque_Nmm"].dims == ("contact.friction", "wear.b")
    assert bare.gap_um.shape == (8, 3, 101)
    assert (bare.status == "ok").all()
    one = DRUM.set({"contact.friction": bare["contact.friction"].values[3], "wear.b": 1.0}).run(sample=101)
    point = bare.isel({"contact.friction": 3}).sel({"wear.b": 1.0})
    assert (point.gap_um == one.gap).all()
    assert float(point["pressure.torque_Nmm"]) == one.summary["pressure"]["torque_Nmm"]


def test_points_without_an_answer_say_why() -> None:
    scene = wearshape.Scene("translating-punch").set(tasks=["pressure"])
    found = wearshape.sweep(scene, {"load.moment": [0.0, 1e6], "contact.friction": [0.25, -1.0]})
    assert found.status.values.tolist() == [["ok", "invalid"], ["refused", "invalid"]]
    assert found.reason.values[0, 0] == ""
    assert "edge" in found.reason.values[1, 0] or "moment" in found.reason.values[1, 0]
    assert "contact.friction" in found.reason.values[0, 1]
    assert np.isnan(found["pressure.p_max_MPa"].values).tolist() == [[False, True], [True, True]]


@pytest.mark.parametrize("sample", [1, 0, -5])
def test_too_few_places_are_refused_before_any_point(sample: int) -> None:
    told: list[float] = []
    with pytest.raises(wearshape.Error, match=f"sample = {sample} is out of range") as raised:
        wearshape.sweep(DRUM, GRID, sample=sample, progress=lambda share, words: told.append(share))
    assert raised.value.remedy == "give 2 to 1000000 points"
    assert not told


def test_arguments_of_a_wrong_type_are_named_as_they_were_given() -> None:
    with pytest.raises(TypeError, match=r"^sample must be a whole number, not 'many'$"):
        wearshape.sweep(DRUM, GRID, sample="many")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"^scene must be a wearshape.Scene, not 'drum'$"):
        wearshape.sweep("drum", GRID)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"^over must be a mapping of keys to values, not \['wear.b'\]$"):
        wearshape.sweep(DRUM, ["wear.b"])  # type: ignore[arg-type]


def test_a_value_that_stands_alone_is_one_point() -> None:
    for alone in (0.5, np.float64(0.5), np.array(0.5)):
        assert wearshape.sweep(DRUM, {"wear.b": alone}).sizes["wear.b"] == 1


def test_a_key_that_no_scene_has_is_an_error_as_in_a_run() -> None:
    with pytest.raises(wearshape.Error, match="unknown key `bb`") as raised:
        wearshape.sweep(DRUM, {"wear.bb": [1, 2]})
    assert raised.value.code == "unknown-key"
    # One that stands in some points alone is a row.
    punch = wearshape.Scene("translating-punch").set(tasks=["pressure"])
    found = wearshape.sweep(punch, {"contact": [{"friktion": 0.1}, {"edges": ["bottom", "top"], "friction": 0.2, "gap": 0}]})
    assert found.status.values.tolist() == ["invalid", "ok"]


def test_short_lists_of_the_summary_are_variables() -> None:
    hertz = wearshape.Scene("hertz-cylinder").set(accuracy=1e-3)
    found = wearshape.sweep(hertz, {"load.force": ["30 kN", "35 kN"]})
    one = hertz.set({"load.force": "35 kN"}).run().summary
    assert found["contact.ends_mm.1"].values[1] == one["contact"]["ends_mm"][1]
    assert found["contact.ends_mm.0"].values[0] == -found["contact.ends_mm.1"].values[0]


def test_numbers_beside_words_stay_numbers() -> None:
    scene = DRUM.set(tasks=["pressure"])
    found = wearshape.sweep(scene, {"load.force": [1e4, "20 kN", 30000], "wear.b": [0.5, 1]})
    assert found["load.force"].values.tolist() == [1e4, "20 kN", 30000]
    force = found.sel({"load.force": 30000, "wear.b": 1.0})["pressure.force_N"]
    assert float(force) == pytest.approx(3e4)
    assert found["wear.b"].dtype == np.float64


def test_nothing_to_sweep_over_is_an_error() -> None:
    with pytest.raises(wearshape.Error, match="nothing to sweep"):
        wearshape.sweep(DRUM, {})


def test_a_sweep_that_was_stopped_says_what_is_missing() -> None:
    found = wearshape.sweep(DRUM, GRID, progress=lambda share, words: share < 0.5)
    assert (found.status == "ok").sum() == 12
    assert (found.status == "interrupted").sum() == 12


def test_a_cluster_gives_the_same_numbers(client: Any, bare: Any) -> None:
    found = wearshape.sweep(DRUM, GRID, client=client)
    xarray.testing.assert_identical(found.drop_vars("seconds"), bare.drop_vars("seconds"))


def test_a_killed_worker_loses_no_point(client: Any, bare: Any) -> None:
    killed: list[int] = []

    def kill_one(share: float, words: str) -> None:
        if share > 0.2 and not killed:
            killed.append(next(iter(client.run(os.getpid).values())))
            os.kill(killed[0], signal.SIGKILL)

    found = wearshape.sweep(DRUM, GRID, client=client, progress=kill_one)
    assert killed
    xarray.testing.assert_identical(found.drop_vars("seconds"), bare.drop_vars("seconds"))
    client.wait_for_workers(2, timeout=30)
    assert killed[0] not in client.run(os.getpid).values()


def test_a_cancelled_sweep_leaves_the_cluster_idle(client: Any) -> None:
    many = {"contact.friction": np.linspace(0.01, 0.4, 400)}
    start = time.perf_counter()
    found = wearshape.sweep(DRUM, many, client=client, progress=lambda share, words: False)
    assert (found.status == "interrupted").sum() > 300
    while any(client.processing().values()):
        assert time.perf_counter() - start < 30
        time.sleep(0.05)


FAULTS = """
import contextlib, resource, statistics, sys, wearshape
from wearshape import _sweep
scene = wearshape.Scene("drum-brake-block").set(accuracy=1e-6)
points = [{"contact.friction": mu} for mu in (.05, .08, .1, .12, .15, .18, .2, .22, .25, .3)]
def faults(batch):
    start = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    assert len(_sweep._batch("one", scene, batch, 101)) == len(batch)
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - start
def of_further_points():
    return statistics.median(faults(points) - faults(points[:2]) for _ in range(5))
if sys.argv[1] == "plain":
    _sweep._memory_kept = contextlib.nullcontext
faults(points)
print(of_further_points())
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="a setting of glibc")
def test_workers_keep_their_memory_between_points() -> None:
    environment = os.environ | {"MALLOC_TRIM_THRESHOLD_": "65536"}

    def faults(memory: str) -> float:
        done = subprocess.run([sys.executable, "-c", FAULTS, memory], env=environment, capture_output=True, text=True, check=True)
        return float(done.stdout)

    # A process for each: what one that kept its memory gives back later depends on what lies above it. Measured: 300 and 20 000.
    assert faults("kept") < faults("plain") / 3
