"""Moves the sliders of scripts/profiles.py and clicks on its curves, without a display.

usage: browse_profiles.py RESULTS_DIRECTORY, of the synthetic results of the tests
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib.backend_bases import MouseButton, MouseEvent

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts"))
import profiles

data = profiles.open_profiles(Path(sys.argv[1]))
browser = profiles.Browser(data, profiles.chosen(data, {"alpha": 1.0, "beta": 100.0, "f": 100.0}), sliders=True)
canvas = browser.figure.canvas
canvas.draw()


def text_in(axes):
    """All text of a picture, in one line."""
    return " ".join(text.get_text() for text in axes.texts)


def shows(alpha, beta, f):
    """The title, the text beside the sliders and the curve drawn are those of the case."""
    title = browser.figure.get_suptitle()
    assert f"α = {alpha}, β = {beta}, f = {f}" in title, title
    beside = [browser.sliders[name].valtext.get_text() for name in ("alpha", "beta", "f")]
    assert beside == [alpha, beta, f], beside
    case = data.sel(alpha=float(alpha.replace("∞", "inf")), f=float(f)).sel(beta=float(beta), method="nearest")
    if int(case["status"]) == 0:
        for name, axes in browser.profiles.items():
            assert (axes.lines[0].get_ydata() == case[name].values).all(), name
        assert f"{float(case['mu_h']):.6g}" in text_in(browser.numbers)
    return case


def click(axes, x, y=0.5):
    """A click on the canvas: x in data, y as a share of the axes."""
    across, up = axes.transData.transform((x, 1.0))[0], axes.transAxes.transform((0.5, y))[1]
    event = MouseEvent("button_press_event", canvas, across, up, MouseButton.LEFT)
    canvas.callbacks.process("button_press_event", event)


shows("1", "100", "100")

# Sliders step through the values of the axes, infinity and the elastic row included.
browser.sliders["alpha"].set_val(3)
shows("∞", "100", "100")
browser.sliders["f"].set_val(0)
shows("∞", "100", "0")
browser.sliders["alpha"].set_val(2)
browser.sliders["f"].set_val(1)
browser.sliders["beta"].set_val(4)
shows("10", "1000", "100")

# The film is drawn over a logarithmic axis.
assert browser.profiles["film_thickness"].get_yscale() == "log"

# A click takes the nearest case of the curve, by ratio.
click(browser.curves["alpha"], 1.9)
shows("1", "1000", "100")
click(browser.curves["beta"], 12.0)
shows("1", "10", "100")
click(browser.curves["alpha"], browser.curves["alpha"].get_xlim()[1] * 0.999)
shows("∞", "10", "100")
# A click elsewhere changes nothing.
click(browser.profiles["pressure"], 0.0)
shows("∞", "10", "100")

# A case that failed says why, and has no curve.
browser.sliders["alpha"].set_val(0)
browser.sliders["beta"].set_val(4)
shows("0.1", "1000", "100")
reason = text_in(browser.profiles["pressure"]).replace("\n", " ")
assert 'failed: load residual 3e-2, "stalled" after 60000 passes' in reason, reason
assert not any(axes.lines for axes in browser.profiles.values())
# And comes back.
browser.sliders["beta"].set_val(0)
shows("0.1", "10", "100")
print("browsed")
