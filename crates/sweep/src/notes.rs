//! Notes: where a solution is beyond its model.

use crate::{Column, ModelLimits, Values};
use stribeck_lab::Experiment;

/// What is said of a place whose solution the model does not hold for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Note {
    /// Contact, film or pressure are not small: a₀ or film > R/3, or p > E∞*/3.
    ContactWide,
    /// The film is thinner than three times the roughness, or than 10 nm where that is not given.
    FilmRough,
    /// The fluid behind the film makes more than a tenth of the drag, and how much there is of it is assumed.
    CavityMatters,
    /// The contact is wider than a third of the layer's thickness.
    LayerThin,
}

impl Note {
    /// What the notes on a place are, in words.
    pub const LONG_NAME: &'static str = "where the solution is beyond its model";

    /// All, in the order of their masks.
    pub const ALL: [Self; 4] = [Self::ContactWide, Self::FilmRough, Self::CavityMatters, Self::LayerThin];

    /// Small beside R, E∞* or the thickness of the layer is what is below this part of it.
    const SMALL: f64 = 1.0 / 3.0;
    /// Least film over the combined roughness (the Λ ratio) without mixed lubrication.
    const LEAST_LAMBDA: f64 = 3.0;
    /// Films below this (m) are thinner than surfaces are smooth.
    const LEAST_FILM: f64 = 1e-8;
    /// Most part of the drag behind the film that does not matter.
    const MOST_CAVITY: f64 = 0.1;

    /// Its bit in the variable `notes` of `results.h5`.
    pub const fn mask(self) -> i32 {
        1 << self as i32
    }

    /// Its name in `flag_meanings`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ContactWide => "contact_wide",
            Self::FilmRough => "film_rough",
            Self::CavityMatters => "cavity_matters",
            Self::LayerThin => "layer_thin",
        }
    }

    /// What it says.
    pub const fn sentence(self) -> &'static str {
        match self {
            Self::ContactWide => {
                "a0 or the film is above a third of R, or the pressure above a third of the modulus: a parabola on a \
                 half space is no model of it. The load is per length of the cylinder, in N/m; look at load, radius \
                 and modulus"
            }
            Self::FilmRough => {
                "the smallest film is below three times the roughness, or below 10 nm where none is given: lubrication \
                 is mixed there, and friction is not that of a full film"
            }
            Self::CavityMatters => {
                "more than a tenth of the drag is shear behind the film, where the fluid's amount is assumed: compare \
                 cavity_shear = \"streamers\" with \"full\""
            }
            Self::LayerThin => "a0 is above a third of the layer's thickness: the layer is no half space",
        }
    }

    /// The notes on a place from its values, in SI units if there is an experiment.
    pub fn of<'v>(
        values: &'v Values,
        experiment: Option<&'v Experiment>,
        limits: &'v ModelLimits,
    ) -> impl Iterator<Item = Self> + 'v {
        let contact = experiment.copied().map(|experiment| (experiment, experiment.contact_length()));
        let holds = move |note: &Self| match (note, contact) {
            (Self::CavityMatters, _) => {
                values[Column::MuHCavity].abs() > Self::MOST_CAVITY * values[Column::MuDrag].abs()
            }
            (_, None) => false,
            (Self::ContactWide, Some((experiment, contact))) => {
                let length = Self::SMALL * experiment.radius;
                contact > length
                    || values[Column::C] > length
                    || values[Column::PMax] > Self::SMALL * experiment.plane_strain_modulus()
            }
            (Self::FilmRough, Some(_)) => {
                let least = limits.roughness.map_or(Self::LEAST_FILM, |roughness| Self::LEAST_LAMBDA * roughness);
                values[Column::FilmMin] < least
            }
            (Self::LayerThin, Some((_, contact))) => {
                limits.thickness.is_some_and(|thickness| contact > Self::SMALL * thickness)
            }
        };
        Self::ALL.into_iter().filter(holds)
    }
}

/// How many places have each note, in the order of [`Note::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoteCounts(pub [u64; Note::ALL.len()]);

impl NoteCounts {
    /// Counts the places of masks of notes.
    pub fn of_masks(masks: impl IntoIterator<Item = i32>) -> Self {
        let mut counts = Self::default();
        for mask in masks {
            counts.add(mask);
        }
        counts
    }

    /// Counts a place with these notes.
    pub fn add(&mut self, mask: i32) {
        for (count, note) in self.0.iter_mut().zip(Note::ALL) {
            *count += u64::from(mask & note.mask() != 0);
        }
    }

    /// The notes that some places have, with their number.
    pub fn iter(&self) -> impl Iterator<Item = (Note, u64)> + '_ {
        Note::ALL.into_iter().zip(self.0).filter(|(_, count)| *count > 0)
    }
}
