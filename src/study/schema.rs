//! The keys of a study file: what the reader knows, and what the JSON schema says of them.

use serde_json::{Map, Value, json};

use super::file::{LONGEST_LABEL, MOST_REPEATS};
use stribeck_solver::{collocation, relaxation};
use stribeck_sweep::section_schema;

/// A key of a table.
pub(super) struct Key {
    pub(super) name: &'static str,
    /// The values that it may have.
    shape: fn() -> Value,
    /// What it is, in words.
    meaning: &'static str,
}

const fn key(name: &'static str, shape: fn() -> Value, meaning: &'static str) -> Key {
    Key { name, shape, meaning }
}

/// The keys of the top level.
pub(super) const KEYS: [Key; 8] = [
    key("title", || text(500), "Title of the tables and pictures, in one line. Default: the file's name."),
    key("measure", measure, "What is measured: errors and times, how stable methods are, or both."),
    key("repeats", || whole(1..=MOST_REPEATS), "How often each case is timed. Default: 3."),
    key("start", || words(&["alone", "chain"]), "Whether each case starts alone, or from the one before it."),
    key("axes", axes, "A box of cases: the product of f, alpha and beta."),
    key("case", || list(table(&CASE_KEYS, &["alpha", "beta", "f"])), "Single cases."),
    key("substrate", || section_schema("substrate"), "What the substrate of all cases is made of."),
    key("method", || list(table(&METHOD_KEYS, &["method"])), "Methods, each with the settings that are varied."),
];

/// The keys of a case.
pub(super) const CASE_KEYS: [Key; 3] = [
    key("alpha", || json!({ "type": ["number", "null"], "minimum": 0 }), "Slide time over retardation time, or inf."),
    key("beta", || json!({ "type": "number", "exclusiveMinimum": 0 }), "Inverse Hersey number."),
    key("f", || json!({ "type": "number", "minimum": 0 }), "Strength of retardation E0/Einf - 1."),
];

/// The keys of a method.
pub(super) const METHOD_KEYS: [Key; 7] = [
    key("method", || words(&["collocation", "relaxation"]), "The method of solution."),
    key("label", || text(LONGEST_LABEL), "Its name in tables and pictures."),
    key("tolerance", tolerance, "With collocation the errors wanted; with relaxation the residual of convergence."),
    key("panels", || several(whole(collocation::Settings::PANELS)), "Numbers of panels, in place of a tolerance."),
    key("degree", || whole(collocation::Settings::DEGREE), "Degree of the panels of collocation."),
    key("points", points, "Numbers of grid points of relaxation, each odd."),
    key("acceleration", || words(&["anderson", "none"]), "How relaxation is sped up; none is the paper's iteration."),
];

/// The names of some keys.
pub(super) fn names<const N: usize>(keys: &[Key; N]) -> [&'static str; N] {
    std::array::from_fn(|place| keys[place].name)
}

/// The JSON schema (draft 7) of study files.
pub fn schema() -> Value {
    let mut schema = table(&KEYS, &["method"]);
    schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
    schema["title"] = json!("Study file of stribeck");
    schema["description"] = json!("Which cases are solved by which methods, and what is measured.");
    schema["anyOf"] = json!([{ "required": ["axes"] }, { "required": ["case"] }]);
    schema
}

/// A table with these keys and no others.
fn table(keys: &[Key], required: &[&str]) -> Value {
    let described = keys.iter().map(|Key { name, shape, meaning }| {
        let mut schema = shape();
        schema["description"] = json!(meaning);
        ((*name).to_owned(), schema)
    });
    let properties: Map<String, Value> = described.collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false, "required": required })
}

fn text(longest: usize) -> Value {
    json!({ "type": "string", "minLength": 1, "maxLength": longest, "pattern": "\\S" })
}

fn words(words: &[&str]) -> Value {
    json!({ "enum": words })
}

fn whole(range: std::ops::RangeInclusive<usize>) -> Value {
    json!({ "type": "integer", "minimum": range.start(), "maximum": range.end() })
}

fn list(item: Value) -> Value {
    json!({ "type": "array", "items": item })
}

/// A value, or a list of different ones.
fn several(value: Value) -> Value {
    let list = json!({ "type": "array", "items": value, "minItems": 1, "uniqueItems": true });
    json!({ "anyOf": [value, list] })
}

fn measure() -> Value {
    json!({ "type": "array", "items": words(&["error", "stability"]), "minItems": 1, "uniqueItems": true })
}

/// The axes of a sweep but the slide-to-sum ratio, with which no case changes.
fn axes() -> Value {
    let mut axes = section_schema("axes");
    axes["properties"].as_object_mut().expect("a section has keys").remove("slide_roll");
    axes
}

/// What is allowed depends on the method.
fn tolerance() -> Value {
    let (of_collocation, of_relaxation) = (collocation::Settings::TOLERANCE, relaxation::Settings::TOLERANCE);
    let least = of_collocation.start().min(*of_relaxation.start());
    let most = of_collocation.end().max(*of_relaxation.end());
    several(json!({ "type": "number", "minimum": least, "maximum": most }))
}

fn points() -> Value {
    let mut points = whole(relaxation::Settings::POINTS);
    points["not"] = json!({ "multipleOf": 2 });
    several(points)
}
