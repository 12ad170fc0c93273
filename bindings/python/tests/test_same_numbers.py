"""Python and the command line run one solver: the same numbers, bit for bit."""

from __future__ import annotations

import csv
import json
import math
import subprocess
from pathlib import Path

import pytest
import stampflow as sf
from conftest import CASES, ROOT

#: Of a run's clock alone.
TIMES = {"wall_time_s"}


def files(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def untimed(value: object) -> object:
    if isinstance(value, dict):
        return {key: untimed(item) for key, item in value.items() if key not in TIMES}
    return [untimed(item) for item in value] if isinstance(value, list) else value


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_every_case_gives_the_files_of_the_command_line(path: Path, program: str, tmp_path: Path) -> None:
    """Trust: all files of a run, compared as bytes; nothing but the time that it took is left out."""
    name = str(path.relative_to(ROOT))
    done = subprocess.run([program, "run", name, "--out", tmp_path / "cli", "--json"], cwd=ROOT, capture_output=True)
    assert done.returncode in (0, 3), done.stderr.decode()
    solution = sf.Case.load(path).solve()
    solution.write(tmp_path / "python")
    ours, theirs = files(tmp_path / "python"), files(tmp_path / "cli")
    assert ours.keys() == theirs.keys()
    for file, bytes_ in ours.items():
        if file.endswith("summary.json"):
            assert untimed(json.loads(bytes_)) == untimed(json.loads(theirs[file])), file
        else:
            assert bytes_ == theirs[file], file
    printed = json.loads(done.stdout)
    told = untimed(solution.summary)
    assert isinstance(told, dict)
    assert {key: value for key, value in untimed(printed).items() if key in told} == told  # type: ignore[attr-defined]
    assert [(row["key"], row["light"], row["value"], row["found"]) for row in printed["verdict"]["findings"]] == [
        (row.key, row.light, row.value, row.found) for row in solution.findings
    ]
    tables(solution, tmp_path / "cli")


def tables(solution: sf.Solution, folder: Path) -> None:
    """Trust: CSV files hold the numbers of the arrays rounded to nine digits."""
    for i, stage in enumerate(solution.stages):
        below = folder if len(solution.case.stages) == 1 else folder / f"{i + 1}-{stage.name}"
        for name, table in [("load_travel", stage.load_travel), ("profile", stage.profile)]:
            rows = list(csv.reader((below / f"{name}.csv").open()))
            assert rows[0] == list(table)
            for at, values in enumerate(table.values()):
                written = [float(row[at]) if row[at] else math.nan for row in rows[1:]]
                rounded = [float(f"{value:.9g}") if math.isfinite(value) else math.nan for value in values]
                assert all(a == b or (a != a and b != b) for a, b in zip(written, rounded, strict=True)), rows[0][at]
