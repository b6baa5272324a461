"""A scene as a model of UM-Bridge, served over HTTP and asked by its own client."""

import socket
import subprocess
import sys
import time
from collections.abc import Iterator

import numpy as np
import pytest
import wearshape

protocol = pytest.importorskip("umbridge")

INPUTS = ["load.force", "contact.friction", "wear.beta.0", "wear.b", "sliding.omega", "thickness"]
OUTPUTS = ["pressure.wear_depth_um_per_h", "pressure.torque_Nmm", "pressure.p_max_MPa"]
AT = [1e4, 0.25, 2e-4, 0.5, 2.5, 10.0]
SCENE = wearshape.Scene("drum-brake-block").set(tasks=["pressure"])


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


def test_what_is_not_there_is_nan() -> None:
    model = wearshape.umbridge(SCENE, INPUTS, OUTPUTS)
    # A sampler may leave the range of a key.
    [found] = model([[AT[0], -0.1, *AT[2:]]])
    assert np.isnan(found).all()
    assert np.isnan(model.gradient(0, 0, [[AT[0], -0.1, *AT[2:]]], [1.0, 0.0, 0.0])).all()
    # Without friction nothing wears by `wear.beta`; and derivatives come as percent by percent: there is none by a number that is 0.
    smooth = [[AT[0], 0.0, *AT[2:]]]
    assert np.isnan(model(smooth)[0]).tolist() == [True, False, False]
    assert np.isnan(model.gradient(0, 0, smooth, [0.0, 0.0, 1.0])[1])
    with pytest.raises(wearshape.Error, match="frictoin"):
        wearshape.umbridge(SCENE, ["contact.frictoin"], OUTPUTS)([[0.1]])


def test_there_is_no_gradient_where_it_is_not_exact() -> None:
    model = wearshape.umbridge(SCENE.set(tasks=["pressure", "shape"], accuracy=1e-2), ["load.force"], ["shape.crown_um"])
    assert not model.supports_gradient()
    assert np.isfinite(model([[1e4]])[0][0])
    with pytest.raises(wearshape.Error, match="not exact"):
        model.gradient(0, 0, [[1e4]], [1.0])
