"""What stands in a summary under a dotted key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any


def item(summary: Mapping[str, Any], key: str) -> Any:
    """The item of a dotted key, whose numbers count the items of a list from 0, as in ``contact.ends_mm.1``; None where there is none."""
    found: Any = summary
    for part in key.split("."):
        if isinstance(found, Mapping):
            found = found.get(part)
        elif isinstance(found, list) and part.isdecimal() and int(part) < len(found):
            found = found[int(part)]
        else:
            return None
    return found


def number(summary: Mapping[str, Any], key: str) -> float | None:
    """The number of a dotted key; None where there is none."""
    found = item(summary, key)
    return float(found) if isinstance(found, (int, float)) and not isinstance(found, bool) else None


def numbers(summary: Any, prefix: str = "") -> Iterator[str]:
    """Dotted keys of all numbers."""
    pairs = summary.items() if isinstance(summary, Mapping) else enumerate(summary) if isinstance(summary, list) else ()
    for key, value in pairs:
        name = f"{prefix}.{key}" if prefix else str(key)
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            yield name
        yield from numbers(value, name)
