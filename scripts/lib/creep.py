"""Retardation modes of the surface of a sweep, from its sweep file."""

import itertools

import numpy as np
from scipy.optimize import brentq

PREFIXES = {"": 1, "k": 1e3, "M": 1e6, "G": 1e9, "m": 1e-3, "u": 1e-6, "µ": 1e-6, "n": 1e-9}


def in_si(value):
    """A modulus or a time, with or without a unit: `"2.5 kPa"`; raises ValueError for other units than Pa and s."""
    if not isinstance(value, str):
        return float(value)
    number, _, unit = value.partition(" ")
    prefix = unit.strip().removesuffix("Pa").removesuffix("s")
    if prefix not in PREFIXES:
        raise ValueError(f"the unit of `{value}` is not known here")
    return float(number) * PREFIXES[prefix]


def creep(material):
    """Shares and relative rates of the retardation modes of a relaxation modulus (section "Materials")."""
    terms = sorted((in_si(term["time"]), in_si(term["modulus"])) for term in material["relaxation"])
    times, moduli = np.array(terms).T
    moduli = moduli / in_si(material["relaxed_modulus"])
    ends = np.append(-1 / times, 0)
    roots = []
    for low, high in itertools.pairwise(ends):
        inside = 1e-13 * (high - low)
        roots.append(brentq(lambda s: 1 + np.sum(moduli * s * times / (1 + s * times)), low + inside, high - inside))
    strengths = np.array([-1 / (s * np.sum(moduli * times / (1 + s * times) ** 2)) for s in roots])
    shares = strengths / strengths.sum()
    return list(zip(shares, -np.array(roots) * np.sum(shares / -np.array(roots)), strict=True))


def modes_of(sweep):
    """Shares of f, rates over α and whether they are the roller's, of all retardation modes that a sweep file gives.

    Raises ValueError where the file does not tell them in so many words.
    """
    bodies = {name: sweep[name] for name in ("substrate", "flat", "roller") if name in sweep}
    laboratory = sweep.get("laboratory", {})
    if "temperature" in laboratory or (laboratory and "roller" in bodies):
        raise ValueError("the modes of two materials, or shifted by temperature, are not known here")
    modes = []
    for name, body in bodies.items():
        listed = [(mode["share"], 1 / mode["time"]) for mode in body.get("modes", [])]
        if "relaxation" in body:
            if "relaxed_modulus" not in body or not all("modulus" in term for term in body["relaxation"]):
                raise ValueError("a relaxation is known here by terms of `modulus` beside a `relaxed_modulus`")
            listed = creep(body)
        modes += [(share, rate, name == "roller") for share, rate in listed]
    return modes or [(1.0, 1.0, False)]
