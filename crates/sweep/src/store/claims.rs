//! Claims: the shards and published files that the logs of a directory name, and how a file is compared with its
//! record.

use std::collections::HashMap;
use std::path::Path;

use super::directory::{Directory, PUBLISHED};
use super::files::hash_file;
use super::log::{LogPlace, read_logs, read_record};
use super::record::{FileRecord, Record, ShardRecord};
use super::shard::{SHARD_DIGITS, ShardReader};
use super::{Contents, History, StoreError, Warning};

/// The newest record of published files.
#[derive(Clone, Debug)]
pub(super) struct LastPublished {
    pub key: String,
    pub files: Vec<FileRecord>,
}

/// How closely shards are compared with their records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inspection {
    /// By their size: finds what is missing or cut short, and takes no time.
    Size,
    /// By every byte, as a run does before it uses them.
    Bytes,
}

/// The newest record of a shard, before the shard is looked at.
pub(super) struct Claim {
    pub file: FileRecord,
    pub contents: Contents,
    pub place: LogPlace,
    pub cases: usize,
}

/// Opens a shard and compares its cases with its record.
///
/// Its checksum comes first: the HDF5 library gets only bytes that this program has written, for it is not made for
/// others.
pub(super) fn open_checked(path: &Path, record: &ShardRecord) -> Result<ShardReader, StoreError> {
    let damaged = |what: &str| StoreError::Damaged { path: path.to_owned(), what: what.to_owned() };
    if let Some(what) = fault(path, &record.file, Inspection::Bytes) {
        return Err(damaged(&what));
    }
    let contents = record.contents().ok_or_else(|| damaged("its record names an unknown field"))?;
    let reader = ShardReader::open(path, &contents)?;
    if !reader.ids().iter().eq(record.cases.iter().map(|case| &case.case)) {
        return Err(damaged("its cases are not those of its record"));
    }
    if !record.cases.iter().enumerate().all(|(row, case)| reader.status(row) == case.status) {
        return Err(damaged("its cases do not have the status of its record"));
    }
    Ok(reader)
}

pub(super) fn shard_record(directory: &Directory, place: LogPlace) -> Result<ShardRecord, StoreError> {
    match read_record(&directory.logs(), place)? {
        Record::Shard(record) => Ok(record),
        _ => {
            let what = format!("log {} holds no shard at byte {}", place.log, place.offset);
            Err(StoreError::Damaged { path: directory.logs(), what })
        }
    }
}

/// What the logs of a directory say.
pub(super) struct LogContent {
    pub warnings: Vec<Warning>,
    pub history: History,
    pub published: Option<LastPublished>,
    /// The newest claim on each shard, in the order of the log.
    pub claims: Vec<Claim>,
}

pub(super) fn read_claims(directory: &Directory) -> Result<LogContent, StoreError> {
    let (mut warnings, mut history, mut published) = (Vec::new(), History::default(), None);
    let mut claims: HashMap<String, Claim> = HashMap::new();
    let mut unknown = Vec::new();
    read_logs(&directory.logs(), &mut warnings, |place, record| {
        history.note(place.log, &record);
        match record {
            Record::Shard(record) => match claim(record, place) {
                Ok(claim) => drop(claims.insert(claim.file.file.clone(), claim)),
                Err(warning) => unknown.push(warning),
            },
            Record::Published { key, files, .. } => published = last_published(key, files),
            Record::Start { .. } | Record::End { .. } => {}
        }
    })?;
    for (name, cases) in unknown {
        let what = "its record is of another version of the program".to_owned();
        warnings.push(Warning::Shard { file: directory.shards().join(name), what, cases });
    }
    let mut claims: Vec<Claim> = claims.into_values().collect();
    claims.sort_by_key(|claim| (claim.place.log, claim.place.offset));
    Ok(LogContent { warnings, history, published, claims })
}

/// What was published; `None` if the record is not of the files that this version publishes, which are then missing.
fn last_published(key: String, files: Vec<FileRecord>) -> Option<LastPublished> {
    let ours = files.iter().map(|file| file.file.as_str()).eq(PUBLISHED);
    ours.then_some(LastPublished { key, files })
}

/// The claim of a record; name and number of cases if it is none that this version could have written.
fn claim(record: ShardRecord, place: LogPlace) -> Result<Claim, (String, usize)> {
    let cases = record.cases.len();
    let stem = record.file.file.strip_suffix(".h5").unwrap_or_default();
    let plain_name = stem.len() == SHARD_DIGITS && stem.bytes().all(|byte| byte.is_ascii_hexdigit());
    let hash_is_sound = record.file.blake3.parse::<blake3::Hash>().is_ok();
    match record.contents() {
        Some(contents) if plain_name && hash_is_sound && u16::try_from(cases).is_ok() => {
            Ok(Claim { file: record.file, contents, place, cases })
        }
        _ => Err((record.file.file, cases)),
    }
}

/// What is wrong with a file, measured by its record; `None` if nothing is. A file that cannot be read is as good as
/// damaged.
pub(super) fn fault(path: &Path, record: &FileRecord, inspection: Inspection) -> Option<String> {
    let bytes = match path.metadata() {
        Ok(metadata) if !metadata.is_file() => return Some("it is no file".to_owned()),
        Ok(metadata) => metadata.len(),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Some("the file is missing".to_owned()),
        Err(error) => return Some(format!("it cannot be read: {error}")),
    };
    if bytes != record.bytes {
        return Some(format!("it has {bytes} bytes, its record says {}", record.bytes));
    }
    if inspection == Inspection::Size {
        return None;
    }
    match hash_file(path) {
        Ok((_, hash)) if hash.to_hex().as_str() == record.blake3 => None,
        Ok(_) => Some("its checksum is not the one of its record".to_owned()),
        Err(StoreError::File { source, .. }) => Some(format!("it cannot be read: {source}")),
        Err(error) => Some(error.to_string()),
    }
}
