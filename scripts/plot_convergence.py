# /// script
# requires-python = ">=3.10"
# dependencies = ["matplotlib>=3.8", "numpy>=1.26"]
# ///
"""Draws the error of the collocation solver over the number of unknowns, one panel for each case.

Usage:
    cargo run --release -p stribeck-solver --example convergence > convergence.csv
    python scripts/plot_convergence.py convergence.csv -o docs/figures/collocation_convergence.svg
"""

import csv
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, NullFormatter, ScalarFormatter

from lib.style import BLUE, ORANGE, VERMILION
from lib.table_picture import draw_table

STYLES = {"4": (BLUE, "s"), "6": (ORANGE, "^"), "8": (VERMILION, "o")}
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
    """What is written above the panel of a case."""
    f, alpha, beta = case
    power = rf"$10^{{{round(np.log10(float(beta)))}}}$"
    if float(f) == 0:
        return rf"elastic, $\beta$ = {power}"
    return rf"$f$ = {f}, $\alpha$ = {alpha}, $\beta$ = {power}"


def draw(cases):
    """The figure with a panel for each case."""
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 4.8), sharex=True, sharey=True, layout="constrained")
    for axis, (case, degrees) in zip(axes.flat, cases.items(), strict=True):
        for degree, points in degrees.items():
            colour, marker = STYLES[degree]
            mean = means(points)
            style = {"color": colour, "markersize": 4, "markeredgewidth": 0, "alpha": 0.85, "label": f"degree {degree}"}
            axis.loglog(mean[:, 0], mean[:, 1], marker, **style)
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


if __name__ == "__main__":
    draw_table(__doc__, "what the example `convergence` prints", lambda table: draw(read(table)), "convergence")
