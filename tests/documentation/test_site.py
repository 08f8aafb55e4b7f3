"""What the site makes of links: it has the pages of docs/ at its root and all else below `repository/`."""

import importlib.util

import pytest

from pages import ROOT

pytestmark = pytest.mark.usefixtures("packages")


@pytest.fixture(scope="module")
def preprocess():
    """The preprocessor of mdBook."""
    spec = importlib.util.spec_from_file_location("preprocess", ROOT / "scripts/site/preprocess.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("page", "link", "on_site", "outside"),
    [
        ("docs/how-to/fit.md", "../reference/output.md#columns", "../reference/output.md#columns", []),
        ("docs/how-to/fit.md", "#bounds", "#bounds", []),
        ("docs/how-to/fit.md", "https://example.org/sweeps", "https://example.org/sweeps", []),
        ("docs/how-to/fit.md", "../../sweeps/a.toml", "../repository/sweeps/a.toml", ["sweeps/a.toml"]),
        ("docs/index.md", "../README.md#install", "repository/README.md#install", ["README.md"]),
        ("README.md", "docs/how-to/fit.md#bounds", "../how-to/fit.md#bounds", []),
        ("README.md", "LICENSE-MIT", "LICENSE-MIT", ["LICENSE-MIT"]),
    ],
)
def test_links_lead_to_where_the_site_has_things(preprocess, page, link, on_site, outside):
    """And the files outside of docs/ are known, which the site needs too."""
    text = preprocess.with_links(page, f"See [this]({link}), not `[that]({link})`.")
    assert text == (f"See [this]({on_site}), not `[that]({link})`.", outside)


def test_formulas_mean_nothing_to_markdown(preprocess):
    """Also in tables, and on one line."""
    text = preprocess.with_formulas("page.md", "| $\\sqrt{|x|}\\cdot a_*$ | `$b$` |\n")
    assert "annotation" not in text and text.count("\n") == 1 and text.endswith(" | `$b$` |\n")
    assert not set("*_[$") & set(text.removesuffix(" | `$b$` |\n"))


def test_a_formula_that_is_wrong_ends_the_build(preprocess):
    """With its page and line."""
    with pytest.raises(SystemExit, match=r"page.md:2: .*Undefined control sequence"):
        preprocess.with_formulas("page.md", "one\n$\\nosuch$\n")
