# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "matplotlib>=3.8", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Compares two sweeps at the places that both have: relative differences beside the errors that both estimate.

    uv run scripts/compare.py results/coarse results/fine
    uv run scripts/compare.py results/coarse results/fine -o compare.png --csv compare.csv --tolerance 1e-4

Exit code: 0; with --tolerance 1 if a difference is larger, or a case failed in one of the two alone; 2 if the input is wrong.
"""

import argparse
import csv
import difflib
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from comparison import AXES, ESTIMATED, QUANTITIES, Comparison
from difference_map import draw
from places import shown
from results_file import count, fail, open_results, print_style, save, text_of

SYMBOLS = {"f": "f", "alpha": "α", "beta": "β"}
# Lines of a list that stand for the rest, which --csv has.
FEW = 8


def say_first(lines, what):
    """Prints some lines and how many there are more."""
    for line in lines[:FEW]:
        print(f"  {line}")
    if len(lines) > FEW:
        print(f"  … and {count(len(lines) - FEW, what)} more")


def place_of(data, index):
    """`f = 100, α = 1, β = 10` of the place with these indices."""
    return ", ".join(f"{SYMBOLS[name]} = {shown(float(data[name][i]))}" for name, i in zip(AXES, index))


def say_origin(comparison, directories):
    """What was compared, and whether program and sweep files are the same."""
    for letter, directory in directories.items():
        data = comparison.whole[letter]
        print(f"{letter}  {directory}: {data.attrs['title']} ({count(comparison.places[letter], 'place')})")
    a, b = comparison.whole.values()
    versions = [data.attrs["stribeck_version"] for data in (a, b)]
    print(f"program: {f'version {versions[0]} in both' if versions[0] == versions[1] else 'A {}, B {}'.format(*versions)}")
    if a.attrs["sweep"] == b.attrs["sweep"]:
        print("sweep file: the same text")
        return
    print("sweep file: differs (- A, + B)")
    lines = difflib.unified_diff(a.attrs["sweep"].splitlines(), b.attrs["sweep"].splitlines(), n=0, lineterm="")
    say_first([line for line in lines if not line.startswith(("---", "+++", "@@"))], "line")


def say_places(comparison):
    """What both have, what one has alone, and what became of it."""
    alone = {letter: total - comparison.size for letter, total in comparison.places.items()}
    print(f"\nplaces: {comparison.size} in both, {alone['A']} in A alone, {alone['B']} in B alone")
    for letter, axes in comparison.alone.items():
        for name, values in axes.items():
            if values.size:
                some = ", ".join(shown(value) for value in values[:FEW]) + (", …" if values.size > FEW else "")
                print(f"  {letter} alone has {SYMBOLS[name]} = {some}")
    in_both = int(comparison.converged.sum())
    both_failed = int((comparison.failed_a & comparison.failed_b).sum())
    changed = int(comparison.changed.sum())
    print(f"status: {in_both} converged in both, {both_failed} failed in both, {changed} failed in one alone")
    lines = []
    for index in zip(*np.nonzero(comparison.changed.values)):
        letter, data = ("A", comparison.a) if comparison.failed_a.values[index] else ("B", comparison.b)
        lines.append(f"{place_of(data, index)} failed in {letter}: {text_of(data['reason'].values[index])}")
    say_first(lines, "place")


def say_differences(comparison):
    """A line for each quantity, and where estimated errors do not explain a difference."""
    print("\nrelative difference |B - A|/|A|, and the sum of the errors that both estimate")
    print(f"{'':9} {'compared':>8} {'equal':>6} {'median':>8} {'largest':>8} {'estimate':>9} {'largest':>8} {'beyond':>7}  largest at")
    for name in QUANTITIES:
        values = comparison.difference[name].values
        valid = ~np.isnan(values)
        if not valid.any():
            print(f"{name:9} {0:8}")
            continue
        index = np.unravel_index(np.argmax(np.where(valid, values, -1.0)), values.shape)
        where = f"  {place_of(comparison.a, index)}" if values[index] > 0 else ""
        estimates, beyond = f"{'–':>9} {'–':>8} {'–':>7}", None
        if name in ESTIMATED:
            known = comparison.estimate[name].values[valid]
            known = known[~np.isnan(known)]
            beyond = int(comparison.beyond(name).sum())
            if known.size:
                estimates = f"{np.median(known):9.1e} {known.max():8.1e} {beyond:7}"
        equal = int((values[valid] == 0).sum())
        print(f"{name:9} {valid.sum():8} {equal:6} {np.median(values[valid]):8.1e} {values[index]:8.1e} {estimates}{where}")
    print()
    say_beyond(comparison)


def say_beyond(comparison):
    """Whether the estimated errors explain the differences."""
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
                f"{name}: {count(int(beyond.sum()), 'difference')} beyond the sum of estimated errors, "
                f"by a factor of {np.median(ratios):.3g} in the median, {ratios.max():.3g} at most; "
                f"the largest of them is {difference[beyond].max():.1e}"
            )
    if explained:
        print("all differences lie within the sum of estimated errors, where there are estimates")
    unknown = [name for name in ESTIMATED if (comparison.estimate[name].isnull() & comparison.converged).any()]
    for name in unknown:
        places = int((comparison.estimate[name].isnull() & comparison.converged).sum())
        print(f"{name}: no estimate at {count(places, 'place')}, which are not judged")


def write_csv(comparison, path):
    """One row for each place of A or B; empty where there is no number."""
    header = [*AXES, "in", "status_a", "status_b", "reason_a", "reason_b"]
    header += [f"difference_{name}" for name in QUANTITIES] + [f"estimate_{name}" for name in ESTIMATED]
    words = ("converged", "failed")
    try:
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(header)
            for index in np.ndindex(*comparison.a["status"].shape):
                values = [float(comparison.a[name].values[i]) for name, i in zip(AXES, index)]
                status = [words[data["status"].values[index]] for data in (comparison.a, comparison.b)]
                reasons = [text_of(data["reason"].values[index]) for data in (comparison.a, comparison.b)]
                numbers = [comparison.difference[name].values[index] for name in QUANTITIES]
                numbers += [comparison.estimate[name].values[index] for name in ESTIMATED]
                cells = ["" if np.isnan(number) else repr(float(number)) for number in numbers]
                writer.writerow([*values, "both", *status, *reasons, *cells])
            for letter, data in comparison.whole.items():
                write_alone(writer, letter, data, comparison.alone[letter], words, len(header))
    except OSError as error:
        fail(f"{path}: {error.strerror}; name a file in a directory that exists and may be written to")
    print(f"wrote {path}")


def write_alone(writer, letter, data, alone, words, width):
    """Rows of the places that one of the two has alone."""
    data = data.transpose(*AXES, ...)
    statuses, reasons = data["status"].values, data["reason"].values
    f, alpha, beta = (np.isin(data[name].values, alone[name]) for name in AXES)
    for index in zip(*np.nonzero(f[:, None, None] | alpha[:, None] | beta)):
        values = [float(data[name].values[i]) for name, i in zip(AXES, index)]
        status, reason = words[statuses[index]], text_of(reasons[index])
        sides = [status, "", reason, ""] if letter == "A" else ["", status, "", reason]
        row = [*values, letter, *sides]
        writer.writerow(row + [""] * (width - len(row)))


def positive(text):
    """A number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not 0 < value < np.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is no number above 0")
    return value


def main():
    parser = argparse.ArgumentParser(description="Compares the results.h5 of two sweeps.")
    parser.add_argument("a", type=Path, metavar="DIR_A", help="directory that `stribeck run` wrote")
    parser.add_argument("b", type=Path, metavar="DIR_B", help="the other one")
    parser.add_argument("-o", "--output", type=Path, help="picture to write: .png, .pdf, .svg")
    parser.add_argument("--quantity", choices=QUANTITIES, default="mu_tot", help="what the maps show [mu_tot]")
    parser.add_argument("--csv", type=Path, help="table of all places to write")
    parser.add_argument("--tolerance", type=positive, help="largest relative difference for exit code 0")
    arguments = parser.parse_args()
    comparison = Comparison(open_results(arguments.a), open_results(arguments.b))
    if comparison.size == 0:
        lacking = [name for name in AXES if comparison.a.sizes[name] == 0]
        fail(
            f"{arguments.a} and {arguments.b} have no place in common: no value of {', '.join(lacking)} is in both; "
            "give two sweeps whose axes share values"
        )
    say_origin(comparison, {"A": arguments.a, "B": arguments.b})
    say_places(comparison)
    say_differences(comparison)
    if arguments.csv:
        write_csv(comparison, arguments.csv)
    if arguments.output:
        print_style()
        save(draw(comparison, arguments.quantity), arguments.output)
    if arguments.tolerance is not None:
        changed = int(comparison.changed.sum())
        if comparison.largest() > arguments.tolerance or changed:
            print(
                f"beyond the tolerance of {arguments.tolerance:g}: the largest difference is {comparison.largest():.1e}, "
                f"{count(changed, 'case')} failed in one alone"
            )
            sys.exit(1)
        print(f"within the tolerance of {arguments.tolerance:g}")


if __name__ == "__main__":
    main()
