"""Studies from Python."""

from __future__ import annotations

import pickle
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT

CHEAP = {"blank.elements": 20, "solver.max_step": 0.1}


def light(solution: sf.Solution) -> str:
    return solution.verdict.light


@pytest.fixture(scope="module")
def case() -> sf.Case:
    return sf.Case.load(QUICKSTART).with_(CHEAP)


def test_a_sweep_has_a_row_per_design_and_pictures(case: sf.Case) -> None:
    done: list[float] = []
    study = sf.sweep(case, {"friction": [0.04, 0.08, 0.12], "tools.die.shoulder": "5..8 mm/2"}, progress=done.append)
    assert len(study) == 6 and study.headline and done[-1] == pytest.approx(1.0)
    assert np.unique(study["friction"]).tolist() == [0.04, 0.08, 0.12]
    assert dir(study.plot) and "<svg" in study._repr_html_()
    with pytest.raises(KeyError, match="there is no column"):
        study["nothing"]


def test_ranges_are_tuples_lists_and_numbers(case: sf.Case) -> None:
    texts = sf.sweep(case, ["friction=0.04,0.12", "tools.die.shoulder=4..8 mm/3", "blank.layers=5"])
    values = {"friction": np.array([0.04, 0.12]), "tools.die.shoulder": ("4 mm", "8 mm", 3), "blank.layers": 5}
    same = pickle.loads(pickle.dumps(sf.sweep(case, values)))
    # The study's number is that of its texts.
    assert all(np.array_equal(same[name], texts[name]) for name in texts.columns if name != "study" and "nan" not in str(texts[name]))
    uniform = sf.scatter(case, {"friction": (0.06, 0.10)}, runs=8)
    assert uniform.headline == sf.scatter(case, "friction=uniform 0.06..0.10", runs=8).headline
    with pytest.raises(ValueError, match="read-only"):
        uniform["friction"][0] = 1.0


def test_eight_runs_go_to_processes(case: sf.Case) -> None:
    """Solutions come back as their cases. Processes are forked after the parent has used its own threads."""
    cases = [case.with_(friction=0.04 + 0.01 * i) for i in range(8)]
    here = [case.solve() for case in cases]
    lights = [solution.verdict.light for solution in here]
    with ProcessPoolExecutor(2) as pool:
        assert list(pool.map(sf.Case.solve, cases)) == here
        assert list(pool.map(light, here)) == lights
    joblib = pytest.importorskip("joblib")
    there = joblib.Parallel(n_jobs=2)(joblib.delayed(case.solve)() for case in cases)
    assert there == here and there[0] != here[1]
    assert [str(solution.numbers["punch_force_N"]) for solution in there] == [str(solution.numbers["punch_force_N"]) for solution in here]


def test_a_search_finds_a_limit(case: sf.Case) -> None:
    study = sf.search(case, {"tools.punch.travel": ("10 mm", "25 mm")}, target="punch_force=40 kN")
    assert study.found and "40" in study.headline


def test_a_scatter_counts_its_parts(case: sf.Case) -> None:
    study = sf.scatter(case, {"friction": "uniform 0.06..0.10"}, runs=16)
    assert len(study) == 16 and 0.06 <= study["friction"].min() <= study["friction"].max() <= 0.10


def test_laws_and_keys_are_fitted(case: sf.Case, tmp_path: Path) -> None:
    law = sf.fit(ROOT / "reference_data" / "aisi304l_bar_flow_curve.csv")
    assert "Ludwik" in law.headline + " ".join(law.notes)
    load = case.with_({"friction": 0.1}).solve().load_travel
    curve = tmp_path / "curve.csv"
    rows = zip(load["travel_mm"][5::8], load["punch_force_N"][5::8])
    curve.write_text("travel_mm,punch_force_N\n" + "".join(f"{x},{y}\n" for x, y in rows))
    fitted = sf.fit(case, {"friction": "0.06 in 0.01..0.3"}, curve)
    assert "0.1" in str(fitted.json)


def test_runs_are_compared(case: sf.Case) -> None:
    study = sf.compare(case, also="friction=0.12")
    assert study.json["tables"] and dir(study.plot)


def test_a_wrong_study_is_named(case: sf.Case) -> None:
    with pytest.raises(sf.StudyError) as caught:
        sf.sweep(case, {"blank.thickness": "0.8 mm.."})
    assert caught.value.help
