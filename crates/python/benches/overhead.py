"""What a Dask cluster costs beside bare runs, at some 20 ms a point: on one worker process, against a loop in one process.

    python crates/python/benches/overhead.py [points] [repeats]
"""

import sys
import time
from typing import Any

import distributed
import numpy as np
import wearshape
from wearshape._sweep import compute


def scene_of_20_ms() -> wearshape.Scene:
    """The drum with its accuracy such that a point with factorised bodies takes about that long."""
    drum = wearshape.Scene("drum-brake-block")
    bodies = wearshape.Bodies()
    for accuracy in (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8):
        scene = drum.set(accuracy=accuracy)
        compute(scene, {}, 101, bodies)
        seconds = min(compute(scene, {"contact.friction": mu}, 101, bodies).seconds for mu in (0.1, 0.2, 0.3))
        if seconds > 0.015:
            break
    return scene


def loop(scene: wearshape.Scene, friction: Any) -> float:
    start, bodies = time.perf_counter(), wearshape.Bodies()
    for mu in friction:
        compute(scene, {"contact.friction": mu}, 101, bodies)
    return time.perf_counter() - start


def cluster(scene: wearshape.Scene, friction: Any, client: Any) -> float:
    start = time.perf_counter()
    found = wearshape.sweep(scene, {"contact.friction": friction}, client=client)
    assert (found.status == "ok").all()
    return time.perf_counter() - start


def main() -> None:
    points, repeats = (int(word) for word in (sys.argv[1:] + ["300", "3"][len(sys.argv) - 1 :]))
    friction = np.linspace(0.05, 0.4, points)
    scene = scene_of_20_ms()
    dask: Any = distributed
    one = {"n_workers": 1, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with dask.LocalCluster(**one) as workers, dask.Client(workers) as client:
        cluster(scene, friction[:4], client)
        # One after the other, so that what else the machine does meets both.
        pairs = [(loop(scene, friction), cluster(scene, friction, client)) for _ in range(repeats)]
    for bare, other in pairs:
        print(f"{1e3 * bare / points:.1f} ms a point bare, {1e3 * other / points:.1f} ms with Dask: {100 * (other / bare - 1):+.1f} %")
    bare, other = (min(column) for column in zip(*pairs, strict=True))
    print(f"fastest of each: {100 * (other / bare - 1):+.1f} %")


if __name__ == "__main__":
    main()
