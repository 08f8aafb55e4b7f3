//! One material by its terms in every form in which they are passed on.

use std::path::Path;

use stribeck_lab::{
    MaterialData, MaterialFile, MaterialOptions, Modulus, ModulusKind, PronyError, PronyParts, PronySeries,
};

/// The series in a file with this text.
fn read(text: &str, modulus_unit: Option<f64>) -> PronySeries {
    let options = MaterialOptions { modulus_unit, ..MaterialOptions::default() };
    match MaterialFile::of(Path::new("series"), text.as_bytes(), &options).expect("a series").data {
        MaterialData::Series(series) => series,
        other => panic!("{other:?}"),
    }
}

/// By the instantaneous or the relaxed modulus, by moduli or by fractions: all four say the same.
#[test]
fn four_ways_to_write_a_series_are_one_material() {
    let (relaxed, terms) = (2e6, [(3e6, 1e-3), (1e6, 0.5), (2e6, 80.0)]);
    let instantaneous = relaxed + terms.iter().map(|term| term.0).sum::<f64>();
    let fractions = terms.map(|(modulus, time)| (modulus / instantaneous, time));
    let materials = [
        (PronyParts::Moduli, terms, Modulus::Relaxed(relaxed)),
        (PronyParts::Moduli, terms, Modulus::Instantaneous(instantaneous)),
        (PronyParts::Fractions, fractions, Modulus::Relaxed(relaxed)),
        (PronyParts::Fractions, fractions, Modulus::Instantaneous(instantaneous)),
    ]
    .map(|(parts, terms, modulus)| {
        let series = PronySeries { parts, terms: terms.to_vec(), modulus: Some(modulus), kind: ModulusKind::Young };
        series.relaxation().expect("a material")
    });
    for material in &materials[1..] {
        assert!((material.relaxed_modulus() / relaxed - 1.0).abs() < 1e-14);
        for (term, exact) in material.terms().iter().zip(materials[0].terms()) {
            assert!((term.modulus / exact.modulus - 1.0).abs() < 1e-14 && term.time == exact.time);
        }
    }
}

/// Abaqus, Ansys and a table: the same terms and the same modulus.
#[test]
fn one_series_in_three_languages_is_one_material() {
    let abaqus = read(
        "*ELASTIC, MODULI=INSTANTANEOUS\n6.5, .5\n*VISCOELASTIC, TIME=PRONY\n.375, 0., .01\n0, 0, 1\n.25, 0., 5.\n",
        Some(1e6),
    );
    let ansys = read("MP,EX,1,6.5\nTB,PRONY,1,1,2,SHEAR\nTBDATA,1,0.375,0.01,0.25,5.0\n", Some(1e6));
    let table = read("# E0 = 6.5 MPa\n# rel_mod, rel_time\n0.375,1e-2\n0,1\n0.25,5\n", None);
    let moduli = read("E0 = 6,5 MPa\ntau_i (ms);E_i (MPa)\n10;2,4375\n5000;1,625\n", None);
    assert_eq!((&abaqus, &abaqus), (&ansys, &table));
    assert_eq!((moduli.parts, moduli.modulus), (PronyParts::Moduli, abaqus.modulus));
    let by_moduli = moduli.relaxation().expect("a material");
    assert!((by_moduli.relaxed_modulus() / (0.375 * 6.5e6) - 1.0).abs() < 1e-14);
    for (term, exact) in by_moduli.terms().iter().zip(abaqus.relaxation().expect("a material").terms()) {
        assert!((term.modulus / exact.modulus - 1.0).abs() < 1e-14 && term.time == exact.time);
    }
    let relaxation = abaqus.relaxation().expect("a material");
    assert!((relaxation.instantaneous_modulus() / 6.5e6 - 1.0).abs() < 1e-15);
    assert!((relaxation.relaxed_modulus() / (0.375 * 6.5e6) - 1.0).abs() < 1e-15);
}

#[test]
fn a_series_that_leaves_nothing_says_what_it_may_be() {
    let series = |terms: &[(f64, f64)], parts, modulus| PronySeries {
        parts,
        terms: terms.to_vec(),
        modulus,
        kind: ModulusKind::Young,
    };
    let per_cent = series(&[(30.0, 1.0), (20.0, 2.0)], PronyParts::Fractions, None).relaxation().expect_err("too much");
    assert!(matches!(per_cent, PronyError::NoFractionLeft { sum: 50.0 }));
    let said = per_cent.to_string();
    assert!(["50.0000", "per cent", "liquid"].iter().all(|word| said.contains(word)), "{said}");
    let liquid = series(&[(2e6, 1.0)], PronyParts::Moduli, Some(Modulus::Instantaneous(2e6))).relaxation();
    assert!(liquid.expect_err("a liquid").to_string().contains("liquid"));
    assert_eq!(series(&[(1.0, 1.0)], PronyParts::Moduli, None).relaxation(), Err(PronyError::NoModulus));
    let many = series(&[(1e-9, 1.0); 1001], PronyParts::Fractions, None).relaxation();
    assert_eq!(many, Err(PronyError::TooMany { terms: 1001 }));
}
