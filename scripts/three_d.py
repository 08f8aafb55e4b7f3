"""Surfaces in three dimensions on logarithmic axes, which mplot3d lacks: powers of ten stand on linear axes of exponents."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import Normalize

from results_file import ALPHA, BETA, FAILED, PAGE, PALETTE, count


def exponent_ticks(axis, low, high):
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


def draw_surface(axes, values, failed, symbol):
    """The heights of one f over alpha and beta; failed cases are holes, marked on the floor."""
    alpha, beta = np.log10(values["alpha"].values), np.log10(values["beta"].values)
    heights = values.transpose("beta", "alpha").values
    finite = heights[np.isfinite(heights)]
    logarithmic = finite.size > 0 and finite.min() > 0 and finite.max() > 3 * finite.min()
    if logarithmic:
        heights, finite = np.log10(heights), np.log10(finite)
    low, high = (finite.min(), finite.max()) if finite.size else (0.0, 1.0)
    room = max(0.04 * (high - low), 1e-3 * max(abs(high), 1e-9))
    low, high = low - room, high + room
    x, y = np.meshgrid(alpha, beta)
    axes.plot_surface(
        x, y, heights, cmap=PALETTE, norm=Normalize(low, high), rstride=1, cstride=1, linewidth=0.15, edgecolor="0.25"
    )
    rows, columns = np.nonzero(failed.transpose("beta", "alpha").values)
    if rows.size:
        axes.plot(alpha[columns], beta[rows], low, "x", color=FAILED, ms=4.5, mew=1.4, zorder=0)
    axes.set(xlim=(alpha[0], alpha[-1]), ylim=(beta[0], beta[-1]), zlim=(low, high))
    exponent_ticks(axes.xaxis, alpha[0], alpha[-1])
    exponent_ticks(axes.yaxis, beta[0], beta[-1])
    if logarithmic:
        exponent_ticks(axes.zaxis, low, high)
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
    axes.set_zlabel(rf"${symbol}\,R/a_0$", labelpad=0)
    axes.view_init(elev=28, azim=-122)
    axes.set_box_aspect((1.25, 1, 0.85), zoom=1.02)


def draw_three_d(data, name, symbol, word):
    """One quantity, one surface for each f."""
    number = data.sizes["f"]
    columns = min(number, 2)
    rows = -(-number // columns)
    width = PAGE if columns == 2 else PAGE * 0.55
    failed = data["status"] == 1
    failures = int(failed.sum())
    title = data.attrs["title"] + (f"\n({count(failures, 'failed case')} marked × on the floor)" if failures else "")
    head, foot = (0.25 if failures else 0.1), 0.25
    height = head + 2.6 * rows + foot
    figure = plt.figure(figsize=(width, height))
    figure.suptitle(title, y=1 - 0.04 / height, va="top")
    for i in range(number):
        axes = figure.add_subplot(rows, columns, i + 1, projection="3d", computed_zorder=False)
        draw_surface(axes, data[name].isel(f=i), failed.isel(f=i), symbol)
        axes.set_title(f"{word} friction, $f = {float(data['f'][i]):g}$", y=0.97)
    # mplot3d leaves room above each box and none below it.
    figure.subplots_adjust(left=0.06, right=0.98, bottom=foot / height, top=1 - head / height, wspace=0.12, hspace=0.2)
    return figure
