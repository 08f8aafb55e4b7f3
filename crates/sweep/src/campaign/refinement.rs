//! Numbers of points with which a sweep keeps what was solved of the one before it.
//!
//! A range of N points is refined without loss by k (N − 1) + 1 points: the old ones are among the new ones, to the last
//! bit. Other numbers of points share little more than the ends.

use std::fmt;

use super::{MergedCatalog, Pending};
use crate::{Grid, Plan, Sweep};
use stribeck_input::range_values;

/// Above so many places a refined sweep is not looked at.
const MOST_PLACES: usize = 10_000_000;

/// Numbers of points that keep every case of the sweep before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refinement {
    /// The axes whose numbers are others than in the sweep file.
    pub points: Vec<(&'static str, usize)>,
    /// The cases that are kept.
    pub keeps: u64,
}

impl fmt::Display for Refinement {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let points = self.points.iter().map(|(axis, points)| format!("{points} points of {axis}"));
        write!(formatter, "{} keep all {}", points.collect::<Vec<_>>().join(" and "), self.keeps)
    }
}

/// An axis that is the same range as before, with more points.
struct Growth {
    axis: usize,
    is_logarithmic: bool,
    /// Intervals before and now.
    intervals: [usize; 2],
}

impl Growth {
    fn of(axis: usize, before: &[f64], now: &[f64]) -> Option<Self> {
        let is_range = |values: &[f64], is_logarithmic: bool| match values {
            [from, .., to] if *from > 0.0 || !is_logarithmic => {
                values == range_values(*from, *to, values.len(), is_logarithmic)
            }
            _ => false,
        };
        let fits = |is_logarithmic: &bool| [before, now].into_iter().all(|values| is_range(values, *is_logarithmic));
        let is_logarithmic = [true, false].into_iter().find(fits)?;
        let same_ends = before.first() == now.first() && before.last() == now.last();
        (same_ends && now.len() > before.len()).then(|| Self {
            axis,
            is_logarithmic,
            intervals: [before.len() - 1, now.len() - 1],
        })
    }

    /// The number of intervals that keeps the points before, next to the one now: the one below, or the one above.
    fn intervals(&self, up: bool) -> usize {
        let [before, now] = self.intervals;
        before * if up { now.div_ceil(before) } else { now / before }
    }
}

/// The refinements of the sweep before that are nearest to a sweep with other numbers of points, and keep all that is
/// stored of the one before; none if the sweep itself keeps it, or is no refinement.
pub(super) fn refinements(before: &Sweep, sweep: &Sweep, stored: &MergedCatalog<'_>) -> Vec<Refinement> {
    let (mut old, mut new) = (before.clone(), sweep.clone());
    let (old, new) = (axes(&mut old.grid), axes(&mut new.grid));
    let names = |axes: &[(&'static str, &mut Vec<f64>)]| axes.iter().map(|(name, _)| *name).collect::<Vec<_>>();
    if names(&old) != names(&new) {
        return Vec::new();
    }
    let changed = (0..old.len()).filter(|&axis| old[axis].1 != new[axis].1);
    let Some(grown) = changed.map(|axis| Growth::of(axis, old[axis].1, new[axis].1)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let survey = |sweep: &Sweep| Pending::survey(sweep, &Plan::new(sweep), None, stored);
    let loses = grown.iter().any(|growth| growth.intervals[1] % growth.intervals[0] != 0);
    let kept = survey(before);
    if !loses || kept.reused() == 0 {
        return Vec::new();
    }
    let mut found: Vec<Refinement> = Vec::new();
    for up in [false, true] {
        let mut refined = sweep.clone();
        let mut points = Vec::new();
        for ((name, values), growth) in axes(&mut refined.grid)
            .into_iter()
            .enumerate()
            .filter_map(|(axis, it)| Some((it, grown.iter().find(|growth| growth.axis == axis)?)))
        {
            let intervals = growth.intervals(up);
            if intervals != growth.intervals[1] {
                points.push((name, intervals + 1));
            }
            *values = range_values(values[0], values[values.len() - 1], intervals + 1, growth.is_logarithmic);
        }
        if refined.grid == before.grid || refined.grid.cases() > MOST_PLACES {
            continue;
        }
        let pending = survey(&refined);
        if pending.reused() >= kept.reused() && pending.unplaced <= kept.unplaced {
            found.push(Refinement { points, keeps: kept.reused() });
        }
    }
    found.dedup();
    found
}

/// The axes of a grid, by name.
fn axes(grid: &mut Grid) -> Vec<(&'static str, &mut Vec<f64>)> {
    match grid {
        Grid::Dimensionless(axes) => {
            let ratio = axes.slide_roll.as_mut().map(|ratios| ("slide_roll", ratios));
            let others = [("f", &mut axes.f), ("alpha", &mut axes.alpha), ("beta", &mut axes.beta)];
            ratio.into_iter().chain(others).collect()
        }
        Grid::Laboratory(axes) => {
            let given = axes.given.iter_mut().map(|given| (given.quantity.name(), &mut given.values));
            std::iter::once(("f", &mut axes.f)).chain(given).collect()
        }
    }
}
