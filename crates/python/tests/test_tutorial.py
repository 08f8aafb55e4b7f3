"""The notebook `docs/tutorial.ipynb`: it runs, and what is stored of its outputs is small."""

from pathlib import Path

import nbclient
import nbformat

NOTEBOOK = Path(__file__).parents[3] / "docs/tutorial.ipynb"


def pictures(notebook):
    """The number of pictures under each cell."""
    outputs = [cell.get("outputs", []) for cell in notebook.cells]
    return [sum("image/png" in output.get("data", {}) for output in outputs) for outputs in outputs]


def test_the_tutorial_runs_and_shows_what_is_stored():
    stored = nbformat.read(NOTEBOOK, as_version=4)
    run = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(run, timeout=60, kernel_name="python3").execute()
    assert pictures(run) == pictures(stored) and sum(pictures(run)) == 6
    said = [[output.text for output in cell.get("outputs", []) if "text" in output] for cell in run.cells]
    assert said == [[output.text for output in cell.get("outputs", []) if "text" in output] for cell in stored.cells]
    assert NOTEBOOK.stat().st_size < 200_000
