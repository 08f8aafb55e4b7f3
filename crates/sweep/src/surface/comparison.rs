//! Random points, and the errors of a surface there.

use super::domain::{Domain, Numbers};
use stribeck_surface::{ErrorRecord, Surface};

/// So many random points of a domain, spread evenly over its mapped axes.
pub fn random_points(domain: &Domain<'_>, count: usize, seed: u64) -> Vec<Vec<f64>> {
    random_numbers(domain.dimensions(), count, seed).iter().map(|t| domain.point(t)).collect()
}

/// So many random points, each coordinate in −1 ≤ t < 1. They depend on the seed alone: they are bits of a BLAKE3 hash
/// of it.
pub fn random_numbers(dimensions: usize, count: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut hasher = blake3::Hasher::new();
    hasher.update(b"stribeck surface points\n");
    hasher.update(&seed.to_le_bytes());
    let mut bits = hasher.finalize_xof();
    let mut number = || {
        let mut bytes = [0; 8];
        bits.fill(&mut bytes);
        // 53 bits, in −1 ≤ t < 1
        (u64::from_le_bytes(bytes) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| (0..dimensions).map(|_| number()).collect()).collect()
}

/// Points with their numbers.
#[derive(Clone, Debug, Default)]
pub struct Known {
    /// The points.
    pub points: Vec<Vec<f64>>,
    /// What is known there.
    pub numbers: Vec<Numbers>,
}

impl Known {
    /// Adds other points.
    pub fn add(&mut self, more: Self) {
        self.points.extend(more.points);
        self.numbers.extend(more.numbers);
    }
}

/// The errors of a surface at known points: for each quantity that at each point.
///
/// # Panics
/// If a point is not in the domain of the surface.
pub fn errors(surface: &Surface, known: &Known) -> Vec<Vec<f64>> {
    let mut evaluator = surface.evaluator();
    let mut all = vec![Vec::with_capacity(known.points.len()); surface.quantities().count()];
    for (point, numbers) in known.points.iter().zip(&known.numbers) {
        let values = evaluator.values(point).expect("points are made in the domain");
        for (q, errors) in all.iter_mut().enumerate() {
            let scale = numbers.values[q].abs().max(numbers.least[q]);
            errors.push((values[q] - numbers.values[q]).abs() / scale);
        }
    }
    all
}

/// What is told of the errors of a quantity.
pub fn summary(mut errors: Vec<f64>) -> ErrorRecord {
    errors.sort_by(f64::total_cmp);
    let at = |part: f64| errors[((errors.len() - 1) as f64 * part).ceil() as usize];
    ErrorRecord { largest: at(1.0), percentile_99: at(0.99), median: at(0.5) }
}
