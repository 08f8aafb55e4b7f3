//! A setting that a method cannot be used with.

use std::fmt::{Debug, Display};
use std::ops::RangeInclusive;

/// A setting of a method beyond the range in which it can be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{setting} = {value} is no setting of the {method} method: it must be {allowed}")]
pub struct SettingOutOfRange {
    /// The method, in words.
    pub method: &'static str,
    /// The name of the setting.
    pub setting: &'static str,
    /// Its value.
    pub value: String,
    /// The values that it may have, in words.
    pub allowed: String,
}

impl SettingOutOfRange {
    /// Checks that a setting of a method is in its range.
    ///
    /// # Errors
    /// [`SettingOutOfRange`] if it is not.
    pub(crate) fn check<T: PartialOrd + Debug + Display>(
        method: &'static str,
        setting: &'static str,
        value: T,
        range: &RangeInclusive<T>,
    ) -> Result<(), Self> {
        match range.contains(&value) {
            true => Ok(()),
            false => {
                let allowed = format!("from {:?} to {:?}", range.start(), range.end());
                Err(Self { method, setting, value: format!("{value:?}"), allowed })
            }
        }
    }
}
