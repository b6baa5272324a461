"""Every built-in scene less each of its keys, and with each of its numbers a thousand million times larger and smaller, in 2 GB of memory and 20 s
of processor time: each must end with exit 0, 1 or 2.

usage: extremes.py <wearshape> <folder of the scenes> [scene ...]
"""

import copy
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import tomllib

MEMORY = 2 << 30
SECONDS = 20
WITH_UNIT = re.compile(r"\s*([-+0-9.eE]+)\s*(.*)")


def written(value):
    """A value as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(k)} = {written(v)}" for k, v in value.items()) + " }"
    return json.dumps(value) if isinstance(value, str) else repr(value)


def places(node, at=()):
    """Keys and places of lists, from the outside to the inside, with what stands there."""
    items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else []
    for key, value in items:
        yield (*at, key), value
        yield from places(value, (*at, key))


def scaled(value, factor):
    """A number, or a text that begins with one, times a factor; None for all else."""
    if isinstance(value, bool):
        return None
    if isinstance(value, (int, float)):
        return value * factor
    found = WITH_UNIT.fullmatch(value) if isinstance(value, str) else None
    try:
        return f"{float(found[1]) * factor!r} {found[2]}".strip() if found else None
    except ValueError:
        return None


def variants(scene):
    """The scenes to run, each with what is different in it."""
    yield "as it is", scene
    for place, value in places(scene):
        parents, last = place[:-1], place[-1]
        name = ".".join(map(str, place))
        changes = [(f"less {name}", None)] if isinstance(last, str) else []
        for factor in (1e9, 1e-9):
            new = scaled(value, factor)
            changes += [] if new is None else [(f"{name} = {new}", new)]
        for what, new in changes:
            other = copy.deepcopy(scene)
            table = other
            for key in parents:
                table = table[key]
            if new is None:
                del table[last]
            else:
                table[last] = new
            yield what, other


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))


def run(program, folder, path):
    """Exit code (negative for a signal, None after six times as long on the clock) and what was said last."""
    out = folder / "out"
    for old in folder.glob("out*"):
        shutil.rmtree(old)
    command = [program, "run", path, "-o", out, "--no-progress", "--threads", "1"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=6 * SECONDS, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, " ".join(done.stderr.split())[-160:]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, scenes = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    names = sys.argv[3:] or sorted(path.stem for path in scenes.glob("*.toml"))
    runs, failed = 0, 0
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for beside in scenes.iterdir():
            if beside.is_file() and beside.suffix != ".toml":
                shutil.copy(beside, folder)
        for name in names:
            before = runs
            for what, scene in variants(tomllib.loads((scenes / f"{name}.toml").read_text())):
                path = folder / f"{name}.toml"
                path.write_text("\n".join(f"{json.dumps(k)} = {written(v)}" for k, v in scene.items()) + "\n")
                code, said = run(program, folder, path)
                runs += 1
                if code not in (0, 1, 2):
                    failed += 1
                    print(f"FAILED {name}: {what}: exit {code} {said}", flush=True)
            print(f"{name}: {runs - before} runs", flush=True)
    print(f"{runs} runs, {failed} failed")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
