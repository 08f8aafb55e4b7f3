//! What cannot be fitted is refused, with the reason.

use super::{SOFT_ROLLER, TRUTH, exact, fitted, points, speeds};
use stribeck_lab::{Experiment, LaboratoryQuantity, Measured, Modulus, Motion, Roller, RollerQuantity, Unknown};
use stribeck_solver::Substrate;

#[test]
fn what_cannot_be_fitted_is_refused() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let friction = exact(&speeds, TRUTH, &substrate);
    let measured = points(&speeds, friction.clone(), None);
    let refused =
        |measured: &Measured, names: &[&str]| fitted(measured, TRUTH, &substrate, names).unwrap_err().to_string();
    let together = refused(&measured, &["relaxed_modulus", "viscosity", "radius", "load"]);
    assert!(together.contains("cannot be told apart") && together.contains("viscosity"), "{together}");
    assert!(refused(&measured, &["speed"]).contains("speed is a column of the measured points"));
    assert!(
        refused(&measured, &["relaxed_modulus", "instantaneous_modulus"])
            .contains("look for one of the moduli of a body and f")
    );
    let few = points(&speeds[..2], friction[..2].to_vec(), None);
    assert!(refused(&few, &["viscosity", "f"]).contains("2 points are too few for 2 unknowns"));
    let mut negative = measured.clone();
    negative.friction[3] = -0.1;
    assert!(refused(&negative, &["viscosity"]).contains("the friction coefficient on line 5 is not above 0"));
    let motion = Motion::Rolling { entrainment_speed: 1e-3, slide_roll_ratio: 0.5 };
    let rolling = Experiment { motion, ..TRUTH };
    let error = fitted(&measured, rolling, &substrate, &["viscosity"]).unwrap_err().to_string();
    assert!(error.contains("the sweep file gives slide_roll_ratio and entrainment_speed"), "{error}");
    let elastic = Experiment { f: 0.0, ..TRUTH };
    let error = fitted(&measured, elastic, &substrate, &["f"]).unwrap_err().to_string();
    assert!(error.contains("f begins at 0"), "{error}");
    let mut extreme = measured.clone();
    extreme.coordinates[0].1[0] = 1e-60;
    let error = refused(&extreme, &["viscosity"]);
    assert!(error.contains("the point on line 2 has no solution at the start of the fit"), "{error}");
    for name in ["poisson_ratio", "slide_roll_ratio", "roller_speed", "flat_speed"] {
        assert!(Unknown::named(name).is_none(), "{name}");
    }
    assert_eq!(Unknown::all().count(), LaboratoryQuantity::ALL.len() - 5 + 1 + RollerQuantity::ALL.len());
    assert!(refused(&measured, &["roller.f"]).contains("roller.f is looked for, and the roller is rigid"));
    let soft = Experiment { roller: SOFT_ROLLER, ..TRUTH };
    let refused = |start, names: &[&str]| fitted(&measured, start, &substrate, names).unwrap_err().to_string();
    let both = refused(soft, &["roller.relaxed_modulus", "roller.instantaneous_modulus"]);
    assert!(both.contains("one of the moduli of a body"), "{both}");
    let elastic = refused(Experiment { roller: Roller { f: 0.0, ..SOFT_ROLLER }, ..TRUTH }, &["roller.f"]);
    assert!(elastic.contains("roller.f begins at 0"), "{elastic}");
    let rigid = Experiment { modulus: Modulus::Relaxed(f64::INFINITY), f: 0.0, ..soft };
    assert!(refused(rigid, &["relaxed_modulus"]).contains("relaxed_modulus is looked for, and the flat is rigid"));
    // a roller that slides without turning has relaxed: no friction tells its times
    let at_rest = refused(soft, &["viscosity", "roller.retardation_time"]);
    assert!(at_rest.contains("roller.retardation_time"), "{at_rest}");
}
