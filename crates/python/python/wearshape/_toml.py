"""Python's values as TOML."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from pathlib import PurePath
from typing import Any

from wearshape import _arguments as arguments


def toml(value: Any) -> str:
    """A value in TOML: numbers (numpy's too), texts, lists, tables."""
    if hasattr(value, "tolist"):  # numpy's arrays and numbers
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (str, PurePath)):
        return json.dumps(str(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, int):
        return _whole(value)
    if isinstance(value, float):
        return "nan" if math.isnan(value) else "inf" if value == math.inf else "-inf" if value == -math.inf else repr(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(key)} = {toml(item)}" for key, item in value.items()) + " }" if value else "{}"
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray, memoryview)):
        return "[" + ", ".join(map(toml, value)) + "]"
    raise TypeError(f"a scene holds numbers, texts, true and false, lists and tables, not {value!r}")


def _whole(value: int) -> str:
    if not -(2**63) <= value < 2**63:
        raise TypeError("a whole number of a scene has 64 bits at most; write a larger one as a float")
    return str(value)


def document(scene: Mapping[str, Any]) -> str:
    """A whole scene in TOML; its keys may be dotted."""
    return "".join(f"{_dotted(key)} = {toml(value)}\n" for key, value in scene.items())


def _key(key: str) -> str:
    arguments.instance("a key", key, str, "a text")
    bare = key.isascii() and key.replace("-", "").replace("_", "").isalnum()
    return key if bare else json.dumps(key, ensure_ascii=False)


def _dotted(key: str) -> str:
    arguments.instance("a key", key, str, "a text")
    return ".".join(map(_key, key.split(".")))
