//! Counts, times and sizes in words.

/// `1 case`, `2 cases`.
pub fn count(number: u64, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{plural}")
}

/// A duration with the precision that matters: `3.1 ms`, `0.42 s`, `12.3 s`, `4 min 05 s`, `3 h 20 min`, `5 d 04 h`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        _ if seconds < 0.0995 => format!("{:.1} ms", 1e3 * seconds),
        0..10 => format!("{seconds:.2} s"),
        10..100 => format!("{seconds:.1} s"),
        100..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        3600..86_400 => format!("{} h {:02} min", whole / 3600, whole % 3600 / 60),
        _ => format!("{} d {:02} h", whole / 86_400, whole % 86_400 / 3600),
    }
}

/// A duration told by clocks of whole seconds: `under 1 s`, `12 s`, `4 min 05 s`.
pub fn whole_seconds(seconds: u64) -> String {
    match seconds {
        0 => "under 1 s".to_owned(),
        1..100 => format!("{seconds} s"),
        _ => duration(seconds as f64),
    }
}

/// A number of bytes: `812 B`, `1.5 kB`, `340 MB`.
pub fn bytes(number: u64) -> String {
    let mut size = number as f64;
    for unit in ["B", "kB", "MB", "GB"] {
        if size < 999.5 {
            return if size < 10.0 && unit != "B" { format!("{size:.1} {unit}") } else { format!("{size:.0} {unit}") };
        }
        size /= 1000.0;
    }
    format!("{size:.1} TB")
}

/// A time in seconds since 1970 as date and time of day, UTC.
pub fn moment(time: u64) -> String {
    let (days, seconds) = (time / 86_400, time % 86_400);
    // Days to date in years that begin in March, so that the leap day is the last; 719468 days from 0000-03-01 to 1970.
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let march_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * march_month + 2) / 5 + 1;
    let month = if march_month < 10 { march_month + 3 } else { march_month - 9 };
    let year = era * 400 + year_of_era + u64::from(month <= 2);
    let (hour, minute, second) = (seconds / 3600, seconds % 3600 / 60, seconds % 60);
    format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02} UTC")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_calendar() {
        // `date -u -d @N`
        let known = [
            (0, "1970-01-01 00:00:00 UTC"),
            (951_782_399, "2000-02-28 23:59:59 UTC"),
            (951_782_400, "2000-02-29 00:00:00 UTC"),
            (1_709_251_199, "2024-02-29 23:59:59 UTC"),
            (1_735_689_599, "2024-12-31 23:59:59 UTC"),
            (4_107_542_400, "2100-03-01 00:00:00 UTC"),
        ];
        for (time, text) in known {
            assert_eq!(moment(time), text);
        }
    }

    #[test]
    fn sizes_and_durations_keep_two_digits_or_more() {
        assert_eq!(
            [0, 999, 1000, 9_960, 999_600, 12_345_678].map(bytes),
            ["0 B", "999 B", "1.0 kB", "10.0 kB", "1.0 MB", "12 MB"]
        );
        assert_eq!(
            [0.00312, 0.0994, 0.0996, 0.424, 12.34, 245.0, 12_000.0, 450_000.0].map(duration),
            ["3.1 ms", "99.4 ms", "0.10 s", "0.42 s", "12.3 s", "4 min 05 s", "3 h 20 min", "5 d 05 h"]
        );
        assert_eq!([0, 1, 99, 100].map(whole_seconds), ["under 1 s", "1 s", "99 s", "1 min 40 s"]);
    }
}
