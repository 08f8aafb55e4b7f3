"""Compares the numbers of two sweeps A and B: places of both, relative differences, estimated errors."""

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


def shared_values(a, b):
    """Pairs of indices of the values that two ascending axes share."""
    same = np.isclose(a[:, None], b[None, :], rtol=SAME, atol=0)
    return np.nonzero(same)


def scale(data, name):
    """What an error of a quantity is relative to."""
    if name == "mu_v":
        return np.maximum(abs(data["mu_v"]), LEAST_SHARE * abs(data["mu_tot"]))
    return abs(data[name])


def estimated_error(data, name):
    """The estimated error of a quantity in its own unit; for mu_tot the errors of its parts are added."""
    if name == "mu_tot":
        return estimated_error(data, "mu_v") + estimated_error(data, "mu_h")
    return data[f"error_{name}"] * scale(data, name)


class Comparison:
    """Two data sets at the places that both have; every array is over (f, alpha, beta) of A.

    `whole` holds the two data sets by letter, `places` their numbers of places, and `alone` the values of each axis
    that one of them has alone. `a` and `b` are cut to the places of both. `difference` and `estimate` hold, by
    quantity, |B - A| and the sum of both estimated errors, each over the scale of A.
    """

    def __init__(self, a, b):
        pairs = {name: shared_values(a[name].values, b[name].values) for name in AXES}
        self.whole = {"A": a, "B": b}
        self.places = {letter: data["status"].size for letter, data in self.whole.items()}
        self.alone = {
            letter: {name: np.delete(data[name].values, pairs[name][i]) for name in AXES}
            for i, (letter, data) in enumerate(self.whole.items())
        }
        self.a = a.isel({name: pairs[name][0] for name in AXES}).transpose(*AXES, ...)
        # B takes the coordinates of A, so that xarray aligns the two.
        coordinates = {name: self.a[name] for name in AXES}
        self.b = b.isel({name: pairs[name][1] for name in AXES}).transpose(*AXES, ...).assign_coords(coordinates)
        self.failed_a, self.failed_b = self.a["status"] == 1, self.b["status"] == 1
        self.converged = ~self.failed_a & ~self.failed_b
        self.changed = self.failed_a ^ self.failed_b
        self.difference = {name: self.relative_difference(name) for name in QUANTITIES}
        self.estimate = {name: self.relative_estimate(name) for name in ESTIMATED}

    @property
    def size(self):
        """Number of places that both have."""
        return self.a["status"].size

    def relative_difference(self, name):
        """|B - A| over the scale of A where both converged; infinite where one of them has no number."""
        change, unit = abs(self.b[name] - self.a[name]), scale(self.a, name)
        ratio = xr.where(change == 0, 0.0, change / unit)
        one_lacks = self.a[name].isnull() ^ self.b[name].isnull()
        return xr.where(one_lacks, np.inf, ratio).where(self.converged)

    def relative_estimate(self, name):
        """Sum of both estimated errors over the scale of A; NaN where there is no estimate."""
        total = estimated_error(self.a, name) + estimated_error(self.b, name)
        return xr.where(total == 0, 0.0, total / scale(self.a, name)).where(self.converged)

    def beyond(self, name):
        """Where the difference is more than both estimated errors together, rounding aside."""
        return self.difference[name] > self.estimate[name] + ROUNDING

    def not_estimated(self, name):
        """Where both converged and a quantity has no estimated error."""
        return self.estimate[name].isnull() & self.converged

    def largest(self):
        """The largest of all relative differences."""
        values = [self.difference[name].values.ravel() for name in QUANTITIES]
        return max((float(np.nanmax(row)) for row in values if not np.isnan(row).all()), default=0.0)
