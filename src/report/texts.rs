//! Texts that come again and again, each kept once.

use std::collections::BTreeMap;

/// Different texts in the order in which they first come.
#[derive(Default)]
pub(super) struct Texts {
    pub(super) texts: Vec<String>,
    indices: BTreeMap<String, usize>,
}

impl Texts {
    /// Returns the index of a text, which is added if it is new.
    pub(super) fn index(&mut self, text: &str) -> usize {
        if let Some(index) = self.indices.get(text) {
            return *index;
        }
        self.indices.insert(text.to_owned(), self.texts.len());
        self.texts.push(text.to_owned());
        self.texts.len() - 1
    }

    /// True if the text is among them.
    pub(super) fn has(&self, text: &str) -> bool {
        self.indices.contains_key(text)
    }
}
