"""Pictures by their names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .picture import Picture

if TYPE_CHECKING:
    from ._native import _Picture


class Plots:
    """The pictures of a thing, each a method; one that has nothing to draw is a ValueError that says so."""

    def __init__(self, find: Callable[[str], _Picture | None], whose: str) -> None:
        self._find = find
        self._whose = whose

    def _picture(self, name: str) -> Picture:
        parts = self._find(name)
        if parts is None:
            raise ValueError(f"{self._whose} has nothing for the picture {name}")
        return Picture._of(parts)

    def _first(self, *names: str) -> Picture | None:
        """The first of some that there is."""
        found = (self._find(name) for name in names)
        return next((Picture._of(parts) for parts in found if parts is not None), None)
