# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "matplotlib>=3.8", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Browses the profiles of a sweep: pressure, film and displacement of a case, beside the friction curves through it.

Usage:
    uv run scripts/profiles.py results/quick
    uv run scripts/profiles.py results/quick --alpha 1 --beta 100 --f 100 -o profile.pdf

In the window sliders step through the values of the axes, and a click on a friction curve takes the nearest case.
"""

import argparse
import textwrap
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.widgets import Slider

from lib.log_axes import format_value, label_range, label_values, nearest, positions
from lib.messages import fail
from lib.results import decode, open_results
from lib.style import ALPHA, BETA, BLUE, FAILED, GREEN, PAGE, VERMILION, picture_path, print_style, save

AXES = {"alpha": ("α", ALPHA), "beta": ("β", BETA), "f": ("f", "$f$")}
FIELDS = {
    "pressure": (r"$p\ /\ (2N/\pi a_0)$", BLUE),
    "film_thickness": (r"$u\ /\ (a_0^2/R)$", GREEN),
    "displacement": (r"$w\ /\ (a_0^2/R)$", VERMILION),
}
FRICTIONS = {
    "mu_tot": (r"$\mu_{tot}$", "black", "-", "o"),
    "mu_v": (r"$\mu_v$", VERMILION, "--", "s"),
    "mu_h": (r"$\mu_h$", BLUE, ":", "^"),
}
NUMBERS = [
    ("mu_v", r"$\mu_v\,R/a_0$", "error_mu_v"),
    ("mu_h", r"$\mu_h\,R/a_0$", "error_mu_h"),
    ("mu_tot", r"$\mu_{tot}\,R/a_0$", None),
    ("c", r"$c\,R/a_0^2$", "error_c"),
    ("film_min", r"$u_{min}\,R/a_0^2$", None),
    ("p_max", r"$p_{max}\,\pi a_0/2N$", None),
    ("x_outlet", r"$x_{outlet}/a_0$", None),
]
# Backends of matplotlib that write files and open no window.
WINDOWLESS = {"agg", "cairo", "pdf", "pgf", "ps", "svg", "template"}


def open_profiles(directory):
    """The published data set of a sweep that keeps fields."""
    data = open_results(directory)
    if not any(name in data for name in FIELDS):
        fail(
            f"{directory / 'results.h5'}: the sweep keeps no fields, so there are no profiles; write\n"
            '    fields = ["pressure", "film_thickness", "displacement"]\n'
            "under [output] of the sweep file and run it again"
        )
    missing = [name for name in FIELDS if name not in data]
    if missing:
        print(f"not shown, as the sweep does not keep it: {', '.join(missing)}")
    return data


class Browser:
    """A figure of one case; `place` holds the indices of the case by axis."""

    def __init__(self, data, place, sliders):
        self.data, self.place, self.sliders = data, dict(place), {}
        self.values = {name: data[name].values for name in AXES}
        self.fields = [name for name in FIELDS if name in data]
        foot = 0.75 if sliders else 0.0
        height = 4.9 + foot
        self.figure = plt.figure(figsize=(PAGE, height))
        self.add_panels(1 - 0.5 / height, (foot + 0.42) / height, 0.1 / height)
        if sliders:
            self.add_sliders(height)
            self.figure.canvas.mpl_connect("button_press_event", self.clicked)
        self.draw()

    def add_panels(self, top, bottom, lower):
        """Adds the profiles on the left; on the right, whose bottom is lower, friction curves and numbers."""
        left = {"left": 0.105, "right": 0.51, "top": top, "bottom": bottom, "hspace": 0.12}
        grid = self.figure.add_gridspec(len(self.fields), 1, **left).subplots(sharex=True, squeeze=False)
        self.profiles = dict(zip(self.fields, grid[:, 0], strict=True))
        right = {"left": 0.625, "right": 0.985, "top": top, "bottom": bottom - lower, "hspace": 0.5}
        grid = self.figure.add_gridspec(3, 1, height_ratios=[1, 1, 0.95], **right)
        self.curves = {name: self.figure.add_subplot(grid[i]) for i, name in enumerate(("alpha", "beta"))}
        self.numbers = self.figure.add_subplot(grid[2])

    def add_sliders(self, height):
        """Adds one slider for each axis that has several values."""
        several = [name for name in AXES if self.values[name].size > 1]
        for i, name in enumerate(several):
            axes = self.figure.add_axes((0.085, (0.52 - 0.21 * i) / height, 0.8, 0.14 / height))
            last = self.values[name].size - 1
            slider = Slider(axes, AXES[name][0], 0, last, valinit=self.place[name], valstep=1, color=BLUE)
            # `moved` draws the whole figure, the slider included.
            slider.drawon = False
            slider.on_changed(lambda index, name=name: self.moved(name, int(index)))
            self.sliders[name] = slider

    def moved(self, name, index):
        """Shows the case at which a slider stands now."""
        self.place[name] = index
        self.draw()
        self.figure.canvas.draw_idle()

    def clicked(self, event):
        """Shows the case of a friction curve that is nearest to a click on it."""
        for name, axes in self.curves.items():
            if event.inaxes is axes and name in self.sliders:
                self.sliders[name].set_val(nearest(positions(self.values[name]), event.xdata))

    def case(self):
        """The data of the case shown."""
        return self.data.isel(self.place)

    def draw(self):
        """Draws everything anew for the case at `place`."""
        case = self.case()
        for name, slider in self.sliders.items():
            slider.valtext.set_text(format_value(self.values[name][self.place[name]]))
        self.figure.suptitle(f"{self.data.attrs['title']}\n{format_case(self.data, self.place)}", y=0.99, va="top")
        self.draw_profiles(case)
        for name in self.curves:
            self.draw_curve(name)
        self.draw_numbers(case)

    def draw_profiles(self, case):
        """Draws the fields over x, or the reason why there are none."""
        failed = int(case["status"]) == 1
        for name, axes in self.profiles.items():
            label, colour = FIELDS[name]
            axes.clear()
            axes.set_ylabel(label)
            axes.yaxis.set_label_coords(-0.155, 0.5)
            axes.grid(True, color="0.9")
            x = self.data["x"].values
            axes.set_xlim(x[0], x[-1])
            if failed:
                why = f"failed: {decode(case['reason'].values[()])}" if name == self.fields[0] else "failed"
                middle = {"ha": "center", "va": "center", "transform": axes.transAxes}
                axes.text(0.5, 0.5, textwrap.fill(why, 42), color=FAILED, **middle)
                axes.set_yticks([])
                continue
            axes.plot(x, case[name].values, color=colour)
            if name == "film_thickness" and (case[name].values > 0).all():
                axes.set_yscale("log")
        last = self.profiles[self.fields[-1]]
        last.set_xlabel("$x/a_0$   (inlet on the right)")

    def draw_curve(self, name):
        """Draws friction over alpha or beta through the case, and the case on it."""
        axes, values = self.curves[name], self.values[name]
        axes.clear()
        through = self.data.isel({other: index for other, index in self.place.items() if other != name})
        where, proper = positions(values), (values > 0) & np.isfinite(values)
        frictions = {key: through[key].values for key in FRICTIONS}
        here = where[self.place[name]]
        axes.axvline(here, color="0.8", linewidth=3, zorder=0)
        for key, (label, colour, dashes, marker) in FRICTIONS.items():
            # Infinity and zero are beside the curve, as they have no place on a logarithmic axis.
            axes.plot(where[proper], frictions[key][proper], dashes, color=colour, label=label, linewidth=1.1)
            axes.plot(where[~proper], frictions[key][~proper], marker, color=colour, ms=3)
            axes.plot(here, frictions[key][self.place[name]], marker, color=colour, ms=4.5)
        failed = through["status"].values == 1
        floor, transform = np.full(failed.sum(), 0.04), axes.get_xaxis_transform()
        axes.plot(where[failed], floor, "x", color=FAILED, ms=4.5, mew=1.4, transform=transform)
        finite = np.concatenate([mu[np.isfinite(mu)] for mu in frictions.values()])
        axes.set(xscale="log", xlabel=AXES[name][1], ylabel=r"$\mu\,R/a_0$")
        if finite.size and finite.min() > 1e-6 * finite.max():
            axes.set_yscale("log")
            label_range(axes.yaxis, *axes.get_ylim())
        axes.yaxis.set_label_coords(-0.18, 0.5)
        room = max((where.max() / where.min()) ** 0.03, 1.1)
        axes.set_xlim(where.min() / room, where.max() * room)
        label_values(axes.xaxis, values)
        if name == "alpha":
            above = {"loc": "lower right", "bbox_to_anchor": (1.0, 0.97)}
            axes.legend(ncols=3, frameon=False, handlelength=2.2, columnspacing=1, **above)

    def draw_numbers(self, case):
        """Writes the numbers of the case with their estimated errors."""
        axes = self.numbers
        axes.clear()
        axes.axis("off")
        rows = [("", "value", "estimated error")]
        for name, symbol, error in NUMBERS:
            value = float(case[name])
            estimate = float(case[error]) if error else np.nan
            number = "none" if np.isnan(value) else f"{value:.6g}"
            rows.append((symbol, number, "" if np.isnan(estimate) else f"{estimate:.1e}"))
        for i, (symbol, number, estimate) in enumerate(rows):
            y = 0.86 - i * 0.145
            axes.text(0.0, y, symbol, transform=axes.transAxes, va="center")
            axes.text(0.5, y, number, transform=axes.transAxes, va="center", ha="right")
            axes.text(1.0, y, estimate, transform=axes.transAxes, va="center", ha="right")


def format_case(data, place):
    """`α = 1, β = 10, f = 100` of the case with these indices."""
    return ", ".join(f"{AXES[name][0]} = {format_value(data[name].values[place[name]])}" for name in AXES)


def axis_value(text):
    """A number from 0 to infinity."""
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not value >= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of at least 0; `inf` is allowed")
    return value


def chosen(data, wanted):
    """Indices of the case nearest to the values wanted; the middle of an axis where nothing is."""
    place = {}
    for name, value in wanted.items():
        values = data[name].values
        place[name] = values.size // 2 if value is None else nearest(values, value)
        taken = values[place[name]]
        if value is not None and taken != value:
            print(f"{AXES[name][0]} = {format_value(value)} is not in the sweep; the nearest is {format_value(taken)}")
    print(f"shows the case {format_case(data, place)}")
    return place


def read_arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description="Shows pressure, film and displacement of the cases of results.h5.")
    parser.add_argument("results", type=Path, metavar="RESULTS_DIR", help="directory that `stribeck run` wrote")
    parser.add_argument(
        "-o", "--output", type=picture_path, help="picture to write in place of a window: .png, .pdf, .svg"
    )
    for name, (symbol, _) in AXES.items():
        parser.add_argument(f"--{name}", type=axis_value, help=f"{symbol} of the case to show; the nearest is taken")
    return parser.parse_args()


def main():
    """Shows a case of the results directory of the command line, in a window or as a picture."""
    arguments = read_arguments()
    if arguments.output:
        plt.switch_backend("agg")
    elif plt.get_backend().lower() in WINDOWLESS:
        fail(
            f"matplotlib can open no window here (its backend is {plt.get_backend()}): give -o FILE.png to draw one "
            "case, or work on a display with tkinter or PySide6 installed"
        )
    data = open_profiles(arguments.results)
    print_style()
    place = chosen(data, {name: getattr(arguments, name) for name in AXES})
    browser = Browser(data, place, sliders=not arguments.output)
    if arguments.output:
        save(browser.figure, arguments.output)
    else:
        plt.show()


if __name__ == "__main__":
    main()
