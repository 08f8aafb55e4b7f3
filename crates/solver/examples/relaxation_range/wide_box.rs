//! Far outside of the method's range.

use rayon::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::relaxation::{RelaxationSolver, Settings};

use crate::comparison::{Compared, QUANTITIES, compare, median_and_worst};
use crate::far_cases::far_cases;

/// Each case alone.
pub fn solve(settings: Settings, count: usize) -> Vec<Compared> {
    let solver = RelaxationSolver::new(settings);
    let alone = |case: Parameters| compare(&solver, settings, &[case]).remove(0);
    far_cases(count).into_par_iter().with_max_len(1).map(alone).collect()
}

/// How many are accepted, how far they are off, and what the others cost.
pub fn print(cases: &[Compared]) {
    let (accepted, refused): (Vec<&Compared>, Vec<&Compared>) = cases.iter().partition(|case| case.deviations.is_ok());
    println!("{} accepted, {} refused\n", accepted.len(), refused.len());
    println!("| of those accepted | median | worst | where |");
    println!("| --- | --- | --- | --- |");
    for (i, name) in QUANTITIES.iter().enumerate() {
        let deviation = |case: &&Compared| case.deviations.as_ref().map_or(f64::NAN, |found| found.relative[i]);
        let Some((median, worst)) = median_and_worst(accepted.iter().map(deviation)) else { continue };
        let Parameters { alpha, beta, f, .. } = accepted
            .iter()
            .find(|case| deviation(case).total_cmp(&worst).is_eq())
            .map(|case| case.parameters.clone())
            .expect("the worst is one of them");
        println!("| {name} | {median:.1e} | {worst:.1e} | α = {alpha:.1e}, β = {beta:.1e}, f = {f:.1e} |");
    }
    println!("\n| | passes, median | most | seconds, median | most |");
    println!("| --- | --- | --- | --- | --- |");
    for (name, cases) in [("accepted", &accepted), ("refused", &refused)] {
        let passes = median_and_worst(cases.iter().map(|case| case.passes as f64)).unwrap_or_default();
        let seconds = median_and_worst(cases.iter().map(|case| case.seconds)).unwrap_or_default();
        println!("| {name} | {:.0} | {:.0} | {:.2} | {:.2} |", passes.0, passes.1, seconds.0, seconds.1);
    }
}
