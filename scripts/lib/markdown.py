"""What the tests of the documentation and its site read of a page: fences, links, anchors and formulas."""

import re
import unicodedata
from dataclasses import dataclass

FENCE = re.compile(r"^(?P<indent>[ >]*)(?P<ticks>`{3,}|~{3,})[ ]*(?P<info>[^`]*)$")
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
CODE = re.compile(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)", re.DOTALL)
HEADING = re.compile(r"^ {0,3}(#{1,6})[ \t]+(.*?)[ \t]*#*[ \t]*$")
# [text](target "title"), where the target may hold one pair of brackets; images too.
LINK = re.compile(r"\]\(\s*<?(?P<target>[^\s()<>]*(?:\([^\s()]*\)[^\s()<>]*)*)>?(?:\s+(?:\"[^\"]*\"|'[^']*'))?\s*\)")
DEFINITION = re.compile(r"^ {0,3}\[[^\]]+\]:[ \t]*<?(?P<target>[^\s>]+)", re.MULTILINE)
ATTRIBUTE = re.compile(r"<[a-zA-Z][^>]*?\s(?:href|src)=\"(?P<target>[^\"]*)\"", re.DOTALL)
ANCHOR = re.compile(r"<[a-zA-Z][^>]*?\s(?:id|name)=\"([^\"]*)\"", re.DOTALL)
DISPLAY = re.compile(r"(?<![\\$])\$\$(?P<formula>[^$]+?)\$\$(?!\$)", re.DOTALL)
INLINE = re.compile(r"(?<![\\$\w])\$(?P<formula>[^\s$](?:[^$]*?[^\s$\\])?)\$(?![\w$])", re.DOTALL)


@dataclass(frozen=True)
class Fence:
    """A block between fences. Lines count from 1; `line` is that of the opening fence, `end` that of the closing."""

    line: int
    end: int
    language: str
    options: tuple[str, ...]
    lines: tuple[str, ...]

    @property
    def text(self):
        """The block without its fences."""
        return "\n".join(self.lines) + "\n"


@dataclass(frozen=True)
class Formula:
    """A formula of a page: where it is, with its dollars, and what stands between them."""

    start: int
    end: int
    source: str
    display: bool


def read_fences(text):
    """The fenced blocks of a page, in order. A fence that is not closed is an error."""
    fences, opened = [], None
    for number, line in enumerate(text.splitlines(), start=1):
        match = FENCE.match(line)
        if opened is None:
            if match:
                opened = (number, match, [])
            continue
        first, opening, lines = opened
        if match and not match["info"].strip() and match["ticks"].startswith(opening["ticks"]):
            language, *options = re.split(r"[,\s]+", opening["info"].strip())
            fences.append(Fence(first, number, language, tuple(options), tuple(lines)))
            opened = None
        else:
            indent = len(opening["indent"])
            lines.append(line[indent:] if not line[:indent].strip() else line.lstrip())
    if opened is not None:
        raise ValueError(f"line {opened[0]}: this fence is not closed")
    return fences


def blank(text, *patterns):
    """The text with all that matches a pattern made into spaces, so that places stay where they are."""
    for pattern in patterns:
        text = pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    return text


def prose(text, *, code=False):
    """The text of a page without fenced blocks and comments, and unless `code` is asked for without `code`."""
    lines = text.splitlines()
    for fence in read_fences(text):
        for number in range(fence.line - 1, fence.end):
            lines[number] = " " * len(lines[number])
    text = blank("\n".join(lines), COMMENT)
    return text if code else blank(text, CODE)


def line_of(text, place):
    """The number of the line that holds a place of a text."""
    return text.count("\n", 0, place) + 1


def read_links(text):
    """The line and the target of each link and picture of a page."""
    text = prose(text)
    # `code` in the text of a link is blank by now; its brackets are not.
    found = [match for pattern in (LINK, DEFINITION, ATTRIBUTE) for match in pattern.finditer(text)]
    return [(line_of(text, match.start("target")), match["target"]) for match in sorted(found, key=re.Match.start)]


def read_headings(text):
    """The line, the level and the text of each heading."""
    found = []
    for number, line in enumerate(prose(text, code=True).splitlines(), start=1):
        match = HEADING.match(line)
        if match:
            found.append((number, len(match[1]), match[2]))
    return found


def slug(heading):
    """The anchor of a heading: small letters, digits, `-` and `_`; a space is a `-`, and all else goes."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"(?<![\w`])_([^_`]+)_(?![\w`])", r"\1", text)
    kept = []
    for letter in text.strip().lower():
        category = unicodedata.category(letter)
        if letter == " ":
            kept.append("-")
        elif letter == "-" or category[0] in "LM" or category in ("Nd", "Pc"):
            kept.append(letter)
    return "".join(kept)


def read_anchors(text):
    """All anchors of a page: those of its headings, which are numbered where they repeat, and those of its tags."""
    anchors = set(ANCHOR.findall(prose(text)))
    seen = {}
    for _, _, heading in read_headings(text):
        name = slug(heading)
        count = seen.get(name, 0)
        seen[name] = count + 1
        anchors.add(f"{name}-{count}" if count else name)
    return anchors


def read_formulas(text):
    """The formulas of a page, in order."""
    outside = prose(text)
    found = [
        Formula(*match.span(), text[match.start("formula") : match.end("formula")], display=True)
        for match in DISPLAY.finditer(outside)
    ]
    outside = blank(outside, DISPLAY)
    found += [
        Formula(*match.span(), text[match.start("formula") : match.end("formula")], display=False)
        for match in INLINE.finditer(outside)
    ]
    return sorted(found, key=lambda formula: formula.start)
