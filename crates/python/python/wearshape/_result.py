"""Results."""

from __future__ import annotations

import html
import json
import math
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from wearshape import _core
from wearshape._error import Error
from wearshape._extras import extra
from wearshape._table import Table, numbers, table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Numbers that a notebook shows, if the summary has them.
_SHOWN = (
    "shape.gap_max_um",
    "shape.crown_um",
    "shape.roundtrip_independent",
    "pressure.p_max_MPa",
    "contact.p_max_MPa",
    "pressure.torque_Nmm",
    "pressure.wear_volume_rate_mm3_per_s",
    "wear.depth_um",
    "wear.volume_mm3",
    "wear.time_s",
    "error.gap_relative",
    "error.pressure_relative",
)


class Result:
    """What a run computed.

    Arrays are views of the solver's own memory, for reading alone; ``.copy()`` gives one to write to. ``n`` is the number of points in order
    along the contact surface. They hold the last task that ran (pressure, contact, shape, wear). Of a run without an answer they raise
    :class:`Error` with the reason.
    """

    __slots__ = ("_files", "_profile", "_solution", "_summary")

    def __init__(self, solution: _core.Solution) -> None:
        self._solution = solution
        self._summary: dict[str, Any] | None = None
        self._profile: Table | None = None
        self._files: dict[str, bytes] | None = None

    @property
    def status(self) -> str:
        """``ok``, ``accuracy-missed``, ``not-converged``, ``refused`` or ``interrupted``."""
        return self._solution.status

    @property
    def ok(self) -> bool:
        """Whether everything asked for was computed to the accuracy asked for."""
        return self.status == "ok"

    @property
    def verdict(self) -> str:
        """One sentence that says what came of it."""
        return str(self.summary["verdict"])

    @property
    def summary(self) -> dict[str, Any]:
        """summary.json: every result with its unit in its name; an absent stage or a number that is not finite is an absent key."""
        if self._summary is None:
            self._summary = json.loads(self._solution.summary())
        return self._summary

    @property
    def error(self) -> dict[str, Any]:
        """Estimated relative errors (``gap_relative``, ``pressure_relative``, ``energy_relative``, as far as known) and ``how`` they were found."""
        return dict(self.summary.get("error", {}))

    @property
    def seconds(self) -> dict[str, float]:
        """Seconds of each stage."""
        return dict(self._solution.seconds())

    def _array(self, array: _core.Array | None) -> NDArray[np.float64]:
        if array is None:
            raise Error(f"there is no profile: {self.verdict}", "no-profile", None, "see `status` and `verdict` of the result")
        return numbers(array)

    @property
    def s(self) -> NDArray[np.float64]:
        """Arc length from the middle, positive towards +x; r in axisymmetric scenes. Shape (n,), mm."""
        return self._array(self._solution.s)

    @property
    def position(self) -> NDArray[np.float64]:
        """Position x, y, z of the points. Shape (n, 3), mm."""
        return self._array(self._solution.position)

    @property
    def weight(self) -> NDArray[np.float64]:
        """Area weights: ``(weight * f).sum()`` is the integral of f over the surface. Shape (n,), mm^2."""
        return self._array(self._solution.weight)

    @property
    def pressure(self) -> NDArray[np.float64]:
        """Contact pressure, positive in compression: optimal, solved, wanted or current. Shape (n,), MPa."""
        return self._array(self._solution.pressure)

    @property
    def gap(self) -> NDArray[np.float64]:
        """Gap of the unloaded surfaces along the normal, positive open; nan where no body was computed. Shape (n,), um."""
        return self._array(self._solution.gap)

    @property
    def wear_rate(self) -> NDArray[np.float64]:
        """Wear rate of both bodies. Shape (n,), um/s."""
        return self._array(self._solution.wear_rate)

    @property
    def profile(self) -> Table:
        """The columns of contact.csv as records, shape (n,); ``.to_pandas()`` makes a data frame. Laid out by the solver when first asked for."""
        if self._profile is None:
            records = self._solution.profile()
            if records is None:
                self._array(None)
                raise AssertionError
            self._profile = table(records)
        return self._profile

    @property
    def history(self) -> Table:
        """The steps of a run in time as records, one a step (history.csv); empty where nothing ran in time."""
        return table(self._solution.history())

    @property
    def resumable(self) -> bool:
        """Whether ``scene.run(resume=result)`` can go on with it."""
        return self._solution.resumable

    def files(self) -> dict[str, bytes]:
        """The files of an output folder by name: report.html, contact.csv, summary.json, plots/*.svg, ...; the same bytes as the command writes but
        for the list of files in summary.json; without timing.json and the recording of a run in time (run.mcap, run.layout.json), which the command makes."""
        if self._files is None:
            self._files = self._solution.files()
        return dict(self._files)

    def save(self, folder: str | PathLike[str]) -> list[Path]:
        """Writes the files to a folder, which is made; files of the same names in it are replaced, others stay. Returns their paths."""
        paths = []
        for name, content in self.files().items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            paths.append(path)
        return paths

    def plot(self) -> Figure:
        """Pressure and gap along the surface, or the pressure over one of two dimensions, by matplotlib, which has to be installed."""
        with extra("plot", "Result.plot"):
            import matplotlib.pyplot as plt

        if self._solution.is_map:
            return self._plot_map()
        known = self._solution.abscissa()
        curves = [("pressure (MPa)", self.pressure), ("gap (um)", self.gap)]
        curves = [(label, values) for label, values in curves if np.isfinite(values).any() and values.any()]
        figure, axes = plt.subplots(len(curves), 1, sharex=True, squeeze=False, layout="constrained")
        for (label, values), place in zip(curves, axes[:, 0], strict=True):
            place.plot(known[0] if known else self.s, values)
            place.set_ylabel(label)
            place.grid(alpha=0.3)
        if known:
            axes[-1, 0].set_xlabel(known[1])
        return figure

    def _plot_map(self) -> Figure:
        """The pressure over x and y, in the true proportions of the surface."""
        import matplotlib.pyplot as plt

        figure, axes = plt.subplots(layout="constrained")
        grid = self._solution.map()
        if grid is None:  # at singular exponents, where the pressure is no function of the place
            drawn: Any = axes.scatter(self.position[:, 0], self.position[:, 1], c=self.pressure, s=4)
        else:
            side = math.isqrt(len(numbers(grid)))
            x, y, pressure = numbers(grid).T.reshape(3, side, side)
            drawn = axes.pcolormesh(x, y, pressure, shading="gouraud")
        figure.colorbar(drawn, label="pressure (MPa)")
        axes.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
        return figure

    def __copy__(self) -> Result:
        """Another one of the same numbers, which never change."""
        return Result(self._solution)

    def __deepcopy__(self, memo: dict[int, Any]) -> Result:
        return Result(self._solution)

    def __reduce__(self) -> NoReturn:
        remedy = "keep `result.summary`, `result.profile` and `result.history`, `result.files()`, or `result.save(folder)`"
        raise TypeError(f"a wearshape.Result is a view of the solver's memory and cannot be pickled\n  remedy: {remedy}")

    def __repr__(self) -> str:
        return f"<wearshape.Result {self.status}: {self.verdict}>"

    def _repr_svg_(self) -> str | None:
        files = self.files()
        names = ("plots/gap.svg", "plots/map.svg", "plots/pressure.svg")
        picture = next((files[name] for name in names if name in files), None)
        return None if picture is None else picture.decode()

    def _repr_html_(self) -> str:
        rows = []
        for key in _SHOWN:
            stage, number = key.split(".")
            value = self.summary.get(stage, {}).get(number)
            if value is not None:
                rows.append(f"<tr><th>{key}</th><td>{value:.6g}</td></tr>")
        files = self.files()
        first = "plots/map.svg" if "plots/map.svg" in files else "plots/pressure.svg"
        pictures = [files[name].decode() for name in (first, "plots/gap.svg") if name in files]
        shown = "".join(f'<div style="max-width:44em">{picture}</div>' for picture in pictures)
        return f"<p><b>{html.escape(self.verdict)}</b></p><table>{''.join(rows)}</table>{shown}"
