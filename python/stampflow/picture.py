"""Pictures as SVG, and on axes of matplotlib."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._native import _Panel, _Picture, _Series


class Picture(str):
    """The text of an SVG, which notebooks show as a picture."""

    #: Above the picture.
    heading: str
    _panels: list[_Panel]

    @classmethod
    def _of(cls, parts: _Picture) -> Picture:
        picture = cls(parts[0])
        _, picture.heading, picture._panels = parts
        return picture

    def _repr_svg_(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"<Picture: {self.heading}>"

    def save(self, path: str | Path) -> None:
        """Writes the SVG to a file."""
        Path(path).write_text(self, encoding="utf-8")

    def axes(self, ax: Any = None, panel: int = 0) -> Any:
        """Draws one of its pairs of axes, the uppermost unless said otherwise, with matplotlib: on ``ax``, or on new axes.

        Returns the ``matplotlib.axes.Axes``. Where matplotlib is not installed that is an ImportError.
        """
        if ax is None:
            import matplotlib.pyplot

            _, ax = matplotlib.pyplot.subplots()
        x, y, series, window, is_section = self._panels[panel]
        for one in series:
            _draw(ax, one)
        ax.set(xlabel=x, ylabel=y, title=self.heading)
        if ax.get_legend_handles_labels()[1]:
            ax.legend()
        if window:
            ax.set(xlim=window[0], ylim=window[1])
        if is_section:
            # As it stands in the press.
            ax.set_aspect("equal")
            ax.yaxis.set_inverted(True)
        return ax


_MARKERS = {"circles": "o", "dots": ".", "triangles": "^"}


def _draw(ax: Any, series: _Series) -> None:
    label, x, y, look, color = series
    if look == "line":
        ax.plot(x, y, color=color, label=label)
    elif look in _MARKERS:
        ax.plot(x, y, _MARKERS[look], color=color, markerfacecolor="none" if look == "circles" else color, label=label)
    elif look == "area" and len(x):
        ax.fill(x, y, color=color, label=label)
    elif look == "flag":
        for at, height in zip(x, y, strict=True):
            ax.plot(at, height, "k.", markersize=4)
            ax.annotate(label, (at, height), fontsize="x-small", xytext=(0, 4), textcoords="offset points")
    elif look == "callout":
        ax.annotate(label, (x[0], y[0]), (x[1], y[1]), arrowprops={"arrowstyle": "-"}, ha="center", va="center")
    elif look == "text" and len(x):
        ax.text(x[0], y[0], label)
