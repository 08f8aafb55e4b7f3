//! What can happen to a run and to its files.

use std::fmt;

use crate::torture::place::Place;
use crate::torture::random::Random;
use crate::torture::stops::Moment;
use crate::torture::witness::assert_told;
use crate::torture::{clock, company, copies, damage, room, stops};

/// A kind of harm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    Kill,
    Signal,
    TwoSignals,
    SecondRun,
    FullDisk,
    FileSizeLimit,
    ReadOnly,
    Clock,
    Copy,
    TruncatedShard,
    FlippedByte,
    DeletedShard,
    ForeignShard,
    TornLine,
    DamagedLine,
}

impl Fault {
    /// Those that happen to a run; kills more often, as they have the most moments to hit.
    pub const OF_RUNS: [Self; 11] = [
        Self::Kill,
        Self::Kill,
        Self::Kill,
        Self::Signal,
        Self::TwoSignals,
        Self::SecondRun,
        Self::FullDisk,
        Self::FileSizeLimit,
        Self::ReadOnly,
        Self::Clock,
        Self::Copy,
    ];

    /// Those that happen to files while no run is at work.
    pub const OF_FILES: [Self; 6] = [
        Self::TruncatedShard,
        Self::FlippedByte,
        Self::DeletedShard,
        Self::ForeignShard,
        Self::TornLine,
        Self::DamagedLine,
    ];

    /// Lets it happen and checks what it may do and what not. Returns how it came out, in a few words.
    pub fn strike(self, place: &mut Place, random: &mut Random) -> &'static str {
        let how = match self {
            Self::Kill => stops::kill(place, Moment::any(random), random),
            Self::Signal => stops::signal(place, Moment::any(random), random),
            Self::TwoSignals => stops::two_signals(place, Moment::any(random), random),
            Self::SecondRun => company::second_run(place, random),
            Self::FullDisk => room::full_disk(place, random),
            Self::FileSizeLimit => room::file_size_limit(place, random),
            Self::ReadOnly => room::read_only(place, random),
            Self::Clock => clock::wrong(place, random),
            Self::Copy => copies::copied(place, random),
            Self::TruncatedShard => damage::to_shards(place, random, damage::truncate),
            Self::FlippedByte => damage::to_shards(place, random, damage::flip),
            Self::DeletedShard => damage::to_shards(place, random, damage::delete),
            Self::ForeignShard => damage::by_a_foreign_shard(place, random),
            Self::TornLine => damage::tear_last_line(place, random),
            Self::DamagedLine => damage::flip_in_a_line(place, random),
        };
        assert_told(place);
        how
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Kill => "SIGKILL",
            Self::Signal => "one signal",
            Self::TwoSignals => "two signals",
            Self::SecondRun => "second run",
            Self::FullDisk => "full disk",
            Self::FileSizeLimit => "file size limit",
            Self::ReadOnly => "read-only disk",
            Self::Clock => "wrong clock",
            Self::Copy => "copy",
            Self::TruncatedShard => "truncated shard",
            Self::FlippedByte => "flipped byte",
            Self::DeletedShard => "deleted shard",
            Self::ForeignShard => "foreign shard",
            Self::TornLine => "torn line",
            Self::DamagedLine => "damaged line",
        })
    }
}
