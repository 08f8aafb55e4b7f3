//! From the name of a column to a quantity and a unit.

use super::Heading;
use crate::{Conversion, Dimension};
use stribeck_input::printable;

/// A quantity that a column may hold.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its own name.
    pub name: &'static str,
    /// Other names, in lower case and with letters, digits, primes, `*` and `|` alone: `rollingspeed` stands for
    /// `Rolling Speed`, `rolling_speed` and so on.
    pub synonyms: &'static [&'static str],
    /// What it measures.
    pub measures: Measures,
}

/// What a quantity measures, and so the units that its column may have.
#[derive(Clone, Copy, Debug)]
pub enum Measures {
    /// One of these; numbers without a unit are in the SI unit of the first.
    Dimensions(&'static [Dimension]),
    /// A ratio; its unit may be `-`, `1` or `%`.
    Ratio,
}

/// How the numbers of a column become those of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unit {
    /// As it stands in the file, or the SI unit where none does.
    pub(super) text: String,
    /// True if the file names it.
    pub(super) is_given: bool,
    pub(super) dimension: Option<Dimension>,
    pub(super) conversion: Conversion,
}

/// A heading that is the name of a field.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Named {
    /// The place of the field in the list.
    pub(super) field: usize,
    /// True for the field's own name, to the letter.
    pub(super) is_own: bool,
    /// Its unit, or why the unit is none of the field.
    pub(super) unit: Result<Unit, String>,
}

impl Field {
    /// True for a name of this field.
    pub(super) fn is_called(&self, name: &str) -> bool {
        let name = squeezed(name);
        !name.is_empty() && (name == squeezed(self.name) || self.synonyms.contains(&name.as_str()))
    }

    /// The unit of a column of this field.
    ///
    /// # Errors
    /// Why it is none of this quantity.
    pub(super) fn unit(&self, unit: Option<&str>) -> Result<Unit, String> {
        let unit = unit.map(str::trim).filter(|unit| !unit.is_empty());
        let given = |dimension, conversion, text: &str| {
            Ok(Unit { text: text.to_owned(), is_given: true, dimension, conversion })
        };
        match (self.measures, unit) {
            (Measures::Ratio, None | Some("-" | "1" | "−" | "–")) => {
                Ok(Unit { text: String::new(), is_given: true, dimension: None, conversion: Conversion::NONE })
            }
            (Measures::Ratio, Some("%")) => given(None, Conversion::by(0.01), "%"),
            (Measures::Ratio, Some(_)) => Err("has no unit; leave it out".to_owned()),
            (Measures::Dimensions(dimensions), None) => Ok(Unit {
                text: dimensions[0].unit().to_owned(),
                is_given: false,
                dimension: Some(dimensions[0]),
                conversion: Conversion::NONE,
            }),
            (Measures::Dimensions(dimensions), Some(text)) => {
                let known = |unit: &str| {
                    dimensions.iter().find_map(|dimension| Some((*dimension, dimension.conversion(unit)?)))
                };
                match known(text).or_else(|| known(any_case(text)?)) {
                    Some((dimension, conversion)) => given(Some(dimension), conversion, text),
                    None => Err(no_such_unit(dimensions, text)),
                }
            }
        }
    }

    /// How much speaks for a column with this heading to hold the field; `None` if its unit speaks against it.
    pub(super) fn likeness(&self, heading: &str) -> Option<u8> {
        let (name, unit) = bracketed(heading).map_or((heading, None), |(name, unit)| (name, Some(unit)));
        if unit.is_some_and(|unit| !self.has_unit(unit)) {
            return None;
        }
        let name = squeezed(name);
        let begins = |known: &str| {
            let begin: String = known.chars().take(4).collect();
            !begin.is_empty() && (name.contains(&begin) || name == known)
        };
        let is_named = self.synonyms.iter().copied().chain([&*squeezed(self.name)]).any(begins);
        Some(2 * u8::from(is_named) + u8::from(unit.is_some()))
    }

    /// True for a unit that this field may have.
    fn has_unit(&self, unit: &str) -> bool {
        self.unit(Some(unit)).is_ok()
    }
}

/// Why a unit is none of these dimensions.
fn no_such_unit(dimensions: &[Dimension], unit: &str) -> String {
    let wanted: Vec<&str> = dimensions.iter().map(|dimension| dimension.unit()).collect();
    let wanted = wanted.join(" or ");
    match Dimension::of_unit(unit) {
        Some(other) => format!("is in {}: {}", printable(unit), dimensions[0].mismatch(other)),
        None => {
            format!("is in `{}`, no unit that is known here; write ({wanted}), or a unit of that kind", printable(unit))
        }
    }
}

/// A unit that people write in small letters where it has large ones.
fn any_case(unit: &str) -> Option<&'static str> {
    let known = ["Hz", "kHz", "Pa", "kPa", "MPa", "GPa", "N/m", "rad/s", "°C", "K", "s", "min"];
    known.into_iter().find(|known| known.to_lowercase() == unit.to_lowercase())
}

/// The field that a heading names, with its unit.
///
/// A unit stands in the line below, in brackets, behind a slash, ` in `, a comma, a blank or a low line. Where it is
/// not in brackets it must be a unit of the field.
pub(super) fn named(heading: &Heading, fields: &[Field]) -> Option<Named> {
    // names of two fields, as t of time and T of temperature, are told apart by their units
    let find = |name: &str, unit: Option<&str>| {
        let called = || (0..fields.len()).filter(|field| fields[*field].is_called(name));
        let unit = unit.or(heading.unit.as_deref());
        called().find(|field| fields[*field].unit(unit).is_ok()).or_else(|| called().next())
    };
    let text = heading.text.trim();
    let of = |field: usize, name: &str, unit: Option<&str>| Named {
        field,
        is_own: fields[field].name == name.trim(),
        unit: fields[field].unit(unit.or(heading.unit.as_deref())),
    };
    if let Some(field) = fields.iter().position(|field| field.name == text) {
        return Some(of(field, text, None));
    }
    let (slash, comma) = (text.split_once(" / ").or_else(|| text.split_once('/')), text.rsplit_once(','));
    let ways = [bracketed(text), slash, text.rsplit_once(" in "), comma, text.rsplit_once(' '), text.rsplit_once('_')];
    let known = |(name, unit): (&str, &str)| {
        let field = find(name, Some(unit)).filter(|field| fields[*field].has_unit(unit))?;
        Some(of(field, name, Some(unit)))
    };
    let unknown = || bracketed(text).and_then(|(name, unit)| Some(of(find(name, Some(unit))?, name, Some(unit))));
    let found = ways.into_iter().flatten().filter_map(known).next();
    found.or_else(|| find(text, None).map(|field| of(field, text, None))).or_else(unknown)
}

/// A name and the unit in brackets behind it.
pub(super) fn bracketed(text: &str) -> Option<(&str, &str)> {
    let open = match text.chars().last()? {
        ')' => '(',
        ']' => '[',
        _ => return None,
    };
    let (name, unit) = text[..text.len() - 1].rsplit_once(open)?;
    Some((name.trim_end(), unit.trim()))
}

/// A name in lower case, without what people put between its words.
pub(super) fn squeezed(name: &str) -> String {
    let one = |c: char| match c {
        '′' | '’' | '´' | '`' => Some('\''),
        '″' | '”' | '“' => Some('"'),
        _ if c.is_alphanumeric() || matches!(c, '\'' | '"' | '*' | '|' | '∞') => Some(c),
        _ => None,
    };
    let joined: String = name.chars().filter_map(one).flat_map(char::to_lowercase).collect();
    joined.replace("''", "\"").replace('μ', "µ")
}
