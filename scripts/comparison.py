"""The numbers of a comparison of two sweeps A and B: places of both, relative differences, estimated errors."""

import numpy as np
import xarray as xr

AXES = ("f", "alpha", "beta")
# Values of two axes that are as near as this are the same place, however the two files write them.
SAME = 1e-9
# What a difference may owe to rounding, where both errors are estimated as nothing.
ROUNDING = 4 * np.finfo(float).eps
# mu_v vanishes on an elastic substrate: there it is compared with this share of mu_tot, as its estimated error is.
LEAST_SHARE = 1e-3
QUANTITIES = ("mu_v", "mu_h", "mu_tot", "c", "film_min", "p_max")
ESTIMATED = ("mu_v", "mu_h", "mu_tot", "c")


def matched(a, b):
    """Pairs of indices of the values that two ascending axes share."""
    same = np.isclose(a[:, None], b[None, :], rtol=SAME, atol=0)
    return np.nonzero(same)


def scale(data, name):
    """What an error of a quantity is relative to."""
    if name == "mu_v":
        return np.maximum(abs(data["mu_v"]), LEAST_SHARE * abs(data["mu_tot"]))
    return abs(data[name])


def error(data, name):
    """The estimated error of a quantity in its own unit; that of mu_tot is the sum of those of its parts."""
    if name == "mu_tot":
        return error(data, "mu_v") + error(data, "mu_h")
    return data[f"error_{name}"] * scale(data, name)


class Comparison:
    """Two data sets at the places that both have; every array is over (f, alpha, beta) of A.

    `difference` and `estimate` hold, by quantity, |B - A| and the sum of both estimated errors, each over the scale of A.
    """

    def __init__(self, a, b):
        pairs = {name: matched(a[name].values, b[name].values) for name in AXES}
        self.alone = {
            "A": {name: np.delete(a[name].values, pairs[name][0]) for name in AXES},
            "B": {name: np.delete(b[name].values, pairs[name][1]) for name in AXES},
        }
        self.places = {"A": a["status"].size, "B": b["status"].size}
        self.whole = {"A": a, "B": b}
        self.a = a.isel({name: pairs[name][0] for name in AXES}).transpose(*AXES, ...)
        # B takes the coordinates of A, so that xarray aligns the two.
        coordinates = {name: self.a[name] for name in AXES}
        self.b = b.isel({name: pairs[name][1] for name in AXES}).transpose(*AXES, ...).assign_coords(coordinates)
        self.failed_a, self.failed_b = self.a["status"] == 1, self.b["status"] == 1
        self.converged = ~self.failed_a & ~self.failed_b
        self.changed = self.failed_a ^ self.failed_b
        self.difference = {name: self.relative(name) for name in QUANTITIES}
        self.estimate = {name: self.estimated(name) for name in ESTIMATED}

    @property
    def size(self):
        """Number of places that both have."""
        return self.a["status"].size

    def relative(self, name):
        """|B - A| over the scale of A where both converged; infinite where one of them has no number."""
        change, unit = abs(self.b[name] - self.a[name]), scale(self.a, name)
        ratio = xr.where(change == 0, 0.0, change / unit)
        one_lacks = self.a[name].isnull() ^ self.b[name].isnull()
        return xr.where(one_lacks, np.inf, ratio).where(self.converged)

    def estimated(self, name):
        """Sum of both estimated errors over the scale of A; NaN where there is no estimate."""
        total = error(self.a, name) + error(self.b, name)
        return xr.where(total == 0, 0.0, total / scale(self.a, name)).where(self.converged)

    def beyond(self, name):
        """Where the difference is more than both estimated errors together, rounding aside."""
        return self.difference[name] > self.estimate[name] + ROUNDING

    def largest(self):
        """The largest of all relative differences."""
        values = [self.difference[name].values.ravel() for name in QUANTITIES]
        return max((float(np.nanmax(row)) for row in values if not np.isnan(row).all()), default=0.0)
