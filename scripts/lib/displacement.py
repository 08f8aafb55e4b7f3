"""Displacement of a viscoelastic half space by pressure that is linear between nodes: docs/theory.md, (T10), (T11)."""

import numpy as np
from scipy.special import exp1, expi


def lag_twice_integrated(z):
    """S(z) + ln|z| + z ln|z| - z + g(1 + z) of an array: S(z) = -e^z Ei(-z) twice integrated; g is Euler's constant."""
    small, large = np.abs(z) < 2, np.abs(z) > 40
    log = np.log(np.maximum(np.abs(z), 1e-300))
    # By series: -(ln|z| + g)(e^z - 1 - z) + Σ H_k z^k/k! from k = 2 on, with H_k = 1 + 1/2 + … + 1/k.
    inner = np.where(small, z, 0.0)
    term, exponential, series, harmonic = inner, 0.0, 0.0, 1.0
    for k in range(2, 30):
        term, harmonic = term * inner / k, harmonic + 1 / k
        exponential, series = exponential + term, series + harmonic * term
    series = series - (log + np.euler_gamma) * exponential
    # S itself, far out by its asymptotic series.
    outer, middle = np.where(large, z, 100.0), np.where(small | large, 2.0, z)
    far, term = 0.0, 1 / outer
    for k in range(1, 30):
        far, term = far + term, -term * k / outer
    near = -np.exp(middle) * np.where(middle > 0, -exp1(np.abs(middle)), expi(np.abs(middle)))
    beyond = np.where(large, far, near) + log * (1 + z) - z + np.euler_gamma * (1 + z)
    return np.where(small, series, beyond)


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
