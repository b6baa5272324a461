"""Arguments as they are given: what is none of its kind is refused by its name, before anything is computed."""

from __future__ import annotations

import math
import operator
import reprlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wearshape._error import Error

#: Largest difference of the length of a unit vector from 1, and of a tangent from a right angle.
UNIT = 1e-6


def instance(name: str, value: Any, kinds: type | tuple[type, ...], wanted: str) -> None:
    """Refuses a value of another type; ``wanted`` says what is taken."""
    if not isinstance(value, kinds):
        raise TypeError(f"{name} must be {wanted}, not {reprlib.repr(value)}")


def whole(name: str, value: Any, low: int, high: int, what: str) -> None:
    """Refuses what is no whole number from ``low`` to ``high`` of ``what``."""
    try:
        count = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {reprlib.repr(value)}") from None
    if not low <= count <= high:
        raise Error(f"{name} = {count} is out of range", "wrong-argument", name, f"give {low} to {high} {what}")


def sample(value: int | None) -> None:
    """Refuses a wrong number of points along the surface."""
    if value is not None:
        whole("sample", value, 2, 1_000_000, "points")


def number(name: str, value: Any) -> float:
    """A number, as Python has it; a text is none."""
    try:
        if not isinstance(value, (str, bytes, complex)):
            return float(value)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name} must be a number, not {reprlib.repr(value)}")


def finite(name: str, value: Any) -> float:
    """A number that is finite."""
    found = number(name, value)
    if not math.isfinite(found):
        raise Error(f"{name} = {found} is not finite", "wrong-argument", name, "give a finite number")
    return found


def array(name: str, values: Any, shape: tuple[int | None, ...]) -> NDArray[np.float64]:
    """Finite numbers of a shape, where None stands for any length."""
    shown = f"({', '.join('n' if length is None else str(length) for length in shape)}{',' if len(shape) == 1 else ''})"
    remedy = f"give an array of the shape {shown}"
    try:
        given = np.asarray(values)
        if np.iscomplexobj(given):
            raise TypeError("they are complex")
        numbers = given.astype(np.float64, copy=False)
    except (TypeError, ValueError) as error:
        raise Error(f"{name} is no array of numbers: {error}", "shape", name, remedy) from error
    if len(numbers.shape) != len(shape) or any(wanted not in (None, found) for found, wanted in zip(numbers.shape, shape, strict=True)):
        raise Error(f"{name} has the shape {numbers.shape}", "shape", name, remedy)
    refused(name, numbers, ~np.isfinite(numbers), "is not finite", "give finite numbers")
    return numbers


def refused(name: str, values: NDArray[np.float64], wrong: NDArray[np.bool_], what: str, remedy: str) -> None:
    """Refuses the first value that is wrong, by its indices."""
    if wrong.any():
        place = tuple(np.argwhere(wrong)[0].tolist())
        where = f"{name}[{', '.join(map(str, place))}]" if place else name
        raise Error(f"{where} = {values[place].tolist()} {what}", "wrong-argument", name, remedy)


def units(name: str, vectors: NDArray[np.float64], *, or_zero: bool = False) -> None:
    """Refuses vectors, along the last axis, that have not the length 1."""
    lengths = np.linalg.norm(vectors, axis=-1)
    wrong = (np.abs(lengths - 1) > UNIT) & ~(or_zero & (lengths == 0))
    kind = "neither a unit vector nor zero" if or_zero else "no unit vector"
    refused(name, vectors, np.asarray(wrong), f"is {kind}", "give vectors of the length 1")
