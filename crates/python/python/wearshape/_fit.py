"""Parameters of a scene from measurements: least squares by scipy."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wearshape import _arguments as arguments
from wearshape import _core
from wearshape import _keys as keys
from wearshape._error import Error
from wearshape._extras import extra
from wearshape._result import Result
from wearshape._scene import Scene
from wearshape._table import Table

_DEVIATIONS = "give one standard deviation for all values, or one each"

#: Relative step of the differences: numbers are known to the accuracy of the scene, which has to be finer by some digits.
_STEP = 1e-4


class Measurement(ABC):
    """Something measured in an experiment."""

    #: What was set in the experiment, beside the scene.
    changes: Mapping[str, Any]

    @abstractmethod
    def residuals(self, result: Result) -> NDArray[np.float64]:
        """(computed - measured) / sigma. Shape (m,)."""


@dataclass(frozen=True)
class Number(Measurement):
    """A measured number of the summary."""

    #: Dotted key, as ``"pressure.torque_Nmm"``; of a list the place from 0, as ``"contact.ends_mm.1"``.
    key: str
    #: Measured value, in the unit of the key.
    value: float
    #: Its standard deviation, in the same unit.
    sigma: float
    #: What was set in this experiment, beside the scene.
    changes: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        arguments.instance("key", self.key, str, "a dotted key of the summary")
        arguments.finite("value", self.value)
        if arguments.finite("sigma", self.sigma) <= 0:
            raise Error(f"sigma = {self.sigma} is not positive", "wrong-argument", "sigma", _DEVIATIONS)

    def residuals(self, result: Result) -> NDArray[np.float64]:
        """(computed - measured) / sigma. Shape (1,)."""
        value = keys.number(result.summary, self.key)
        if value is None and keys.item(result.summary, self.key) is not None:
            raise Error(f"{self.key} of the summary is no number", "no-number", self.key, "see `result.summary`")
        if value is None:
            raise Error(f"the summary has no {self.key}: {result.verdict}", "no-number", self.key, "see `result.summary`")
        return np.array([(value - self.value) / self.sigma])


@dataclass(frozen=True)
class _Column(Measurement):
    #: Name of the column, its unit at its end.
    column: str
    #: Places of the measurements: s (mm) of a profile, time (s) of a history. Shape (m,).
    at: ArrayLike
    #: Measured values. Shape (m,).
    values: ArrayLike
    #: Their standard deviation, one for all or one each.
    sigma: ArrayLike
    #: What was set in this experiment, beside the scene.
    changes: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        at = arguments.array("at", self.at, (None,))
        arguments.array("values", self.values, at.shape)
        sigma = arguments.array("sigma", np.atleast_1d(np.asarray(self.sigma)), (None,))
        arguments.refused("sigma", sigma, sigma <= 0, "is not positive", _DEVIATIONS)
        if at.size == 0 or sigma.size not in (1, at.size):
            raise Error(f"{self.column} has {at.size} places and {sigma.size} deviations", "shape", "at", _DEVIATIONS)

    def _computed(self, kind: str, table: Table | None) -> NDArray[np.float64]:
        names = () if table is None else table.dtype.names or ()
        if table is None or self.column not in names or table.dtype[self.column].kind != "f":
            remedy = f"one of {', '.join(names)}" if names else f"a scene whose result has a {kind}"
            raise Error(f"the {kind} has no numbers {self.column}", "no-column", self.column, remedy)
        return np.asarray(table[self.column])

    def _against(self, known: NDArray[np.float64], computed: NDArray[np.float64]) -> NDArray[np.float64]:
        """Between the points of the solver by a cubic that keeps the ups and downs of its numbers."""
        with extra("fit", "wearshape.fit"):
            from scipy.interpolate import PchipInterpolator

        at = np.asarray(self.at, dtype=np.float64)
        if at.min() < known[0] or at.max() > known[-1]:
            reach = f"from {known[0]:.6g} to {known[-1]:.6g}"
            raise Error(f"{self.column} is measured beyond what is computed, {reach}", "beyond", None, "leave those out, or run longer")
        there = PchipInterpolator(known, computed)(at)
        return np.asarray((there - np.asarray(self.values, dtype=np.float64)) / np.asarray(self.sigma), dtype=np.float64)


@dataclass(frozen=True)
class Profile(_Column):
    """A measured profile: a column of ``result.profile``, as ``"gap_um"``, at places s (mm)."""

    def residuals(self, result: Result) -> NDArray[np.float64]:
        """(computed - measured) / sigma. Shape (m,)."""
        if result._solution.is_map:
            remedy = "give a Number of the summary, as Number(\"pressure.p_max_MPa\", value, sigma)"
            raise Error(f"{self.column} is no curve over s: the surface has two dimensions", "no-curve", self.column, remedy)
        return self._against(result.s, self._computed("profile", result.profile))


@dataclass(frozen=True)
class History(_Column):
    """Measurements over time (s): a column of ``result.history``, as ``"volume1_mm3"``."""

    def residuals(self, result: Result) -> NDArray[np.float64]:
        """(computed - measured) / sigma. Shape (m,)."""
        found = self._computed("history", result.history)
        return self._against(result.history["time_s"], found)


@dataclass(frozen=True)
class Combination:
    """A direction in the space of the parameters, and how well the data tell the place along it."""

    #: Share of each parameter's relative change, a unit vector.
    direction: dict[str, float]
    #: Standard deviation of the relative change along it; 1 is 100 %.
    deviation: float

    @property
    def known(self) -> bool:
        """Whether the data tell it: to better than its own size."""
        return self.deviation < 1


@dataclass(frozen=True)
class Fit:
    """Estimated parameters."""

    #: Estimates by key.
    estimates: dict[str, float]
    #: Covariance of the estimates, in the order of ``estimates``; inf in it where a combination is not told at all. Shape (p, p).
    covariance: NDArray[np.float64]
    #: Singular directions of the relative sensitivities, best known first.
    combinations: list[Combination]
    #: Half the sum of squared residuals.
    cost: float
    #: Residuals at the estimates, each by its standard deviation. Shape (m,).
    residuals: NDArray[np.float64]
    #: Runs of the scene.
    runs: int

    @property
    def deviations(self) -> dict[str, float]:
        """Standard deviation of each estimate."""
        return dict(zip(self.estimates, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    @property
    def unknown(self) -> list[Combination]:
        """Combinations of parameters that the data cannot tell apart."""
        return [each for each in self.combinations if not each.known]

    def interval(self, key: str, level: float = 0.95) -> tuple[float, float]:
        """Confidence interval of an estimate, for noise as the given sigma say."""
        with extra("fit", "Fit.interval"):
            from scipy.stats import norm

        if key not in self.estimates:
            raise Error(f"nothing was estimated of {key}", "wrong-argument", "key", f"give one of {', '.join(self.estimates)}")
        if not 0 < arguments.number("level", level) < 1:
            raise Error(f"level = {level} is no probability between 0 and 1", "wrong-argument", "level", "give 0.95 for 95 %")
        reach = float(norm.ppf(0.5 + level / 2)) * self.deviations[key]
        return self.estimates[key] - reach, self.estimates[key] + reach


def fit(
    scene: Scene,
    data: Sequence[Measurement],
    parameters: Mapping[str, float | Sequence[float]],
) -> Fit:
    """Finds parameters of a scene from measurements by ``scipy.optimize.least_squares``.

    :param data: :class:`Number`, :class:`Profile` and :class:`History`, each with its standard deviation and with what was set in its
        experiment; equal settings are run once.
    :param parameters: keys with a start value other than 0, or with three: a start value, the smallest and the largest one. Keys are those of
        :meth:`Scene.set`; ``wear.beta.0`` is the first of a list.

    The covariance is (J^T J)^-1 of the residuals, whose sigma are taken as they are given.

    Raises :class:`Error` for data that the scene does not compute, and where it has no answer beside a point that has one, so that there are no slopes.
    """
    with extra("fit", "wearshape.fit"):
        from scipy.optimize import least_squares

    arguments.instance("scene", scene, Scene, "a wearshape.Scene")
    arguments.instance("parameters", parameters, Mapping, "a mapping of keys to start values")
    arguments.instance("data", data, Sequence, "a list of Number, Profile and History")
    for number, each in enumerate(data):
        arguments.instance(f"data[{number}]", each, Measurement, "a Number, a Profile or a History")
    names = list(parameters)
    if not names or not data:
        raise Error("there is nothing to fit", "nothing-to-fit", None, "give one parameter and one measurement at least")
    ranges = np.array([_range(key, value) for key, value in parameters.items()])
    start, bounds = ranges[:, 0], ranges[:, 1:]
    experiments: dict[Hashable, list[Measurement]] = {}
    for each in data:
        experiments.setdefault(_told(each.changes), []).append(each)
    bodies = _core.Bodies()
    runs = 0
    length: int | None = None
    lost: Error | None = None

    def residuals(relative: NDArray[np.float64]) -> NDArray[np.float64]:
        nonlocal runs, length, lost
        values = dict(zip(names, (relative * start).tolist(), strict=True))
        parts: list[NDArray[np.float64]] = []
        for group in experiments.values():
            runs += 1
            try:
                result = _changed(scene, values, group[0].changes).run(bodies=bodies)
                parts.extend(each.residuals(result) for each in group)
            except Error as error:
                # A step that went too far, to where there is no answer, is made shorter.
                if length is None:
                    raise
                lost = error
                return np.full(length, np.inf)
        found = np.concatenate(parts)
        length = len(found)
        return found

    limits = np.sort(bounds / start[:, None], axis=1).T
    steps = np.full(len(names), _STEP)
    try:
        solved = least_squares(residuals, np.ones(len(names)), bounds=(limits[0], limits[1]), diff_step=steps, x_scale=1.0)
    except (ValueError, np.linalg.LinAlgError) as error:  # slopes that are not finite
        if lost is None or isinstance(error, Error):
            raise
        raise _beside(lost) from error
    jacobian = np.asarray(solved.jac, dtype=np.float64)
    if not np.isfinite(jacobian).all() and lost is not None:
        raise _beside(lost)
    slopes = jacobian * solved.x
    # Fewer measurements than parameters leave directions that none of them tells.
    slopes = np.vstack([slopes, np.zeros((max(0, len(names) - len(slopes)), len(names)))])
    _, singular, rows = np.linalg.svd(slopes, full_matrices=False)
    combinations = [
        Combination(dict(zip(names, row.tolist(), strict=True)), float(1 / value) if value > 0 else np.inf)
        for row, value in zip(rows, singular, strict=True)
    ]
    told = singular > singular[0] * 1e-7
    estimates = solved.x * start
    relative = (rows[told].T / singular[told] ** 2) @ rows[told]
    covariance = relative * np.outer(estimates, estimates)
    lost = (np.abs(rows[~told]) > 1e-6).any(axis=0)
    covariance[lost] = covariance[:, lost] = np.inf
    return Fit(
        estimates=dict(zip(names, estimates.tolist(), strict=True)),
        covariance=covariance,
        combinations=combinations,
        cost=float(solved.cost),
        residuals=solved.fun,
        runs=runs,
    )


def _range(key: str, value: Any) -> tuple[float, float, float]:
    """Start, smallest and largest value of a parameter."""
    given = value.tolist() if hasattr(value, "tolist") else value  # numpy's arrays and numbers
    given = given if isinstance(given, (tuple, list)) else (given, -math.inf, math.inf)
    remedy = "give a start, or a start, then the smallest and the largest value: (start, low, high)"
    if len(given) != 3:
        what = " and no start" if len(given) == 2 else ""
        raise Error(f"{key} has {len(given)} numbers{what}", "wrong-start", key, remedy)
    start, low, high = (arguments.number(f"parameters[{key!r}]", number) for number in given)
    if start == 0:
        raise Error(f"{key} starts at 0", "zero-start", key, "start where it might be: its size is the scale of the steps")
    if not (low <= start <= high and low < high and math.isfinite(start)):
        raise Error(f"{key} starts outside of its bounds: {start}, from {low} to {high}", "wrong-start", key, remedy)
    return start, low, high


def _beside(lost: Error) -> Error:
    remedy = "bound the parameters away from there, or start elsewhere"
    return Error(f"there are no slopes, for the scene has no answer beside a point: {lost.message}", "no-slope", lost.key, remedy)


def _told(value: Any) -> Hashable:
    """What two settings have in common that are equal: every digit of their arrays."""
    if isinstance(value, Mapping):
        return tuple(sorted((str(key), _told(each)) for key, each in value.items()))
    if isinstance(value, (list, tuple)):
        return tuple(_told(each) for each in value)
    if hasattr(value, "__array__"):
        return tuple(map(str, getattr(value, "columns", ()))), repr(np.asarray(value).tolist())
    return repr(value)


def _changed(scene: Scene, values: Mapping[str, float], changes: Mapping[str, Any]) -> Scene:
    """The scene with parameters, then with what the experiment sets."""
    return scene.set({**values, **changes})
