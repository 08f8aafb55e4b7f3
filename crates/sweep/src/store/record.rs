//! One line of a log: a record with a checksum.
//!
//! A line is `{"crc":"xxxxxxxx","record":{…}}`, where `xxxxxxxx` is the CRC-32 (IEEE) of the text of the record in
//! eight hexadecimal digits. Any JSON reader can read it; whoever wants to check it takes the text between `"record":`
//! and the last brace.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::contents::columns_key;
use super::{CaseEntry, Contents, Status, Timing};
use crate::{CaseId, Field, FieldPrecision};
use stribeck_input::printable;
use stribeck_solver::continuation::kind_name_of_text;

/// What a log line says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum Record {
    /// A run began.
    Start {
        program: String,
        #[serde(default)]
        sweep: String,
        cases: u64,
        threads: u64,
        time: u64,
    },
    /// Cases were committed.
    Shard(ShardRecord),
    /// The files for the user were put in place.
    Published { key: String, files: Vec<FileRecord>, time: u64 },
    /// A run ended by itself.
    End { ending: Ending, time: u64 },
}

/// How the text of a [`Record::Shard`] begins.
const SHARD: &[u8] = br#"{"kind":"shard","#;

/// How a run ended. One that was killed says nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Ending {
    /// All cases are done.
    Completed,
    /// The user stopped it.
    Interrupted,
}

/// A shard and its cases.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct ShardRecord {
    #[serde(flatten)]
    pub file: FileRecord,
    pub fields: Vec<String>,
    pub x: String,
    /// True if the fields are rounded to single precision. Not written where it is false, as in records of earlier
    /// versions.
    #[serde(default, skip_serializing_if = "is_false")]
    pub single: bool,
    pub limits: bool,
    /// Not written where it is false, as in records of earlier versions.
    #[serde(default, skip_serializing_if = "is_false")]
    pub sensitivities: bool,
    /// Hash of the names of the columns; that of this version where it is missing.
    #[serde(default = "these_columns")]
    pub columns: String,
    /// What the cases were solved with; null if that is not known.
    #[serde(default, skip_serializing_if = "Value::is_null")]
    pub recipe: Value,
    pub time: u64,
    pub cases: Vec<CaseRecord>,
}

fn these_columns() -> String {
    hexadecimal(columns_key())
}

fn is_false(value: &bool) -> bool {
    !value
}

fn hexadecimal(key: u64) -> String {
    format!("{key:016x}")
}

/// A file as it was written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct FileRecord {
    pub file: String,
    pub bytes: u64,
    pub blake3: String,
}

/// A case of a shard, in the shard's order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct CaseRecord {
    #[serde(with = "case_id")]
    pub case: CaseId,
    pub status: Status,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
    /// Records of earlier versions have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure_kind: Option<String>,
    pub seconds: f64,
    pub iterations: u64,
    pub factorisations: u64,
    pub seed: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_limit: Option<f64>,
}

impl CaseRecord {
    /// What is said of a case that nobody has solved.
    pub(super) fn unsolved(case: CaseId) -> Self {
        let (reason, seed) = (String::new(), String::new());
        let (failure_kind, time_limit) = (None, None);
        let (seconds, iterations, factorisations, status) = (0.0, 0, 0, Status::Failed);
        Self { case, status, reason, failure_kind, seconds, iterations, factorisations, seed, time_limit }
    }

    pub(super) fn of(entry: &CaseEntry) -> Self {
        let Timing { seconds, iterations, factorisations, seed, time_limit } = entry.timing;
        let seed = seed.map_or_else(String::new, |seed| seed.to_string());
        let (case, status, reason) = (entry.id, entry.outcome, entry.reason.clone());
        let failure_kind = entry.failure_kind.clone();
        Self { case, status, reason, failure_kind, seconds, iterations, factorisations, seed, time_limit }
    }

    /// The name of the kind of failure, which a record of an earlier version tells by its reason alone; `None` if the
    /// case converged.
    pub(super) fn failure_kind(&self) -> Option<&str> {
        match self.status {
            Status::Converged => None,
            Status::Failed => Some(self.failure_kind.as_deref().unwrap_or_else(|| kind_name_of_text(&self.reason))),
        }
    }

    pub(super) fn timing(&self) -> Timing {
        let Self { seconds, iterations, factorisations, time_limit, .. } = *self;
        Timing { seconds, iterations, factorisations, seed: self.seed.parse().ok(), time_limit }
    }
}

impl ShardRecord {
    pub(super) fn new(file: FileRecord, contents: &Contents, recipe: Value, time: u64, cases: Vec<CaseRecord>) -> Self {
        let &Contents { fields, x, field_precision, limits, sensitivities, columns } = contents;
        let fields = Field::selected(fields).map(|field| field.name().to_owned()).collect();
        let (x, columns) = (hexadecimal(x), hexadecimal(columns));
        let single = field_precision == FieldPrecision::Single;
        Self { file, fields, x, single, limits, sensitivities, columns, recipe, time, cases }
    }

    /// What the shard holds; `None` if the record names a field unknown to this version.
    pub(super) fn contents(&self) -> Option<Contents> {
        let fields = self.fields.iter().map(|name| Field::named(name)).collect::<Option<Vec<_>>>()?;
        let x = u64::from_str_radix(&self.x, 16).ok()?;
        let columns = u64::from_str_radix(&self.columns, 16).ok()?;
        Some(Contents {
            fields: Field::selection(fields),
            x,
            field_precision: if self.single { FieldPrecision::Single } else { FieldPrecision::Double },
            limits: self.limits,
            sensitivities: self.sensitivities,
            columns,
        })
    }
}

impl Record {
    /// The line of this record, line feed included.
    pub(super) fn line(&self) -> String {
        let text = serde_json::to_string(self).expect("a record is made of strings and finite numbers");
        format!("{{\"crc\":\"{:08x}\",\"record\":{text}}}\n", crc32fast::hash(text.as_bytes()))
    }

    /// The record of a line (without its line feed), or what is wrong with it.
    pub(super) fn parse(line: &[u8]) -> Result<Self, String> {
        let (checksum, text) = unframe(line).ok_or("not a whole record")?;
        if crc32fast::hash(text) != checksum {
            return Err("the checksum does not fit".to_owned());
        }
        // A tagged enum is read into a tree first, which takes twice as long. Logs are made of shards, so these are
        // read as what they are.
        let record = match text.starts_with(SHARD) {
            true => serde_json::from_slice(text).map(Self::Shard),
            false => serde_json::from_slice(text),
        };
        record
            .map_err(|error| format!("a record of another version of the program ({})", printable(&error.to_string())))
    }
}

/// Checksum and text of the record in a line.
fn unframe(line: &[u8]) -> Option<(u32, &[u8])> {
    let rest = line.strip_prefix(b"{\"crc\":\"")?;
    let (checksum, rest) = rest.split_at_checked(8)?;
    if !checksum.iter().all(u8::is_ascii_hexdigit) {
        return None;
    }
    let checksum = u32::from_str_radix(std::str::from_utf8(checksum).ok()?, 16).ok()?;
    let text = rest.strip_prefix(b"\",\"record\":")?.strip_suffix(b"}")?;
    Some((checksum, text))
}

/// Case ids as their 16 digits.
mod case_id {
    use super::CaseId;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(id: &CaseId, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(id)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<CaseId, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A record without sensitivities and rounding is that of an earlier version, to the letter.
    #[test]
    fn sensitivities_and_rounding_are_named_where_they_are() {
        let file = FileRecord { file: "a.h5".into(), bytes: 1, blake3: "00".repeat(32) };
        for (sensitivities, field_precision) in
            [(false, FieldPrecision::Double), (true, FieldPrecision::Double), (false, FieldPrecision::Single)]
        {
            let contents = Contents { sensitivities, field_precision, ..Contents::default() };
            let record = Record::Shard(ShardRecord::new(file.clone(), &contents, Value::Null, 0, Vec::new()));
            let line = record.line();
            assert_eq!(line.contains("sensitivities"), sensitivities, "{line}");
            assert_eq!(line.contains("single"), field_precision == FieldPrecision::Single, "{line}");
            let Ok(Record::Shard(read)) = Record::parse(line.trim_end().as_bytes()) else { panic!("{line}") };
            assert_eq!(read.contents(), Some(contents));
        }
    }

    /// An earlier version recorded the reason of a failure alone; its kind is told by the reason.
    #[test]
    fn a_failure_of_an_earlier_version_has_a_kind() {
        let read = |more: &str| -> CaseRecord {
            let text = r#"{"case":"00000000000000aa","status":"failed","reason":"the iteration stalls: 900 passes","#;
            let rest = r#""seconds":1.0,"iterations":1,"factorisations":1,"seed":"hertz"}"#;
            serde_json::from_str(&format!("{text}{more}{rest}")).expect("a record")
        };
        assert_eq!(read("").failure_kind(), Some("stalled"));
        assert_eq!(read(r#""failure_kind":"diverged","#).failure_kind(), Some("diverged"));
        assert_eq!(CaseRecord { status: Status::Converged, ..read("") }.failure_kind(), None);
    }
}
