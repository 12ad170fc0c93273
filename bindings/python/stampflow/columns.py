"""Named columns of numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Columns(Mapping[str, "NDArray[np.float64]"]):
    """Read-only arrays by name; the name ends with the unit: ``table["punch_force_N"]``."""

    def __init__(self, columns: Sequence[tuple[str, str, str, NDArray[np.float64]]]) -> None:
        for _, _, _, values in columns:
            values.flags.writeable = False
        self._columns = {header: values for header, _, _, values in columns}
        #: Axis label of each column: ``{"punch_force_N": "Punch force"}``.
        self.labels = {header: label for header, label, _, _ in columns}
        #: Printed unit of each column: ``{"punch_force_N": "N"}``.
        self.units = {header: unit for header, _, unit, _ in columns}

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        if name not in self._columns:
            near = [known for known in self._columns if name in known] or get_close_matches(name, self._columns)
            meant = f"; did you mean {', '.join(near)}?" if near else ""
            raise KeyError(f"there is no column {name}{meant}; there are {', '.join(self._columns)}")
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        rows = max((len(values) for values in self._columns.values()), default=0)
        return f"<Columns: {rows} rows of {', '.join(self._columns)}>"

    def to_pandas(self) -> Any:
        """``pandas.DataFrame`` with one row per value."""
        import pandas

        return pandas.DataFrame(self._columns)
