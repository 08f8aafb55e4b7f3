//! From a value to a colour, and the bar that shows how.

use crate::axes::place;
use crate::axes::ticks::{self, Ticks};
use crate::paint::font;
use crate::paint::palette::{self, FRAME, Ink, TEXT};
use crate::paint::scene;
use crate::paint::scene::{Area, Point, Scene, Shape};

/// A scale of colours from `low` to `high`. Values beyond have the colour of the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ColourRange {
    low: f64,
    high: f64,
    logarithmic: bool,
    /// Some value lies below `low` (above `high`): the bar ends in a point there.
    below: bool,
    above: bool,
    /// About how many bands the colours come in; none if they change smoothly.
    bands: Option<usize>,
}

impl ColourRange {
    /// The scale of these values: from the smallest to the largest unless `wanted` (low < high) says otherwise; zeros
    /// have no place on a logarithmic one. None if there is neither a value nor a range wanted.
    pub(crate) fn of(values: &[f64], logarithmic: bool, wanted: Option<(f64, f64)>) -> Option<Self> {
        let shown = values.iter().copied().filter(|value| !logarithmic || *value > 0.0);
        let (least, most) = shown.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = match wanted {
            Some(range) => range,
            None if least > most => return None,
            // A colour needs a range around it, at least a part in a thousand.
            None if logarithmic && most / least < 1.001 => (least / 10f64.sqrt(), most * 10f64.sqrt()),
            None if !logarithmic && most - least <= 1e-3 * least.abs().max(most.abs()) => {
                let room = 0.5 * least.abs().max(most.abs()).max(f64::MIN_POSITIVE.sqrt());
                (least - room, most + room)
            }
            None => (least, most),
        };
        let (low, high) = if wanted.is_none() { place::ends((low, high), logarithmic) } else { (low, high) };
        Some(ColourRange { low, high, logarithmic, below: least < low, above: most > high, bands: None })
    }

    /// The same scale in about this many bands, whose boundaries are round values. The eye parts no more than a
    /// hundred.
    pub(crate) fn in_bands(self, count: usize) -> Self {
        ColourRange { bands: Some(count.min(100)), ..self }
    }

    /// The values that part the bands, between the ends of the scale; none if colours change smoothly.
    pub(crate) fn boundaries(&self) -> Vec<f64> {
        let values = self.bands.map(|count| self.round(count + 1).major).unwrap_or_default();
        values.into_iter().map(|tick| tick.value).filter(|value| self.low < *value && *value < self.high).collect()
    }

    /// The colour of each band, that of its middle.
    pub(crate) fn band_inks(&self) -> Vec<Ink> {
        let shares = self.band_ends();
        shares.windows(2).map(|pair| palette::viridis(0.5 * (pair[0] + pair[1]))).collect()
    }

    /// The ends of all bands as shares of the scale.
    fn band_ends(&self) -> Vec<f64> {
        let inner = self.boundaries().into_iter().map(|value| self.share(value));
        [0.0].into_iter().chain(inner).chain([1.0]).collect()
    }

    /// At most `most` round values with labels.
    fn round(&self, most: usize) -> Ticks {
        if self.logarithmic {
            ticks::logarithmic(self.low, self.high, most)
        } else {
            ticks::linear(self.low, self.high, most)
        }
    }

    /// 0 at the lower end, 1 at the upper; beyond for values beyond.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let share = if self.logarithmic { place::logarithmic } else { place::linear };
        share(value, self.low, self.high)
    }

    /// The colour of a value.
    pub(crate) fn ink(&self, value: f64) -> Ink {
        palette::viridis(self.share(value))
    }

    /// Ticks of a bar of this length.
    pub(crate) fn ticks(&self, length: f64, em: f64) -> Ticks {
        let candidates = |most| match self.bands {
            None => self.round(most),
            // Labels stand at boundaries.
            Some(count) => ticks::thinned_evenly(self.round(count + 1), most),
        };
        ticks::fitting_or_fewer(candidates, ticks::extent(|value| self.share(value), length, em, true), 0.4 * em)
    }

    /// Lines across a bar that is drawn there, at these values.
    pub(crate) fn across(&self, (left, top): Point, length: f64, em: f64, values: &[f64]) -> Vec<Vec<Point>> {
        let y = |value: f64| top + length * (1.0 - self.share(value));
        values.iter().map(|value| vec![(left, y(*value)), (left + BAR * em, y(*value))]).collect()
    }

    /// How wide the bar is with its ticks and its label.
    pub(crate) fn width(&self, length: f64, em: f64, label: &str) -> f64 {
        let widest = self.ticks(length, em).widest(em);
        BAR * em + 0.5 * em + widest + 0.3 * em + scene::thickness(label, em, length)
    }

    /// Draws the bar of this length from its upper left corner downwards.
    pub(crate) fn draw(&self, scene: &mut Scene, (left, top): Point, length: f64, em: f64, label: &str) {
        let bar = Area { left, top, right: left + BAR * em, bottom: top + length };
        const STEPS: usize = 128;
        let (ends, inks) = match self.bands {
            Some(_) => (self.band_ends(), self.band_inks()),
            None => {
                let end = |step: usize| step as f64 / STEPS as f64;
                let ink = |step: usize| palette::viridis((step as f64 + 0.5) / STEPS as f64);
                ((0..=STEPS).map(end).collect(), (0..STEPS).map(ink).collect())
            }
        };
        for (pair, ink) in ends.windows(2).zip(inks) {
            let height = |share: f64| bar.bottom - length * share;
            scene.rectangle(Area { top: height(pair[1]), bottom: height(pair[0]), ..bar }, ink);
        }
        for (beyond, edge, tip, end) in
            [(self.below, bar.bottom, bar.bottom + 0.7 * em, 0.0), (self.above, bar.top, bar.top - 0.7 * em, 1.0)]
        {
            if beyond {
                let corners = vec![(bar.left, edge), (bar.right, edge), (bar.centre().0, tip)];
                let mut outline = corners.clone();
                outline.push(corners[0]);
                scene.shapes.push(Shape::Polygon { corners, ink: palette::viridis(end) });
                scene.path(outline, 2.0, FRAME);
            }
        }
        scene.frame(bar, 2.0, FRAME);
        let ticks = self.ticks(length, em);
        let y = |value: f64| bar.bottom - length * self.share(value);
        for value in &ticks.minor {
            scene.line((bar.right, y(*value)), (bar.right + 0.12 * em, y(*value)), 2.0, FRAME);
        }
        let mut right = bar.right;
        for tick in &ticks.major {
            let at = y(tick.value);
            scene.line((bar.right, at), (bar.right + 0.25 * em, at), 2.0, FRAME);
            let start = (bar.right + 0.5 * em, at + 0.36 * em);
            scene.text(start, scene::Anchor::Start, em, TEXT, tick.label.as_str());
            right = right.max(start.0 + font::width(&tick.label, em));
        }
        scene.upright((right + 0.3 * em, bar.centre().1), em, TEXT, length, label);
    }
}

/// Width of the bar over the font's size.
const BAR: f64 = 0.9;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::{any_number, any_positive, range_of};

    fn check_bands(range: &ColourRange) {
        let ends = range.band_ends();
        assert!(ends.windows(2).all(|pair| pair[0] <= pair[1]), "{range:?}: {ends:?}");
        assert_eq!(range.band_inks().len(), range.boundaries().len() + 1);
        assert!(!range.ticks(900.0, 40.0).major.is_empty());
    }

    laws! {
        seed: 3, cases: 256;

        fn places_on_the_bar_grow_with_the_value(
            mut values in prop::collection::vec(1e-12..1e3f64, 1..20), logarithmic: bool,
        ) {
            values.sort_by(f64::total_cmp);
            let range = ColourRange::of(&values, logarithmic, None).unwrap();
            let shares: Vec<f64> = values.iter().map(|value| range.share(*value)).collect();
            prop_assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]));
            prop_assert!(shares.iter().all(|share| (-1e-9..=1.0 + 1e-9).contains(share)));
            prop_assert!(!range.below && !range.above);
        }

        fn any_numbers_have_a_scale(
            mut values in prop::collection::vec(any_number(), 1..9), logarithmic: bool, bands in 1usize..101,
        ) {
            if logarithmic {
                values.iter_mut().for_each(|value| *value = value.abs().max(5e-324));
            }
            let range = ColourRange::of(&values, logarithmic, None).unwrap().in_bands(bands);
            prop_assert!(values.iter().all(|value| (-1e-9..=1.0 + 1e-9).contains(&range.share(*value))), "{range:?}");
            check_bands(&range);
        }

        fn any_range_has_bands(linear in range_of(any_number()), logarithmic in range_of(any_positive())) {
            check_bands(&ColourRange::of(&[], false, Some(linear)).unwrap().in_bands(usize::MAX));
            check_bands(&ColourRange::of(&[], true, Some(logarithmic)).unwrap().in_bands(usize::MAX));
        }
    }

    #[test]
    fn values_beyond_a_range_have_the_colour_of_its_end() {
        let range = ColourRange::of(&[1e-9, 1e-3], true, Some((1e-6, 1e-2))).unwrap();
        assert_eq!(range.ink(1e-9), palette::viridis(0.0));
        assert!(range.below && !range.above);
        assert_eq!(ColourRange::of(&[0.0], true, None), None);
        for value in [0.0, -2.0, 1e-300] {
            let range = ColourRange::of(&[value, value], false, None).unwrap();
            assert!((range.share(value) - 0.5).abs() < 1e-9);
            range.ticks(500.0, 40.0);
        }
    }
}
