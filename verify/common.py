"""What all scripts share: the command line, two levels, and out.json."""

import argparse
import csv
import json
import logging
import os
import sys
import time
import traceback
from pathlib import Path

REMEDY = "cargo xtask verify --install"
MISSING = 3

try:
    import numpy as np
    import dolfinx
    import gmsh
    from petsc4py import PETSc
except ImportError as error:
    print(f"verify: {error}. Remedy: {REMEDY}", file=sys.stderr)
    sys.exit(MISSING)

import scene as scenes

FAULTS = ("friction-sign", "young", "conductivity")


def arguments(doc):
    """Command line of every script: <case folder> [--fault F] [--option key=value]."""
    parser = argparse.ArgumentParser(description=doc)
    parser.add_argument("case", type=Path, help="folder that holds ours/ and receives out.json")
    parser.add_argument("--fault", choices=FAULTS, help="solve a wrong problem on purpose")
    return parser.parse_args()


def disturb(scene, fault):
    """The scene, or a wrong one: friction reversed on the bodies (not in the wanted pressure), or
    body 2 stiffer by 2 %, or body 1 conducting 2 % better. A comparison that passes with it proves nothing."""
    if fault == "young":
        values = scene["body2"]["material"]
        values["young"] = 1.02 * scenes.quantity(values["young"])
    if fault == "conductivity":
        values = scene["body1"]["material"]
        values["conductivity"] = 1.02 * scenes.quantity(values["conductivity"])
    return -1.0 if fault == "friction-sign" else 1.0


def contact_points(case):
    """The columns of ours/contact.csv as arrays of numbers; empty or `nan` cells are nan."""
    with open(case / "ours" / "contact.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    number = lambda text: float(text) if text and text.replace("status", "") else float("nan")
    columns = {}
    for name in rows[0]:
        if name != "status":
            columns[name] = np.array([number(row[name]) for row in rows])
    return columns


def spread(values, modes):
    """Largest difference of values after taking out the best combination of modes."""
    rest = np.asarray(values, dtype=float)
    if modes:
        basis = np.column_stack(modes)
        rest = rest - basis @ np.linalg.lstsq(basis, rest, rcond=None)[0]
    return float(np.max(np.abs(rest)))


class Quantity:
    """One compared quantity: values at the sample points (or one number), the rigid motions that
    do not count, and the difference between the two levels."""

    def __init__(self, name, unit, coarse, fine, modes=(), keep=None):
        coarse, fine = np.atleast_1d(coarse), np.atleast_1d(fine)
        modes = [np.asarray(m, dtype=float) for m in modes]
        keep = np.ones(len(fine), dtype=bool) if keep is None else np.asarray(keep, dtype=bool)
        pick = [m[keep] for m in modes]
        self.record = {
            "name": name, "unit": unit, "values": fine.tolist(), "modes": [m.tolist() for m in modes],
            "keep": keep.tolist(), "self_error": spread((fine - coarse)[keep], pick),
        }


def versions():
    """What solved it."""
    return {"dolfinx": dolfinx.__version__, "gmsh": gmsh.GMSH_API_VERSION,
            "petsc": ".".join(map(str, PETSc.Sys.getVersion())), "python": sys.version.split()[0]}


def finish(case, started, quantities, extra=None):
    """Writes out.json in one step: a reader sees the whole file or none."""
    record = {
        "quantities": [q.record for q in quantities],
        "versions": versions(),
        "seconds": time.perf_counter() - started,
        **(extra or {}),
    }
    partial = case / "out.json.partial"
    partial.write_text(json.dumps(record, indent=1))
    os.replace(partial, case / "out.json")


def main(doc, solve):
    """Runs `solve(scene, points, sign, case)` -> (quantities, extra) for a case folder."""
    logging.getLogger().setLevel(logging.WARNING)
    args = arguments(doc)
    started = time.perf_counter()
    try:
        scene = scenes.read(args.case / "ours" / "scene.resolved.toml")
        sign = disturb(scene, args.fault)
        quantities, extra = solve(scene, contact_points(args.case), sign)
        finish(args.case, started, quantities, extra)
    except Exception as error:
        traceback.print_exc()
        print(f"verify: {error}", file=sys.stderr)
        sys.exit(1)
