//! One solid by Young's modulus and by its shear modulus, G = E/2(1+ν).

use stribeck_lab::LaboratoryQuantity;
use stribeck_sweep::{Grid, Sweep};

/// The relaxed or instantaneous moduli of a sweep, with their quantity.
fn moduli(text: &str) -> Vec<(LaboratoryQuantity, Vec<f64>)> {
    let Grid::Laboratory(axes) = Sweep::parse("moduli", text).expect("valid").grid else {
        panic!("quantities of the laboratory");
    };
    let of_modulus = [LaboratoryQuantity::RelaxedModulus, LaboratoryQuantity::InstantaneousModulus];
    let moduli = axes.given.into_iter().filter(|given| of_modulus.contains(&given.quantity));
    moduli.map(|given| (given.quantity, given.values)).collect()
}

/// A roller has the shear modulus of the flat that it is made of.
#[test]
fn a_roller_has_a_shear_modulus_too() {
    let roller = |modulus: &str| {
        let flat = "relaxed_modulus = 3e6\n[roller]\npoisson_ratio = 0.25\n";
        let text = with("", &format!("{flat}{modulus}"), 0.5);
        let Grid::Laboratory(axes) = Sweep::parse("roller", &text).expect("valid").grid else {
            panic!("quantities of the laboratory");
        };
        axes.roller
    };
    assert_eq!(roller("relaxed_shear_modulus = \"2 MPa\""), roller("relaxed_modulus = \"5 MPa\""));
}

fn with(laboratory: &str, substrate: &str, poisson_ratio: f64) -> String {
    format!(
        "[laboratory]\nradius = 0.002\nload = 100.0\nviscosity = 5.1\nspeed = [0.01, 0.1]\npoisson_ratio = \
         {poisson_ratio:?}\n{laboratory}\n[substrate]\n{substrate}\n"
    )
}

#[test]
fn a_shear_modulus_is_youngs_modulus_over_twice_one_and_poissons_ratio() {
    // powers of two, for which the factor is exact
    for poisson_ratio in [0.0, 0.25, 0.5] {
        let shear = |young: f64| young / (2.0 * (1.0 + poisson_ratio));
        let term = |modulus: f64| format!("relaxation = [{{ modulus = {modulus:?}, time = 0.5 }}]");
        let same = |young: (&str, &str), by_shear: (&str, &str)| {
            let [young, by_shear] = [young, by_shear].map(|(top, section)| moduli(&with(top, section, poisson_ratio)));
            assert_eq!(young.len(), 1);
            for ((quantity, values), (other, shears)) in young.iter().zip(&by_shear) {
                assert_eq!((quantity, values.len()), (other, shears.len()));
                assert!(values.iter().zip(shears).all(|(a, b)| (a / b - 1.0).abs() < 1e-15), "{values:?} {shears:?}");
            }
        };
        for which in ["relaxed", "instantaneous"] {
            let substrate =
                |kind: &str, modulus: f64, rest: &str| format!("{which}{kind}_modulus = {modulus:?}\n{rest}");
            let young = substrate("", 3e6, &term(2e6));
            same(("", &young), ("", &substrate("_shear", shear(3e6), &term(shear(2e6)))));
            let fractions = "relaxation = [{ fraction = 0.4, time = 0.5 }]";
            same(("", &substrate("", 3e6, fractions)), ("", &substrate("_shear", shear(3e6), fractions)));
            let laboratory = |kind: &str, low: f64, high: f64| {
                format!("{which}{kind}_modulus = [{low:?}, {high:?}]\nretardation_time = 1.0\nf = 2.0")
            };
            same((&laboratory("", 1e5, 3e6), ""), (&laboratory("_shear", shear(1e5), shear(3e6)), ""));
            let elastic = |kind: &str, modulus: f64| format!("{which}{kind}_modulus = {modulus:?}");
            same(("", &elastic("", 3e6)), ("", &elastic("_shear", shear(3e6))));
        }
    }
}
