"""Pictures drawn with matplotlib show what their SVG shows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("svg")

CUP = sf.Case.load(QUICKSTART).with_({"blank.elements": 30})


@pytest.fixture(autouse=True)
def closed() -> Iterator[None]:
    yield
    import matplotlib.pyplot

    matplotlib.pyplot.close("all")


def written(ax: Any) -> list[str]:
    """What stands along x of a picture that is drawn."""
    ax.figure.canvas.draw()
    low, high = ax.get_xlim()
    return [label.get_text() for tick, label in zip(ax.get_xticks(), ax.get_xticklabels()) if low <= tick <= high]


def legend(ax: Any) -> list[str]:
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_even_ratios_stand_on_a_logarithmic_axis() -> None:
    curves = sf.sweep(CUP, {"tools.holder.force": "2..50 kN/5 log"}).plot.curves()
    ax = curves.axes()
    assert ax.get_xscale() == "log" and ax.get_yscale() == "linear" and ax.get_xlabel() == "Holder force [kN]"
    assert written(ax) == ["2", "5", "10", "20", "50"]
    # Trust: the values of the study.
    places = {round(float(x), 6) for line in ax.lines for x in line.get_xdata() if len(line.get_xdata()) == 5}
    assert places == {round(x, 6) for x in np.geomspace(2, 50, 5)}
    window = sf.sweep(CUP, {"tools.holder.force": "5..40 kN/3 log", "blank.radius": "50..58 mm/3"}).plot.window()
    drawn = window.axes()
    assert drawn.get_xscale() == "log" or drawn.get_yscale() == "log"


def test_names_stand_where_they_are_drawn() -> None:
    sheets = sf.sweep(CUP, {"material": ["drawing-steel", "aa6016-t4"], "friction": [0.05, 0.1]}).plot.window()
    ax = sheets.axes()
    names = written(ax) if len(ax.get_xticks()) == 2 else [label.get_text() for label in ax.get_yticklabels()]
    assert names == ["drawing-steel", "aa6016-t4"]


def test_bands_lines_and_their_legend() -> None:
    band = sf.scatter(CUP, {"friction": "uniform 0.05..0.12"}, runs=32).plot.load_band()
    ax = band.axes()
    assert len(legend(ax)) == len(set(legend(ax))) > 1 and any("%" in label for label in legend(ax))
    (filled,) = [patch for patch in ax.patches if len(patch.get_xy()) > 2]
    line = next(line for line in ax.lines if len(line.get_xdata()) > 2)
    assert filled.get_zorder() < line.get_zorder(), "behind"
    assert ax.get_ylim()[0] == 0
    # Drawn on axes that have something: it stays, and the axes keep their ends.
    other = CUP.solve().plot.load_travel().axes()
    ends = other.get_xlim()
    before = legend(other)
    assert band.axes(ax=other) is other and other.get_xlim() == ends and legend(other)[: len(before)] == before


def test_a_section_stands_as_in_the_press() -> None:
    solution = CUP.solve()
    ax = solution.plot.part().axes()
    assert ax.get_aspect() == 1 and ax.yaxis_inverted()
    shapes = solution.plot.shapes()
    figure = shapes.figure()
    sections = [ax for ax in figure.axes if ax.get_aspect() == 1]
    assert len(figure.axes) == shapes.panels and sections
    # A scale of colours has its values along x alone.
    (bar,) = [ax for ax in figure.axes if ax.get_aspect() != 1]
    low, high = bar.get_xlim()
    assert bar.get_ylim() == (0, 1) and not len(bar.get_yticks())
    assert {low, 0.0, high} <= set(bar.get_xticks()) and len(bar.get_xticks()) < 10


@pytest.mark.parametrize("case", ["quickstart", "hat_springback"])
def test_a_figure_has_all_panels_and_one_legend(case: str, tmp_path: Any) -> None:
    path = ROOT / "cases" / f"{case}.toml"
    if not path.exists():
        pytest.skip("no such case")
    solution = sf.Case.load(path).solve()
    names = [name for name in dir(sf.solved_stage.StagePlots) if not name.startswith("_")]  # type: ignore[attr-defined]
    drawn = 0
    for stage in solution.stages:
        for name in names:
            try:
                picture = getattr(stage.plot, name)()
            except ValueError:
                continue
            figure = picture.figure()
            figure.savefig(tmp_path / f"{name}.svg")
            assert len(figure.axes) == picture.panels and figure.get_suptitle().replace("\n", " ") == picture.heading
            drawn += 1
    assert drawn > 4
