//! The extension module of the Python package `stribeck`: the solver, sweeps and the program itself.
//!
//! The package lies in `python/stribeck`. It takes what a person gives it and makes data sets; this module has the
//! numbers, and the names, units and descriptions that belong to them, from the one declaration that the program has.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `points` | `solve`: a list of points |
//! | `in_memory` | `solve_sweep`: a sweep whose results are kept in memory |
//! | `campaign` | `run`: a sweep into a results directory |
//! | `quantities`, `material` | numbers with units; materials |
//! | `fit` | `fit`: quantities from measured friction |
//! | `program` | `main`: the program |
//! | `variables` | columns and fields with their descriptions, as numpy arrays |
//! | `background` | work on threads of its own while Python looks for Ctrl-C |
//! | `errors` | errors of the libraries as exceptions |

mod background;
mod campaign;
mod errors;
mod fit;
mod in_memory;
mod material;
mod points;
mod program;
mod quantities;
mod variables;

use pyo3::prelude::*;

/// What the Python package is made of.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::campaign::run;
    #[pymodule_export]
    use super::fit::fit;
    #[pymodule_export]
    use super::in_memory::solve_sweep;
    #[pymodule_export]
    use super::material::{material_file, prony};
    #[pymodule_export]
    use super::points::solve;
    #[pymodule_export]
    use super::program::main;
    #[pymodule_export]
    use super::quantities::{check_sweep, si};

    use pyo3::prelude::*;
    use stribeck_lab::LaboratoryQuantity;
    use stribeck_sweep::Field;

    /// The text of the surface that is built in.
    #[pyfunction]
    fn universe() -> String {
        stribeck::universe::text()
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        // When a package is imported there are seldom other threads.
        stribeck_sweep::store::initialise_hdf5();
        stribeck_sweep::store::sign_as(stribeck::VERSION);
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("FIELDS", Field::ALL.map(Field::name))?;
        module.add("QUANTITIES", LaboratoryQuantity::ALL.map(|quantity| (quantity.name(), quantity.units())))
    }
}
