"""Modules of others that parts of the package need: where one is missing, the error says which extra brings it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def extra(name: str, user: str) -> Iterator[None]:
    """Imports for ``user`` what the extra ``name`` brings."""
    try:
        yield
    except ModuleNotFoundError as error:
        remedy = f"install wearshape with its extra `{name}`, as in pip install './crates/python[{name}]', or {error.name} alone"
        raise ModuleNotFoundError(f"{user} needs {error.name}, which is not installed\n  remedy: {remedy}", name=error.name) from error
