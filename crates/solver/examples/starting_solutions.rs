//! Writes the table of solutions from which the collocation solver starts: again for each `RESULTS_VERSION`.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example starting_solutions
//! ```

use stribeck_solver::collocation::CollocationSolver;

fn main() -> std::io::Result<()> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/collocation/starting_solutions.bin");
    let table = CollocationSolver::starting_solutions();
    std::fs::write(path, &table)?;
    println!("{} bytes", table.len());
    Ok(())
}
