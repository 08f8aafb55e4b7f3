//! The JSON schema of sweep files, for editors: made of the keys, words and limits that the reader knows.
//!
//! It refuses unknown keys, values of a wrong type and values out of range. What depends on several keys at once is for
//! the reader alone. A file that the reader takes is valid by the schema; an infinity may be `null` there, as which it
//! reaches the validators of TOML editors.

use serde_json::{Map, Value, json};

use super::sections::{Key, entries};
use super::solver::{ACCELERATIONS, METHODS};
use super::specification::SolverSettings;
use super::surface::{POINTS, SEED, SurfaceSettings, TOLERANCE, is_function};
use super::{named_series, output, substrate, temperature};
use crate::{Column, Field};
use stribeck_input::{Quantity, RANGE_KEYS, RANGE_SCALES};
use stribeck_lab::LaboratoryQuantity;
use stribeck_solver::collocation;
use stribeck_solver::relaxation::{Domain, Settings};

/// The values that a key may have.
pub(super) enum Shape {
    /// One line of text.
    Title,
    /// True or false, with the default.
    Boolean(bool),
    /// A table with the keys of a section of this name.
    Section(&'static str),
    /// A number, a list or a range.
    Axis(Quantity),
    /// The same of a quantity, whose numbers may have a unit.
    Varying(LaboratoryQuantity),
    /// One number, which may have a unit, above 0.
    Quantity,
    /// As [`Varying`](Self::Varying), or a law of temperature.
    Viscosity,
    /// What a function says.
    Computed(fn() -> Value),
}

/// The JSON schema (draft 7) of sweep files.
pub fn schema() -> Value {
    let mut schema = section("");
    schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
    schema["title"] = json!("Sweep file of stribeck");
    schema["description"] = json!("Which cases of lubricated sliding are solved, how, and what is kept of them.");
    schema["anyOf"] = json!([{ "required": ["axes"] }, { "required": ["laboratory"] }]);
    schema
}

/// The JSON schema of a section, for files that have it too.
pub fn section_schema(name: &str) -> Value {
    section(name)
}

impl Shape {
    fn schema(&self) -> Value {
        match self {
            Self::Title => json!({ "type": "string", "minLength": 1, "maxLength": 500, "pattern": "\\S" }),
            Self::Boolean(default) => json!({ "type": "boolean", "default": default }),
            Self::Section(name) => section(name),
            Self::Axis(quantity) => axis(&number(*quantity)),
            Self::Varying(quantity) => axis(&measured(*quantity)),
            Self::Quantity => above_0_or_text(),
            Self::Viscosity => either([axis(&measured(LaboratoryQuantity::Viscosity)), viscosity_law()]),
            Self::Computed(schema) => schema(),
        }
    }
}

/// A table with the keys of a section.
fn section(name: &str) -> Value {
    closed(entries(name).iter().map(|Key { name, shape, meaning }| {
        let mut schema = shape.schema();
        schema["description"] = json!(meaning);
        (*name, schema)
    }))
}

/// A table with these keys and no others.
fn closed<'k>(keys: impl IntoIterator<Item = (&'k str, Value)>) -> Value {
    let properties: Map<String, Value> = keys.into_iter().map(|(key, schema)| (key.to_owned(), schema)).collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false })
}

/// The same, where some keys must be there.
fn with_required<'k>(keys: impl IntoIterator<Item = (&'k str, Value)>, required: &[&str]) -> Value {
    let mut schema = closed(keys);
    schema["required"] = json!(required);
    schema
}

fn either(schemas: impl IntoIterator<Item = Value>) -> Value {
    json!({ "anyOf": schemas.into_iter().collect::<Vec<_>>() })
}

fn words<'w>(words: impl IntoIterator<Item = &'w str>) -> Value {
    json!({ "enum": words.into_iter().collect::<Vec<_>>() })
}

fn whole(range: &std::ops::RangeInclusive<usize>) -> Value {
    json!({ "type": "integer", "minimum": range.start(), "maximum": range.end() })
}

fn within(range: &std::ops::RangeInclusive<f64>) -> Value {
    json!({ "type": "number", "minimum": range.start(), "maximum": range.end() })
}

fn with_default(mut schema: Value, default: Value) -> Value {
    schema["default"] = default;
    schema
}

/// A number of a dimensionless quantity.
fn number(quantity: Quantity) -> Value {
    match quantity {
        Quantity::Strength => json!({ "type": "number", "minimum": 0 }),
        Quantity::SlideTime => json!({ "type": ["number", "null"], "minimum": 0 }),
        Quantity::InverseHersey => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Quantity::Position => json!({ "type": "number" }),
        Quantity::SlideRoll => json!({ "type": "number", "minimum": -1, "maximum": 1 }),
    }
}

/// A number of a quantity of the laboratory; it may have a unit where the quantity has one.
fn measured(quantity: LaboratoryQuantity) -> Value {
    // The limits of the reader, from outside.
    let [least, most] = [-1e300, 1e300].map(|far| quantity.admits(far));
    debug_assert!(!least, "no quantity is below any number");
    let mut schema = match (quantity.admits(0.0), most) {
        (true, true) => json!({ "type": "number", "minimum": 0 }),
        (false, true) => json!({ "type": "number", "exclusiveMinimum": 0 }),
        (_, false) => match quantity {
            LaboratoryQuantity::Temperature => within(&LaboratoryQuantity::TEMPERATURES),
            LaboratoryQuantity::SlideRollRatio => json!({ "type": "number", "minimum": -2, "maximum": 2 }),
            _ => json!({ "type": "number", "minimum": 0, "maximum": 0.5 }),
        },
    };
    if quantity != LaboratoryQuantity::PoissonRatio {
        schema = either([schema, text_with_unit()]);
    }
    schema
}

fn above_0_or_text() -> Value {
    either([json!({ "type": "number", "exclusiveMinimum": 0 }), text_with_unit()])
}

/// A number with a unit behind it.
fn text_with_unit() -> Value {
    json!({ "type": "string", "pattern": "[0-9][\\s\\S]*[^0-9.\\s]" })
}

/// One value, a list of them, or a range.
fn axis(value: &Value) -> Value {
    let of_range = |key| match key {
        "points" => whole(&(2..=1_000_000)),
        "scale" => with_default(words(RANGE_SCALES), json!(RANGE_SCALES[0])),
        _ => value.clone(),
    };
    // The ranges of a surface need no number of points.
    let range = with_required(RANGE_KEYS.map(|key| (key, of_range(key))), &["from", "to"]);
    either([value.clone(), json!({ "type": "array", "items": value, "minItems": 1 }), range])
}

pub(super) fn strength() -> Value {
    number(Quantity::Strength)
}

pub(super) fn poisson_ratio() -> Value {
    measured(LaboratoryQuantity::PoissonRatio)
}

pub(super) fn modes() -> Value {
    let of = |key| match key {
        "share" => json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1 }),
        _ => json!({ "type": "number", "exclusiveMinimum": 0 }),
    };
    let mode = with_required(substrate::MODE_KEYS.map(|key| (key, of(key))), &substrate::MODE_KEYS);
    json!({ "type": "array", "items": mode })
}

pub(super) fn relaxation() -> Value {
    let of = |key| match key {
        "fraction" => json!({ "type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1 }),
        _ => above_0_or_text(),
    };
    let mut term = with_required(substrate::TERM_KEYS.map(|key| (key, of(key))), &["time"]);
    term["oneOf"] = json!([{ "required": ["modulus"] }, { "required": ["fraction"] }]);
    let text = json!({ "type": "string" });
    let file = with_required(named_series::FILE_KEYS.map(|key| (key, text.clone())), &["file"]);
    either([json!({ "type": "array", "items": term }), file])
}

pub(super) fn shift() -> Value {
    either(temperature::SHIFT_LAWS.map(|(law, own)| law_of_temperature(law, own)))
}

/// A law of the viscosity, or a table of it.
fn viscosity_law() -> Value {
    let laws = temperature::VISCOSITY_LAWS.map(|(law, own)| {
        let mut schema = law_of_temperature(law, own);
        schema["properties"]["value"] = above_0_or_text();
        schema["required"].as_array_mut().expect("a list").push(json!("value"));
        schema
    });
    let temperature = measured(LaboratoryQuantity::Temperature);
    let point = [("temperature", temperature), ("value", above_0_or_text())];
    let point = with_required(point, &["temperature", "value"]);
    let table = with_required([("table", json!({ "type": "array", "items": point, "minItems": 2 }))], &["table"]);
    either(laws.into_iter().chain([table]))
}

/// A law with a reference and keys of its own.
fn law_of_temperature(law: &str, own: &[&str]) -> Value {
    let of = |key: &str| match key {
        "c1" => json!({ "type": "number", "exclusiveMinimum": 0 }),
        _ => above_0_or_text(),
    };
    let common = [("law", json!({ "const": law })), ("reference", measured(LaboratoryQuantity::Temperature))];
    let keys = common.into_iter().chain(own.iter().map(|key| (*key, of(key))));
    let required: Vec<&str> = ["law", "reference"].into_iter().chain(own.iter().copied()).collect();
    with_required(keys, &required)
}

pub(super) fn method() -> Value {
    with_default(words(METHODS.map(|(name, _)| name)), json!(METHODS[0].0))
}

pub(super) fn tolerance() -> Value {
    with_default(within(&collocation::Settings::TOLERANCE), json!(SolverSettings::default().tolerance))
}

pub(super) fn time_limit() -> Value {
    let schema = json!({ "type": ["number", "null"], "exclusiveMinimum": 0 });
    with_default(schema, json!(SolverSettings::TIME_LIMIT))
}

pub(super) fn domain() -> Value {
    let (leftmost, rightmost) = Domain::ENDS.into_inner();
    let left = json!({ "type": "number", "minimum": leftmost, "exclusiveMaximum": 0 });
    let right = json!({ "type": "number", "exclusiveMinimum": 0, "maximum": rightmost });
    let ends = json!({ "type": "array", "items": [left, right], "minItems": 2, "maxItems": 2 });
    with_default(either([json!({ "const": "auto" }), ends]), json!("auto"))
}

pub(super) fn grid_points() -> Value {
    let mut schema = with_default(whole(&Settings::POINTS), json!(Settings::default().points));
    schema["not"] = json!({ "multipleOf": 2 });
    schema
}

pub(super) fn residual() -> Value {
    with_default(within(&Settings::TOLERANCE), json!(Settings::default().tolerance))
}

pub(super) fn acceleration() -> Value {
    with_default(words(ACCELERATIONS.map(|(name, _)| name)), json!(ACCELERATIONS[0].0))
}

pub(super) fn fields() -> Value {
    let names = Field::ALL.map(Field::name);
    json!({ "type": "array", "items": words(names), "uniqueItems": true, "default": names })
}

pub(super) fn field_precision() -> Value {
    with_default(words(output::FIELD_PRECISIONS.map(|(name, _)| name)), json!(output::FIELD_PRECISIONS[0].0))
}

pub(super) fn cavity_shear() -> Value {
    with_default(words(output::CAVITY_SHEARS.map(|(name, _)| name)), json!(output::CAVITY_SHEARS[0].0))
}

pub(super) fn surface_tolerance() -> Value {
    with_default(within(&TOLERANCE), json!(SurfaceSettings::default().tolerance))
}

pub(super) fn surface_quantities() -> Value {
    let names = Column::ALL.into_iter().filter(|column| is_function(*column)).map(Column::name);
    let default: Vec<&str> = SurfaceSettings::default().quantities.into_iter().map(Column::name).collect();
    json!({ "type": "array", "items": words(names), "minItems": 1, "default": default })
}

pub(super) fn surface_points() -> Value {
    with_default(whole(&POINTS), json!(SurfaceSettings::default().points))
}

pub(super) fn surface_seed() -> Value {
    with_default(whole(&SEED), json!(SurfaceSettings::default().seed))
}
