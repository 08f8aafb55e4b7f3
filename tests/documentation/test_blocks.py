"""Every block of `sh` and `python` in README.md and docs/ runs as it stands, one page after the other."""

import shutil
import tempfile
import time
from pathlib import Path

import pytest

from commands import PATH
from lib.markdown import read_fences
from pages import ROOT, Directories, copy_files, executed_pages, is_run, run_page, tracked, wrong_fences

PAGES = executed_pages()


@pytest.fixture(scope="session")
def caches(tmp_path_factory):
    """Where the pages share what takes seconds to make: the list of fonts of matplotlib."""
    return tmp_path_factory.mktemp("caches")


@pytest.mark.parametrize("page", PAGES)
def test_the_fences_of_a_page_are_known(page):
    """A block that says something else than these few words would be run by nobody."""
    wrong = wrong_fences((ROOT / page).read_text(encoding="utf-8"))
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("page", PAGES)
def test_the_blocks_of_a_page_run(page, caches, took):
    """In a copy of the repository, with the program that is installed beside this interpreter."""
    text = (ROOT / page).read_text(encoding="utf-8")
    if not any(map(is_run, read_fences(text))):
        return
    assert shutil.which("stribeck", path=PATH), "install the package first: pip install ."
    # Not in a directory of pytest, which would keep the copies.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        directories = Directories(Path(place, "repository"), Path(place, "work"), caches)
        directories.work.mkdir()
        copy_files(ROOT, tracked(), directories.repository)
        begin = time.monotonic()
        try:
            run_page(page, text, directories)
        finally:
            took(page, time.monotonic() - begin)
