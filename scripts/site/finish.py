"""Completes the site that mdBook built, and checks it: `finish.py SITE`.

Copies what mdBook does not know: the style and the fonts of KaTeX, and files outside of docs/ that pages link to. Then
every link of every page must lead to a file and an anchor of the site, and nothing may be loaded from elsewhere.
"""

import posixpath
import shutil
import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).parents[2]
KATEX = ROOT / ".tools/site/node_modules/katex/dist"
OUTSIDE = "repository/"
# Pages that mdBook writes for itself: one for servers, one to print.
APART = ("404.html", "print.html", "toc.html")


class Page(HTMLParser):
    """The links, the parts that are loaded, and the anchors of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        """Notes what a tag refers to or names."""
        attributes = dict(attributes)
        if attributes.get("id"):
            self.anchors.add(attributes["id"])
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        elif tag in ("link", "script", "img"):
            self.loaded.append(attributes.get("href" if tag == "link" else "src") or "")


def check_page(site, name, read):
    """A message for each wrong link of a page; copies the files that are missing."""
    page = read(name)
    wrong = [f"{name}: loads {address}" for address in page.loaded if urlsplit(address).netloc]
    for link in page.links + page.loaded:
        address = urlsplit(link)
        if address.scheme or address.netloc:
            continue
        target = posixpath.normpath(posixpath.join(posixpath.dirname(name), unquote(address.path)))
        target = target if address.path else name
        source = ROOT / target.removeprefix(OUTSIDE)
        if target.startswith(OUTSIDE) and source.is_file() and not (site / target).exists():
            (site / target).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, site / target)
        elif target.startswith(OUTSIDE) and source.is_dir():
            (site / target).mkdir(parents=True, exist_ok=True)
            list_directory(source, site / target)
        if not (site / target).exists():
            wrong.append(f"{name}: no {target}")
        elif target.endswith(".html") and unquote(address.fragment) not in read(target).anchors:
            wrong.append(f"{name}: no anchor {address.fragment} in {target}")
    return wrong


def list_directory(source, target):
    """A page with the files of a directory, as text, in place of the list that a forge would show."""
    names = sorted(path.name for path in source.iterdir() if path.is_file())
    for name in names:
        shutil.copy(source / name, target / name)
    items = "\n".join(f'<li><a href="{name}">{name}</a></li>' for name in names)
    title = f"<title>{source.name}</title>"
    (target / "index.html").write_text(f"<!doctype html>\n{title}\n<ul>\n{items}\n</ul>\n", encoding="utf-8")


def main():
    """Says what is wrong and exits with 1 if something is."""
    site = Path(sys.argv[1])
    (site / "katex").mkdir(exist_ok=True)
    shutil.copy(KATEX / "katex.min.css", site / "katex")
    shutil.copytree(KATEX / "fonts", site / "katex/fonts", dirs_exist_ok=True)

    @cache
    def read(name):
        return Page(site / name)

    names = [path.relative_to(site).as_posix() for path in sorted(site.rglob("*.html"))]
    pages = [name for name in names if name not in APART]
    wrong = [message for name in pages for message in check_page(site, name, read)]
    if wrong:
        sys.exit("\n".join(wrong))
    print(f"{len(pages)} pages, every link leads somewhere")


if __name__ == "__main__":
    main()
