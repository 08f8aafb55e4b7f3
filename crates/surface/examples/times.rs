//! Prints what a point of surfaces costs: `cargo run --release -p stribeck-surface --example times -- FILE…`.
//!
//! Random points take a contraction of all coefficients each. Along a line of a thousand points, the other coordinates are
//! contracted once.

use std::hint::black_box;
use std::time::Instant;

use stribeck_surface::{Axis, Surface};

/// Points of each kind.
const POINTS: u32 = 20_000;
/// Points along a line.
const ALONG: u32 = 1000;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("ns at a random point   with derivatives   along lines");
    for file in std::env::args().skip(1) {
        let surface = Surface::read(&file)?;
        let mut evaluator = surface.evaluator();
        let axes = surface.axes();
        let points: Vec<Vec<f64>> =
            (0..POINTS).map(|n| axes.iter().zip(0..).map(|(it, k)| place(it, n, k)).collect()).collect();
        let values = nanoseconds(|| {
            for point in &points {
                black_box(evaluator.values(point).expect("it is inside"));
            }
        });
        let derivatives = nanoseconds(|| {
            for point in &points {
                black_box(evaluator.derivatives(point).expect("it is inside"));
            }
        });
        let places: Vec<f64> = (0..ALONG).map(|n| place(&axes[0], n, 0)).collect();
        let along = nanoseconds(|| {
            for point in &points[..(POINTS / ALONG) as usize] {
                let mut line = evaluator.line(0, point).expect("it is inside");
                for x in &places {
                    black_box(line.values(*x).expect("it is inside"));
                }
            }
        });
        println!("{values:20.0}   {derivatives:16.0}   {along:11.0}   {file}");
    }
    Ok(())
}

/// Nanoseconds a point: the least of three runs.
fn nanoseconds(mut run: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64() * 1e9 / f64::from(POINTS)
    };
    (0..3).map(time).fold(f64::INFINITY, f64::min)
}

/// The n-th of numbers that fill an axis evenly, or its logarithm where it is positive: multiples of a power of the
/// golden ratio.
fn place(axis: &Axis, n: u32, k: i32) -> f64 {
    let part = (f64::from(n) * 0.618_033_988_749_895_f64.powi(k + 1)).fract();
    let (from, to) = (axis.from.max(1e-6), axis.to.min(1e6));
    match axis.from < 0.0 {
        true => axis.from + part * (axis.to - axis.from),
        false => (from * (to / from).powf(part)).clamp(axis.from, axis.to),
    }
}
