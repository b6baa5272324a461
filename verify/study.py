"""Error against run time of dolfinx: one case on a ladder of meshes and degrees.

usage: study.py FOLDER CASE. Reads the scene and the places to compare at from FOLDER/ours, the
ladder of CASE from study.toml beside this file; writes FOLDER/out.json with the seconds and the
values of every level. Seconds run from the scene, read, to the answer, meshing included. Left out:
the preparation of forms (all are compiled before), the start of the program, and the evaluation
at the places to compare at.
"""

import json
import os
import sys
import time
import tomllib
from pathlib import Path

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import body as bodies
import common
import gap
import hertz
import numpy as np
import scene as scenes
import wear
from interface import Interface


class Clock:
    """Seconds since it was made, without those spent on forms."""

    def __init__(self):
        self.wall, self.cpu, self.forms = time.perf_counter(), time.process_time(), bodies.FORMS[0]

    def read(self):
        forms = bodies.FORMS[0] - self.forms
        return {"seconds": time.perf_counter() - self.wall - forms,
                "seconds_cpu": time.process_time() - self.cpu - forms, "seconds_forms": forms}


def gap_level(scene, surface, c, level):
    """Gap of the wanted pressure, um."""
    span = (surface.range[1] - surface.range[0]) * (surface.radius or 1.0)
    grading = (level["size"] * span, level["smallest"] * span, level["slope"])
    near = level["near"] * span if "near" in level else None
    clock = Clock()
    pressure = scenes.Pressure(scene, surface)
    found = []
    for number in (1, 2):
        body, tags = gap.build(scene, surface, number, grading, level["degree"], near)
        found.append((body, body.solve(gap.loads(scene, surface, pressure, 1.0, number, body, tags)), tags))
    seconds = clock.read()
    u1, u2 = (body.points(u, surface.point(c), tags) for body, u, tags in found)
    unknowns = sum(u.vector.getSize() for _, u, _ in found)
    return [{**seconds, "unknowns": unknowns, "values": (np.sum((u2 - u1) * surface.normal(c), axis=1) * 1e3).tolist()}]


def hertz_level(scene, surface, c, level):
    """Pressure of a round contact, MPa."""
    clock = Clock()
    pair, p, _, _ = hertz.press(scene, surface, 1.0, level["cells"], level["size"])
    seconds = clock.read()
    return [{**seconds, "unknowns": 2 * len(pair.c), "values": pair.at(p, c).tolist()}]


def wear_level(scene, surface, c, level):
    """Worn gap, um, each time the distance from the steady state has fallen by a factor."""
    clock = Clock()
    pair = Interface(scene, surface, np.linspace(*surface.range, level["cells"] + 1), level["size"], grade=False)
    rows = []
    for state in wear.steps(scene, surface, pair, level["share"]):
        if state.residual <= level["first"] * level["factor"] ** -len(rows):
            rows.append({**clock.read(), "unknowns": 2 * len(pair.c), "steps": state.step, "residual": state.residual,
                         "values": (pair.at(state.gap, c) * 1e3).tolist()})
        if state.residual <= level["last"]:
            return rows
    return rows


LEVELS = {"gap": gap_level, "hertz": hertz_level, "wear": wear_level}


def main():
    folder, name = Path(sys.argv[1]), sys.argv[2]
    with open(Path(__file__).with_name("study.toml"), "rb") as file:
        case = next(case for case in tomllib.load(file)["case"] if case["name"] == name)
    scene = scenes.read(folder / "ours" / "scene.resolved.toml")
    points = common.contact_points(folder)
    levels = case["theirs"]["levels"]
    # Once without the clock for every degree: compiles what dolfinx compiles, loads what it loads.
    first = {level.get("degree"): level for level in reversed(levels)}
    rows = []
    for number, level in enumerate([*first.values(), *levels]):
        surface = scenes.Surface(scene)
        if case["theirs"]["kind"] == "hertz":
            hertz.narrow(scene, surface)
        c = surface.coordinate(points["x_mm"], points["z_mm"])
        for row in LEVELS[case["theirs"]["kind"]](scene, surface, c, level):
            if number >= len(first):
                rows.append({**level, **row})
    partial = folder / "out.json.partial"
    partial.write_text(json.dumps({"rows": rows, "versions": common.versions()}))
    os.replace(partial, folder / "out.json")


if __name__ == "__main__":
    main()
