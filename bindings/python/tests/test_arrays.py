"""Measurements as arrays and frames: the numbers of files, and their messages."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT
from numpy.typing import NDArray

BAR = ROOT / "reference_data" / "aisi304l_bar_flow_curve.csv"
CUP = sf.Case.load(QUICKSTART).with_({"blank.elements": 30})


def columns(path: Path) -> dict[str, NDArray[np.float64]]:
    """Of a CSV file."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def called(found: dict[str, Any], name: str) -> dict[str, Any]:
    """With another name for what was measured."""
    for table in [*found.get("tests", []), *found.get("curves", []), *found.get("measured", [])]:
        table.update({key: name for key in ("file", "curve") if key in table})
    for of in ("test 1", BAR.name):
        found["material"] = found.get("material", "").replace(f"to {of}:", f"to {name}:")
    return found


def test_a_law_of_arrays_is_that_of_their_file() -> None:
    of_file, bar = sf.fit(BAR), columns(BAR)
    laws = sf.fit(bar)
    assert laws.tests[0].file == "test 1" and called(laws.json, "bar") == called(of_file.json, "bar")
    assert laws.plot.fit().startswith("<svg")
    # In another unit, and from a view that is not contiguous.
    strain, stress, scatter, *_ = bar
    other = np.column_stack([100 * bar[strain], bar[stress], bar[scatter]]).T
    percent = sf.fit({f"{strain}_percent": other[0], stress: other[1], scatter: other[2]})
    for name, number in laws.best.parameters.items():
        assert float(percent.best.parameters[name]) == pytest.approx(float(number), rel=1e-6)
    several = sf.fit([bar, BAR], rate=[0.001, 1.0])
    assert [test.file for test in several.tests] == ["test 1", str(BAR)] and several.best.rate


def test_a_frame_of_pandas_is_a_test() -> None:
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(columns(BAR))
    assert called(sf.fit(frame).json, "") == called(sf.fit(BAR).json, "")
    # A gap is a row less.
    gap = pandas.concat([frame.iloc[:3], pandas.DataFrame([{name: None for name in frame}]), frame.iloc[3:]])
    assert sf.fit(gap).best.parameters == sf.fit(BAR).best.parameters


def test_keys_are_fitted_to_arrays(tmp_path: Path) -> None:
    load = CUP.with_(friction=0.12).solve().load_travel
    curve = {name: load[name][2::4] for name in ("travel_mm", "punch_force_N")}
    path = tmp_path / "curve.csv"
    rows = zip(*curve.values(), strict=True)
    path.write_text("travel_mm,punch_force_N\n" + "".join(f"{x},{y}\n" for x, y in rows))
    vary = {"friction": "0.08 in 0.01..0.3"}
    fit, of_file = sf.fit(CUP, vary, to=curve, threads=2), sf.fit(CUP, vary, to=path, threads=2)
    assert called(fit.json, "") == called(of_file.json, "") and fit.settings == of_file.settings
    np.testing.assert_array_equal(fit.curves[0].measured, curve["punch_force_N"])
    end = CUP.with_(friction=0.12).solve().frames[-1]
    both = sf.fit(CUP, vary, to=[path, {"s0_mm": end.s0, "thickness_mm": end.thickness}], threads=2)
    assert [one.file for one in both.curves] == ["curve.csv", "curve 2"]
    assert float(both.parameters["friction"]) == pytest.approx(0.12, abs=1e-3)


def test_runs_stand_beside_arrays(tmp_path: Path) -> None:
    curve = {"travel_mm": np.array([5.0, 10.0, 20.0]), "punch_force_kN": np.array([20.0, 40.0, 50.0])}
    path = tmp_path / "curve.csv"
    path.write_text("travel_mm,punch_force_kN\n5,20\n10,40\n20,50\n")
    compared, of_file = (sf.compare(QUICKSTART, one, also=[{"friction": 0.12}]) for one in (curve, path))
    assert compared.measured[0].curve == "curve 1"
    assert called(compared.json, "")["measured"] == called(of_file.json, "")["measured"]


def test_what_is_no_measurement_is_told() -> None:
    strain = np.linspace(0.01, 0.06, 6)
    stress = 300 + 1000 * strain
    back = strain.copy()
    back[3] = 0.005
    wrong: list[tuple[Any, str]] = [
        ({"true_strain": strain, "true_stress": stress}, "must end in a unit"),
        ({"true_strain": strain, "hardness_MPa": stress}, "test 1 has no columns of strain and stress"),
        ({"true_strain": back, "true_stress_MPa": stress}, "test 1, row 3: the strain goes back"),
        ({"true_strain": strain, "true_stress_MPa": stress[:4]}, "has 6 rows, but `true_stress_MPa` has 4"),
        ({"true_strain": strain, "true_stress_MPa": np.append(stress[:5], np.inf)}, "row 5 of `true_stress_MPa` is infinite"),
        ({"true_strain": strain, "true_stress_MPa": ["a"] * 6}, "the column true_stress_MPa is no numbers"),
        ({"true_strain": strain, "true_stress_MPa": np.ones((6, 2))}, "has 2 dimensions"),
        ({"elongation_mm": strain, "force_kN": stress}, "force and elongation"),
        ({}, "test 1 has no columns"),
        ([strain, stress], "test 1 is a ndarray"),
    ]
    for given, said in wrong:
        with pytest.raises(sf.StudyError, match=said) as caught:
            sf.fit(given)
        assert caught.value.help
    # In the words of Python.
    with pytest.raises(sf.StudyError, match='section="20 mm\\^2" and gauge="80 mm"'):
        sf.fit({"elongation_mm": strain, "force_kN": stress})
    with pytest.raises(sf.StudyError, match="curve 1 is no curve that a run can be held against"):
        sf.fit(CUP, {"friction": "0.1 in 0.01..0.3"}, to={"time_s": strain, "temperature_C": stress})
    with pytest.raises(sf.StudyError, match="are of a case"):
        sf.fit({"true_strain": strain, "true_stress_MPa": stress}, to="curve.csv")  # type: ignore[call-overload]
