"""Every built-in scene less each of its keys, and with each of its numbers a thousand million times larger and smaller, in 2 GB of memory and 20 s
of processor time: each must end with exit 0, 1 or 2.

With --random N, N scenes with one to three random faults each; there `check` must say of a scene what `run` says of it: what `check` lets pass, `run`
does not refuse with exit 2, and the other way round.

usage: extremes.py <wearshape> <folder of the scenes> [scene ...] [--random N] [--seed S]
"""

import collections
import copy
import json
import math
import pathlib
import random
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
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


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


WORDS = ["", "10 furlong", "1e400", "-0", "nan", "steady", "top", "\u00fc\u200b", True, False, [], {}, [1, 2, 3], [[0, 0]], 0, -1, 1e-300, 1e300, math.inf, math.nan]


def random_variant(chance, scene, others):
    """A scene with one to three random faults, and what they are."""
    other, said = copy.deepcopy(scene), []
    for _ in range(chance.choice([1, 1, 1, 2, 3])):
        found = list(places(other))
        if not found:
            break
        place, value = chance.choice(found)
        table = other
        for key in place[:-1]:
            table = table[key]
        kind = chance.choice(["less", "scale", "scale", "scale", "negate", "word", "swap", "graft", "twice"])
        if kind == "less":
            del table[place[-1]]
        elif kind in ("scale", "negate"):
            new = scaled(value, -1.0 if kind == "negate" else 10 ** chance.uniform(-6, 6))
            if new is None:
                continue
            table[place[-1]] = new
        elif kind == "word":
            table[place[-1]] = chance.choice(WORDS)
        elif kind == "swap":
            from_place, from_value = chance.choice(found)
            table[place[-1]] = copy.deepcopy(from_value)
            kind = f"swap {'.'.join(map(str, from_place))} into"
        elif kind == "graft":
            donor = chance.choice(others)
            key = chance.choice(list(donor))
            other[key] = copy.deepcopy(donor[key])
            said.append(f"graft {key} of {donor.get('title')}")
            continue
        elif isinstance(value, list) and value:
            value.append(copy.deepcopy(chance.choice(value)))
        said.append(f"{kind} {'.'.join(map(str, place))}")
    return ", ".join(said), other


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))


def run(program, folder, path, word="run"):
    """Exit code (negative for a signal, None after six times as long on the clock) and what was said last."""
    out = folder / "out"
    for old in folder.glob("out*"):
        shutil.rmtree(old)
    command = [program, word, path, *(["-o", out, "--no-progress", "--threads", "1"] if word == "run" else [])]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=6 * SECONDS, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, " ".join(done.stderr.split())[-160:]


def write(path, scene):
    path.write_text("\n".join(f"{json.dumps(k)} = {written(v)}" for k, v in scene.items()) + "\n")


def at_random(program, folder, scenes, names, count, seed):
    """Runs scenes with random faults; how many failed."""
    chance, failed, ends = random.Random(seed), 0, collections.Counter()
    known = {name: tomllib.loads((scenes / f"{name}.toml").read_text()) for name in names}
    for number in range(count):
        name = chance.choice(names)
        what, scene = random_variant(chance, known[name], list(known.values()))
        path = folder / f"{name}.toml"
        write(path, scene)
        checked, _ = run(program, folder, path, "check")
        code, said = run(program, folder, path)
        ends[code] += 1
        if code not in (0, 1, 2) or (checked == 2) != (code == 2):
            failed += 1
            print(f"FAILED {number} {name}: {what}: exit {code}, of check {checked}: {said}", flush=True)
            shutil.copy(path, pathlib.Path(f"extreme-{seed}-{number}.toml"))
        if number % 100 == 99:
            print(f"{number + 1} scenes, exits {dict(ends)}", flush=True)
    print(f"{count} random scenes of seed {seed}, exits {dict(ends)}, {failed} failed")
    return failed


def option(arguments, name, default):
    """The number behind an option, which is taken out of the arguments."""
    if name not in arguments:
        return default
    place = arguments.index(name)
    value = int(arguments[place + 1])
    del arguments[place : place + 2]
    return value


def main():
    arguments = sys.argv[1:]
    count, seed = option(arguments, "--random", 0), option(arguments, "--seed", 1)
    if len(arguments) < 2:
        sys.exit(__doc__)
    program, scenes = pathlib.Path(arguments[0]).resolve(), pathlib.Path(arguments[1])
    names = arguments[2:] or sorted(path.stem for path in scenes.glob("*.toml"))
    runs, failed = 0, 0
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for beside in scenes.iterdir():
            if beside.is_file() and beside.suffix != ".toml":
                shutil.copy(beside, folder)
        if count:
            sys.exit(at_random(program, folder, scenes, names, count, seed) > 0)
        for name in names:
            before = runs
            for what, scene in variants(tomllib.loads((scenes / f"{name}.toml").read_text())):
                path = folder / f"{name}.toml"
                write(path, scene)
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
