"""Notebooks: `docs/tutorial.ipynb` runs, and what is stored of its outputs is small; a run shows how far it is."""

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


def test_a_run_in_a_notebook_shows_how_far_it_is(tmp_path):
    (tmp_path / "small.toml").write_text("[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [10.0, 20.0, 30.0]\n")
    cell = nbformat.v4.new_code_cell("import stribeck\nstribeck.run('small.toml', 'out');")
    run = nbformat.v4.new_notebook(cells=[cell])
    nbclient.NotebookClient(
        run, timeout=60, kernel_name="python3", resources={"metadata": {"path": tmp_path}}
    ).execute()
    shown = "".join(output.get("text", "") for output in run.cells[0].outputs)
    assert "3/3" in shown and "case" in shown, run.cells[0].outputs
