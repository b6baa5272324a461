"""Optimal and steady pressures on points of your own, without bodies.

A surface is a list of points with position, normal, area weight, sliding speed and drag direction. Body 1 wears by
``w' = factor p^b v^a`` (mm/s, p in MPa, v in mm/s). Formulas and limits: the README of the crate ``wear``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wearshape import _core
from wearshape._arguments import UNIT, array, finite, instance, number, refused, units
from wearshape._table import numbers

__all__ = ["Law", "Optimum", "Press", "Surface", "Tilt", "optimal_pressure"]


@dataclass(frozen=True)
class Surface:
    """Points of a contact surface, n of them; body 2 slides over body 1."""

    #: Position, shape (n, 3), mm; y is out of the plane of plane scenes.
    position: ArrayLike
    #: Unit normal out of body 2 into body 1, shape (n, 3).
    normal: ArrayLike
    #: Area weight, shape (n,), mm^2: ``(weight * f).sum()`` is the integral of f.
    weight: ArrayLike
    #: Sliding speed of body 2 relative to body 1, shape (n,), mm/s, 0 or more.
    sliding_speed: ArrayLike
    #: Unit tangent along which body 2 drags body 1, shape (n, 3); zero where the speed is zero.
    drag: ArrayLike


@dataclass(frozen=True)
class Law:
    """Wear rule of body 1, ``w' = factor p^b v^a``."""

    #: Archard's k, or beta mu^b; (mm/s) / (MPa^b (mm/s)^a).
    factor: float
    #: Exponent a of the sliding speed.
    a: float = 1.0
    #: Exponent b > 0 of the pressure.
    b: float = 1.0


@dataclass(frozen=True)
class Press:
    """A free translation with the force that the load has along it."""

    #: Force (N).
    force: float
    #: Unit direction of the force on body 1; pressing down is -z.
    direction: Sequence[float] = (0.0, 0.0, -1.0)


@dataclass(frozen=True)
class Tilt:
    """A free rotation with the moment that the contact pressure has about it."""

    #: Moment (N mm).
    moment: float
    #: A point of the axis (mm).
    about: Sequence[float] = (0.0, 0.0, 0.0)
    #: Unit axis; +y closes the +x side of a plane surface.
    axis: Sequence[float] = (0.0, 1.0, 0.0)


@dataclass(frozen=True)
class Optimum:
    """An optimal pressure and what follows from it."""

    #: Pressure at the points, shape (n,), MPa, a view for reading alone; zero where there is no contact.
    pressure: NDArray[np.float64]
    #: regular, near-singular, singular, partial-contact or several.
    regime: str
    #: minimum, maximum, indifferent or stationary, said only where it is proved.
    character: str
    #: Multiplier of each motion; the feed itself (mm/s, rad/s) for the steady state.
    multipliers: tuple[float, ...]
    #: Rigid velocity of wear in each motion, mm/s or rad/s, where the state is steady.
    feed: tuple[float, ...] | None
    #: Resultants that the motions carry, friction included (N, N mm).
    resultants: tuple[float, ...]
    #: Smallest pressure (MPa).
    p_min: float
    #: Largest pressure (MPa).
    p_max: float
    #: Mean pressure (MPa).
    p_mean: float
    #: Integral of the pressure (N).
    normal_force: float
    #: Wear volume a second (mm^3/s).
    wear_volume_rate: float
    #: Integral of mu p v (mW).
    friction_power: float
    #: Integral of p w' (mW).
    wear_power: float
    #: Part of the wear rate that is not a rigid motion, relative; 0 in the steady state.
    steadiness_residual: float | None


def optimal_pressure(
    surface: Surface,
    law: Law,
    motions: Sequence[Press | Tilt],
    *,
    friction: float = 0.0,
    functional: str = "steady",
    q: float = 1.0,
) -> Optimum:
    """The pressure that makes a functional stationary under a load.

    ``functional`` is ``steady`` (default), ``wear-volume``, ``friction-power``, ``wear-power`` or ``uniform``; ``q`` is used by the three in
    the middle. ``motions`` are the rigid motions that body 1 is free in, six at most. ``friction`` is the coefficient mu.

    Raises :class:`wearshape.Error` for a load that no pressure carries, for shapes that do not fit, and for numbers that make no surface.
    """
    instance("law", law, Law, "a wearshape.wear.Law")
    instance("motions", motions, Iterable, "a list of wearshape.wear.Press and Tilt")
    instance("functional", functional, str, "a word")
    position, columns = _columns(surface)
    found = _core.optimal_pressure(
        {
            "position": position.tolist(),
            "normal": columns["normal"].tolist(),
            "drag": columns["drag"].tolist(),
            "weight": columns["weight"].tolist(),
            "sliding_speed": columns["sliding_speed"].tolist(),
            "law": [number(f"law.{name}", value) for name, value in (("factor", law.factor), ("a", law.a), ("b", law.b))],
            "friction": number("friction", friction),
            "functional": functional,
            "q": number("q", q),
            "modes": [_mode(f"motions[{index}]", motion) for index, motion in enumerate(motions)],
        }
    )
    regime, character = found.words
    known = dict(found.numbers)
    return Optimum(
        pressure=numbers(found.pressure),
        regime=regime,
        character=character,
        multipliers=tuple(found.multipliers),
        feed=None if found.feed is None else tuple(found.feed),
        resultants=tuple(found.resultants),
        steadiness_residual=known.pop("steadiness_residual"),
        **{name: known[name] or 0.0 for name in _SURE},
    )


_SURE = ("p_min", "p_max", "p_mean", "normal_force", "wear_volume_rate", "friction_power", "wear_power")


def _columns(surface: Surface) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]:
    """Positions, and what goes with them, as far as they make a surface."""
    instance("surface", surface, Surface, "a wearshape.wear.Surface")
    position = array("position", surface.position, (None, 3))
    count = len(position)
    columns = {
        "normal": array("normal", surface.normal, (count, 3)),
        "drag": array("drag", surface.drag, (count, 3)),
        "weight": array("weight", surface.weight, (count,)),
        "sliding_speed": array("sliding_speed", surface.sliding_speed, (count,)),
    }
    units("normal", columns["normal"])
    units("drag", columns["drag"], or_zero=True)
    along = np.abs((columns["drag"] * columns["normal"]).sum(axis=1))
    refused("drag", columns["drag"], along > UNIT, "is no tangent", "give vectors at right angles to the normals")
    for name in ("weight", "sliding_speed"):
        refused(name, columns[name], columns[name] < 0, "is negative", "give 0 or more")
    return position, columns


def _mode(name: str, motion: Press | Tilt) -> _core.Mode:
    instance(name, motion, (Press, Tilt), "a wearshape.wear.Press or Tilt")
    if isinstance(motion, Press):
        force = finite(f"{name}.force", motion.force)
        return {"direction": _direction(f"{name}.direction", motion.direction), "about": None, "resultant": force}
    about: list[float] = array(f"{name}.about", motion.about, (3,)).tolist()
    moment = finite(f"{name}.moment", motion.moment)
    return {"direction": _direction(f"{name}.axis", motion.axis), "about": about, "resultant": moment}


def _direction(name: str, vector: Sequence[float]) -> list[float]:
    direction = array(name, vector, (3,))
    units(name, direction)
    return [float(part) for part in direction]
