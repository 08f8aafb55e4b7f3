//! Curves that belong together, with what is known beside them.

use stribeck_charts::{Colour, Curve, Stroke};

/// The colour of the `index`-th of `count` curves of a family.
pub(super) fn colour(index: usize, count: usize) -> Colour {
    if count < 2 { Colour::Family(0.3) } else { Colour::Family(index as f64 / (count - 1) as f64) }
}

/// Known curves beside those of a family, one for each member: a single black one where all are the same, else one in the colour
/// of each member and a line in the legend for all. Members for which nothing is known have an empty one.
///
/// A thing of its own kind keeps its colour, so that curves of several quantities can be told apart.
pub(super) fn beside(label: &str, stroke: Stroke, members: Vec<(Colour, Vec<(f64, f64)>)>) -> Vec<Curve> {
    let curve = |label: &str, points: Vec<(f64, f64)>, colour: Colour| Curve {
        label: label.to_owned(),
        points,
        failed: vec![],
        stroke,
        colour,
        marked: false,
    };
    let shown = |points: &[(f64, f64)]| points.iter().any(|point| point.1.is_finite());
    let members: Vec<_> = members.into_iter().filter(|(_, points)| shown(points)).collect();
    let Some((first_colour, first)) = members.first() else { return vec![] };
    let same = |one: &(f64, f64), other: &(f64, f64)| {
        one.0 == other.0 && (one.1 == other.1 || one.1.is_nan() && other.1.is_nan())
    };
    let alike = |points: &[(f64, f64)]| {
        points.len() == first.len() && points.iter().zip(first).all(|(one, other)| same(one, other))
    };
    if members.iter().all(|(_, points)| alike(points)) {
        let colour = if matches!(first_colour, Colour::Kind(_)) { *first_colour } else { Colour::Black };
        return vec![curve(label, first.clone(), colour)];
    }
    let mut curves: Vec<Curve> = members.into_iter().map(|(colour, points)| curve("", points, colour)).collect();
    curves.push(curve(label, vec![], Colour::Black));
    curves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_the_same_for_all_is_drawn_once() {
        let member = |index, y: f64| (colour(index, 2), vec![(1.0, y), (2.0, f64::NAN)]);
        let same = beside("dry", Stroke::Dashed, vec![member(0, 0.5), member(1, 0.5)]);
        assert_eq!(same.len(), 1);
        assert_eq!((same[0].colour, same[0].label.as_str()), (Colour::Black, "dry"));
        let different = beside("dry", Stroke::Dashed, vec![member(0, 0.5), member(1, 0.6)]);
        assert_eq!(different.iter().map(|curve| curve.label.as_str()).collect::<Vec<_>>(), ["", "", "dry"]);
        assert!(beside("dry", Stroke::Dashed, vec![member(0, f64::NAN)]).is_empty());
    }
}
