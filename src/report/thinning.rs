//! Which places of a large sweep are shown, and which points of a case.

use super::scaled::Scaled;
use crate::pictures::AxisWords;
use stribeck_sweep::store::DataSet;

/// More places of the grid than this make the page slow, and larger than 14 MB.
const MOST_PLACES: usize = 30_000;

/// The indices on the axes f, α and β that are shown, ascending, with both ends of each axis.
pub(super) struct Grid(pub(super) [Vec<usize>; 3]);

impl Grid {
    /// All indices, or of a large grid an even choice: the longest axis is thinned first.
    pub(super) fn of(data: &DataSet) -> Self {
        let shape = data.shape().lengths();
        let mut kept = shape;
        while kept.iter().product::<usize>() > MOST_PLACES {
            let longest = (0..3).max_by_key(|axis| kept[*axis]).expect("there are three axes");
            kept[longest] = (kept[longest] / 2).max(2);
        }
        Self(std::array::from_fn(|axis| evenly(shape[axis], kept[axis])))
    }

    /// Says how many places are left out, if some are.
    pub(super) fn note(&self, data: &DataSet, axes: &[AxisWords; 3]) -> Option<String> {
        let (all, shown) = (data.shape().lengths(), self.0.each_ref().map(Vec::len));
        // An axis without a symbol has one value, and is no axis to the reader.
        let product = |words: [String; 3]| {
            let named = words.into_iter().zip(axes).filter(|(_, axis)| !axis.symbol.is_empty());
            named.map(|(word, _)| word).collect::<Vec<_>>().join(" × ")
        };
        (shown != all).then(|| {
            format!(
                "Of the {} places of the sweep ({}) {} are shown, spread evenly with both ends of each axis.",
                product(all.map(|length| length.to_string())),
                product(axes.each_ref().map(|axis| axis.symbol.clone())),
                product(shown.map(|length| length.to_string()))
            )
        })
    }

    /// The indices of every place shown, in the order of the plan.
    pub(super) fn places(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        let [f, alpha, beta] = &self.0;
        f.iter().flat_map(move |i_f| {
            alpha.iter().flat_map(move |i_alpha| beta.iter().map(move |i_beta| [*i_f, *i_alpha, *i_beta]))
        })
    }
}

/// Chooses `kept` of `count` indices evenly, with both ends.
pub(super) fn evenly(count: usize, kept: usize) -> Vec<usize> {
    if kept >= count {
        return (0..count).collect();
    }
    (0..kept).map(|i| (i * (count - 1) + (kept - 1) / 2) / (kept - 1)).collect()
}

/// Chooses the points of a case that show its shape best: `kept` of them with both ends. Beginning with a line between
/// the ends, it adds the point that is farthest from the lines drawn so far, again and again; distances are over the
/// range of each field.
pub(super) fn shape_points(fields: &[Vec<f64>], x: &[f64], kept: usize) -> Vec<usize> {
    if x.len() <= kept {
        return (0..x.len()).collect();
    }
    let scaled: Vec<Vec<f64>> = fields.iter().map(|field| Scaled::of(field).shares).collect();
    let piece = |from: usize, to: usize| {
        // In the middle if all is straight.
        let (mut farthest, mut distance) = (from.midpoint(to), 0.0);
        for values in &scaled {
            for i in from + 1..to {
                let own = from_line(x, values, (from, to), i);
                if own > distance {
                    (farthest, distance) = (i, own);
                }
            }
        }
        Piece { from, to, farthest, distance }
    };
    let mut pieces = vec![piece(0, x.len() - 1)];
    while pieces.len() + 1 < kept {
        let divisible = (0..pieces.len()).filter(|i| pieces[*i].to - pieces[*i].from > 1);
        let worst = divisible.max_by(|one, other| pieces[*one].distance.total_cmp(&pieces[*other].distance));
        let Piece { from, to, farthest, .. } = pieces.swap_remove(worst.expect("fewer points are kept than there are"));
        pieces.extend([piece(from, farthest), piece(farthest, to)]);
    }
    let mut chosen: Vec<usize> = pieces.iter().map(|piece| piece.from).chain([x.len() - 1]).collect();
    chosen.sort_unstable();
    chosen
}

/// A line between two points of a case, and the point between them that is farthest from it.
struct Piece {
    from: usize,
    to: usize,
    farthest: usize,
    distance: f64,
}

/// Returns how far a point is from the line between two others.
fn from_line(x: &[f64], values: &[f64], (from, to): (usize, usize), i: usize) -> f64 {
    let share = (x[i] - x[from]) / (x[to] - x[from]);
    (values[from] + share * (values[to] - values[from]) - values[i]).abs()
}

/// Returns how far the lines through the chosen points are from the whole field at most, over the range of the field.
pub(super) fn deviation(x: &[f64], field: &[f64], chosen: &[usize]) -> f64 {
    let values = Scaled::of(field).shares;
    let pairs = chosen.windows(2).map(|pair| (pair[0], pair[1]));
    let distances = pairs.flat_map(|(from, to)| {
        let values = &values;
        (from..to).map(move |i| from_line(x, values, (from, to), i))
    });
    distances.fold(0.0, f64::max)
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
        fn the_points_kept_ascend_and_hold_both_ends(
            values in prop::collection::vec(-3.0..3.0f64, 2..300), kept in 2usize..80,
        ) {
            let x: Vec<f64> = (0..values.len()).map(|i| i as f64).collect();
            let points = shape_points(std::slice::from_ref(&values), &x, kept);
            prop_assert_eq!(points.len(), kept.min(values.len()));
            prop_assert_eq!((points[0], points[points.len() - 1]), (0, values.len() - 1));
            prop_assert!(points.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", points);
        }

        #[test]
        fn an_even_choice_holds_both_ends(count in 1usize..500, kept in 2usize..100) {
            let chosen = evenly(count, kept);
            prop_assert_eq!(chosen.len(), kept.min(count));
            prop_assert_eq!((chosen[0], chosen[chosen.len() - 1]), (0, count - 1));
            prop_assert!(chosen.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn the_deviation_is_that_of_the_worst_point_over_the_range() {
        let x: Vec<f64> = (0..=4).map(f64::from).collect();
        let field = [0.0, 1.0, -2.0, 1.0, 2.0];
        assert_eq!(deviation(&x, &field, &[0, 1, 2, 3, 4]), 0.0);
        // The line from 0 to 2 is at 1 above −2, in a range of 4.
        assert_eq!(deviation(&x, &field, &[0, 4]), 0.75);
    }

    /// A narrow peak in a long field keeps most of the points.
    #[test]
    fn a_peak_is_kept() {
        let x: Vec<f64> = (0..=600).map(|i| f64::from(i - 300) / 100.0).collect();
        let peak: Vec<f64> = x.iter().map(|x| (-(x / 0.05).powi(2)).exp()).collect();
        let points = shape_points(std::slice::from_ref(&peak), &x, 60);
        assert!(points.iter().filter(|i| peak[**i] > 1e-3).count() >= 20);
        assert!(points.contains(&300), "the maximum is shown");
        assert!(deviation(&x, &peak, &points) < 0.01);
    }
}
