//! Case ids.

use std::fmt;
use std::str::FromStr;

/// Names a problem and the way it is solved: cases with the same id have the same numbers.
///
/// It does not depend on the place in a sweep, so a case keeps its id when values are added to an axis. Written as
/// 16 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CaseId(pub u64);

impl CaseId {
    /// What it is, in words.
    pub const LONG_NAME: &'static str = "id of the case, as in summary.csv";
}

impl fmt::Display for CaseId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:016x}", self.0)
    }
}

/// A text that is not 16 hexadecimal digits.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a case id: 16 hexadecimal digits, as in the column `case` of summary.csv")]
pub struct NotACaseId(String);

impl FromStr for CaseId {
    type Err = NotACaseId;

    fn from_str(text: &str) -> Result<Self, NotACaseId> {
        let hexadecimal = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let id = if hexadecimal { u64::from_str_radix(text, 16).ok() } else { None };
        id.map(Self).ok_or_else(|| NotACaseId(text.to_owned()))
    }
}
