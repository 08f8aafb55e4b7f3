"""Writes a comparison as CSV, with a row for each place of A or B."""

import csv

import numpy as np

from lib.comparison import AXES, ESTIMATED, QUANTITIES
from lib.messages import fail
from lib.results import decode

STATUS = ("converged", "failed")
HEADER = [*AXES, "in", "status_a", "status_b", "reason_a", "reason_b"]
HEADER += [f"difference_{name}" for name in QUANTITIES] + [f"estimate_{name}" for name in ESTIMATED]


def state(data, index, letter):
    """Where a place is, and what became of it in one of the two data sets."""
    place = {name: float(data[name].values[i]) for name, i in zip(AXES, index, strict=True)}
    status, reason = STATUS[data["status"].values[index]], decode(data["reason"].values[index])
    return place | {f"status_{letter.lower()}": status, f"reason_{letter.lower()}": reason}


def rows_of_both(comparison):
    """Rows of the places that both have; a number that does not exist is left out."""
    numbers = {f"difference_{name}": values.values for name, values in comparison.difference.items()}
    numbers |= {f"estimate_{name}": values.values for name, values in comparison.estimate.items()}
    for index in np.ndindex(*comparison.a["status"].shape):
        cells = {name: repr(float(values[index])) for name, values in numbers.items() if not np.isnan(values[index])}
        # The coordinates of B are those of A.
        yield state(comparison.a, index, "A") | state(comparison.b, index, "B") | cells | {"in": "both"}


def rows_alone(data, letter, alone):
    """Rows of the places that one of the two data sets has alone."""
    data = data.transpose(*AXES, ...)
    f, alpha, beta = (np.isin(data[name].values, alone[name]) for name in AXES)
    for index in zip(*np.nonzero(f[:, None, None] | alpha[:, None] | beta), strict=True):
        yield state(data, index, letter) | {"in": letter}


def write_table(comparison, path):
    """Writes the table; a cell is empty where there is no number."""
    try:
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, HEADER, restval="")
            writer.writeheader()
            writer.writerows(rows_of_both(comparison))
            for letter, data in comparison.whole.items():
                writer.writerows(rows_alone(data, letter, comparison.alone[letter]))
    except OSError as error:
        fail(f"{path}: {error.strerror}; name a file in a directory that exists and may be written to")
    print(f"wrote {path}")
