//! What pictures are wanted.

use super::sweep_data::SweepData;
use super::{Axis, PictureError};
use stribeck_solver::shortest;

/// A kind of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Kind {
    /// A quantity as height over α and β.
    Surfaces,
    /// A quantity as colour over α and β, with lines of equal value.
    Maps,
    /// A quantity along an axis, one curve for each value of another.
    Curves,
    /// Pressure, film and displacement of chosen cases.
    Profiles,
    /// Pressure against height of a point of the surface that passes under the cylinder.
    Loops,
    /// Normal stress below the deformed surface.
    Stress,
    /// Estimated errors over α and β, or along an axis.
    Errors,
    /// Which cases converged, over α and β.
    Status,
    /// Estimated error against seconds of each case.
    Cost,
}

impl Kind {
    /// Name in options.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Surfaces => "surfaces",
            Kind::Maps => "maps",
            Kind::Curves => "curves",
            Kind::Profiles => "profiles",
            Kind::Loops => "loops",
            Kind::Stress => "stress",
            Kind::Errors => "errors",
            Kind::Status => "status",
            Kind::Cost => "cost",
        }
    }

    /// An error that says why there is no picture of this kind.
    pub fn missing(self, why: impl Into<String>) -> PictureError {
        PictureError::Missing { kind: self.name(), why: why.into() }
    }
}

/// Whether the axis of a quantity is logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum AxisScale {
    /// Logarithmic if the values are positive and span more than a factor of 30.
    #[default]
    Auto,
    /// Equal differences are equal lengths.
    Linear,
    /// Equal ratios are equal lengths.
    Log,
}

impl AxisScale {
    /// The choice for these values.
    pub fn is_logarithmic(self, values: impl Iterator<Item = f64>) -> bool {
        match self {
            AxisScale::Linear => false,
            AxisScale::Log => true,
            AxisScale::Auto => {
                let (least, most) = values
                    .filter(|value| value.is_finite())
                    .fold((f64::INFINITY, 0.0_f64), |(least, most), value| (least.min(value), most.max(value)));
                least > 0.0 && most > 30.0 * least
            }
        }
    }
}

/// What is wanted, and of which part of the sweep. The default leaves every choice to the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// The kinds of pictures; all that make sense if empty.
    pub kinds: Vec<Kind>,
    /// Names of columns and fields; a sensible choice if empty.
    pub of: Vec<String>,
    /// Name of the axis of curves; each that has several values if none.
    pub along: Option<String>,
    /// Values wanted of dimensions, by their names; of others a sensible choice.
    pub values: Vec<(String, Vec<f64>)>,
    /// Where profiles and stresses are shown.
    pub x: Option<(f64, f64)>,
    /// Ends of the vertical axis of curves, profiles and loops.
    pub y: Option<(f64, f64)>,
    /// Scale of the quantity.
    pub scale: AxisScale,
    /// All quantities of curves in one picture.
    pub together: bool,
    /// Whether known limits are drawn beside solutions.
    pub bare: bool,
}

impl Request {
    /// The axis of curves, if one is asked for.
    pub(super) fn along(&self, sweep: &SweepData) -> Result<Option<Axis>, PictureError> {
        let Some(name) = &self.along else { return Ok(None) };
        let found = Axis::ALL.into_iter().find(|axis| sweep.axis(*axis).name == *name);
        let axes = Axis::ALL.map(|axis| sweep.axis(axis).name.as_str()).into_iter().filter(|name| !name.is_empty());
        found.map(Some).ok_or_else(|| no_axis(format!("--along {name}"), axes))
    }

    /// True if values of an axis are asked for.
    pub(super) fn asks(&self, sweep: &SweepData, axis: Axis) -> bool {
        let names = sweep.dimension_names(axis);
        self.values.iter().any(|(wanted, _)| names.iter().any(|name| name == wanted))
    }
}

/// What was asked for by the name of an axis that is not there.
fn no_axis<'a>(option: String, there: impl Iterator<Item = &'a str>) -> PictureError {
    PictureError::NoAxis { option, there: there.collect::<Vec<_>>().join(", ") }
}

/// The option that asks for values of an axis.
fn option(axis: &str, value: &str) -> String {
    match axis {
        "f" | "alpha" | "beta" => format!("--{axis} {value}"),
        _ => format!("--at {axis}={value}"),
    }
}

/// Indices chosen on the three axes, ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    indices: [Vec<usize>; 3],
    asked: [bool; 3],
}

impl Selection {
    /// The values asked for, the nearest ones there are; all of an axis if none is asked for.
    ///
    /// # Errors
    /// [`PictureError::Outside`] for a value beyond the ends of its axis, [`PictureError::NoAxis`] for an axis that is
    /// not there.
    pub fn of(sweep: &SweepData, request: &Request) -> Result<Self, PictureError> {
        let dimensions = &sweep.data.dimensions;
        let known = |name: &String| dimensions.iter().any(|dimension| dimension.name == *name);
        if let Some((name, _)) = request.values.iter().find(|(name, _)| !known(name)) {
            return Err(no_axis(option(name, "…"), dimensions.iter().map(|dimension| dimension.name.as_str())));
        }
        let mut chosen = Vec::new();
        for dimension in dimensions {
            let own = request.values.iter().filter(|(name, _)| *name == dimension.name);
            let wanted: Vec<f64> = own.flat_map(|(_, wanted)| wanted.iter().copied()).collect();
            let nearest = |value: &f64| nearest(&dimension.name, &dimension.values, *value);
            let mut indices = match wanted.is_empty() {
                true => (0..dimension.values.len()).collect(),
                false => wanted.iter().map(nearest).collect::<Result<Vec<usize>, _>>()?,
            };
            indices.sort_unstable();
            indices.dedup();
            chosen.push(indices);
        }
        let inner = chosen.pop().expect("there are two dimensions");
        let lengths: Vec<usize> = dimensions.iter().map(|dimension| dimension.values.len()).collect();
        let outer = sweep.data.outer();
        let blocks = together(&chosen[..outer], &lengths);
        let middle = together(&chosen[outer..], &lengths[outer..]);
        Ok(Self { indices: [blocks, middle, inner], asked: Axis::ALL.map(|axis| request.asks(sweep, axis)) })
    }

    /// True if values of the axis were asked for.
    pub fn is_asked(&self, axis: Axis) -> bool {
        self.asked[axis.dimension()]
    }

    /// The indices of an axis.
    pub fn on(&self, axis: Axis) -> &[usize] {
        &self.indices[axis.dimension()]
    }
}

/// Indices chosen on several dimensions as those of one, the last dimension fastest.
fn together(chosen: &[Vec<usize>], lengths: &[usize]) -> Vec<usize> {
    let mut together = vec![0];
    for (indices, length) in chosen.iter().zip(lengths) {
        together = together.iter().flat_map(|begun| indices.iter().map(move |index| begun * length + index)).collect();
    }
    together
}

/// Index of the value nearest to the one wanted, by ratio where that makes sense.
///
/// # Errors
/// [`PictureError::Outside`] for a value beyond the ends of the axis.
pub fn nearest(axis: &str, values: &[f64], wanted: f64) -> Result<usize, PictureError> {
    let (first, last) = (values[0], values[values.len() - 1]);
    // What was written with a few digits means the end itself.
    if !(wanted >= first * (1.0 - 1e-3 * first.signum()) && wanted <= last * (1.0 + 1e-3 * last.signum())) {
        let there =
            if values.len() == 1 { shortest(first) } else { format!("from {} to {}", shortest(first), shortest(last)) };
        let (option, axis) = (option(axis, &shortest(wanted)), axis.to_owned());
        return Err(PictureError::Outside { option, axis, there });
    }
    let distance = |value: f64| {
        if value == wanted {
            0.0
        } else if first < 0.0 {
            (value - wanted).abs()
        } else if value > 0.0 && wanted > 0.0 {
            (value / wanted).ln().abs()
        } else {
            f64::MAX
        }
    };
    let by_distance = |one: &usize, other: &usize| distance(values[*one]).total_cmp(&distance(values[*other]));
    Ok((0..values.len()).min_by(by_distance).expect("an axis has a value"))
}

/// At most `most` (≥ 2) of these, evenly spread, with both ends.
pub fn spread(indices: &[usize], most: usize) -> Vec<usize> {
    if indices.len() <= most {
        return indices.to_vec();
    }
    (0..most).map(|i| indices[(i * (indices.len() - 1) + (most - 1) / 2) / (most - 1)]).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn a_spread_keeps_the_ends_and_the_order(count in 1usize..200, most in 2usize..9) {
            let indices: Vec<usize> = (0..count).map(|i| 3 * i).collect();
            let kept = spread(&indices, most);
            prop_assert_eq!(kept.len(), count.min(most));
            prop_assert_eq!((kept.first(), kept.last()), (indices.first(), indices.last()));
            prop_assert!(kept.windows(2).all(|pair| pair[0] < pair[1]));
        }

        #[test]
        fn the_nearest_value_is_found(
            values in prop::collection::btree_set(1u32..1000, 1..30), wanted in 1.0..1000.0f64,
        ) {
            let values: Vec<f64> = values.into_iter().map(f64::from).collect();
            let inside = wanted >= 0.999 * values[0] && wanted <= 1.001 * values[values.len() - 1];
            match nearest("beta", &values, wanted) {
                Ok(found) => prop_assert!(
                    inside && values.iter().all(|v| (values[found] / wanted).ln().abs() <= (v / wanted).ln().abs())
                ),
                Err(_) => prop_assert!(!inside),
            }
        }
    }

    #[test]
    fn zero_and_infinity_are_values_of_their_own() {
        let values = [0.0, 0.5, 20.0, f64::INFINITY];
        for (wanted, index) in [(0.0, 0), (0.1, 1), (19.0, 2), (1e6, 2), (f64::INFINITY, 3)] {
            assert_eq!(nearest("alpha", &values, wanted).unwrap(), index, "{wanted}");
        }
        assert!(nearest("alpha", &values, f64::NAN).is_err());
    }

    #[test]
    fn values_on_both_sides_of_zero_are_found_by_their_distance() {
        let ratios = [-1.0, 0.0, 1.0, 2.0];
        for (wanted, index) in [(-1.0, 0), (-0.4, 1), (0.3, 1), (0.6, 2), (2.0, 3)] {
            assert_eq!(nearest("slide_roll_ratio", &ratios, wanted).unwrap(), index, "{wanted}");
        }
        assert!(
            nearest("slide_roll_ratio", &ratios, -1.1).is_err() && nearest("slide_roll_ratio", &ratios, 2.1).is_err()
        );
    }

    #[test]
    fn a_scale_is_logarithmic_where_that_shows_more() {
        let auto = |values: &[f64]| AxisScale::Auto.is_logarithmic(values.iter().copied());
        assert!(auto(&[1e-3, 1.0]) && !auto(&[1.0, 2.0]) && !auto(&[0.0, 1.0]) && !auto(&[f64::NAN]));
    }
}
