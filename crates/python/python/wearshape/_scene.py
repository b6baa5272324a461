"""Scenes."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple

from wearshape import _arguments as arguments
from wearshape import _core
from wearshape._error import Error
from wearshape._progress import Progress, watched
from wearshape._result import Result
from wearshape._toml import document, toml

Bodies = _core.Bodies


class Lint(NamedTuple):
    """A remark: the scene is legal, and something about it is worth knowing."""

    #: Hyphenated word, a section of docs/lints.md.
    code: str
    #: One or two sentences.
    message: str


class Stage(NamedTuple):
    """A part of the work."""

    #: What is done.
    name: str
    #: Whether it is done.
    runs: bool
    #: Why, or why not.
    because: str


class Check(NamedTuple):
    """What is to be said of a scene before it is computed."""

    #: What is computed, and why.
    stages: list[Stage]
    #: What the theory has to say.
    lints: list[Lint]
    #: Keys that were written and are not used.
    unused_keys: list[str]


class Level(NamedTuple):
    """One level of discretisation before it is computed."""

    #: Degree of the cells.
    degree: int
    #: Layers around singular points.
    layers: int
    #: Cells of both bodies.
    cells: int
    #: Unknowns of both bodies.
    dofs: int
    #: Unknowns of both contact traces.
    trace_dofs: int
    #: Points of the contact surface.
    contact_points: int
    #: Memory of both eliminations; with frictional heat that of the temperatures and of the responses to the heat of each contact point too (bytes).
    memory_bytes: int
    #: Seconds until this level is done, about.
    about_seconds: float


def _setting(key: str, value: Any) -> str:
    """A setting of the command; what a scene cannot hold is refused by its key."""
    try:
        return f"{key}={toml(value)}"
    except TypeError as error:
        raise TypeError(f"{key}: {error}") from None


class Scene:
    """A scene: two bodies, how they touch, slide and wear, and what is wanted of them.

    ``source`` is the name of a built-in scene (see :func:`scenes`), the path of a TOML file, a text in TOML (with a line break or a ``=``
    in it), or a mapping. A scene never changes; :meth:`set` returns another one. Units are N, mm, MPa, s and rad, or as written: ``"10 kN"``.

    Mesh and profile files that a scene names lie beside it; for a text or a mapping in ``folder`` (the current one). Each is read once.

    Raises :class:`Error` for what cannot be read, with its place and a remedy.
    """

    __slots__ = ("_beside", "_document", "_file", "_folder", "_problem", "_settings", "_text")

    def __init__(self, source: str | PathLike[str] | Mapping[str, Any], *, folder: str | PathLike[str] | None = None) -> None:
        arguments.instance("source", source, (str, PathLike, Mapping), "a name, a path, a text or a mapping")
        if folder is not None:
            arguments.instance("folder", folder, (str, PathLike), "a path")
        if isinstance(source, str) and not source.strip():
            raise Error("the scene is an empty text", "empty-scene", None, f"give the path of a TOML file, a text in TOML, or one of {', '.join(_core.scenes())}")
        found = None if folder is None else Path(folder)
        if isinstance(source, Mapping):
            self._made("scene.toml", document(source), (), (found or Path(), {}))
        elif isinstance(source, str) and ("\n" in source or "=" in source):
            self._made("scene.toml", source, (), (found or Path(), {}))
        else:
            file, text, where = _opened(fspath(source))
            self._made(file, text, (), (found or where, {}))

    def _made(self, file: str, text: str, settings: tuple[str, ...], beside: tuple[Path, dict[str, bytes]]) -> Scene:
        self._file, self._text, self._settings = file, text, settings
        self._folder, self._beside = beside
        self._document = _core.Document(file, text, list(settings))
        self._problem: _core.Problem | None = None
        return self

    def __reduce__(self) -> tuple[Callable[..., Scene], tuple[Any, ...]]:
        self._posed()  # reads the files beside it, which the receiver need not have
        return _again, (self._file, self._text, self._settings, (self._folder, self._beside))

    def _posed(self) -> _core.Problem:
        if self._problem is None:
            self._problem = self._document.pose(self._read)
        return self._problem

    def _read(self, path: str) -> bytes:
        if path not in self._beside:
            self._beside[path] = (self._folder / path).read_bytes()
        return self._beside[path]

    @property
    def name(self) -> str:
        """Short name of the scene."""
        return self._document.name

    @property
    def title(self) -> str:
        """Title of the scene, or its name."""
        return self._posed().title

    @property
    def resolved(self) -> str:
        """The scene with every default filled in, in base units, as TOML; running it gives the same result."""
        return self._posed().resolved()

    def set(self, changes: Mapping[str, Any] | None = None, /, **more: Any) -> Scene:
        """The scene with some keys changed, as by ``--set`` of the command.

        Keys are dotted paths: ``scene.set(**{"contact.friction": 0.1})``, ``scene.set({"load.force": "5 kN"}, accuracy=1e-4)``. Values are
        numbers (numpy's too), texts, lists or mappings. Alternatives replace each other: setting ``wear.k`` removes ``wear.beta``.
        """
        if changes is not None:
            arguments.instance("changes", changes, Mapping, "a mapping of keys to values")
        keys = {**(changes or {}), **more}
        settings = tuple(_setting(key, value) for key, value in keys.items())
        other = object.__new__(Scene)
        return other._made(self._file, self._text, self._settings + settings, (self._folder, self._beside))

    def check(self) -> Check:
        """Checks the scene without computing it: what will be done, what the theory has to say, which keys are unused.

        Raises :class:`Error` for what has to be mended.
        """
        problem = self._posed()
        problem.available()
        found = json.loads(problem.findings())
        stages = [Stage(stage["name"], stage["ran"], stage["because"]) for stage in found["stages"]]
        return Check(stages, [Lint(**lint) for lint in found["lints"]], found["unused_keys"])

    def forecast(self) -> list[Level]:
        """The levels that a run may climb to, with their sizes and about how long they take on this machine."""
        return [Level(**level) for level in json.loads(self._posed().forecast())]

    def run(
        self,
        *,
        progress: Progress = False,
        sample: int | None = None,
        threads: int | None = None,
        bodies: Bodies | None = None,
        resume: Result | None = None,
    ) -> Result:
        """Computes the scene.

        :param progress: ``True`` shows a bar (of tqdm if it is installed) in terminal and notebook; a function is called with the share that
            is done (0 to 1, about; 1 at the end alone) and words, and ends the run between two of its parts by returning ``False``: the result
            then says ``"interrupted"``.
        :param sample: so many points, 2 to 1000000, evenly spaced along the surface, instead of the contact points.
        :param threads: threads of the solver; by default as many as the machine has. The numbers do not depend on them.
        :param bodies: keeps what is factorised for other runs with the same bodies, materials and supports.
        :param resume: a result of this scene that was interrupted in a run in time; the end is that of an undisturbed run, bit for bit. One that
            is not :attr:`Result.resumable` is refused.

        Python's lock is released while it computes. Ctrl-C raises ``KeyboardInterrupt`` at once; the solver ends between two parts of its work.
        What has no answer is a result whose ``status`` says so, not an error.

        Raises :class:`Error` for what has to be mended in the scene.
        """
        arguments.sample(sample)
        if threads is not None:
            arguments.whole("threads", threads, 1, 1024, "threads")
        if bodies is not None:
            arguments.instance("bodies", bodies, Bodies, "a wearshape.Bodies")
        if resume is not None:
            arguments.instance("resume", resume, Result, "a wearshape.Result")
            if not resume.resumable:
                message = f"the result to go on with was not stopped in a run in time: its status is `{resume.status}`"
                raise Error(message, "not-resumable", "resume", "give a result whose `resumable` is true, or begin anew without one")
        problem = self._posed()
        with watched(progress, self.name) as told:
            run: _core.Run = {
                "progress": told,
                "sample": sample,
                "threads": threads,
                "bodies": bodies,
                "resume": None if resume is None else resume._solution,
            }
            result = Result(problem.solve(run))
            if told is not None and result.status != "interrupted":
                told(1.0, "done")
            return result

    def __repr__(self) -> str:
        changes = ", ".join(self._settings)
        return f"<wearshape.Scene {self.name}{': ' if changes else ''}{changes}>"

    def _repr_svg_(self) -> str:
        return self._posed().drawing()


def scenes() -> list[str]:
    """Names of the built-in scenes."""
    return _core.scenes()


def _again(file: str, text: str, settings: tuple[str, ...], beside: tuple[Path, dict[str, bytes]]) -> Scene:
    scene: Scene = object.__new__(Scene)
    return scene._made(file, text, settings, beside)


def _opened(path: str) -> tuple[str, str, Path]:
    """Name, text and folder of a built-in scene or a file."""
    builtin = None if Path(path).is_file() else _core.builtin(path)
    if builtin is not None:
        return *builtin, Path()
    try:
        return path, Path(path).read_text("utf-8"), Path(path).parent
    except (OSError, UnicodeDecodeError) as error:
        known = ", ".join(_core.scenes())
        message = f"`{path}` is neither a file that can be read nor a built-in scene: {error}"
        raise Error(message, "no-scene", None, f"give the path of a TOML file, or one of {known}") from error
