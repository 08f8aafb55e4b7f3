# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "matplotlib>=3.8", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Plots mu_v, mu_h and mu_tot over alpha and beta, one row of panels for each f.

    python scripts/surface.py results/quick
    uv run scripts/surface.py results/quick -o surface.pdf
"""

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from matplotlib.colors import LogNorm, Normalize
from matplotlib.ticker import LogFormatterMathtext, LogLocator, MaxNLocator, ScalarFormatter
from matplotlib.patheffects import withStroke

PANELS = {
    "mu_v": (r"\mu_v", "viscoelastic"),
    "mu_h": (r"\mu_h", "hydrodynamic"),
    "mu_tot": (r"\mu_{tot}", "total"),
}
# Even steps of colour look even, also to the colour-blind and in print.
PALETTE = "viridis"
FAILED = "#d55e00"


def open_results(directory):
    """The published data set, with the places that a logarithmic axis can show and that depend on alpha."""
    path = directory / "results.h5"
    if not path.is_file():
        sys.exit(f"{path}: no such file; give a directory in which `stribeck run` has published its results")
    data = xr.open_dataset(path, engine="h5netcdf")
    for name in ("alpha", "beta"):
        shown = np.isfinite(data[name].values) & (data[name].values > 0)
        left_out = data[name].values[~shown]
        if left_out.size:
            print(f"not shown, as the axis is logarithmic: {name} = {', '.join(f'{v:g}' for v in left_out)}")
        data = data.isel({name: shown})
        if data.sizes[name] < 2:
            sys.exit(
                f"{path}: {name} has {data.sizes[name]} value(s) on a logarithmic axis, a surface needs at least 2; "
                f"add values of {name} to the sweep file and run it again"
            )
    retarded = data["f"].values > 0
    if not retarded.any():
        sys.exit(f"{path}: at f = 0 nothing depends on alpha, there is no surface; add values of f to the sweep file")
    if not retarded.all():
        print("not shown, as it does not depend on alpha: f = 0")
    return data.isel(f=retarded)


def edges(centres):
    """Edges of the cells around the values of a logarithmic axis."""
    logs = np.log(centres)
    middles = (logs[1:] + logs[:-1]) / 2
    return np.exp(np.concatenate([[2 * logs[0] - middles[0]], middles, [2 * logs[-1] - middles[-1]]]))


def colour_scale(values):
    """Scale and levels of the contour lines for the values of a panel."""
    low, high = np.nanmin(values), np.nanmax(values)
    if low > 0 and high / low > 30:
        first, last = np.floor(np.log10(low)), np.ceil(np.log10(high))
        in_a_decade = [1, 2, 5] if last - first <= 4 else [1]
        levels = np.outer(10.0 ** np.arange(first, last + 1), in_a_decade).ravel()
        scale = LogNorm(low, high)
    else:
        if high - low < 1e-9 * max(abs(low), abs(high), 1e-12):
            low, high = low - 0.5 * max(abs(low), 1e-12), high + 0.5 * max(abs(high), 1e-12)
        levels = MaxNLocator(7).tick_values(low, high)
        scale = Normalize(low, high)
    return scale, levels[(levels > low) & (levels < high)]


def draw_panel(axes, figure, panel, failed, symbol):
    """One surface: colours, contour lines with their values, crosses where a case failed."""
    alpha, beta, values = panel["alpha"].values, panel["beta"].values, panel.transpose("beta", "alpha").values
    axes.set(xscale="log", yscale="log", xlim=(alpha[0], alpha[-1]), ylim=(beta[0], beta[-1]))
    axes.set_facecolor("0.85")
    if np.isfinite(values).any():
        scale, levels = colour_scale(values)
        # Cells reach half a step beyond the axes, so that each value keeps its place; smooth colours need all values.
        if np.isfinite(values).all():
            mesh = axes.pcolormesh(alpha, beta, values, norm=scale, cmap=PALETTE, shading="gouraud", rasterized=True)
        else:
            mesh = axes.pcolormesh(edges(alpha), edges(beta), values, norm=scale, cmap=PALETTE, rasterized=True)
        if levels.size:
            lines = axes.contour(alpha, beta, values, levels=levels, colors="white", linewidths=0.9)
            halo = [withStroke(linewidth=1.8, foreground="0.2")]
            lines.set_path_effects(halo)
            for label in axes.clabel(lines, fontsize=8, fmt=lambda level: f"{level:g}", inline_spacing=3):
                label.set_path_effects([withStroke(linewidth=2.2, foreground="0.2")])
                # steep labels all read upwards
                angle = (label.get_rotation() + 90) % 180 - 90
                label.set_rotation(angle + 180 if angle < -75 else angle)
        bar = figure.colorbar(mesh, ax=axes, pad=0.02, aspect=24)
        bar.ax.set_title(rf"${symbol}\,R/a_0$", fontsize=11, loc="left")
        if isinstance(scale, Normalize) and not isinstance(scale, LogNorm):
            bar.formatter = ScalarFormatter(useMathText=True)
            bar.formatter.set_powerlimits((-3, 4))
            bar.update_ticks()
    rows, columns = np.nonzero(failed.transpose("beta", "alpha").values)
    if rows.size:
        axes.plot(alpha[columns], beta[rows], "x", color=FAILED, ms=6, mew=1.8, clip_on=False, zorder=5)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(numticks=12))
        axis.set_major_formatter(LogFormatterMathtext())
    axes.grid(False)


def draw(data):
    """The whole figure."""
    count = data.sizes["f"]
    plt.rcParams.update({"font.size": 10, "axes.titlesize": 11, "mathtext.fontset": "stix", "axes.linewidth": 0.8})
    figure, grid = plt.subplots(
        count, len(PANELS), figsize=(12.6, 1.0 + 3.2 * count), squeeze=False, sharex=True, sharey=True, layout="constrained"
    )
    figure.get_layout_engine().set(rect=(0, 0, 0.985, 1))
    failed = data["status"] == 1
    for i, row in enumerate(grid):
        strength = float(data["f"][i])
        for axes, (name, (symbol, word)) in zip(row, PANELS.items()):
            draw_panel(axes, figure, data[name].isel(f=i), failed.isel(f=i), symbol)
            axes.set_title(f"{word} friction, $f = {strength:g}$")
            if i == count - 1:
                axes.set_xlabel(r"$\alpha = a_0/(V\tau)$")
        row[0].set_ylabel(r"$\beta = E_\infty^* a_0^4/(12\,\eta V R^3)$")
    failures = int(failed.sum())
    title = data.attrs["title"]
    if failures:
        title += f"\n({failures} failed {'case' if failures == 1 else 'cases'} marked ×)"
    figure.suptitle(title, fontsize=13)
    return figure


def main():
    parser = argparse.ArgumentParser(description="Plots friction over alpha and beta from results.h5.")
    parser.add_argument("results", type=Path, metavar="RESULTS_DIR", help="directory that `stribeck run` wrote")
    parser.add_argument("-o", "--output", type=Path, help="picture to write [RESULTS_DIR/surface.png]; also .pdf, .svg")
    arguments = parser.parse_args()
    output = arguments.output or arguments.results / "surface.png"
    figure = draw(open_results(arguments.results))
    figure.savefig(output, dpi=160)
    print(f"wrote {output}")


if __name__ == "__main__":
    main()
