"""One look for all pictures in print: colours, labels, type, and how a picture is saved."""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.backend_bases import FigureCanvasBase

from lib.messages import fail

# Even steps of colour look even, also to the colour-blind and in print.
PALETTE = "viridis"
# Colours of Okabe and Ito, which the colour-blind tell apart.
BLUE, ORANGE, GREEN, VERMILION, PURPLE = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7"
FAILED = VERMILION
# Full width of a page in inches: pictures are made at the size at which they are printed.
PAGE = 7.1
ALPHA = r"$\alpha = a_0/(V\tau)$"
BETA = r"$\beta = E_\infty^* a_0^4/(12\,\eta V R^3)$"


def print_style():
    """Sets type of 8 points, thin lines, and text that stays text."""
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


def picture_path(text):
    """The name of a picture to write, checked before anything is drawn."""
    path = Path(text)
    if path.suffix[1:].lower() not in FigureCanvasBase.get_supported_filetypes():
        raise argparse.ArgumentTypeError(
            f"{path}: no kind of picture that can be written; end its name in .png, .pdf or .svg"
        )
    if not path.parent.is_dir():
        raise argparse.ArgumentTypeError(f"{path.parent}: no such directory; name a file in a directory that exists")
    return path


def save(figure, path):
    """Writes a picture in the format that its name ends in."""
    try:
        figure.savefig(path, dpi=300)
    except OSError as error:
        fail(f"{path}: {error.strerror}; name a file in a directory that exists and may be written to")
    print(f"wrote {path}")
