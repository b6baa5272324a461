"""What is wrong with the input, where it stands, and what to do about it."""

from __future__ import annotations

from typing import NamedTuple


class Place(NamedTuple):
    """Where the wrong input was written."""

    #: Name of the scene file, or ``"set()"`` for a change.
    file: str
    #: Line from 1; None for a change.
    line: int | None
    #: Column from 1; None for a change.
    column: int | None
    #: The line, or the change as ``key=value``.
    text: str

    def __str__(self) -> str:
        return f"{self.file}: {self.text}" if self.line is None else f"{self.file}:{self.line}:{self.column}: {self.text.strip()}"


class Error(ValueError):
    """A scene or an argument that the user has to mend."""

    def __init__(
        self, message: str, code: str, key: str | None = None, remedy: str = "", place: tuple[str, int | None, int | None, str] | None = None
    ) -> None:
        super().__init__(message, code, key, remedy, place)
        #: What is wrong, with the numbers in it.
        self.message = message
        #: Kind of error in one hyphenated word, for programs.
        self.code = code
        #: Dotted key of the scene that is to blame, if one is.
        self.key = key
        #: What to write instead.
        self.remedy = remedy
        #: Where it stands.
        self.place = None if place is None else Place(*place)

    def __str__(self) -> str:
        lines = [self.message]
        if self.place is not None:
            lines.append(f"  at {self.place}")
        if self.remedy:
            lines.append(f"  remedy: {self.remedy}")
        return "\n".join(lines)
