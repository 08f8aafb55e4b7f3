# /// script
# requires-python = ">=3.10"
# dependencies = ["mpmath>=1.3"]
# ///
"""Writes crates/solver/tests/reference/retarded_log.csv: S(z) = -exp(z) Ei(-z) with 60 digits of working precision.

z is written as the decimal digits of the double itself, so that the table is exact for a program that reads doubles.
"""

from pathlib import Path

import mpmath as mp

mp.mp.dps = 60


def retarded_log(z):
    """S(z) by the exponential integral, and by its asymptotic series far out on the negative side."""
    if z > 0:
        return mp.exp(z) * mp.e1(z)
    y = -z
    if y < 200:
        return -mp.exp(-y) * mp.ei(y)
    total, term, k = mp.mpf(1), mp.mpf(1), 0
    while abs(term) > mp.mpf(10) ** -50 and k < 190:
        k += 1
        term *= k / y
        total += term
    return -total / y


def arguments():
    """|z| from 1e-12 to 1e12 on both sides, denser around the zero of S and where formulas may change over."""
    points = []
    for i in range(-48, 49):
        points += [10 ** (i / 4), -(10 ** (i / 4))]
    for centre in (-0.3725074107813666, -1.0, 1.0, -50.0, 50.0, -40.0, 40.0, -2.0, 2.0, 2.5, -2.5, 4.0, -4.0):
        points += [centre * (1 + side * 10 ** (-j / 2)) for j in range(1, 13) for side in (-1, 1)] + [centre]
    points += [sign * i / 4 for i in range(1, 241) for sign in (-1, 1)]
    return sorted(set(points))


def main():
    """Writes the table."""
    rows = ["z,retarded_log"]
    for z in arguments():
        rows.append(f"{z!r},{mp.nstr(retarded_log(mp.mpf(z)), 36)}")
    target = Path(__file__).parent.parent / "crates/solver/tests/reference" / "retarded_log.csv"
    target.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
