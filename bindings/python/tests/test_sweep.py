"""Studies."""

from __future__ import annotations

import signal
from threading import Timer

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART

CUP = sf.Case.load(QUICKSTART).with_(**{"blank.elements": 30})


def test_a_sweep_has_the_numbers_of_its_runs() -> None:
    shares: list[float] = []
    frictions = [0.05, 0.1, 0.15]
    sweep = sf.sweep(CUP, {"tools.die.shoulder": "5..7 mm/2", "friction": frictions}, progress=shares.append)
    assert sweep.designs == 6 and sweep.shape == (2, 3) and "friction" in sweep
    assert list(sweep["tools.die.shoulder_mm"]) == [5, 5, 5, 7, 7, 7]
    assert shares == sorted(shares) and shares[-1] == 1.0
    for i, shoulder in enumerate(["5 mm", "7 mm"]):
        for j, friction in enumerate(frictions):
            one = CUP.with_(**{"tools.die.shoulder": shoulder, "friction": friction}).solve()
            for name in ("thinnest_mm", "punch_force_N", "draw_in_mm"):
                assert sweep.grid(name)[i, j] == one.numbers[name].value, name
            assert sweep.grid("verdict")[i, j] == one.light


def test_a_sweep_becomes_a_frame_of_pandas() -> None:
    pytest.importorskip("pandas")
    frame = sf.sweep(CUP, {"friction": [0.05, 0.1]}).to_pandas()
    assert list(frame["friction"]) == [0.05, 0.1] and "verdict" in frame


def test_values_may_be_written_as_on_the_command_line() -> None:
    texts = sf.sweep(CUP, ["friction=0.05,0.1", "blank.radius=54..55 mm/2 & tools.punch.travel=24..25 mm/2"])
    keys = sf.sweep(
        CUP,
        {"friction": np.array([0.05, 0.1])},
        together=[{"blank.radius": ["54 mm", "55 mm"], "tools.punch.travel": "24..25 mm/2"}],
        threads=1,
    )
    assert texts.shape == keys.shape == (2, 2)
    np.testing.assert_array_equal(texts["thinnest_mm"], keys["thinnest_mm"])
    words = sf.sweep(CUP, {"material": ["drawing-steel", "aa6016-t4"]})
    assert list(words["material"]) == ["drawing-steel", "aa6016-t4"]


def test_what_cannot_be_built_is_a_row_that_says_why() -> None:
    sweep = sf.sweep(CUP, {"tools.punch.flat.nose": ["6 mm", "60 mm"]})
    assert list(sweep["end"]) == ["full travel", "not run"]
    assert np.isnan(sweep["thinnest_mm"][1]) and not np.isnan(sweep["thinnest_mm"][0]) and sweep["reason"][1]


def test_a_wrong_study_is_refused() -> None:
    with pytest.raises(sf.StudyError, match="does not say how many") as caught:
        sf.sweep(CUP, {"friction": "0.05..0.1"})
    assert "FROM..TO" in caught.value.help
    with pytest.raises(sf.StudyError, match="more than 10000000"):
        sf.sweep(CUP, {"friction": "0.05..0.1/4000", "tools.punch.friction": "0.05..0.1/4000"})
    with pytest.raises(sf.CaseError, match="holds no|there is no|unknown"):
        sf.sweep(CUP, {"tools.punch.fricton": [0.05, 0.1]})


def test_a_model_built_in_code_can_be_swept() -> None:
    case = sf.Case.from_text(CUP.text, "nowhere/cup.toml").with_(friction=0.1)
    sweep = sf.sweep(case, {"blank.thickness": ["0.9 mm", "1 mm"]})
    assert sweep["thinnest_mm"][1] == case.solve().numbers["thinnest_mm"].value


def test_ctrl_c_keeps_the_designs_that_are_done() -> None:
    """Trust: rows are whole designs in their order, those of the runs by themselves."""
    friction = np.linspace(0.02, 0.15, 2000)
    began = Timer(1.0, signal.raise_signal, [signal.SIGINT])
    began.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        sf.sweep(CUP, {"friction": friction})
    assert isinstance(caught.value, sf.Interrupted)
    kept = caught.value.partial
    assert isinstance(kept, sf.Sweep) and 0 < kept.designs < 2000
    np.testing.assert_array_equal(kept["friction"], friction[: kept.designs])
    assert np.isnan(kept.grid("thinnest_mm")[-1])
    first = CUP.with_(friction=friction[0]).solve()
    assert kept["thinnest_mm"][0] == first.numbers["thinnest_mm"].value
