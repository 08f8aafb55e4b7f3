"""Opens pages of `stribeck report` of any sweeps in one Chromium.

    python tests/python/browse_any_report.py (--page PAGE [SENTENCE...])...

Every picture that is shown must be drawn, and each sentence must be seen in its page at some f. Any difference ends it
with an error.
"""

import argparse
from pathlib import Path

from chromium import launched, window

# Pictures that are shown without anything drawn in them, and sections that have a heading and nothing else.
LACKS = """() => {
    const empty = [...document.querySelectorAll(".plot")].filter(
        plot => plot.checkVisibility() && !plot.querySelector(".main-svg"));
    const silent = [...document.querySelectorAll("section")].filter(
        section => section.innerText.trim() === section.querySelector("h2").innerText.trim());
    return [...empty, ...silent].map(element => element.id);
}"""
# Pictures whose labels along a horizontal axis lie over each other; those that are turned do not.
CROWDED = """() => [...document.querySelectorAll(".plot")].filter(plot => {
    const lies = label => !/rotate\\((?!0,)/.test(label.getAttribute("transform"));
    const labels = [...plot.querySelectorAll(".xtick text")].filter(lies);
    const boxes = labels.map(it => it.getBoundingClientRect()).sort((a, b) => a.left - b.left);
    return boxes.some((box, i) => i > 0 && box.left < boxes[i - 1].right);
}).map(plot => plot.id)"""
# Chooses each quantity, and each f, as a reader would; what each of them lacks and what the page says at each f.
CHOOSE_ALL = """async lacks => {
    const lacking = [], texts = [];
    const look = then => document.body.dataset.drawn === "all" ? then() : setTimeout(look, 5, then);
    const choose = async (control, value, event) => {
        control.value = value;
        control.dispatchEvent(new Event(event, { bubbles: true }));
        await new Promise(look);
        lacking.push(...lacks().map(id => `${id} at ${control.id} = ${value}`));
    };
    const [quantity, slider] = ["quantity", "f-slider"].map(id => document.getElementById(id));
    for (const { value } of quantity.options) await choose(quantity, value, "change");
    for (let f = 0; slider.checkVisibility() && f <= slider.max; f++) {
        await choose(slider, f, "input");
        texts.push(document.body.innerText);
    }
    return [lacking, texts];
}"""


def browse(chromium, path, sentences):
    """Looks at the page on a desktop, with each quantity and each f, and on a phone."""
    for width, height in [(1280, 900), (390, 844)]:
        with window(chromium, width, height) as watched:
            watched.open(path)
            page = watched.page
            text = page.inner_text("body")
            assert page.evaluate(LACKS) == []
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            assert page.evaluate(CROWDED) == []
            watched.screenshot(f"any-{width}-{path.parent.parent.parent.name}")
            # What can be chosen is no different on a phone.
            if width > 600:
                lacking, texts = page.evaluate(f"() => ({CHOOSE_ALL})({LACKS})")
                assert lacking == [], lacking
                text = "\n".join([text, *texts])
                for sentence in sentences:
                    assert sentence in text, (sentence, text)
            watched.expect_peace()
    print(f"{path}: every picture shown is drawn")


def main():
    """Browses each page named on the command line."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--page", action="append", nargs="+", metavar=("PAGE", "SENTENCE"), required=True)
    with launched() as chromium:
        for path, *sentences in parser.parse_args().page:
            browse(chromium, Path(path), sentences)


if __name__ == "__main__":
    main()
