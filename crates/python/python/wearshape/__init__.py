"""The contact shape that starts worn in: pressure, contact, shape and wear in time of two bodies in sliding wear.

>>> import wearshape
>>> result = wearshape.Scene("drum-brake-block").run()
>>> result.status
'ok'

Units are N, mm, MPa, s and rad; results have theirs in their names.
"""

from wearshape import hpfem, wear
from wearshape._error import Error, Place
from wearshape._result import Result
from wearshape._scene import Bodies, Check, Level, Lint, Scene, Stage, scenes
from wearshape._table import Table

__all__ = ["Bodies", "Check", "Error", "Level", "Lint", "Place", "Result", "Scene", "Stage", "Table", "hpfem", "scenes", "wear"]
