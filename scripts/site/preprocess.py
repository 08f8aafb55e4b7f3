"""What mdBook has done to the pages: formulas become HTML, and links lead to where the site has things.

Reads the book as JSON from stdin and writes it to stdout, as mdBook asks of a preprocessor. A page outside of docs/
that a page links to becomes a chapter; other files are copied by scripts/site/finish.py.
"""

import json
import posixpath
import re
import sys
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

from lib.katex import render_formulas  # noqa: E402
from lib.markdown import LINK, line_of, prose, read_formulas  # noqa: E402

# Where the site has what lies outside of docs/.
OUTSIDE = "repository"


def chapters_of(items):
    """All chapters of a book, also those below others."""
    for item in items:
        if "Chapter" in item:
            yield item["Chapter"]
            yield from chapters_of(item["Chapter"]["sub_items"])


def place_of(name):
    """Where the site has a file of the repository."""
    return posixpath.relpath(name, "docs") if name.startswith("docs/") else posixpath.join(OUTSIDE, name)


def with_formulas(name, text):
    """The text of a page with its formulas as HTML; a formula that KaTeX does not know ends the build."""
    formulas = read_formulas(text)
    pieces, end, wrong = [], 0, []
    for formula, (html, error) in zip(formulas, render_formulas(formulas), strict=True):
        if error:
            wrong.append(f"{name}:{line_of(text, formula.start)}: {error}")
        pieces += [text[end : formula.start], html or ""]
        end = formula.end
    if wrong:
        sys.exit("\n".join(wrong))
    return "".join([*pieces, text[end:]])


def with_links(name, text):
    """The text of a page with its links as the site needs them, and the files outside of docs/ that they lead to."""
    outside, pieces, end = [], [], 0
    for match in LINK.finditer(prose(text)):
        target = text[match.start("target") : match.end("target")]
        path, sign, anchor = target.partition("#")
        if not path or re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue
        file = posixpath.normpath(posixpath.join(posixpath.dirname(name), unquote(path)))
        if name.startswith("docs/") and file.startswith("docs/"):
            continue
        if not file.startswith("docs/"):
            outside.append(file)
        new = posixpath.relpath(place_of(file), posixpath.dirname(place_of(name)))
        pieces += [text[end : match.start("target")], new + sign + anchor]
        end = match.end("target")
    return "".join([*pieces, text[end:]]), outside


def chapter(name, text):
    """A chapter without a number for a page outside of docs/, under the name of its file."""
    return {
        "Chapter": {
            "name": name.removesuffix(".md"),
            "content": text,
            "number": None,
            "sub_items": [],
            "path": place_of(name),
            "source_path": None,
            "parent_names": [],
        }
    }


def main():
    """Answers mdBook."""
    if sys.argv[1:2] == ["supports"]:
        sys.exit(sys.argv[2] != "html")
    _, book = json.load(sys.stdin)
    linked = []
    for page in chapters_of(book["items"]):
        name = posixpath.join("docs", page["source_path"])
        page["content"], outside = with_links(name, with_formulas(name, page["content"]))
        linked += outside
    seen, added = set(), []
    while linked:
        name = linked.pop(0)
        if name.endswith(".md") and name not in seen:
            seen.add(name)
            text, outside = with_links(name, with_formulas(name, (ROOT / name).read_text(encoding="utf-8")))
            added.append(chapter(name, text))
            linked += outside
    if added:
        book["items"] += [{"PartTitle": "The repository"}, *added]
    json.dump(book, sys.stdout)


if __name__ == "__main__":
    main()
