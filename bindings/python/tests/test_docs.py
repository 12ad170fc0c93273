"""What is written for users runs."""

from __future__ import annotations

import contextlib
import io
import os
import re
import shutil
from pathlib import Path

import pytest
from conftest import ROOT

PAGE = ROOT / "docs" / "python.md"
NOTEBOOKS = sorted((ROOT / "bindings" / "python" / "notebooks").glob("*.ipynb"))


def test_the_page_of_the_book_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Snippets run one after the other; below each stands what it prints. UPDATE=1 writes that."""
    for folder in ("cases", "reference_data", "tests/drawings"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text(encoding="utf-8")
    names: dict[str, object] = {}

    def run(snippet: re.Match[str]) -> str:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(snippet[1], names)
        shown = f"\n\n```text\n{out.getvalue()}```" if out.getvalue() else ""
        return f"```python\n{snippet[1]}```{shown}"

    computed, count = re.subn(r"```python\n(.*?)```(?:\n\n```text\n.*?```)?", run, text, flags=re.DOTALL)
    assert count > 5
    if os.environ.get("UPDATE"):
        PAGE.write_text(computed, encoding="utf-8")
    assert os.environ.get("UPDATE") or computed == text


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_shows_its_pictures(path: Path) -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": path.parent}}).execute()
    shown = {kind for cell in notebook.cells for output in cell.get("outputs", []) for kind in output.get("data", {})}
    assert shown & {"image/svg+xml", "image/png"}
