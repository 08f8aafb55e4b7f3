//! The plane of α and β of a sweep, as far as it has a place on logarithmic axes.

use super::maps::{check_plane, why_no_grid};
use super::request::{Kind, Selection};
use super::sweep_data::{SweepData, rounded};
use super::{Axis, PictureError};

/// Indices on the two axes.
pub(super) struct SurfaceGrid {
    alphas: Vec<usize>,
    betas: Vec<usize>,
    /// Values without a place, each by its axis and index: those that are not above 0, and ∞.
    special: Vec<(Axis, usize)>,
}

impl SurfaceGrid {
    /// The values chosen that are positive and finite, two or more on each axis.
    pub(super) fn of(sweep: &SweepData, selection: &Selection, kind: Kind) -> Result<Self, PictureError> {
        check_plane(sweep, kind)?;
        let mut special = Vec::new();
        let mut with_a_place = |axis: Axis| -> Vec<usize> {
            let (there, others): (Vec<usize>, Vec<usize>) = selection.on(axis).iter().partition(|index| {
                let value = sweep.value(axis, **index);
                value > 0.0 && value.is_finite()
            });
            special.extend(others.into_iter().map(|index| (axis, index)));
            there
        };
        let (alphas, betas) = (with_a_place(Axis::Middle), with_a_place(Axis::Inner));
        for (axis, indices) in [(Axis::Middle, &alphas), (Axis::Inner, &betas)] {
            if indices.len() < 2 {
                return Err(kind.missing(match sweep.axis(axis).name.as_str() {
                    "" => why_no_grid(sweep, axis, "surface"),
                    name => format!(
                        "{name} has {} value here with a place on a logarithmic axis, and a surface needs two; try \
                         --what curves",
                        indices.len()
                    ),
                }));
            }
        }
        Ok(Self { alphas, betas, special })
    }

    /// Values of α.
    pub(super) fn alphas(&self, sweep: &SweepData) -> Vec<f64> {
        self.alphas.iter().map(|i| sweep.value(Axis::Middle, *i)).collect()
    }

    /// Values of β.
    pub(super) fn betas(&self, sweep: &SweepData) -> Vec<f64> {
        self.betas.iter().map(|i| sweep.value(Axis::Inner, *i)).collect()
    }

    /// Indices and place of every point, α fastest.
    pub(super) fn places<'a>(
        &'a self,
        sweep: &'a SweepData,
        i_f: usize,
    ) -> impl Iterator<Item = ([usize; 3], usize)> + 'a {
        self.betas.iter().flat_map(move |i_beta| {
            self.alphas.iter().map(move |i_alpha| {
                let indices = [i_f, *i_alpha, *i_beta];
                (indices, sweep.data.place(indices))
            })
        })
    }

    /// What is not shown, in words, if something is not.
    pub(super) fn left_out(&self, sweep: &SweepData) -> Option<String> {
        let on = |axis: Axis| -> Option<String> {
            let own = self.special.iter().filter(|(of, _)| *of == axis);
            let values: Vec<String> = own.map(|(_, index)| rounded(sweep.value(axis, *index))).collect();
            (!values.is_empty()).then(|| format!("{} = {}", sweep.axis(axis).symbol, values.join(", ")))
        };
        let all: Vec<String> = [Axis::Middle, Axis::Inner].into_iter().filter_map(on).collect();
        (!all.is_empty()).then(|| format!("not shown: {}", all.join("; ")))
    }
}
