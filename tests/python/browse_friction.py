"""Opens pages of `stribeck report` that begin with a friction curve, and compares the curve with results.h5.

    python tests/python/browse_friction.py (PAGE RESULTS_DIR)...

Any difference ends it with an error.
"""

import sys
from pathlib import Path

import numpy as np
import xarray as xr

from chromium import launched, read_number, window

# Texts of an axis, and those of them that overlap a title.
AXIS_TEXTS = """() => {
    const plot = document.getElementById("friction");
    const boxes = name => [...plot.querySelectorAll(name)].map(it => it.getBoundingClientRect());
    const overlap = (a, b) => Math.min(a.right, b.right) > Math.max(a.left, b.left)
        && Math.min(a.bottom, b.bottom) > Math.max(a.top, b.top);
    const titles = boxes(".xtitle, .ytitle");
    const ticks = [...plot.querySelectorAll(".xtick text, .ytick text")];
    const hit = ticks.filter(it => titles.some(title => overlap(it.getBoundingClientRect(), title)));
    return [ticks.map(it => it.textContent), hit.map(it => it.textContent)];
}"""
# Half a bar over the height of the curves from which on it is drawn.
VISIBLE = 0.005


def slide_roll(data):
    """The slide-to-roll ratio S of a sweep that has one."""
    return float(data.slide_roll_ratio) / 2 if "slide_roll_ratio" in data else 1.0


def see_sum(page, data):
    """The piled parts reach up to the drag, and each is as thick as its column says."""
    traces = page.evaluate("document.getElementById('friction').data")
    tops = [np.array(trace["y"], dtype=float) for trace in traces[:3]]
    drag = next(trace for trace in traces if trace.get("name") == "drag μ_drag")
    places = [data[name].values.ravel() for name in ("mu_drag", "mu_v_flat", "mu_shear", "mu_pressure")]
    mu_drag, mu_v_flat, mu_shear, mu_pressure = places
    sum_of_parts = [mu_v_flat, slide_roll(data) * mu_shear, -mu_pressure]
    assert np.allclose(drag["y"], mu_drag, rtol=1e-5)
    assert np.allclose(tops, np.cumsum(sum_of_parts, axis=0), rtol=1e-4, atol=1e-6 * mu_drag.max())
    assert np.allclose(tops[-1], mu_drag, rtol=1e-4), "the parts do not add up to the drag"
    return drag


def bars(trace):
    """Which points of a curve have error bars."""
    return [one is not None for one in trace["error_y"]["array"]]


def see_no_bars(page, data, drag):
    """The errors of the drag are narrower than its line, and said in words."""
    errors = (data.error_mu_drag * abs(data.mu_drag)).values
    assert 0 < np.nanmax(errors) < VISIBLE * np.nanmax(data.mu_drag)
    assert not any(bars(drag))
    said = page.inner_text("#friction-errors")
    share = said.removeprefix("Estimated errors are too small to be seen: at most ").removesuffix(" %.")
    assert np.isclose(read_number(share) / 100, np.nanmax(errors) / np.nanmax(data.mu_drag), rtol=0.06), said


def see_bars(page, data):
    """Bars of c stand where half a bar is wider than a line, and nowhere else; True if there are some."""
    page.select_option("#quantity", "c")
    page.wait_for_function("document.body.dataset.drawn === 'all'")
    c = data.c.values.ravel()
    half = data.error_c.values.ravel() * c
    if c.max() > 30 * c.min():
        half, c = np.log10(1 + half / c), np.log10(c)
    expected = half > VISIBLE * np.ptp(c)
    drawn = bars(page.evaluate("document.getElementById('curve-beta').data.find(it => it.error_y?.array)"))
    assert drawn == expected.tolist(), (drawn, half)
    words = "Bars are estimated errors" if expected.any() else "too small to be seen"
    assert words in page.inner_text("#curve-errors")
    return expected.any()


def see_axes(page, data):
    """In laboratory units ticks bear units with prefixes; titles are clear of all ticks."""
    ticks, hit = page.evaluate(AXIS_TEXTS)
    assert hit == [], hit
    if "stribeck_dimensions" in data.attrs:
        speeds = [tick for tick in ticks if "m/s" in tick]
        assert len(speeds) > 1 and all("10" not in tick or "⁻" not in tick for tick in speeds), ticks


def main():
    """Looks at each page on a desktop and on a phone."""
    with_bars = []
    paths = [Path(argument) for argument in sys.argv[1:]]
    with launched() as chromium:
        for path, results in zip(paths[::2], paths[1::2], strict=True):
            data = xr.open_dataset(results / "results.h5", engine="h5netcdf")
            for width, height in [(1280, 900), (390, 844)]:
                with window(chromium, width, height) as watched:
                    watched.open(path)
                    page = watched.page
                    first = "[...document.querySelectorAll('main > section')].find(it => it.checkVisibility()).id"
                    assert page.evaluate(first) == "friction-section"
                    see_no_bars(page, data, see_sum(page, data))
                    see_axes(page, data)
                    with_bars.append(see_bars(page, data))
                    top = "id => document.getElementById(id).getBoundingClientRect().bottom + scrollY"
                    assert page.evaluate(top, "friction") < page.evaluate(top, "numbers")
                    watched.expect_peace()
    assert any(with_bars) and not all(with_bars), "both are to be seen: bars, and errors too small for them"
    print("every friction curve is the sum of its parts")


if __name__ == "__main__":
    main()
