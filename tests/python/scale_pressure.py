"""Multiplies the pressure of the last case of a results.h5 by a factor.

Usage:
    python tests/python/scale_pressure.py results/results.h5 1.001
"""

import sys

import h5py

with h5py.File(sys.argv[1], "r+") as data:
    data["pressure"][-1, -1, -1] *= float(sys.argv[2])
