# /// script
# requires-python = ">=3.10"
# dependencies = ["matplotlib>=3.8", "numpy>=1.26"]
# ///
"""Plots the errors of approximations over β.

    cargo run --release --example where_approximations_hold -- --csv errors.csv
    python scripts/plot_approximations.py errors.csv -o docs/figures/approximations.svg
"""

import csv
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from plot_convergence import draw

F = 100.0
ALPHAS = [0.01, 1.0, 100.0]
# Colours of Okabe and Ito, which the colour-blind tell apart; the dashes differ too.
ROWS = [
    (
        "error of $c$, %",
        {
            "equation_49": ("Eq. 49", "#D55E00", "-"),
            "relaxed": (r"$0.4458\,\beta^{-3/5}$", "#E69F00", (0, (1, 1.2))),
            "asymptote": ("power law, exact factor", "#009E73", "--"),
            "formula": ("formula", "#0072B2", "-"),
        },
    ),
    (
        "error of friction, %",
        {
            "dry_mu_v": (r"dry, for $\mu_v$", "#CC79A7", "-"),
            "approx_mu_h": (r"approx_mu_h, for the film's $\mu_h$", "#000000", (0, (5, 1, 1, 1))),
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


def plot(lines):
    figure, axes = plt.subplots(2, 3, figsize=(7.2, 5.0), sharex=True, sharey="row", layout="constrained")
    for row, (label, curves) in zip(axes, ROWS):
        for axis, alpha in zip(row, ALPHAS):
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
    for axis, alpha in zip(axes[0], ALPHAS):
        axis.set_title(rf"$\alpha$ = {alpha:g}, $f$ = {F:g}", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel(r"$\beta$", fontsize=9)
    handles = [handle for row in axes for handle in row[0].get_lines() if not handle.get_label().startswith("_")]
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=8, frameon=False)
    return figure


if __name__ == "__main__":
    table = "what the example `where_approximations_hold` writes"
    draw(__doc__, table, lambda table: plot(read(table)), "approximations")
