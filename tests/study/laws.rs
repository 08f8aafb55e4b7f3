//! What the measures mean.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};

use stribeck::study::{Row, run};
use stribeck_solver::continuation::Interrupt;

use crate::study::{findings, of, study};

const CASES: &str = "[axes]\nf = [10.0]\nalpha = [1.0, 10.0]\nbeta = [10.0, 100.0]\n";

fn largest(rows: &[&Row]) -> f64 {
    rows.iter().map(|row| row.largest_error().expect("solved, with a reference")).fold(0.0, f64::max)
}

#[test]
fn errors_are_what_the_settings_promise() {
    let study = study(&format!(
        "repeats = 1\n{CASES}[[method]]\nmethod = \"collocation\"\ntolerance = [1e-2, 1e-4, 1e-6]\n\
         [[method]]\nmethod = \"collocation\"\ndegree = 4\npanels = [20, 40, 80]\n\
         [[method]]\nmethod = \"relaxation\"\npoints = [101, 201, 401]\n"
    ));
    let findings = findings(&study);
    let rows = &findings.rows;
    assert!(!findings.interrupted);
    let order: Vec<(usize, usize)> = rows.iter().map(|row| (row.case, row.variant)).collect();
    let expected: Vec<(usize, usize)> = (0..4).flat_map(|case| (0..9).map(move |variant| (case, variant))).collect();
    assert_eq!(order, expected);
    for (variant, tolerance) in [1e-2, 1e-4, 1e-6].into_iter().enumerate() {
        assert!(largest(&of(rows, variant)) <= tolerance);
    }
    // twice the panels of degree 4, or twice the points at second order
    for [coarse, fine] in [[3, 4], [4, 5], [6, 7], [7, 8]] {
        let error = |variant| largest(&of(rows, variant));
        let gain = error(coarse) / error(fine);
        assert!(gain > if fine < 6 { 5.0 } else { 2.0 }, "{coarse} to {fine}: {gain}");
    }
    for row in rows {
        let reference = row.reference.as_ref().expect("there is one");
        // fixed panels are there: as tight as it goes
        assert!(reference.tolerance <= 1e-8 && reference.error() <= reference.tolerance, "{reference:?}");
        // what is below the reference's own error is not known
        let known = reference.errors_of(&reference.quantities);
        assert_eq!(known[1..], [None; 3], "{reference:?}");
        let cost = row.cost.expect("measured");
        assert!(cost.seconds > 0.0 && row.iterations > 0 && row.unknowns.is_some_and(|unknowns| unknowns > 20));
        assert!(row.failure.is_none() && row.stability.is_none());
    }
}

/// Two orders tighter than the tightest setting; a method that is as tight as the reference has no measurable error.
#[test]
fn references_are_two_orders_tighter() {
    let cases = "[[case]]\nalpha = 1.0\nbeta = 50.0\nf = 10.0\n";
    let text = |tolerances: &str| {
        format!("repeats = 1\n{cases}[[method]]\nmethod = \"collocation\"\ntolerance = {tolerances}\n")
    };
    for row in &findings(&study(&text("[1e-3, 1e-5]"))).rows {
        assert_eq!(row.reference.as_ref().expect("there is one").tolerance, 1e-7);
    }
    let rows = findings(&study(&text("[1e-6, 1e-10]"))).rows;
    assert!(rows[0].largest_error().is_some() && rows[1].errors == [None; 4] && rows[1].failure.is_none());
}

/// A film too thin for the tolerance of a reference gets a looser one.
#[test]
fn references_of_thin_films_are_looser() {
    let study = study(
        "repeats = 1\n[[case]]\nalpha = 1.0\nbeta = 1e9\nf = 1e4\n[[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-7]\n",
    );
    let rows = findings(&study).rows;
    let reference = rows[0].reference.as_ref().expect("there is one");
    assert!(reference.tolerance > 1e-9 && reference.tolerance <= 1e-5, "{reference:?}");
    assert!(rows[0].errors.iter().flatten().all(|error| *error >= 0.0) && rows[0].largest_error().is_some());
}

/// A reference shares its degree with none of the variants.
#[test]
fn references_have_another_degree() {
    for (degree, expected) in [(8, "degree 12"), (12, "degree 14")] {
        let study = study(&format!(
            "repeats = 1\n[[case]]\nalpha = 1.0\nbeta = 50.0\nf = 10.0\n\
             [[method]]\nmethod = \"collocation\"\ntolerance = 1e-4\ndegree = {degree}\n"
        ));
        let rows = findings(&study).rows;
        let text = stribeck::study::markdown(&study, &rows, (&[], stribeck::pictures::Format::Svg));
        assert!(text.contains(&format!("panels of {expected}")), "{text}");
        // An error below that of the reference is not known, and smaller still.
        assert!(rows[0].failure.is_none() && rows[0].largest_error().is_none_or(|error| error <= 1e-4));
        assert!(rows[0].reference.as_ref().is_ok_and(|reference| reference.error() <= 1e-6));
    }
}

/// Fewer panels than sizes that change gradually take are a failure that says how many it takes.
#[test]
fn panels_are_as_many_as_asked_for() {
    let study = study(
        "repeats = 1\n[[case]]\nalpha = 1.0\nbeta = 100.0\nf = 10.0\n[[method]]\nmethod = \"collocation\"\npanels = [4, 20]\n",
    );
    let rows = findings(&study).rows;
    assert!(rows[0].failure.as_ref().is_some_and(|reason| reason.contains("at least, not 4")), "{:?}", rows[0].failure);
    assert_eq!(rows[1].unknowns, Some(20 * 8 + 1));
}

/// A grid that is too coarse for the film fails, and is a row with its reason.
#[test]
fn failures_are_rows() {
    let study = study(
        "measure = [\"error\", \"stability\"]\nrepeats = 1\n[[case]]\nalpha = 1.0\nbeta = 1e4\nf = 100.0\n\
         [[method]]\nmethod = \"relaxation\"\npoints = [51]\n[[method]]\nmethod = \"collocation\"\ntolerance = [1e-4]\n",
    );
    let rows = findings(&study).rows;
    let [failed, solved] = rows.as_slice() else { panic!("two rows") };
    assert!(failed.failure.as_ref().is_some_and(|reason| !reason.is_empty()) && solved.failure.is_none());
    assert!(
        failed.errors == [None; 4] && failed.unknowns.is_none() && failed.cost.is_some_and(|cost| cost.seconds > 0.0)
    );
    let [of_failed, of_solved] = [failed, solved].map(|row| row.stability.clone().expect("examined"));
    assert!(of_failed.condition.is_none() && of_failed.pressure_min.is_none() && of_failed.seed_difference.is_none());
    assert!(of_solved.condition.is_some() && of_solved.seeds_agree == Some(true));
}

/// Elastic: μ_v = 0 to rounding for both methods, and so is its error.
#[test]
fn an_elastic_substrate_has_no_error_of_mu_v() {
    let study = study(
        "repeats = 1\n[[case]]\nalpha = inf\nbeta = 100.0\nf = 0.0\n[[method]]\nmethod = \"collocation\"\ntolerance = 1e-4\n",
    );
    let [mu_v, mu_h, c, _] = findings(&study).rows[0].errors;
    assert_eq!(mu_v, Some(0.0));
    assert!(mu_h > Some(0.0) && c > Some(0.0));
}

#[test]
fn solutions_are_examined_from_the_inside() {
    let study = study(&format!(
        "measure = [\"stability\"]\n{CASES}[[method]]\nmethod = \"collocation\"\ntolerance = [1e-4, 1e-8]\n\
         [[method]]\nmethod = \"relaxation\"\npoints = [201, 401]\n"
    ));
    let findings = findings(&study);
    for row in &findings.rows {
        let found = row.stability.as_ref().expect("examined");
        assert!(row.cost.is_none() && row.failure.is_none() && found.other_failure.is_none());
        assert_eq!(found.seeds_agree, Some(true), "{found:?}");
        assert!(found.seed_difference.is_some_and(|difference| difference < 1e-4));
        assert!((-1e-6..=0.0).contains(&found.pressure_min.expect("solved")));
        assert!(found.load_residual.expect("solved") < 1e-7);
        // seeds are what they say they are: from the neighbour only the second time
        assert_ne!(row.seed, "neighbour");
        assert!(
            found.other_seed == "neighbour" || found.other_seed.starts_with("intermediate"),
            "{}",
            found.other_seed
        );
        // the estimate is near the error, where that is large enough to be known
        let estimated = found.estimated_error.expect("there is one");
        match row.largest_error() {
            Some(error) => assert!((0.1..30.0).contains(&(estimated / error)), "{estimated} {error}"),
            None => assert!(row.reference.as_ref().is_ok_and(|reference| reference.error() < 0.01 * 1e-4)),
        }
    }
    let known = findings.rows.iter().filter(|row| row.largest_error().is_some()).count();
    assert!(2 * known > findings.rows.len(), "{known}");
    // second differences: about four times the condition on half the step, scaling apart
    for case in 0..study.cases.len() {
        let condition = |variant| {
            let row = findings.rows.iter().find(|row| (row.case, row.variant) == (case, variant));
            row.and_then(|row| row.stability.as_ref()?.condition).expect("solved")
        };
        let growth = condition(3) / condition(2);
        assert!((2.0..16.0).contains(&growth), "{growth}");
        assert!(condition(0) > 1e2 && condition(1) > condition(0));
    }
}

/// Everything but times is the same on any number of threads, and however often it is repeated.
#[test]
fn threads_and_repeats_change_nothing_but_times() {
    let text = format!(
        "measure = [\"error\", \"stability\"]\nstart = \"chain\"\nrepeats = 1\n{CASES}\
         [[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-5]\n[[method]]\nmethod = \"relaxation\"\npoints = 101\n"
    );
    let again = study(&text.replace("repeats = 1", "repeats = 3"));
    let study = study(&text);
    let count = AtomicUsize::new(0);
    let threads = NonZeroUsize::new(3).expect("not 0");
    let no_meter = |work: &mut dyn FnMut()| {
        work();
        0
    };
    let counted = |_| {
        count.fetch_add(1, Ordering::Relaxed);
    };
    let parallel = run(&again, threads, &no_meter, &Interrupt::new(), counted).expect("three threads");
    let key = |row: &Row| {
        (row.case, row.variant, row.iterations, row.unknowns, row.errors, row.stability.clone(), row.seed.clone())
    };
    let sequential = findings(&study);
    assert_eq!(sequential.rows.iter().map(key).collect::<Vec<_>>(), parallel.rows.iter().map(key).collect::<Vec<_>>());
    assert_eq!(count.into_inner(), parallel.rows.len());
}

/// What is interrupted is left out whole, and the findings say so.
#[test]
fn an_interrupted_study_has_the_rows_that_were_finished() {
    let study = study(&format!("repeats = 1\n{CASES}[[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-5]\n"));
    let interrupt = Interrupt::new();
    let no_meter = |work: &mut dyn FnMut()| {
        work();
        0
    };
    let stop = |_| interrupt.request();
    let findings = run(&study, NonZeroUsize::MIN, &no_meter, &interrupt, stop).expect("one thread");
    assert!(findings.interrupted);
    assert_eq!(findings.rows.iter().map(|row| (row.case, row.variant)).collect::<Vec<_>>(), [(0, 0), (0, 1)]);
}
