# /// script
# requires-python = ">=3.10"
# dependencies = ["h5netcdf>=1.3", "h5py>=3.10", "numpy>=1.26", "xarray>=2024.1"]
# ///
"""Prints the numbers of docs/figures.md from the results of the figures' sweeps, which `scripts/figures` makes.

    python scripts/figure_numbers.py [results]
"""

import sys
from pathlib import Path

import numpy as np
import xarray as xr


def elastic_fit(beta):
    """Eq. 34 of the paper: c of an elastic substrate."""
    return 0.197 / np.sqrt(beta) + 0.951 / beta


def at(values, wanted):
    """Index of the value nearest to the one wanted, by ratio."""
    return int(np.argmin(np.abs(np.log(np.asarray(values) / wanted))))


def per_cent(ratio):
    return f"{100 * (ratio - 1):+.1f} %"


def figure_4(data):
    c = data.c.isel(f=0, alpha=0)
    beta = c.beta.values
    slope = np.gradient(np.log(c.values), np.log(beta))
    for wanted in [10, 50, 100, 1000, 2000, 1e4, 1e5]:
        i = at(beta, wanted)
        fit, law = elastic_fit(beta[i]) / c.values[i], 0.44583 * beta[i] ** -0.6 / c.values[i]
        print(f"  β = {beta[i]:8.4g}: Eq. 34 {per_cent(fit)}, β^(-3/5) law {per_cent(law)}, slope {slope[i]:.3f}")


def figure_5(data):
    x = data.x.values
    for beta in data.beta.values:
        film = data.film_thickness.sel(beta=beta).isel(f=0, alpha=0).values
        c, slope = elastic_fit(beta), 0.197**2
        ratio = c * (1 + slope * x + 3 * slope**2 * x**2) / film
        reach = {limit: per_cent(1 + np.max(np.abs(ratio[np.abs(x) <= limit] - 1))) for limit in (0.5, 0.8, 0.9)}
        inside = np.abs(x) < 1.05
        dip = x[inside][np.argmin(film[inside])]
        print(f"  β = {beta:g}: largest difference of Eq. 36 for |x| up to {reach}; the film is thinnest at x = {dip:.2f}")


def pressures(data):
    flat = data.stack(case=("f", "alpha", "beta"))
    for i in range(flat.sizes["case"]):
        case = flat.isel(case=i)
        print(
            f"  α = {float(case.alpha):g}, β = {float(case.beta):g}: largest pressure {float(case.p_max):.3f} at x = "
            f"{float(case.x_p_max):.3f}, friction {100 * float(case.mu_v / case.dry_mu_v):.1f} % of its dry limit"
        )


def figure_8(data):
    for beta in data.beta.values:
        outlet = data.x_outlet.sel(beta=beta).isel(f=0)
        ahead = outlet.alpha.values[outlet.values > 0]
        print(f"  β = {beta:g}: above 0 for α from {ahead.min():.3g} to {ahead.max():.3g}, at most {float(outlet.max()):.3f}")


def figure_11(data):
    friction, dry = data.mu_v.isel(f=0), data.dry_mu_v.isel(f=0)
    for beta in data.beta.values:
        own, ratio = friction.sel(beta=beta), (friction / dry).sel(beta=beta)
        peak = float(own.alpha[int(own.argmax("alpha"))])
        print(f"  β = {beta:g}: largest {float(own.max()):.3f} at α = {peak:.2f}; {float(ratio.min()):.3f} to {float(ratio.max()):.3f} of the dry limit")


def figure_12(data):
    c = data.c.isel(f=0, beta=0)
    print(f"  c from {float(c.min()):.3g} at α = {float(c.alpha[int(c.argmin('alpha'))]):g} to {float(c[-1]):.3g} at α = 1000: {float(c[-1] / c.min()):.1f} times")


def figure_13(data):
    f = float(data.f[0])
    for alpha in data.alpha.values:
        c = data.c.isel(f=0).sel(alpha=alpha)
        beta = c.beta.values
        effective = beta * (1 + f * np.exp(-1.41 * alpha))
        ratio = elastic_fit(effective) / c.values
        power = np.polyfit(np.log(beta), np.log(c.values), 1)[0]
        ends = ", ".join(f"{per_cent(ratio[i])} at β = {beta[i]:g}" for i in (0, len(beta) // 2, -1))
        print(f"  α = {alpha:g}: Eq. 49 {ends}; c falls as β^{power:.2f}")
    beta = data.beta.values
    c = data.c.isel(f=0, alpha=0).values
    exact = elastic_fit(beta / (1 + f)) / (1 + f)
    print(f"  α = {float(data.alpha[0]):g}: Eq. 34 at β/(1+f), over 1+f: {per_cent(exact[0] / c[0])} at β = 10, {per_cent(exact[-1] / c[-1])} at β = 1000")


def figure_14b(data):
    friction, approximation = data.mu_h.isel(f=0), data.approx_mu_h.isel(f=0)
    for beta in data.beta.values:
        own, ratio = friction.sel(beta=beta), (approximation / friction).sel(beta=beta)
        peak = float(own.alpha[int(own.argmax("alpha"))])
        parts = ", ".join(f"{per_cent(float(ratio.sel(alpha=alpha, method='nearest')))} at α = {alpha:g}" for alpha in (1e-3, 1, 1e3))
        print(f"  β = {beta:g}: {float(own[0]):.4f} at α = 0.001, peak {float(own.max()):.4f} at α = {peak:.2f}, {float(own[-1]):.4f} at α = 1000; approximation {parts}")


def figure_15(data):
    case = data.isel(f=0, beta=0)
    ratio = (case.dry_mu_v + case.approx_mu_h) / case.mu_tot
    ahead = case.alpha.values[case.mu_v.values > case.mu_h.values]
    near = ratio.sel(alpha=slice(0.3, 3))
    print(
        f"  β = {float(case.beta):g}: viscoelastic friction is the larger part for α from {ahead.min():.3g} to {ahead.max():.3g}; "
        f"dry F_v + approximate F_h {per_cent(float(ratio.min()))} to {per_cent(float(ratio.max()))}, "
        f"for α from 0.3 to 3 {per_cent(float(near.min()))} to {per_cent(float(near.max()))}"
    )


def figure_16(data):
    retarded, elastic = data.sel(f=100.0), data.sel(f=0.0).isel(alpha=0)
    for beta in (10, 100, 1000):
        case = retarded.sel(beta=beta, method="nearest")
        ahead = case.alpha.values[case.mu_v.values > case.mu_h.values]
        print(f"  β = {beta}: viscoelastic friction is the larger part for α from {ahead.min():.3g} to {ahead.max():.3g}; μ_tot at most {float(case.mu_tot.max()):.3f}")
    shares = (retarded.mu_h.isel(alpha=-1) / elastic.mu_h).values
    print(f"  μ_h at α = 1000 is that of the elastic substrate within {100 * np.max(np.abs(shares - 1)):.2f} %")
    parts = (retarded.dry_mu_v + elastic.mu_h) / retarded.mu_tot
    print(f"  dry F_v + elastic F_h over F_tot: {per_cent(float(parts.min()))} to {per_cent(float(parts.max()))}")


FIGURES = {
    "fig04": figure_4,
    "fig05": figure_5,
    "fig07a": pressures,
    "fig07b": pressures,
    "fig07c": pressures,
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
    results = Path(sys.argv[1] if len(sys.argv) > 1 else "results")
    for name, show in FIGURES.items():
        path = results / name / "results.h5"
        if not path.is_file():
            sys.exit(f"{path}: no such file; run scripts/figures first")
        print(name)
        with xr.open_dataset(path, engine="h5netcdf") as data:
            show(data)


if __name__ == "__main__":
    main()
