"""Progress on the screen."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeAlias

#: No progress, a bar, or a function of the share that is done and words, which ends the run by returning ``False``.
Progress: TypeAlias = bool | Callable[[float, str], Any]


@contextmanager
def watched(progress: Progress, name: str) -> Iterator[Callable[[float, str], Any] | None]:
    """What is told of the progress of a run."""
    if callable(progress):
        yield progress
    elif not progress:
        yield None
    else:
        bar = _bar(name)
        if bar is None:
            yield _line
            sys.stderr.write("\r\x1b[K")
            return
        with bar:

            def tell(share: float, words: str) -> None:
                bar.set_postfix_str(words, refresh=False)
                bar.update(max(0.0, 100 * share - bar.n))

            yield tell
            bar.set_postfix_str("", refresh=False)
            bar.update(100 - bar.n)


def _bar(name: str) -> Any:
    """A bar of tqdm: a widget in a notebook that has widgets; None without tqdm."""
    try:
        import warnings

        import tqdm
        from tqdm import auto

        with warnings.catch_warnings():
            warnings.simplefilter("ignore", tqdm.TqdmWarning)
            form = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}{postfix}"
            return auto.tqdm(total=100, desc=name, bar_format=form)
    except ImportError:
        return None


def _line(share: float, words: str) -> None:
    sys.stderr.write(f"\r\x1b[K{share:4.0%} {words}")
    sys.stderr.flush()
