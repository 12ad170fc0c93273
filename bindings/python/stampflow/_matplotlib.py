"""What a picture shows, drawn with matplotlib as it is drawn in its SVG."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._native import _Axis, _Panel, _Series

#: Width of a figure [inch], and points of a page over px of an SVG that is 800 wide.
_WIDTH = 8.0
_POINT = 72 * _WIDTH / 800
#: px of such an SVG to the inch.
_INCH = 800 / _WIDTH
#: Size of the small print and of what stands inside axes [pt]; of a title, a row of a legend and one of small print [inch].
_NOTE, _MARK = 8, 9
_TITLE, _ROW, _SMALL = 0.25, 0.22, 0.15
#: Characters on a line of the title and of the small print.
_WIDE, _WIDEST = 80, 125
#: Height of a section [px], least and most, and of a small one; and how many panels stand side by side.
_SECTIONS = {"section": (290.0, 560.0), "small": (110.0, 320.0)}
_BESIDE = {"small": 3, "multiple": 2}
#: What panels need besides [px]: values and label below, a caption above; and a label that stands above all curves.
_BELOW, _CAPTION, _FLAG = 60.0, 30.0, 20.0
#: Values at a scale of colours, about.
_COLORS = 8
_GREY = "#787878"
#: Behind letters.
_WHITE = {"facecolor": "white", "edgecolor": "none", "pad": 0.8}
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
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    rows = _rows(panels)
    inside = [max(_height(panels[i]) for i in row) for row in rows]
    besides = sum(_besides(panels[row[0]]) for row in rows)
    heading = textwrap.wrap(title, _WIDE)
    small = [line for note in notes for line in textwrap.wrap(note, _WIDEST)]
    labels = [one[0] for panel in panels for one in panel[1] if one[0] and one[3][0] in _EXPLAINED]
    # Samples and letters of the widest label.
    columns = min(max(int(_WIDTH / (0.55 + 0.065 * max(map(len, labels), default=1))), 1), max(len(labels), 1))
    above = _TITLE * (len(heading) + 0.3) + _ROW * (-(-len(labels) // columns) + bool(labels and legend))
    below = _SMALL * (len(small) + 0.5)
    height = (sum(inside) + besides) / _INCH + above + below
    # None of pyplot's, which keeps every one that is not closed.
    layout = ConstrainedLayoutEngine(rect=(0, below / height, 1, 1 - (above + below) / height))
    made = Figure(figsize=(_WIDTH, height), layout=layout)
    parts = 6  # 1, 2 and 3 panels fit into a row
    grid = made.add_gridspec(len(rows), parts, height_ratios=inside)
    for i, row in enumerate(rows):
        width = parts // _BESIDE.get(_scale(panels[row[0]]), 1)
        for j, of in enumerate(row):
            ax = made.add_subplot(grid[i, j * width : (j + 1) * width])
            _draw(panels[of], ax, True)
            ax.set_title(_caption(panels[of]), fontsize="medium", loc="left")
    head = made.suptitle("\n".join(heading), x=0.01, y=1 - 0.06 / height, ha="left", va="top", fontsize="large")
    head.set_in_layout(False)
    handles = [handle for ax in made.axes for handle in ax.get_legend_handles_labels()[0]]
    if handles:
        # Along its rows, as in the SVG.
        along = [handle for column in range(columns) for handle in handles[column::columns]]
        place = (0.0, 1 - _TITLE * (len(heading) + 0.2) / height)
        made.legend(
            handles=along, title=legend or None, ncols=columns, loc="upper left", bbox_to_anchor=place, fontsize="small",
            frameon=False, alignment="left",
        )  # fmt: skip
    made.text(0.01, 0.04 / height, "\n".join(small), fontsize=_NOTE, color=_GREY, ha="left", va="bottom")
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
    """Of its inside [px]."""
    _, _, (x, y), (scale, height) = panel
    if scale in _SECTIONS:
        least, most = _SECTIONS[scale]
        return min(max(700.0 / _BESIDE.get(scale, 1) * (y[1] - y[0]) / (x[1] - x[0]), least), most)
    return height or 18.0


def _besides(panel: _Panel) -> float:
    """What its row needs besides [px]."""
    scale = _scale(panel)
    return (0.0 if scale == "small" else _BELOW) + (_CAPTION if scale in _BESIDE else 0.0)


def _draw(panel: _Panel, ax: Any, is_bare: bool) -> None:
    (along, up), series, (x, y), (scale, _) = panel
    if is_bare:
        # Labels of single places stand above all curves.
        flags = sum(len(one[1]) for one in series if one[3][0] == "flag")
        y = (y[0], y[1] + (y[1] - y[0]) * _FLAG * flags / _height(panel))
    _set(ax.xaxis, along, x, is_bare)
    _set(ax.yaxis, up, y, is_bare)
    if is_bare:
        ax.set(xlim=x, ylim=y)
    for i, one in enumerate(series):
        # In the order of the series, whatever matplotlib puts before what.
        _put(ax, one, 2 + i / len(series))
    if is_bare:
        ax.set(xlim=x, ylim=y)
    if scale in _SECTIONS:
        # As it stands in the press.
        ax.set_aspect("equal")
        ax.yaxis.set_inverted(True)
    if scale == "small":
        ax.set(xticks=[], yticks=[], xlabel="", ylabel="")
    elif scale == "bar":
        ax.set(xticks=_spread(sorted({float(at) for one in series for at in one[1]})), yticks=[], ylabel="")
    else:
        ax.grid(True, color="#D7D7D7", linewidth=0.6)
        ax.set_axisbelow(True)


def _spread(borders: Sequence[float]) -> list[float]:
    """Of the borders of colours both ends, zero, and those between at even steps from it."""
    last = len(borders) - 1
    zero = borders.index(0.0) if 0.0 in borders else 0
    step = -(-len(borders) // _COLORS)

    def is_kept(i: int) -> bool:
        return i in (0, last, zero) or (not (i - zero) % step and i >= step and last - i >= step)

    return [border for i, border in enumerate(borders) if is_kept(i)]


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
        axis.set_minor_locator(ticker.NullLocator())


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
            # Inside, each below the one before, on the side where there is room.
            above = sum(1 for text in ax.texts if text.get_gid() == "flag")
            share = ax.transAxes.inverted().transform(ax.transData.transform((at, height)))[0]
            side, away = ("left", 3) if share < 0.6 else ("right", -3)
            ax.annotate(
                label, (at, 1), (away, -3 - _POINT * _FLAG * above), xycoords=ax.get_xaxis_transform(),
                textcoords="offset points", fontsize=_MARK, ha=side, va="top", gid="flag", zorder=4, bbox=_WHITE,
            )  # fmt: skip
    elif kind == "callout" and len(x):
        arrow = {"arrowstyle": "-", "shrinkA": 0, "shrinkB": 0}
        ax.annotate(
            label, (x[0], y[0]), (x[1], y[1]), arrowprops=arrow, ha="center", va="center", fontsize="large", zorder=4,
            bbox=_WHITE,
        )  # fmt: skip
        ax.plot(x[0], y[0], "ko", markersize=9, markeredgecolor="white", markeredgewidth=2, zorder=4)
    else:
        side = {"text": "left", "before": "right"}.get(kind, "center")
        for at, height in zip(x, y, strict=True):
            ax.text(at, height, label, ha=side, va="center", fontsize=_MARK, bbox=_WHITE, zorder=4, clip_on=True)


def _dashes(width: float, dash: Sequence[float]) -> Any:
    """In widths of the line, as matplotlib has them."""
    return (0, [length / width for length in dash]) if dash else "-"


def _area(fill: str | None, edge: str | None, kind: str, rise: float) -> dict[str, Any]:
    if kind == "hatched":
        hatch = ("--", "//", "||", "\\\\")[round(rise / 45) % 4]
        return {"facecolor": fill or "none", "edgecolor": edge, "hatch": hatch, "linewidth": 0}
    # Areas of one colour side by side show no seam.
    return {"facecolor": fill, "edgecolor": edge or fill, "linewidth": 0.8 if edge else 0.3}

