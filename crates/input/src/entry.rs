//! Keys and values of a file, read by type, that remember where they stand.

use std::ops::Range;
use std::rc::Rc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::Fault;

/// A table whose keys are all known.
pub struct Section<'t> {
    path: Rc<str>,
    span: Range<usize>,
    table: &'t DeTable<'t>,
}

/// A value, with the dotted path of its key for messages.
pub struct Entry<'t> {
    path: Rc<str>,
    span: Range<usize>,
    value: &'t DeValue<'t>,
}

impl<'t> Section<'t> {
    /// A table in which no key but the `known` ones stands. `elsewhere` names the section a key belongs to, for the
    /// remedy.
    pub fn new(
        path: &str,
        span: Range<usize>,
        table: &'t DeTable<'t>,
        known: &[&str],
        elsewhere: fn(&str) -> Option<&'static str>,
    ) -> Result<Self, Fault> {
        let unknown = table.keys().filter(|key| !known.contains(&key.get_ref().as_ref()));
        let faults = unknown.map(|key| unknown_key(path, key.get_ref(), key.span(), known, elsewhere));
        match Fault::of_all(faults) {
            Some(fault) => Err(fault),
            None => Ok(Self { path: path.into(), span, table }),
        }
    }

    /// The value of a key, if it is there.
    pub fn get(&self, key: &str) -> Option<Entry<'t>> {
        let (_, value) = self.table.iter().find(|(name, _)| name.get_ref() == key)?;
        let path = if self.path.is_empty() { key.into() } else { format!("{}.{key}", self.path).into() };
        Some(Entry { path, span: value.span(), value: value.get_ref() })
    }

    /// What `read` makes of the value of a key, if it is there.
    ///
    /// # Errors
    /// Those of `read`.
    pub fn optional<T>(
        &self,
        key: &str,
        read: impl FnOnce(&Entry<'t>) -> Result<T, Fault>,
    ) -> Result<Option<T>, Fault> {
        self.get(key).map(|entry| read(&entry)).transpose()
    }

    /// The value of a key that must be there; `help` is the line to add.
    pub fn require(&self, key: &str, help: &str) -> Result<Entry<'t>, Fault> {
        self.get(key).ok_or_else(|| {
            let place = if self.path.is_empty() { "the file".to_owned() } else { format!("[{}]", self.path) };
            let what = format!("{place} needs `{key}`, which is missing");
            self.fault(what, format!("`{key}` is missing"), help)
        })
    }

    /// The end of the last value in it.
    fn end(&self) -> usize {
        self.table.values().map(|value| value.span().end).max().unwrap_or(self.span.end)
    }

    /// A fault of the section as a whole.
    pub fn fault(&self, what: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Fault {
        Fault::new(self.span.clone(), what, label, help).unquoted().told_behind(self.end())
    }
}

impl<'t> Entry<'t> {
    /// Dotted path of the key, as in `solver.relaxation.points`.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Where the value stands in the text; of a section that has a header of its own, where that stands.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// A fault of this value: `what` says what is allowed.
    pub fn fault(&self, what: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Fault {
        Fault::new(self.span.clone(), what, label, help)
    }

    /// A fault of a number that is none of those `allowed`, with a remedy.
    pub fn not_allowed(&self, allowed: &str, remedy: &str) -> Fault {
        self.fault(format!("a value of `{}` must be {allowed}", self.path), "not allowed", remedy)
    }

    fn wrong_type(&self, wanted: &str, help: &str) -> Fault {
        let label = format!("{}, not {wanted}", kind(self.value));
        self.fault(format!("`{}` must be {wanted}", self.path), label, help)
    }

    /// A number, whole or not; NaN and infinities pass here.
    pub fn number(&self) -> Result<f64, Fault> {
        let too_large = || {
            let help = format!("write a number of at most {:e}", f64::MAX);
            self.fault(format!("`{}` must be a number of double precision", self.path), "too large", help)
        };
        match self.value {
            DeValue::Float(float) => match float.as_str().parse::<f64>() {
                Ok(value) if value.is_finite() || float.as_str().contains(['n', 'N']) => Ok(value + 0.0),
                _ => Err(too_large()),
            },
            DeValue::Integer(integer) if integer.radix() == 10 => {
                integer.as_str().parse::<f64>().map(|value| value + 0.0).map_err(|_| too_large())
            }
            DeValue::Integer(integer) => u64::from_str_radix(integer.as_str(), integer.radix())
                .map(|value| value as f64)
                .map_err(|_| too_large()),
            _ => Err(self.wrong_type("a number", "write a plain number without quotes, as in 1e-3 or 100")),
        }
    }

    /// A whole number within `range`.
    pub fn whole(&self, range: std::ops::RangeInclusive<usize>) -> Result<usize, Fault> {
        let wanted = format!("a whole number from {} to {}", range.start(), range.end());
        let DeValue::Integer(integer) = self.value else {
            return Err(self.wrong_type(&wanted, "write it without quotes and without a decimal point, as in 401"));
        };
        let value = usize::from_str_radix(integer.as_str(), integer.radix()).ok();
        value.filter(|value| range.contains(value)).ok_or_else(|| {
            let help = format!("write {wanted}");
            self.fault(format!("`{}` must be {wanted}", self.path), "out of range", help)
        })
    }

    /// A text.
    pub fn text(&self) -> Result<&'t str, Fault> {
        match self.value {
            DeValue::String(text) => Ok(text),
            _ => Err(self.wrong_type("a text", "put the text in double quotes")),
        }
    }

    /// True or false.
    pub fn boolean(&self) -> Result<bool, Fault> {
        match self.value {
            DeValue::Boolean(value) => Ok(*value),
            _ => Err(self.wrong_type("true or false", "write true or false, without quotes")),
        }
    }

    /// One of several words, each with what it stands for.
    pub fn choice<T: Copy>(&self, choices: &[(&str, T)]) -> Result<T, Fault> {
        let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let wanted = one_of(&names);
        let DeValue::String(word) = self.value else {
            return Err(self.wrong_type(&wanted, &format!("write {wanted}, in double quotes")));
        };
        let found = choices.iter().find(|(name, _)| name == word);
        found.map(|(_, value)| *value).ok_or_else(|| {
            let help = match nearest(word, &names) {
                Some(name) => format!("did you mean \"{name}\"?"),
                None => format!("write {wanted}"),
            };
            self.fault(format!("`{}` must be {wanted}", self.path), "not one of them", help)
        })
    }

    /// The entries of a list, or `None` if the value is not one.
    pub fn list(&self) -> Option<impl ExactSizeIterator<Item = Entry<'t>>> {
        let DeValue::Array(items) = self.value else { return None };
        let item = |item: &'t Spanned<DeValue<'t>>| Entry {
            path: Rc::clone(&self.path),
            span: item.span(),
            value: item.get_ref(),
        };
        Some(items.iter().map(item))
    }

    /// The entries of a list; `help` shows how one is written.
    pub fn require_list(&self, help: &str) -> Result<impl ExactSizeIterator<Item = Entry<'t>>, Fault> {
        self.list().ok_or_else(|| self.wrong_type("a list", help))
    }

    /// True if the value is a text.
    pub fn is_text(&self) -> bool {
        matches!(self.value, DeValue::String(_))
    }

    /// True if the value is a number.
    pub fn is_number(&self) -> bool {
        matches!(self.value, DeValue::Float(_) | DeValue::Integer(_))
    }

    /// True if the value is a table.
    pub fn is_section(&self) -> bool {
        matches!(self.value, DeValue::Table(_))
    }

    /// The value of a key, known or not, if this is a table with such a key.
    pub fn member(&self, key: &str) -> Option<Entry<'t>> {
        let DeValue::Table(table) = self.value else { return None };
        Section { path: Rc::clone(&self.path), span: self.span.clone(), table }.get(key)
    }

    /// A table in which no key but the `known` ones stands.
    pub fn section(&self, known: &[&str], elsewhere: fn(&str) -> Option<&'static str>) -> Result<Section<'t>, Fault> {
        match self.value {
            DeValue::Table(table) => Section::new(&self.path, self.span.clone(), table, known, elsewhere),
            _ => {
                let help = format!("a table has the keys {}", quoted_list(known));
                Err(self.wrong_type("a table", &help))
            }
        }
    }
}

/// The fault of a key that no table at `path` has; `elsewhere` names the section it belongs to, for the remedy.
pub fn unknown_key(
    path: &str,
    key: &str,
    span: Range<usize>,
    known: &[&str],
    elsewhere: fn(&str) -> Option<&'static str>,
) -> Fault {
    let place = if path.is_empty() { "the top level".to_owned() } else { format!("[{path}]") };
    let (written, list) = (key.escape_debug(), quoted_list(known));
    let help = match (nearest(key, known), elsewhere(key)) {
        (Some(known), _) => format!("did you mean `{known}`?"),
        (None, Some(home)) => format!("`{written}` is a key of [{home}]: move it there"),
        (None, None) => format!("remove the key, or write one of {list}"),
    };
    let what = format!("`{written}` is not a key of {place}, which has {list}");
    Fault::new(span, what, "unknown key", help).unquoted()
}

/// What a value is, in words.
fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

fn quoted_list(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}

/// `"a"`, `"b"` or `"c"`.
fn one_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

/// The known word that was begun, or the nearest one if it shares at least half of its letters with what was written.
pub fn nearest<'k>(written: &str, known: &[&'k str]) -> Option<&'k str> {
    if written.len() > 100 {
        return None;
    }
    let written = written.to_lowercase().replace(['-', ' '], "_");
    if let Some(word) = known.iter().find(|word| written.len() > 1 && word.starts_with(&written)) {
        return Some(word);
    }
    let distances = known.iter().map(|word| (strsim::levenshtein(&written, word), *word));
    let (distance, word) = distances.min_by_key(|(distance, _)| *distance)?;
    (2 * distance <= word.len()).then_some(word)
}
