"""A scene as a model of UM-Bridge, the protocol of uncertainty quantification."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from wearshape import _arguments as arguments
from wearshape import _core
from wearshape import _keys as keys
from wearshape._error import Error
from wearshape._extras import extra
from wearshape._result import Result
from wearshape._scene import Scene

if TYPE_CHECKING:
    from umbridge import Model

#: Outputs whose derivatives by the given numbers come with the summary, and their name there.
_EXACT = {
    "pressure.wear_depth_um_per_h": "wear_rate_percent",
    "pressure.torque_Nmm": "torque_percent",
    "pressure.p_max_MPa": "p_max_percent",
}
#: What a run with an answer says.
_ANSWERED = ("ok", "accuracy-missed")
#: A number by which the keys of inputs are tried: whether it is in their range is not asked.
_ANY = 1.0


def umbridge(scene: Scene, inputs: Sequence[str], outputs: Sequence[str], *, name: str = "wearshape") -> Model:
    """A scene as a model for ``umbridge.serve_models([model], port)``; the package ``umbridge`` has to be installed.

    :param inputs: keys of the scene, the components of the one input vector, in the units of the scene.
    :param outputs: dotted keys of the summary, the components of the one output vector. The summary of the scene itself must have them.

    ``Evaluate`` runs the scene; points that differ in load, friction, sliding, wear or optimum share factorised bodies. ``Gradient`` is there
    where all derivatives come with the pressure (``summary["pressure"]["sensitivity"]``): outputs
    ``pressure.wear_depth_um_per_h``, ``pressure.torque_Nmm`` and ``pressure.p_max_MPa`` of a scene with the task ``pressure`` alone, by
    its given numbers.

    A point that is out of the range of a key, that has no answer or not all outputs, and a derivative that the pressure has not, as by a number
    that is 0, raise :class:`Error` with the reason. A client of the server gets it as the protocol's error answer: ``InvalidInput`` for what
    was given, ``InvalidOutput`` for what did not come of it.

    Raises :class:`Error` for inputs that are no keys of a scene, and for outputs that are no numbers of its summary.
    """
    with extra("umbridge", "wearshape.umbridge"):
        import umbridge as protocol

    arguments.instance("scene", scene, Scene, "a wearshape.Scene")
    inputs, outputs = _named("inputs", inputs), _named("outputs", outputs)
    _refuse_unknown_inputs(scene, inputs)
    points = _Points(scene, inputs, outputs)

    class SceneModel(protocol.Model):  # type: ignore[misc]
        """One scene."""

        def __init__(self) -> None:
            super().__init__(name)
            self._exact = points.exact()

        def get_input_sizes(self, config: Mapping[str, Any] = {}) -> list[int]:
            return [len(inputs)]

        def get_output_sizes(self, config: Mapping[str, Any] = {}) -> list[int]:
            return [len(outputs)]

        def supports_evaluate(self) -> bool:
            return True

        def supports_gradient(self) -> bool:
            return self._exact

        def __call__(self, parameters: Sequence[Sequence[float]], config: Mapping[str, Any] = {}) -> list[list[float]]:
            return [points.outputs_of(points.run(parameters[0]))]

        def gradient(
            self, out_wrt: int, in_wrt: int, parameters: Sequence[Sequence[float]], sens: Sequence[float], config: Mapping[str, Any] = {}
        ) -> list[float]:
            if not self._exact:
                raise Error("the derivatives of this model are not exact", "no-gradient", None, "see wearshape.umbridge")
            return points.gradient(parameters[0], sens)

    return SceneModel()


class _Points:
    """Runs of a scene at values of its inputs, and what a model answers of them."""

    def __init__(self, scene: Scene, inputs: list[str], outputs: list[str]) -> None:
        self._scene, self._inputs, self._outputs = scene, inputs, outputs
        self._bodies = _core.Bodies()

    def exact(self) -> bool:
        """Whether all derivatives come with the pressure. Refuses outputs that the summary of the scene itself has not."""
        result = self._scene.run(bodies=self._bodies)
        if result.status in _ANSWERED:
            for output in self._outputs:
                _refuse_unknown_output(result.summary, output)
        known = _sensitivities(result)
        return all(output in _EXACT and all(_EXACT[output] in known.get(key, {}) for key in self._inputs) for output in self._outputs)

    def run(self, values: Sequence[float]) -> Result:
        """The scene at a point, which has an answer."""
        from wearshape._no_answer import NoAnswer

        if len(values) != len(self._inputs):
            raise NoAnswer(f"{len(values)} numbers are given", "wrong-argument", None, f"give {len(self._inputs)}: {', '.join(self._inputs)}")
        try:
            numbers = {key: arguments.finite(key, value) for key, value in zip(self._inputs, values, strict=True)}
            result = self._scene.set(numbers).run(bodies=self._bodies)
        except Error as error:
            raise NoAnswer(*error.args) from error
        except TypeError as error:
            raise NoAnswer(str(error), "wrong-argument", None, "give numbers") from error
        if result.status not in _ANSWERED:
            raise NoAnswer(f"the point has no answer: {result.verdict}", "no-answer", None, "leave such points out of the distribution of the inputs")
        return result

    def outputs_of(self, result: Result) -> list[float]:
        """The numbers of the outputs."""
        return [_output(result, output) for output in self._outputs]

    def gradient(self, values: Sequence[float], sens: Sequence[float]) -> list[float]:
        """Derivatives by the inputs of the sum of the outputs, each by its factor."""
        result = self.run(values)
        known = _sensitivities(result)
        wanted = [(output, factor * _output(result, output)) for output, factor in zip(self._outputs, sens, strict=True) if factor != 0]
        pairs = list(zip(self._inputs, values, strict=True))
        return [sum(number * _share(known, output, key, value) / value for output, number in wanted) for key, value in pairs]


def _output(result: Result, output: str) -> float:
    """The number of an output at a point."""
    from wearshape._no_answer import NoAnswer

    number = keys.number(result.summary, output)
    if number is None:
        message = f"the summary of the point has no {output}: {result.verdict}"
        raise NoAnswer(message, "no-output", output, "leave the output out, or such points")
    return number


def _share(known: Mapping[str, Any], output: str, key: str, value: float) -> float:
    """Change of an output in percent by a percent of a number."""
    from wearshape._no_answer import NoAnswer

    share = known.get(key, {}).get(_EXACT[output])
    if share is None or value == 0:
        remedy = "derivatives come as percent by percent: keep the number away from 0"
        raise NoAnswer(f"there is no derivative of {output} by {key} = {value}", "no-gradient", key, remedy)
    return float(share)


def _sensitivities(result: Result) -> dict[str, Any]:
    """Changes in percent by a percent of each given number."""
    return {row["given"]: row for row in result.summary.get("pressure", {}).get("sensitivity", [])}


def _named(argument: str, names: Any) -> list[str]:
    """Keys in a list."""
    names = names.tolist() if hasattr(names, "tolist") else names  # numpy's arrays
    arguments.instance(argument, names, (list, tuple), "a list of dotted keys")
    for place, each in enumerate(names):
        arguments.instance(f"{argument}[{place}]", each, str, "a dotted key")
    if not names:
        raise Error(f"there are no {argument}", "wrong-argument", argument, "give one dotted key at least")
    return list(names)


def _refuse_unknown_inputs(scene: Scene, inputs: list[str]) -> None:
    """Raises for what no scene has; whether a value is in the range of its key is for each point."""
    for key in inputs:
        try:
            scene.set({key: _ANY})
        except Error as error:
            if error.code in ("unknown-key", "wrong-type", "wrong-flag"):
                raise


def _refuse_unknown_output(summary: Mapping[str, Any], output: str) -> None:
    if keys.number(summary, output) is not None:
        return
    if keys.item(summary, output) is not None:
        raise Error(f"{output} of the summary is no number", "no-output", output, "see `scene.run().summary`")
    near = difflib.get_close_matches(output, list(keys.numbers(summary)), 3)
    remedy = f"did you mean {' or '.join(near)}?" if near else "see `scene.run().summary`"
    raise Error(f"the summary of the scene has no {output}", "no-output", output, remedy)
