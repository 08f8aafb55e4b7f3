"""Opens a page of `stribeck report` of any sweep in Chromium: every picture that is shown is drawn, and what is missing is said.

    python tests/python/browse_any_report.py PAGE [SENTENCE...]

Each sentence must stand in the page at some f, to be seen. Any difference ends it with an error.
"""

import sys
from pathlib import Path

from chromium import browser

# Pictures that are shown without anything drawn in them.
EMPTY = """() => [...document.querySelectorAll(".plot")].filter(plot => plot.checkVisibility() && !plot.querySelector(".main-svg")).map(plot => plot.id)"""
# Sections with a heading and nothing else.
SILENT = """() => [...document.querySelectorAll("section")].filter(section => section.innerText.trim() === section.querySelector("h2").innerText.trim()).map(section => section.id)"""


def main():
    path, sentences = Path(sys.argv[1]), sys.argv[2:]
    for width, height in [(1280, 900), (390, 844)]:
        with browser(width, height) as watched:
            watched.open(path)
            page = watched.page
            text = page.inner_text("body")
            assert page.evaluate(EMPTY) == []
            assert page.evaluate(SILENT) == []
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            watched.screenshot(f"any-{width}-{path.parent.parent.parent.name}")
            if width < 600:
                watched.expect_peace()
                continue
            # Every quantity can be chosen, and every value of f; on a phone that is no different.
            for value in page.eval_on_selector_all("#quantity option", "options => options.map(option => option.value)"):
                page.select_option("#quantity", value)
                assert page.evaluate(EMPTY) == [], value
                assert page.evaluate(SILENT) == [], value
            if page.is_visible("#f-slider"):
                page.focus("#f-slider")
                for key in ["Home"] + int(page.get_attribute("#f-slider", "max")) * ["ArrowRight"]:
                    page.keyboard.press(key)
                    assert page.evaluate(EMPTY) == []
                    text += page.inner_text("body")
            for sentence in sentences:
                assert sentence in text, (sentence, text)
            watched.expect_peace()
    print("every picture shown is drawn")


if __name__ == "__main__":
    main()
