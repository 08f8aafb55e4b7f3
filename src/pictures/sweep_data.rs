//! What pictures are made of.

use super::axis::{AxisWords, held};
use super::{Axis, Kind, PictureError};
use stribeck_lab::{LaboratoryQuantity, Measured, Scales};
use stribeck_solver::{Parameters, shortest};
use stribeck_sweep::store::{DataSet, StoreError};
use stribeck_sweep::{Column, Field, Sweep};

/// A published data set, and what else pictures of it need.
#[derive(Debug)]
pub struct SweepData {
    /// The data set.
    pub data: DataSet,
    /// The sweep it was computed for, which known limits need; none if this version cannot read it.
    pub sweep: Option<Sweep>,
    /// Points that were measured, to be laid over.
    pub measured: Option<Measured>,
    axes: [AxisWords; 3],
    /// f, α and β of every place.
    numbers: Vec<[f64; 3]>,
    /// The hysteresis that is a part of the drag (T54): that of the flat, which is all of it where the roller is not
    /// viscoelastic.
    hysteresis: Column,
    /// In SI data sets the scales of every place, as [`Scales::VARIABLES`] has them.
    scales: Option<[Vec<f64>; 4]>,
}

impl SweepData {
    /// The pictures of a data set, of which values of some dimensions are asked for.
    ///
    /// # Errors
    /// [`StoreError`] if it cannot be read.
    pub fn new(
        data: DataSet,
        sweep: Option<Sweep>,
        measured: Option<Measured>,
        asked: &[(String, Vec<f64>)],
    ) -> Result<Self, StoreError> {
        let scales = match data.laboratory {
            true => {
                let [length, height, pressure, friction] = Scales::VARIABLES.map(|(name, ..)| data.variable(name));
                Some([length?, height?, pressure?, friction?])
            }
            false => None,
        };
        let (axes, numbers) = (AxisWords::of(&data, asked), data.numbers()?);
        let hysteresis = if data.has_hysteresis_of_roller()? { Column::MuVFlat } else { Column::MuV };
        Ok(Self { axes, numbers, hysteresis, scales, data, sweep, measured })
    }

    /// What an instrument reads, and its parts (T54).
    pub(super) fn drag_and_parts(&self) -> [Column; 4] {
        [Column::MuDrag, self.hysteresis, Column::MuShear, Column::MuPressure]
    }

    /// What an axis is called, and its values.
    pub(super) fn axis(&self, axis: Axis) -> &AxisWords {
        &self.axes[axis.dimension()]
    }

    /// Names of the dimensions that an axis is made of.
    pub(super) fn dimension_names(&self, axis: Axis) -> Vec<&str> {
        let (outer, last) = (self.data.outer(), self.data.dimensions.len() - 1);
        let range = match axis {
            Axis::F => 0..outer,
            Axis::Middle => outer..last,
            Axis::Inner => last..last + 1,
        };
        self.data.dimensions[range].iter().map(|dimension| dimension.name.as_str()).collect()
    }

    /// The value of an axis at an index.
    pub(super) fn value(&self, axis: Axis, index: usize) -> f64 {
        self.axis(axis).values[index]
    }

    /// f, α and β at these indices.
    pub(super) fn point(&self, indices: [usize; 3]) -> [f64; 3] {
        self.numbers[self.data.place(indices)]
    }

    /// What the columns of tables are called that say where a number belongs.
    pub(super) fn coordinate_names(&self) -> Vec<&str> {
        let dimensions = self.data.dimensions.iter().map(|dimension| dimension.name.as_str());
        dimensions.chain(if self.data.laboratory { &["alpha", "beta"][..] } else { &[] }.iter().copied()).collect()
    }

    /// The values of these columns at a place.
    pub(super) fn coordinates(&self, indices: [usize; 3]) -> Vec<f64> {
        let on_axes = self.data.indices(indices).into_iter().zip(&self.data.dimensions);
        let derived = if self.data.laboratory { &self.point(indices)[1..] } else { &[] };
        on_axes.map(|(index, dimension)| dimension.values[index]).chain(derived.iter().copied()).collect()
    }

    /// What numbers in a unit of dimensionless results are to be multiplied with at a place: 1 but in SI data sets.
    pub(super) fn factor(&self, units: &str, indices: [usize; 3]) -> f64 {
        let Some([length, height, pressure, friction]) = &self.scales else { return 1.0 };
        let place = self.data.place(indices);
        let [length, height, pressure, friction] = [length, height, pressure, friction].map(|values| values[place]);
        Scales { length, height, pressure, friction }.factor(units)
    }

    /// A field in the units of dimensionless results.
    pub(super) fn dimensionless_field(&self, field: Field, indices: [usize; 3]) -> Result<Vec<f64>, StoreError> {
        let mut values = self.data.field(field, indices)?;
        let factor = self.factor(field.units(), indices);
        values.iter_mut().for_each(|value| *value /= factor);
        Ok(values)
    }

    /// Checks that the sweep has the fields that a kind of picture needs.
    pub(super) fn check_fields(&self, kind: Kind, needed: &[Field]) -> Result<(), PictureError> {
        match needed.iter().find(|field| !self.data.fields.contains(field)) {
            None => Ok(()),
            Some(field) => {
                let name = field.name();
                Err(kind.missing(format!(
                    "the sweep has no field {name}; add it to fields below [output] and run it again"
                )))
            }
        }
    }

    /// The parameters of the case at these indices; `None` if the sweep is not known.
    pub(super) fn parameters(&self, indices: [usize; 3]) -> Option<Parameters> {
        let sweep = self.sweep.as_ref()?;
        Some(sweep.grid.parameters(indices.into(), &sweep.substrate))
    }

    /// "β = 100".
    pub(super) fn words(&self, axis: Axis, index: usize) -> String {
        self.axis(axis).words(index)
    }

    /// "-beta-100": what tells the file of a picture from others.
    pub(super) fn name_part(&self, axis: Axis, indices: [usize; 3]) -> String {
        let value = rounded(self.value(axis, indices[axis.dimension()])).replace('∞', "inf");
        format!("-{}-{value}", self.axis(axis).name)
    }

    /// "N = 400 N/m", "SRR = 0.5": what an experiment holds at one value and readers ask for first.
    pub(super) fn held(&self) -> Vec<String> {
        const ASKED_FOR: [LaboratoryQuantity; 3] =
            [LaboratoryQuantity::Load, LaboratoryQuantity::SlideRollRatio, LaboratoryQuantity::Temperature];
        let value = |name: &str| self.data.fixed.iter().find(|(fixed, _)| fixed == name).map(|(_, value)| *value);
        let words =
            |quantity: &LaboratoryQuantity| Some(held(quantity.name(), quantity.units(), value(quantity.name())?));
        ASKED_FOR.iter().filter_map(words).collect()
    }

    /// "f = 100" of the quantities that an axis is made of but does not run along.
    pub(super) fn held_along(&self, axis: Axis, index: usize) -> Vec<String> {
        if self.axis(axis).name == AxisWords::COMBINATION {
            return Vec::new();
        }
        let own = format!("{} = ", self.axis(axis).symbol);
        let words = self.words(axis, index);
        words.split(", ").filter(|words| !words.is_empty() && !words.starts_with(&own)).map(str::to_owned).collect()
    }

    /// "f = 100, α = 1" of the axes named.
    pub(super) fn list(&self, axes: &[Axis], indices: [usize; 3]) -> String {
        let words: Vec<String> = axes
            .iter()
            .map(|axis| self.words(*axis, indices[axis.dimension()]))
            .filter(|words| !words.is_empty())
            .collect();
        words.join(", ")
    }
}

/// A number with at most four digits: 31.62, 0.001, 1e6, ∞.
pub(super) fn rounded(value: f64) -> String {
    if value == f64::INFINITY {
        return "∞".to_owned();
    }
    let short: f64 = format!("{value:.3e}").parse().expect("{:e} writes a number");
    // The largest numbers would round to infinity.
    let short = if short.is_finite() { short } else { value };
    if short != 0.0 && !(1e-4..1e6).contains(&short.abs()) { format!("{short:e}") } else { shortest(short) }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_are_short() {
        let values = [31.622776601683793, 0.001, 1000.0, 0.0, f64::INFINITY, 2e-7, 1.7e308];
        assert_eq!(values.map(rounded), ["31.62", "0.001", "1000", "0", "∞", "2e-7", "1.7e308"]);
        assert_eq!(rounded(f64::MAX), "1.7976931348623157e308");
    }
}
