# /// script
# requires-python = ">=3.10"
# dependencies = ["numpy>=1.26", "scipy>=1.11"]
# ///
"""Solves cases by another method and compares them with `stribeck solve`.

The pressure is piecewise linear on a graded grid, from far behind the cylinder to far ahead of it, and nothing is said
of where the film ends. Around each node either p = 0 or the flow into its cell is the flow out of it (p >= 0, residual
<= 0, one of them 0): a semismooth Newton method on min(p, -residual). The displacement by a linear piece is exact.
Three grids, each with twice the points of the one before, remove the errors of second and third order (Richardson); the
difference of the two extrapolations of second order is the error, at least a hundredth of what they add. Equations
(T1) to (T11) of docs/explanation/theory.md.

Usage:
    uv run scripts/second_opinion.py
    uv run scripts/second_opinion.py --case 1,1e4,100 --points 200 --stribeck target/release/stribeck

Exit code: 0; 1 if a difference is larger than the errors of both; 2 if the input is wrong or
Newton's method fails.
"""

import argparse
import json
import subprocess
import sys

import numpy as np
from scipy.interpolate import PchipInterpolator

from lib.displacement import displacement_matrix
from lib.messages import fail

# α, β, f
CASES = ["1,10,0", "1,1e5,0", "0.01,100,10", "0.1,1e3,10", "1,10,100", "1,1e3,100", "1,1e5,100", "10,1e4,10"]
CASES += ["100,1e5,100", "1000,1e4,1000"]
QUANTITIES = ["mu_v", "mu_h", "mu_drag", "c"]
END = 1000.0


class Grid:
    """Nodes that gather at the outlet (y = 0) and at the inlet, as a smooth function of the number of the node."""

    def __init__(self, inlet, widths, cells):
        self.inlet, self.widths = inlet, widths

        def place(y):
            return np.arcsinh(y / widths[0]) + np.arcsinh((y - inlet) / widths[1])

        table = np.concatenate([-np.geomspace(2 * END, 1e-7, 4000), [0], np.geomspace(1e-7, 2 * END, 4000)])
        step = (place(END) - place(0.0)) / cells
        behind = round(16 * (place(0.0) - place(-END)) / (place(END) - place(0.0))) * cells // 16
        wanted = place(0.0) + step * np.arange(-behind, cells + 1)
        y = np.interp(wanted, place(table), table)
        for _ in range(5):
            slope = 1 / np.hypot(y, widths[0]) + 1 / np.hypot(y - inlet, widths[1])
            y -= (place(y) - wanted) / slope
        y[behind] = 0.0
        self.y, self.h, self.middle, self.outlet = y, np.diff(y), 0.5 * (y[1:] + y[:-1]), behind


class Film:
    """Pressure at the nodes and film at the middles of the cells, for one case on a grid."""

    def __init__(self, case, grid, start):
        self.alpha, self.beta, self.f = case
        self.grid, self.kernel = grid, displacement_matrix(grid.middle, grid.y, [(self.f, self.alpha)])
        self.p, self.u, self.separation, self.shift = start
        self.fresh = True

    def step(self):
        """One semismooth Newton step in pressure, film and separation; returns how far the first two went."""
        h, p, u, end = self.grid.h, self.p, self.u, self.shift + self.grid.y[-1]
        p[-1] = 4 / (3 * self.beta * end**3)
        missing = self.separation + 0.5 * (self.shift + self.grid.middle) ** 2 - self.kernel @ p - u
        conduct = self.beta * u**3 / h
        scale = conduct[1:] + conduct[:-1]
        by_film = 1 + 3 * conduct * np.diff(p) / u
        flow = by_film[:, None] * np.hstack([-self.kernel, np.ones((h.size, 1))])
        faces = np.arange(h.size)
        flow[faces, faces] -= conduct
        flow[faces, faces + 1] += conduct
        rows = np.diff(flow, axis=0) / scale[:, None]
        residual = np.diff(conduct * np.diff(p) + u + by_film * missing) / scale
        empty = self.grid.y[1:-1] <= 0 if self.fresh else p[1:-1] < -residual
        self.fresh = False
        rows[empty] = np.eye(p.size - 2, p.size + 1, 1)[empty]
        residual[empty] = p[1:-1][empty]
        weights = 0.5 * (np.append(h, 0) + np.append(0, h))
        load = weights @ p + 2 / (3 * self.beta * end**2) - np.pi / 2
        matrix = np.vstack([rows, np.append(weights, 0)])[:, np.r_[1 : p.size - 1, p.size]]
        change = np.linalg.solve(matrix, -np.append(residual, load))
        rise = missing + change[-1] - self.kernel[:, 1:-1] @ change[:-1]
        part = 1 / max(1.0, np.max(-rise / u) / 0.8, np.max(rise / u) / 4)
        p[1:-1] += part * change[:-1]
        self.u = u + part * rise
        self.separation += part * change[-1]
        return max(np.max(np.abs(change[:-1])) / np.max(p), np.max(np.abs(rise) / u))

    def solve(self):
        """Newton's method; afterwards the grid is moved until the outlet lies on its node, and all is repeated."""
        for _ in range(80):
            if self.step() < 1e-7:
                moved = self.outlet()
                if abs(moved) < 1e-2 * self.grid.h[self.grid.outlet]:
                    return self
                self.shift += moved
        raise ArithmeticError(f"no convergence at beta = {self.beta:g}; take more --points")

    def flow(self):
        """c, the flow under the cylinder."""
        u, k = self.u, np.argmax(self.p)
        return self.beta * (self.p[k] - self.p[k - 1]) / self.grid.h[k - 1] * u[k - 1] ** 3 + u[k - 1]

    def outlet(self):
        """Where the film has become c thick, over the node where it should be."""
        y, u, c = self.grid.middle, self.u, self.flow()
        k = np.argmax(u < c)
        return np.interp(-c, -u[k - 1 : k + 1], y[k - 1 : k + 1])

    def next_grid(self, cells):
        """A grid that fits this film: places and widths of outlet and inlet."""
        y, u, c = self.grid.middle, self.u, self.flow()
        rises = np.diff(u) > 0
        dip, last = np.argmax(rises), np.flatnonzero(~rises)[-1] + 1
        begin, end = np.interp([1.2 * c, 3 * c], u[last:], y[last:])
        return Grid(begin, (0.5 * (y[dip] - self.outlet()), 0.5 * (end - begin)), cells)

    def on(self, grid, beta):
        """This film as a start on another grid, at another beta."""
        p = np.maximum(PchipInterpolator(self.grid.y, self.p, extrapolate=False)(grid.y), 0)
        u = np.exp(np.interp(grid.middle, self.grid.middle, np.log(self.u)))
        thinner = (self.beta / beta) ** (0.6 * np.exp(-np.maximum(u / self.flow() - 1, 0)))
        return Film((self.alpha, beta, self.f), grid, (np.nan_to_num(p), u * thinner, self.separation, self.shift))

    def numbers(self):
        """mu_v, mu_h, mu_drag and c, with what lies beyond the grid ("Friction" in docs/explanation/theory.md)."""
        h, u, dp = self.grid.h, self.u, np.diff(self.p)
        w = self.kernel @ self.p
        mu_v = -2 / np.pi * dp @ (w - w[-1])
        behind, ahead = -self.shift - self.grid.y[0], self.shift + self.grid.y[-1]
        pressure = dp @ u / np.pi - 2 / (np.pi * self.beta * ahead)
        shear = (np.sum(h / u) + 2 / behind + 2 / ahead) / (3 * np.pi * self.beta)
        return np.array([mu_v, pressure + shear, mu_v + shear - pressure, self.flow()])


def first_film(alpha, f, cells):
    """A film so thick that the cylinder is rigid beside it, from a smooth pressure of the right load."""
    beta = 1e-2
    separation = 0.2597 / beta
    reach = np.sqrt(2 * separation)
    grid = Grid(1.5 * reach, (0.3 * reach, 0.7 * reach), cells)
    p = np.where(grid.y > 0, np.exp(-((grid.y / reach - 0.9) ** 2) / 0.36), 0)
    p *= np.pi / 2 / (p[1:] @ grid.h)
    shift = -0.475 * reach
    start = p, separation + 0.5 * (shift + grid.middle) ** 2, separation, shift
    return Film((alpha, beta, f), grid, start).solve()


def second_opinion(case, cells):
    """Numbers of a case (alpha, beta, f) and their errors."""
    film = first_film(case[0], case[2], cells)
    while film.beta < case[1]:
        film = film.on(film.next_grid(cells), min(film.beta * 10**0.25, case[1])).solve()
    fitted, values = film.next_grid(cells), []
    for times in (1, 2, 4):
        film = film.on(Grid(fitted.inlet, fitted.widths, times * cells), film.beta).solve()
        values.append(film.numbers())
    once = np.array(values[1:]) + np.diff(values, axis=0) / 3
    errors = np.maximum(np.abs(once[1] - once[0]), 0.01 * np.abs(once[1] - values[2]))
    return once[1] + (once[1] - once[0]) / 7, errors


def of_program(program, case):
    """The same numbers by `stribeck solve`, and the errors that it estimates."""
    command = [program, "solve", "--json", "--tolerance", "1e-8"]
    command += [f"--{name}={value!r}" for name, value in zip(("alpha", "beta", "f"), case, strict=True)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        fail(f"{program}: {error.strerror}; name the program by --stribeck")
    if run.returncode:
        fail(f"{' '.join(command)}: {run.stderr or run.stdout}")
    solved = json.loads(run.stdout)
    values = np.array([solved[name] for name in QUANTITIES])
    scale = np.maximum(np.abs(values), [1e-3 * solved["mu_tot"], 0, 0, 0])
    return values, scale * [solved[f"error_{name}"] for name in QUANTITIES]


def numbers(text):
    """Three positive numbers; f may be 0."""
    alpha, beta, f = (float(part) for part in text.split(","))
    if not (0 < alpha < np.inf and 0.01 < beta < np.inf and 0 <= f < np.inf):
        raise ValueError
    return alpha, beta, f


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", type=numbers, action="append", metavar="ALPHA,BETA,F", help="default: ten cases")
    parser.add_argument(
        "--points", type=int, default=128, help="cells ahead of the outlet on the first grid (%(default)s)"
    )
    parser.add_argument("--stribeck", default="stribeck", metavar="PROGRAM", help="the program (%(default)s)")
    arguments = parser.parse_args()
    print("| α | β | f | | `stribeck` | second opinion | difference | error |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    within = True
    for case in arguments.case or map(numbers, CASES):
        theirs, estimates = of_program(arguments.stribeck, case)
        try:
            ours, errors = second_opinion(case, arguments.points)
        except ArithmeticError as error:
            fail(f"alpha, beta, f = {case}: {error}")
        within &= bool(np.all(np.abs(ours - theirs) <= errors + estimates))
        place = " | ".join(f"{value:g}" for value in case)
        for name, *row in zip(QUANTITIES, theirs, ours, ours - theirs, errors, strict=True):
            print(f"| {place} | {name} | {row[0]:.9g} | {row[1]:.9g} | {row[2]:.1e} | {row[3]:.1e} |", flush=True)
    print("all differences are below the errors" if within else "a difference is larger than the errors")
    sys.exit(0 if within else 1)


if __name__ == "__main__":
    main()
