"""Opens a page of `stribeck report` in Chromium, uses it as a reader would, and compares what it says with results.h5.

    python tests/python/browse_report.py PAGE RESULTS_DIR

Prints what it has seen; any difference ends it with an error.
"""

import csv
import io
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib.image
import numpy as np
import xarray as xr
from playwright.sync_api import TimeoutError

from chromium import launched, window

SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def read_number(text):
    """The number that the page writes as 0.7, 3.2·10⁻⁵, 10⁴ or ∞."""
    text = text.strip().replace("−", "-")
    if text == "∞":
        return np.inf
    mantissa, _, power = text.rpartition("10")
    if power and all(c in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹" for c in power):
        return float((mantissa.rstrip("·") or "1") + "e" + power.translate(SUPERSCRIPTS))
    return float(text)


def selected(page):
    """f, α and β of the selected case, and what is said of it."""
    text = page.inner_text("#selected")
    found = re.match(r"f = (\S+), α = (\S+), β = (\S+): (.*)", text)
    assert found, text
    return tuple(read_number(part) for part in found.groups()[:3]), found[4]


def number_of(page, symbol):
    """A number of the selected case, by its symbol."""
    rows = page.eval_on_selector_all(
        "#numbers div", "rows => rows.map(row => [...row.children].map(e => e.textContent))"
    )
    return read_number({row[0]: row[1] for row in rows}[symbol].split(" ")[0])


def expect_case(page, data, point):
    """The page shows this case with the numbers of the data set."""
    f, alpha, beta = point
    assert np.allclose(selected(page)[0], (f, alpha, beta), rtol=1e-3), (selected(page), point)
    case = data.sel(f=f, alpha=alpha, beta=beta)
    for symbol, name in [("μₜₒₜ", "mu_tot"), ("μᵥ", "mu_v"), ("μₕ", "mu_h"), ("uₘᵢₙ", "film_min"), ("pₘₐₓ", "p_max")]:
        assert np.isclose(number_of(page, symbol), float(case[name]), rtol=1e-4, atol=1e-12), (symbol, point)
    drawn = page.evaluate("() => { const { x, y } = document.getElementById('pressure').data[0]; return { x, y }; }")
    there = np.interp(drawn["x"], case.x, case.pressure)
    assert np.max(np.abs(np.array(drawn["y"]) - there)) < 1e-4 * float(case.p_max), point


def pixel(page, picture, x, y):
    """Where a point of a plane picture is on the screen."""
    return page.evaluate(
        """([id, x, y]) => {
            const picture = document.getElementById(id);
            const box = picture.getBoundingClientRect();
            const { xaxis, yaxis } = picture._fullLayout;
            return [box.left + xaxis._offset + xaxis.l2p(x), box.top + yaxis._offset + yaxis.l2p(y)];
        }""",
        [picture, x, y],
    )


def click_point(page, picture, x, y):
    """Clicks on a point of a plane picture, and waits until the page has another case selected."""
    page.locator(f"#{picture}").scroll_into_view_if_needed()
    page.mouse.move(*pixel(page, picture, x, y))
    # A click counts where the picture has noticed the pointer.
    page.wait_for_function("id => (document.getElementById(id)._hoverdata ?? []).length > 0", arg=picture)
    page.evaluate("document.body.dataset.place = 'awaited'")
    page.mouse.click(*pixel(page, picture, x, y))
    page.wait_for_function("document.body.dataset.place !== 'awaited'")


# Where the cases of the surface are on the screen, those in the middle of the picture first.
PROJECTED = """() => {
    const picture = document.getElementById("surface");
    const scene = picture._fullLayout.scene._scene;
    const { projection, view, model } = scene.glplot.cameraParams;
    const product = (m, v) => [0, 1, 2, 3].map(i => m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3]);
    const box = picture.querySelector("canvas").getBoundingClientRect();
    const { x, y, z } = picture.data[0];
    const found = [];
    y.forEach((beta, j) => x.forEach((alpha, i) => {
        if (!Number.isFinite(z[j][i])) return;
        const scaled = [alpha, beta, z[j][i]].map((value, axis) => value * scene.dataScale[axis]);
        const p = product(projection, product(view, product(model, [...scaled, 1])));
        const [across, down] = [p[0] / p[3], p[1] / p[3]];
        const [left, top] = [(0.5 + 0.5 * across) * box.width, (0.5 - 0.5 * down) * box.height];
        found.push([Math.hypot(across, down), box.left + left, box.top + top]);
    }));
    return found.sort((one, other) => one[0] - other[0]).map(([, left, top]) => [left, top]);
}"""


def click_surface(page):
    """Clicks on the surface, and returns the f, α and β of the case that this selects."""
    page.evaluate("scrollTo(0, 0)")
    page.evaluate("document.getElementById('surface').on('plotly_hover', event => { window.under = event.points[0]; })")
    page.evaluate("document.getElementById('surface').on('plotly_unhover', () => { window.under = undefined; })")
    for left, top in page.evaluate(PROJECTED):
        # A case may be hidden behind others, or by the mark of the selected one.
        page.mouse.move(left, top, steps=4)
        try:
            page.wait_for_function("window.under !== undefined", timeout=5000)
        except TimeoutError:
            continue
        hovered = page.evaluate("[window.under.x, window.under.y]")
        page.evaluate("document.body.dataset.place = 'awaited'")
        # A picture in space looks at the button when it is next drawn, which takes the processor a while.
        page.mouse.down()
        page.wait_for_function("document.body.dataset.place !== 'awaited'")
        page.mouse.up()
        point = selected(page)[0]
        shown = page.evaluate(
            "() => { const { x, y } = document.getElementById('map').data.at(-1); return [x[0], y[0]]; }"
        )
        assert np.allclose(shown, hovered), (shown, hovered)
        return point
    raise AssertionError("the pointer found no surface")


def colours(page, selector):
    """How many different colours a part of the page has."""
    picture = matplotlib.image.imread(io.BytesIO(page.locator(selector).screenshot()), format="png")
    return len(np.unique(np.round(picture[..., :3].reshape(-1, 3) * 31).astype(int), axis=0))


@dataclass
class Visit:
    """A page that is looked at, and what it should show."""

    page: Any
    picture: Any
    data: xr.Dataset
    summary: list[dict[str, str]]

    def axes(self):
        """The values of f, α and β."""
        return tuple(self.data[name].values for name in ("f", "alpha", "beta"))


def heights(page, picture):
    """What a picture draws over α and β, NaN where it has nothing."""
    z = page.evaluate("id => document.getElementById(id).data[0].z", picture)
    return np.array([[np.nan if value is None else value for value in row] for row in z], dtype=float)


def expect_heights(visit, drawn, i_f):
    """A picture draws the total friction of the data set at this f."""
    mu_tot = visit.data.mu_tot
    logarithmic = np.nanmax(mu_tot) > 30 * np.nanmin(mu_tot)
    shown = mu_tot.isel(f=i_f).transpose("beta", "alpha").values
    assert np.allclose(10**drawn if logarithmic else drawn, shown, rtol=1e-5, equal_nan=True)


def see_first_pictures(visit):
    """The surface is drawn: not one colour, and with the numbers of the data set."""
    page = visit.page
    paint = page.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime")
    drawn = page.evaluate("performance.now()")
    print(f"words after {paint / 1000:.2f} s, every picture after {drawn / 1000:.2f} s")
    assert page.title() == visit.data.attrs["title"]
    assert page.text_content("#sweep") == visit.data.attrs["sweep"]
    page.wait_for_function("document.querySelector('#surface canvas') !== null")
    assert colours(page, "#surface") > 100, "the surface is blank"
    assert colours(page, "#map") > 30, "the map is blank"
    expect_heights(visit, heights(page, "surface"), -1)
    visit.picture("light")


def move_slider(visit):
    """The slider changes f everywhere."""
    page, (f, _, _) = visit.page, visit.axes()
    before = page.inner_text("#f-value")
    page.focus("#f-slider")
    page.keyboard.press("ArrowLeft")
    assert page.inner_text("#f-value") != before
    assert np.isclose(read_number(page.inner_text("#f-value").removeprefix("f = ")), f[-2], rtol=1e-3)
    moved = heights(page, "map")
    expect_heights(visit, moved, -2)
    assert np.array_equal(heights(page, "surface"), moved, equal_nan=True), "the surface has another f than the map"
    page.keyboard.press("End")
    assert page.inner_text("#f-value") == before


def turn_surface(visit):
    """The keys turn the surface, there and back."""
    page = visit.page
    eye = "document.getElementById('surface').layout.scene.camera.eye"
    before = page.evaluate(eye)
    away = f"from => Math.hypot(...['x', 'y', 'z'].map(axis => from[axis] - {eye}[axis]))"
    page.focus("#surface")
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(f"{away} > 0", arg=before)
    for key in ("ArrowUp", "ArrowDown", "ArrowRight", "+", "-"):
        page.keyboard.press(key)
    page.wait_for_function(f"{away} < 1e-6", arg=before)


def click_pictures(visit):
    """A click on the map, on a curve, on the scatter and on the surface selects the case below it."""
    page, (f, alpha, beta) = visit.page, visit.axes()
    i_alpha, i_beta = 1, len(beta) - 2
    click_point(page, "map", np.log10(alpha[i_alpha]), np.log10(beta[i_beta]))
    expect_case(page, visit.data, (f[-1], alpha[i_alpha], beta[i_beta]))
    visit.picture("selected")

    height = page.evaluate("document.getElementById('curve-alpha').data.at(-2).y[2]")
    click_point(page, "curve-alpha", np.log10(alpha[2]), height)
    expect_case(page, visit.data, (f[-1], alpha[2], beta[i_beta]))
    target = page.evaluate(
        "() => { const { x, y } = document.getElementById('scatter').data[0]; return [x[0], y[0]]; }"
    )
    click_point(page, "scatter", *target)
    assert page.evaluate("document.getElementById('scatter').layout.shapes[0].xanchor") == target[0]

    point = click_surface(page)
    near = zip(visit.axes(), point, strict=True)
    expect_case(page, visit.data, [values[np.isclose(values, value, rtol=1e-3)][0] for values, value in near])


def move_selection(visit):
    """The arrow keys move the selection in the map."""
    page, (_, alpha, beta) = visit.page, visit.axes()
    page.focus("#map")
    place = selected(page)[0]
    page.keyboard.press("ArrowRight" if place[1] < alpha[-1] else "ArrowLeft")
    assert selected(page)[0][1] != place[1] and selected(page)[0][2] == place[2]
    place = selected(page)[0]
    page.keyboard.press("ArrowUp" if place[2] < beta[-1] else "ArrowDown")
    assert selected(page)[0][2] != place[2] and selected(page)[0][1] == place[1]


def see_failure(visit):
    """A failed case says why, by its list."""
    page = visit.page
    failed = page.locator("#failure-list button")
    if failed.count():
        failed.first.click()
        assert selected(page)[1].startswith("failed, "), selected(page)
        assert page.is_visible("#no-fields") and not page.is_visible("#pressure")
        visit.picture("failed")


def sort_table(visit):
    """The table sorts, in both directions."""
    page, column = visit.page, "#table th[data-column=mu_tot]"

    def shown():
        cells = page.eval_on_selector_all("#table tbody tr", "rows => rows.map(row => row.cells[4].textContent)")
        return [read_number(cell) for cell in cells if cell != "–"]

    page.click(f"{column} button")
    values = shown()
    assert len(values) > 2 and values == sorted(values)
    page.click(f"{column} button")
    assert page.get_attribute(column, "aria-sort") == "descending"
    values = shown()
    assert values == sorted(values, reverse=True)


def filter_table(visit):
    """The table filters, selects, and is downloaded as it is shown."""
    page, (_, _, beta) = visit.page, visit.axes()
    page.fill("#filter", f"β = {beta[0]:g}, converged")
    rows = page.locator("#table tbody tr")
    assert rows.count() == int((visit.data.status.isel(beta=0) == 0).sum())
    rows.first.focus()
    page.keyboard.press("Enter")
    assert rows.first.get_attribute("aria-selected") == "true" and selected(page)[0][2] == beta[0]
    with page.expect_download() as waiting:
        page.click("#download")
    table = list(csv.DictReader(Path(waiting.value.path()).read_text(encoding="utf-8").splitlines()))
    # What follows from other columns, or is for those who check, has no room in a page.
    left_out = {"mu_v_flat", "mu_v_roller", "mu_torque", "energy_residual"}
    assert len(table) == rows.count() and list(table[0]) == [name for name in visit.summary[0] if name not in left_out]
    summary = {row["case"]: row for row in visit.summary}
    for row in table:
        other = summary[row["case"]]
        for name in list(row)[6:]:
            assert (row[name] == "") == (other[name] == ""), (name, row)
            near = row[name] == "" or np.isclose(float(row[name]), float(other[name]), rtol=1e-6, atol=1e-40)
            assert near, (name, row)
    visit.picture("table")


def change_theme(visit):
    """The page is dark or light, and remembers which for the session."""
    page, ground = visit.page, "getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(ground)
    page.click("#theme")
    dark = page.evaluate(ground)
    assert dark != light
    page.reload()
    page.wait_for_function("document.body.dataset.drawn === 'all'")
    assert page.evaluate(ground) == dark
    visit.picture("dark")


def use_phone(visit):
    """On a phone nothing runs off the page, and another quantity is chosen by the keyboard alone."""
    page = visit.page
    page.set_viewport_size({"width": 390, "height": 844})
    # Pictures follow the width of the page in their own time.
    page.wait_for_function("document.documentElement.scrollWidth <= 390")
    visit.picture("phone")
    page.focus("#quantity")
    page.keyboard.press("ArrowDown")
    assert "viscoelastic" in page.inner_text("#surface-title").lower()


def main():
    """Looks at the page as a reader would, from the first picture to the phone."""
    path, results = Path(sys.argv[1]), Path(sys.argv[2])
    data = xr.open_dataset(results / "results.h5", engine="h5netcdf")
    with (results / "summary.csv").open(encoding="utf-8") as file:
        summary = list(csv.DictReader(file))
    with launched() as chromium, window(chromium) as watched:
        visit = Visit(watched.page, watched.screenshot, data, summary)
        watched.open(path)
        see_first_pictures(visit)
        move_slider(visit)
        turn_surface(visit)
        click_pictures(visit)
        move_selection(visit)
        see_failure(visit)
        sort_table(visit)
        filter_table(visit)
        change_theme(visit)
        use_phone(visit)
        assert watched.page.evaluate("window.broken") is None, "a text of the sweep ran as a script"
        watched.expect_peace()
    print("the page does what it says")


if __name__ == "__main__":
    main()
