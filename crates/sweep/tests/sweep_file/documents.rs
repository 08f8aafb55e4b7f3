//! Documents put together from the keys of a sweep file, each with a value that may be right, of the wrong type, or out
//! of range: more of them get past the grammar than of random text.

use proptest::prelude::*;
use proptest::sample::select;

type Texts = &'static [&'static str];

type Section = (&'static str, &'static [(&'static str, Texts)]);

/// The sections with their keys, and values that are right.
const SECTIONS: [Section; 6] = [
    ("", &[("title", &["'a title'", "\"τ \\u03c4\""])]),
    (
        "[axes]\n",
        &[
            ("f", &["[100.0]", "[0, 1, 1e3]", "{ from = 0.0, to = 2, points = 5 }"]),
            ("alpha", &["[1.0]", "[0.0, 0.5, inf]", "{ from = 1e-3, to = 1e3, points = 7, scale = 'log' }"]),
            ("beta", &["[10.0]", "[1e-5, 0x10, 1_000]", "{ from = 1, to = 1e6, points = 130, scale = \"log\" }"]),
        ],
    ),
    (
        "[substrate]\n",
        &[("modes", &["[{ share = 1, time = 1 }]", "[{ share = 0.7, time = 1.0 }, { time = 2e3, share = 0.3 }]"])],
    ),
    (
        "[solver]\n",
        &[
            ("method", &["'collocation'", "\"relaxation\""]),
            ("tolerance", &["1e-5", "0.1"]),
            ("time_limit", &["60", "inf"]),
        ],
    ),
    (
        "[solver.relaxation]\n",
        &[
            ("domain", &["'auto'", "[-3.0, 4]"]),
            ("points", &["401", "1601"]),
            ("tolerance", &["1e-8"]),
            ("acceleration", &["'none'", "'anderson'"]),
            ("estimate", &["true", "false"]),
        ],
    ),
    (
        "[output]\n",
        &[
            ("fields", &["[]", "['pressure', 'displacement']"]),
            ("x", &["[-1.0, 0, 1]", "{ from = -3, to = 3, points = 11 }"]),
            ("limits", &["true", "false"]),
            ("cavity_shear", &["'full'", "'none'"]),
            ("sensitivities", &["true", "false"]),
            ("field_precision", &["'double'", "'single'"]),
        ],
    ),
];

/// Keys of tables within lists and in the place of lists.
const INNER_KEYS: Texts = &["from", "to", "points", "scale", "share", "time", "modes", "x", "ξ"];

/// Values that a type or a range ends at.
const EDGES: Texts = &[
    "0",
    "-0.0",
    "1",
    "2",
    "-1",
    "1e308",
    "1e999",
    "-1e-400",
    "5e-324",
    "inf",
    "-inf",
    "nan",
    "0xffffffffffffffffff",
    "true",
    "''",
    "'log'",
    "\"\\u0000\"",
    "\"\\e[31m\"",
    "1979-05-27T07:32:00Z",
    "07:32:00",
    "[]",
    "{}",
    "[[]]",
    "1..2",
    "=",
    "[\n# \n]",
];

/// Any value of TOML, of any type.
fn any_value() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        4 => select(EDGES).prop_map(str::to_owned),
        1 => any::<f64>().prop_map(|value| format!("{value:?}").replace("NaN", "nan")),
        1 => any::<i64>().prop_map(|value| value.to_string()),
        1 => any::<String>().prop_map(|text| format!("{text:?}")),
    ];
    leaf.prop_recursive(3, 12, 4, |inner| {
        let entry = (select(INNER_KEYS), inner.clone()).prop_map(|(key, value)| format!("{key} = {value}"));
        let joined = |items: Vec<String>| items.join(", ");
        prop_oneof![
            prop::collection::vec(inner, 0..4).prop_map(move |items| format!("[{}]", joined(items))),
            prop::collection::vec(entry, 0..4).prop_map(move |entries| format!("{{ {} }}", joined(entries))),
        ]
    })
}

/// One line: most keys are there, and most values are right.
fn line(&(key, right): &(&'static str, Texts)) -> impl Strategy<Value = String> + use<> {
    let value = prop_oneof![14 => select(right).prop_map(str::to_owned), 1 => any_value()];
    prop_oneof![19 => value.prop_map(move |value| format!("{key} = {value}\n")), 1 => Just(String::new())]
}

fn documents() -> impl Strategy<Value = String> {
    let section = |&(header, keys): &Section| {
        let lines: Vec<_> = keys.iter().map(line).collect();
        lines.prop_map(move |lines| header.to_owned() + &lines.concat())
    };
    SECTIONS.iter().map(section).collect::<Vec<_>>().prop_map(|sections| sections.concat())
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(1000)
    })]

    #[test]
    fn documents_of_known_keys_are_taken_or_refused_with_a_place(text in documents()) {
        crate::laws::sweep_file::check(text.as_bytes());
    }
}

/// Or the law above says little.
#[test]
fn many_of_the_documents_are_sweeps_and_many_are_not() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let documents = documents();
    let mut text = || documents.new_tree(&mut runner).expect("made").current();
    let taken = (0..400).filter(|_| stribeck_sweep::Sweep::parse("made", &text()).is_ok()).count();
    assert!((40..360).contains(&taken), "{taken} of 400");
}
