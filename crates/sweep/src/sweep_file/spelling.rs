//! Keys that no section has: each is told, and read as what it was meant to be. So the rest of the file is judged as if
//! it had been spelt well, and nothing is told as missing that stands there under another name.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::modulus::{self, Ambiguous};
use super::sections;
use stribeck_input::{Fault, nearest, unknown_key};

/// The keys that sections of a kind of file have; the section without a name is the top level.
#[derive(Clone, Copy, Debug)]
pub struct Keys {
    /// The keys of a section.
    pub of: fn(&str) -> Vec<&'static str>,
    /// Those of them that are sections, or lists of such, with the name of the section.
    pub within: fn(&str) -> Vec<(&'static str, &'static str)>,
    /// The section below the top level that knows a key.
    pub home: fn(&str) -> Option<&'static str>,
}

impl Keys {
    /// Those of a sweep file.
    pub(super) const OF_SWEEP: Self = Self { of: sections::keys, within: sections::within, home: sections::home };
}

/// The document of a file whose sections have known keys only.
pub struct Spelt<'t> {
    keys: Keys,
    /// The document.
    pub document: DeTable<'t>,
    /// The keys that it had beside.
    unknown: Option<Fault>,
    /// Where values stand of which nobody knows for certain what they are.
    guessed: Vec<Range<usize>>,
}

/// A value whose key belongs to another section.
struct Stray<'t> {
    home: &'static str,
    key: Spanned<DeString<'t>>,
    value: Spanned<DeValue<'t>>,
}

impl<'t> Spelt<'t> {
    /// Takes a document whose sections should have these keys.
    pub fn of(mut document: DeTable<'t>, keys: Keys) -> Self {
        let mut spelt = Self { keys, document: DeTable::new(), unknown: None, guessed: Vec::new() };
        let mut strays = Vec::new();
        spelt.mend("", &mut document, &mut strays);
        for Stray { home, key, value } in strays {
            // A sweep has one kind of axes: a key of the other kind alone makes it no sweep of that kind.
            let is_other_kind = home == "laboratory" && document.contains_key("axes");
            if is_other_kind && !document.contains_key(home) {
                continue;
            }
            let section = document
                .entry(Spanned::new(key.span(), home.into()))
                .or_insert_with(|| Spanned::new(key.span(), DeValue::Table(DeTable::new())));
            match section.get_mut() {
                DeValue::Table(section) if !section.contains_key(&key) => {
                    spelt.guessed.push(value.span());
                    section.insert(key, value);
                }
                _ => {}
            }
        }
        Self { document, ..spelt }
    }

    /// Leaves what stands at a place to the fault that it has already.
    pub(super) fn told(&mut self, fault: Fault, place: Range<usize>) {
        self.unknown = Fault::of_all(self.unknown.take().into_iter().chain([fault]));
        self.guessed.push(place);
    }

    /// Names the keys of a section and of those within it.
    fn mend(&mut self, section: &'static str, table: &mut DeTable<'t>, strays: &mut Vec<Stray<'t>>) {
        let Keys { of, within, home } = self.keys;
        let known = of(section);
        let is_known = |key: &Spanned<DeString<'t>>| known.contains(&key.get_ref().as_ref());
        let unknown: Vec<_> = table.keys().filter(|key| !is_known(key)).cloned().collect();
        for key in unknown {
            let value = table.remove(&key).expect("it is there");
            let (written, place) = (key.get_ref().as_ref(), key.span());
            let ambiguous = Ambiguous::of(section, written);
            let fault = match &ambiguous {
                Some(ambiguous) => ambiguous.fault(section, written, value.span()),
                None => unknown_key(section, written, place.clone(), &known, home),
            };
            self.unknown = Fault::of_all(self.unknown.take().into_iter().chain([fault]));
            let meant = match ambiguous {
                Some(ambiguous) => Some(ambiguous.meant).filter(|_| !has_modulus(table)),
                None => nearest(written, &known).filter(|meant| !table.contains_key(*meant)),
            };
            match (meant, home(written).filter(|home| of("").contains(home))) {
                (Some(meant), _) => {
                    if !value.get_ref().is_table() {
                        self.guessed.push(value.span());
                    }
                    table.insert(Spanned::new(place, Cow::Borrowed(meant)), value);
                }
                (None, Some(home)) => strays.push(Stray { home, key, value }),
                (None, None) => {}
            }
        }
        for (name, within) in within(section) {
            match table.get_mut(name).map(Spanned::get_mut) {
                Some(DeValue::Table(table)) => self.mend(within, table, strays),
                Some(DeValue::Array(items)) => {
                    for item in items.iter_mut() {
                        if let DeValue::Table(table) = item.get_mut() {
                            self.mend(within, table, strays);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// What was read of the document, or every fault of the file.
    ///
    /// # Errors
    /// The unknown keys, and what is wrong outside of the places that they leave open.
    pub fn judge<T>(self, read: Result<T, Fault>) -> Result<T, Fault> {
        match (self.unknown, read) {
            (None, read) => read,
            (Some(unknown), Ok(_)) => Err(unknown),
            (Some(unknown), Err(fault)) => {
                Err(fault.outside(&self.guessed).map_or(unknown.clone(), |fault| unknown.and(fault)))
            }
        }
    }
}

/// True for a section that says a modulus in its own words.
fn has_modulus(section: &DeTable<'_>) -> bool {
    modulus::KEYS.iter().any(|(key, ..)| section.contains_key(*key))
}
