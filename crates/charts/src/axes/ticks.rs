//! Where an axis is labelled.

use crate::axes::number::{self, Notation, decade, power_of_ten};
use crate::axes::place;
use crate::paint::font;

/// A place on an axis with its label.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    pub(crate) label: String,
}

/// Labelled ticks, and those between them without label.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) major: Vec<Tick>,
    pub(crate) minor: Vec<f64>,
}

impl Ticks {
    /// Width of the widest label in pixels, for a font of `em` pixels.
    pub(crate) fn widest(&self, em: f64) -> f64 {
        self.major.iter().map(|tick| font::width(&tick.label, em)).fold(0.0, f64::max)
    }
}

/// The two ends of the label of a tick, in pixels along an axis of this length on which values have
/// these shares: the label (of font size `em`) lies along the
/// axis or, `upright`, across it.
pub(crate) fn extent(share: impl Fn(f64) -> f64, length: f64, em: f64, upright: bool) -> impl Fn(&Tick) -> (f64, f64) {
    move |tick| {
        let half = if upright { 0.6 * em } else { 0.5 * font::width(&tick.label, em) };
        let middle = length * share(tick.value);
        (middle - half, middle + half)
    }
}

/// Ticks of a logarithmic axis from `low` to `high`, 0 < low < high: whole decades, every second, fifth, … if there are
/// more than `most` (≥ 2); 1, 2 and 5 of each decade where there are less than three decades; even steps within one.
pub(crate) fn logarithmic(low: f64, high: f64, most: usize) -> Ticks {
    let inside = |value: &f64| (low..=high).contains(value);
    let first = number::exponent(low);
    let decades: Vec<i32> = (first..=number::exponent(high)).filter(|e| inside(&power_of_ten(*e))).collect();
    if decades.len() >= 3 {
        let kept = thinned(&decades, most);
        // More marks than this are a bar.
        const MOST_MINOR: usize = 100;
        let minor = if decades.len() > MOST_MINOR {
            vec![]
        } else if kept.len() == decades.len() {
            if decades.len() <= 7 { multiples(low, high, &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]) } else { vec![] }
        } else {
            decades.iter().filter(|e| !kept.contains(e)).map(|e| power_of_ten(*e)).collect()
        };
        let major = kept.into_iter().map(|e| Tick { value: power_of_ten(e), label: decade(e) }).collect();
        return Ticks { major, minor };
    }
    for digits in [&[1.0, 2.0, 5.0][..], &[1.0, 3.0][..], &[1.0][..]] {
        let values = multiples(low, high, digits);
        if (2..=most).contains(&values.len()) {
            let plain = values.iter().all(|value| (1e-3..2e4).contains(value));
            let label = |value: f64| {
                let power = number::exponent(value);
                let notation = if plain { Notation::Plain } else { Notation::Scientific };
                number::stepped(value, power, notation)
            };
            let minor = multiples(low, high, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
            return Ticks {
                minor: minor.into_iter().filter(|value| !values.contains(value)).collect(),
                major: values.into_iter().map(|value| Tick { value, label: label(value) }).collect(),
            };
        }
    }
    linear(low, high, most)
}

/// Ticks of a linear axis from `low` < `high`: multiples of 1, 2 or 5 times a power of ten, 2 to `most` of them. The
/// ends themselves where too few numbers lie between for that.
pub(crate) fn linear(low: f64, high: f64, most: usize) -> Ticks {
    /// Down to steps a thousand times smaller than the range; there are never that many ticks.
    const FINEST: i32 = 4;
    /// Integers beyond this have gaps.
    const MOST_COUNTED: f64 = 9e15;
    let shift = shift(low, high);
    let (from, to) = (shifted(low, shift), shifted(high, shift));
    let coarsest = number::exponent(to - from) + 1;
    let mut found: Option<Ticks> = None;
    // From coarse to fine, until the next finer step has too many.
    for power in (coarsest - FINEST..=coarsest).rev() {
        for digit in [5.0, 2.0, 1.0] {
            let step = digit * power_of_ten(power);
            let (first, last) = ((from / step).ceil(), (to / step).floor());
            let count = last - first + 1.0;
            if count > most as f64
                && let Some(ticks) = found
            {
                return ticks;
            }
            let all = || (0..count as usize).map(|i| first + i as f64).collect();
            let counts: Vec<f64> = if count > most as f64 { vec![first, last] } else { all() };
            let values: Vec<f64> = counts.into_iter().map(|count| multiple(count * digit, power - shift)).collect();
            let are_counted = digit * first.abs().max(last.abs()) < MOST_COUNTED;
            if values.len() >= 2 && are_counted && are_ticks(&values, low, high) {
                found = Some(labelled(&values, power - shift));
            }
        }
    }
    found.unwrap_or_else(|| {
        let end = |value: f64| Tick { value, label: number::exact(value) };
        Ticks { major: vec![end(low), end(high)], minor: vec![] }
    })
}

/// By which power of ten numbers of this range are multiplied, so that neither their differences nor steps between them
/// are beyond what a double holds.
fn shift(low: f64, high: f64) -> i32 {
    match low.abs().max(high.abs()) {
        1e300.. => -100,
        _ if high - low < 1e-280 => 300,
        _ => 0,
    }
}

fn shifted(value: f64, shift: i32) -> f64 {
    if shift == 0 { value } else { value * power_of_ten(shift) }
}

/// Whether values are different numbers inside a range, but for rounding.
fn are_ticks(values: &[f64], low: f64, high: f64) -> bool {
    const ROUNDING: f64 = 1e-6;
    let inside = |value: &f64| (-ROUNDING..=1.0 + ROUNDING).contains(&place::linear(*value, low, high));
    values.iter().all(inside) && values.windows(2).all(|pair| pair[0] < pair[1])
}

/// Whether labels leave room for each other: `extent` gives the two ends of a label in pixels along the axis, `gap` is
/// the room wanted between two.
pub(crate) fn fits(ticks: &Ticks, extent: impl Fn(&Tick) -> (f64, f64), gap: f64) -> bool {
    let mut ends: Vec<(f64, f64)> = ticks.major.iter().map(extent).collect();
    ends.sort_by(|one, other| one.0.total_cmp(&other.0));
    ends.windows(2).all(|pair| pair[0].1 + gap <= pair[1].0)
}

/// The most ticks, nine at most, whose labels leave room for each other.
pub(crate) fn fitting(ticks: impl Fn(usize) -> Ticks, extent: impl Fn(&Tick) -> (f64, f64), gap: f64) -> Ticks {
    (3..=9).rev().map(&ticks).find(|ticks| fits(ticks, &extent, gap)).unwrap_or_else(|| ticks(2))
}

/// The same; where even two leave no room for each other those that come last keep their labels, and the others lose
/// them.
pub(crate) fn fitting_or_fewer(
    ticks: impl Fn(usize) -> Ticks,
    extent: impl Fn(&Tick) -> (f64, f64),
    gap: f64,
) -> Ticks {
    let found = fitting(ticks, &extent, gap);
    let mut kept = Ticks { major: Vec::new(), minor: found.minor };
    for tick in found.major.into_iter().rev() {
        let (from, to) = extent(&tick);
        if kept.major.iter().map(&extent).all(|other| other.1 + gap <= from || to + gap <= other.0) {
            kept.major.insert(0, tick);
        } else {
            kept.minor.push(tick.value);
        }
    }
    kept
}

/// The same ticks with at most `most` labels, every second, fifth, … one.
pub(crate) fn thinned_evenly(ticks: Ticks, most: usize) -> Ticks {
    let step = [1, 2, 5, 10, 20, 50, 100].into_iter().find(|step| ticks.major.len().div_ceil(*step) <= most);
    let step = step.unwrap_or(ticks.major.len());
    // A zero keeps its label.
    let first = ticks.major.iter().position(|tick| tick.value == 0.0).unwrap_or(0) % step;
    let mut thinned = Ticks { major: vec![], minor: ticks.minor };
    for (i, tick) in ticks.major.into_iter().enumerate() {
        if i % step == first {
            thinned.major.push(tick);
        } else {
            thinned.minor.push(tick.value);
        }
    }
    thinned
}

/// `count` times ten to the power, rounded once.
fn multiple(count: f64, power: i32) -> f64 {
    format!("{count}e{power}").parse().expect("a number and an exponent")
}

/// Ticks with labels whose last digit counts ten to the power `last`.
fn labelled(values: &[f64], last: i32) -> Ticks {
    let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let notation = Notation::of(largest, last);
    let tick = |value: &f64| Tick { value: *value, label: number::stepped(*value, last, notation) };
    Ticks { major: values.iter().map(tick).collect(), minor: vec![] }
}

/// The digits times every power of ten, between low and high.
fn multiples(low: f64, high: f64, digits: &[f64]) -> Vec<f64> {
    let mut values: Vec<f64> = (number::exponent(low)..=number::exponent(high))
        .flat_map(|e| digits.iter().map(move |digit| multiple(*digit, e)))
        .filter(|value| (low..=high).contains(value))
        .collect();
    // The smallest numbers have few neighbours.
    values.dedup();
    values
}

/// Multiples of the smallest round step that leaves at most `most` of the decades; the two ends if none leaves two.
fn thinned(decades: &[i32], most: usize) -> Vec<i32> {
    for step in [1, 2, 3, 4, 5, 10, 20, 50, 100, 200] {
        let kept: Vec<i32> = decades.iter().copied().filter(|e| e % step == 0).collect();
        if (2..=most).contains(&kept.len()) {
            return kept;
        }
    }
    vec![decades[0], decades[decades.len() - 1]]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::{any_number, any_positive, range_of};

    fn check(ticks: &Ticks, low: f64, high: f64, most: usize) {
        let values: Vec<f64> = ticks.major.iter().map(|tick| tick.value).collect();
        assert!((2..=most).contains(&values.len()), "{low} to {high}: {ticks:?}");
        assert!(values.windows(2).all(|pair| pair[0] < pair[1]), "{low} to {high}: {ticks:?}");
        // Rounding of an even step may put the last tick beyond the end by a part of a pixel.
        let inside = |value: &f64| (-1e-6..=1.0 + 1e-6).contains(&place::linear(*value, low, high));
        assert!(values.iter().chain(&ticks.minor).all(inside), "{low} to {high}: {ticks:?}");
        let mut labels: Vec<&str> = ticks.major.iter().map(|tick| tick.label.as_str()).collect();
        labels.sort_unstable();
        labels.dedup();
        assert_eq!(labels.len(), values.len(), "two ticks with one label: {ticks:?}");
        for tick in &ticks.major {
            assert!(tick.label.chars().count() <= 26, "{tick:?} is long");
            // What the label says is the value, to the last bit.
            assert_eq!(read(&tick.label), tick.value, "{low} to {high}: {tick:?}");
        }
    }

    /// The number that a label reads.
    fn read(label: &str) -> f64 {
        let digits: String = label
            .chars()
            .map(|c| match c {
                '−' | '⁻' => '-',
                '⁰' => '0',
                '¹' => '1',
                '²' => '2',
                '³' => '3',
                '⁴'..='⁹' => char::from_digit(c as u32 - '⁴' as u32 + 4, 10).unwrap(),
                c => c,
            })
            .collect();
        let raised = label.chars().any(|c| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c));
        let text = match digits.split_once("·10") {
            Some((mantissa, power)) => format!("{mantissa}e{power}"),
            None if raised => format!("1e{}", digits.strip_prefix("10").unwrap()),
            None => digits,
        };
        text.parse().unwrap_or_else(|_| panic!("{label} is not a number"))
    }

    laws! {
        seed: 1, cases: 256;

        fn any_logarithmic_range_has_a_few_ticks_inside(
            start in -30.0..20.0f64, decades in prop_oneof![1e-4..1.0f64, 1.0..40.0f64], most in 3usize..10,
        ) {
            let (low, high) = (10f64.powf(start), 10f64.powf(start + decades));
            check(&logarithmic(low, high, most), low, high, most);
        }

        fn any_linear_range_has_a_few_ticks_inside(low in -1e3..1e3f64, power in -6.0..6.0f64, most in 3usize..10) {
            let high = low + 10f64.powf(power);
            check(&linear(low, high, most), low, high, most);
        }

        fn so_have_ranges_of_the_largest_and_the_smallest_numbers(
            (low, high) in range_of(any_number()), most in 2usize..101,
        ) {
            check(&linear(low, high, most), low, high, most);
        }

        fn so_have_logarithmic_ranges_of_them((low, high) in range_of(any_positive()), most in 2usize..101) {
            check(&logarithmic(low, high, most), low, high, most);
        }
    }

    #[test]
    fn whole_decades_are_labelled_as_powers_of_ten() {
        let labels =
            |low, high| -> Vec<String> { logarithmic(low, high, 9).major.into_iter().map(|tick| tick.label).collect() };
        assert_eq!(labels(1e-3, 1.0), ["10⁻³", "10⁻²", "10⁻¹", "10⁰"]);
        assert_eq!(labels(0.9, 60.0), ["1", "2", "5", "10", "20", "50"]);
        assert_eq!(labels(1e-20, 1e20), ["10⁻²⁰", "10⁻¹⁵", "10⁻¹⁰", "10⁻⁵", "10⁰", "10⁵", "10¹⁰", "10¹⁵", "10²⁰"]);
    }
}
