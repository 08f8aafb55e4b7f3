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

from chromium import launched, read_number, window
from first_picture import MOMENTS, WATCH


def selected(page):
    """f, α and β of the selected case, and what is said of it."""
    text = page.inner_text("#selected")
    found = re.match(r"f = (\S+), α = (\S+), β = (\S+): (.*)", text)
    assert found, text
    return tuple(read_number(part) for part in found.groups()[:3]), found[4]


# What the page calls numbers of the selected case, as pictures do, and their columns.
WORDS = {
    "total friction μₜₒₜ": "mu_tot",
    "viscoelastic friction μᵥ": "mu_v",
    "hydrodynamic friction μₕ": "mu_h",
    "drag μ_drag": "mu_drag",
    "smallest film thickness uₘᵢₙ": "film_min",
    "largest pressure pₘₐₓ": "p_max",
}


def number_of(page, words):
    """A number of the selected case and its estimated error, by what the page calls it; 0 where there is no error."""
    rows = page.eval_on_selector_all(
        "#numbers div", "rows => rows.map(row => [...row.children].map(e => e.textContent))"
    )
    parts = {row[0]: row[1] for row in rows}[words].split(" ")
    return read_number(parts[0]), read_number(parts[2]) if parts[1:2] == ["±"] else 0.0


def drawn(page):
    """Waits until all pictures follow what was chosen."""
    page.wait_for_function("document.body.dataset.drawn === 'all'")


def expect_case(page, data, point):
    """The page shows this case with the numbers of the data set."""
    f, alpha, beta = point
    assert np.allclose(selected(page)[0], (f, alpha, beta), rtol=1e-3), (selected(page), point)
    case = data.sel(f=f, alpha=alpha, beta=beta)
    for words, name in WORDS.items():
        assert np.isclose(number_of(page, words)[0], float(case[name]), rtol=1e-4, atol=1e-12), (words, point)
    expected = float(case.error_mu_drag) * abs(float(case.mu_drag))
    assert np.isclose(number_of(page, "drag μ_drag")[1], expected, rtol=0.06), (point, expected)
    drawn(page)
    line = page.evaluate("() => { const { x, y } = document.getElementById('pressure').data[0]; return { x, y }; }")
    there = np.interp(line["x"], case.x, case.pressure)
    assert np.max(np.abs(np.array(line["y"]) - there)) < 1e-4 * float(case.p_max), point


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
    drawn(page)


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
        drawn(page)
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


def expect_heights(visit, shown_heights, i_f):
    """A picture draws the total friction of the data set at this f."""
    mu_tot = visit.data.mu_tot
    logarithmic = np.nanmax(mu_tot) > 30 * np.nanmin(mu_tot)
    shown = mu_tot.isel(f=i_f).transpose("beta", "alpha").values
    found = 10**shown_heights if logarithmic else shown_heights
    assert np.allclose(found, shown, rtol=1e-5, equal_nan=True)


def see_first_pictures(visit):
    """The surface is drawn: not one colour, and with the numbers of the data set."""
    page = visit.page
    words, shown, first = page.evaluate(MOMENTS)
    last = page.evaluate("performance.now()") / 1000
    print(f"words after {shown:.2f} s, the first live picture after {first:.2f} s, every picture after {last:.2f} s")
    # The frame with the words was made before; a busy machine may show it later.
    assert words <= first < last, "the first live picture is drawn behind the words and before the others"
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
    drawn(page)
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
        drawn(page)
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
    named = [name for name in visit.summary[0] if name not in left_out]
    further = ["error_mu_pressure", "error_mu_shear", "error_film_min", "error_p_max"]
    assert len(table) == rows.count() and list(table[0]) == [*named, *further]
    summary = {row["case"]: row for row in visit.summary}
    for row in table:
        other = summary[row["case"]]
        for name in named[6:]:
            assert (row[name] == "") == (other[name] == ""), (name, row)
            near = row[name] == "" or np.isclose(float(row[name]), float(other[name]), rtol=1e-6, atol=1e-40)
            assert near, (name, row)
    visit.picture("table")


def pin_cases(visit):
    """Two pinned cases stay in the pictures beside the selected one, and are compared in a table."""
    page, (f, alpha, beta) = visit.page, visit.axes()
    lines = "document.getElementById('pressure').data.length"
    for i_alpha in (1, 2):
        click_point(page, "map", np.log10(alpha[i_alpha]), np.log10(beta[0]))
        page.click("#pin")
    click_point(page, "map", np.log10(alpha[1]), np.log10(beta[1]))
    assert page.evaluate(lines) == 3, "the selected case and both pinned ones have a line"
    marks = page.evaluate("document.getElementById('curve-alpha').data.filter(it => it.mode === 'markers+text')")
    values = [float(visit.data.mu_tot.sel(f=f[-1], alpha=alpha[i], beta=beta[0])) for i in (1, 2)]
    heights_of_marks = [mark["y"][0] for mark in marks]
    logarithmic = np.nanmax(visit.data.mu_tot) > 30 * np.nanmin(visit.data.mu_tot)
    assert np.allclose(heights_of_marks, np.log10(values) if logarithmic else values, rtol=1e-5)
    rows = page.locator("#pins tbody tr")
    assert rows.count() == 3 and rows.nth(1).inner_text().startswith(f"pin 1: f = {f[-1]:g}")
    compared = [read_number(rows.nth(i).locator("td").first.inner_text().split(" ")[0]) for i in (1, 2)]
    assert np.allclose(compared, values, rtol=1e-3)
    visit.picture("pinned")


def open_link(visit, chromium):
    """The address holds what is chosen: a link opens the same view, and one that asks for more says so."""
    page = visit.page
    page.select_option("#quantity", "film_min")
    page.select_option("#scale", "log")
    drawn(page)
    here = """() => [
        ["quantity", "scale", "f-slider"].map(id => document.getElementById(id).value),
        ["selected", "pins", "numbers"].map(id => document.getElementById(id).innerText),
        ["map", "curve-beta", "pressure"].map(id => document.getElementById(id).data.map(({ x, y }) => ({ x, y }))),
    ]"""
    address = page.url
    with window(chromium) as other:
        other.go(address)
        assert other.page.evaluate(here) == page.evaluate(here), address
        assert not other.page.is_visible("#address")
        other.go(f"{address.split('#')[0]}#quantity=speed&alpha=1&beta=12345&pin=1&colour=red")
        # Another address of the same page loads nothing anew.
        other.page.wait_for_function("document.getElementById('address').checkVisibility()")
        said = other.page.inner_text("#address")
        for part in ("quantity = speed", "beta = 12345", "pin = 1", "colour = ", "the default"):
            assert part in said, said
        assert "alpha" not in said, "what the page has is not complained of"
        assert other.page.input_value("#quantity") == "mu_tot"
        other.expect_peace()
    page.locator("#pins button").first.click()
    page.locator("#pins button").first.click()
    drawn(page)
    assert not page.is_visible("#pins") and page.evaluate("document.getElementById('pressure').data.length") == 1


def copy_pictures(visit):
    """A picture is copied as CSV and as PNG; where nothing may be copied, a file is saved."""
    page = visit.page
    csv_button = page.get_by_role("button", name="copy map as CSV")
    page.evaluate("Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true })")
    with page.expect_download() as waiting:
        csv_button.click()
    saved = Path(waiting.value.path()).read_text(encoding="utf-8")
    page.evaluate("delete navigator.clipboard")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    csv_button.click()
    said = page.locator("figure:has(#map) [role=status]")
    page.wait_for_function("element => element.textContent === 'copied'", arg=said.element_handle())
    assert page.evaluate("navigator.clipboard.readText()") == saved
    (f, _, _), table = visit.axes(), list(csv.DictReader(saved.splitlines()))
    assert len(table) == visit.data.film_min.isel(f=0).size
    for row in table:
        case = visit.data.sel({name: float(row[name]) for name in ("f", "alpha", "beta")})
        assert float(row["f"]) in f
        assert row["film_min"] == "" or np.isclose(float(row["film_min"]), float(case.film_min), rtol=1e-6), row
    page.get_by_role("button", name="copy pressure as PNG").click()
    said = page.locator("figure:has(#pressure) [role=status]")
    page.wait_for_function("element => element.textContent === 'copied'", arg=said.element_handle())
    size = page.evaluate(
        """async () => {
            const [item] = await navigator.clipboard.read();
            const picture = await createImageBitmap(await item.getType("image/png"));
            return [picture.width, picture.height];
        }"""
    )
    box = page.locator("#pressure").bounding_box()
    assert np.allclose(size, [2 * box["width"], 2 * box["height"]], atol=2), (size, box)


# Pairs of blocks of the page that overlap, and blocks that reach beyond the paper.
COLLISIONS = """width => {
    const blocks = [...document.querySelectorAll("h1, h2, p, dl > div, .svg-container, pre, li")]
        .filter(block => block.checkVisibility())
        .map(block => ({ name: block.textContent.slice(0, 20), box: block.getBoundingClientRect() }));
    const within = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1
        && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;
    const pictures = [...document.querySelectorAll(".plot .main-svg")].filter(it => it.checkVisibility());
    return [
        ...blocks.flatMap((one, i) => blocks.slice(i + 1).filter(other => within(one.box, other.box))
            .map(other => [one.name, other.name])),
        ...pictures.filter(it => it.getBoundingClientRect().right > width).map(it => [it.closest(".plot").id, "wide"]),
    ];
}"""


def print_page(visit):
    """On paper nothing overlaps or is cut off, all is light, and the screen has its own colours again afterwards."""
    page = visit.page
    size = page.viewport_size
    before = page.evaluate("document.documentElement.dataset.theme")
    # A4 without its margins.
    page.set_viewport_size({"width": 717, "height": 1000})
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.evaluate("document.documentElement.dataset.theme") == "light"
    assert page.evaluate(COLLISIONS, 717) == []
    assert page.evaluate("document.documentElement.scrollWidth") <= 717
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="screen")
    page.set_viewport_size(size)
    drawn(page)
    assert page.evaluate("document.documentElement.dataset.theme") == before


def change_theme(visit):
    """The page is dark or light, and remembers which for the session."""
    page, ground = visit.page, "getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(ground)
    page.click("#theme")
    # Chromium hands what a page stores to another process, which takes a moment.
    drawn(page)
    dark = page.evaluate(ground)
    assert dark != light
    page.reload()
    drawn(page)
    again = page.evaluate(ground)
    assert again == dark, (light, dark, again)
    visit.picture("dark")


def use_phone(visit):
    """On a phone nothing runs off the page, and another quantity is chosen by the keyboard alone."""
    page = visit.page
    page.set_viewport_size({"width": 390, "height": 844})
    # Pictures follow the width of the page in their own time.
    page.wait_for_function("document.documentElement.scrollWidth <= 390")
    visit.picture("phone")
    page.focus("#quantity")
    page.keyboard.press("ArrowUp")
    chosen = page.evaluate("document.getElementById('quantity').selectedOptions[0].text")
    assert page.input_value("#quantity") != "film_min" and page.inner_text("#surface-title").lower() == chosen.lower()


def main():
    """Looks at the page as a reader would, from the first picture to the phone."""
    path, results = Path(sys.argv[1]), Path(sys.argv[2])
    data = xr.open_dataset(results / "results.h5", engine="h5netcdf")
    with (results / "summary.csv").open(encoding="utf-8") as file:
        summary = list(csv.DictReader(file))
    with launched() as chromium, window(chromium) as watched:
        visit = Visit(watched.page, watched.screenshot, data, summary)
        watched.page.add_init_script(WATCH)
        watched.open(path)
        see_first_pictures(visit)
        move_slider(visit)
        turn_surface(visit)
        click_pictures(visit)
        move_selection(visit)
        see_failure(visit)
        sort_table(visit)
        filter_table(visit)
        pin_cases(visit)
        open_link(visit, chromium)
        copy_pictures(visit)
        change_theme(visit)
        print_page(visit)
        use_phone(visit)
        assert watched.page.evaluate("window.broken") is None, "a text of the sweep ran as a script"
        watched.expect_peace()
    print("the page does what it says")


if __name__ == "__main__":
    main()
