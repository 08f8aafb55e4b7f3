//! A surface that is ready to be evaluated.

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::error::SurfaceError;
use crate::evaluator::Evaluator;
use crate::file::{FORMAT, NumberKind, QuantityRecord, SurfaceFile, Transform};
use crate::map::Axis;
use crate::tensor::{Factor, Numbers, Tucker};

/// The most that a value at a check point may differ, relatively, from what stands in the file.
const CHECK: f64 = 1e-12;

/// A surface: the quantities of a sweep as functions of its axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    file: SurfaceFile,
    pub(crate) series: Vec<Series>,
    /// The largest number of polynomials along each axis.
    pub(crate) degrees: Vec<usize>,
}

/// A quantity and its series.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Series {
    pub tucker: Tucker,
    pub value: Value,
}

/// How a value follows from its series y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    Identity,
    Exp,
    /// share · (quantity `of`) · (a function of y).
    Part {
        of: usize,
        share: f64,
        function: Part,
    },
}

/// What a part is over its share of the whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// sinh y.
    Sinh,
    /// r² − offset, r = e^(y/2) − 1 + √offset.
    Root { offset: f64 },
}

impl Part {
    /// The function and its derivative.
    pub fn at(self, y: f64) -> [f64; 2] {
        match self {
            Self::Sinh => [y.sinh(), y.cosh()],
            Self::Root { offset } => {
                let (change, least) = ((0.5 * y).exp_m1(), offset.sqrt());
                [change * (change + 2.0 * least), (change + least) * (change + 1.0)]
            }
        }
    }
}

impl Surface {
    /// Reads a surface and compares it with its check points.
    ///
    /// # Errors
    /// [`SurfaceError`] if the file cannot be read, is no surface, or is damaged.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SurfaceError> {
        Self::parse(&std::fs::read_to_string(path).map_err(SurfaceError::Unreadable)?)
    }

    /// Takes the text of a surface, and compares it with its check points.
    ///
    /// # Errors
    /// As for [`Surface::read`].
    pub fn parse(text: &str) -> Result<Self, SurfaceError> {
        let surface = Self::new(serde_json::from_str(text)?)?;
        surface.check()?;
        Ok(surface)
    }

    /// Makes the series of a file ready.
    ///
    /// # Errors
    /// [`SurfaceError::Format`] or [`SurfaceError::Damaged`] if parts of it do not fit together.
    pub fn new(file: SurfaceFile) -> Result<Self, SurfaceError> {
        if file.format != FORMAT {
            return Err(SurfaceError::Format { found: file.format, known: FORMAT });
        }
        check_axes(&file.axes)?;
        let mut series = Vec::with_capacity(file.quantities.len());
        let mut degrees = vec![0; file.axes.len()];
        for (place, quantity) in file.quantities.iter().enumerate() {
            let damaged = |what: String| SurfaceError::Damaged { quantity: quantity.name.clone(), what };
            let tucker = decode(quantity, file.axes.len()).map_err(damaged)?;
            for (most, factor) in degrees.iter_mut().zip(&tucker.factors) {
                *most = factor.degrees.max(*most);
            }
            let value = match &quantity.transform {
                Transform::Identity => Value::Identity,
                Transform::Exp => Value::Exp,
                Transform::Sinh { of, share } | Transform::Root { of, share, .. } => {
                    let of = file.quantities[..place].iter().position(|whole| whole.name == *of);
                    let of = of.ok_or_else(|| damaged("the quantity that it is a part of is not before it".into()))?;
                    let function = match quantity.transform {
                        Transform::Root { offset, .. } => Part::Root { offset },
                        _ => Part::Sinh,
                    };
                    Value::Part { of, share: *share, function }
                }
            };
            series.push(Series { tucker, value });
        }
        Ok(Self { file, series, degrees })
    }

    /// The file.
    pub fn file(&self) -> &SurfaceFile {
        &self.file
    }

    /// The axes, in the order of the coordinates of a point.
    pub fn axes(&self) -> &[Axis] {
        &self.file.axes
    }

    /// The names of the quantities, in the order of the values.
    pub fn quantities(&self) -> impl Iterator<Item = &str> {
        self.file.quantities.iter().map(|quantity| quantity.name.as_str())
    }

    /// What evaluates the surface. It has the memory for that, so that a point needs none.
    pub fn evaluator(&self) -> Evaluator<'_> {
        Evaluator::new(self)
    }

    /// What a difference of a quantity is relative to: itself, or where that is larger the share of the whole at which
    /// a part begins to count.
    fn least(&self, place: usize, values: &[f64]) -> f64 {
        let whole = match &self.file.quantities[place].transform {
            Transform::Sinh { of, share } | Transform::Root { of, share, .. } => {
                self.quantities().position(|name| name == of).map(|of| share * values[of])
            }
            Transform::Identity | Transform::Exp => None,
        };
        values[place].abs().max(whole.unwrap_or(0.0).abs())
    }

    fn check(&self) -> Result<(), SurfaceError> {
        let mut evaluator = self.evaluator();
        for (number, check) in (1..).zip(&self.file.checks) {
            let damaged = |what: String| SurfaceError::Damaged { quantity: format!("check point {number}"), what };
            let values = evaluator.values(&check.point).map_err(|outside| damaged(outside.to_string()))?;
            if values.len() != check.values.len() {
                return Err(damaged(format!("{} values, and {} quantities", check.values.len(), values.len())));
            }
            for (place, (quantity, &found)) in self.quantities().zip(values).enumerate() {
                let expected = check.values[place];
                let agrees = (found - expected).abs() <= CHECK * self.least(place, &check.values);
                if !agrees {
                    return Err(SurfaceError::CheckPoint { quantity: quantity.to_owned(), number, found, expected });
                }
            }
        }
        Ok(())
    }
}

fn check_axes(axes: &[Axis]) -> Result<(), SurfaceError> {
    let damaged = |what: String| SurfaceError::Damaged { quantity: "axes".to_owned(), what };
    if !(1..=3).contains(&axes.len()) {
        return Err(damaged(format!("{} axes, and one to three are possible", axes.len())));
    }
    for axis in axes {
        let ends = [axis.from, axis.to].map(|end| axis.spread.forward(end));
        if !(ends[0] < ends[1] && ends.iter().all(|end| end.is_finite())) {
            return Err(damaged(format!("{} from {} to {} is no range", axis.name, axis.from, axis.to)));
        }
    }
    Ok(())
}

fn decode(quantity: &QuantityRecord, axes: usize) -> Result<Tucker, String> {
    if quantity.shape.len() != axes || quantity.factors.len() != axes {
        return Err(format!("{} factors, and {axes} axes", quantity.factors.len()));
    }
    let numbers = |text: &str, expected: usize| {
        let bytes = STANDARD.decode(text).map_err(|error| format!("not base64: {error}"))?;
        let (numbers, are_finite) = from_bytes(quantity.numbers, &bytes);
        if numbers.len() != expected || !are_finite {
            return Err(format!("{} numbers, and {expected} finite ones are expected", numbers.len()));
        }
        Ok(numbers)
    };
    let mut factors = Vec::with_capacity(axes);
    let mut size = 1_usize;
    for (&[degrees, rank], text) in quantity.shape.iter().zip(&quantity.factors) {
        // Larger ones would be none that a program wrote.
        if !(1..=4096).contains(&degrees) || !(1..=degrees).contains(&rank) {
            return Err(format!("{degrees} polynomials of rank {rank}"));
        }
        size = size.saturating_mul(rank);
        factors.push(Factor { degrees, rank, numbers: numbers(text, degrees * rank)? });
    }
    Ok(Tucker { factors, core: numbers(&quantity.core, size)? })
}

/// The numbers, and whether all are finite.
fn from_bytes(kind: NumberKind, bytes: &[u8]) -> (Numbers, bool) {
    match kind {
        NumberKind::Float32 => {
            let numbers: Vec<f32> = bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
            let are_finite = numbers.iter().all(|number| number.is_finite());
            (Numbers::Single(numbers), are_finite)
        }
        NumberKind::Float64 => {
            let numbers: Vec<f64> = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
            let are_finite = numbers.iter().all(|number| number.is_finite());
            (Numbers::Double(numbers), are_finite)
        }
    }
}

/// Numbers as they stand in a file.
pub fn encode(kind: NumberKind, numbers: &[f64]) -> String {
    let bytes: Vec<u8> = match kind {
        NumberKind::Float32 => numbers.iter().flat_map(|number| (*number as f32).to_le_bytes()).collect(),
        NumberKind::Float64 => numbers.iter().flat_map(|number| number.to_le_bytes()).collect(),
    };
    STANDARD.encode(bytes)
}
