"""Results by name: columns of numbers, and anything else that is looked up."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_Item = TypeVar("_Item", covariant=True)


class Named(Mapping[str, _Item]):
    """Items by name, in their order, which nobody changes; a wrong name proposes the nearest."""

    def __init__(self, kind: str, items: Mapping[str, _Item]) -> None:
        self._kind = kind
        self._items = dict(items)

    def __getitem__(self, name: str) -> _Item:
        if name not in self._items:
            near = [known for known in self if str(name) in known] or get_close_matches(str(name), self)
            meant = f"; did you mean {', '.join(near)}?" if near else ""
            raise KeyError(f"there is no {self._kind} {name}{meant}; there are {', '.join(self)}")
        return self._items[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self)}>"


class Columns(Named["NDArray[np.float64]"]):
    """Read-only arrays by name; the name ends with the unit: ``table["punch_force_N"]``."""

    def __init__(self, columns: Sequence[tuple[str, str, str, NDArray[np.float64]]]) -> None:
        super().__init__("column", {header: read_only(values) for header, _, _, values in columns})
        self._columns = columns
        #: Axis label of each column: ``{"punch_force_N": "Punch force"}``.
        self.labels = {header: label for header, label, _, _ in columns}
        #: Printed unit of each column: ``{"punch_force_N": "N"}``.
        self.units = {header: unit for header, _, unit, _ in columns}

    def __reduce__(self) -> tuple[object, ...]:
        return Columns, (self._columns,)

    def to_pandas(self) -> Any:
        """``pandas.DataFrame`` with one row per value."""
        import pandas

        return pandas.DataFrame(self._items)


def read_only(values: NDArray[Any]) -> NDArray[Any]:
    """View into which nobody writes."""
    values.flags.writeable = False
    return values.view()
