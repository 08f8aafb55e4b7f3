# /// script
# requires-python = ">=3.10"
# dependencies = ["mpmath>=1.3"]
# ///
"""Writes crates/solver/tests/reference/dry_contact.csv: half width, centre and friction of dry sliding at 60 digits.

The formulas are those of Hunter as Eqs. 25 to 32 have them (b in units of a0), cancellation and all: with 60 digits it
does no harm.
"""

from pathlib import Path

import mpmath as mp

mp.mp.dps = 60


def dry_contact(alpha, f):
    """(half width, centre, friction) over a0 and N a0/R."""
    rate = (1 + f) * alpha

    def ratios(a):
        k, x = rate * a, alpha * a
        return k, mp.besselk(0, x) / mp.besselk(1, x), mp.besseli(0, k) / mp.besseli(1, k)

    def residual(log_a):
        a = mp.e**log_a
        k, outer, inner = ratios(a)
        return 2 * log_a + mp.log(1 + 2 * f / (k * (outer + inner)))

    log_a = mp.findroot(residual, (-mp.log(1 + f) / 2, mp.mpf(0)), solver="anderson", tol=1e-45)
    a = mp.e**log_a
    k, _, inner = ratios(a)
    gamma2 = (1 / a**2 - 1) / 2
    gamma1 = -1 / k - gamma2 * inner
    b = a * gamma1 + 1 / alpha
    return a, b, b - 1 / rate - a**3 * gamma1


def main():
    """Writes the table."""
    rows = ["alpha,f,half_width,centre,friction"]
    for alpha in ["1e-6", "1e-4", "1e-2", "0.3", "1", "3", "30", "1e3", "1e6"]:
        for f in ["1e-6", "0.01", "1", "10", "1e3", "1e6"]:
            values = dry_contact(mp.mpf(alpha), mp.mpf(f))
            rows.append(",".join([alpha, f, *(mp.nstr(value, 20) for value in values)]))
    target = Path(__file__).parent.parent / "crates/solver/tests/reference" / "dry_contact.csv"
    target.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
