"""The recording and the drawing of a run, opened by the official reader of MCAP and by ezdxf.

usage: outputs_files.py <folder of a run>
"""

import csv
import json
import pathlib
import sys

import ezdxf
import jsonschema
from mcap.reader import make_reader


def recording(path):
    """Every message is valid against the schema of its channel."""
    counts, validators = {}, {}
    with open(path, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        for schema, channel, message in reader.iter_messages():
            if schema.id not in validators:
                jsonschema.Draft7Validator.check_schema(json.loads(schema.data))
                validators[schema.id] = jsonschema.Draft7Validator(json.loads(schema.data))
            validators[schema.id].validate(json.loads(message.data))
            counts[channel.topic] = counts.get(channel.topic, 0) + 1
        names = [attachment.name for attachment in reader.iter_attachments()]
    if not {"scene.resolved.toml", "summary.json"} <= set(names) or "/contact/profile" not in counts:
        sys.exit(f"{path}: messages {counts}, attachments {names}")
    print(f"  run.mcap: {sum(counts.values())} messages on {len(counts)} channels, each valid")


def drawing(folder):
    """No fault is found, and the spline runs through the points of the table."""
    document = ezdxf.readfile(folder / "profile.dxf")
    audit = document.audit()
    if audit.errors or audit.fixes:
        sys.exit(f"profile.dxf: {[str(fault.message) for fault in audit.errors + audit.fixes]}")
    (spline,) = document.modelspace().query("SPLINE")
    curve = spline.construction_tool()
    with open(folder / "profile.csv", newline="") as text:
        rows = list(csv.DictReader(text))
    start, worst = float(rows[0]["s_mm"]), 0.0
    for row in rows[1:-1]:
        point = curve.point(float(row["s_mm"]) - start)
        worst = max(worst, abs(point.x - float(row["x_mm"])), abs(point.y - float(row["z_mm"])))
    if not worst < 1e-9:
        sys.exit(f"profile.dxf is {worst:.1e} mm off profile.csv")
    print(f"  profile.dxf: no fault; within {worst:.1e} mm of {len(rows)} points")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    recording(folder / "run.mcap")
    if (folder / "profile.dxf").exists():
        drawing(folder)
