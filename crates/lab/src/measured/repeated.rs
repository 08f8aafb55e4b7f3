//! Readings that were taken at one place, as one point: their mean, and its standard error from their scatter.

use std::collections::HashMap;
use std::iter::Sum;

use super::Measured;

/// The fewest readings whose scatter is told.
const FEWEST: usize = 3;
/// The fewest readings whose scatter is that of their point: of fewer it is known so badly that all points together
/// tell it better, relative to their means.
const ENOUGH: usize = 10;
/// The coordinate that no machine holds still.
const TEMPERATURE: &str = "temperature";
/// How far apart the temperatures of readings at one place may be, in K.
const NEAR_KELVINS: f64 = 5.0;
/// A step of the temperature, in K, behind which another place begins: more than a thermostat wavers.
const STEP: f64 = 1.0;
/// How far the readings of a step may be from their median, relative to it or, for ratios, as they are.
const NEAR: f64 = 0.02;
/// The part of the readings of a step that must be near the median.
const MOST: f64 = 0.8;

/// The points of readings that are all taken at their places three times or more: `None` if some are not, or readings
/// have errors of their own, or none scatter.
pub(super) fn averaged(readings: &Measured) -> Option<Measured> {
    if readings.errors.is_some() {
        return None;
    }
    let groups = groups(readings);
    let points = groups.iter().all(|group| group.len() >= FEWEST).then(|| {
        let all = groups.iter().map(|group| Scatter::of(readings, group)).sum();
        mean(readings, &groups, all)
    })?;
    points.errors.is_some().then_some(points)
}

/// Readings by their places, in the order of the file. Temperatures that are near each other are one place.
fn groups(readings: &Measured) -> Vec<Vec<usize>> {
    let temperatures = readings.coordinate(TEMPERATURE).unwrap_or_default();
    let spread = |group: &Vec<usize>| {
        let values = || group.iter().filter_map(|reading| temperatures.get(*reading).copied());
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let without = by(readings, |name| name != TEMPERATURE);
    let mut parts: Vec<Vec<usize>> = match temperatures {
        [] => without,
        _ => without.into_iter().flat_map(|group| at_steps(group, temperatures)).collect(),
    };
    parts.sort_by_key(|part| part[0]);
    if parts.iter().all(|part| spread(part) <= NEAR_KELVINS) { parts } else { by(readings, |_| true) }
}

/// Readings that agree in some coordinates, in the order of the file.
fn by(readings: &Measured, is_key: impl Fn(&str) -> bool) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut known: HashMap<Vec<u64>, usize> = HashMap::new();
    for reading in 0..readings.friction.len() {
        let keys = readings.coordinates.iter().filter(|(name, _)| is_key(name));
        let place = keys.map(|(_, values)| values[reading].to_bits()).collect();
        let group = *known.entry(place).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(reading);
    }
    groups
}

/// A group in parts at temperatures that are a step apart, if each part has readings enough; else as it is.
fn at_steps(group: Vec<usize>, temperatures: &[f64]) -> Vec<Vec<usize>> {
    let mut sorted = group.clone();
    sorted.sort_by(|a, b| temperatures[*a].total_cmp(&temperatures[*b]));
    let parts = sorted.chunk_by(|a, b| temperatures[*b] - temperatures[*a] <= STEP);
    if parts.clone().any(|part| part.len() < FEWEST) {
        return vec![group];
    }
    let in_order = |part: &[usize]| {
        let mut part = part.to_vec();
        part.sort_unstable();
        part
    };
    parts.map(in_order).collect()
}

/// The readings of a step that were taken at one place; `None` if the step runs over several.
pub(super) fn at_one_place(readings: &Measured) -> Option<Vec<usize>> {
    let count = readings.friction.len();
    let medians: Vec<f64> = readings.coordinates.iter().map(|(_, values)| median(values)).collect();
    let is_near = |reading: &usize| {
        readings.coordinates.iter().zip(&medians).all(|((name, values), median)| {
            let scale = if *name == "slide_roll_ratio" { median.abs().max(1.0) } else { median.abs() };
            (values[*reading] - median).abs() <= NEAR * scale
        })
    };
    let near: Vec<usize> = (0..count).filter(is_near).collect();
    (near.len() >= FEWEST && near.len() as f64 >= MOST * count as f64).then_some(near)
}

/// How far readings lie from the means of their places, relative to them.
#[derive(Clone, Copy)]
pub(super) struct Scatter {
    squares: f64,
    /// How many of the deviations are independent.
    independent: f64,
}

impl Scatter {
    /// Of the readings of one place.
    pub(super) fn of(readings: &Measured, group: &[usize]) -> Self {
        let mean = average(&readings.friction, group);
        let square = |reading: &usize| (readings.friction[*reading] / mean - 1.0).powi(2);
        Self { squares: group.iter().map(square).sum(), independent: group.len() as f64 - 1.0 }
    }
}

impl Sum for Scatter {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        let nothing = Self { squares: 0.0, independent: 0.0 };
        all.fold(nothing, |sum, of| Self {
            squares: sum.squares + of.squares,
            independent: sum.independent + of.independent,
        })
    }
}

/// The mean of some readings; that of equal values is that value to the last bit.
fn average(values: &[f64], group: &[usize]) -> f64 {
    let first = values[group[0]];
    first + group.iter().map(|reading| values[*reading] - first).sum::<f64>() / group.len() as f64
}

/// A point for each group of readings; `all` is the scatter of all places of the file. It has no errors if readings do
/// not scatter.
pub(super) fn mean(readings: &Measured, groups: &[Vec<usize>], all: Scatter) -> Measured {
    let means = |values: &[f64]| groups.iter().map(|group| average(values, group)).collect::<Vec<f64>>();
    let error = |group: &Vec<usize>| {
        let Scatter { squares, independent } = if group.len() < ENOUGH { all } else { Scatter::of(readings, group) };
        average(&readings.friction, group).abs() * (squares / independent / group.len() as f64).sqrt()
    };
    let errors: Vec<f64> = groups.iter().map(error).collect();
    Measured {
        friction: means(&readings.friction),
        errors: Some(errors).filter(|errors| errors.iter().all(|error| *error > 0.0 && error.is_finite())),
        places: groups.iter().map(|group| readings.places[group[0]]).collect(),
        coordinates: readings.coordinates.iter().map(|(name, values)| (*name, means(values))).collect(),
        is_averaged: true,
        ..readings.clone()
    }
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
