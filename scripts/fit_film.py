# /// script
# requires-python = ">=3.10"
# dependencies = ["numpy>=1.26", "pandas>=2.1", "scipy>=1.11"]
# ///
"""Fits the coefficients of the formula for the film thickness c (docs/explanation/approximations.md).

Usage:
    stribeck run sweeps/film.toml
    uv run scripts/fit_film.py results/film/summary.csv

Prints the coefficients that stand in crates/solver/src/exact/film_formula.rs, and the errors on the cases fitted.
The errors on other cases come from `cargo run --release -p stribeck-solver --example film_formula`.
"""

import argparse
from pathlib import Path

import numpy as np
import pandas as pd
from scipy.optimize import brentq, least_squares
from scipy.special import ive, k0e, k1e

from lib.messages import fail

ASYMPTOTE = 0.44583  # of c beta^(3/5), elastic, by Richardson's extrapolation in beta^(-2/5)
SMALL_INLET = 0.01  # inlet length over half the contact's width below which the contact's size does not matter


def dry_contact(alpha, f):
    """Half width, k and 1 + gamma2 (2 + k + k T) of the dry contact (T14)."""

    def ratios(half_width):
        k, x = (1 + f) * alpha * half_width, alpha * half_width
        return k, k0e(x) / k1e(x), ive(2, k) / ive(1, k)

    def residual(ln_half_width):
        k, q, t = ratios(np.exp(ln_half_width))
        return 2 * ln_half_width + np.log1p(2 * f / (2 + k * (q + t)))

    half_width = np.exp(brentq(residual, -0.5 * np.log1p(f) - 1e-9, 1e-9, xtol=1e-14))
    k, q, t = ratios(half_width)
    return half_width, k, 1 + f / (2 + k * (q + t)) * (2 + k + k * t)


def rigid_ratio(p, beta):
    """The ratio pi beta c of an elastic film: 1 for beta -> 0, the power 2/5 for beta -> inf."""
    return (1 + p[0] * beta + p[1] * beta ** p[2] + (ASYMPTOTE * np.pi * beta**0.4) ** p[3]) ** (1 / p[3])


class Cases:
    """Viscoelastic cases, and what the formula takes from their dry contacts."""

    def __init__(self, rows, elastic):
        self.elastic = elastic
        self.beta, self.c = rows.beta.to_numpy(), rows.c.to_numpy()
        self.alpha, self.f = rows.alpha.to_numpy(), rows.f.to_numpy()
        keys = list(zip(self.alpha, self.f, strict=True))
        contacts = {key: dry_contact(*key) for key in set(keys)}
        columns = np.array([contacts[key] for key in keys]).T
        self.half_width, self.k, strength = columns
        self.slope = np.sqrt(2 * self.half_width) * strength / (1 + self.f)
        excess = ((1 + self.f) / (self.half_width * strength)) ** 2 - 1
        self.thick = (self.f - excess) / excess

    def softening(self, inlet, blend, length):
        """X at an inlet length: the pressure is S(1 + f/(1 + X)) sqrt(distance) there."""
        x, y = (1 + self.f) * self.alpha * length, self.alpha * length
        level, onset, sharpness, rate, power = inlet
        lag = level + (1 - level) / (1 + (onset * y) ** sharpness)
        near = (1 + (rate * x) ** power) ** (1 / power) / lag - 1
        if blend is None:
            return near
        ratio = near / self.thick
        n = blend[0] + blend[1] * self.k / (blend[2] + self.k) + blend[3] * ratio / (1 + ratio)
        with np.errstate(over="ignore"):  # infinity to a negative power is the 0 it should be
            return near * (1 + ratio**n) ** (-1 / n)

    def formula(self, inlet, blend=None):
        """The film thickness c and the inlet length."""
        length = (self.beta * (1 + self.f) * self.slope**3) ** -0.4
        for _ in range(60):
            pressure = self.slope * (1 + self.f / (1 + self.softening(inlet, blend, length)))
            length = (self.beta * pressure * self.slope**2) ** -0.4
        effective = (length / self.half_width) ** -2.5 / 2**1.5
        finite = rigid_ratio(self.elastic, effective) / (np.pi * ASYMPTOTE * effective**0.4)
        return ASYMPTOTE * 2**0.4 * self.slope * length**1.5 * finite, length


def fit(errors, start):
    """Fits coefficients by least squares, then by ever higher powers, towards the least largest error."""
    solution = least_squares(errors, start).x
    for power in (2, 4, 8):
        solution = least_squares(lambda p, power=power: (100 * np.abs(errors(p))) ** power, solution).x
    return solution


def rounded(coefficients):
    """Rounds coefficients to the four digits that stand in the program."""
    return np.array([float(f"{value:.4g}") for value in coefficients])


def fit_and_print(name, errors, start):
    """Fits coefficients, prints them with their errors, and returns them as they are printed."""
    coefficients = rounded(fit(errors, start))
    left = 100 * errors(coefficients)
    print(f"{name}: {', '.join(f'{value:.4g}' for value in coefficients)}")
    print(f"    {left.size} cases: largest error {np.abs(left).max():.2f} %, rms {np.sqrt((left**2).mean()):.2f} %")
    return coefficients


def fit_elastic(rows):
    """Fits the coefficients of an elastic film."""
    # At alpha = 0 the substrate has its instantaneous modulus: the elastic film at beta/(1+f), u times 1/(1+f).
    elastic = rows[(rows.f == 0) | (rows.alpha == 0)].drop_duplicates(["f", "beta"])
    stiffening = 1 + elastic.f.to_numpy()
    beta, c = elastic.beta.to_numpy() / stiffening, elastic.c.to_numpy() * stiffening
    wanted = np.pi * beta * c

    def errors(p):
        return np.log(rigid_ratio(p, beta) / wanted)

    return fit_and_print("elastic", errors, [9.0, 33.0, 2.4, 7.1])


def fit_viscoelastic(rows, elastic):
    """Fits the coefficients of the inlet to narrow inlets, and those of the blend to all viscoelastic cases."""
    viscoelastic = rows[(rows.f > 0) & (rows.alpha > 0)]
    start = [0.5, 1.1, 1.6, 2.1, 1.0]
    cases = Cases(viscoelastic, elastic)
    _, length = cases.formula(start)
    narrow = Cases(viscoelastic[length < SMALL_INLET * cases.half_width], elastic)

    def inlet_errors(p):
        return np.log(narrow.formula(p)[0] / narrow.c)

    inlet = fit_and_print("inlet", inlet_errors, start)

    def blend_errors(p):
        return np.log(cases.formula(inlet, p)[0] / cases.c)

    fit_and_print("blend", blend_errors, [0.2, 0.9, 1.8, 2.2])


def main():
    """Fits the coefficients to the table of the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("summary", type=Path, help="summary.csv of the sweep `film`")
    rows = pd.read_csv(parser.parse_args().summary)
    if not (rows.status == "converged").all():
        fail("some cases failed: the fit wants all of them")
    fit_viscoelastic(rows, fit_elastic(rows))


if __name__ == "__main__":
    main()
