"""What the wheel brings."""

from __future__ import annotations

from importlib.metadata import files, metadata


def test_the_licences_are_there() -> None:
    """Both licences of the program, and that of the font in its pictures."""
    shipped = {file.name: file.read_text() for file in files("stampflow") or [] if "licenses" in file.parts}
    assert shipped.keys() == {"LICENSE-APACHE", "LICENSE-MIT", "LICENSE-DejaVuSans.txt"}
    assert "Apache License" in shipped["LICENSE-APACHE"] and "Permission is hereby granted" in shipped["LICENSE-MIT"]
    assert "Bitstream" in shipped["LICENSE-DejaVuSans.txt"]
    assert metadata("stampflow")["License-Expression"] == "MIT OR Apache-2.0"


def test_nothing_else_is_there() -> None:
    names = {file.parts[0] for file in files("stampflow") or []}
    assert all(name == "stampflow" or name.endswith(".dist-info") for name in names), names
