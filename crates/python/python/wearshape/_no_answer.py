"""Points that a model of UM-Bridge cannot answer, in the protocol's own words. Imported where `umbridge` is there alone, for it needs aiohttp."""

from __future__ import annotations

import json

from aiohttp import web

from wearshape._error import Error


class NoAnswer(Error, web.HTTPException):
    """A point without an answer: an :class:`Error` in this process, and for a client of the server an error answer with the same words.

    The server of `umbridge` catches nothing that a model raises. aiohttp, which it stands on, sends an exception of its own kind as the answer.
    """

    def __init__(
        self, message: str, code: str, key: str | None = None, remedy: str = "", place: tuple[str, int | None, int | None, str] | None = None
    ) -> None:
        # Numbers that were given are the client's, what is missing of the summary is the model's.
        kind, self.status_code = ("InvalidOutput", 500) if code in ("no-answer", "no-output", "no-gradient") else ("InvalidInput", 400)
        words = str(Error(message, code, key, remedy, place))
        answer = json.dumps({"error": {"type": kind, "message": words}})
        web.HTTPException.__init__(self, text=answer, content_type="application/json")
        Error.__init__(self, message, code, key, remedy, place)
