"""Draws a comparison: a map of relative differences for each f, and differences over estimated errors."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from lib.log_axes import edges, format_value, label_values, positions
from lib.style import ALPHA, BETA, BLUE, FAILED, GREEN, PAGE, PALETTE, VERMILION

EQUAL = "0.82"
SYMBOLS = {
    "mu_v": r"\mu_v",
    "mu_h": r"\mu_h",
    "mu_tot": r"\mu_{tot}",
    "c": "c",
    "film_min": r"u_{min}",
    "p_max": r"p_{max}",
}
MARKS = {"mu_v": (VERMILION, "s"), "mu_h": (BLUE, "^"), "c": (GREEN, "o")}
# How far below the largest difference colours reach.
REACH = 1e5


def colour_scale(values):
    """One logarithmic scale for all maps; None if nothing differs by a finite number."""
    differing = values[np.isfinite(values) & (values > 0)]
    if not differing.size:
        return None
    high = differing.max()
    low = max(differing.min(), high / REACH)
    return LogNorm(low, high if high > low * 1.5 else low * 1.5)


def draw_map(axes, comparison, name, i_f, norm):
    """Draws the differences at one f; returns what carries the colours, None if there are none."""
    values = comparison.difference[name].isel(f=i_f).transpose("beta", "alpha").values
    alpha, beta = comparison.a["alpha"].values, comparison.a["beta"].values
    x, y = positions(alpha), positions(beta)
    axes.set(xscale="log", yscale="log", facecolor="white")
    mesh = None
    if norm is not None:
        differing = np.ma.masked_where(~(values > 0), values)
        mesh = axes.pcolormesh(edges(x), edges(y), differing, norm=norm, cmap=PALETTE, rasterized=True)
    equal = np.ma.masked_where(values != 0, np.zeros_like(values))
    axes.pcolormesh(edges(x), edges(y), equal, cmap=ListedColormap([EQUAL]), rasterized=True)
    for failed, colour, mark in (
        (comparison.changed, FAILED, "x"),
        (comparison.failed_a & comparison.failed_b, "black", "+"),
    ):
        rows, columns = np.nonzero(failed.isel(f=i_f).transpose("beta", "alpha").values)
        if rows.size:
            axes.plot(x[columns], y[rows], mark, color=colour, ms=4.5, mew=1.3, clip_on=False)
    label_values(axes.xaxis, alpha)
    label_values(axes.yaxis, beta)
    axes.set_title(f"$f = {format_value(float(comparison.a['f'][i_f]))}$", loc="left")
    return mesh


def draw_scatter(axes, comparison):
    """Draws each difference over the sum of the estimated errors, which do not explain what lies above the line."""
    ends, unseen = [], 0
    for name, (colour, mark) in MARKS.items():
        difference, estimate = comparison.difference[name].values.ravel(), comparison.estimate[name].values.ravel()
        both = (difference > 0) & (estimate > 0) & np.isfinite(difference)
        unseen += int(((difference == 0) & np.isfinite(estimate)).sum())
        style = {"ms": 2.6, "mew": 0, "alpha": 0.55, "color": colour, "label": f"${SYMBOLS[name]}$"}
        axes.plot(estimate[both], difference[both], mark, **style)
        ends += [*estimate[both], *difference[both]]
    axes.set_title("all f" if comparison.a.sizes["f"] > 1 else "", loc="left")
    if not ends:
        axes.set_axis_off()
        words = "no difference\nbeside an estimated error"
        axes.text(0.5, 0.5, words, ha="center", va="center", transform=axes.transAxes)
        return
    low, high = min(ends) / 2, max(ends) * 2
    axes.plot([low, high], [low, high], color="0.3", linewidth=0.9, linestyle="--")
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(low, high))
    axes.set(xlabel="sum of estimated errors", ylabel="relative difference")
    axes.legend(loc="upper left", frameon=False, handletextpad=0.1, borderpad=0.1, labelspacing=0.25, markerscale=1.8)
    if unseen:
        words = f"{unseen} equal, not shown"
        axes.text(0.97, 0.03, words, transform=axes.transAxes, ha="right", va="bottom", fontsize=7)


def add_legend(figure):
    """Explains the marks of all panels below them."""
    figure.legend(
        handles=[
            Patch(facecolor=EQUAL, edgecolor="0.5", label="equal"),
            Line2D([], [], linestyle="", marker="x", color=FAILED, mew=1.3, label="failed in one alone"),
            Line2D([], [], linestyle="", marker="+", color="black", mew=1.3, label="failed in both"),
            Line2D([], [], linestyle="--", color="0.3", linewidth=0.9, label="difference = estimate"),
        ],
        loc="outside lower center",
        ncols=4,
        frameon=False,
    )


def draw_comparison(comparison, name):
    """The figure with a map of one quantity for each f, and the differences of all over their estimates."""
    number = comparison.a.sizes["f"]
    columns = 2 if number + 1 in (2, 4) else 3
    rows = -(-(number + 1) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(PAGE, 0.85 + 2.1 * rows), squeeze=False, layout="constrained")
    panels = list(grid.ravel())
    norm = colour_scale(comparison.difference[name].values)
    meshes = [draw_map(axes, comparison, name, i, norm) for i, axes in enumerate(panels[:number])]
    for axes in panels[:number]:
        axes.set_xlabel(ALPHA)
    for i in range(0, number, columns):
        panels[i].set_ylabel(BETA)
    draw_scatter(panels[number], comparison)
    for axes in panels[number + 1 :]:
        axes.remove()
    # Two columns are wide: a colour bar beside each map keeps them of one size.
    for i in range(number) if columns == 2 else [number - 1]:
        if norm is not None:
            bar = figure.colorbar(meshes[i], ax=panels[i], pad=0.03, aspect=24, extend="min")
            bar.set_label(rf"difference of ${SYMBOLS[name]}$")
    add_legend(figure)
    a, b = (comparison.whole[letter].attrs["title"] for letter in "AB")
    figure.suptitle(f"{a}: B against A" if a == b else f"A: {a}\nB: {b}")
    return figure
