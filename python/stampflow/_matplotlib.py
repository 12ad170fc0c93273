"""What a picture shows, drawn with matplotlib as it is drawn in its SVG."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._native import _Axis, _Panel, _Series

#: Points of a page over px of an SVG that is 800 wide, in a figure of this width [inch].
_WIDTH = 8.0
_POINT = 72 * _WIDTH / 800
#: Size of the small print and of what stands inside axes [pt].
_NOTE, _MARK = 8, 9
#: Characters of the small print on a line of the figure, and of its title.
_CHARACTERS, _TITLE = 130, 80
#: Height of a section [px], least and most, and of a small one; and how many panels stand side by side.
_SECTIONS = {"section": (290.0, 560.0), "small": (110.0, 320.0)}
_BESIDE = {"small": 3, "multiple": 2}
#: What the axes of a panel need besides [px]: values and label below, and a caption.
_BELOW, _CAPTION = 60.0, 26.0
_GREY = "#787878"
#: What a legend says.
_EXPLAINED = ("line", "circles", "dots", "triangles", "area", "hatched")
_MARKERS = {"circles": "o", "dots": ".", "triangles": "^"}


def axes(panel: _Panel, title: str, legend: str, ax: Any = None) -> Any:
    """A panel on axes, new ones where there are none."""
    if ax is None:
        import matplotlib.pyplot

        _, ax = matplotlib.pyplot.subplots()
    is_bare = not ax.has_data()
    _draw(panel, ax, is_bare)
    if is_bare:
        ax.set_title(_caption(panel) or title, wrap=True)
    if ax.get_legend_handles_labels()[0]:
        ax.legend(title=legend or None, fontsize="small")
    return ax


def figure(panels: Sequence[_Panel], title: str, legend: str, notes: Sequence[str]) -> Any:
    """All panels as they stand in the SVG."""
    import matplotlib.pyplot  # with which notebooks show figures
    from matplotlib.figure import Figure

    rows = _rows(panels)
    heights = [max(_height(panels[i]) for i in row) for row in rows]
    columns = 6  # 1, 2 and 3 panels fit into a row
    labels = sum(bool(one[0]) and one[3][0] in _EXPLAINED for panel in panels for one in panel[1])
    small = [line for note in notes for line in textwrap.wrap(note, _CHARACTERS)]
    heading = "\n".join(textwrap.wrap(title, _TITLE))
    height = sum(heights) / 100 + 0.6 + 0.25 * -(-labels // 3) + 0.15 * len(small)
    # None of pyplot's, which keeps every one that is not closed.
    made = Figure(figsize=(_WIDTH, height), layout="constrained")
    grid = made.add_gridspec(len(rows), columns, height_ratios=heights)
    for i, row in enumerate(rows):
        width = columns // max(len(row), _BESIDE.get(_scale(panels[row[0]]), 1))
        for j, of in enumerate(row):
            ax = made.add_subplot(grid[i, j * width : (j + 1) * width])
            _draw(panels[of], ax, True)
            ax.set_title(_caption(panels[of]), fontsize="medium", loc="left")
    made.suptitle(heading, fontsize="large")
    if labels:
        handles = [handle for ax in made.axes for handle in ax.get_legend_handles_labels()[0]]
        made.legend(handles=handles, title=legend or None, loc="outside upper left", ncols=3, fontsize="small", frameon=False)
    if small:
        made.supxlabel("\n".join(small), fontsize=_NOTE, color=_GREY, x=0.01, ha="left")
    return made


def _scale(panel: _Panel) -> str:
    return panel[3][0]


def _caption(panel: _Panel) -> str:
    """What stands above a panel that stands beside others."""
    named = (label for label, x, _, look in panel[1] if look[0] == "text" and not len(x))
    return next(named, None) or ""


def _rows(panels: Sequence[_Panel]) -> list[list[int]]:
    """Which panels stand side by side."""
    rows: list[list[int]] = []
    for i, panel in enumerate(panels):
        most = _BESIDE.get(_scale(panel), 1)
        if rows and most > 1 and len(rows[-1]) < most and _scale(panels[rows[-1][0]]) == _scale(panel):
            rows[-1].append(i)
        else:
            rows.append([i])
    return rows


def _height(panel: _Panel) -> float:
    """Of a row with it [px]."""
    _, _, (x, y), (scale, height) = panel
    if scale in _SECTIONS:
        least, most = _SECTIONS[scale]
        wide = 700.0 / _BESIDE.get(scale, 1)
        return min(max(wide * (y[1] - y[0]) / (x[1] - x[0]), least), most) + (_CAPTION if scale == "small" else _BELOW)
    return (height or 18.0) + _BELOW + (_CAPTION if scale == "multiple" else 0.0)


def _draw(panel: _Panel, ax: Any, is_bare: bool) -> None:
    (along, up), series, (x, y), (scale, _) = panel
    for i, one in enumerate(series):
        # In the order of the series, whatever matplotlib puts before what.
        _put(ax, one, 2 + i / len(series))
    _set(ax.xaxis, along, x, is_bare)
    _set(ax.yaxis, up, y, is_bare)
    if is_bare:
        ax.set(xlim=x, ylim=y)
    if scale in _SECTIONS:
        # As it stands in the press.
        ax.set_aspect("equal")
        ax.yaxis.set_inverted(True)
    if scale == "small":
        ax.set_axis_off()
    if scale == "bar":
        ax.set_yticks([])
        ax.set_ylabel("")
    if scale == "fit":
        ax.grid(True, color="#D7D7D7", linewidth=0.6, zorder=0)


def _set(axis: Any, parts: _Axis, ends: tuple[float, float], is_bare: bool) -> None:
    """The label, and where values are written: at names, or at round values in even ratios."""
    label, is_log, names = parts
    axis.set_label_text(label)
    if names:
        axis.set_ticks(range(len(names)), names)
    elif is_log and is_bare:
        from matplotlib import ticker

        axis.axes.set(**{f"{axis.axis_name}scale": "log"})
        fine = [digit * 10.0**power for power in range(-12, 13) for digit in (1, 2, 5)]
        few = sum(ends[0] <= value <= ends[1] for value in fine) < 2
        axis.set_major_locator(ticker.MaxNLocator(6) if few else ticker.LogLocator(subs=(1, 2, 5), numticks=12))
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(ticker.NullFormatter())


def _put(ax: Any, series: _Series, order: float) -> None:
    label, x, y, look = series
    kind, color, edge, width, dash, rise = look
    if kind == "line":
        ax.plot(x, y, color=color, linewidth=_POINT * width, linestyle=_dashes(width, dash), label=label, zorder=order)
    elif kind in _MARKERS:
        fill = "none" if kind == "circles" else color
        ax.plot(x, y, _MARKERS[kind], color=color, markerfacecolor=fill, label=label, zorder=order)
    elif kind in ("area", "hatched"):
        ax.fill(x, y, label=label, zorder=order, **_area(color, edge, kind, rise))
    elif kind == "flag":
        for at, height in zip(x, y, strict=True):
            ax.axvline(at, color=_GREY, linewidth=0.7, zorder=order)
            ax.plot(at, height, "k.", zorder=order)
            # Inside, each below the one before.
            above = sum(1 for text in ax.texts if text.get_gid() == "flag")
            ax.annotate(
                label,
                (at, 1),
                (3, -4 - 11 * above),
                xycoords=ax.get_xaxis_transform(),
                textcoords="offset points",
                fontsize=_MARK,
                va="top",
                gid="flag",
                zorder=4,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
            )
    elif kind == "callout" and len(x):
        arrow = {"arrowstyle": "-", "shrinkA": 0, "shrinkB": 0}
        ax.annotate(
            label, (x[0], y[0]), (x[1], y[1]), arrowprops=arrow, ha="center", va="center", fontweight="bold", zorder=4,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5},
        )  # fmt: skip
        ax.plot(x[0], y[0], "ko", zorder=4)
    else:
        side = {"text": "left", "before": "right"}.get(kind, "center")
        for at, height in zip(x, y, strict=True):
            box = {"facecolor": "white", "edgecolor": "none", "pad": 0.5}
            ax.text(at, height, label, ha=side, va="center", fontsize=_MARK, bbox=box, zorder=4, clip_on=True)


def _dashes(width: float, dash: Sequence[float]) -> Any:
    """In widths of the line, as matplotlib has them."""
    return (0, [length / width for length in dash]) if dash else "-"


def _area(fill: str | None, edge: str | None, kind: str, rise: float) -> dict[str, Any]:
    if kind == "hatched":
        return {"facecolor": fill or "none", "edgecolor": edge, "hatch": "//" if rise > 0 else "\\\\", "linewidth": 0}
    # Areas of one colour side by side show no seam.
    return {"facecolor": fill, "edgecolor": edge or fill, "linewidth": 0.8 if edge else 0.3}

