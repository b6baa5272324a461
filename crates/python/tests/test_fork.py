"""Processes that are forked, as `multiprocessing` may do: they have none of the threads of their parent."""

import multiprocessing
import subprocess
import sys
from pathlib import Path

import pytest

MESH = Path(__file__).parents[3] / "data" / "meshes" / "punch.msh"

#: All that computes on several threads, in the parent, in two of its children and in their children.
CODE = f"""
import multiprocessing, wearshape

fork = multiprocessing.get_context("fork")

def computed(number):
    scene = wearshape.Scene("drum-brake-block").set(accuracy=1e-3)
    scene.check()
    levels = len(scene.forecast())
    result = scene.run()
    steel = wearshape.hpfem.Mesh({str(MESH)!r}).interface("bottom", {{"steel": (1000, 0.25)}}, supports={{"top": ["x", "z"]}})
    return levels, float(result.gap.max()), len(result.files()), float(steel.stiffness.max())

def of_a_child(wanted):
    assert computed(0) == wanted
    with fork.Pool(2) as pool:
        assert pool.map_async(computed, range(3)).get(60) == [wanted] * 3

wanted = computed(0)
of_a_child(wanted)
child = fork.Process(target=of_a_child, args=(wanted,))
child.start()
child.join(100)
assert child.exitcode == 0
assert computed(0) == wanted
"""


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods() or sys.platform == "darwin", reason="processes are not forked")
def test_a_forked_process_has_threads_of_its_own() -> None:
    subprocess.run([sys.executable, "-c", CODE], check=True, timeout=200)
