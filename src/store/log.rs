//! The log: one file per start, a record per line.

use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::directory::{files_in, synchronise_directory};
use super::record::Record;
use super::{StoreError, Warning};

/// Where a record stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LogPlace {
    /// Number of the log.
    pub log: u32,
    /// Bytes before its line.
    pub offset: u64,
}

/// The log of this start.
#[derive(Debug)]
pub(super) struct Log {
    file: File,
    path: PathBuf,
    number: u32,
    length: u64,
}

impl Log {
    /// A new log with the next number, which no other start has or gets.
    pub(super) fn create(logs: &Path) -> Result<Self, StoreError> {
        let number = log_numbers(logs)?.last().map_or(1, |last| last + 1);
        let path = log_path(logs, number);
        let created = OpenOptions::new().append(true).create_new(true).open(&path);
        let file = created.map_err(StoreError::file(&path, "create"))?;
        synchronise_directory(logs)?;
        Ok(Self { file, path, number, length: 0 })
    }

    /// Appends records, waits once until they are on the disk, and tells where each stands.
    ///
    /// After an error the file may end in half a line: do not append to it again.
    pub(super) fn append(&mut self, records: &[Record]) -> Result<Vec<LogPlace>, StoreError> {
        let (mut lines, mut places) = (String::new(), Vec::with_capacity(records.len()));
        for record in records {
            places.push(LogPlace { log: self.number, offset: self.length + lines.len() as u64 });
            lines += &record.line();
        }
        let written = self.file.write_all(lines.as_bytes()).and_then(|()| self.file.sync_data());
        written.map_err(StoreError::file(&self.path, "write"))?;
        self.length += lines.len() as u64;
        Ok(places)
    }
}

/// The file of a log: `0001.jsonl` and so on.
pub(super) fn log_path(logs: &Path, number: u32) -> PathBuf {
    logs.join(format!("{number:04}.jsonl"))
}

/// Numbers of the logs that are there, ascending.
pub(super) fn log_numbers(logs: &Path) -> Result<Vec<u32>, StoreError> {
    let number = |path: &PathBuf| path.file_name()?.to_str()?.strip_suffix(".jsonl")?.parse().ok();
    let mut numbers: Vec<u32> = files_in(logs)?.iter().filter_map(number).collect();
    numbers.sort_unstable();
    Ok(numbers)
}

/// Visits every valid record of every log, oldest first; lines that are none become warnings.
pub(super) fn read_logs(
    logs: &Path,
    warnings: &mut Vec<Warning>,
    mut visit: impl FnMut(LogPlace, Record),
) -> Result<(), StoreError> {
    for number in log_numbers(logs)? {
        let path = log_path(logs, number);
        let mut reader = BufReader::new(File::open(&path).map_err(StoreError::file(&path, "open"))?);
        let (mut line, mut count, mut offset) = (Vec::new(), 0, 0);
        loop {
            line.clear();
            let read = reader.read_until(b'\n', &mut line).map_err(StoreError::file(&path, "read"))?;
            if read == 0 {
                break;
            }
            count += 1;
            match Record::parse(line.strip_suffix(b"\n").unwrap_or(&line)) {
                Ok(record) => visit(LogPlace { log: number, offset }, record),
                Err(what) => warnings.push(Warning::Record { file: path.clone(), line: count, what }),
            }
            offset += read as u64;
        }
    }
    Ok(())
}

/// The record at a place.
pub(super) fn read_record(logs: &Path, place: LogPlace) -> Result<Record, StoreError> {
    let path = log_path(logs, place.log);
    let mut file = File::open(&path).map_err(StoreError::file(&path, "open"))?;
    file.seek(SeekFrom::Start(place.offset)).map_err(StoreError::file(&path, "read"))?;
    let mut line = Vec::new();
    BufReader::new(file).read_until(b'\n', &mut line).map_err(StoreError::file(&path, "read"))?;
    let record = Record::parse(line.strip_suffix(b"\n").unwrap_or(&line));
    record.map_err(|what| StoreError::Damaged { path, what: format!("at byte {}: {what}", place.offset) })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use proptest::prelude::*;

    use super::super::record::{CaseRecord, FileRecord, ShardRecord};
    use super::super::{Contents, Ending, Status};
    use super::*;
    use crate::model::CaseId;

    fn any_record() -> impl Strategy<Value = Record> {
        let seconds = prop_oneof![Just(0.0), 1e-300..1e300, 0.0..1e3];
        let status = prop_oneof![Just(Status::Converged), Just(Status::Failed)];
        let limit = prop::option::of(1e-3..1e6);
        let case = (any::<u64>(), status, ".*", seconds, any::<u64>(), any::<u64>(), ".*", limit).prop_map(
            |(id, status, reason, seconds, iterations, factorisations, seed, time_limit)| CaseRecord {
                case: CaseId(id),
                status,
                reason,
                seconds,
                iterations,
                factorisations,
                seed,
                time_limit,
            },
        );
        let shard = (".*", any::<u64>(), any::<u64>(), any::<bool>(), proptest::collection::vec(case, 0..4)).prop_map(
            |(name, bytes, x, limits, cases)| {
                let file = FileRecord { file: name, bytes, blake3: "00".repeat(32) };
                let contents = Contents { x, limits, ..Contents::default() };
                let recipe = if limits { serde_json::json!({ "tolerance": 1e-5 }) } else { serde_json::Value::Null };
                Record::Shard(ShardRecord::new(file, &contents, recipe, bytes / 2, cases))
            },
        );
        let start = (".*", ".*", any::<u64>(), any::<u64>(), any::<u64>())
            .prop_map(|(program, sweep, cases, threads, time)| Record::Start { program, sweep, cases, threads, time });
        let end = any::<u64>().prop_map(|time| Record::End { ending: Ending::Interrupted, time });
        prop_oneof![shard, start, end]
    }

    fn read(content: &[u8]) -> (Vec<Record>, Vec<Warning>) {
        let directory = tempfile::tempdir().unwrap();
        fs::write(log_path(directory.path(), 1), content).unwrap();
        let (mut records, mut warnings, mut places) = (Vec::new(), Vec::new(), Vec::new());
        read_logs(directory.path(), &mut warnings, |place, record| {
            records.push(record);
            places.push(place);
        })
        .unwrap();
        for (place, record) in places.into_iter().zip(&records) {
            assert_eq!(&read_record(directory.path(), place).unwrap(), record);
        }
        (records, warnings)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(128))]

        #[test]
        fn a_record_comes_back_as_it_was(record in any_record()) {
            let line = record.line();
            prop_assert_eq!(line.matches('\n').count(), 1);
            prop_assert_eq!(Record::parse(line.trim_end_matches('\n').as_bytes()), Ok(record));
        }

        #[test]
        fn any_bytes_are_read_without_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
            let (records, warnings) = read(&bytes);
            prop_assert!(records.is_empty(), "random bytes with a fitting checksum");
            prop_assert_eq!(warnings.is_empty(), bytes.is_empty());
        }

        #[test]
        fn a_changed_byte_never_passes(record in any_record(), place in any::<prop::sample::Index>(), flip in 1_u8..) {
            let mut line = record.line().into_bytes();
            line.pop();
            let place = place.index(line.len());
            let before = line[place];
            line[place] ^= flip;
            // Hexadecimal digits of the checksum mean the same in both cases.
            prop_assume!(!line[place].eq_ignore_ascii_case(&before));
            prop_assert!(Record::parse(&line).is_err());
        }

        #[test]
        fn records_survive_around_damage(
            records in proptest::collection::vec(any_record(), 1..6),
            junk in proptest::collection::vec(any::<u8>(), 0..60),
            place in any::<prop::sample::Index>(),
            torn in any::<prop::sample::Index>(),
        ) {
            let place = place.index(records.len());
            let last = records.last().unwrap().line();
            let mut content = Vec::new();
            for (i, record) in records.iter().enumerate() {
                if i == place {
                    content.extend(junk.iter().chain(b"\n"));
                }
                content.extend(record.line().bytes());
            }
            // Half of the last line once more, as a killed run leaves it.
            content.extend(&last.as_bytes()[..torn.index(last.len() - 2)]);
            let (found, warnings) = read(&content);
            prop_assert_eq!(found, records);
            prop_assert!(!warnings.is_empty());
        }
    }
}
