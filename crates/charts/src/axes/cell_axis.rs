//! The logarithmic axis of a map, cut into cells. 0 and ∞, which have no place on it, are cells of their own, set off
//! at its ends.

use crate::axes::ticks::{self, Tick, Ticks};
use crate::axes::{Axis, number, place};

/// From sorted values to cells, as shares of the axis's length.
#[derive(Clone, Debug)]
pub(crate) struct CellAxis {
    values: Vec<f64>,
    /// Where the cell of each value begins and ends.
    cells: Vec<(f64, f64)>,
    /// Where the cells hang together: 0, the values between, ∞.
    blocks: Vec<(f64, f64)>,
    /// The block of the values between, and its ends as decimal logarithms, or as `narrow` says.
    finite: Option<((f64, f64), (f64, f64))>,
    /// The first and the last of the values between, where logarithms tell too little: they count as 0 and 1.
    narrow: Option<(f64, f64)>,
}

/// Up to this many values are labelled one by one.
const FEW: usize = 5;

impl CellAxis {
    /// The axis of strictly increasing values, 0 and ∞ allowed.
    pub(crate) fn new(values: &[f64]) -> Self {
        let between: Vec<f64> = values.iter().copied().filter(|value| !is_special(*value)).collect();
        let narrow = match between[..] {
            [first, .., last] if place::is_narrow(first.log10(), last.log10()) => Some((first, last)),
            _ => None,
        };
        let borders = borders(&between.iter().map(|value| counted(*value, narrow)).collect::<Vec<_>>());
        let count = between.len();
        // The length of the values between is 1 for now.
        let special = if count == 0 { 1.0 } else { (1.0 / count as f64).clamp(0.07, 0.16) };
        const GAP: f64 = 0.03;
        let mut axis = CellAxis { values: values.to_vec(), cells: vec![], blocks: vec![], finite: None, narrow };
        let mut end = 0.0;
        let begin = |end: f64| if end > 0.0 { end + GAP } else { 0.0 };
        for (i, value) in values.iter().enumerate() {
            if is_special(*value) {
                let cell = (begin(end), begin(end) + special);
                axis.cells.push(cell);
                axis.blocks.push(cell);
                end = cell.1;
                continue;
            }
            let (low, high) = (borders[0], borders[borders.len() - 1]);
            let ((start, _), _) = *axis.finite.get_or_insert_with(|| ((begin(end), begin(end) + 1.0), (low, high)));
            let k = i - usize::from(values[0] == 0.0);
            let share = |border: f64| start + (border - low) / (high - low);
            axis.cells.push((share(borders[k]), share(borders[k + 1])));
            if k == 0 {
                axis.blocks.push((start, start + 1.0));
            }
            end = start + 1.0;
        }
        let scaled = |(from, to): (f64, f64)| (from / end, to / end);
        axis.cells.iter_mut().chain(&mut axis.blocks).for_each(|span| *span = scaled(*span));
        axis.finite = axis.finite.map(|(span, logarithms)| (scaled(span), logarithms));
        axis
    }

    /// Where the cell of value `i` begins and ends.
    pub(crate) fn cell(&self, i: usize) -> (f64, f64) {
        self.cells[i]
    }

    /// The spans of cells that hang together.
    pub(crate) fn blocks(&self) -> &[(f64, f64)] {
        &self.blocks
    }
}

impl Axis for CellAxis {
    /// The place of a value: the middle of its cell for 0 and ∞.
    fn share(&self, value: f64) -> f64 {
        if let Some(i) = self.values.iter().position(|other| is_special(value) && *other == value) {
            return 0.5 * (self.cells[i].0 + self.cells[i].1);
        }
        let ((from, to), (low, high)) = self.finite.expect("only an axis with finite values is asked for one");
        from + (to - from) * (counted(value, self.narrow) - low) / (high - low)
    }

    /// The ticks of an axis of `length` pixels, whose labels (of font size `em`) lie along it or, `upright`, across it.
    fn ticks(&self, length: f64, em: f64, upright: bool) -> Ticks {
        let extent = ticks::extent(|value| self.share(value), length, em, upright);
        let special = self
            .values
            .iter()
            .filter(|value| is_special(**value))
            .map(|value| Tick { value: *value, label: if *value == 0.0 { "0" } else { "∞" }.to_string() });
        let special: Vec<Tick> = special.collect();
        let with_special = |mut ticks: Ticks| {
            ticks.major.extend(special.iter().cloned());
            ticks
        };
        let gap = if upright { 0.1 * em } else { 0.5 * em };
        let between: Vec<f64> = self.values.iter().copied().filter(|value| !is_special(*value)).collect();
        let Some((_, (low, high))) = self.finite else { return with_special(Ticks::default()) };
        if between.len() <= FEW {
            let labels = between.iter().zip(number::short(&between));
            let major = labels.map(|(value, label)| Tick { value: *value, label }).collect();
            let one_by_one = with_special(Ticks { major, minor: vec![] });
            let told_apart = one_by_one.major.windows(2).all(|pair| pair[0].label != pair[1].label);
            if told_apart && ticks::fits(&one_by_one, &extent, gap) {
                return one_by_one;
            }
        }
        let (least, largest) = self.narrow.unwrap_or_else(|| place::numbers_between(low, high));
        let decades = |most| with_special(ticks::logarithmic(least, largest, most));
        let fitting = ticks::fitting(decades, &extent, gap);
        if ticks::fits(&fitting, &extent, gap) {
            return fitting;
        }
        // Too short for two labels: one, of the value nearest to the middle that leaves room for 0 and ∞.
        let mut candidates: Vec<f64> = between.clone();
        let off_middle = |value: f64| (self.share(value) - 0.5).abs();
        candidates.sort_by(|one, other| off_middle(*one).total_cmp(&off_middle(*other)));
        let single = |value: f64| {
            let label = number::short(&[value]).remove(0);
            with_special(Ticks { major: vec![Tick { value, label }], minor: vec![] })
        };
        let found = candidates.into_iter().map(single).find(|ticks| ticks::fits(ticks, &extent, gap));
        found.unwrap_or_else(|| with_special(Ticks::default()))
    }
}

fn is_special(value: f64) -> bool {
    value == 0.0 || value == f64::INFINITY
}

/// A value as the axis counts: its decimal logarithm, or a share of a narrow axis.
fn counted(value: f64, narrow: Option<(f64, f64)>) -> f64 {
    narrow.map_or_else(|| value.log10(), |(first, last)| place::linear(value, first, last))
}

/// The borders of the cells of values, both as the axis counts: midway between neighbours, and as far beyond the first
/// and last value as before it. One value alone has half a decade on each side.
fn borders(logarithms: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (logarithms.first(), logarithms.last()) else { return vec![] };
    let mut borders: Vec<f64> = logarithms.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    let before = borders.first().map_or(first - 0.5, |border| 2.0 * first - border);
    let after = borders.last().map_or(last + 0.5, |border| 2.0 * last - border);
    borders.insert(0, before);
    borders.push(after);
    borders
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::{any_positive, increasing};

    laws! {
        seed: 2, cases: 256;

        fn cells_follow_one_another_and_hold_their_values(
            logarithms in prop::collection::btree_set(-60..60i32, 0..12), zero: bool, infinity: bool,
        ) {
            let mut values: Vec<f64> = zero.then_some(0.0).into_iter().collect();
            values.extend(logarithms.into_iter().map(|tenths| 10f64.powf(0.2 * f64::from(tenths))));
            values.extend(infinity.then_some(f64::INFINITY));
            prop_assume!(!values.is_empty());
            let axis = CellAxis::new(&values);
            let mut end = 0.0;
            for (i, value) in values.iter().enumerate() {
                let (from, to) = axis.cell(i);
                prop_assert!(end <= from + 1e-12 && from < to && to <= 1.0 + 1e-12);
                prop_assert!(from < axis.share(*value) && axis.share(*value) < to);
                prop_assert!(axis.blocks().iter().any(|b| b.0 <= from + 1e-12 && to <= b.1 + 1e-12));
                // Beside 0 and ∞ there is a gap; elsewhere cells touch.
                if i > 0 {
                    let set_off = is_special(*value) || is_special(values[i - 1]);
                    prop_assert_eq!(from - end > 1e-3, set_off);
                }
                end = to;
            }
            prop_assert!((end - 1.0).abs() < 1e-9);
            let ticks = axis.ticks(1000.0, 40.0, false);
            prop_assert_eq!(ticks.major.iter().any(|tick| tick.label == "0"), zero);
            prop_assert_eq!(ticks.major.iter().any(|tick| tick.label == "∞"), infinity);
        }

        fn any_values_have_cells_side_by_side(values in increasing(any_positive(), 1..9), length in 20.0..1500.0f64) {
            let axis = CellAxis::new(&values);
            let shares: Vec<f64> = values.iter().map(|value| axis.share(*value)).collect();
            for (i, share) in shares.iter().enumerate() {
                let (from, to) = axis.cell(i);
                prop_assert!(-1e-9 <= from && from <= *share && *share <= to && to <= 1.0 + 1e-9, "{axis:?}");
                prop_assert!(i == 0 || axis.cell(i - 1).1 == from, "{axis:?}");
            }
            let inside = |tick: &Tick| (-1e-6..=1.0 + 1e-6).contains(&axis.share(tick.value));
            let ticks = axis.ticks(length, 40.0, false);
            prop_assert!(ticks.major.iter().all(inside), "{ticks:?}");
        }
    }

    #[test]
    fn borders_lie_midway_in_the_logarithm() {
        let axis = CellAxis::new(&[1.0, 100.0, 10000.0]);
        assert!((axis.share(10.0) - axis.cell(0).1).abs() < 1e-12);
        assert!((axis.cell(1).1 - axis.cell(1).0 - 1.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn few_values_are_labelled_one_by_one() {
        let labels: Vec<String> = CellAxis::new(&[1e-3, 1.0, 30.0, 1e5])
            .ticks(2000.0, 40.0, false)
            .major
            .into_iter()
            .map(|t| t.label)
            .collect();
        assert_eq!(labels, ["10⁻³", "10⁰", "3·10¹", "10⁵"]);
    }
}
