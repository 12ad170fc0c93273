"""Pictures as SVG, and on axes of matplotlib."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._native import Solution, _Panel, _Series


class Picture(str):
    """The text of an SVG, which notebooks show as a picture."""

    #: Above the picture.
    heading: str
    _panels: list[_Panel]

    @classmethod
    def _of(cls, parts: tuple[str, str, list[_Panel]]) -> Picture:
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


class Plots:
    """The pictures of a stage, each a method; one that has nothing to draw is a ValueError that says so."""

    def __init__(self, native: Solution, stage: int) -> None:
        self._native = native
        self._stage = stage

    def _picture(self, file: str) -> Picture:
        parts = self._native.picture(self._stage, f"{file}.png")
        if parts is None:
            raise ValueError(f"this stage has nothing for the picture {file}")
        return Picture._of(parts)

    def part(self) -> Picture:
        """The part coloured by thinning, and its thinnest place."""
        return self._picture("part")

    def shapes(self) -> Picture:
        """The section over the travel, coloured by thinning, and the tools where they were then."""
        return self._picture("shapes")

    def load_travel(self) -> Picture:
        """Forces [N, or N/mm of depth] over the punch travel [mm]."""
        return self._picture("load_travel")

    def thickness(self) -> Picture:
        """Thickness [mm] over the blank at every kept frame, and over the part."""
        return self._picture("thickness")

    def strains(self) -> Picture:
        """Strains [–] over the blank at the last frame."""
        return self._picture("strains")

    def forming_limit(self) -> Picture:
        """How near every place comes to the forming limit."""
        return self._picture("forming_limit")

    def springback(self) -> Picture:
        """The section before and after release."""
        return self._picture("springback")

    def residual_stress(self) -> Picture:
        """Residual stress [MPa] through the thickness."""
        return self._picture("residual_stress")

    def pressure_cycle(self) -> Picture:
        """Gas pressure [MPa], strain rate [1/s] and height of the dome [mm] over time [s], where a rate is held."""
        return self._picture("pressure_cycle")

    def temperature(self) -> Picture:
        """Temperature [°C] over the blank, where it is given."""
        return self._picture("temperature")

    def porosity(self) -> Picture:
        """Porosity [–] over the blank, of a sheet with voids."""
        return self._picture("porosity")
