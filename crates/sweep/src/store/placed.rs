//! A case at its place: its numbers and fields at the slide-to-roll ratio of the place, in the units of the place.

use super::further_columns::averages_of;
use super::{Point, sensitivity_columns};
use crate::{Column, Field, Note, Values};
use stribeck_solver::{Lubricant, Output, Sensitivities, shear_traction};

/// The numbers of a case at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedNumbers {
    /// Those of the columns, in SI units where the place has an experiment.
    pub values: Values,
    /// Those of the columns that only some sweeps have: sensitivities, then averages of swapped bodies.
    pub more: Vec<f64>,
    /// Where the solution is beyond its model: [`Note::mask`] of each note.
    pub notes: i32,
    lubricant: Lubricant,
}

impl Point {
    /// The numbers of its case, from those at S = 1 over a₀/R.
    ///
    /// `sensitivities` are those of the solution and their errors, where the output has them. `swapped` are the numbers
    /// of the case with the bodies swapped, at the opposite slide-to-roll ratio, where bodies are swapped.
    pub fn numbers_of(
        &self,
        values: &Values,
        sensitivities: [Option<Sensitivities>; 2],
        swapped: Option<&Values>,
        output: &Output,
    ) -> PlacedNumbers {
        let slide_roll = self.slide_roll;
        let mut values = asked(*values, output.limits).at_slide_roll(slide_roll);
        let mut more = match output.sensitivities {
            true => {
                let sensitivities = self.sensitivities_of(sensitivities);
                sensitivity_columns::values(sensitivities, &values, slide_roll, self.experiment.as_ref())
            }
            false => Vec::new(),
        };
        let scales = self.experiment.map(|experiment| experiment.scales());
        if let Some(swapped) = swapped {
            let factor = scales.map_or(1.0, |scales| scales.friction);
            more.extend(averages_of(slide_roll, &values, swapped).map(|mu| factor * mu));
        }
        let lubricant = Lubricant {
            beta: self.numbers[2],
            c: values[Column::C],
            outlet: values[Column::XOutlet],
            cavity_shear: output.cavity_shear,
        };
        if let Some(scales) = &scales {
            for column in Column::ALL {
                values[column] *= scales.factor(column.units());
            }
        }
        let notes = Note::of(&values, self.experiment.as_ref(), &self.limits);
        let notes = notes.fold(0, |notes, note| notes | note.mask());
        PlacedNumbers { values, more, notes, lubricant }
    }

    /// Sensitivities and their errors with respect to the numbers of the place, from those to the numbers of its case.
    pub fn sensitivities_of(&self, of_case: [Option<Sensitivities>; 2]) -> [Option<Sensitivities>; 2] {
        of_case.map(|known| known.map(|known| known.with_power_of_strength(self.power_of_strength)))
    }

    /// True if a field of this place follows from the film: the shear on a roller that turns, as what is stored is that
    /// on one that slides.
    pub fn follows_from_film(&self, field: Field) -> bool {
        field == Field::ShearTraction && self.slide_roll != 1.0
    }

    /// What makes a field of this place of the stored one, or of the film if it [follows](Point::follows_from_film)
    /// from that.
    pub fn placing(&self, field: Field, numbers: &PlacedNumbers) -> Placing {
        let shear = self.follows_from_film(field).then_some((numbers.lubricant, self.slide_roll));
        let factor = self.experiment.map(|experiment| experiment.scales().factor(field.units()));
        Placing { shear, factor }
    }
}

/// What makes a field of a place of a stored one.
#[derive(Clone, Copy, Debug)]
pub struct Placing {
    /// The film becomes the shear at this slide-to-roll ratio.
    shear: Option<(Lubricant, f64)>,
    /// The unit of the place.
    factor: Option<f64>,
}

impl Placing {
    /// Does it to values over x.
    pub fn apply(&self, x: &[f64], values: &mut [f64]) {
        if let Some((lubricant, slide_roll)) = &self.shear {
            for (value, &x) in values.iter_mut().zip(x) {
                *value = shear_traction(lubricant, x, *value, *slide_roll);
            }
        }
        if let Some(factor) = self.factor {
            values.iter_mut().for_each(|value| *value *= factor);
        }
    }
}

/// The numbers of a case that the sweep asks for; a shard of an earlier run may have the limits as well.
fn asked(mut values: Values, limits: bool) -> Values {
    for column in Column::ALL.into_iter().filter(|column| column.is_limit() && !limits) {
        values[column] = f64::NAN;
    }
    values
}
