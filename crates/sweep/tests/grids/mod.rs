//! Publications over f, α and β.

use stribeck_sweep::store::{Point, Publication, Published, Store, StoreError};
use stribeck_sweep::{CaseId, Dimension};

/// Publishes the cases of the rows at places of f and α under a title and a sweep text.
pub fn publish(
    store: &mut Store,
    [title, sweep_text]: [&str; 2],
    [f, alpha, beta]: [&[f64]; 3],
    cases: &dyn Fn(usize, usize) -> Vec<CaseId>,
) -> Result<Published, StoreError> {
    let row = |row: usize| {
        let (i_f, i_alpha) = (row / alpha.len(), row % alpha.len());
        let points = cases(i_f, i_alpha).into_iter().zip(beta.iter().cycle());
        points.map(|(case, beta)| Point::new(case, [f[i_f], alpha[i_alpha], *beta])).collect()
    };
    let dimensions = [Dimension::strength(f), Dimension::alpha(alpha), Dimension::beta(beta)];
    let (method, tolerance) = ("made up", 1e-5);
    let partial = false;
    store.publish(&Publication { title, sweep_text, method, tolerance, partial, dimensions: &dimensions, row: &row })
}
