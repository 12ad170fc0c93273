"""Pictures by their names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .picture import Picture

if TYPE_CHECKING:
    from ._native import _Picture


class Plots:
    """The pictures of a thing, each a method; one that has nothing to draw is a ValueError that says so."""

    def __init__(self, find: Callable[[str], _Picture | None], whose: str) -> None:
        self._find = find
        self._whose = whose

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self._names())}>"

    def _names(self) -> list[str]:
        return [name for name in dir(type(self)) if not name.startswith("_")]

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(f"there is no picture {name}; there are {', '.join(self._names())}")

    def _picture(self, name: str) -> Picture:
        parts = self._find(name)
        if parts is None:
            raise ValueError(f"{self._whose} has nothing for the picture {name}")
        return Picture._of(parts)

    def _first(self, *names: str) -> Picture | None:
        """The first of some that there is."""
        found = (self._find(name) for name in names)
        return next((Picture._of(parts) for parts in found if parts is not None), None)
