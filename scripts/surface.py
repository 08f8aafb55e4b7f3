# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "matplotlib>=3.8", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Draws mu_v, mu_h and mu_tot over alpha and beta, one row of panels for each f.

Usage:
    python scripts/surface.py results/quick
    uv run scripts/surface.py results/quick -o surface.pdf
    uv run scripts/surface.py results/quick --three-d --quantity mu_h
"""

import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, Normalize
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator, ScalarFormatter

from lib.log_axes import edges, label_decades, label_range
from lib.messages import fail, format_count
from lib.results import open_results
from lib.style import ALPHA, BETA, FAILED, PAGE, PALETTE, picture_path, print_style, save
from lib.surfaces_3d import draw_surfaces

PANELS = {
    "mu_v": (r"\mu_v", "viscoelastic"),
    "mu_h": (r"\mu_h", "hydrodynamic"),
    "mu_tot": (r"\mu_{tot}", "total"),
}


def open_surface(directory):
    """The published data set without what a surface cannot show: f = 0, and values that no logarithmic axis has."""
    path = directory / "results.h5"
    data = open_results(directory)
    for name in ("alpha", "beta"):
        shown = np.isfinite(data[name].values) & (data[name].values > 0)
        left_out = data[name].values[~shown]
        if left_out.size:
            print(f"not shown, as the axis is logarithmic: {name} = {', '.join(f'{v:g}' for v in left_out)}")
        data = data.isel({name: shown})
        if data.sizes[name] < 2:
            fail(
                f"{path}: {name} has {data.sizes[name]} value(s) on a logarithmic axis, a surface needs at least 2; "
                f"add values of {name} to the sweep file and run it again"
            )
    retarded = data["f"].values > 0
    if not retarded.any():
        fail(f"{path}: at f = 0 nothing depends on alpha, there is no surface; add values of f to the sweep file")
    if not retarded.all():
        print("not shown, as it does not depend on alpha: f = 0")
    return data.isel(f=retarded)


def colour_scale(values):
    """Scale and levels of the contour lines for the values of a panel."""
    low, high = np.nanmin(values), np.nanmax(values)
    if low > 0 and high / low > 10:
        first, last = np.floor(np.log10(low)), np.ceil(np.log10(high))
        in_a_decade = [1, 2, 5] if last - first <= 4 else [1]
        levels = np.outer(10.0 ** np.arange(first, last + 1), in_a_decade).ravel()
        scale = LogNorm(low, high)
    else:
        if high - low < 1e-9 * max(abs(low), abs(high), 1e-12):
            low, high = low - 0.5 * max(abs(low), 1e-12), high + 0.5 * max(abs(high), 1e-12)
        levels = MaxNLocator(6).tick_values(low, high)
        scale = Normalize(low, high)
    return scale, levels[(levels > low) & (levels < high)]


def draw_colours(axes, panel, scale):
    """Draws the values of a panel as colours."""
    alpha, beta, values = panel["alpha"].values, panel["beta"].values, panel.values
    style = {"norm": scale, "cmap": PALETTE, "rasterized": True}
    # Smooth colours need all values.
    if np.isfinite(values).all():
        return axes.pcolormesh(alpha, beta, values, shading="gouraud", **style)
    # Cells reach half a step beyond the axes, so that each value keeps its place.
    return axes.pcolormesh(edges(alpha), edges(beta), values, **style)


def draw_contours(axes, panel, levels):
    """Draws contour lines with their values."""
    lines = axes.contour(panel["alpha"], panel["beta"], panel.values, levels=levels, colors="white", linewidths=0.7)
    lines.set_path_effects([withStroke(linewidth=1.3, foreground="0.2")])
    for label in axes.clabel(lines, fontsize=7, fmt=lambda level: f"{level:g}", inline=False):
        label.set_path_effects([withStroke(linewidth=1.6, foreground="0.2")])
        # Steep labels all read upwards.
        angle = (label.get_rotation() + 90) % 180 - 90
        label.set_rotation(90 if abs(angle) > 60 else angle)


def add_colour_bar(axes, mesh, symbol):
    """Adds the colour bar of a panel."""
    bar = axes.figure.colorbar(mesh, ax=axes, pad=0.02, aspect=24)
    bar.ax.set_title(rf"${symbol}\,R/a_0$", fontsize=8, loc="left")
    if isinstance(mesh.norm, LogNorm):
        label_range(bar.ax.yaxis, mesh.norm.vmin, mesh.norm.vmax)
    else:
        bar.formatter = ScalarFormatter(useMathText=True)
        bar.formatter.set_powerlimits((-3, 4))
        bar.update_ticks()


def draw_panel(axes, panel, failed, symbol):
    """Draws one surface: colours, contour lines with their values, crosses where a case failed."""
    panel = panel.transpose("beta", "alpha")
    alpha, beta = panel["alpha"].values, panel["beta"].values
    axes.set(xscale="log", yscale="log", xlim=(alpha[0], alpha[-1]), ylim=(beta[0], beta[-1]))
    axes.set_facecolor("0.85")
    if np.isfinite(panel.values).any():
        scale, levels = colour_scale(panel.values)
        mesh = draw_colours(axes, panel, scale)
        if levels.size:
            draw_contours(axes, panel, levels)
        add_colour_bar(axes, mesh, symbol)
    rows, columns = np.nonzero(failed.transpose("beta", "alpha").values)
    if rows.size:
        axes.plot(alpha[columns], beta[rows], "x", color=FAILED, ms=4.5, mew=1.4, clip_on=False, zorder=5)
    label_decades(axes.xaxis)
    label_decades(axes.yaxis)
    axes.grid(False)


def keep_apart(figure):
    """Hides labels of contour lines that lie over another one or reach out of their panel."""
    # Laid out once: a second time would take panels and labels elsewhere.
    figure.get_layout_engine().execute(figure)
    figure.set_layout_engine("none")
    for axes in figure.axes:
        panel, kept = axes.get_window_extent(), []
        for label in [text for text in axes.texts if text.get_text()]:
            box = label.get_window_extent()
            inside = panel.x0 <= box.x0 and box.x1 <= panel.x1 and panel.y0 <= box.y0 and box.y1 <= panel.y1
            if inside and not any(box.overlaps(other) for other in kept):
                kept.append(box)
            else:
                label.set_visible(False)


def draw_maps(data):
    """The figure with a row of panels for each f."""
    rows = data.sizes["f"]
    size = (PAGE, 0.75 + 1.85 * rows)
    shared = {"sharex": True, "sharey": True}
    figure, grid = plt.subplots(rows, len(PANELS), figsize=size, squeeze=False, layout="constrained", **shared)
    figure.get_layout_engine().set(rect=(0, 0, 0.99, 1), w_pad=0.02)
    failed = data["status"] == 1
    for i, row in enumerate(grid):
        strength = float(data["f"][i])
        for axes, (name, (symbol, word)) in zip(row, PANELS.items(), strict=True):
            draw_panel(axes, data[name].isel(f=i), failed.isel(f=i), symbol)
            axes.set_title(f"{word}, $f = {strength:g}$", loc="left")
            if i == rows - 1:
                axes.set_xlabel(ALPHA)
        row[0].set_ylabel(BETA)
    failures = int(failed.sum())
    title = data.attrs["title"]
    if failures:
        title += f"\n({format_count(failures, 'failed case')} marked ×)"
    figure.suptitle(title)
    keep_apart(figure)
    return figure


def main():
    """Draws the results directory of the command line."""
    parser = argparse.ArgumentParser(description="Draws friction over alpha and beta from results.h5.")
    parser.add_argument("results", type=Path, metavar="RESULTS_DIR", help="directory that `stribeck run` wrote")
    parser.add_argument(
        "-o", "--output", type=picture_path, help="picture to write [RESULTS_DIR/surface.png]; also .pdf, .svg"
    )
    parser.add_argument("--three-d", action="store_true", help="a surface in three dimensions for each f")
    parser.add_argument("--quantity", choices=PANELS, default="mu_tot", help="what --three-d shows [mu_tot]")
    arguments = parser.parse_args()
    output = arguments.output or arguments.results / "surface.png"
    data = open_surface(arguments.results)
    print_style()
    if arguments.three_d:
        figure = draw_surfaces(data, arguments.quantity, *PANELS[arguments.quantity])
    else:
        figure = draw_maps(data)
    save(figure, output)


if __name__ == "__main__":
    main()
