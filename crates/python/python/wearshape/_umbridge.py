"""A scene as a model of UM-Bridge, the protocol of uncertainty quantification."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from wearshape import _core
from wearshape._error import Error
from wearshape._scene import Scene

if TYPE_CHECKING:
    from umbridge import Model

#: Outputs whose derivatives by the given numbers come with the summary, and their name there.
_EXACT = {
    "pressure.wear_depth_um_per_h": "wear_rate_percent",
    "pressure.torque_Nmm": "torque_percent",
    "pressure.p_max_MPa": "p_max_percent",
}


def umbridge(scene: Scene, inputs: Sequence[str], outputs: Sequence[str], *, name: str = "wearshape") -> Model:
    """A scene as a model for ``umbridge.serve_models([model], port)``; the package ``umbridge`` has to be installed.

    :param inputs: keys of the scene, the components of the one input vector, in the units of the scene.
    :param outputs: dotted keys of the summary, the components of the one output vector; nan where a point has no answer or is out of the range of
        a key.

    ``Evaluate`` runs the scene; points that differ in load, friction, sliding, wear or optimum share factorised bodies. ``Gradient`` is there
    where all derivatives come with the pressure (``summary["pressure"]["sensitivity"]``): outputs
    ``pressure.wear_depth_um_per_h``, ``pressure.torque_Nmm`` and ``pressure.p_max_MPa`` of a scene with the task ``pressure`` alone, by
    its given numbers. Derivatives that the pressure has not, as by a number that is 0, are nan.
    """
    import umbridge as protocol

    bodies = _core.Bodies()

    def summary(values: Sequence[float]) -> dict[str, Any]:
        try:
            return scene.set(dict(zip(inputs, values, strict=True))).run(bodies=bodies).summary
        except Error as error:
            if error.code == "wrong-value":
                return {}
            raise

    def exact() -> bool:
        found = scene.run(bodies=bodies).summary
        known = {row["given"]: row for row in found.get("pressure", {}).get("sensitivity", [])}
        return all(output in _EXACT and all(_EXACT[output] in known.get(key, {}) for key in inputs) for output in outputs)

    class SceneModel(protocol.Model):  # type: ignore[misc]
        """One scene."""

        def __init__(self) -> None:
            super().__init__(name)
            self._exact = exact()

        def get_input_sizes(self, config: Mapping[str, Any] = {}) -> list[int]:
            return [len(inputs)]

        def get_output_sizes(self, config: Mapping[str, Any] = {}) -> list[int]:
            return [len(outputs)]

        def supports_evaluate(self) -> bool:
            return True

        def supports_gradient(self) -> bool:
            return self._exact

        def __call__(self, parameters: Sequence[Sequence[float]], config: Mapping[str, Any] = {}) -> list[list[float]]:
            found = summary(parameters[0])
            return [[_number(found, key) for key in outputs]]

        def gradient(
            self, out_wrt: int, in_wrt: int, parameters: Sequence[Sequence[float]], sens: Sequence[float], config: Mapping[str, Any] = {}
        ) -> list[float]:
            if not self._exact:
                raise Error("the derivatives of this model are not exact", "no-gradient", None, "see wearshape.umbridge")
            found = summary(parameters[0])
            known = {row["given"]: row for row in found.get("pressure", {}).get("sensitivity", [])}

            def slope(output: str, key: str, value: float) -> float:
                share = known.get(key, {}).get(_EXACT[output])
                return math.nan if share is None else float(share * _number(found, output) / value)

            pairs = list(zip(outputs, sens, strict=True))
            return [sum(s * slope(output, key, value) for output, s in pairs) for key, value in zip(inputs, parameters[0], strict=True)]

    return SceneModel()


def _number(summary: Mapping[str, Any], key: str) -> float:
    value: Any = summary
    for part in key.split("."):
        value = value.get(part) if isinstance(value, dict) else None
    return math.nan if value is None else float(value)
