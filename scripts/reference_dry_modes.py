# /// script
# requires-python = ">=3.10"
# dependencies = ["mpmath>=1.3"]
# ///
"""Writes crates/solver/tests/reference/dry_modes.csv: dry sliding with several retardation times, at 60 digits.

The amplitudes of the exponentials follow from the history ahead of the contact (T44), unsymmetric and with all its
cancellation: with 60 digits it does no harm.
"""

import random
from pathlib import Path

import mpmath as mp

mp.mp.dps = 60


def ratio(x, sign):
    """I1/I0 (sign 1) or K1/K0 (sign -1) at x, from the asymptotic series of A&S 9.7 where it has all the digits."""
    if x < 100:
        return mp.besseli(1, x) / mp.besseli(0, x) if sign > 0 else mp.besselk(1, x) / mp.besselk(0, x)
    sums = []
    for order in (1, 0):
        total, term = mp.mpf(1), mp.mpf(1)
        for j in range(1, 400):
            term *= -sign * (4 * order**2 - (2 * j - 1) ** 2) / (8 * x * j)
            total += term
        sums.append(total)
    return sums[0] / sums[1]


def roots(modes):
    """The relaxation rates, one above each of the ascending rates."""
    modes = sorted(modes, key=lambda mode: mode[1])

    def excess(rate):
        return 1 - sum(f / (rate / alpha - 1) for f, alpha in modes)

    found = []
    for i, (_, alpha) in enumerate(modes):
        end = modes[i + 1][1] if i + 1 < len(modes) else alpha + 2 * sum(f * rate for f, rate in modes)
        low, high = alpha, end
        for _ in range(400):
            middle = (low + high) / 2
            low, high = (middle, high) if excess(middle) < 0 else (low, middle)
        found.append((low + high) / 2)
    return found


def dry_contact(modes):
    """(half width, centre, friction) over a0 and N a0/R; modes are (f_j, alpha_j)."""
    f = sum(mode[0] for mode in modes)
    rates = roots(modes)

    def amplitudes(a):
        kappa = [a * rate for rate in rates]
        inner = [ratio(k, 1) for k in kappa]
        matrix = mp.matrix(len(modes), len(modes))
        for j, (_, alpha) in enumerate(modes):
            gamma = alpha * a
            outer = 1 / ratio(gamma, -1)
            for m, k in enumerate(kappa):
                matrix[j, m] = gamma * (1 + outer * inner[m]) / (gamma - k)
        return kappa, inner, mp.lu_solve(matrix, mp.matrix([1] * len(modes)))

    def residual(log_a):
        a = mp.e**log_a
        kappa, inner, y = amplitudes(a)
        return 2 * log_a + mp.log(1 - 2 * sum(y[m] * inner[m] / kappa[m] for m in range(len(modes))))

    low, high = -mp.log(1 + f) / 2, mp.mpf(0)
    log_a = mp.findroot(residual, (low, high), solver="anderson", tol=1e-50)
    a = mp.e**log_a
    kappa, inner, y = amplitudes(a)
    b = sum(g / ((1 + f) * alpha) for g, alpha in modes) + a * sum(y[m] / kappa[m] for m in range(len(modes)))
    # I2/I0 = 1 - (2/k) I1/I0
    second = sum(y[m] / k * (1 - 2 / k * inner[m]) for m, k in enumerate(kappa))
    return a, b, b - a**3 * second


def cases():
    """Strengths and rates as texts, chosen at random and rounded so that a double holds what is written."""
    chance = random.Random(7)

    def number(low, high):
        return repr(float(f"{10 ** chance.uniform(low, high):.3g}"))

    for _ in range(45):
        count = chance.choice([2, 2, 3, 4, 6])
        middle, spread = chance.uniform(-4, 4), chance.choice([0.5, 2, 5])
        level, contrast = chance.uniform(-3, 5), chance.choice([0.2, 2, 6])
        yield [
            (number(level - contrast / 2, level + contrast / 2), number(middle - spread, middle + spread))
            for _ in range(count)
        ]


def main():
    """Writes the table."""
    rows = ["strengths,rates,half_width,centre,friction"]
    for modes in cases():
        values = dry_contact([(mp.mpf(float(f)), mp.mpf(float(alpha))) for f, alpha in modes])
        lists = (" ".join(mode[part] for mode in modes) for part in (0, 1))
        rows.append(",".join([*lists, *(mp.nstr(value, 20) for value in values)]))
    target = Path(__file__).parent.parent / "crates/solver/tests/reference" / "dry_modes.csv"
    target.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
