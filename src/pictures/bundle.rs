//! Which curves stand in one picture: along an axis, a family over another, the third fixed.

use super::Axis;
use super::cases::middle;
use super::request::{Request, Selection, spread};
use super::source::{Source, rounded};

/// Most curves of a family.
const MOST_CURVES: usize = 7;

/// The curves of one picture.
pub(super) struct Bundle {
    /// The axis that runs.
    pub(super) along: Axis,
    /// The axis that makes the family.
    pub(super) family: Axis,
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

impl Bundle {
    /// Indices of a point of a member.
    pub(super) fn at(&self, member: usize, point: usize) -> [usize; 3] {
        let mut indices = self.start;
        indices[self.family.dimension()] = member;
        indices[self.along.dimension()] = point;
        indices
    }
}

/// The pictures along an axis: one for each value of the third axis that was asked for, else one in its middle. With several
/// quantities in one picture there is no room for a family, and its members have a picture each.
pub(super) fn bundles(source: &Source, request: &Request, selection: &Selection, along: Axis) -> Vec<Bundle> {
    // The axis with more values makes the family, β rather than f or α.
    let mut others = along.others();
    others.sort_by_key(|axis| (selection.on(*axis).len(), *axis == Axis::Inner));
    let [third, family] = others;
    // At f = 0 nothing depends on α.
    let varies = |axis: Axis, index: &usize| {
        source.data.laboratory
            || along != Axis::Middle
            || axis != Axis::F
            || source.value(Axis::F, *index) > 0.0
            || selection.on(Axis::F).len() == 1
    };
    let on = |axis: Axis, most: usize| {
        let all: Vec<usize> = selection.on(axis).iter().copied().filter(|index| varies(axis, index)).collect();
        match most {
            _ if selection.is_asked(axis) => all,
            1 => vec![middle(source, axis, &all)],
            _ => spread(&all, most),
        }
    };
    let members = on(family, if request.together { 1 } else { MOST_CURVES });
    let groups: Vec<Vec<usize>> =
        if request.together { members.iter().map(|member| vec![*member]).collect() } else { vec![members] };
    let thirds = on(third, 1);
    let mut bundles = Vec::new();
    for third_index in &thirds {
        for members in &groups {
            let mut start = [0; 3];
            start[third.dimension()] = *third_index;
            start[family.dimension()] = members[0];
            let several = [(third, thirds.len()), (family, groups.len())].into_iter().filter(|(_, count)| *count > 1);
            let part = |(axis, _): (Axis, usize)| {
                format!(
                    "-{}-{}",
                    source.axis(axis).name,
                    rounded(source.value(axis, start[axis.dimension()])).replace('∞', "inf")
                )
            };
            let mut fixed = vec![third];
            if members.len() == 1 {
                fixed.push(family);
            }
            fixed.sort_by_key(|axis| axis.dimension());
            bundles.push(Bundle {
                along,
                family,
                points: selection.on(along).to_vec(),
                members: members.clone(),
                fixed,
                start,
                suffix: several.map(part).collect(),
            });
        }
    }
    bundles
}
