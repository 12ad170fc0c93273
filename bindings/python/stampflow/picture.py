"""Pictures: the program's SVG, and the chart value that it is drawn from."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any


class Picture(str):
    """SVG text, which notebooks show as a picture."""

    #: Title of the chart.
    caption: str
    #: Chart value: panels with axes, and series with their points. For those who draw themselves.
    chart: dict[str, Any]

    @classmethod
    def _of(cls, svg: str, chart: str) -> Picture:
        picture = cls(svg)
        picture.chart = json.loads(chart)
        picture.caption = picture.chart.get("title", "")
        return picture

    def _repr_svg_(self) -> str:
        return str(self)

    def __repr__(self) -> str:
        return f"<Picture: {self.caption}>"

    def save(self, path: str | Path) -> None:
        """Writes the SVG to a file."""
        Path(path).write_text(self, encoding="utf-8")


class Plots:
    """Pictures by name, each a method: ``plot.load_travel()``. ``dir(plot)`` lists them."""

    def __init__(self, names: Callable[[], list[str]], draw: Callable[[str], tuple[str, str] | None]) -> None:
        self._names = names
        self._draw = draw

    def __dir__(self) -> list[str]:
        return self._names()

    def __repr__(self) -> str:
        return f"<Plots: {', '.join(self._names())}>"

    def __getattr__(self, name: str) -> Callable[[], Picture]:
        if name.startswith("_") or name not in self._names():
            raise AttributeError(f"there is no picture {name}; there are {', '.join(self._names())}")
        drawn = self._draw(name)
        if drawn is None:
            raise ValueError(f"there is nothing to draw for the picture {name}")
        return lambda: Picture._of(*drawn)
