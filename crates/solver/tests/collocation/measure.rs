//! The cases of the reference, and what counts as the error of a solution.

use stribeck_solver::collocation::Settings;
use stribeck_solver::{Parameters, Quantities, RelativeErrors};

/// The tolerances that a solution is tried with.
pub const TOLERANCES: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
/// The settings whose solution counts as exact. Panels of a higher degree than usual, so that meshes and errors have
/// little in common with what is judged.
pub const EXACT: Settings = Settings { tolerance: 1e-10, degree: 12 };

/// The numbers of a row of the reference after f, α and β: c, u_min, p_max, x_out, F_v, F_h,film, F_h,cavity with a
/// full gap and with streamers, F_drag.
pub type Columns = [f64; 9];

/// The rows of `tests/reference/single_mode.csv`, α = ∞ where f = 0.
pub fn reference() -> Vec<(Parameters, Columns)> {
    let records = csv::Reader::from_reader(include_bytes!("../reference/single_mode.csv").as_slice()).into_records();
    let row = |record: csv::StringRecord| {
        let numbers: Vec<f64> = record.iter().map(|number| number.parse().expect("a number")).collect();
        let (&[f, alpha, beta], columns) = numbers.split_first_chunk().expect("f, α and β");
        let parameters = if f == 0.0 { Parameters::elastic(beta) } else { Parameters::new(alpha, beta, f) };
        (parameters, columns.try_into().expect("nine more columns"))
    };
    records.map(|record| row(record.expect("a row"))).collect()
}

/// The error that a tolerance is about: the largest relative one of μ_v, μ_h and c, of μ_v relative to μ_tot/1000 where
/// it is below that.
pub fn true_error(found: &Quantities, exact: &Quantities) -> f64 {
    let (friction, exactly) = (&found.friction, &exact.friction);
    let scale = exactly.viscoelastic_error_scale();
    worst(&RelativeErrors {
        mu_v: (friction.viscoelastic - exactly.viscoelastic).abs() / scale,
        mu_h: (friction.hydrodynamic() / exactly.hydrodynamic() - 1.0).abs(),
        c: (found.c / exact.c - 1.0).abs(),
        ..RelativeErrors::UNKNOWN
    })
}

/// The largest of the three errors; NaN if one of them is.
pub fn worst(errors: &RelativeErrors) -> f64 {
    [errors.mu_v, errors.mu_h, errors.c].into_iter().fold(0.0, |a, b| if b.is_nan() || b > a { b } else { a })
}

/// The value below which a part of the numbers lies.
pub fn quantile(numbers: &[f64], part: f64) -> f64 {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[(part * (sorted.len() - 1) as f64).round() as usize]
}
