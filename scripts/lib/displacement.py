"""Displacement by pressure that is linear between nodes: (T10), (T11) of docs/explanation/theory.md."""

import numpy as np
from scipy.special import exp1, expi


def by_series(z):
    """-(ln|z| + g)(e^z - 1 - z) + Σ H_k z^k/k! from k = 2 on, with H_k = 1 + 1/2 + … + 1/k; for small z."""
    term, exponential, sums, harmonic = z, 0.0, 0.0, 1.0
    for k in range(2, 30):
        term, harmonic = term * z / k, harmonic + 1 / k
        exponential, sums = exponential + term, sums + harmonic * term
    return sums - (np.log(np.maximum(np.abs(z), 1e-300)) + np.euler_gamma) * exponential


def lag(z):
    """S(z) = -e^z Ei(-z) for z that is not small, by its asymptotic series where that has all the digits."""
    value, term, near = np.zeros_like(z), 1 / z, np.abs(z) < 40
    for k in range(1, 30):
        value, term = value + term, -term * k / z
    ahead, behind = near & (z > 0), near & (z < 0)
    value[ahead] = np.exp(z[ahead]) * exp1(z[ahead])
    value[behind] = -np.exp(z[behind]) * expi(-z[behind])
    return value


def lag_twice_integrated(z):
    """S(z) + ln|z| + z ln|z| - z + g(1 + z): S twice integrated, less a line; g is Euler's constant."""
    small = np.abs(z) < 2
    value, large = np.empty_like(z), z[~small]
    value[small] = by_series(z[small])
    value[~small] = lag(large) + np.log(np.abs(large)) * (1 + large) - large + np.euler_gamma * (1 + large)
    return value


def displacement_matrix(x, nodes, modes):
    """What the pressures at the nodes make of the displacement at x, a matrix of shape (x, nodes), up to a constant.

    The pressure is 0 at both end nodes and beyond. Modes are (f_j, alpha_j); alpha_j may be 0 and infinite.
    """
    distance = x[:, None] - nodes
    whole = 1 + sum(strength for strength, _ in modes)
    moved = whole - sum(strength for strength, rate in modes if rate == 0)
    twice = moved / whole * distance**2 * (0.5 * np.log(np.maximum(np.abs(distance), 1e-300)) - 0.75)
    for strength, rate in modes:
        if strength > 0 and 0 < rate < np.inf:
            twice += strength / whole * lag_twice_integrated(rate * distance) / rate**2
    matrix = np.zeros_like(distance)
    matrix[:, 1:-1] = np.diff(np.diff(twice, axis=1) / np.diff(nodes), axis=1) / np.pi
    return matrix
