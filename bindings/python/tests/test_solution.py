"""What a solution gives."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT


@pytest.fixture(scope="module")
def cup() -> sf.Solution:
    return sf.Case.load(QUICKSTART).solve()


@pytest.fixture(scope="module")
def hat() -> sf.Solution:
    return sf.Case.load(ROOT / "cases" / "hat_springback.toml").solve()


def test_tables_are_arrays(cup: sf.Solution) -> None:
    force = cup.load_travel["punch_force_N"]
    assert force.dtype == np.float64 and len(force) == len(cup.load_travel["travel_mm"])
    assert cup.load_travel["travel_mm"][-1] == 25.0
    assert f"{force.max():.9g}" == f"{cup.summary['peak_punch_force_N']:.9g}"
    assert cup.load_travel.units["punch_force_N"] == "N"
    assert cup.load_travel.labels["punch_force_N"] == "Punch force"
    assert cup.load_travel is cup.load_travel, "made once"
    with pytest.raises(KeyError, match="there are travel_mm"):
        cup.load_travel["punch_force_kN"]


def test_frames_hold_the_sheet(cup: sf.Solution) -> None:
    end = cup.frames[-1]
    assert end.travel == 25.0 and len(end.thickness) == 100 and len(end.nodes["r_mm"]) == 101
    assert end.thickness.min() == cup.load_travel["thinnest_mm"][-1]
    # Trust: the definition, and round-off.
    np.testing.assert_allclose(np.log(end.thickness / 1.0), end.strain_thickness, atol=1e-12)
    assert [frame.travel for frame in cup.frames] == sorted(frame.travel for frame in cup.frames[:])
    for array in (end.s0, end.r, end.z, end.strain_hoop, end.strain_meridional, end.stress_hoop, end.stress_meridional):
        assert array.shape == end.thickness.shape and np.isfinite(array).all()
    assert end.strain_equivalent.max() > 0.1
    with pytest.raises(IndexError):
        cup.frames[99]
    with pytest.raises(KeyError, match="temperature"):
        _ = end.temperature


def test_the_verdict_is_told(cup: sf.Solution) -> None:
    assert cup.light in ("green", "amber", "red")
    thinning = next(row for row in cup.findings if row.key == "thinning")
    assert thinning.limit and thinning.source and thinning.unit == "percent" and thinning.error_bar is None
    assert cup.verdict and cup.headline and "Steel cup" in str(cup)


def test_numbers_have_error_bars_once_verified(cup: sf.Solution) -> None:
    assert cup.numbers["thinnest_mm"].error_bar is None and cup.about_error_bars == []
    shares: list[float] = []
    verified = cup.verify(quick=True, progress=shares.append)
    thinnest = verified.numbers["thinnest_mm"]
    assert thinnest.error_bar and 0 < thinnest.error_bar < 0.2 and "±" in str(thinnest)
    assert float(thinnest) == cup.numbers["thinnest_mm"].value
    assert any("error bars" in told for told in verified.about_error_bars)
    assert next(row for row in verified.findings if row.key == "thinning").error_bar
    assert verified.summary["thinnest_error_bar_mm"] > 0
    assert shares == [1.0]


def test_stages_stand_by_themselves(hat: sf.Solution) -> None:
    assert [stage.name for stage in hat.stages] == ["draw", "release"] == hat.case.stages
    with pytest.raises(ValueError, match=r"stages\[0\] \(draw\), stages\[1\] \(release\)"):
        _ = hat.load_travel
    assert hat.stages[0].load_travel["punch_force_N_per_mm"].max() > 0
    assert len(hat.stages[1].residual_stress) > 3
    assert [stage["stop"] for stage in hat.summary["stages"]]
    with pytest.raises(ValueError, match="has no residual_stress"):
        _ = hat.stages[0].residual_stress


def test_pictures_are_svg(cup: sf.Solution, hat: sf.Solution, tmp_path: Path) -> None:
    load = cup.plot.load_travel()
    assert ElementTree.fromstring(load).tag.endswith("svg") and load._repr_svg_() == load
    load.save(tmp_path / "load.svg")
    assert (tmp_path / "load.svg").read_text(encoding="utf-8") == load
    for picture in (cup.plot.part(), cup.plot.shapes(), cup.plot.thickness(), cup.plot.strains()):
        assert picture.startswith("<svg") and picture.heading
    assert hat.stages[1].plot.springback().startswith("<svg")
    with pytest.raises(ValueError, match="nothing for the picture springback"):
        cup.plot.springback()
    html = cup._repr_html_()
    assert cup.verdict in html and "<svg" in html and "Thinning" in html


def test_pictures_can_be_drawn_with_matplotlib(cup: sf.Solution) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    ax = cup.plot.load_travel().axes()
    assert ax.get_xlabel() == "Punch travel [mm]"
    line = next(line for line in ax.lines if line.get_label() == "Punch force")
    assert ax.get_ylabel().endswith("[kN]"), "as it is told"
    np.testing.assert_array_equal(line.get_ydata(), cup.load_travel["punch_force_N"] * 1e-3)
    section = cup.plot.part().axes()
    assert cup.plot.part().axes(ax=section) is section
    assert section.get_aspect() == 1 and section.get_ylim()[0] > section.get_ylim()[1], "down the page"
    assert 0 < section.get_xlim()[1] < 55, "no wider than the part"


def test_tables_become_frames_of_pandas(cup: sf.Solution, hat: sf.Solution) -> None:
    pandas = pytest.importorskip("pandas")
    frame = cup.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame.columns) == list(cup.load_travel)
    both = hat.to_pandas()
    assert set(both["stage"]) == {"draw", "release"}
    assert len(both) == sum(len(stage.load_travel["step"]) for stage in hat.stages)


def test_references_stand_beside() -> None:
    solution = sf.Case.load(ROOT / "cases" / "osu_stretch.toml").solve()
    (travel,) = solution.comparisons
    assert travel.quantity == "travel" and not travel.failure and travel.source
    assert "tolerance 5 %" in travel.sentence
    assert len(travel.table["reference_mm"]) == len(travel.table["computed_mm"]) > 3
