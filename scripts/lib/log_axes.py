"""Logarithmic axes of a sweep: where its values stand, infinity and zero beside the rest, and how they are labelled."""

import numpy as np
from matplotlib.ticker import LogLocator, NullLocator


def format_value(value):
    """A value of an axis as text."""
    return "∞" if value == np.inf else f"{value:.6g}"


def positions(values):
    """Where values stand on a logarithmic axis: infinity one step beyond the last, zero one step before the first."""
    proper = values[(values > 0) & np.isfinite(values)]
    low, high = (proper[0], proper[-1]) if proper.size else (1.0, 1.0)
    step = max((high / low) ** 0.08, 2.0)
    return np.where(values == np.inf, high * step, np.where(values == 0, low / step, values))


def edges(centres):
    """Edges of the cells around places on a logarithmic axis; a single one gets a cell of a decade."""
    logs = np.log(np.asarray(centres, dtype=float))
    if logs.size == 1:
        return np.exp(logs[0] + np.log(10) * np.array([-0.5, 0.5]))
    middles = (logs[1:] + logs[:-1]) / 2
    return np.exp(np.concatenate([[2 * logs[0] - middles[0]], middles, [2 * logs[-1] - middles[-1]]]))


def label_values(axis, values):
    """Labels the decades of an axis on which values stand at their `positions`, and infinity or zero by name."""
    where = positions(values)
    low, high = where.min(), where.max()
    names = {place: format_value(value) for place, value in zip(where, values, strict=True) if value in (0, np.inf)}
    decades = [tick for tick in LogLocator(numticks=7).tick_values(low, high) if low / 1.01 <= tick <= high * 1.01]
    far = [tick for tick in decades if all(abs(np.log(tick / place)) > np.log(high / low) / 20 for place in names)]
    labels = [f"$10^{{{round(np.log10(tick))}}}$" for tick in far] + list(names.values())
    if not labels:
        far, labels = [low, high], [format_value(low), format_value(high)]
    axis.set_ticks([*far, *names], labels)
    axis.set_minor_locator(NullLocator())
