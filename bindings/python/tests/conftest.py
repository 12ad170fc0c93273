"""Paths and the program that the tests share."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
CASES = sorted((ROOT / "cases").glob("*.toml"))
QUICKSTART = ROOT / "cases" / "quickstart.toml"


@pytest.fixture(scope="session")
def program() -> str:
    """The command line: STAMPFLOW, or the one that was built in this checkout."""
    built = ROOT / "target" / "release" / "stampflow"
    found = os.environ.get("STAMPFLOW") or (str(built) if built.exists() else shutil.which("stampflow"))
    if not found:
        pytest.skip("no stampflow: build it, or name it with STAMPFLOW")
    return found
