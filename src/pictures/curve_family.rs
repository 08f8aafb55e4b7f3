//! Families of curves: which curves stand in one picture, their colours, and reference curves beside them.

use super::Axis;
use super::cases::middle;
use super::request::{Request, Selection, spread};
use super::sweep_data::SweepData;
use stribeck_charts::{Colour, Curve, Stroke};

/// Most curves of a family.
const MOST_CURVES: usize = 7;

/// The curves of one picture.
pub(super) struct CurveFamily {
    /// The axis that runs.
    pub(super) along: Axis,
    /// The axis along which the curves differ.
    pub(super) varied: Axis,
    /// Indices on the running axis.
    pub(super) points: Vec<usize>,
    /// Indices of the family's members.
    pub(super) members: Vec<usize>,
    /// Axes on which all curves agree.
    pub(super) fixed: Vec<Axis>,
    /// Indices of the first member's first point.
    pub(super) start: [usize; 3],
    /// What tells the picture from others along the same axis; empty if there is one.
    pub(super) suffix: String,
}

impl CurveFamily {
    /// Indices of a point of a member.
    pub(super) fn at(&self, member: usize, point: usize) -> [usize; 3] {
        let mut indices = self.start;
        indices[self.varied.dimension()] = member;
        indices[self.along.dimension()] = point;
        indices
    }
}

/// The pictures along an axis: one for each value of the third axis that was asked for, else one in its middle. With
/// several quantities in one picture there is no room for a family, and its members have a picture each.
pub(super) fn curve_families(
    sweep: &SweepData,
    request: &Request,
    selection: &Selection,
    along: Axis,
) -> Vec<CurveFamily> {
    // The axis with more values makes the family, β rather than f or α.
    let mut others = along.others();
    others.sort_by_key(|axis| (selection.on(*axis).len(), *axis == Axis::Inner));
    let [third, varied] = others;
    // At f = 0 nothing depends on α.
    let varies = |axis: Axis, index: &usize| {
        sweep.data.laboratory
            || along != Axis::Middle
            || axis != Axis::F
            || sweep.point([*index, 0, 0])[0] > 0.0
            || selection.on(Axis::F).len() == 1
    };
    let on = |axis: Axis, most: usize| {
        let all: Vec<usize> = selection.on(axis).iter().copied().filter(|index| varies(axis, index)).collect();
        match most {
            _ if selection.is_asked(axis) => all,
            1 => vec![middle(sweep, axis, &all)],
            _ => spread(&all, most),
        }
    };
    let members = on(varied, if request.together { 1 } else { MOST_CURVES });
    let groups: Vec<Vec<usize>> =
        if request.together { members.iter().map(|member| vec![*member]).collect() } else { vec![members] };
    let thirds = on(third, 1);
    let mut families = Vec::new();
    for third_index in &thirds {
        for members in &groups {
            let mut start = [0; 3];
            start[third.dimension()] = *third_index;
            start[varied.dimension()] = members[0];
            let several = [(third, thirds.len()), (varied, groups.len())].into_iter().filter(|(_, count)| *count > 1);
            let suffix = several.map(|(axis, _)| sweep.name_part(axis, start)).collect();
            let mut fixed = vec![third];
            if members.len() == 1 {
                fixed.push(varied);
            }
            fixed.sort_by_key(|axis| axis.dimension());
            families.push(CurveFamily {
                along,
                varied,
                points: selection.on(along).to_vec(),
                members: members.clone(),
                fixed,
                start,
                suffix,
            });
        }
    }
    families
}

/// The colour of the `index`-th of `count` curves of a family.
pub(super) fn member_colour(index: usize, count: usize) -> Colour {
    if count < 2 { Colour::Family(0.3) } else { Colour::Family(index as f64 / (count - 1) as f64) }
}

/// Reference curves beside those of a family, one for each member: a single black one where all are the same, else one
/// in the colour of each member and a line in the legend for all. Members for which nothing is known have an empty one.
///
/// A thing of its own kind keeps its colour, so that curves of several quantities can be told apart.
pub(super) fn beside(label: &str, stroke: Stroke, members: Vec<(Colour, Vec<(f64, f64)>)>) -> Vec<Curve> {
    let curve = |label: &str, points: Vec<(f64, f64)>, colour: Colour| Curve {
        label: label.to_owned(),
        points,
        failed: vec![],
        stroke,
        colour,
        mark: None,
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
        let member = |index, y: f64| (member_colour(index, 2), vec![(1.0, y), (2.0, f64::NAN)]);
        let same = beside("dry", Stroke::Dashed, vec![member(0, 0.5), member(1, 0.5)]);
        assert_eq!(same.len(), 1);
        assert_eq!((same[0].colour, same[0].label.as_str()), (Colour::Black, "dry"));
        let different = beside("dry", Stroke::Dashed, vec![member(0, 0.5), member(1, 0.6)]);
        assert_eq!(different.iter().map(|curve| curve.label.as_str()).collect::<Vec<_>>(), ["", "", "dry"]);
        assert!(beside("dry", Stroke::Dashed, vec![member(0, f64::NAN)]).is_empty());
    }
}
