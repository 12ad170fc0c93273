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
    numbers = {name: number for name, number in solution.numbers.items() if name in printed and name not in TIMES}
    assert len(numbers) > 25
    for name, number in numbers.items():
        # Nine digits are printed.
        assert number.value == pytest.approx(printed[name], rel=1e-8), name
    rows = printed["verdict"]["findings"]
    assert [(row["key"], row["light"], row["value"]) for row in rows] == [
        (key, row.light, row.value) for key, row in solution.verdict.items()
    ]
    assert printed["verdict"]["sentence"] == str(solution.verdict)


def test_a_solution_has_arrays_numbers_and_frames(solution: sf.Solution) -> None:
    force = solution.load_travel["punch_force_N"]
    assert solution.complete and force.max() == pytest.approx(45503.8011, rel=1e-8)
    assert float(solution.numbers["punch_force_N"]) == pytest.approx(force.max(), rel=1e-3)
    end = solution.frames[-1]
    assert end.thickness.min() == pytest.approx(0.941025376, rel=1e-7) and len(solution.frames) > 3
    with pytest.raises(KeyError, match="did you mean punch_force_N"):
        solution.load_travel["punch_force"]
    assert solution.verdict.light == "green" and "tear" in str(solution.verdict)
    drawn, moved = solution.stages[0].tools["punch"], end.tools["punch"]
    assert drawn["z_mm"].max() == pytest.approx(-0.5) and np.allclose(moved["z_mm"] - drawn["z_mm"], end.travel, atol=0.01)


def test_nobody_changes_a_result(solution: sf.Solution) -> None:
    end, trace = solution.frames[-1], solution.case.trace(2)["primal_dual"]
    copied = pickle.loads(pickle.dumps(solution.load_travel))
    tables = [solution.load_travel, end.elements, end.nodes, end.tools["die"], copied, trace.iterations, trace.iterates[0].nodes]
    for values in [end.thickness, trace.residual, *(values for table in tables for values in table.values())]:
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 1.0
        with pytest.raises(ValueError, match="cannot set WRITEABLE"):
            values.flags.writeable = True
    with pytest.raises(TypeError):
        solution.numbers["punch_force_N"] = 0  # type: ignore[index]


def test_a_step_is_traced_with_every_matrix(solution: sf.Solution) -> None:
    """Trust: the run's own step; three matrices of one equilibrium, apart by the tolerance of the velocities, 1e-5."""
    trace = solution.case.trace(40, matrices="all")
    assert list(trace) == ["primal_dual", "newton", "secant"] and all(history.converged for history in trace.values())
    assert trace.travel == solution.load_travel["travel_mm"][39]
    own = trace["primal_dual"]
    assert len(own.velocity) - 1 == solution.load_travel["iterations"][39] and own.velocity[-1] > own.velocity[0] == 0.0
    assert own.residual[-1] < 0.01 * own.residual[0] and len(own.iterates) == len(own.residual)
    moves = [history.iterates[-1].nodes["z_mm"] for history in trace.values()]
    assert np.abs(moves[1] - moves[0]).max() < 1e-3 * trace.duration
    elements = own.iterates[-1].elements
    rate, flows = elements["strain_increment"] / trace.duration, elements["cut_off"] == 0
    # Mises' stress of the plane; transverse shear is small.
    along, across = elements["stress_meridional_MPa"], elements["stress_hoop_MPa"]
    equivalent = np.sqrt(along**2 - along * across + across**2)
    assert np.allclose(equivalent[flows], elements["yield_stress_MPa"][flows], rtol=0.05)
    # Beyond ten cut-offs the cut-off adds half a hundredth at most.
    assert np.allclose(elements["viscosity_MPa_s"][flows], (elements["yield_stress_MPa"] / (3 * rate))[flows], rtol=0.005)
    with pytest.raises(IndexError, match="there is no step 4000"):
        solution.case.trace(4000)
    with pytest.raises(ValueError, match="there is no matrix picard"):
        solution.case.trace(1, "picard")


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


def test_an_exported_drawing_gives_the_same_tools(solution: sf.Solution, tmp_path: Path) -> None:
    layers = solution.export(tmp_path / "tools.dxf")
    assert {"PUNCH", "DIE", "HOLDER", "SHEET", "BLANK"} <= set(layers)
    again = sf.Case.from_drawing(tmp_path / "tools.dxf")
    assert all(f"[tools.{tool}]" in again.text for tool in ("punch", "die", "holder")), again.text
    with pytest.raises(ValueError, match="ends with .dxf, .svg or .csv"):
        solution.export(tmp_path / "tools.step")


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
    assert "cup" in sf.templates() and sf.new("cup", height="35 mm").title and len(list(sf.materials())) > 5


def test_sheets_and_laws_are_described() -> None:
    steel = sf.materials()["drawing-steel"]
    assert steel["source"] and steel["tensile_strength_MPa"] > steel["proof_stress_MPa"] > 100 and steel["law"]
    swift = sf.laws()["hardening.swift"]
    assert swift["formula"] == "σ = k (offset + ε)^n." and swift["range"] and swift["source"].startswith("H. W. Swift")
    assert swift["keys"]["n"] == {"about": "Hardening exponent, 0 to 1.", "example": 0.22}
    assert all(law["formula"] and law["source"] and law["keys"] for law in sf.laws().values())
    assert not {"case", "solution", "study"} & set(dir(sf))


def test_a_drawing_becomes_a_case() -> None:
    drawing = ROOT / "tests" / "drawings" / "ezdxf_lines_and_arcs.dxf"
    case = sf.Case.from_drawing(drawing, friction=0.07, holder_force="9 kN", settings={"blank.elements": 77})
    assert "9 kN" in case.text and "= 77" in case.text and case.notes and case.drawing and "<svg" in case.drawing
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
    none = tmp_path / "none.toml"
    for read in (sf.Case.load, sf.Case.from_drawing, lambda path: sf.fit(path, to=path), lambda path: sf.compare(case, to=[path])):
        with pytest.raises(FileNotFoundError):
            read(none)


def test_an_interrupted_run_keeps_what_was_computed() -> None:
    case = sf.Case.load(QUICKSTART).with_({"blank.elements": 2000, "solver.max_step": 1e-5, "solver.first_step": 1e-5})
    calls: list[float] = []

    def progress(share: float) -> None:
        calls.append(share)
        if len(calls) == 3:
            _thread.interrupt_main()

    with pytest.raises(sf.Interrupted) as caught:
        case.solve(progress)
    partial = caught.value.partial
    assert not partial.complete and len(partial.load_travel["travel_mm"]) > 0
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(partial)

    def refuse(share: float) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        case.solve(refuse)
