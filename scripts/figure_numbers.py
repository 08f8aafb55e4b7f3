# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Prints the numbers of docs/explanation/paper-figures.md from the results that `scripts/figures` makes.

Usage:
    python scripts/figure_numbers.py [results]
"""

import sys
from pathlib import Path

import numpy as np
import xarray as xr

from lib.messages import fail


def elastic_fit(beta):
    """Eq. 34 of the paper: c of an elastic substrate."""
    return 0.197 / np.sqrt(beta) + 0.951 / beta


def nearest_index(values, wanted):
    """Index of the value nearest to the one wanted, by ratio."""
    return int(np.argmin(np.abs(np.log(np.asarray(values) / wanted))))


def per_cent(ratio):
    """How far a ratio is from 1, as `+2.5 %`."""
    return f"{100 * (float(ratio) - 1):+.1f} %"


def peak(curve):
    """The largest value of a curve along α, and the α where it is."""
    i = int(curve.argmax("alpha"))
    return float(curve[i]), float(curve.alpha[i])


def viscoelastic_range(case):
    """Says for which α viscoelastic friction is larger than hydrodynamic friction."""
    ahead = case.alpha.values[case.mu_v.values > case.mu_h.values]
    return f"viscoelastic friction is the larger part for α from {ahead.min():.3g} to {ahead.max():.3g}"


def print_range(label, ratio):
    """Prints the smallest and the largest of some ratios."""
    print(f"  {label}: {per_cent(ratio.min())} to {per_cent(ratio.max())}")


def figure_4(data):
    """Prints how c of an elastic substrate compares with Eq. 34 and with its law at large β."""
    c = data.c.isel(f=0, alpha=0)
    beta = c.beta.values
    slope = np.gradient(np.log(c.values), np.log(beta))
    for wanted in [10, 50, 100, 1000, 2000, 1e4, 1e5]:
        i = nearest_index(beta, wanted)
        fit, law = elastic_fit(beta[i]) / c.values[i], 0.44583 * beta[i] ** -0.6 / c.values[i]
        print(f"  β = {beta[i]:8.4g}: Eq. 34 {per_cent(fit)}, β^(-3/5) law {per_cent(law)}, slope {slope[i]:.3f}")


def figure_5(data):
    """Prints how the film of an elastic substrate compares with Eq. 36, and where it is thinnest."""
    x = data.x.values
    for beta in data.beta.values:
        film = data.film_thickness.sel(beta=beta).isel(f=0, alpha=0).values
        c, slope = elastic_fit(beta), 0.197**2
        ratio = c * (1 + slope * x + 3 * slope**2 * x**2) / film
        reach = {limit: per_cent(1 + np.max(np.abs(ratio[np.abs(x) <= limit] - 1))) for limit in (0.5, 0.8, 0.9)}
        inside = np.abs(x) < 1.05
        dip = x[inside][np.argmin(film[inside])]
        print(f"  β = {beta:g}: film thinnest at x = {dip:.2f}; largest difference of Eq. 36 for |x| up to {reach}")


def figure_7(data):
    """Prints the largest pressure of each case, and its friction as a share of the dry limit."""
    flat = data.stack(case=("f", "alpha", "beta"))
    for i in range(flat.sizes["case"]):
        case = flat.isel(case=i)
        print(
            f"  α = {float(case.alpha):g}, β = {float(case.beta):g}: largest pressure {float(case.p_max):.3f} at x = "
            f"{float(case.x_p_max):.3f}, friction {100 * float(case.mu_v / case.dry_mu_v):.1f} % of its dry limit"
        )


def figure_8(data):
    """Prints where the outlet lies ahead of the middle."""
    for beta in data.beta.values:
        outlet = data.x_outlet.sel(beta=beta).isel(f=0)
        ahead, most = outlet.alpha.values[outlet.values > 0], float(outlet.max())
        print(f"  β = {beta:g}: above 0 for α from {ahead.min():.3g} to {ahead.max():.3g}, at most {most:.3f}")


def figure_11(data):
    """Prints the peak of viscoelastic friction, and friction as a share of the dry limit."""
    friction, dry = data.mu_v.isel(f=0), data.dry_mu_v.isel(f=0)
    for beta in data.beta.values:
        (most, alpha), ratio = peak(friction.sel(beta=beta)), (friction / dry).sel(beta=beta)
        shares = f"{float(ratio.min()):.3f} to {float(ratio.max()):.3f} of the dry limit"
        print(f"  β = {beta:g}: largest {most:.3f} at α = {alpha:.2f}; {shares}")


def figure_12(data):
    """Prints the smallest c and c at the end of the axis."""
    c = data.c.isel(f=0, beta=0)
    least, last = float(c.min()), float(c[-1])
    at = float(c.alpha[int(c.argmin("alpha"))])
    print(f"  c from {least:.3g} at α = {at:g} to {last:.3g} at α = 1000: {last / least:.1f} times")


def figure_13(data):
    """Prints how c of a viscoelastic substrate compares with Eqs. 49 and 34."""
    f, beta = float(data.f[0]), data.beta.values
    for alpha in data.alpha.values:
        c = data.c.isel(f=0).sel(alpha=alpha).values
        ratio = elastic_fit(beta * (1 + f * np.exp(-1.41 * alpha))) / c
        power = np.polyfit(np.log(beta), np.log(c), 1)[0]
        ends = ", ".join(f"{per_cent(ratio[i])} at β = {beta[i]:g}" for i in (0, len(beta) // 2, -1))
        print(f"  α = {alpha:g}: Eq. 49 {ends}; c falls as β^{power:.2f}")
    c = data.c.isel(f=0, alpha=0).values
    exact = elastic_fit(beta / (1 + f)) / (1 + f) / c
    ends = f"{per_cent(exact[0])} at β = 10, {per_cent(exact[-1])} at β = 1000"
    print(f"  α = {float(data.alpha[0]):g}: Eq. 34 at β/(1+f), over 1+f: {ends}")


def figure_14b(data):
    """Prints hydrodynamic friction at the ends of α and at its peak, and how its approximation compares."""
    friction, approximation = data.mu_h.isel(f=0), data.approx_mu_h.isel(f=0)
    for beta in data.beta.values:
        own, ratio = friction.sel(beta=beta), (approximation / friction).sel(beta=beta)
        most, at = peak(own)
        near = {alpha: per_cent(ratio.sel(alpha=alpha, method="nearest")) for alpha in (1e-3, 1, 1e3)}
        parts = ", ".join(f"{difference} at α = {alpha:g}" for alpha, difference in near.items())
        print(
            f"  β = {beta:g}: {float(own[0]):.4f} at α = 0.001, peak {most:.4f} at α = {at:.2f}, "
            f"{float(own[-1]):.4f} at α = 1000; approximation {parts}"
        )


def print_drag(case):
    """Prints what viscoelastic friction is of the drag, and the drag over the total of the paper."""
    share = case.mu_v / case.mu_drag
    alpha = case.alpha.values[share.values > 0.5]
    where = f"for α from {alpha[0]:.3g} to {alpha[-1]:.3g}" if alpha.size else "nowhere"
    print(f"  F_v is more than half of the drag {where}, at most {100 * float(share.max()):.1f} %")
    print_range("drag over F_tot", case.mu_drag / case.mu_tot)


def figure_15(data):
    """Prints which part of friction is larger, and how the sum of approximations compares with the total."""
    case = data.isel(f=0, beta=0)
    ratio = (case.dry_mu_v + case.approx_mu_h) / case.mu_tot
    print(f"  β = {float(case.beta):g}: {viscoelastic_range(case)}")
    print_drag(case)
    print_range("dry F_v + approximate F_h over F_tot", ratio)
    print_range("the same for α from 0.3 to 3", ratio.sel(alpha=slice(0.3, 3)))


def figure_16(data):
    """Prints which part of friction is larger, and how the sum of limits compares with the total."""
    retarded, elastic = data.sel(f=100.0), data.sel(f=0.0).isel(alpha=0)
    for beta in (10, 100, 1000):
        case = retarded.sel(beta=beta, method="nearest")
        print(f"  β = {beta}: {viscoelastic_range(case)}; μ_tot at most {float(case.mu_tot.max()):.3f}")
        print_drag(case)
    apart = 100 * float(abs(retarded.mu_h.isel(alpha=-1) / elastic.mu_h - 1).max())
    print(f"  μ_h at α = 1000 is μ_h of the elastic substrate within {apart:.2f} %")
    print_range("dry F_v + elastic F_h over F_tot", (retarded.dry_mu_v + elastic.mu_h) / retarded.mu_tot)


FIGURES = {
    "fig04": figure_4,
    "fig05": figure_5,
    "fig07a": figure_7,
    "fig07b": figure_7,
    "fig07c": figure_7,
    "fig08b": figure_8,
    "fig11": figure_11,
    "fig12": figure_12,
    "fig13": figure_13,
    "fig14b": figure_14b,
    "fig15a": figure_15,
    "fig15b": figure_15,
    "fig16": figure_16,
}


def main():
    """Prints the numbers of all figures."""
    results = Path(sys.argv[1] if len(sys.argv) > 1 else "results")
    for name, print_numbers in FIGURES.items():
        path = results / name / "results.h5"
        if not path.is_file():
            fail(f"{path}: no such file; run scripts/figures first")
        print(name)
        with xr.open_dataset(path, engine="h5netcdf") as data:
            print_numbers(data)


if __name__ == "__main__":
    main()
