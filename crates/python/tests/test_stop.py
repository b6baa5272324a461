"""Progress, stopping and going on."""

import signal
import subprocess
import sys
import time

import pytest
import wearshape

WEAR = wearshape.Scene("punch-wear").set(accuracy=1e-3)


def test_the_share_never_falls_and_has_words() -> None:
    told: list[tuple[float, str]] = []
    wearshape.Scene("drum-brake-block").run(progress=lambda share, words: told.append((share, words)))
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1 and max(shares[:-1]) < 1
    assert any("shape, degree 4" in words for _, words in told)


def test_a_bar_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    wearshape.Scene("drum-brake-block").run(progress=True)
    shown = capsys.readouterr().err
    assert "drum-brake-block: 100%" in shown


def test_a_run_that_was_stopped_goes_on_to_the_same_bits() -> None:
    calls = 0

    def until_some_steps(share: float, words: str) -> bool:
        nonlocal calls
        calls += "step" in words
        return calls < 8

    stopped = WEAR.run(progress=until_some_steps)
    assert stopped.status == "interrupted"
    assert stopped.resumable
    end, whole = WEAR.run(resume=stopped), WEAR.run()
    assert end.status == whole.status == "ok"
    assert (end.gap == whole.gap).all()
    assert end.summary == whole.summary


def test_a_run_of_another_scene_is_not_gone_on_with() -> None:
    stopped = WEAR.run(progress=lambda share, words: "step" not in words)
    assert stopped.status == "interrupted"
    with pytest.raises(wearshape.Error, match="one of another scene"):
        WEAR.set({"load.force": 333.0}).run(resume=stopped)


def test_a_run_that_is_done_is_not_gone_on_with() -> None:
    with pytest.raises(wearshape.Error, match="its status is `ok`") as raised:
        WEAR.run(resume=WEAR.run())
    assert raised.value.code == "not-resumable" and "begin anew" in raised.value.remedy


def test_a_run_that_was_stopped_does_not_tell_that_it_is_done() -> None:
    shares: list[float] = []

    def stop(share: float, words: str) -> bool:
        shares.append(share)
        return "step" not in words

    assert WEAR.run(progress=stop).status == "interrupted"
    assert max(shares) < 1


def test_an_error_in_the_callable_ends_the_run_and_goes_up() -> None:
    def fails(share: float, words: str) -> None:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        WEAR.run(progress=fails)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGINT for one child")
def test_ctrl_c_stops_at_once() -> None:
    code = (
        "import wearshape, sys\n"
        "scene = wearshape.Scene('punch-wear').set(accuracy=1e-11)\n"
        "print('begins', flush=True)\n"
        "scene.run()\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "begins\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    start = time.perf_counter()
    _, said = process.communicate(timeout=60)
    assert said.rstrip().endswith("KeyboardInterrupt")
    assert time.perf_counter() - start < 5
