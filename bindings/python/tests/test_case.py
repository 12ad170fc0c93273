"""Cases: read, changed, refused."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest
import stampflow as sf
from conftest import QUICKSTART


def test_settings_are_those_of_the_command_line() -> None:
    case = sf.Case.load(QUICKSTART).with_(**{"tools.punch.friction": 0.1, "blank.thickness": "0.9 mm"})
    assert case.settings == ["tools.punch.friction=0.1", 'blank.thickness="0.9 mm"']
    assert 'thickness = "0.9 mm"' in case.text
    assert case.with_({"blank.elements": np.int64(40)}).settings[-1] == "blank.elements=40"
    assert sf.Case.load(QUICKSTART).settings == []
    thinner = case.with_(**{"tools.holder.force": [["0 mm", "10 kN"], ["25 mm", "20 kN"]]})
    assert 'force = [["0 mm", "10 kN"], ["25 mm", "20 kN"]]' in thinner.text


def test_an_error_has_its_file_its_place_and_help(tmp_path: Path) -> None:
    path = tmp_path / "cup.toml"
    path.write_text(QUICKSTART.read_text().replace('thickness = "1.0 mm"', "thickness = 1.0"))
    with pytest.raises(sf.CaseError) as caught:
        sf.Case.load(path)
    error = caught.value
    line = next(i for i, text in enumerate(path.read_text().splitlines(), 1) if text.startswith("thickness"))
    assert (error.file, error.line, error.column, error.key) == (str(path), line, 13, "blank.thickness")
    assert error.help and "mm" in error.help
    assert error.message in str(error) and "thickness = 1.0" in str(error), "the line is shown"


def test_what_is_nowhere_has_no_place() -> None:
    with pytest.raises(sf.CaseError, match="there is no file") as caught:
        sf.Case.load("none.toml")
    assert (caught.value.file, caught.value.line) == (None, None)
    with pytest.raises(sf.CaseError, match="no table"):
        sf.Case.load(QUICKSTART).with_(**{"tool.punch.friction": 0.1})
    with pytest.raises(TypeError, match="no value of a case file"):
        sf.Case.load(QUICKSTART).with_(**{"tools.punch.friction": object()})


def test_a_check_tells_what_was_assumed() -> None:
    findings = sf.Case.load(QUICKSTART).with_(**{"blank.elements": 12}).check()
    assert any(finding.key == "mesh" or "element" in finding.found for finding in findings), findings


def test_templates_make_cases() -> None:
    case = sf.new("cup", height="35 mm", punch_radius="40 mm")
    assert case.name == "cup" and case.solve().complete
    assert {"cup", "hat-section", "v-bend"} <= set(sf.templates())
    assert "punch_radius" in [option.name for option in sf.templates()["cup"].options]
    with pytest.raises(sf.CaseError, match="no option"):
        sf.new("cup", hight="35 mm")
    with pytest.raises(sf.CaseError, match="no template"):
        sf.new("cupp")
    with pytest.raises(sf.CaseError, match="no option hight") as caught:
        sf.new("cup", hight="35 mm")
    assert caught.value.help and "height" in caught.value.help and "--" not in str(caught.value)


def test_a_case_can_be_asked_copied_and_sent() -> None:
    case = sf.Case.load(QUICKSTART).with_({"blank.elements": 30, "friction": 0.1})
    assert case.value("blank.thickness") == "1.0 mm" and case.value("blank.elements") == "30"
    # Trust: that of every tool; the holder's force is of no tool else.
    assert case.value("friction") == "0.1" and case.value("tools.punch.force") is None
    for again in (copy.deepcopy(case), pickle.loads(pickle.dumps(case))):
        assert (again.text, again.settings, again.path) == (case.text, case.settings, case.path)
        assert again.solve().numbers["thinnest_mm"].value == case.solve().numbers["thinnest_mm"].value


def test_names_that_are_near_are_told() -> None:
    solution = sf.Case.load(QUICKSTART).with_({"blank.elements": 30}).solve()
    with pytest.raises(KeyError, match="no number thinnest; did you mean thinnest_mm"):
        solution.numbers["thinnest"]
    with pytest.raises(KeyError, match="no column punch_force; did you mean punch_force_N"):
        solution.load_travel["punch_force"]
    with pytest.raises(AttributeError, match="no picture thinning; there are .*thickness"):
        getattr(solution.plot, "thinning")
    assert "load_travel" in repr(solution.plot) and "thinnest_mm: Thinnest 0.9" in repr(solution.numbers)
    friction = next(row for row in solution.findings if row.key == "friction")
    assert repr(friction).startswith("<Finding friction: amber, 0.08")
    # What can be looked for has the spaces that are on a keyboard.
    texts = [solution.verdict, *(row.found for row in solution.findings), *(str(n) for n in solution.numbers.values())]
    assert any(" mm" in text for text in texts) and not any("\u00a0" in text for text in texts)
