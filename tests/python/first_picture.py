"""Measures how long a page of `stribeck report` takes to its first picture, and looks at that picture.

    python tests/python/first_picture.py PAGE...

Each page is loaded five times; printed is the median of the seconds from the start of the load until the picture is
painted, and until the live picture that takes its place is drawn. The picture must be there without any script, before
the live one, and where the live one is afterwards. Any difference ends it with an error.
"""

import sys
from pathlib import Path
from statistics import median

from chromium import launched, window

LOADS = 5

# Marks the moment behind the first frame that is made with the picture in the page.
WATCH = """
new MutationObserver((_, observer) => {
    if (!document.querySelector(".first + .plot")) return;
    observer.disconnect();
    requestAnimationFrame(() => setTimeout(() => performance.mark("first picture")));
}).observe(document, { childList: true, subtree: true });
"""
# When that frame was made, when the first frame of all was on the screen, and when the live picture was drawn.
MOMENTS = """["first picture", "first-contentful-paint", "first live picture"].map(
    name => performance.getEntriesByName(name)[0].startTime / 1000)"""
# The box of the picture that is shown, and how many lines and cells it has.
LOOK = """() => {
    const shown = [...document.querySelectorAll(".first svg")].filter(it => it.checkVisibility());
    const { x, y, width, height } = shown[0].getBoundingClientRect();
    return [shown.length, shown[0].querySelectorAll("polyline, rect").length, [x, y, width, height].map(Math.round)];
}"""
# The box of the live picture that stands where the first one stood.
LIVE = """() => {
    const live = [...document.querySelectorAll("#friction, #map")].find(it => it.checkVisibility());
    const { x, y, width, height } = live.getBoundingClientRect();
    return [x, y, width, height].map(Math.round);
}"""


def see_without_scripts(chromium, path, size):
    """The picture is there, the one that fits the window, with its shapes, and has about the size of the live one."""
    context = chromium.new_context(
        viewport=dict(zip(("width", "height"), size, strict=True)), java_script_enabled=False
    )
    page = context.new_page()
    page.goto(path.resolve().as_uri())
    shown, shapes, box = page.evaluate(LOOK)
    assert shown == 1 and shapes > 10, (shown, shapes)
    assert box[2] > 0.3 * size[0] and box[3] > 300, box
    context.close()


def load(chromium, path, size):
    """Loads the page; when its first picture was there and when the live one."""
    with window(chromium, *size) as watched:
        watched.page.add_init_script(WATCH)
        watched.open(path)
        made, shown, live = watched.page.evaluate(MOMENTS)
        assert made < live, ("the first picture waits for the drawing library", made, live)
        watched.expect_peace()
    return max(made, shown), live


def stay(chromium, path, size):
    """The live picture stands where the first one stood when words had been filled in."""
    with window(chromium, *size) as watched:
        # The box in the last frame that has the picture.
        watched.page.add_init_script(f"""const watch = () => {{
            const shown = [...document.querySelectorAll(".first svg")].some(it => it.checkVisibility());
            if (shown) window.boxes = ({LOOK})()[2];
            if (shown || !window.boxes) requestAnimationFrame(watch);
        }};
        requestAnimationFrame(watch);""")
        watched.open(path)
        assert watched.page.query_selector(".first") is None, "the first picture still stands before the live one"
        before, after = watched.page.evaluate("window.boxes"), watched.page.evaluate(LIVE)
        assert before == after, (before, after)


def main():
    """Measures each page named on the command line."""
    with launched() as chromium:
        for path in map(Path, sys.argv[1:]):
            for size in [(1400, 900), (390, 844)]:
                see_without_scripts(chromium, path, size)
                stay(chromium, path, size)
            first, live = zip(*(load(chromium, path, (1400, 900)) for _ in range(LOADS)), strict=True)
            print(f"{path}: first picture after {median(first):.2f} s, the live one after {median(live):.2f} s")


if __name__ == "__main__":
    main()
