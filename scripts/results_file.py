"""What the scripts that draw results.h5 share: opening it by xarray, logarithmic axes, one look for print."""

import sys

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from matplotlib.ticker import FixedLocator, LogFormatterMathtext, LogLocator, NullFormatter

# Even steps of colour look even, also to the colour-blind and in print.
PALETTE = "viridis"
# Colours of Okabe and Ito, which the colour-blind tell apart.
BLUE, ORANGE, GREEN, VERMILION, PURPLE = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7"
FAILED = VERMILION
# Full width of a page in inches: pictures are made at the size at which they are printed.
PAGE = 7.1
ALPHA = r"$\alpha = a_0/(V\tau)$"
BETA = r"$\beta = E_\infty^* a_0^4/(12\,\eta V R^3)$"


def fail(message):
    """Ends the script: the input is wrong, as exit code 2 says in the program too."""
    print(message, file=sys.stderr)
    sys.exit(2)


def open_results(directory):
    """The published data set of a results directory."""
    path = directory / "results.h5"
    if not path.is_file():
        fail(f"{path}: no such file; give a directory in which `stribeck run` has published its results")
    try:
        data = xr.open_dataset(path, engine="h5netcdf")
    except (OSError, ValueError) as error:
        fail(
            f"{path}: not readable as a data set ({error}); `stribeck verify {directory}` says what is damaged, "
            "and the `stribeck run` that made it writes it again"
        )
    dimensions = data.attrs.get("stribeck_dimensions")
    if dimensions is not None:
        fail(
            f"{path}: its dimensions are {text_of(dimensions)}, and this script is for f, alpha and beta; `stribeck plot "
            f"{directory}` draws it"
        )
    return data


def save(figure, path):
    """Writes a picture, in the format that its name ends in."""
    formats = figure.canvas.get_supported_filetypes()
    if path.suffix[1:].lower() not in formats:
        fail(f"{path}: no kind of picture that can be written; end its name in .png, .pdf or .svg")
    try:
        figure.savefig(path, dpi=300)
    except OSError as error:
        fail(f"{path}: {error.strerror}; name a file in a directory that exists and may be written to")
    print(f"wrote {path}")


def print_style():
    """Type of 8 points, thin lines, text that stays text."""
    plt.rcParams.update(
        {
            "font.size": 8,
            "axes.titlesize": 8.5,
            "figure.titlesize": 9,
            "legend.fontsize": 8,
            "mathtext.fontset": "stix",
            "axes.linewidth": 0.7,
            "xtick.major.width": 0.7,
            "ytick.major.width": 0.7,
            "grid.linewidth": 0.4,
            "lines.linewidth": 1.3,
            "pdf.fonttype": 42,
            "svg.fonttype": "none",
        }
    )


def text_of(value):
    """A string of the file, which an engine may hand over as bytes."""
    return value.decode() if isinstance(value, bytes) else str(value)


def count(number, noun):
    """`1 case`, `2 cases`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def decades(axis):
    """Labels a logarithmic axis at its decades alone."""
    axis.set_major_locator(LogLocator(numticks=12))
    axis.set_major_formatter(LogFormatterMathtext())
    axis.set_minor_formatter(NullFormatter())


def label_logarithmic(axis, low, high):
    """Labels the decades of a logarithmic axis from low to high, and 2 and 5 between them if there are few."""
    if high / low > 300:
        decades(axis)
        return
    ticks = np.outer(10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1), [1, 2, 5]).ravel()
    ticks = ticks[(ticks >= low) & (ticks <= high)]
    if ticks.size < 2:
        ticks = np.array([low, np.sqrt(low * high), high])
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(lambda value, _: f"{value:.3g}")
    axis.set_minor_formatter(NullFormatter())
