"""Pictures as SVG, and on axes of matplotlib."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._native import _Panel, _Picture


class Picture(str):
    """The text of an SVG, which notebooks show as a picture."""

    #: Above the picture.
    heading: str
    #: Small print below it: assumptions and sources.
    notes: list[str]
    _legend: str
    _panels: list[_Panel]

    @classmethod
    def _of(cls, parts: _Picture) -> Picture:
        picture = cls(parts[0])
        _, picture.heading, picture._legend, picture._panels, picture.notes = parts
        return picture

    def _repr_svg_(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"<Picture: {self.heading}>"

    @property
    def panels(self) -> int:
        """How many pairs of axes it has, which :meth:`axes` counts from the uppermost."""
        return len(self._panels)

    def save(self, path: str | Path) -> None:
        """Writes the SVG to a file."""
        Path(path).write_text(self, encoding="utf-8")

    def axes(self, ax: Any = None, panel: int = 0) -> Any:
        """Draws one of its pairs of axes, the uppermost unless said otherwise, with matplotlib: on ``ax``, or on new axes.

        Returns the ``matplotlib.axes.Axes``. Axes on which something stands already keep their limits and their title, so that
        pictures can be drawn over each other. Where matplotlib is not installed that is an ImportError.
        """
        from . import _matplotlib

        return _matplotlib.axes(self._panels[panel], self.heading, self._legend, ax)

    def figure(self) -> Any:
        """Draws all of it with matplotlib, its pairs of axes as they stand in the SVG: a new ``matplotlib.figure.Figure``.

        Where matplotlib is not installed that is an ImportError.
        """
        from . import _matplotlib

        return _matplotlib.figure(self._panels, self.heading, self._legend, self.notes)
