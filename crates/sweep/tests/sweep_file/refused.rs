//! Bad sweep files are refused with place, message and remedy.

use miette::Diagnostic;
use stribeck_input::InputError;
use stribeck_sweep::Sweep;

use crate::bad_sweeps::{bad_files, with_alpha};
use crate::sweep_file::drawn;

#[test]
fn bad_files_are_refused_with_place_message_and_remedy() {
    for (text, place, message, remedy) in bad_files() {
        let error = Sweep::parse("bad", &text).expect_err(&text);
        let said = error.to_string();
        assert!(said.starts_with(&format!("bad.toml:{place}: ")), "{said}\nshould be at {place} of\n{text}");
        assert!(said.contains(message), "{said}\nshould say: {message}");
        let help = error.help().expect("there is always a remedy").to_string();
        assert!(help.contains(remedy), "{help}\nshould say: {remedy}");
        assert!(matches!(error, InputError::Invalid { .. }));

        let line: usize = place.split(':').next().and_then(|line| line.parse().ok()).expect("places are line:column");
        let drawing = drawn(&error);
        let offending = text.lines().nth(line - 1).unwrap_or_default();
        assert!(drawing.contains(offending) && drawing.contains(&format!("bad.toml:{place}")), "{drawing}");
        if !text.is_empty() {
            let label = error.labels().and_then(|mut labels| labels.next()).expect("there is a label");
            assert!(!label.is_empty() && drawing.contains(label.label().expect("it has a text")), "{drawing}");
        }
    }
}

#[test]
fn a_line_too_long_to_draw_is_named_only() {
    let list = "1.0, ".repeat(1000);
    let error = Sweep::parse("long", &with_alpha(&format!("[{list}]"))).expect_err("double values");
    assert!(error.to_string().starts_with("long.toml:3:15: "), "{error}");
    assert!(drawn(&error).len() < 1000);
}
