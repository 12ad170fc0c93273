"""Studies as files, their tables on the disk, and their parts."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT

STUDY = f"""
case = "{QUICKSTART.as_posix()}"
set = ["blank.elements=30"]

[vary]
friction = [0.05, 0.1, 0.15]
tools.die.shoulder = "5..7 mm/2"
"""


@pytest.fixture
def study(tmp_path: Path) -> Path:
    path = tmp_path / "study.toml"
    path.write_text(STUDY)
    return path


def command(program: str, *words: str) -> dict[str, Any]:
    done = subprocess.run([program, *words, "--json", "--quiet"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)  # type: ignore[no-any-return]


def test_a_study_file_is_that_of_the_command_line(program: str, study: Path, tmp_path: Path) -> None:
    theirs = command(program, "sweep", str(study), "--out", str(tmp_path / "theirs"))
    ours = sf.sweep(study, out=tmp_path / "ours")
    table, times = (
        [(tmp_path / whose / name).read_bytes() for whose in ("ours", "theirs")]
        for name in ("study.csv", "study_times.csv")
    )
    assert table[0] == table[1] and table[0].count(b"\n") == 7
    assert times[0].count(b"\n") == times[1].count(b"\n") == 7
    here = {"file", "pictures", "kept", "wall_s"}
    assert ours.json.pop("told") == [ours.answer, *ours.notes] and theirs["told"][0] == ours.answer
    assert ours.json and ours.json == {key: value for key, value in theirs.items() if key not in {*here, "told"}}
    assert ours.answer == theirs["told"][0] and ours.shape == (3, 2) and list(ours.index) == list(range(6))
    held = sf.sweep(str(study))
    assert held.answer == ours.answer and held.plot.window() == ours.plot.window()
    # Trust: nine digits are written.
    np.testing.assert_allclose(ours.grid("thinnest_mm"), held.grid("thinnest_mm"), rtol=1e-8)
    assert list(ours["fails"]) == list(held["fails"]) and "seconds" in held
    assert sf.sweep(study, settings={"blank.elements": 20})["thinnest_mm"][0] != held["thinnest_mm"][0]


def test_parts_are_put_together(program: str, study: Path, tmp_path: Path) -> None:
    whole = sf.sweep(study, out=tmp_path / "whole")
    parts = [sf.sweep(study, shard=(k, 4), out=tmp_path) for k in (3, 1, 4, 2)]
    assert [list(part.index) for part in parts] == [[2], [0, 4], [3], [1, 5]] and not any(part.answer for part in parts)
    shards = sorted(tmp_path.glob("study-*-of-4.csv"))
    assert sf.merge(shards, tmp_path / "study.csv") == 6
    assert (tmp_path / "study.csv").read_bytes() == (tmp_path / "whole" / "study.csv").read_bytes()
    again = sf.sweep(study, out=tmp_path, resume=True)
    assert again.answer == whole.answer and "seconds" not in again
    np.testing.assert_array_equal(again["thinnest_mm"], whole["thinnest_mm"])
    with pytest.raises(sf.StudyError, match="is in no shard"):
        sf.merge(shards[1:], tmp_path / "other.csv")
    part = sf.sweep(study, shard=(2, 4))
    assert list(part.index) == [1, 5] and np.isnan(part.grid("thinnest_mm")[0, 0])
    # Trust: nine digits are written.
    np.testing.assert_allclose(part.grid("thinnest_mm")[2, 1], whole.grid("thinnest_mm")[2, 1], rtol=1e-8)


def test_rows_of_an_earlier_run_are_kept_or_refused(study: Path, tmp_path: Path) -> None:
    def stop(share: float) -> None:
        if share >= 0.5:
            raise RuntimeError("enough")

    # Half of the study is some seconds, after which it is heard at once.
    study.write_text(STUDY.replace("elements=30", "elements=500"))
    out = tmp_path / "out"
    with pytest.raises(RuntimeError, match="enough"):
        sf.sweep(study, out=out, threads=1, progress=stop)
    assert not (out / "study.csv").exists()
    left = (out / ".study.csv.part").read_bytes()
    assert 1 < left.count(b"\n") < 7
    with pytest.raises(sf.StudyError, match="did not end") as caught:
        sf.sweep(study, out=out)
    # In the words of Python.
    assert "resume" in caught.value.help and "--" not in caught.value.help
    done = sf.sweep(study, out=out, resume=True)
    assert done.designs == 6 and (out / "study.csv").read_bytes().startswith(left)
    for wrong, said in [
        ({"resume": True}, "no table"),
        ({"resume": True, "restart": True, "out": out}, "both"),
        ({"shard": (5, 4)}, "no shard"),
    ]:
        with pytest.raises(sf.StudyError, match=said) as caught:
            sf.sweep(study, **wrong)  # type: ignore[arg-type]
        assert caught.value.help


def test_one_key_at_a_time(program: str, study: Path, tmp_path: Path) -> None:
    theirs = command(program, "sweep", str(study), "--one-at-a-time", "--out", str(tmp_path))
    tornado = sf.sweep(study, one_at_a_time=True)
    assert tornado.answer == theirs["told"][0] and tornado.designs == 1 + 3 + 2 and tornado.shape is None
    assert tornado.plot.tornado().startswith("<svg")
    # The first is the case as it stands.
    np.testing.assert_array_equal(tornado["friction"], [np.nan, 0.05, 0.1, 0.15, np.nan, np.nan])
    with pytest.raises(sf.StudyError, match="has no grid"):
        tornado.grid("thinnest_mm")
    study.write_text("one_at_a_time = true\n" + STUDY)
    assert list(sf.sweep(study)["thinnest_mm"]) == list(tornado["thinnest_mm"])


def test_error_bars_of_a_sweep_over_one_key_are_those_of_the_command_line(program: str, tmp_path: Path) -> None:
    words = ["sweep", str(QUICKSTART), "--set", "blank.elements=30", "--vary", "friction=0.05,0.1"]
    command(program, *words, "--out", str(tmp_path / "theirs"))
    bars = sf.sweep(QUICKSTART, {"friction": [0.05, 0.1]}, settings={"blank.elements": 30}, out=tmp_path / "ours")
    table = [(tmp_path / whose / "study.csv").read_bytes() for whose in ("ours", "theirs")]
    assert table[0] == table[1]
    assert (bars["punch_force_error_N"] > 0).all()
    assert "punch_force_error_N" not in sf.sweep(QUICKSTART, {"friction": [0.1]}, error_bars=False)


def test_a_scatter_as_a_file(program: str, tmp_path: Path) -> None:
    study = tmp_path / "study.toml"
    study.write_text(
        f'case = "{QUICKSTART.as_posix()}"\nset = ["blank.elements=30"]\nruns = 32\nseed = 3\n\n'
        '[scatter]\nfriction = "uniform 0.05..0.12"\n'
    )
    theirs = command(program, "scatter", str(study), "--out", str(tmp_path / "theirs"))
    ours = sf.scatter(study)
    assert ours.runs == 32 and ours.json == {key: value for key, value in theirs.items() if key not in ("file", "written")}
    parts = [sf.scatter(study, shard=(k, 2), out=tmp_path) for k in (1, 2)]
    assert [part.runs for part in parts] == [16, 16] and not parts[0].numbers
    assert sf.merge(sorted(tmp_path.glob("scatter-*-of-2.csv")), tmp_path / "scatter.csv") == 32
    assert (tmp_path / "scatter.csv").read_bytes() == (tmp_path / "theirs" / "scatter.csv").read_bytes()
    merged = sf.scatter(study, out=tmp_path, resume=True)
    assert merged.answer == ours.answer and merged.numbers == ours.numbers
    assert sf.scatter(study, runs=64, seed=4).runs == 64


def test_a_search_of_a_file_and_a_fit_as_one(tmp_path: Path) -> None:
    case = sf.Case.load(QUICKSTART)
    words: dict[str, Any] = {"largest": True, "while_": "thinning < 8 %", "error_bars": False}
    of_file = sf.search(QUICKSTART, {"blank.diameter": "100..120 mm/3"}, **words)
    assert of_file.json == sf.search(case, {"blank.diameter": "100..120 mm/3"}, **words).json
    load = case.with_(friction=0.12, **{"blank.elements": 30}).solve().load_travel
    points = zip(load["travel_mm"][2::4], load["punch_force_N"][2::4], strict=True)
    (tmp_path / "curve.csv").write_text("travel_mm,punch_force_N\n" + "".join(f"{x},{y}\n" for x, y in points))
    study = tmp_path / "study.toml"
    study.write_text(f'case = "{QUICKSTART.as_posix()}"\nto = "curve.csv"\n\n[fit]\nfriction = [0.08, 0.01, 0.3]\n')
    fit = sf.fit(study, None, settings={"blank.elements": 30}, threads=2)
    # Trust: the program's own curve gives its key back, docs/fit.md.
    assert float(fit.parameters["friction"]) == pytest.approx(0.12, abs=1e-4)
    assert fit.case.solve().load_travel["punch_force_N"][-1] == pytest.approx(load["punch_force_N"][-1], rel=1e-3)
    with pytest.raises(sf.StudyError, match="cannot read"):
        sf.fit(tmp_path / "none.toml", None)
    with pytest.raises(sf.StudyError, match="no key of this study"):
        sf.sweep(study)
    with pytest.raises(sf.StudyError, match="nothing to vary"):
        sf.sweep(case)
