# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "matplotlib>=3.8", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Compares two sweeps at the places that both have: relative differences beside the errors that both estimate.

Usage:
    uv run scripts/compare.py results/coarse results/fine
    uv run scripts/compare.py results/coarse results/fine -o compare.png --csv compare.csv --tolerance 1e-4

Exit code: 0; with --tolerance 1 if a difference is larger, or a case failed in one of the two alone; 2 if the input is
wrong.
"""

import argparse
import difflib
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from lib.comparison import AXES, ESTIMATED, QUANTITIES, Comparison
from lib.comparison_table import write_table
from lib.difference_map import draw_comparison
from lib.log_axes import format_value
from lib.messages import fail, format_count
from lib.results import decode, open_results
from lib.style import picture_path, print_style, save

SYMBOLS = {"f": "f", "alpha": "α", "beta": "β"}
# Lines of a list that stand for the rest, which --csv has.
FEW = 8


def print_first(lines, noun):
    """Prints some lines and how many there are more."""
    for line in lines[:FEW]:
        print(f"  {line}")
    if len(lines) > FEW:
        print(f"  … and {format_count(len(lines) - FEW, noun)} more")


def format_place(data, index):
    """`f = 100, α = 1, β = 10` of the place with these indices."""
    values = {name: float(data[name][i]) for name, i in zip(AXES, index, strict=True)}
    return ", ".join(f"{SYMBOLS[name]} = {format_value(value)}" for name, value in values.items())


def print_origin(comparison, directories):
    """Prints what was compared, and whether program and sweep files are the same."""
    for letter, directory in directories.items():
        title, places = comparison.whole[letter].attrs["title"], comparison.places[letter]
        print(f"{letter}  {directory}: {title} ({format_count(places, 'place')})")
    a, b = (data.attrs for data in comparison.whole.values())
    versions = a["stribeck_version"], b["stribeck_version"]
    same = versions[0] == versions[1]
    print("program: " + (f"version {versions[0]} in both" if same else f"A {versions[0]}, B {versions[1]}"))
    if a["sweep"] == b["sweep"]:
        print("sweep file: the same text")
        return
    print("sweep file: differs (- A, + B)")
    lines = difflib.unified_diff(a["sweep"].splitlines(), b["sweep"].splitlines(), n=0, lineterm="")
    print_first([line for line in lines if not line.startswith(("---", "+++", "@@"))], "line")


def print_places(comparison):
    """Prints how many places both have, what one has alone, and what became of them."""
    alone = {letter: total - comparison.size for letter, total in comparison.places.items()}
    print(f"\nplaces: {comparison.size} in both, {alone['A']} in A alone, {alone['B']} in B alone")
    for letter, axes in comparison.alone.items():
        for name, values in axes.items():
            if values.size:
                some = ", ".join(map(format_value, values[:FEW])) + (", …" if values.size > FEW else "")
                print(f"  {letter} alone has {SYMBOLS[name]} = {some}")
    in_both = int(comparison.converged.sum())
    both_failed = int((comparison.failed_a & comparison.failed_b).sum())
    changed = int(comparison.changed.sum())
    print(f"status: {in_both} converged in both, {both_failed} failed in both, {changed} failed in one alone")
    lines = []
    for index in zip(*np.nonzero(comparison.changed.values), strict=True):
        letter, data = ("A", comparison.a) if comparison.failed_a.values[index] else ("B", comparison.b)
        lines.append(f"{format_place(data, index)} failed in {letter}: {decode(data['reason'].values[index])}")
    print_first(lines, "place")


def format_difference(comparison, name):
    """One line of the table of differences: a quantity, its differences and their estimates."""
    values = comparison.difference[name].values
    valid = ~np.isnan(values)
    if not valid.any():
        return f"{name:9} {0:8}"
    index = np.unravel_index(np.argmax(np.where(valid, values, -1.0)), values.shape)
    where = f"  {format_place(comparison.a, index)}" if values[index] > 0 else ""
    estimates = f"{'–':>9} {'–':>8} {'–':>7}"
    if name in ESTIMATED:
        known = comparison.estimate[name].values[valid]
        known = known[~np.isnan(known)]
        if known.size:
            beyond = int(comparison.beyond(name).sum())
            estimates = f"{np.median(known):9.1e} {known.max():8.1e} {beyond:7}"
    equal = int((values[valid] == 0).sum())
    found = f"{valid.sum():8} {equal:6} {np.median(values[valid]):8.1e} {values[index]:8.1e}"
    return f"{name:9} {found} {estimates}{where}"


def print_differences(comparison):
    """Prints a line for each quantity, and where estimated errors do not explain a difference."""
    print("\nrelative difference |B - A|/|A|, and the sum of the errors that both estimate")
    found = f"{'compared':>8} {'equal':>6} {'median':>8} {'largest':>8}"
    print(f"{'':9} {found} {'estimate':>9} {'largest':>8} {'beyond':>7}  largest at")
    for name in QUANTITIES:
        print(format_difference(comparison, name))
    print()
    print_beyond(comparison)


def print_beyond(comparison):
    """Prints whether the estimated errors explain the differences."""
    if comparison.largest() == 0 and not comparison.changed.any():
        print("all places that both have are equal")
        return
    explained = True
    for name in ESTIMATED:
        beyond = comparison.beyond(name).values
        if beyond.any():
            explained = False
            difference = comparison.difference[name].values
            ratios = difference[beyond] / np.maximum(comparison.estimate[name].values[beyond], 1e-300)
            print(
                f"{name}: {format_count(int(beyond.sum()), 'difference')} beyond the sum of estimated errors, "
                f"by a factor of {np.median(ratios):.3g} in the median, {ratios.max():.3g} at most; "
                f"the largest of them is {difference[beyond].max():.1e}"
            )
    if explained:
        print("all differences lie within the sum of estimated errors, where there are estimates")
    for name in ESTIMATED:
        if places := int(comparison.not_estimated(name).sum()):
            print(f"{name}: no estimate at {format_count(places, 'place')}, which are not judged")


def judge(comparison, tolerance):
    """Prints whether the two agree to a tolerance, and ends with exit code 1 if they do not."""
    changed = int(comparison.changed.sum())
    if comparison.largest() <= tolerance and not changed:
        print(f"within the tolerance of {tolerance:g}")
        return
    print(
        f"beyond the tolerance of {tolerance:g}: the largest difference is {comparison.largest():.1e}, "
        f"{format_count(changed, 'case')} failed in one alone"
    )
    sys.exit(1)


def positive(text):
    """A number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not 0 < value < np.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is no number above 0")
    return value


def read_arguments():
    """The command line."""
    parser = argparse.ArgumentParser(description="Compares the results.h5 of two sweeps.")
    parser.add_argument("a", type=Path, metavar="DIR_A", help="directory that `stribeck run` wrote")
    parser.add_argument("b", type=Path, metavar="DIR_B", help="the other one")
    parser.add_argument("-o", "--output", type=picture_path, help="picture to write: .png, .pdf, .svg")
    parser.add_argument("--quantity", choices=QUANTITIES, default="mu_tot", help="what the maps show [mu_tot]")
    parser.add_argument("--csv", type=Path, help="table of all places to write")
    parser.add_argument("--tolerance", type=positive, help="largest relative difference for exit code 0")
    return parser.parse_args()


def main():
    """Compares the two directories of the command line, and writes what it asks for."""
    arguments = read_arguments()
    comparison = Comparison(open_results(arguments.a), open_results(arguments.b))
    if comparison.size == 0:
        lacking = [name for name in AXES if comparison.a.sizes[name] == 0]
        fail(
            f"{arguments.a} and {arguments.b} have no place in common: no value of {', '.join(lacking)} is in both; "
            "give two sweeps whose axes share values"
        )
    print_origin(comparison, {"A": arguments.a, "B": arguments.b})
    print_places(comparison)
    print_differences(comparison)
    if arguments.csv:
        write_table(comparison, arguments.csv)
    if arguments.output:
        print_style()
        save(draw_comparison(comparison, arguments.quantity), arguments.output)
    if arguments.tolerance is not None:
        judge(comparison, arguments.tolerance)


if __name__ == "__main__":
    main()
