"""The notebooks of examples/ run from their first cell to their last, with the assertions that they hold."""
import nbformat
import pytest
from conftest import ROOT
from nbclient import NotebookClient

NOTEBOOKS = sorted((ROOT / "examples").glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path):
    notebook = nbformat.read(path, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert not any(cell.outputs for cell in cells), "outputs are left out of the repository"
    assert any("assert " in cell.source for cell in cells)
    NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": path.parent}}).execute()
    assert any("text/html" in output.get("data", {}) or output.get("text") for cell in cells for output in cell.outputs)


def test_there_are_notebooks():
    assert len(NOTEBOOKS) == 3
