# /// script
# requires-python = ">=3.11"
# dependencies = ["h5py>=3.10", "numpy>=1.26", "scipy>=1.11"]
# ///
"""Recomputes every case of a sweep from its published fields, and compares with what the program published.

Usage:
    uv run scripts/audit.py results/quick

For every case with pressure and film in results.h5 (numbers in brackets are those of docs/explanation/theory.md):
    film      the surface displaced by the pressure, and the film under it (T3, T10), over the film, place by place
    flow      the pressure that the film and c make (T2), over the largest pressure, place by place
    c         from the film alone, (T2) over u³ integrated, over c
    load      the integral of the pressure (T4), over π/2
    forces    mu_v, mu_pressure, mu_shear, mu_h, mu_drag (T53, T54), over the drag of a roller that does not turn
    energy    energy_residual (T56)
    gap       film and displacement make the gap (T3), over the film
Pressure and film are splines through the published places; ahead of these the film follows from the pressure and the
pressure from the film. A constant in the displacement means nothing, and how two bodies share mu_v is taken
as published.

All is done again with every second and every third place alone, which tells the error of the field's grid. A deviation
is explained if it is below that error and the claimed one: the error_* column, or twice the tolerance if that is
larger; at a single place 0.3 √tolerance, to which the meshes resolve a solution (docs/explanation/accuracy.md). The sum
of its estimated errors stands for the tolerance of the relaxation method.

Exit code: 0; 1 if a deviation is not explained; 2 if the input is wrong.
"""

import argparse
import sys
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from lib.cases import open_fields, read_cases
from lib.displacement import displacement_matrix
from lib.messages import fail, format_count

# Where the last tail begins, places in the tail ahead, parts of an interval, places where films are compared.
FAR, TAIL, PARTS, COMPARED = 1e3, 240, 4, 120
# What the quadratures here leave at best.
FLOOR = 1e-7


def integral(x, values):
    """∫ values dx by a cubic spline."""
    return CubicSpline(x, values).integrate(x[0], x[-1])


class Recomputed:
    """All quantities of a case from its fields at the places x."""

    def __init__(self, case, step, matrices):
        x, self.p, self.u = (case[name][::step] for name in ("x", "pressure", "film_thickness"))
        self.case, self.x = case, x
        self.outlet, self.beta, self.c = case["x_outlet"], case["beta"], case["c"]
        self.level = case["separation"]
        self.film = CubicSpline(x, np.log(self.u))
        wet = x > self.outlet + 1e-9
        start = np.append(self.outlet, x[wet]), np.append(0, self.p[wet])
        self.pressure = CubicSpline(*start, bc_type=((1, 0.0), "not-a-knot"))
        fine = np.interp(np.arange(PARTS * (x.size - 1) + 1) / PARTS, np.arange(x.size), x)
        self.within = np.append(self.outlet, fine[fine > self.outlet + 1e-9])
        self.dry = np.append(fine[fine < self.outlet - 1e-9], self.outlet)
        self.ahead, self.behind = np.geomspace(x[-1], FAR, TAIL), -np.geomspace(-x[0], FAR, TAIL // 4)
        every = case["x"][::2]
        self.compared = every[:: max(1, every.size // COMPARED)]
        self.displace(fine, matrices)

    def displace(self, fine, matrices):
        """The displacement by the pressure, and the film and pressure ahead of the last place, which depend on it."""
        x, key = self.x, (self.x.size, *self.case["modes"])
        if key not in matrices:
            rows = np.concatenate([self.behind, self.compared, self.ahead])
            nodes = np.concatenate([[2 * x[0] - x[1]], fine, self.ahead[1:]])
            matrices[key] = displacement_matrix(rows, nodes, self.case["modes"])
        inside = np.where(fine > self.outlet, self.pressure(fine), 0)
        self.p_ahead = self.p[-1] * (self.ahead / x[-1]) ** -3.0
        log = np.log(self.ahead)
        for _ in range(3):
            w = matrices[key] @ np.concatenate([[0], inside, self.p_ahead[1:]])
            w += self.level + 0.5 * x[-1] ** 2 - self.u[-1] - w[-TAIL]
            self.w_behind, self.w_ahead = w[: TAIL // 4], w[-TAIL:]
            self.u_ahead = self.level + 0.5 * self.ahead**2 - self.w_ahead
            slope = (self.u_ahead - self.c) / (self.beta * self.u_ahead**3)
            rest = CubicSpline(log, slope * self.ahead).antiderivative()
            self.p_ahead = rest(log[-1]) - rest(log) + 4 / (3 * self.beta * FAR**3)
        self.w = w[TAIL // 4 : -TAIL]

    def profiles(self):
        """Place, pressure, film and slopes of film and displacement from the outlet to FAR."""
        x, log = self.within, np.log(self.ahead)
        w = CubicSpline(self.x, self.level + 0.5 * self.x**2 - self.u)
        slope = np.append(w(x, 1), CubicSpline(log, self.w_ahead)(log, 1) / self.ahead)
        film = np.exp(self.film(x))
        x = np.append(x, self.ahead)
        return x, np.append(self.pressure(self.within), self.p_ahead), np.append(film, self.u_ahead), x - slope, slope

    def over_film(self, values):
        """∫ values dx of a profile, as far as FAR."""
        inside, ahead = values[:-TAIL], values[-TAIL:]
        return integral(self.within, inside) + integral(np.log(self.ahead), ahead * self.ahead)

    def shear_behind(self):
        """∫ θ/u dx behind the outlet, as far as the gap is published and beyond."""
        filled = {"full": lambda u: 1 / u, "streamers": lambda u: self.c / u**2, "none": lambda u: 0 * u}
        of = filled[self.case["cavity_shear"]]
        u = self.level + 0.5 * self.behind**2 - self.w_behind
        rest = 2 / FAR if self.case["cavity_shear"] == "full" else 0
        beyond = integral(np.log(-self.behind), -self.behind * of(u))
        return integral(self.dry, of(np.exp(self.film(self.dry)))) + beyond + rest

    def numbers(self):
        """Load, c, forces and energy."""
        beta, c, speed = self.beta, self.c, self.case["S"]
        last, (x, p, u, u_slope, w_slope) = 1 / (np.pi * beta * FAR), self.profiles()
        load = self.over_film(p) + 2 / (3 * beta * FAR**2)
        flow = self.over_film(u**-2) / self.over_film(u**-3)
        hysteresis = 2 / np.pi * self.over_film(p * w_slope)
        pressure = -self.over_film(p * u_slope) / np.pi - 4 / 3 * last
        shear = (self.over_film(1 / u) + 2 / FAR + self.shear_behind()) / (3 * np.pi * beta)
        moment = 2 / np.pi * self.over_film(p * x) + 8 / 3 * last
        lost = self.over_film((u - c) ** 2 / u**3) / (np.pi * beta) + 2 * last
        flat = hysteresis - self.case["mu_v_roller"]
        drag = flat - pressure + speed * shear
        roller, side = (1 - speed) / 2, (1 + speed) / 2
        spent = self.case["mu_v_roller"] * roller + flat * side + lost + speed**2 * shear
        energy = (drag * side - (drag - moment) * roller - spent) / spent
        numbers = {"load": load / (np.pi / 2), "c": flow, "mu_v": hysteresis, "mu_pressure": pressure}
        numbers |= {"mu_shear": shear, "mu_h": pressure + speed * shear, "mu_drag": drag, "energy": energy}
        return numbers

    def places(self):
        """What is to be 0 place by place, with the places: film and flow."""
        film = self.level + 0.5 * self.compared**2 - self.w
        stored = np.exp(self.film(self.compared))
        thinnest = np.argmin(stored)
        off = film - stored - (film - stored)[thinnest]
        x = self.x[self.x > self.outlet]
        u = np.exp(self.film(self.within))
        rise = CubicSpline(self.within, (u**-2 - self.c * u**-3) / self.beta).antiderivative()
        p = self.p_ahead[0] + rise(self.within[-1]) - rise(x)
        return {"film": (self.compared, off / stored), "flow": (x, (p - self.pressure(x)) / self.p.max())}


def grid_errors(x, off, thinned):
    """What thinning changes in deviations at the places x: the largest at a place and its neighbours."""
    errors = np.zeros_like(off)
    for at, coarse in thinned:
        change = np.abs(np.interp(at, x, off) - coarse)
        wide = np.max([change, np.append(change[1:], 0), np.append(0, change[:-1])], axis=0)
        errors = np.maximum(errors, np.interp(x, at, wide))
    return errors


def deviations(case, matrices):
    """Yields name, deviation, claimed error, error of the field's grid, and the deviation that would be explained."""
    once, *thinned = (Recomputed(case, step, matrices) for step in (1, 2, 3))
    values, coarse = once.numbers(), [other.numbers() for other in thinned]
    drag, whole = (case["mu_v"] + sign * case["mu_pressure"] + case["mu_shear"] for sign in (-1, 1))
    for name, value in values.items():
        stored, claimed, scale = {"load": 1.0, "energy": case["energy_residual"]}.get(name), 0.0, 1.0
        if stored is None:
            stored, scale = case[name], case["c"] if name == "c" else drag
            size = max(abs(stored), 1e-3 * whole) if name == "mu_v" else abs(stored)
            claimed = case[f"error_{name}"] * size / scale
        grid = max(abs(value - other[name]) for other in coarse) / scale
        allowed = max(claimed, 2 * case["tolerance"]) + grid + FLOOR
        yield name, abs(value - stored) / scale, claimed, grid, allowed
    places, claimed = [other.places() for other in thinned], 0.3 * np.sqrt(case["tolerance"])
    for name, (x, off) in once.places().items():
        grid = grid_errors(x, off, [other[name] for other in places])
        worst = np.argmax(np.abs(off) / (claimed + grid))
        yield name, abs(off[worst]), claimed, grid[worst], claimed + grid[worst] + 100 * FLOOR
    if "displacement" in case:
        gap = once.level + 0.5 * case["x"] ** 2 - case["displacement"] - case["film_thickness"]
        yield "gap", np.max(np.abs(gap / case["film_thickness"])), 0.0, 0.0, FLOOR


def is_resolved(case):
    """Whether the places of the fields reach over the film and tell its inlet and its dip at the outlet."""
    x, u, c = case["x"], case["film_thickness"], case["c"]
    film = u[x > case["x_outlet"]]
    inlet = np.sum(film[np.flatnonzero(film < 1.2 * c)[-1] :] < 3 * c) if np.any(film < 1.2 * c) else 0
    reaches = x[0] < 0 < x[-1] and 20 < film.size < x.size - 4 and film[-1] > 3 * c
    return reaches and inlet > 3 and np.argmax(np.diff(film) > 0) > 0


def print_table(worst, unexplained):
    """Prints the largest deviation of each quantity, and those that are not explained."""
    print(f"{'':12} {'deviation':>9} {'claimed':>9} {'grid':>9}  largest at")
    for name, (deviation, claimed, grid, _, place) in worst.items():
        print(f"{name:12} {deviation:9.1e} {claimed:9.1e} {grid:9.1e}  {place}")
    for name, deviation, claimed, grid, _, place in unexplained:
        print(f"not explained: {name} deviates by {deviation:.1e}, claimed {claimed:.1e}, grid {grid:.1e}, at {place}")
    failed = format_count(len(unexplained), "deviation")
    print(f"{failed} not explained" if unexplained else "every deviation is explained")


def main():
    """Audits a data set."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", type=Path, help="a results directory, or its results.h5")
    path = parser.parse_args().results
    worst, unexplained, matrices, audited, unresolved = {}, [], {}, 0, 0
    try:
        for case in read_cases(*open_fields(path / "results.h5" if path.is_dir() else path)):
            if not is_resolved(case):
                unresolved += 1
                continue
            audited += 1
            for name, *numbers in deviations(case, matrices):
                if not numbers[0] <= numbers[-1]:
                    unexplained.append((name, *numbers, case["place"]))
                if name not in worst or numbers[0] > worst[name][0]:
                    worst[name] = (*numbers, case["place"])
    except ValueError as error:
        fail(f"{path}: {error}")
    print(f"{format_count(audited, 'case')} audited, {unresolved} left out: too few places in their film")
    if not audited:
        fail(f"{path}: nothing to audit; `output.x` needs more places, from behind the outlet to far ahead of the film")
    print_table(worst, unexplained)
    sys.exit(1 if unexplained else 0)


if __name__ == "__main__":
    main()
