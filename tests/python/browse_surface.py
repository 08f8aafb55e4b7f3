"""Opens pages of `stribeck report` that have a surface, and compares what they say with `stribeck evaluate`.

    python tests/python/browse_surface.py PROGRAM (PAGE SURFACE)...

Any difference ends it with an error.
"""

import csv
import io
import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from browse_report import COLLISIONS
from chromium import launched, read_number, window

# What a slider's move may take of the processor, in millions of logarithms and exponentials.
MOST = 8

PREFIXES = {"": 1, "n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6}


def in_unit(text, units):
    """The number that the page writes with a unit: 5 mm/s, 0.72 a₀/R."""
    number, _, unit = text.replace("\u00a0", " ").partition(" ")
    scale = 1 if units == "1" else next(one for prefix, one in PREFIXES.items() if prefix + units == unit)
    return float(f"{read_number(number) * scale:.14g}")


def mapped(axis, x):
    """Values of an axis in the coordinate in which the surface is smooth (docs/reference/surface-file.md)."""
    if axis["map"] != "compact":
        return np.log(x) if axis["map"] == "log" else x
    with np.errstate(divide="ignore"):
        return 1 / (1 + (axis["center"] / x) ** 0.25)


@dataclass
class Visit:
    """A page that is looked at, and the surface that it shows."""

    watched: Any
    program: str
    surface: Path

    @property
    def page(self):
        """The page in the browser."""
        return self.watched.page

    @property
    def file(self):
        """The file of the surface."""
        return json.loads(self.surface.read_text(encoding="utf-8"))

    def evaluate(self, points):
        """The quantities at points by the program, a list of numbers for each."""
        names = [axis["name"] for axis in self.file["axes"]]
        table = io.StringIO()
        csv.writer(table).writerows([names, *points])
        path = self.surface.with_name("points.csv")
        path.write_text(table.getvalue(), encoding="utf-8")
        command = [self.program, "evaluate", str(self.surface), "--points", str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        rows = list(csv.DictReader(done.stdout.splitlines()))
        return {q["name"]: np.array([float(row[q["name"]]) for row in rows]) for q in self.file["quantities"]}

    def shown(self):
        """Waits until the page shows what was chosen."""
        self.page.wait_for_function("document.getElementById('live').dataset.shown === 'all'")

    def point(self):
        """The point that stands in the fields."""
        fields = [(self.page.input_value(f"#live-{axis['name']}-value"), axis["units"]) for axis in self.file["axes"]]
        return [in_unit(*field) for field in fields]

    def choose(self, name, value):
        """Chooses of a list."""
        self.page.select_option(f"#live-{name}", value)
        self.shown()

    def write(self, axis, text):
        """Writes a value into a field."""
        self.page.fill(f"#live-{axis}-value", text)
        self.page.keyboard.press("Enter")
        self.shown()


def expect_numbers(visit):
    """The numbers agree with the program to the digits that are printed, and stand with their errors."""
    found = visit.evaluate([visit.point()])
    rows = visit.page.eval_on_selector_all(
        "#live-values tbody tr", "rows => rows.map(row => [row.title, row.cells[1].textContent])"
    )
    order = {quantity["name"]: place for place, quantity in enumerate(visit.file["quantities"])}
    assert len(rows) == len(order)
    for title, text in rows:
        name = title.split(":")[0]
        quantity = visit.file["quantities"][order[name]]
        (value,) = found[name]
        number, error = text.replace("\u00a0", " ").split(" ± ")
        unit = error.partition(" ")[2]
        shown = in_unit(f"{number} {unit}".strip(), quantity["units"])
        least = quantity.get("share", 0) * abs(found["mu_drag"][0])
        largest = visit.file["certificate"]["errors"][order[name]]["largest"] * max(abs(value), least)
        assert np.isclose(in_unit(error, quantity["units"]), largest, rtol=0.06), (title, text, largest)
        # The last digit is below the error.
        assert abs(shown - value) <= 0.5 * largest, (name, text, value)


def expect_curve(visit):
    """The curve that is drawn has the values of the program; the points on it."""
    page = visit.page
    page.evaluate("Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true })")
    with page.expect_download() as waiting:
        page.get_by_role("button", name="copy curve of the surface as CSV").click()
    rows = list(csv.DictReader(Path(waiting.value.path()).read_text(encoding="utf-8").splitlines()))
    points = [[row[axis["name"]] for axis in visit.file["axes"]] for row in rows]
    found = visit.evaluate(points)
    for name, values in found.items():
        saved = np.array([float(row[name]) for row in rows])
        assert np.allclose(saved, values, rtol=1e-6, atol=1e-9 * np.abs(found["mu_drag"]).max()), name
    lines = page.evaluate(
        "document.getElementById('live-curve').data.filter(it => it.mode === 'lines').map(({ y }) => Array.from(y))"
    )
    friction = [name for name in found if name.startswith("mu_")]
    assert len(lines) == len(friction)
    for line in lines:
        assert any(np.allclose(line, found[name], rtol=1e-9, atol=1e-12) for name in friction), "a line of no quantity"
    ring = page.evaluate("document.getElementById('live-curve').data.find(it => it.marker?.symbol === 'circle-open').y")
    assert np.allclose(ring, visit.evaluate([visit.point()])["mu_drag"], rtol=1e-9), "the mark is at the point"
    return [[float(x) for x in point] for point in points]


def move_sliders(visit):
    """Sliders move the point, and reach both ends of each axis."""
    page = visit.page
    for place, axis in enumerate(visit.file["axes"]):
        slider = f"#live-{axis['name']}"
        page.focus(slider)
        for key, end in [("Home", axis["from"]), ("End", axis["to"])]:
            page.keyboard.press(key)
            visit.shown()
            assert np.isclose(visit.point()[place], float(end)), (axis["name"], key, visit.point())
            expect_numbers(visit)
        page.keyboard.press("ArrowLeft")
        visit.shown()
        assert page.input_value(slider) == "999", "a key moves a slider by one step"
        assert visit.point()[place] < float(axis["to"])
        page.evaluate(
            "slider => { slider.value = 613; slider.dispatchEvent(new Event('input', { bubbles: true })); }",
            page.query_selector(slider),
        )
        visit.shown()
        assert axis["from"] < visit.point()[place] < float(axis["to"])
        expect_numbers(visit)
        visit.choose("cut", axis["name"])
        points = np.array(expect_curve(visit))
        assert np.isclose(points[0, place], axis["from"]) and np.isclose(points[-1, place], float(axis["to"]))
        assert len(points) > 200 and (np.diff(np.delete(points, place, 1), axis=0) == 0).all()


def write_values(visit):
    """A value is written with its unit or without; what is no value, or outside, is said and changes nothing."""
    axis = visit.file["axes"][-1]
    name, units = axis["name"], axis["units"]
    texts = {"1": ["77", "7.7e1", "7.7·10¹"], "m/s": ["7 mm/s", "7", "7000 um/s", "0.007 m/s"]}[units]
    for text in texts:
        visit.write(name, text)
        assert np.isclose(visit.point()[-1], 77 if units == "1" else 0.007), (text, visit.point())
    expect_numbers(visit)
    before, beyond = visit.point(), axis["to"] * 2
    for text, words in [("12 furlongs", "is no value"), (f"{beyond} {units.strip('1')}", "is outside the surface")]:
        visit.write(name, text)
        assert words in visit.page.inner_text("#live-said"), text
        assert visit.page.get_attribute(f"#live-{name}-value", "aria-invalid") == "true"
    visit.page.focus(f"#live-{name}")
    visit.page.keyboard.press("ArrowRight")
    visit.page.keyboard.press("ArrowLeft")
    visit.shown()
    assert not visit.page.is_visible("#live-said")
    assert np.allclose(visit.point(), before, rtol=1e-2), (visit.point(), before)


def cut_to_pin(visit):
    """A cut goes straight from the point to the pinned one, in the coordinates of the axes."""
    page = visit.page
    page.click("#live-pin")
    pinned = visit.point()
    for axis in visit.file["axes"]:
        page.focus(f"#live-{axis['name']}")
        page.keyboard.press("Home")
    visit.shown()
    visit.choose("cut", "pin")
    points = np.array(expect_curve(visit))
    assert np.allclose(points[0], visit.point()) and np.allclose(points[-1], pinned)
    for axis, x in zip(visit.file["axes"], points.T, strict=True):
        steps = np.diff(mapped(axis, x))
        assert steps[0] > 0 and np.allclose(steps, steps[0]), ("the cut is not straight", axis["name"])
    assert page.locator("#live-values thead th").all_inner_texts()[1:] == ["here", "pinned"]


def open_link(visit, chromium):
    """The address brings the same view again, and says what is not on the surface."""
    visit.choose("scale", "log")
    page = visit.page
    page.wait_for_function("location.hash.includes('live.scale=log')")
    if page.query_selector("#quantity"):
        page.select_option("#quantity", "c")
        visit.watched.drawn()
        assert "quantity=c" in page.url and "live.scale=log" in page.url, "the surface stays where it is"
    here = """() => [
        [...document.querySelectorAll("#live input, #live select")].map(it => it.value),
        ["live-point", "live-pinned", "live-values"].map(id => document.getElementById(id).innerText),
        document.getElementById("live-curve").data.map(({ x, y }) => [Array.from(x), Array.from(y)]),
    ]"""
    with window(chromium) as other:
        other.go(page.url)
        assert other.page.evaluate(here) == page.evaluate(here), page.url
        assert not other.page.is_visible("#address") and not other.page.is_visible("#live-said")
        last = visit.file["axes"][-1]["name"]
        other.go(f"{page.url.split('#')[0]}#live.{last}=1e99&live.cut=none&live.pin=1,2,3,4&colour=red")
        other.page.wait_for_function("document.getElementById('live-said').checkVisibility()")
        said = other.page.inner_text("#live-said")
        assert all(part in said for part in (f"{last} = 1e99", "cut = none", "pin = 1,2,3,4", "the default")), said
        assert "colour = " in other.page.inner_text("#address")
        other.expect_peace()


def click_curve(visit):
    """A click on the curve goes there."""
    page, last = visit.page, visit.file["axes"][-1]
    visit.choose("cut", last["name"])
    target = page.evaluate(
        """() => {
            const picture = document.getElementById("live-curve");
            picture.scrollIntoView({ block: "center", behavior: "instant" });
            const { x, y } = picture.data.findLast(it => it.mode === "lines");
            const { xaxis, yaxis } = picture._fullLayout;
            const box = picture.getBoundingClientRect();
            return [box.left + xaxis._offset + xaxis.l2p(x[150]), box.top + yaxis._offset + yaxis.l2p(y[150]),
                (x[150] - x[0]) / (x.at(-1) - x[0])];
        }"""
    )
    page.mouse.move(*target[:2])
    page.wait_for_function("(document.getElementById('live-curve')._hoverdata ?? []).length > 0")
    before = page.inner_text("#live-point")
    page.mouse.click(*target[:2])
    page.wait_for_function("before => document.getElementById('live-point').innerText !== before", arg=before)
    visit.shown()
    ends = np.array([mapped(last, np.array(float(last[end]))) for end in ("from", "to")])
    z = mapped(last, np.array(visit.point()[-1]))
    assert np.isclose((z - ends[0]) / (ends[1] - ends[0]), target[2], atol=0.01), (visit.point(), target)
    expect_numbers(visit)


def measure_moves(visit):
    """What a slider's move takes: the median on the clock until its frame is painted, and of the processor.

    The latter is compared with arithmetic in the same page, so that a slow processor does not matter.
    """
    page, count = visit.page, 15
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def busy():
        metrics = session.send("Performance.getMetrics")["metrics"]
        return next(metric["value"] for metric in metrics if metric["name"] == "TaskDuration")

    move = """async ([id, count]) => {
        const slider = document.getElementById(id), times = [];
        for (let i = 0; i < count; i++) {
            const start = performance.now();
            slider.value = 200 + 30 * i;
            slider.dispatchEvent(new Event("input", { bubbles: true }));
            do await new Promise(then => requestAnimationFrame(() => setTimeout(then)));
            while (document.getElementById("live").dataset.shown !== "all");
            times.push(performance.now() - start);
        }
        return times;
    }"""
    arithmetic = """count => {
        let sum = 0;
        for (let i = 1; i <= 1e6 * count; i++) sum += Math.log(i) * Math.exp(-1 / i);
        return sum;
    }"""
    page.evaluate(arithmetic, 1)
    start = busy()
    page.evaluate(arithmetic, count)
    before = busy()
    clock = median(page.evaluate(move, [f"live-{visit.file['axes'][0]['name']}", count]))
    own, million = 1000 * (busy() - before) / count, 1000 * (before - start) / count
    print(
        f"a slider's move is on the screen after {clock:.0f} ms, of which the processor takes {own:.0f} ms; "
        f"for a million logarithms and exponentials it takes {million:.0f} ms"
    )
    assert own < MOST * million, f"a move takes {own:.0f} ms of the processor, arithmetic {million:.0f} ms"


def use_other_sizes(visit):
    """On a phone nothing runs off the page, and on paper nothing overlaps."""
    page = visit.page
    page.set_viewport_size({"width": 390, "height": 844})
    page.wait_for_function("document.documentElement.scrollWidth <= 390")
    visit.watched.screenshot(f"surface-phone-{visit.surface.parent.name}")
    page.set_viewport_size({"width": 717, "height": 1000})
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.evaluate(COLLISIONS, 717) == []
    assert page.evaluate("document.documentElement.scrollWidth") <= 717
    page.evaluate("dispatchEvent(new Event('afterprint'))")


def see_damage(chromium, path):
    """A page whose surface does not have the values of its check points says so, and shows all else."""
    before, mark, after = path.read_text(encoding="utf-8").partition('"checks":[{"point":[')
    first, values, rest = after.partition('"values":[')
    damaged = path.with_name("damaged.html")
    damaged.write_text(before + mark + first + values + "1" + rest, encoding="utf-8")
    with window(chromium) as watched:
        watched.open(damaged)
        said = watched.page.inner_text("#live-refused")
        assert "at check point 1 is" in said and "the file is damaged" in said, said
        assert not watched.page.is_visible("#live-body")
        watched.expect_peace()
    damaged.unlink()


def main():
    """Looks at each page as a reader would."""
    program, *paths = sys.argv[1:]
    with launched() as chromium:
        for path, surface in zip(map(Path, paths[::2]), map(Path, paths[1::2]), strict=True):
            with window(chromium, 1400, 900) as watched:
                visit = Visit(watched, program, surface)
                watched.open(path)
                move_sliders(visit)
                write_values(visit)
                measure_moves(visit)
                cut_to_pin(visit)
                open_link(visit, chromium)
                click_curve(visit)
                use_other_sizes(visit)
                watched.expect_peace()
            see_damage(chromium, path)
            print(f"{path}: friction moves as the surface says")


if __name__ == "__main__":
    main()
