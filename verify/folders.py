"""Folders under attack: pairs of processes on one folder, runs killed at any moment, sweeps and runs in time killed and continued.

The same scene gives the same bytes, so that a folder is whole where its files are those of a run that nothing disturbed. Nothing may be lost or
mixed.

usage: folders.py <wearshape> [pairs of processes] [kills of each kind] [seed]
"""

import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FORCES = [f"{force} kN" for force in (3, 5, 7, 11)]
SWEEP = ["sweep", "drum-brake-block", "--set", "tasks=[pressure]", "--over", "contact.friction=0:1:3000"]
WEAR = ["run", "punch-wear"]


def files(folder):
    """What a folder holds, but for its seconds; None where there is none."""
    if not folder.is_dir():
        return None
    paths = (path for path in folder.rglob("*") if path.is_file() and path.name not in ("timing.json", "run.mcap"))
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


class Attack:
    def __init__(self, program, place, seed):
        self.program, self.place, self.chance = program, pathlib.Path(place), random.Random(seed)
        self.faults = []

    def start(self, call, name, *more):
        command = [self.program, *call, "-o", name, "-q", "--threads", "1", *more]
        return subprocess.Popen(command, cwd=self.place, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def finish(self, call, name, *more):
        begun = time.monotonic()
        process = self.start(call, name, *more)
        said = process.communicate()[1]
        return process.returncode, said, time.monotonic() - begun

    def fault(self, words):
        self.faults.append(words)
        print("FAULT", words, flush=True)

    def whole(self, call, name):
        """A run that nothing disturbs, and its seconds."""
        code, said, seconds = self.finish(call, name)
        if code != 0:
            sys.exit(f"{call}: exit {code}: {said}")
        return files(self.place / name), seconds

    def clear(self, name):
        for path in self.place.glob(f"{name}*"):
            shutil.rmtree(path)

    def killed(self, call, name, seconds, *more):
        """A process that is killed within some seconds; whether it was still at work."""
        process = self.start(call, name, *more)
        time.sleep(self.chance.uniform(0, seconds))
        process.send_signal(signal.SIGKILL)
        process.communicate()
        return process.returncode == -signal.SIGKILL

    def pairs(self, count):
        """Two runs of different scenes in one folder: one wins whole, the other says that the folder is in use, or comes after it."""
        calls = [["run", "drum-brake-block", "--set", "tasks=[pressure]", "--set", f"load.force={force}"] for force in FORCES]
        wholes = [self.whole(call, f"whole-{number}")[0] for number, call in enumerate(calls)]
        refused = 0
        for _ in range(count):
            both = self.chance.sample(range(len(calls)), 2)
            processes = [self.start(calls[number], "both") for number in both]
            said = [process.communicate()[1] for process in processes]
            codes = [process.returncode for process in processes]
            refused += codes.count(2)
            won = [wholes[number] for number, code in zip(both, codes) if code == 0]
            if any(code not in (0, 2) for code in codes) or files(self.place / "both") not in won:
                self.fault(f"pair {both}: exits {codes}: {said}")
            if self.chance.random() < 0.3:
                self.clear("both")
        print(f"{count} pairs of processes, {refused} refused", flush=True)

    def kills(self, count):
        """A run that is killed leaves the folder of before or its own."""
        calls = [["run", "drum-brake-block", "--set", "mesh.degree=4", "--set", f"load.force={force}"] for force in FORCES[:2]]
        (before, seconds), (after, _) = (self.whole(call, f"good-{number}") for number, call in enumerate(calls))
        killed, own = 0, 0
        for _ in range(count):
            self.clear("run")
            self.finish(calls[0], "run")
            killed += self.killed(calls[1], "run", 1.2 * seconds)
            now = files(self.place / "run")
            own += now == after
            if now not in (before, after):
                self.fault(f"kill of a run: {None if now is None else sorted(now)}")
            code, said, _ = self.finish(calls[1], "run")
            if code != 0 or files(self.place / "run") != after:
                self.fault(f"run after a kill: exit {code}: {said}")
        print(f"{count} runs, {killed} killed at work, {own} had finished their folder", flush=True)

    def continued(self, call, name, count):
        """What is killed is continued to the same bytes, and what was written is never less."""
        whole, seconds = self.whole(call, f"{name}-whole")
        killed = 0
        for _ in range(count):
            self.clear(name)
            rows, more = 0, ()
            for _ in range(3):
                killed += self.killed(call, name, 0.6 * seconds, *more)
                partial = self.place / f"{name}.partial" / "sweep.jsonl"
                now = partial.read_bytes().count(b"\n") if partial.is_file() else 0
                if now < rows and not (self.place / name).is_dir():
                    self.fault(f"{name}: {rows} rows became {now}")
                rows = max(rows, now)
                there = (self.place / f"{name}.partial").is_dir()
                more = ("--resume",) if there and not (self.place / name).is_dir() else ()
                if (self.place / name).is_dir():
                    break
            code, said, _ = self.finish(call, name, *more)
            if code != 0 or files(self.place / name) != whole:
                self.fault(f"{name} continued {more}: exit {code}: {said}")
        print(f"{name}: {count} continued to the end, {killed} kills at work", flush=True)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve()
    pairs, kills, seed = [int(word) for word in sys.argv[2:5]] + [300, 100, 1][len(sys.argv) - 2 :]
    print(f"seed {seed}", flush=True)
    with tempfile.TemporaryDirectory() as place:
        attack = Attack(program, place, seed)
        attack.pairs(pairs)
        attack.kills(kills)
        attack.continued(SWEEP, "sweep", kills)
        attack.continued(WEAR, "wear", kills)
    print(f"{len(attack.faults)} faults")
    sys.exit(bool(attack.faults))


if __name__ == "__main__":
    main()
