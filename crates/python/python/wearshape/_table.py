"""Tables: numpy's records, which pandas takes too."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from wearshape import _core
from wearshape._extras import extra

if TYPE_CHECKING:
    import pandas


class Table(np.ndarray[tuple[int], np.dtype[np.void]]):
    """Records with named fields, one row each: ``table["pressure_MPa"]`` is a column, ``table[0]`` a row. Units stand in the names."""

    def __getitem__(self, key: Any) -> Any:
        found = super().__getitem__(key)
        # A column is an array like any other.
        return np.asarray(found) if isinstance(found, Table) and found.dtype.names is None else found

    def to_pandas(self) -> pandas.DataFrame:
        """The same as a ``pandas.DataFrame``."""
        with extra("pandas", "to_pandas"):
            import pandas

        return pandas.DataFrame({name: np.asarray(self[name]) for name in self.dtype.names or ()})

    def _repr_html_(self) -> str:
        try:
            return str(self.to_pandas()._repr_html_())  # type: ignore[operator]
        except ImportError:
            return f"<pre>{self!r}</pre>"


def table(records: _core.Array) -> Table:
    """Records of Rust, not copied."""
    return np.asarray(records).view(Table)


def numbers(array: _core.Array) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Numbers of Rust, not copied."""
    return np.asarray(array)
