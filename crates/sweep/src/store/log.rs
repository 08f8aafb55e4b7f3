//! The log: one file per start, a record per line.

use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::files::{files_in, open_file, synchronise_directory};
use super::record::Record;
use super::{StoreError, Warning};

/// Longest line of a log, its line feed included: 4 kB for each case of the largest commit. A longer one is no record,
/// and is not kept in memory.
const LONGEST_LINE: u64 = 16 << 20;

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
        let number = log_numbers(logs)?.last().map_or(1, |last| last.saturating_add(1));
        let path = log_path(logs, number);
        let created = OpenOptions::new().append(true).create_new(true).open(&path);
        let file = created.map_err(StoreError::file(&path, "create"))?;
        synchronise_directory(logs)?;
        Ok(Self { file, path, number, length: 0 })
    }

    /// Appends records, waits once until they are on the disk, and tells where each stands.
    ///
    /// After an error nothing of them counts. The file may end in half a line: do not append to it again.
    pub(super) fn append(&mut self, records: &[Record]) -> Result<Vec<LogPlace>, StoreError> {
        let (mut lines, mut places) = (String::new(), Vec::with_capacity(records.len()));
        for record in records {
            let line = record.line();
            if line.len() as u64 > LONGEST_LINE {
                let what = format!("the record has {} bytes, and a line at most {LONGEST_LINE}", line.len());
                return Err(StoreError::file(&self.path, "write")(io::Error::new(io::ErrorKind::InvalidInput, what)));
            }
            places.push(LogPlace { log: self.number, offset: self.length + lines.len() as u64 });
            lines += &line;
        }
        let written = self.file.write_all(lines.as_bytes()).and_then(|()| self.file.sync_data());
        // What did not reach the disk is not committed: the next start is not to find it in the memory of the system.
        // If it cannot be taken back, that start brings it to the disk (`synchronise_logs`).
        written.map_err(|error| {
            let _ = self.file.set_len(self.length);
            StoreError::file(&self.path, "write")(error)
        })?;
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
    let number = |path: &PathBuf| {
        let number = path.file_name()?.to_str()?.strip_suffix(".jsonl")?.parse().ok()?;
        (log_path(logs, number) == *path).then_some(number)
    };
    let mut numbers: Vec<u32> = files_in(logs)?.iter().filter_map(number).collect();
    numbers.sort_unstable();
    Ok(numbers)
}

/// Waits until all logs are on the disk: a start that was killed may have written records that it did not wait for.
///
/// A log that cannot be opened is left to [`read_logs`], which tells of it.
pub(super) fn synchronise_logs(logs: &Path) -> Result<(), StoreError> {
    for number in log_numbers(logs)? {
        let path = log_path(logs, number);
        if let Ok(file) = open_file(&path) {
            file.sync_data().map_err(StoreError::file(&path, "write"))?;
        }
    }
    Ok(())
}

/// Visits every valid record of every log, oldest first; lines that are none become warnings, and so does the rest of
/// a log that cannot be read.
pub(super) fn read_logs(
    logs: &Path,
    warnings: &mut Vec<Warning>,
    mut visit: impl FnMut(LogPlace, Record),
) -> Result<(), StoreError> {
    for number in log_numbers(logs)? {
        let path = log_path(logs, number);
        let unreadable =
            |line: u64, error: &io::Error| Warning::Unreadable { file: path.clone(), line, what: error.to_string() };
        let mut reader = match open_file(&path) {
            Ok(file) => BufReader::new(file),
            Err(error) => {
                warnings.push(unreadable(1, &error));
                continue;
            }
        };
        let (mut buffer, mut line, mut offset) = (Vec::new(), 0, 0);
        // The damaged lines before this one: told together, as there can be millions.
        let mut damage: Option<Warning> = None;
        loop {
            line += 1;
            let (bytes, record) = match next_line(&mut reader, &mut buffer) {
                Ok(Some(read)) => read,
                Ok(None) => break,
                Err(error) => {
                    warnings.extend(damage.take());
                    warnings.push(unreadable(line, &error));
                    break;
                }
            };
            match (record, &mut damage) {
                (Ok(record), _) => {
                    warnings.extend(damage.take());
                    visit(LogPlace { log: number, offset }, record);
                }
                (Err(_), Some(Warning::Record { more, .. })) => *more += 1,
                (Err(what), _) => damage = Some(Warning::Record { file: path.clone(), line, more: 0, what }),
            }
            offset += bytes;
        }
        warnings.extend(damage);
    }
    Ok(())
}

/// The next line: how many bytes it has, and its record or what is wrong with it. `None` at the end.
fn next_line(reader: &mut impl BufRead, buffer: &mut Vec<u8>) -> io::Result<Option<(u64, Result<Record, String>)>> {
    buffer.clear();
    let mut bytes = reader.by_ref().take(LONGEST_LINE).read_until(b'\n', buffer)? as u64;
    if bytes == 0 {
        return Ok(None);
    }
    let record = match buffer.strip_suffix(b"\n") {
        Some(line) => Record::parse(line),
        None if bytes < LONGEST_LINE => Record::parse(buffer),
        None => {
            bytes += reader.skip_until(b'\n')? as u64;
            Err(format!("it has {bytes} bytes, more than any record"))
        }
    };
    Ok(Some((bytes, record)))
}

/// The record at a place.
pub(super) fn read_record(logs: &Path, place: LogPlace) -> Result<Record, StoreError> {
    let path = log_path(logs, place.log);
    let mut file = open_file(&path).map_err(StoreError::file(&path, "open"))?;
    file.seek(SeekFrom::Start(place.offset)).map_err(StoreError::file(&path, "read"))?;
    let line = next_line(&mut BufReader::new(file), &mut Vec::new()).map_err(StoreError::file(&path, "read"))?;
    let record = line.map_or_else(|| Err("there is nothing".to_owned()), |(_, record)| record);
    record.map_err(|what| StoreError::Damaged { path, what: format!("at byte {}: {what}", place.offset) })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use proptest::prelude::*;

    use super::super::record::{CaseRecord, FileRecord, ShardRecord};
    use super::super::{Contents, Ending, Status};
    use super::*;
    use crate::CaseId;

    fn any_record() -> impl Strategy<Value = Record> {
        let seconds = prop_oneof![Just(0.0), 1e-300..1e300, 0.0..1e3];
        let status = prop_oneof![Just(Status::Converged), Just(Status::Failed)];
        let limit = prop::option::of(1e-3..1e6);
        let kind = prop::option::of(".*");
        let case = (any::<u64>(), status, (".*", kind), seconds, any::<u64>(), any::<u64>(), ".*", limit).prop_map(
            |(id, status, (reason, failure_kind), seconds, iterations, factorisations, seed, time_limit)| CaseRecord {
                case: CaseId(id),
                status,
                reason,
                failure_kind,
                seconds,
                iterations,
                factorisations,
                seed,
                time_limit,
            },
        );
        let flags = any::<[bool; 2]>();
        let shard = (".*", any::<u64>(), any::<u64>(), flags, proptest::collection::vec(case, 0..4)).prop_map(
            |(name, bytes, x, [limits, sensitivities], cases)| {
                let file = FileRecord { file: name, bytes, blake3: "00".repeat(32) };
                let contents = Contents { x, limits, sensitivities, ..Contents::default() };
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
        read_directory(&directory)
    }

    fn read_directory(directory: &tempfile::TempDir) -> (Vec<Record>, Vec<Warning>) {
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

    /// Numbers of the lines that the warnings are of.
    fn warned(warnings: &[Warning]) -> Vec<u64> {
        let lines = |warning: &Warning| match *warning {
            Warning::Record { line, more, .. } => line..=line + more,
            Warning::Shard { .. } | Warning::NoLock { .. } | Warning::Unreadable { .. } => panic!("{warning}"),
        };
        warnings.iter().flat_map(lines).collect()
    }

    /// A line that is no record, as editors, tools and disks make them. Without line feed.
    fn damaged_line() -> impl Strategy<Value = Vec<u8>> {
        let damaged = |damage: fn(&mut Vec<u8>)| {
            any_record().prop_map(move |record| {
                let mut line = record.line().into_bytes();
                line.pop();
                damage(&mut line);
                line
            })
        };
        prop_oneof![
            Just(Vec::new()),
            prop::collection::vec(any::<u8>().prop_filter("no line feed", |byte| *byte != b'\n'), 0..40),
            (1..5000_usize).prop_map(|length| vec![0; length]),
            damaged(|line| line.push(b'\r')),
            damaged(|line| line.insert(0, 0)),
            damaged(|line| line.truncate(line.len() / 2)),
            damaged(|line| line.extend_from_within(..)),
        ]
    }

    #[test]
    fn a_line_without_end_is_told_and_not_kept() {
        let directory = tempfile::tempdir().unwrap();
        let end = Record::End { ending: Ending::Completed, time: 5 };
        let before = end.line();
        let path = log_path(directory.path(), 1);
        fs::write(&path, &before).unwrap();
        // 100 MB of zeros, which take no place on the disk.
        let mut file = OpenOptions::new().append(true).open(&path).unwrap();
        file.set_len(before.len() as u64 + 100_000_000).unwrap();
        file.write_all(format!("\n{before}").as_bytes()).unwrap();
        let (records, warnings) = read_directory(&directory);
        assert_eq!((records, warned(&warnings)), (vec![end.clone(), end], vec![2]));
        assert!(
            warnings[0].to_string().contains("line 2: it has 100000001 bytes, more than any record"),
            "{}",
            warnings[0]
        );

        let mut reader = BufReader::new(File::open(&path).unwrap());
        let mut buffer = Vec::new();
        while next_line(&mut reader, &mut buffer).unwrap().is_some() {
            assert!(buffer.capacity() as u64 <= 2 * LONGEST_LINE, "{}", buffer.capacity());
        }
    }

    #[test]
    fn a_record_that_would_not_be_read_is_not_written() {
        let directory = tempfile::tempdir().unwrap();
        let mut log = Log::create(directory.path()).unwrap();
        let start = |length| {
            let program = "p".repeat(length);
            [Record::Start { program, sweep: String::new(), cases: 0, threads: 1, time: 0 }]
        };
        let frame = start(0)[0].line().len();
        let longest = LONGEST_LINE as usize - frame;
        log.append(&start(longest)).unwrap();
        let error = log.append(&start(longest + 1)).unwrap_err().to_string();
        assert!(error.contains("16777217 bytes, and a line at most 16777216"), "{error}");
        let (records, warnings) = read_directory(&directory);
        assert_eq!((records.len(), warnings), (1, Vec::new()));
    }

    #[test]
    fn only_files_with_the_names_of_logs_are_logs() {
        let directory = tempfile::tempdir().unwrap();
        let line = Record::End { ending: Ending::Completed, time: 5 }.line();
        for name in
            ["1.jsonl", "00001.jsonl", "+001.jsonl", "-001.jsonl", "0001.jsonl~", "0001.JSONL", ".jsonl", "a.jsonl"]
        {
            fs::write(directory.path().join(name), &line).unwrap();
        }
        fs::create_dir(log_path(directory.path(), 3)).unwrap();
        assert_eq!(read_directory(&directory), (Vec::new(), Vec::new()));
        fs::write(log_path(directory.path(), u32::MAX), &line).unwrap();
        assert_eq!(read_directory(&directory).0.len(), 1);
        let error = Log::create(directory.path()).unwrap_err();
        assert!(error.to_string().contains("4294967295.jsonl"), "there is no next number: {error}");
    }

    proptest! {
        #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(128)
    })]

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
        fn records_survive_between_damaged_lines_and_each_of_these_is_told_once(
            lines in prop::collection::vec(prop_oneof![any_record().prop_map(Ok), damaged_line().prop_map(Err)], 0..12),
            twice in any::<bool>(),
        ) {
            // A record may stand there twice, as copied logs have it.
            let lines = if twice { [lines.clone(), lines].concat() } else { lines };
            let mut content = Vec::new();
            for line in &lines {
                match line {
                    Ok(record) => content.extend(record.line().into_bytes()),
                    Err(damage) => content.extend(damage.iter().chain(b"\n")),
                }
            }
            let (found, warnings) = read(&content);
            prop_assert!(found.iter().eq(lines.iter().flatten()));
            let damaged = (1..).zip(&lines).filter_map(|(number, line)| line.is_err().then_some(number));
            let damaged: Vec<u64> = damaged.collect();
            prop_assert_eq!(warned(&warnings), damaged);
        }

        #[test]
        fn logs_are_read_in_the_order_of_their_numbers(
            logs in prop::collection::btree_map(1_u32..2_000_000, prop::collection::vec(any_record(), 0..3), 0..6),
        ) {
            let directory = tempfile::tempdir().unwrap();
            for (number, records) in logs.iter().rev() {
                let content: String = records.iter().map(Record::line).collect();
                fs::write(log_path(directory.path(), *number), content).unwrap();
            }
            let (found, warnings) = read_directory(&directory);
            prop_assert!(found.iter().eq(logs.values().flatten()));
            prop_assert_eq!(warnings, Vec::new());
            let next = Log::create(directory.path()).unwrap().number;
            prop_assert_eq!(next, logs.last_key_value().map_or(1, |(last, _)| last + 1));
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
