//! Counts, times, sizes and tables as text.

use jiff::Timestamp;

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
pub fn utc_timestamp(seconds: u64) -> String {
    let timestamp = i64::try_from(seconds).ok().and_then(|seconds| Timestamp::from_second(seconds).ok());
    match timestamp {
        Some(timestamp) => timestamp.strftime("%Y-%m-%d %H:%M:%S UTC").to_string(),
        None => format!("{seconds} s after 1970"),
    }
}

/// How the cells of a column of text stand: on which side, and the least width in characters.
#[derive(Clone, Copy)]
pub enum Align {
    /// Cells begin at the left.
    Left(usize),
    /// Cells end at the right.
    Right(usize),
}

/// One line of a table: a cell in each column, two blanks between them and none at the end.
pub fn table_line(columns: &[Align], cells: &[impl AsRef<str>]) -> String {
    let padded = |(column, cell): (&Align, &_)| match (*column, AsRef::<str>::as_ref(cell)) {
        (Align::Left(width), cell) => format!("{cell:<width$}"),
        (Align::Right(width), cell) => format!("{cell:>width$}"),
    };
    let line = columns.iter().zip(cells).map(padded).collect::<Vec<_>>().join("  ");
    line.trim_end().to_owned() + "\n"
}

/// Characters of a line in the terminal.
const WIDTH: usize = 80;

/// A text in lines of at most 80 characters, those behind the first one with `indent`. A word that is longer, as a path
/// may be, stays whole.
pub fn filled(text: &str, indent: &str) -> String {
    let (mut lines, mut length) = (String::new(), 0);
    for (place, word) in text.split(' ').enumerate() {
        let width = word.chars().count();
        if place > 0 && length + 1 + width > WIDTH {
            lines.truncate(lines.trim_end_matches(' ').len());
            lines += &format!("\n{indent}{word}");
            length = indent.chars().count() + width;
            continue;
        }
        if place > 0 {
            lines.push(' ');
            length += 1;
        }
        lines += word;
        length += width;
    }
    lines
}

/// A list in lines of at most 80 characters, whose pieces stay whole.
pub fn filled_list(pieces: &[String], indent: &str) -> String {
    let whole: Vec<String> = pieces.iter().map(|piece| piece.replace(' ', "\u{a0}")).collect();
    filled(&format!("{indent}{}", whole.join(", ")), indent).replace('\u{a0}', " ")
}

/// A line with a name and what it is, which goes on below itself where it is long.
pub fn entry(name: &str, words: &str) -> String {
    filled(&format!("{name:<10} {words}"), &" ".repeat(11)) + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn timestamps_are_those_of_the_calendar() {
        // `date -u -d @N`
        let known = [
            (0, "1970-01-01 00:00:00 UTC"),
            (951_782_399, "2000-02-28 23:59:59 UTC"),
            (951_782_400, "2000-02-29 00:00:00 UTC"),
            (1_709_251_199, "2024-02-29 23:59:59 UTC"),
            (1_735_689_599, "2024-12-31 23:59:59 UTC"),
            (4_107_542_400, "2100-03-01 00:00:00 UTC"),
            (u64::MAX, "18446744073709551615 s after 1970"),
        ];
        for (time, text) in known {
            assert_eq!(utc_timestamp(time), text);
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

    #[test]
    fn lines_end_before_the_edge_of_the_terminal() {
        let text = "word ".repeat(40);
        let filled_text = filled(text.trim(), "   ");
        let lines: Vec<&str> = filled_text.lines().collect();
        assert!(lines.iter().all(|line| line.chars().count() <= 80 && !line.ends_with(' ')), "{filled_text}");
        assert!(lines[1].starts_with("   word") && lines.len() == 3, "{filled_text}");
        assert_eq!(filled_text.split_whitespace().count(), 40);
        assert_eq!(filled("a  table   cell", ""), "a  table   cell");
        assert_eq!(filled(&"x".repeat(100), ""), "x".repeat(100));
        assert_eq!(entry("state", "3 reused"), "state      3 reused\n");
        let list = filled_list(&vec!["load = 200 N/m".to_owned(); 9], "  ");
        assert!(list.lines().all(|line| line.starts_with("  load = ") && line.chars().count() <= 80), "{list}");
    }

    #[test]
    fn cells_stand_in_their_columns() {
        let columns = [Align::Left(4), Align::Right(5), Align::Left(3)];
        assert_eq!(table_line(&columns, &["μ", "1.5", "1"]), "μ       1.5  1\n");
        assert_eq!(table_line(&columns, &["longer", "", ""]), "longer\n");
    }
}
