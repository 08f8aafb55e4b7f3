# /// script
# requires-python = ">=3.10"
# dependencies = ["matplotlib>=3.8", "numpy>=1.26"]
# ///
"""Plots the error of the collocation solver over the number of unknowns, one panel for each case.

    cargo run --release --example convergence > convergence.csv
    python scripts/plot_convergence.py convergence.csv -o docs/figures/collocation_convergence.svg
"""

import argparse
import csv
import re
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, NullFormatter, ScalarFormatter

# Colours of Okabe and Ito, which the colour-blind tell apart; the markers differ too.
STYLES = {"4": ("#0072B2", "s"), "6": ("#E69F00", "^"), "8": ("#D55E00", "o")}
UNKNOWNS = [50, 100, 200, 400, 800]


def read(path):
    """{(f, alpha, beta): {degree: rows of (unknowns, error)}}, in the order of the file."""
    cases = defaultdict(lambda: defaultdict(list))
    with path.open() as lines:
        for row in csv.DictReader(lines):
            case = row["f"], row["alpha"], row["beta"]
            cases[case][row["degree"]].append((float(row["unknowns"]), float(row["error"])))
    return cases


def means(points):
    """The geometric mean of the errors at each number of unknowns."""
    grouped = defaultdict(list)
    for unknowns, error in points:
        grouped[unknowns].append(np.log(error))
    return np.array(sorted((unknowns, np.exp(np.mean(logs))) for unknowns, logs in grouped.items()))


def title(case):
    f, alpha, beta = case
    power = rf"$10^{{{round(np.log10(float(beta)))}}}$"
    if float(f) == 0:
        return rf"elastic, $\beta$ = {power}"
    return rf"$f$ = {f}, $\alpha$ = {alpha}, $\beta$ = {power}"


def plot(cases):
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 4.8), sharex=True, sharey=True, layout="constrained")
    for axis, (case, degrees) in zip(axes.flat, cases.items(), strict=True):
        for degree, points in degrees.items():
            colour, marker = STYLES[degree]
            mean = means(points)
            axis.loglog(
                mean[:, 0], mean[:, 1], marker, color=colour, markersize=4, markeredgewidth=0, alpha=0.85,
                label=f"degree {degree}",
            )
        axis.set_title(title(case), fontsize=9)
        axis.grid(color="0.9", linewidth=0.6)
        axis.set_axisbelow(True)
        axis.xaxis.set_major_locator(FixedLocator(UNKNOWNS))
        axis.xaxis.set_major_formatter(ScalarFormatter())
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.tick_params(labelsize=8)
        axis.tick_params(which="minor", length=0)
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3, fontsize=9, frameon=False, handletextpad=0.2)
    figure.supxlabel("unknowns", fontsize=9)
    figure.supylabel(r"largest relative error of $\mu_v$, $\mu_h$ and $c$", fontsize=9)
    return figure


def smaller(svg):
    """The same picture with coordinates to a hundredth of a point and no white space between elements."""
    svg = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    parts = re.split(r"(scale\([^)]*\))", svg)
    parts[::2] = [re.sub(r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", part) for part in parts[::2]]
    svg = "".join(parts)
    return re.sub(r">\s+<", "><", svg)


def draw(description, table, figure_of, salt):
    """The command line of a plot: reads its table, makes the figure of it and saves that."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("table", type=Path, help=table)
    parser.add_argument("-o", "--output", type=Path, required=True, help="the picture: .svg, .png or .pdf")
    options = parser.parse_args()
    # nothing that changes from one run to the next, and no font that a reader may lack
    plt.rcParams.update({"svg.fonttype": "path", "svg.hashsalt": salt})
    metadata = {"Date": None} if options.output.suffix == ".svg" else None
    figure_of(options.table).savefig(options.output, dpi=150, metadata=metadata)
    if options.output.suffix == ".svg":
        options.output.write_text(smaller(options.output.read_text()))


if __name__ == "__main__":
    draw(__doc__, "what the example `convergence` prints", lambda table: plot(read(table)), "convergence")
