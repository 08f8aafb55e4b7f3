"""The command line of scripts that draw a table of an example, and pictures that are the same bytes each time."""

import argparse
import re
from pathlib import Path

import matplotlib.pyplot as plt

from lib.style import picture_path


def shorten_svg(svg):
    """The same picture with coordinates to a hundredth of a point and no white space between elements."""
    svg = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    parts = re.split(r"(scale\([^)]*\))", svg)
    parts[::2] = [re.sub(r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", part) for part in parts[::2]]
    return re.sub(r">\s+<", "><", "".join(parts))


def draw_table(description, table, figure_of, salt):
    """Reads the command line, and saves the figure that `figure_of` makes of the table named there.

    `table` says what the table is, and `salt` makes the names within an SVG.
    """
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("table", type=Path, help=table)
    parser.add_argument("-o", "--output", type=picture_path, required=True, help="the picture: .svg, .png or .pdf")
    options = parser.parse_args()
    # Nothing that changes from one run to the next, and no font that a reader may lack.
    plt.rcParams.update({"svg.fonttype": "path", "svg.hashsalt": salt})
    is_svg = options.output.suffix == ".svg"
    figure_of(options.table).savefig(options.output, dpi=150, metadata={"Date": None} if is_svg else None)
    if is_svg:
        options.output.write_text(shorten_svg(options.output.read_text()))
