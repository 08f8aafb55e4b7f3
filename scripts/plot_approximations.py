# /// script
# requires-python = ">=3.10"
# dependencies = ["matplotlib>=3.8", "numpy>=1.26"]
# ///
"""Draws the errors of approximations over β.

Usage:
    cargo run --release -p stribeck-solver --example where_approximations_hold -- --csv errors.csv
    python scripts/plot_approximations.py errors.csv -o docs/figures/approximations.svg
"""

import csv
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from lib.style import BLUE, GREEN, ORANGE, PURPLE, VERMILION
from lib.table_picture import draw_table

F = 100.0
ALPHAS = [0.01, 1.0, 100.0]
# Label of a row of panels, and its curves: words, colour and dashes by column of the table.
ROWS = [
    (
        "error of $c$, %",
        {
            "equation_49": ("Eq. 49", VERMILION, "-"),
            "relaxed": (r"$0.4458\,\beta^{-3/5}$", ORANGE, (0, (1, 1.2))),
            "asymptote": ("power law, exact factor", GREEN, "--"),
            "formula": ("formula", BLUE, "-"),
        },
    ),
    (
        "error of friction, %",
        {
            "dry_mu_v": (r"dry, for $\mu_v$", PURPLE, "-"),
            "approx_mu_h": (r"approx_mu_h, for the film's $\mu_h$", "black", (0, (5, 1, 1, 1))),
        },
    ),
]


def read(path):
    """{alpha: {column: values along beta}} at the f of the figure."""
    lines = defaultdict(lambda: defaultdict(list))
    with path.open() as rows:
        for row in csv.DictReader(rows):
            if float(row["f"]) == F:
                for name, value in row.items():
                    lines[float(row["alpha"])][name].append(float(value))
    return lines


def draw(lines):
    """The figure with a column of panels for each alpha."""
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 5.0), sharex=True, sharey="row", layout="constrained")
    for row, (label, curves) in zip(axes, ROWS, strict=True):
        for axis, alpha in zip(row, ALPHAS, strict=True):
            line = lines[alpha]
            for name, (words, colour, dashes) in curves.items():
                error = 100 * np.abs(line[name])
                axis.loglog(line["beta"], error, color=colour, linestyle=dashes, linewidth=1.4, label=words)
            for bound in (1, 5, 20):
                axis.axhline(bound, color="0.7", linewidth=0.6, zorder=0)
            axis.tick_params(labelsize=8)
            axis.minorticks_off()
        row[0].set_ylabel(label, fontsize=9)
    axes[0, 0].set_ylim(0.02, 1e4)
    axes[1, 0].set_ylim(0.02, 1e3)
    for axis, alpha in zip(axes[0], ALPHAS, strict=True):
        axis.set_title(rf"$\alpha$ = {alpha:g}, $f$ = {F:g}", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel(r"$\beta$", fontsize=9)
    handles = [handle for row in axes for handle in row[0].get_lines() if not handle.get_label().startswith("_")]
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=8, frameon=False)
    return figure


if __name__ == "__main__":
    words = "what the example `where_approximations_hold` writes"
    draw_table(__doc__, words, lambda table: draw(read(table)), "approximations")
