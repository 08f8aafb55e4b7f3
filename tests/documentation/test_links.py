"""Links between pages: files and anchors exist, the summary of the site has every page, each page says its kind."""

import posixpath
import re
from functools import cache
from urllib.parse import unquote

import pytest

from lib.markdown import prose, read_anchors, read_headings, read_links
from pages import ROOT, executed_pages, tracked

PAGES = [name for name in tracked() if name.endswith(".md")]
SUMMARY = "docs/SUMMARY.md"
DOCUMENTS = [name for name in executed_pages() if name not in ("README.md", SUMMARY)]
KINDS = {"docs/how-to/": "How-to", "docs/reference/": "Reference", "docs/explanation/": "Explanation"}
COLUMNS = 120
README_LINES = 120


@cache
def read(page):
    """The text of a page."""
    return (ROOT / page).read_text(encoding="utf-8")


@cache
def places():
    """All files of the repository and the directories that hold them."""
    names = set(tracked())
    return names | {name[: match.start()] for name in names for match in re.finditer("/", name)} | {"."}


def wrong_links(page):
    """A message for each link of a page that leads nowhere."""
    wrong = []
    for line, target in read_links(read(page)):
        if re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue
        path, _, anchor = unquote(target).partition("#")
        file = posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
        if file not in places():
            wrong.append(f"{page}:{line}: there is no {file}")
        elif anchor and not file.endswith(".md"):
            wrong.append(f"{page}:{line}: {file} is no page and has no anchors")
        elif anchor and anchor not in read_anchors(read(file)):
            wrong.append(f"{page}:{line}: {file} has no anchor {anchor}")
    return wrong


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_to_files_and_anchors_that_exist(page):
    """Of every page in the repository, by the forge's rule of anchors."""
    wrong = wrong_links(page)
    assert not wrong, "\n".join(wrong)


def test_the_summary_of_the_site_has_every_page_once():
    """A page that is not in it would not be on the site."""
    listed = [posixpath.normpath(posixpath.join("docs", target)) for _, target in read_links(read(SUMMARY))]
    assert sorted(listed) == sorted(DOCUMENTS)


@pytest.mark.parametrize("page", DOCUMENTS)
def test_a_page_says_its_kind(page):
    """In the first line under its title, in one sentence."""
    kind = next((kind for place, kind in KINDS.items() if page.startswith(place)), r"\w+")
    lines = [line for line in read(page).splitlines() if line.strip()]
    assert re.match(r"# \S", lines[0])
    assert page == "docs/index.md" or re.match(rf"\*{kind}\.\* \S", lines[1]), lines[1]


@pytest.mark.parametrize("page", DOCUMENTS)
def test_headings_have_the_same_anchors_everywhere(page):
    """Formulas make other anchors on the site than on a forge."""
    wrong = [f"{page}:{line}: {heading}" for line, _, heading in read_headings(read(page)) if "$" in heading]
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("page", [*executed_pages(), "CONTRIBUTING.md"])
def test_lines_are_short(page):
    """All but tables, code, formulas and what cannot be broken."""
    lines = prose(read(page), code=True).splitlines()
    long = [
        f"{page}:{number}: {len(line)} columns"
        for number, line in enumerate(lines, start=1)
        if len(line) > COLUMNS and not line.lstrip().startswith(("|", "$$", "![")) and " " in line.strip()
    ]
    assert not long, "\n".join(long)


def test_the_readme_is_short():
    """It is the front door; all else is in docs/."""
    assert len(read("README.md").splitlines()) <= README_LINES
