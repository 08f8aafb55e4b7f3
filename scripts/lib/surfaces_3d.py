"""Draws surfaces in three dimensions over logarithmic axes.

mplot3d has no logarithmic axes: powers of ten stand on linear axes of exponents.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import Normalize

from lib.messages import format_count
from lib.style import ALPHA, BETA, FAILED, PAGE, PALETTE


def label_exponents(axis, low, high):
    """Labels the exponents from low to high: decades, or with 2 and 5 between them below two decades."""
    if high - low >= 2 - 1e-9:
        ticks = np.arange(np.ceil(low - 1e-9), np.floor(high + 1e-9) + 1)
        ticks = ticks[:: 1 + ticks.size // 8]
        labels = [f"$10^{{{tick:.0f}}}$" for tick in ticks]
    else:
        decades = np.arange(np.floor(low), np.ceil(high) + 1)
        ticks = np.add.outer(decades, np.log10([1, 2, 5])).ravel()
        ticks = ticks[(ticks >= low - 1e-9) & (ticks <= high + 1e-9)]
        labels = [f"{10**tick:.3g}" for tick in ticks]
    axis.set_ticks(ticks, labels)


def scale_heights(heights):
    """The heights to draw, the ends of their axis, and whether they are exponents of ten, as for a wide range."""
    finite = heights[np.isfinite(heights)]
    logarithmic = finite.size > 0 and finite.min() > 0 and finite.max() > 3 * finite.min()
    if logarithmic:
        heights, finite = np.log10(heights), np.log10(finite)
    low, high = (finite.min(), finite.max()) if finite.size else (0.0, 1.0)
    room = max(0.04 * (high - low), 1e-3 * max(abs(high), 1e-9))
    return heights, (low - room, high + room), logarithmic


def draw_surface(axes, values, failed, symbol):
    """Draws the heights of one f over alpha and beta; failed cases are holes, marked on the floor."""
    alpha, beta = np.log10(values["alpha"].values), np.log10(values["beta"].values)
    heights, ends, logarithmic = scale_heights(values.transpose("beta", "alpha").values)
    x, y = np.meshgrid(alpha, beta)
    edges = {"linewidth": 0.15, "edgecolor": "0.25"}
    axes.plot_surface(x, y, heights, cmap=PALETTE, norm=Normalize(*ends), rstride=1, cstride=1, **edges)
    rows, columns = np.nonzero(failed.transpose("beta", "alpha").values)
    if rows.size:
        axes.plot(alpha[columns], beta[rows], ends[0], "x", color=FAILED, ms=4.5, mew=1.4, zorder=0)
    axes.set(xlim=(alpha[0], alpha[-1]), ylim=(beta[0], beta[-1]), zlim=ends)
    label_exponents(axes.xaxis, alpha[0], alpha[-1])
    label_exponents(axes.yaxis, beta[0], beta[-1])
    if logarithmic:
        label_exponents(axes.zaxis, *ends)
    arrange(axes)
    axes.set_zlabel(rf"${symbol}\,R/a_0$", labelpad=0)


def arrange(axes):
    """Sets the view, and brings the labels near the axes."""
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.pane.set_edgecolor("0.8")
    axes.tick_params(axis="x", pad=-2)
    axes.tick_params(axis="y", pad=-2)
    axes.tick_params(axis="z", pad=0)
    # Labels of the two horizontal axes go apart at the corner where they meet.
    for axis, side in ((axes.xaxis, "left"), (axes.yaxis, "right")):
        for label in axis.get_majorticklabels():
            label.set_horizontalalignment(side)
    axes.set_xlabel(ALPHA, labelpad=0)
    axes.set_ylabel(BETA, labelpad=0)
    axes.view_init(elev=28, azim=-122)
    axes.set_box_aspect((1.25, 1, 0.85), zoom=1.02)


def draw_surfaces(data, name, symbol, word):
    """The figure of one quantity, with one surface for each f."""
    number = data.sizes["f"]
    columns = min(number, 2)
    rows = -(-number // columns)
    width = PAGE if columns == 2 else PAGE * 0.55
    failed = data["status"] == 1
    failures = int(failed.sum())
    marked = f"\n({format_count(failures, 'failed case')} marked × on the floor)" if failures else ""
    head, foot = (0.25 if failures else 0.1), 0.25
    height = head + 2.6 * rows + foot
    figure = plt.figure(figsize=(width, height))
    figure.suptitle(data.attrs["title"] + marked, y=1 - 0.04 / height, va="top")
    for i in range(number):
        axes = figure.add_subplot(rows, columns, i + 1, projection="3d", computed_zorder=False)
        draw_surface(axes, data[name].isel(f=i), failed.isel(f=i), symbol)
        axes.set_title(f"{word} friction, $f = {float(data['f'][i]):g}$", y=0.97)
    # mplot3d leaves room above each box and none below it.
    figure.subplots_adjust(left=0.06, right=0.98, bottom=foot / height, top=1 - head / height, wspace=0.12, hspace=0.2)
    return figure
