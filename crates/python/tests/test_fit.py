"""Fits: what was put in comes back, within what is said of it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import wearshape

pytest.importorskip("scipy")

RATE = "pressure.wear_volume_rate_mm3_per_s"
TRUE = {"wear.beta.0": 2e-4, "wear.a": 1.1, "wear.b": 0.8}
DRUM = wearshape.Scene("drum-brake-ring").set(tasks=["pressure"])
#: Force (N) and speed (rad/s) of six wear tests.
TESTS = [{"load.force": force, "sliding.omega": omega} for force in (4e3, 1e4, 2.5e4) for omega in (1.0, 6.0)]


def rates() -> list[float]:
    return [float(DRUM.set({**TRUE, **test}).run().summary["pressure"]["wear_volume_rate_mm3_per_s"]) for test in TESTS]


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    """100 draws of noise of 2 %: the truth lies in the interval of 95 % in 95 of them, give or take 3 standard deviations of the count."""
    random = np.random.default_rng(18)
    exact = rates()
    draws, held = 100, dict.fromkeys(TRUE, 0)
    for _ in range(draws):
        noise = 1 + 0.02 * random.standard_normal(len(exact))
        data = [wearshape.Number(RATE, rate * n, 0.02 * rate, test) for rate, n, test in zip(exact, noise, TESTS, strict=True)]
        found = wearshape.fit(DRUM, data, {"wear.beta.0": 2.5e-4, "wear.a": 1.0, "wear.b": 1.0})
        assert not found.unknown
        for key, value in TRUE.items():
            low, high = found.interval(key)
            held[key] += low <= value <= high
    print(f"intervals of 95 % that hold the truth, of {draws}: {held}")
    spread = 3 * np.sqrt(draws * 0.95 * 0.05)
    assert all(abs(count - 0.95 * draws) <= spread for count in held.values()), held


def test_a_steady_pressure_tells_a_over_b_alone() -> None:
    """p ~ r^(-a/b) on a ring: a and b by the same factor change nothing."""
    ring = wearshape.Scene("annular-punch").set({"tasks": ["pressure"], "wear.a": 1.2, "wear.b": 0.9})
    truth = ring.run()
    radii = np.linspace(30, 110, 25)
    pressure = np.interp(radii, truth.s, truth.pressure)
    data = [wearshape.Profile("pressure_MPa", truth.s, truth.pressure, 0.5)]
    found = wearshape.fit(ring, data, {"wear.a": 1.0, "wear.b": 1.0})
    assert found.estimates["wear.a"] / found.estimates["wear.b"] == pytest.approx(1.2 / 0.9, rel=1e-6)
    assert [each.known for each in found.combinations] == [True, False]
    [lost] = found.unknown
    assert abs(lost.direction["wear.a"]) == pytest.approx(np.sqrt(0.5), rel=1e-3)
    assert lost.direction["wear.a"] == pytest.approx(lost.direction["wear.b"], rel=1e-3)
    assert min(found.deviations.values()) > 1
    # Measured between the points of the solver, it is the same.
    between = wearshape.fit(ring, [wearshape.Profile("pressure_MPa", radii, pressure, 0.5)], {"wear.a": (1.0, 0.1, 3.0)})
    assert between.estimates["wear.a"] == pytest.approx(1.2, rel=2e-2)


def test_a_run_in_time_gives_back_its_wear_factor() -> None:
    punch = wearshape.Scene("punch-wear").set({"accuracy": 1e-3, "wear.until": "60 s"})
    truth = punch.set({"wear.beta.0": 3e-4}).run()
    time_s, volume = truth.history["time_s"], truth.history["volume1_mm3"]
    places = np.linspace(-25, 25, 11)
    data = [
        wearshape.History("volume1_mm3", time_s[5::6], volume[5::6], 0.01 * volume[-1]),
        wearshape.Profile("gap_um", places, np.interp(places, truth.s, truth.gap), 0.1),
    ]
    found = wearshape.fit(punch, data, {"wear.beta.0": (2e-4, 5e-5, 1e-3)})
    low, high = found.interval("wear.beta.0")
    assert low < 3e-4 < high
    assert found.estimates["wear.beta.0"] == pytest.approx(3e-4, rel=1e-2)


def test_a_torque_over_time_gives_friction_by_its_size_and_wear_by_its_pace() -> None:
    """A flat ring wears in from the edge-loaded pressure to p ~ 1/r: its torque falls by 15 % on the way."""
    ring = wearshape.Scene("annular-punch").set({"tasks": ["wear"], "accuracy": 1e-3, "wear.until": "1 s"})
    true = {"contact.friction": 0.3, "wear.beta.0": 1.5e-4}
    truth = ring.set(true).run()
    time_s, torque = truth.history["time_s"], truth.history["torque_Nmm"]
    assert torque[-1] < 0.95 * torque[0]
    random = np.random.default_rng(7)
    at = np.linspace(0.01, 0.95, 40)
    sigma = 0.002 * torque[0]
    measured = np.interp(at, time_s, torque) + sigma * random.standard_normal(at.size)
    start = {"contact.friction": (0.2, 0.05, 0.9), "wear.beta.0": (4e-4, 2e-5, 2e-3)}
    found = wearshape.fit(ring, [wearshape.History("torque_Nmm", at, measured, sigma)], start)
    assert not found.unknown
    for key, value in true.items():
        assert abs(found.estimates[key] - value) < 3 * found.deviations[key], found
        assert found.deviations[key] < 0.1 * value


def test_data_that_are_not_computed_are_refused() -> None:
    with pytest.raises(wearshape.Error, match=r"no shape\.crown_um"):
        wearshape.fit(DRUM, [wearshape.Number("shape.crown_um", 1, 1)], {"wear.a": 1.0})
    with pytest.raises(wearshape.Error, match="starts at 0"):
        wearshape.fit(DRUM, [wearshape.Number(RATE, 1, 1)], {"wear.a": 0.0})
    with pytest.raises(wearshape.Error, match="beyond"):
        wearshape.fit(DRUM, [wearshape.Profile("pressure_MPa", [0, 500], [1, 1], 1)], {"wear.a": 1.0})
    with pytest.raises(TypeError, match=r"^data\[0\] must be a Number, a Profile or a History, not 3$"):
        wearshape.fit(DRUM, [3], {"wear.a": 1.0})  # type: ignore[list-item]


def test_data_that_are_no_list_are_refused() -> None:
    with pytest.raises(TypeError, match=r"^data must be a list of Number, Profile and History, not Number"):
        wearshape.fit(DRUM, wearshape.Number(RATE, 1, 1), {"wear.a": 1.0})  # type: ignore[arg-type]


def test_a_start_with_bounds_is_three_numbers() -> None:
    rate = float(DRUM.run().summary["pressure"]["wear_volume_rate_mm3_per_s"])
    data = [wearshape.Number(RATE, 1.1 * rate, 0.01 * rate)]
    as_tuple = wearshape.fit(DRUM, data, {"wear.beta.0": (2e-4, 1e-4, 4e-4)})
    as_list = wearshape.fit(DRUM, data, {"wear.beta.0": [2e-4, 1e-4, 4e-4]})
    assert as_tuple.estimates == as_list.estimates
    assert as_tuple.estimates["wear.beta.0"] == pytest.approx(2.2e-4, rel=1e-5)
    for level in (2, 0.0, 1.0, float("nan")):
        with pytest.raises(wearshape.Error, match="level = ") as raised:
            as_tuple.interval("wear.beta.0", level)
        assert "0.95" in raised.value.remedy
    with pytest.raises(wearshape.Error, match=r"nothing was estimated of wear\.b"):
        as_tuple.interval("wear.b")
    wrong: list[tuple[Any, str]] = [
        ((1e-4, 4e-4), "2 numbers and no start"),
        ([2e-4], "1 numbers"),
        ((2e-4, 1e-4, 4e-4, 5e-4), "4 numbers"),
        ((5e-4, 1e-4, 4e-4), "outside of its bounds"),
        ((2e-4, 2e-4, 2e-4), "outside of its bounds"),
        ((2e-4, float("nan"), 4e-4), "outside of its bounds"),
        (float("nan"), "outside of its bounds"),
    ]
    for given, words in wrong:
        with pytest.raises(wearshape.Error, match=words) as refused:
            wearshape.fit(DRUM, data, {"wear.beta.0": given})
        assert refused.value.key == "wear.beta.0" and "(start, low, high)" in refused.value.remedy
    with pytest.raises(TypeError, match=r"^parameters\['wear.a'\] must be a number, not 'one'$"):
        wearshape.fit(DRUM, data, {"wear.a": "one"})  # type: ignore[dict-item]


def test_a_number_of_a_list_has_the_name_that_a_sweep_gives_it() -> None:
    hertz = wearshape.Scene("hertz-cylinder").set(accuracy=1e-3)
    end = hertz.set({"load.force": "35 kN"}).run().summary["contact"]["ends_mm"][1]
    found = wearshape.fit(hertz, [wearshape.Number("contact.ends_mm.1", end, 1e-4 * end)], {"load.force": 30000.0})
    assert found.estimates["load.force"] == pytest.approx(35000, rel=1e-3)
    for key in ("contact.ends_mm.2", "contact.ends_mm", "contact.ends_mm.-1"):
        with pytest.raises(wearshape.Error, match=r"contact\.ends_mm"):
            wearshape.fit(hertz, [wearshape.Number(key, 1, 1)], {"load.force": 30000.0})


def test_a_map_is_no_curve() -> None:
    data = [wearshape.Profile("pressure_MPa", [0.0], [1.0], 1.0)]
    with pytest.raises(wearshape.Error, match="two dimensions") as raised:
        wearshape.fit(wearshape.Scene("disc-pad"), data, {"load.force": 1e3})
    assert "Number" in raised.value.remedy


def test_experiments_of_long_arrays_are_told_apart() -> None:
    """numpy shows the ends of a long array alone: two gaps that differ in between are two experiments."""
    s = np.linspace(-30, 30, 1201)
    plain = 1e-3 * s**2
    gaps = [{"contact.gap": {"s_mm": s, "gap_um": gap}} for gap in (plain, plain + 1.5 * np.exp(-((s / 8) ** 2)) * (np.abs(s) < 25))]
    scene = wearshape.Scene("translating-punch").set(tasks=["contact"], accuracy=1e-2)
    key = "contact.approach_mm"
    data = [wearshape.Number(key, scene.set(gap).run().summary["contact"]["approach_mm"], 1e-5, gap) for gap in gaps]
    found = wearshape.fit(scene, data, {"body1.material.young": 2.1e5})
    assert np.abs(found.residuals).max() < 1e-6 and found.estimates["body1.material.young"] == pytest.approx(2.1e5, rel=1e-6)


def test_a_step_to_where_there_is_no_answer_is_made_shorter() -> None:
    """One torque tells no exponents: steps along what is not known went to a negative one."""
    scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
    data = [wearshape.Number("pressure.torque_Nmm", 521000, 500)]
    assert wearshape.fit(scene, data, {"wear.beta.0": 2e-4, "wear.a": 1.0, "wear.b": 1.0}).unknown


def test_no_answer_beside_a_point_is_said() -> None:
    """A step of the differences leads to a Poisson's ratio of .50004."""
    data = [wearshape.Number(RATE, 1.0, 1.0)]
    with pytest.raises(wearshape.Error, match=r"no slopes.*Poisson") as raised:
        wearshape.fit(DRUM, data, {"body1.material.poisson": 0.49999})
    assert raised.value.key == "body1.material.poisson"


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: wearshape.Number("x", 1.0, 0.0), "sigma"),
        (lambda: wearshape.Number("x", float("nan"), 1.0), "value"),
        (lambda: wearshape.Profile("gap_um", [1.0], [1.0, 2.0], 1.0), "values"),
        (lambda: wearshape.Profile("gap_um", [], [], 1.0), "places"),
        (lambda: wearshape.Profile("gap_um", [1.0], [1.0], -1.0), "sigma"),
        (lambda: wearshape.fit(DRUM, [wearshape.Number(RATE, 1.0, 1.0)], {"wear.a": (1.0, 2.0, 3.0)}), "outside"),
        (lambda: wearshape.fit(DRUM, [wearshape.Profile("gap", [0.0], [1.0], 1.0)], {"wear.a": 1.0}), "gap_um"),
        (lambda: wearshape.fit(DRUM, [wearshape.History("p_max_MPa", [0.0], [1.0], 1.0)], {"wear.a": 1.0}), "history"),
    ],
)
def test_wrong_measurements_are_refused(wrong: Callable[[], object], words: str) -> None:
    with pytest.raises(wearshape.Error, match=words):
        wrong()
