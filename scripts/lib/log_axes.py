"""Logarithmic axes of a sweep: where its values stand, infinity and zero beside the rest, and how they are labelled."""

import numpy as np
from matplotlib.ticker import FixedLocator, LogFormatterMathtext, LogLocator, NullFormatter, NullLocator


def format_value(value):
    """A value of an axis as text."""
    return "∞" if value == np.inf else f"{value:.6g}"


def nearest(values, wanted):
    """Index of the value nearest to the one wanted, by ratio; 0 and infinity are the ends."""
    logs = np.log(np.clip([*values, wanted], 1e-300, 1e300))
    return int(np.argmin(np.abs(logs[:-1] - logs[-1])))


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


def label_decades(axis):
    """Labels an axis at its decades alone."""
    axis.set_major_locator(LogLocator(numticks=12))
    axis.set_major_formatter(LogFormatterMathtext())
    axis.set_minor_formatter(NullFormatter())


def label_range(axis, low, high):
    """Labels the decades of an axis from low to high, and 2 and 5 between them if there are few."""
    if high / low > 300:
        label_decades(axis)
        return
    ticks = np.outer(10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1), [1, 2, 5]).ravel()
    ticks = ticks[(ticks >= low) & (ticks <= high)]
    if ticks.size < 2:
        ticks = np.array([low, np.sqrt(low * high), high])
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(lambda value, _: f"{value:.3g}")
    axis.set_minor_formatter(NullFormatter())
