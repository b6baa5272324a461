"""Many points of one scene: on the threads of this machine, or on the workers of a Dask cluster."""

from __future__ import annotations

import ctypes
import itertools
import math
import os
import time
from collections.abc import Generator, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray

from wearshape import _arguments as arguments
from wearshape import _core
from wearshape._error import Error
from wearshape._extras import extra
from wearshape._progress import Progress, watched
from wearshape._scene import Scene

if TYPE_CHECKING:
    import xarray

#: Columns of the profile that a sweep keeps.
CURVES = ("s_mm", "x_mm", "y_mm", "z_mm", "pressure_MPa", "pressure_solved_MPa", "shear_MPa", "gap_um", "opening_um", "wear_rate_um_per_s")
#: Parts of the summary that tell how, not what.
_LEFT_OUT = ("schema_version", "version", "scene", "scene_sha256", "counters")
#: Numbers in a list that still are variables of their own.
_SHORT = 4
#: Keys that leave the bodies as they are: points that differ in these alone share what was factorised, and so run one after another.
_SAME_BODIES = ("contact.friction", "load", "optimum", "sliding", "wear")
#: Seconds of a batch, and how many of them a worker has at hand.
_BATCH, _AT_HAND = 1.0, 2
#: Times that a batch is tried on another worker when its own is lost.
_RETRIES = 4


class Point(NamedTuple):
    """What came of a point."""

    #: Numbers and words of the summary, by dotted keys.
    summary: dict[str, Any]
    #: Columns of the profile; empty where there is none.
    curves: dict[str, NDArray[np.float64]]
    #: Seconds that it took.
    seconds: float


class _Batch(NamedTuple):
    first: int
    points: list[dict[str, Any]]


def sweep(
    scene: Scene,
    over: Mapping[str, Any],
    *,
    client: Any = None,
    sample: int = 101,
    progress: Progress = False,
) -> xarray.Dataset:
    """Computes a scene at all points of a grid.

    :param over: a sequence or an array of values for each key, as in ``{"contact.friction": np.linspace(0, 0.4, 9), "wear.b": [0.5, 1, 2]}``.
    :param client: a ``dask.distributed.Client``: the points run on its workers, in batches of about a second; each worker factorises
        bodies once. A worker that is lost takes no point with it. Without one the points run on the threads of this machine.
    :param sample: places along the surface at which the curves are kept, evenly spaced, 2 to 1000000.
    :param progress: as of :meth:`Scene.run`; a function that returns ``False`` ends the sweep, and the points that are missing say
        ``interrupted``. So does Ctrl-C, which raises ``KeyboardInterrupt``; tasks on a cluster are cancelled.

    Returns a dataset with one dimension a key and ``place``. Variables are the numbers and words of the summary under their dotted names
    (``pressure.torque_Nmm``; of lists the numbers of those of up to four, counted from 0: ``contact.ends_mm.1``), ``status`` and ``reason``
    among them, and the curves of the profile (``gap_um`` ...) over ``place``. A point without an answer has a status and a reason, and nan
    elsewhere; an invalid one has the status ``invalid``.

    Raises :class:`Error` for a key that no scene has.
    """
    arguments.instance("scene", scene, Scene, "a wearshape.Scene")
    arguments.instance("over", over, Mapping, "a mapping of keys to values")
    arguments.sample(sample)
    axes = {key: _listed(values) for key, values in over.items()}
    if not axes or not all(axes.values()):
        raise Error("there is nothing to sweep over", "no-points", None, "give a key with one value at least")
    # The keys that change bodies come first, so that neighbours share them.
    order = sorted(axes, key=lambda key: any(key == known or key.startswith(known + ".") for known in _SAME_BODIES))
    points = [dict(zip(order, values, strict=True)) for values in itertools.product(*(axes[key] for key in order))]
    _refuse_unknown(scene, points[0])
    # Before the first point: what was computed would be lost where the dataset cannot be made.
    with extra("sweep", "wearshape.sweep"):
        import xarray  # noqa: F401
    if client is not None:
        with extra("dask", "wearshape.sweep on a cluster"):
            import distributed  # noqa: F401
    found: list[Point | None] = [None] * len(points)
    left = len(points)
    with watched(progress, f"{scene.name}: {len(points)} points") as told:
        results = _by_threads(scene, points, sample) if client is None else _by_dask(scene, points, sample, client)
        for number, point in results:
            found[number] = point
            left -= 1
            done = len(points) - left
            if told is not None and told(done / len(points), f"{done} of {len(points)} points") is False:
                results.close()
                break
    return _dataset(scene, axes, order, found)


def _refuse_unknown(scene: Scene, point: dict[str, Any]) -> None:
    """Raises what stands in every point: a key that no scene has."""
    try:
        scene.set(point)
    except Error as error:
        if error.code == "unknown-key" and error.key in point:
            raise


def _listed(values: Any) -> list[Any]:
    """Values one by one, numpy's as Python's; one that stands alone is one."""
    alone = isinstance(values, (str, Mapping)) or not hasattr(values, "__iter__") or getattr(values, "ndim", 1) == 0
    return [value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value for value in ([values] if alone else values)]


def compute(scene: Scene, changes: Mapping[str, Any], sample: int, bodies: _core.Bodies) -> Point:
    """One point, on one thread."""
    start = time.perf_counter()
    curves: dict[str, NDArray[np.float64]] = {}
    try:
        result = scene.set(changes).run(sample=sample, bodies=bodies, threads=1)
        summary = {key: value for key, value in _flat(result.summary) if not key.startswith(_LEFT_OUT)}
        if not result.ok:
            summary["reason"] = result.verdict
        if result._solution.s is not None:
            names = result.profile.dtype.names or ()
            curves = {name: np.array(result.profile[name]) for name in CURVES if name in names}
    except Error as error:
        summary = {"status": "invalid", "reason": str(error)}
    return Point(summary, curves, time.perf_counter() - start)


def _flat(value: Any, prefix: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _flat(item, f"{prefix}.{key}" if prefix else key)
    elif not isinstance(value, list):
        yield prefix, value
    elif len(value) <= _SHORT and all(isinstance(item, (int, float)) and not isinstance(item, bool) for item in value):
        for place, item in enumerate(value):
            yield f"{prefix}.{place}", item


def _by_threads(scene: Scene, points: list[dict[str, Any]], sample: int) -> Generator[tuple[int, Point], None, None]:
    """The first point alone: what it factorises serves the others."""
    bodies = _core.Bodies()
    yield 0, compute(scene, points[0], sample, bodies)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        waiting = [pool.submit(compute, scene, point, sample, bodies) for point in points[1:]]
        try:
            for number, future in enumerate(waiting, 1):
                yield number, future.result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


@lru_cache(maxsize=1)
def _bodies_of(sweep: str) -> _core.Bodies:
    """What a worker has factorised for a sweep, until another one comes."""
    return _core.Bodies()


def _batch(sweep: str, scene: Scene, points: list[dict[str, Any]], sample: int) -> list[Point]:
    """The points of a batch on a worker."""
    bodies = _bodies_of(sweep)
    with _memory_kept():
        return [compute(scene, point, sample, bodies) for point in points]


#: Parameters of glibc's ``mallopt``, and its own value of the second.
_TRIM_THRESHOLD, _MMAP_THRESHOLD, _MMAP_DEFAULT = -1, -3, 128 * 1024
#: Bytes up to which memory is kept between the points of a batch.
_KEPT = 1 << 30


@contextmanager
def _memory_kept() -> Generator[None, None, None]:
    """Keeps freed memory for the next point, and gives it back afterwards.

    Dask starts its workers with ``MALLOC_TRIM_THRESHOLD_=65536``: what is freed goes back to the system at once, and the pages of each
    matrix are made anew for the next point, which takes a fifth of its time.
    """
    threshold = os.environ.get("MALLOC_TRIM_THRESHOLD_", "")
    library = ctypes.CDLL(None) if os.name == "posix" and threshold.isdigit() else None
    if library is None or not hasattr(library, "mallopt"):
        yield
        return
    library.mallopt(_TRIM_THRESHOLD, _KEPT)
    library.mallopt(_MMAP_THRESHOLD, _KEPT)
    try:
        yield
    finally:
        library.mallopt(_TRIM_THRESHOLD, int(threshold))
        library.mallopt(_MMAP_THRESHOLD, _MMAP_DEFAULT)
        library.malloc_trim(0)


def _by_dask(scene: Scene, points: list[dict[str, Any]], sample: int, client: Any) -> Generator[tuple[int, Point], None, None]:
    """Batches as large as what was measured so far says; each worker has the next one at hand while it computes.

    The scene goes along with every batch: what was sent once would be lost with the workers that hold it.
    """
    import distributed

    sweep = uuid4().hex
    threads = max(1, sum(client.nthreads().values()))
    batches: dict[Any, _Batch] = {}
    running: Any = distributed.as_completed()  # type: ignore[no-untyped-call]
    spent, counted, begun = 0.0, 0, 0

    def submit() -> None:
        nonlocal begun
        size = 1 if not counted else round(_BATCH / max(spent / counted, 1e-6))
        # The last ones are small, so that no worker waits long for another.
        fair = math.ceil((len(points) - begun) / (threads * _AT_HAND))
        part = points[begun : begun + max(1, min(size, fair))]
        future = client.submit(_batch, sweep, scene, part, sample, retries=_RETRIES, pure=False)
        batches[future] = _Batch(begun, part)
        begun += len(part)
        running.add(future)

    try:
        for _ in range(min(threads, len(points))):
            submit()
        for future in running:
            batch = batches.pop(future)
            computed: list[Point] = future.result()
            future.release()
            spent += sum(point.seconds for point in computed)
            counted += len(computed)
            while begun < len(points) and len(batches) < threads * _AT_HAND:
                submit()
            yield from enumerate(computed, batch.first)
    finally:
        client.cancel(list(batches), force=True)


def _dataset(scene: Scene, axes: dict[str, list[Any]], order: list[str], found: list[Point | None]) -> xarray.Dataset:
    import xarray

    missing = Point({"status": "interrupted", "reason": "the sweep was ended before"}, {}, math.nan)
    points = [point or missing for point in found]
    shape = tuple(len(axes[key]) for key in order)
    variables: dict[str, tuple[list[str], NDArray[Any]]] = {}
    for name in dict.fromkeys(["status", "reason", *(key for point in points for key in point.summary)]):
        values = [point.summary.get(name) for point in points]
        text = any(isinstance(value, str) for value in values) or name == "reason"
        column: NDArray[Any]
        if text:
            column = np.array(["" if value is None else str(value) for value in values], dtype=object)
        else:
            column = np.array([math.nan if value is None else float(value) for value in values])
        variables[name] = (order, column.reshape(shape))
    for name in dict.fromkeys(name for point in points for name in point.curves):
        length = max(len(point.curves[name]) for point in points if name in point.curves)
        curves = np.full((len(points), length), math.nan)
        for row, point in zip(curves, points, strict=True):
            curve = point.curves.get(name, np.empty(0))
            row[: len(curve)] = curve
        variables[name] = ([*order, "place"], curves.reshape(*shape, length))
    variables["seconds"] = (order, np.array([point.seconds for point in points]).reshape(shape))
    coordinates = {key: _coordinate(values) for key, values in axes.items()}
    dataset = xarray.Dataset(variables, coordinates, {"scene": scene.name, "title": scene.title})
    return dataset.transpose(*axes, ...)


def _coordinate(values: list[Any]) -> NDArray[Any]:
    """Numbers and texts as they are, beside each other too; what has no order of its own (lists, tables) as text."""
    plain = [value if isinstance(value, (int, float, str)) else str(value) for value in values]
    texts = sum(isinstance(value, str) for value in plain)
    # An array of numpy's own type would make a text of every number beside one.
    return np.array(plain, dtype=None if texts in (0, len(plain)) else object)
