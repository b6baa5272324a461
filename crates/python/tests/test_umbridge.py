"""A scene as a model of UM-Bridge, served over HTTP and asked by its own client."""

import pickle
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import wearshape

protocol = pytest.importorskip("umbridge")

INPUTS = ["load.force", "contact.friction", "wear.beta.0", "wear.b", "sliding.omega", "thickness"]
OUTPUTS = ["pressure.wear_depth_um_per_h", "pressure.torque_Nmm", "pressure.p_max_MPa"]
AT = [1e4, 0.25, 2e-4, 0.5, 2.5, 10.0]
SCENE = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
MODEL = wearshape.umbridge(SCENE, INPUTS, OUTPUTS)


#: The server handles signals and so needs the main thread of a process.
SERVER = f"""
import sys, umbridge, wearshape
scene = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])
umbridge.serve_models([wearshape.umbridge(scene, {INPUTS}, {OUTPUTS}, name="drum")], int(sys.argv[1]))
"""


@pytest.fixture(scope="module")
def served() -> Iterator[str]:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen([sys.executable, "-c", SERVER, str(port)], stdout=subprocess.DEVNULL)
    try:
        for _ in range(600):
            with socket.socket() as asked:
                if asked.connect_ex(("127.0.0.1", port)) == 0:
                    break
            assert server.poll() is None, "the server ended"
            time.sleep(0.05)
        yield f"http://127.0.0.1:{port}"
    finally:
        server.kill()
        server.wait()


def test_a_client_gets_what_a_run_gives(served: str) -> None:
    client = protocol.HTTPModel(served, "drum")
    assert client.get_input_sizes() == [6]
    assert client.get_output_sizes() == [3]
    assert client.supports_evaluate()
    [found] = client([AT])
    pressure = SCENE.run().summary["pressure"]
    assert found == [pressure[key.split(".")[1]] for key in OUTPUTS]


def test_gradients_are_those_of_differences(served: str) -> None:
    client = protocol.HTTPModel(served, "drum")
    assert client.supports_gradient()
    for output in range(3):
        sens = [float(output == number) for number in range(3)]
        gradient = client.gradient(0, 0, [AT], sens)
        for number, value in enumerate(AT):
            step = 1e-5 * value
            up, down = ([*AT[:number], value + by, *AT[number + 1 :]] for by in (step, -step))
            scale = client([AT])[0][output] / value
            difference = (client([up])[0][output] - client([down])[0][output]) / (2 * step)
            assert gradient[number] == pytest.approx(difference, abs=1e-7 * scale)


#: A point out of the range of a key, as a sampler may draw one, and one without friction, where nothing wears by `wear.beta`.
BEYOND, SMOOTH = [AT[0], -0.1, *AT[2:]], [AT[0], 0.0, *AT[2:]]
NO_ANSWERS: list[tuple[Any, str, str, str]] = [
    (lambda model: model([BEYOND]), "wrong-value", "InvalidInput", "negative friction"),
    (lambda model: model([[*AT[:5], 0.0]]), "wrong-value", "InvalidInput", "thickness"),
    (lambda model: model([[*AT[:5], None]]), "wrong-argument", "InvalidInput", "thickness must be a number, not None"),
    (lambda model: model([SMOOTH]), "no-output", "InvalidOutput", "no pressure.wear_depth_um_per_h"),
    (lambda model: model.gradient(0, 0, [BEYOND], [1.0, 0.0, 0.0]), "wrong-value", "InvalidInput", "negative friction"),
    # Derivatives come as percent by percent: there is none by a number that is 0.
    (lambda model: model.gradient(0, 0, [SMOOTH], [0.0, 0.0, 1.0]), "no-gradient", "InvalidOutput", "no derivative of pressure.p_max_MPa by contact.friction"),
]


@pytest.mark.parametrize(("call", "code", "kind", "words"), NO_ANSWERS)
def test_what_is_not_there_is_an_error_with_its_reason(served: str, call: Any, code: str, kind: str, words: str) -> None:
    with pytest.raises(wearshape.Error, match=words) as raised:
        call(MODEL)
    assert raised.value.code == code
    again = pickle.loads(pickle.dumps(raised.value))
    assert (type(again), str(again), again.code) == (type(raised.value), str(raised.value), code)
    # A client is told the same, and the server goes on.
    client = protocol.HTTPModel(served, "drum")
    with pytest.raises(Exception, match=words) as answered:
        call(client)
    assert str(answered.value) == f"Model returned error of type {kind}: {raised.value}"
    assert np.isfinite(client([AT])).all()


def test_a_point_without_an_answer_says_why() -> None:
    punch = wearshape.Scene("translating-punch").set(tasks=["pressure"])
    model = wearshape.umbridge(punch, ["load.moment"], ["pressure.p_max_MPa"])
    with pytest.raises(wearshape.Error, match="at or beyond the edge") as raised:
        model([[1e6]])
    assert raised.value.code == "no-answer"


def test_what_is_misspelt_is_refused_by_name_before_any_point() -> None:
    wrong: list[tuple[Any, Any, str]] = [
        (["contact.frictoin"], OUTPUTS, "frictoin"),
        (["load"], OUTPUTS, "load: wrong type"),
        (INPUTS, ["pressure.torqe_Nmm"], "no pressure.torqe_Nmm"),
        (INPUTS, ["status"], "status of the summary is no number"),
        (INPUTS, [], "there are no outputs"),
        ([], OUTPUTS, "there are no inputs"),
    ]
    for inputs, outputs, words in wrong:
        with pytest.raises(wearshape.Error, match=words) as raised:
            wearshape.umbridge(SCENE, inputs, outputs)
        assert raised.value.remedy
    with pytest.raises(wearshape.Error, match=r"did you mean pressure\.torque_Nmm"):
        wearshape.umbridge(SCENE, INPUTS, ["pressure.torqe_Nmm"])
    for outputs, words in (("pressure.p_max_MPa", "^outputs must be a list of dotted keys"), ([3], r"^outputs\[0\] must be a dotted key, not 3")):
        with pytest.raises(TypeError, match=words):
            wearshape.umbridge(SCENE, INPUTS, outputs)  # type: ignore[arg-type]


def test_an_output_may_be_a_number_of_a_list() -> None:
    hertz = wearshape.Scene("hertz-cylinder").set(accuracy=1e-3)
    [[end]] = wearshape.umbridge(hertz, ["load.force"], ["contact.ends_mm.1"])([[35000.0]])
    assert end == hertz.set({"load.force": 35000.0}).run().summary["contact"]["ends_mm"][1]


def test_there_is_no_gradient_where_it_is_not_exact() -> None:
    model = wearshape.umbridge(SCENE.set(tasks=["pressure", "shape"], accuracy=1e-2), ["load.force"], ["shape.crown_um"])
    assert not model.supports_gradient()
    assert np.isfinite(model([[1e4]])[0][0])
    with pytest.raises(wearshape.Error, match="not exact"):
        model.gradient(0, 0, [[1e4]], [1.0])
