"""The contact shape that starts worn in: pressure, contact, shape and wear in time of two bodies in sliding wear.

>>> import wearshape
>>> result = wearshape.Scene("drum-brake-block").run()
>>> result.status
'ok'

Units are N, mm, MPa, s and rad; results have theirs in their names.
"""

from importlib.metadata import version as _version

from wearshape import hpfem, wear
from wearshape._error import Error, Place
from wearshape._result import Result
from wearshape._scene import Bodies, Check, Level, Lint, Scene, Stage, scenes
from wearshape._fit import Combination, Fit, History, Measurement, Number, Profile, fit
from wearshape._sweep import sweep
from wearshape._table import Table
from wearshape._umbridge import umbridge

__version__ = _version("wearshape")

__all__ = [
    "Bodies",
    "Check",
    "Combination",
    "Error",
    "Fit",
    "History",
    "Level",
    "Lint",
    "Measurement",
    "Number",
    "Place",
    "Profile",
    "Result",
    "Scene",
    "Stage",
    "Table",
    "fit",
    "hpfem",
    "scenes",
    "sweep",
    "umbridge",
    "wear",
    "__version__",
]
