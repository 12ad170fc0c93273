"""Cases from drawings."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import pytest
import stampflow as sf
from conftest import ROOT

DRAWINGS = ROOT / "tests" / "drawings"


def test_a_drawing_makes_the_case_of_the_command_line(program: str, tmp_path: Path) -> None:
    for name in ("ezdxf_lines_and_arcs", "ezdxf_operations", "makerjs_inches_both_halves"):
        drawing, out = DRAWINGS / f"{name}.dxf", tmp_path / f"{name}.toml"
        sizes: dict[str, Any] = {"thickness": "0.8 mm", "travel": "20 mm"}
        words = [word for key, value in sizes.items() for word in (f"--{key}", value)]
        done = subprocess.run([program, "import", drawing, "-o", out, *words], cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        case = sf.Case.from_drawing(drawing, **sizes)
        assert case.text == out.read_text(encoding="utf-8") and case.name == name
        assert case.notes and all(note in done.stdout for note in case.notes)
        assert case.drawing is not None and case.drawing.startswith("<svg") and "<svg" in case._repr_html_()
        assert case.with_(friction=0.1).drawing is None


def test_what_is_said_of_a_drawing_is_minded() -> None:
    drawing = DRAWINGS / "ezdxf_lines_and_arcs.dxf"
    half = sf.Case.from_drawing(drawing, blank_radius="50 mm", material="DC04", geometry="plane_strain", join="0.02 mm")
    assert 'geometry = "plane_strain"' in half.text and 'half_length = "50 mm"' in half.text and "DC04" in half.text
    solution = sf.Case.from_drawing(drawing, travel="10 mm").solve()
    assert solution.load_travel["travel_mm"][-1] == 10


def test_a_wrong_drawing_is_refused(tmp_path: Path) -> None:
    drawing = DRAWINGS / "ezdxf_lines_and_arcs.dxf"
    with pytest.raises(sf.DrawingError, match="give mm, cm") as caught:
        sf.Case.from_drawing(drawing, units="furlong")
    assert caught.value.file == str(drawing) and "furlong" in caught.value.message
    with pytest.raises(sf.DrawingError, match="no punch is drawn"):
        sf.Case.from_drawing(drawing, layers={layer: "none" for layer in layers(drawing) if "PUNCH" in layer.upper()})
    with pytest.raises(sf.DrawingError, match="cannot be read"):
        sf.Case.from_drawing(tmp_path / "none.dxf")
    with pytest.raises(sf.CaseError):
        sf.Case.from_drawing(drawing, material="unobtainium")
    lines = []
    for faulty in sorted((DRAWINGS / "faulty").glob("*.dxf")):
        with pytest.raises((sf.DrawingError, sf.CaseError)) as refused:
            sf.Case.from_drawing(faulty)
        assert getattr(refused.value, "help"), faulty
        lines.append(getattr(refused.value, "line", None))
    assert any(lines), "places in the file are told"


def layers(drawing: Path) -> set[str]:
    """Every text behind the group code of a layer."""
    texts = drawing.read_text(encoding="utf-8").splitlines()
    return {text.strip() for code, text in zip(texts[::2], texts[1::2]) if code.strip() == "8"}
