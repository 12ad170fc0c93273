"""Models built in code."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace

import pytest
import stampflow as sf
from conftest import QUICKSTART, ROOT

TOOLS = sf.Tools(
    punch=sf.Punch(flat=sf.Flat(radius="30 mm", nose="6 mm"), friction=0.08, travel="25 mm"),
    die=sf.Die(throat="31.25 mm", shoulder="6 mm", friction=0.08),
    holder=sf.Holder(inner_radius="32 mm", force="10 kN"),
)
CUP = sf.Model(
    title="Steel cup, 60 mm punch",
    geometry="axisymmetric",
    blank=sf.Blank(radius="55 mm", thickness="1.0 mm"),
    material=sf.Material(hardening=sf.Swift(k="520 MPa", n=0.22, offset=0.005)),
    tools=TOOLS,
)


def test_a_model_is_the_case_of_its_file() -> None:
    ours, theirs = CUP.case().solve(), sf.Case.load(QUICKSTART).solve()
    assert (ours.load_travel["punch_force_N"] == theirs.load_travel["punch_force_N"]).all()
    assert "[material.hardening.swift]" in CUP.toml() and "[tools.punch.flat]" in CUP.toml()


def test_its_errors_are_those_of_files() -> None:
    wrong = replace(CUP, blank=sf.Blank(radius="55 MPa", thickness="1.0 mm"))
    with pytest.raises(sf.CaseError) as caught:
        wrong.case("cup.toml")
    assert (caught.value.file, caught.value.key) == ("cup.toml", "blank.radius")
    assert 'radius = "55 MPa"' in str(caught.value) and caught.value.help
    missing = replace(CUP, blank=sf.Blank(thickness="1.0 mm"))
    with pytest.raises(sf.CaseError, match="radius"):
        missing.case()
    with pytest.raises(TypeError):
        sf.Blank(radius="55 mm", thicknes="1 mm")  # type: ignore[call-arg]


def test_stages_beads_and_laws_are_written() -> None:
    stages = [sf.Stage(name="retract", punch=sf.StagePunch(move="-30 mm"))]
    strip = sf.Bead(at="40 mm", restraining="20 N/mm")
    model = replace(
        CUP,
        stages=stages,
        tools=replace(TOOLS, beads=[strip]),
        material=sf.Material(
            hardening=sf.Voce(initial="150 MPa", saturation="350 MPa", rate=12.0),
            yield_condition=sf.HosfordLaw(crystal="bcc"),
        ),
    )
    text = model.toml()
    assert "[[stages]]" in text and "[[tools.beads]]" in text and "[material.yield_condition.hosford]" in text


def test_the_classes_are_those_of_the_schema(program: str) -> None:
    schema = subprocess.run([program, "schema"], capture_output=True, check=True).stdout
    tools = ROOT / "python" / "tools" / "parts.py"
    written = subprocess.run([sys.executable, tools], input=schema, capture_output=True, check=True).stdout
    shipped = (ROOT / "python" / "stampflow" / "parts.py").read_bytes()
    assert written == shipped, "write it anew: stampflow schema | python tools/parts.py > stampflow/parts.py"
