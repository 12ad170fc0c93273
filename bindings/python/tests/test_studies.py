"""Searches, scatters, fits and comparisons: the numbers of the command line, and what Python has besides."""

from __future__ import annotations

import csv
import json
import re
import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from threading import Timer
from typing import Any

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT

BAR = ROOT / "reference_data" / "aisi304l_bar_flow_curve.csv"
#: A coarse cup: a run takes a few hundredths of a second.
COARSE = {"blank.elements": 30}
CUP = sf.Case.load(QUICKSTART).with_(COARSE)

#: Where a run's files go, and how long it took.
PLACES = {"file", "files", "seconds", "written", "case"}


def printed(program: str, folder: Path, *words: str) -> dict[str, Any]:
    """What the command line prints with --json, but for where and when."""
    done = subprocess.run([program, *words, "--json", "--out", str(folder)], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return placeless(json.loads(done.stdout))  # type: ignore[no-any-return]


def placeless(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: placeless(item) for key, item in value.items() if key not in PLACES}
    return [placeless(item) for item in value] if isinstance(value, list) else value


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def same_rows(found: sf.Search | sf.Best | sf.Scatter, path: Path) -> None:
    """Trust: the table of the command line holds the numbers of the arrays rounded to nine digits."""
    table = rows(path)
    assert found.runs == len(table)
    for header, column in found.items():
        if header not in table[0]:
            # Numbers that the case as it stands has not are in one cell there.
            assert header == "seconds" or any(f"{header}=" in row["other_numbers"] for row in table), header
        elif column.dtype == object:
            assert list(column) == [row[header] for row in table], header
        else:
            written = [float(row[header] or "nan") for row in table]
            np.testing.assert_allclose(column, written, rtol=1e-8, err_msg=header)


def shown(study: Any) -> None:
    """Its answer and its picture are what a notebook shows."""
    html = study._repr_html_()
    assert study.answer and study.answer.split("“")[0].split("&")[0][:20] in html and "<svg" in html


def test_a_search_is_that_of_the_command_line(program: str, tmp_path: Path) -> None:
    shares: list[float] = []
    span, condition = "90..150 mm/5", "no red"
    found = sf.search(CUP, {"blank.diameter": span}, largest=True, while_=condition, threads=2, progress=shares.append)
    words = ["--set", "blank.elements=30", "--vary", f"blank.diameter={span}", "--largest", "--while", condition]
    theirs = printed(program, tmp_path, "search", str(QUICKSTART), *words, "--threads", "2")
    assert placeless(found.json) == theirs
    same_rows(found, tmp_path / "search.csv")
    assert found.found == "between" and found.value is not None and found.other is not None
    assert found.tolerance == pytest.approx(found.other - found.value)
    assert found.solution is not None and found.solution.light != "red"
    assert found.solution.case.settings[-1].startswith("blank.diameter=")
    assert found.solution.numbers["thinnest_mm"].error_bar and found.draw_ratios
    assert shares == sorted(shares)
    assert found.plot.search() == found._pictures["search"][0]
    shown(found)


def test_a_search_for_a_number_and_a_template(program: str, tmp_path: Path) -> None:
    found = sf.search(CUP, ["tools.holder.force=5..60 kN log"], target="draw_in=10 mm", error_bars=False, threads=2)
    words = ["--set", "blank.elements=30", "--vary", "tools.holder.force=5..60 kN log", "--target", "draw_in=10 mm"]
    theirs = printed(program, tmp_path, "search", str(QUICKSTART), *words, "--no-error-bars", "--threads", "2")
    assert placeless(found.json) == theirs and found.wanted == 10
    ratio = sf.search(CUP, for_="limiting-draw-ratio", threads=2)
    words = ["--set", "blank.elements=30", "--for", "limiting-draw-ratio", "--threads", "2"]
    assert placeless(ratio.json) == printed(program, tmp_path, "search", str(QUICKSTART), *words)


def test_the_best_of_several_keys_is_that_of_the_command_line(program: str, tmp_path: Path) -> None:
    keys = {"tools.die.shoulder": "4..10 mm", "friction": "0.04..0.12"}
    best = sf.search(CUP, keys, minimise="punch_force", while_="thinning < 8 %", threads=2)
    words = [word for key, span in keys.items() for word in ("--vary", f"{key}={span}")]
    words += ["--minimise", "punch_force", "--while", "thinning < 8 %", "--set", "blank.elements=30", "--threads", "2"]
    assert placeless(best.json) == printed(program, tmp_path, "search", str(QUICKSTART), *words)
    same_rows(best, tmp_path / "search.csv")
    assert best.at and set(best.at) == {"tools.die.shoulder_mm", "friction"} and best.solution
    force = best.solution.numbers["punch_force_N"].value
    kept = best["punch_force_N"][best["end"] == "full travel"]
    assert force >= kept.min() and force in kept
    shown(best)


def test_wrong_searches_are_refused() -> None:
    wrong: list[tuple[dict[str, str], dict[str, Any], str]] = [
        ({"friction": "0.05..0.1"}, {"while_": "no red"}, "neither the largest nor the smallest"),
        ({"friction": "0.05..0.1"}, {"largest": True}, "what a run must keep to"),
        ({"friction": "0.05"}, {"largest": True, "while_": "no red"}, "no range"),
        ({"friction": "0.05..0.1"}, {"target": "drawin=8 mm"}, "no number `drawin`"),
        ({"friction": "0.05..0.1"}, {"target": "draw_in=8 mm", "while_": "no red"}, "both a condition and a target"),
        ({"friction": "0.05..0.1"}, {"largest": True, "smallest": True, "while_": "no red"}, "both the largest"),
        ({"friction": "0.05..0.1"}, {"minimise": "punch_force", "target": "draw_in=8 mm"}, "a best goes with"),
    ]
    for vary, words, said in wrong:
        with pytest.raises(sf.StudyError, match=said) as caught:
            sf.search(CUP, vary, **words)
        assert caught.value.help
    with pytest.raises(sf.CaseError):
        sf.search(CUP, {"tools.punch.fricton": "0.05..0.1"}, largest=True, while_="no red")


SCATTER = {"friction": "uniform 0.05..0.12", "blank.thickness": "normal ± 0.02 mm in ± 0.05 mm"}


@pytest.mark.parametrize("indices", [False, True], ids=["ranks", "indices"])
def test_a_scatter_is_that_of_the_command_line(program: str, tmp_path: Path, indices: bool) -> None:
    shares: list[float] = []
    sample = sf.scatter(CUP, SCATTER, runs=64, seed=7, indices=indices, progress=shares.append)
    words = [word for key, how in SCATTER.items() for word in ("--vary", f"{key}={how}")]
    words += ["--runs", "64", "--seed", "7", "--set", "blank.elements=30", *(["--indices"] if indices else [])]
    assert placeless(sample.json) == printed(program, tmp_path, "scatter", str(QUICKSTART), *words)
    same_rows(sample, tmp_path / "scatter.csv")
    assert shares[-1] == 1.0
    force = sample.numbers["punch_force_N"]
    assert force.q05 < force.q50 < force.q95 and force.runs == (128 if indices else 64)
    assert (force.influence.sobol is not None) == indices
    if force.influence.sobol:
        assert 0.5 < force.influence.sobol["friction"].total.value
    assert 0 <= float(sample.probability("tear")) <= 1
    assert sample.load is not None and (sample.load.q05 <= sample.load.q95).all()
    bands = [row for row in rows(tmp_path / "bands.csv") if row["curve"] == "punch_force_over_travel"]
    np.testing.assert_allclose(sample.load.q50, [float(row["q50"]) for row in bands], rtol=1e-8)
    for picture in (sample.plot.scatter(), sample.plot.load_band(), sample.plot.thickness_band()):
        assert picture.startswith("<svg")
    shown(sample)


def test_a_scatter_of_what_is_declared_and_correlated() -> None:
    declared = sf.scatter(CUP, runs=32)
    assert declared.declared and declared.scatters == ["friction"]
    keys = ("material.hardening.swift.k", "material.hardening.swift.n")
    vary = dict(zip(keys, ["normal ± 5 %", "normal ± 4 %"]))
    sample = sf.scatter(CUP, vary, correlate={keys: -0.8}, runs=64)
    found = np.corrcoef(sample[f"{keys[0]}_MPa"], sample[keys[1]])[0, 1]
    # Trust: the coefficient is that of the normal numbers behind; 64 points leave 0.1 open.
    assert found == pytest.approx(-0.8, abs=0.1)
    with pytest.raises(sf.StudyError, match="runs say nothing of a scatter"):
        sf.scatter(CUP, SCATTER, runs=3)
    with pytest.raises(sf.StudyError, match="how it scatters"):
        sf.scatter(CUP, ["friction"])
    with pytest.raises(KeyError, match="in no run"):
        sample.probability("no row")


def test_a_law_is_that_of_the_command_line(program: str, tmp_path: Path) -> None:
    laws = sf.fit(BAR)
    theirs = printed(program, tmp_path, "fit", str(BAR))
    ours = laws.json
    assert [test.pop("file") for test in ours["tests"]] and placeless(ours) == theirs
    assert laws.best.name == "ludwik" and set(laws.laws) == {"swift", "voce", "hockett-sherby", "ludwik", "mixed"}
    n = laws.best.parameters["n"]
    assert n.low and n.high and n.low < float(n) < n.high and n.standard_error
    assert laws.material == (tmp_path / "material.toml").read_text()
    assert sf.fit(str(BAR), law="swift", until="20 %").tests[0].end < 0.25
    assert laws.plot.fit().startswith("<svg")
    shown(laws)
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"law": "hooke"}, "the laws are"),
        ({"young": "210 mm"}, "210 mm"),
        ({"rate": [1, 2]}, "for 1 test"),
    ]
    for words, said in wrong:
        with pytest.raises(sf.StudyError, match=said):
            sf.fit(BAR, **words)
    with pytest.raises(sf.StudyError, match="cannot read"):
        sf.fit("none.csv")


def test_a_fitted_sheet_is_that_of_its_pasted_text() -> None:
    """Trust: the text that the command line writes to be pasted, in place of the case's own."""
    for law in ("ludwik", "mixed", "hockett-sherby"):
        laws = sf.fit(BAR, law=law)
        case = laws.applied_to(CUP)
        pasted = re.sub(r"\[material\..*?(?=\n\[)", lambda _: laws.material, QUICKSTART.read_text(), flags=re.DOTALL)
        assert pasted.count("[material") == laws.material.count("[material")
        theirs = sf.Case.from_text(pasted).with_(COARSE)
        ours, pastes = (one.solve().load_travel["punch_force_N"] for one in (case, theirs))
        np.testing.assert_array_equal(ours, pastes)


def test_keys_of_a_case_are_those_of_the_command_line(program: str, tmp_path: Path) -> None:
    curve = tmp_path / "curve.csv"
    travel, force = (CUP.with_(friction=0.12).solve().load_travel[name] for name in ("travel_mm", "punch_force_N"))
    points = zip(travel[2::4], force[2::4], strict=True)
    curve.write_text("travel_mm,punch_force_N\n" + "".join(f"{x},{y}\n" for x, y in points))
    fit = sf.fit(CUP, {"friction": "0.08 in 0.01..0.3"}, to=curve, threads=2)
    words = ["--vary", "friction=0.08 in 0.01..0.3", "--to", str(curve), "--set", "blank.elements=30", "--threads", "2"]
    theirs = printed(program, tmp_path / "out", "fit", str(QUICKSTART), *words)
    assert placeless({**fit.json, "curves": None}) == {**theirs, "curves": None}
    # Trust: the program's own curve gives its key back, docs/fit.md.
    assert float(fit.parameters["friction"]) == pytest.approx(0.12, abs=1e-4)
    assert fit.case.settings[-1] == fit.settings[-1] and fit.settings[-1].startswith("friction=0.1")
    (matched,) = fit.curves
    np.testing.assert_allclose(matched.computed, matched.measured, rtol=1e-3)
    np.testing.assert_allclose(matched.measured, force[2::4], rtol=1e-12)
    assert fit.rms["end"] is not None and fit.rms["start"] is not None and fit.rms["end"] < fit.rms["start"]
    shown(fit)
    with pytest.raises(sf.StudyError, match="no key is to be fitted"):
        sf.fit(CUP, {}, to=curve)
    with pytest.raises(sf.StudyError, match="where to begin"):
        sf.fit(CUP, {"friction": "0.01..0.3"}, to=curve)


def test_runs_side_by_side_are_those_of_the_command_line(program: str, tmp_path: Path) -> None:
    curve = tmp_path / "measured.csv"
    curve.write_text("travel_mm,punch_force_kN\n5,20\n10,40\n20,50\n")
    shares: list[float] = []
    compared = sf.compare(CUP, curve, also=[{"friction": 0.12}, {"tools.die.shoulder": "4 mm"}], progress=shares.append)
    words = [str(curve), "--also", "friction=0.12", "--also", "tools.die.shoulder=4 mm", "--set", "blank.elements=30"]
    theirs = printed(program, tmp_path / "out", "compare", str(QUICKSTART), *words)
    for run in [*compared.json["runs"], *theirs["runs"]]:
        # Texts have their quotes in Python: friction=0.12, tools.die.shoulder="4 mm".
        run.pop("overrides")
    assert placeless(compared.json) == theirs
    assert [solution.light for solution in compared.solutions] == [run["verdict"] for run in theirs["runs"]]
    force = compared["punch_force_N"]
    for solution, value, bar in zip(compared.solutions, force.values, force.error_bars, strict=True):
        number = solution.numbers["punch_force_N"]
        assert (number.value, number.error_bar) == (value, bar)
    np.testing.assert_allclose(force.differences[1:], force.values[1:] - force.values[0], rtol=1e-9)
    assert force.within_error[0] is None and len(compared.legend) == 4
    assert compared.measured[0].points == 3 and compared.measured[0].unit == "N"
    assert compared.plot.load().startswith("<svg") and compared.plot.sections().startswith("<svg")
    with pytest.raises(ValueError, match="nothing for the picture compare_strains"):
        compared.plot.strains()
    shown(compared)
    other = sf.compare(CUP, sf.Case.load(ROOT / "cases" / "erichsen_304l.toml").with_(COARSE))
    assert other.legend == ["A: quickstart", "B: erichsen_304l"]
    with pytest.raises(sf.StudyError, match="one is not enough"):
        sf.compare(CUP)


def test_studies_become_frames_of_pandas() -> None:
    pytest.importorskip("pandas")
    sample = sf.scatter(CUP, {"friction": "uniform 0.05..0.12"}, runs=32)
    assert list(sample.to_pandas()["friction"]) == list(sample["friction"])
    frame = sf.compare(CUP, also=[{"friction": 0.12}]).to_pandas()
    assert list(frame.index) == ["friction 0.08", "friction 0.12"] and "thinnest_mm" in frame


def test_a_sweep_is_told_and_drawn() -> None:
    curves = sf.sweep(CUP, {"friction": "0.04..0.16/4"})
    assert curves.plot.curves().startswith("<svg")
    shown(curves)
    window = sf.sweep(CUP, {"blank.radius": "50..58 mm/3", "tools.holder.force": "5..40 kN/3"})
    assert window.plot.window().startswith("<svg") and window.answer
    with pytest.raises(ValueError, match="nothing for the picture curves"):
        window.plot.curves()


def pressed_after(seconds: float) -> Timer:
    timer = Timer(seconds, signal.raise_signal, [signal.SIGINT])
    timer.start()
    return timer


def test_ctrl_c_keeps_the_runs_that_are_done() -> None:
    """Trust: rows are whole runs in their order, those of the cases by themselves."""
    fine = CUP.with_({"blank.elements": 200})
    pressed_after(1.5)
    with pytest.raises(sf.Interrupted) as caught:
        sf.scatter(fine, SCATTER, runs=4096)
    kept = caught.value.partial
    assert isinstance(kept, sf.Scatter) and 0 < kept.runs < 4096
    assert not kept.lights and not kept.numbers and kept._repr_html_()
    first = fine.with_(friction=kept["friction"][0], **{"blank.thickness": f"{kept['blank.thickness_mm'][0]} mm"}).solve()
    assert first.numbers["thinnest_mm"].value == kept["thinnest_mm"][0]

    pressed_after(1.5)
    with pytest.raises(sf.Interrupted) as caught:
        sf.search(fine, {"friction": "0.02..0.3/500"}, largest=True, while_="no red")
    assert isinstance(caught.value.partial, sf.Search) and caught.value.partial.runs > 0
    assert caught.value.partial.found == "interrupted" and caught.value.partial.solution is None

    pressed_after(1.5)
    also = [{"friction": 0.09 + 1e-4 * i} for i in range(300)]
    with pytest.raises(sf.Interrupted) as caught:
        sf.compare(fine, also=also)
    assert 0 < len(caught.value.partial.solutions) < 300


def test_ctrl_c_before_the_first_run_has_ended(tmp_path: Path) -> None:
    """Trust: a run of this mesh takes some seconds; what is raised then has no part or an empty one, and no study goes on."""
    slow = CUP.with_({"blank.elements": 2000, "solver.strain_step": 0.002})
    curve = tmp_path / "curve.csv"
    curve.write_text("travel_mm,punch_force_kN\n" + "".join(f"{x},{2 * x}\n" for x in range(1, 20)))
    studies: list[Callable[[], object]] = [
        lambda: sf.sweep(slow, {"friction": [0.05, 0.1]}),
        lambda: sf.search(slow, {"friction": "0.02..0.3"}, largest=True, while_="no red"),
        lambda: sf.search(slow, {"friction": "0.02..0.3"}, minimise="punch_force"),
        lambda: sf.scatter(slow, SCATTER, runs=32),
        lambda: sf.fit(slow, {"friction": "0.08 in 0.01..0.3"}, to=curve),
        lambda: sf.compare(slow, also=[{"friction": 0.12}]),
    ]
    for study in studies:
        pressed_after(0.5)
        with pytest.raises(KeyboardInterrupt) as caught:
            study()
        assert not isinstance(caught.value, sf.Interrupted) or caught.value.partial.runs == 0
