"""Cases and solutions: the numbers of the command line, errors, pictures, interruption."""

from __future__ import annotations

import _thread
import csv
import json
import math
import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest
import stampflow as sf
from conftest import CASES, QUICKSTART, ROOT

#: Keys of the clock and of what the program adds to a summary on the screen.
TIMES = {"wall_time_s"}


@pytest.fixture(scope="module")
def solution() -> sf.Solution:
    return sf.Case.load(QUICKSTART).solve()


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_every_case_gives_the_tables_of_the_command_line(path: Path, program: str, tmp_path: Path) -> None:
    """Trust: CSV files hold the numbers of the arrays rounded to nine digits."""
    done = subprocess.run([program, "run", path.relative_to(ROOT), "--out", tmp_path, "--quiet"], cwd=ROOT, capture_output=True)
    assert done.returncode in (0, 3), done.stderr.decode()
    solution = sf.Case.load(path).solve()
    for i, stage in enumerate(solution.stages):
        folder = tmp_path if len(sf.Case.load(path).stages) == 1 else tmp_path / f"{i + 1}-{stage.name}"
        for name in ("load_travel", "profile"):
            rows = list(csv.reader((folder / f"{name}.csv").open()))
            table = stage.table(name)
            assert rows[0] == list(table)
            for at, values in enumerate(table.values()):
                written = [float(row[at]) if row[at] else math.nan for row in rows[1:]]
                rounded = [float(f"{value:.9g}") if math.isfinite(value) else math.nan for value in values]
                assert np.array_equal(written, rounded, equal_nan=True), rows[0][at]


def test_summary_and_verdict_are_those_of_the_command_line(program: str, solution: sf.Solution, tmp_path: Path) -> None:
    done = subprocess.run(
        [program, "run", "cases/quickstart.toml", "--json", "--out", tmp_path], cwd=ROOT, capture_output=True, check=True
    )
    printed = json.loads(done.stdout)
    assert printed["peak_punch_force_N"] == solution.summary["peak_punch_force_N"]
    rows = printed["verdict"]["findings"]
    assert [(row["key"], row["light"], row["value"]) for row in rows] == [
        (row.key, row.light, row.value) for row in solution.findings
    ]
    assert printed["verdict"]["sentence"] == solution.verdict


def test_a_solution_has_arrays_numbers_and_frames(solution: sf.Solution) -> None:
    force = solution.load_travel["punch_force_N"]
    assert solution.complete and force.max() == pytest.approx(45503.8011, rel=1e-8)
    assert float(solution.numbers["punch_force_N"]) == pytest.approx(force.max(), rel=1e-3)
    end = solution.frames[-1]
    assert end.thickness.min() == pytest.approx(0.941025376, rel=1e-7) and len(solution.frames) > 3
    with pytest.raises(ValueError, match="read-only"):
        force[0] = 1.0
    with pytest.raises(KeyError, match="did you mean punch_force_N"):
        solution.load_travel["punch_force"]
    assert solution.light in ("green", "amber", "red") and "tear" in solution.verdict


def test_pictures_are_the_svg_of_the_program(program: str, solution: sf.Solution, tmp_path: Path) -> None:
    args = [program, "run", "cases/quickstart.toml", "--format", "svg", "--out", str(tmp_path), "--quiet"]
    subprocess.run(args, cwd=ROOT, capture_output=True, check=True)
    picture = solution.plot.load_travel()
    assert picture._repr_svg_().startswith("<svg") and picture.caption
    assert picture == (tmp_path / "load_travel.svg").read_text(encoding="utf-8")
    assert picture.chart["panels"]
    with pytest.raises(AttributeError, match="there is no picture"):
        solution.plot.nothing()
    with pytest.raises(ValueError, match="nothing to draw"):
        solution.plot.springback()
    assert "<svg" in solution._repr_html_()


def test_error_bars_are_added(solution: sf.Solution) -> None:
    verified = solution.verify()
    bar = verified.numbers["punch_force_N"].error_bar
    assert bar is not None and 0.0 < bar < 5_000.0
    assert solution.numbers["punch_force_N"].error_bar is None


def test_results_and_report_are_written(solution: sf.Solution, tmp_path: Path) -> None:
    files = solution.write(tmp_path / "out")
    assert {Path(file).name for file in files} >= {"load_travel.csv", "part.png", "summary.json"}
    solution.report(tmp_path / "report.html")
    assert "<svg" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_a_case_is_varied_and_made_from_a_dictionary() -> None:
    case = sf.Case.load(QUICKSTART)
    assert case.with_({"blank.thickness": "0.8 mm"}) != case
    cup = {
        "title": "Cup",
        "geometry": "axisymmetric",
        "blank": {"radius": "55 mm", "thickness": "1 mm", "elements": 30},
        "material": {"hardening": {"swift": {"k": "520 MPa", "n": 0.22, "offset": 0.005}}},
        "tools": {
            "punch": {"flat": {"radius": "30 mm", "nose": "6 mm"}, "friction": 0.08, "travel": "5 mm"},
            "die": {"throat": "31.25 mm", "shoulder": "6 mm", "friction": 0.08},
            "holder": {"inner_radius": "38 mm", "force": "10 kN"},
        },
    }
    assert sf.Case.from_dict(cup).solve().complete
    copied = pickle.loads(pickle.dumps(case.with_({"friction": 0.1})))
    assert copied.settings == ["friction=0.1"] and copied == case.with_({"friction": 0.1})
    assert "cup" in sf.templates() and sf.new("cup", height="35 mm").title and len(sf.materials()) > 5


def test_a_drawing_becomes_a_case() -> None:
    drawing = ROOT / "tests" / "drawings" / "ezdxf_lines_and_arcs.dxf"
    case = sf.Case.from_drawing(drawing)
    assert case.notes and case.drawing is not None and "<svg" in case.drawing
    with pytest.raises(sf.DrawingError) as caught:
        sf.Case.from_drawing(ROOT / "tests" / "drawings" / "faulty" / "gap.dxf")
    assert caught.value.help


def test_errors_have_place_key_and_remedy(tmp_path: Path) -> None:
    case = sf.Case.load(QUICKSTART)
    with pytest.raises(sf.CaseError) as caught:
        case.with_({"blank.thickness": "0.8"})
    assert caught.value.key == "blank.thickness" and caught.value.help and "unit" in str(caught.value)
    wrong = case.text.replace("friction = 0.08", "friction = 7", 1)
    with pytest.raises(sf.CaseError) as caught:
        sf.Case.from_text(wrong, "wrong.toml")
    assert caught.value.line and caught.value.column and caught.value.file == "wrong.toml"
    with pytest.raises(FileNotFoundError):
        sf.Case.load(tmp_path / "none.toml")


def test_an_interrupted_run_keeps_what_was_computed() -> None:
    case = sf.Case.load(QUICKSTART).with_({"blank.elements": 2000, "solver.max_step": 1e-5, "solver.first_step": 1e-5})
    calls: list[float] = []

    def progress(share: float) -> None:
        calls.append(share)
        if len(calls) == 3:
            _thread.interrupt_main()

    with pytest.raises(sf.Interrupted) as caught:
        case.solve(progress)
    assert not caught.value.partial.complete and len(caught.value.partial.load_travel["travel_mm"]) > 0

    def refuse(share: float) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        case.solve(refuse)
