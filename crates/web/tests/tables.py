"""How far two tables of the program are apart."""

import csv
import math


def columns(table: str) -> dict[str, list[float]]:
    rows = list(csv.DictReader(table.splitlines()))
    found = {name: [float(row[name] or "nan") for row in rows] for name in rows[0] if name != "status"}
    # A contact solve finds forces; in the finest layers their points have next to no area, by which the last digit of a force becomes the eighth of a
    # pressure.
    if "pressure_solved_MPa" in found:
        found["force_solved_N"] = [p * w for p, w in zip(found.pop("pressure_solved_MPa"), found["weight_mm2"], strict=True)]
    return found


def farthest(ours: str, theirs: str) -> tuple[float, str]:
    """The largest difference of two tables, relative to the largest number of each column, and its column."""
    a, b = columns(ours), columns(theirs)
    assert list(a) == list(b), "other columns"
    worst = (0.0, "")
    for name in a:
        size = max((abs(x) for x in b[name] if math.isfinite(x)), default=0.0) or 1.0
        assert len(a[name]) == len(b[name]), name
        for x, y in zip(a[name], b[name], strict=True):
            if math.isfinite(x) or math.isfinite(y):
                worst = max(worst, (abs(x - y) / size, name))
    return worst
