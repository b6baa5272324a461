"""What a resolved scene says, read without any code of wearshape.

Units N, mm, MPa, s, rad. Body 1 is shaped, body 2 is the counter-face; n points out of body 2
into body 1; tau is the direction in which body 2 drags body 1. Everything about the wanted
pressure is computed here again, from the formulas, so that a mistake in wearshape's own
pressure shows as a difference.
"""

import math
import tomllib

import numpy as np

UNITS = {
    "": 1.0, "rad": 1.0, "deg": math.pi / 180.0,
    "mm": 1.0, "m": 1e3, "um": 1e-3, "cm": 10.0,
    "N": 1.0, "kN": 1e3, "MN": 1e6, "MPa": 1.0, "GPa": 1e3, "kPa": 1e-3, "Pa": 1e-6,
    "N mm": 1.0, "N m": 1e3, "kN mm": 1e3, "kN m": 1e6, "s": 1.0, "min": 60.0, "h": 3600.0,
    "mm/s": 1.0, "m/s": 1e3, "rad/s": 1.0, "rpm": math.pi / 30.0, "deg/s": math.pi / 180.0,
    "degC": 1.0, "1/K": 1.0, "W/(m K)": 1.0, "W/(m2 K)": 1e-3, "mW/mm^2": 1.0,
}


def quantity(value):
    """A number in base units from a number or from a string with a unit."""
    if isinstance(value, (int, float)):
        return float(value)
    if value.strip() == "inf":
        return math.inf
    number, _, unit = value.strip().partition(" ")
    if unit.strip() not in UNITS:
        raise ValueError(f"unit of {value!r} is not known here")
    return float(number) * UNITS[unit.strip()]


def read(path):
    """The scene file as a dictionary; only N-mm is understood."""
    with open(path, "rb") as file:
        scene = tomllib.load(file)
    if scene.get("units") != "N-mm":
        raise ValueError(f"units {scene.get('units')!r}: this script understands N-mm")
    return scene


def material(body):
    """(E, nu) of a body."""
    values = body["material"]
    return quantity(values["young"]), quantity(values["poisson"])


def geometry(body):
    """(template name, its parameters in base units)."""
    (name, values), = body["geometry"].items()
    convert = lambda v: [quantity(x) for x in v] if isinstance(v, list) else quantity(v)
    return name, {key: convert(value) for key, value in values.items()}


def pair(value):
    """A number for body 1 alone or for both, or a list of two."""
    return [quantity(v) for v in value] if isinstance(value, list) else [quantity(value)] * 2


class Surface:
    """The contact surface as a curve with a scalar coordinate c: the angle from the vertical on
    an arc, x on a line (r when axisymmetric)."""

    def __init__(self, scene):
        self.axisymmetric = scene["kinematics"] == "axisymmetric"
        self.thickness = 1.0 if self.axisymmetric else quantity(scene.get("thickness", 1.0))
        self.friction = quantity(scene["contact"].get("friction", 0.0))
        self.shear = bool(scene["contact"].get("shear", True))
        first, second = geometry(scene["body1"]), geometry(scene["body2"])
        self.centre, self.radius, self.ball = (0.0, 0.0), None, None
        if first[0] == "shoe-block":
            self.radius = first[1]["radius"]
            half = first[1]["half_angle"]
            self.range = (-half, half)
        elif first[0] == "ring-segment":
            self.radius = min(first[1]["inner"], first[1]["outer"])
            self.range = tuple(math.asin(x / self.radius) for x in first[1]["x"])
        elif first[0] == "ring":
            # A housing around its shaft: less than a quarter of a turn to both sides of the top can touch.
            self.radius = first[1]["inner"]
            self.range = (-math.radians(80.0), math.radians(80.0))
        elif first[0] == "rectangle":
            self.height = second[1]["z"][1]
            self.range = (max(first[1]["x"][0], second[1]["x"][0]), min(first[1]["x"][1], second[1]["x"][1]))
        elif first[0] == "half-disc":
            self.height, self.ball = second[1]["z"][1], first[1]["radius"]
            self.range = (0.0 if self.axisymmetric else -0.5 * self.ball, 0.5 * self.ball)
        else:
            raise ValueError(f"contact of a {first[0]} is not known here")
        if self.radius is not None:
            self.centre = tuple(second[1].get("centre", [0.0, 0.0]))
        sliding = scene.get("sliding", {})
        self.omega = quantity(sliding["omega"]) if "omega" in sliding else None
        self.speed = quantity(sliding["speed"]) if "speed" in sliding else None
        drive = self.omega if self.omega is not None else self.speed
        self.sense = 0.0 if drive is None else math.copysign(1.0, drive)

    def coordinate(self, x, z):
        """Angle on an arc, x on a line."""
        if self.radius is None:
            return np.asarray(x, dtype=float)
        return np.arctan2(np.asarray(x) - self.centre[0], np.asarray(z) - self.centre[1])

    def point(self, c):
        """(x, z) of a coordinate."""
        c = np.asarray(c, dtype=float)
        if self.radius is None:
            return np.stack([c, np.full_like(c, self.height)], axis=-1)
        return np.stack([self.centre[0] + self.radius * np.sin(c), self.centre[1] + self.radius * np.cos(c)], axis=-1)

    def on_body(self, c, number):
        """(x, z) on the surface of body 1 or 2; they differ where the unloaded bodies do."""
        if self.ball is None or number == 2:
            return self.point(c)
        c = np.asarray(c, dtype=float)
        return np.stack([c, self.height + self.initial_gap(c)], axis=-1)

    def initial_gap(self, c):
        """Distance of the unloaded bodies along n, mm: R - sqrt(R^2 - x^2) for a ball."""
        c = np.asarray(c, dtype=float)
        if self.ball is None:
            return np.zeros_like(c)
        return c * c / (self.ball + np.sqrt(self.ball**2 - c * c))

    def normal(self, c):
        """n, out of body 2 into body 1."""
        c = np.asarray(c, dtype=float)
        if self.radius is None:
            return np.stack([np.zeros_like(c), np.ones_like(c)], axis=-1)
        return np.stack([np.sin(c), np.cos(c)], axis=-1)

    def drag(self, c):
        """tau in the plane: body 2 turning anti-clockwise drags along (-nz, nx)."""
        n = self.normal(c)
        if self.radius is None:
            return self.sense * np.stack([n[..., 1], n[..., 0]], axis=-1)
        return self.sense * np.stack([-n[..., 1], n[..., 0]], axis=-1)

    def area(self, c):
        """dS/dc: mm^2 per rad or per mm."""
        if self.radius is not None:
            return np.full_like(np.asarray(c, dtype=float), self.radius * self.thickness)
        return 2.0 * math.pi * np.asarray(c) if self.axisymmetric else np.full_like(np.asarray(c, float), self.thickness)

    def sliding_speed(self, c):
        """v, mm/s."""
        c = np.asarray(c, dtype=float)
        if self.omega is None:
            return np.full_like(c, abs(self.speed or 1.0))
        return abs(self.omega) * (c if self.axisymmetric else np.full_like(c, self.radius))

    def balance_friction(self):
        """mu in the force balance: zero when the shear is out of the plane or left out."""
        return 0.0 if self.axisymmetric or not self.shear else self.friction

    def rule(self, count=400):
        """Gauss points c and weights of area."""
        x, w = np.polynomial.legendre.leggauss(count)
        a, b = self.range
        c = 0.5 * (a + b) + 0.5 * (b - a) * x
        return c, 0.5 * (b - a) * w * self.area(c)


def modes(scene, surface):
    """The free rigid modes of body 1 as functions of c: pairs (phi, psi). phi is the closing
    velocity, psi = phi - mu tau . d the share of the balance that p carries."""
    mu = surface.balance_friction()
    vertical = (lambda c: surface.normal(c)[..., 1], lambda c: surface.normal(c)[..., 1] + mu * surface.drag(c)[..., 1])
    found = [vertical]
    load = scene["load"]
    turning = load.get("as") == "rigid" and "tilt" not in load
    if turning:
        about = pair(load.get("about", [0.0, 0.0]))[0]
        arm = lambda c: np.asarray(c, dtype=float) - about
        found.append((arm, arm))
    return found


class Pressure:
    """The wanted pressure p = ((lambda . phi)_+ / v^power)^k, N/mm^2."""

    def __init__(self, scene, surface):
        optimum = scene.get("optimum", {})
        functional, q = optimum.get("functional", "steady"), optimum.get("q", 1.0)
        if optimum.get("balance", "equilibrium") != "equilibrium" or optimum.get("modes", "kinematic") != "kinematic":
            raise ValueError("only balance = equilibrium with kinematic modes is known here")
        a, b = self._one_rule(scene)
        self.surface, self.uniform = surface, functional == "uniform"
        q = math.inf if q == "inf" else quantity(q)
        s, self.power = {"steady": (b + 1.0, a), "uniform": (2.0, 0.0), "wear-volume": (b * q, a * q),
                         "friction-power": (q, q), "wear-power": ((b + 1.0) * q, a * q)}[functional]
        if s == 1.0 or not math.isfinite(s):
            raise ValueError(f"s = {s}: no regular pressure")
        self.k = 1.0 / (s - 1.0)
        self.modes = modes(scene, surface)
        load = scene["load"]
        self.goal = np.array([quantity(load["force"]), quantity(load.get("moment", 0.0))][: len(self.modes)])
        self.multipliers = self._balance()

    @staticmethod
    def _one_rule(scene):
        """(a, b) of the one wear rule that shapes the pressure; two different rules are refused."""
        rule = scene.get("wear", {})
        if "threshold" in rule and scene.get("optimum", {}).get("functional") not in ("uniform", "friction-power"):
            raise ValueError("a wear rule with a threshold: the pressure is not known here")
        a, b = pair(rule.get("a", 1.0)), pair(rule.get("b", 1.0))
        factor = rule.get("beta", rule.get("k", 1.0))
        wears = pair(factor) if isinstance(factor, list) else [quantity(factor), 0.0]
        alone = wears[1] == 0.0 or rule.get("counterface") == "fresh"
        if not alone and (a[0], b[0]) != (a[1], b[1]):
            raise ValueError("two different wear rules: the pressure is not known here")
        return a[0], b[0]

    def _shape(self, multipliers, c):
        if self.uniform:
            return np.full_like(np.asarray(c, dtype=float), multipliers[0])
        f = sum(m * phi(c) for m, (phi, _) in zip(multipliers, self.modes))
        safe = np.where(f > 0.0, f, 1.0)
        return np.where(f > 0.0, (safe / self.surface.sliding_speed(c) ** self.power) ** self.k, 0.0)

    def _resultants(self, multipliers):
        c, w = self.surface.rule()
        p = self._shape(multipliers, c)
        return np.array([np.sum(w * psi(c) * p) for _, psi in self.modes])

    def _residual(self, multipliers):
        return self._resultants(multipliers) - self.goal

    def _balance(self):
        """Newton with a difference Jacobian, from the multiplier that carries the force alone."""
        scale = np.array([1.0] + [1.0 / self.surface.range[1]] * (len(self.modes) - 1))
        start = np.zeros(len(self.modes))
        start[0] = 1.0
        carried = self._resultants(start)[0]
        if carried <= 0.0:
            raise ValueError("the surface cannot carry the force: jammed")
        start[0] = (self.goal[0] / carried) ** (1.0 if self.uniform else 1.0 / self.k)
        if self.uniform:
            return start
        lam = start
        for _ in range(50):
            residual = self._residual(lam)
            if np.max(np.abs(residual * scale)) <= 1e-13 * self.goal[0]:
                break
            steps = 1e-6 * start[0] * scale
            columns = [(self._residual(lam + d) - self._residual(lam - d)) / (2.0 * np.sum(d)) for d in np.diag(steps)]
            lam = lam - np.linalg.solve(np.array(columns).T, residual)
        return lam

    def __call__(self, c):
        return self._shape(self.multipliers, c)

    def field(self, ufl, x, number):
        """The same as an expression of the position x in the plane; `number` makes a coefficient of a form of a number."""
        surface = self.surface
        if self.uniform:
            return number(self.multipliers[0])
        closing = (x[1] - number(surface.centre[1])) / number(surface.radius) if surface.radius is not None else 1.0
        f = number(self.multipliers[0]) * closing
        if len(self.modes) > 1:
            zero = self.modes[1][0](np.zeros(1))[0]
            f = f + number(self.multipliers[1]) * (x[0] + number(zero))
        if surface.axisymmetric:
            f = f / (number(abs(surface.omega)) * x[0]) ** number(self.power)
        else:
            f = f / number(surface.sliding_speed(np.zeros(1))[0] ** self.power)
        return ufl.conditional(ufl.gt(f, 0.0), ufl.max_value(f, 1e-300) ** number(self.k), 0.0)
