//! Isotherms of a material whose law of temperature is known.

use super::{rubber, solid};
use stribeck_lab::{
    Isotherms, IsothermsError, MasterCurve, MasterCurveError, Measurement, Relaxation, ShiftFactors, ShiftFactorsError,
    ShiftLaw, ShiftLawFit, VerticalShift,
};

const REFERENCE: f64 = 293.15;
const WLF: ShiftLaw = ShiftLaw::Wlf { c1: 10.0, c2: 110.0, reference: REFERENCE };
const ARRHENIUS: ShiftLaw = ShiftLaw::Arrhenius { activation_energy: 1.5e5, reference: REFERENCE };

/// A kind of measurement at a rate.
type Kind = fn(f64) -> Measurement;

fn wave(rate: f64) -> Measurement {
    Measurement::Oscillation { omega: rate, storage: f64::NAN, loss: f64::NAN }
}

fn step(rate: f64) -> Measurement {
    Measurement::Relaxation { time: 1.0 / rate, modulus: f64::NAN }
}

/// What a material shows at a temperature: what it shows at the reference at rates that are a_T times as high.
fn shown(material: &Relaxation, law: &ShiftLaw, temperature: f64, kind: Kind, rate: f64) -> Measurement {
    let factor = law.shift_factor(temperature).expect("within the law");
    material.answer(&kind(rate * factor)).faster(1.0 / factor)
}

/// Isotherms each 8 K from −20 °C to 60 °C over three decades, with a thermostat that wavers by 0.2 K.
fn rows(material: &Relaxation, law: &ShiftLaw, kind: Kind) -> Vec<(f64, Measurement)> {
    let temperatures = (0..=10).map(|i| 253.15 + 8.0 * f64::from(i));
    let rates = (0..=18).map(|i| 10_f64.powf(f64::from(i) / 6.0 - 1.0));
    let all = temperatures.flat_map(|temperature| rates.clone().map(move |rate| (temperature, rate)));
    let wavers = |i: usize| 0.2 * (7.3 * i as f64).sin();
    all.enumerate().map(|(i, (t, rate))| (t + wavers(i), shown(material, law, t, kind, rate))).collect()
}

fn isotherms(material: &Relaxation, law: &ShiftLaw, kind: Kind) -> Isotherms {
    Isotherms::new(rows(material, law, kind)).expect("isotherms")
}

/// Shifts, law and moduli come back: shifts within 0.05 decades over ten steps, moduli within 5 %.
#[test]
fn a_known_law_comes_back_from_isotherms() {
    for kind in [wave as Kind, step] {
        for law in [WLF, ARRHENIUS] {
            let all = isotherms(&rubber(), &law, kind);
            let (curve, measurements) = MasterCurve::by_overlap(&all, REFERENCE, VerticalShift::None).expect("a curve");
            assert_eq!(curve.shifts.len(), 11);
            for shift in &curve.shifts {
                let exact = law.log_shift_factor(shift.temperature).expect("within the law");
                assert!((shift.log_factor - exact).abs() < 0.05, "{law:?}: {shift:?}, not {exact}");
                assert!(shift.residual.is_none_or(|residual| residual < 0.02), "{shift:?}");
            }
            for row in measurements.rows() {
                let exact = rubber().answer(row);
                let ([a, b], [c, d]) = (row.moduli(), exact.moduli());
                assert!((a - c).hypot(b - d) < 0.05 * c.hypot(d), "{row:?}, not {exact:?}");
            }
            let best = &curve.laws[0];
            assert_eq!(best.law.name(), law.name(), "{:?}", curve.laws);
            assert!(best.rms_residual < 0.02, "{best:?}");
            match best.law {
                ShiftLaw::Wlf { c1, c2, .. } => {
                    assert!((c1 / 10.0 - 1.0).abs() < 0.1 && (c2 / 110.0 - 1.0).abs() < 0.1)
                }
                ShiftLaw::Arrhenius { activation_energy, .. } => {
                    assert!((activation_energy / 1.5e5 - 1.0).abs() < 0.02)
                }
            }
        }
    }
}

/// Moduli that are larger by 1/b_T at T come back, by the overlaps as by the law of the density.
#[test]
fn moduli_are_shifted_back() {
    let density = VerticalShift::Density { expansion: 6e-4 };
    let b = |temperature: f64| (1.0 + 6e-4 * (temperature - REFERENCE)) * REFERENCE / temperature;
    let all = rows(&rubber(), &WLF, wave).into_iter();
    let rows = all.map(|(temperature, row)| (temperature, row.stiffer(1.0 / b(temperature)))).collect();
    let all = Isotherms::new(rows).expect("isotherms");
    let error = |vertical: VerticalShift| {
        let (curve, measurements) = MasterCurve::by_overlap(&all, REFERENCE, vertical).expect("a curve");
        for shift in &curve.shifts {
            let exact = if vertical == VerticalShift::None { 0.0 } else { b(shift.temperature).log10() };
            assert!((shift.log_vertical - exact).abs() < 0.01, "{vertical:?}: {shift:?}, not {exact}");
        }
        let misses = measurements.rows().iter().map(|row| {
            let ([a, b], [c, d]) = (row.moduli(), rubber().answer(row).moduli());
            (a - c).hypot(b - d) / c.hypot(d)
        });
        misses.fold(0.0, f64::max)
    };
    let [none, fitted, known] = [VerticalShift::None, VerticalShift::Overlap, density].map(error);
    assert!(fitted < 0.05 && known < 0.05 && none > 2.0 * known, "{none} {fitted} {known}");
}

/// Given the factors themselves, shifts and moduli are exact, at any reference.
#[test]
fn given_factors_are_taken() {
    let exact = |temperature| (temperature, WLF.log_shift_factor(temperature).expect("within the law"));
    // close enough for straight lines between them
    let factors = ShiftFactors::new((0..=1000).map(|i| exact(252.0 + 0.1 * f64::from(i))).collect()).expect("factors");
    assert!((factors.reference().expect("one within") - REFERENCE).abs() < 0.01);
    let isotherms = isotherms(&rubber(), &WLF, wave);
    for (asked, reference) in [(None, REFERENCE), (Some(REFERENCE), REFERENCE), (Some(313.15), 313.15)] {
        let (curve, _) = MasterCurve::by_factors(&isotherms, &factors, asked, VerticalShift::None).expect("a curve");
        assert!((curve.reference - reference).abs() < 0.01);
        let zero = exact(reference).1;
        for shift in &curve.shifts {
            assert!((shift.log_factor - exact(shift.temperature).1 + zero).abs() < 2e-3, "{shift:?}");
            assert!(shift.residual.is_none_or(|residual| residual < 0.02), "{shift:?}");
        }
        assert_eq!(curve.laws[0].law.name(), "wlf");
        assert!(curve.laws[0].rms_residual < 2e-3, "{:?}", curve.laws[0]);
    }
}

/// A law is found from the factors that it gives, at another reference as well; of a straight line c₁ and c₂ are not.
#[test]
fn laws_are_found_from_their_own_factors() {
    let factors = |law: &ShiftLaw| -> Vec<(f64, f64)> {
        let at = |i: i32| 260.0 + 7.0 * f64::from(i);
        (0..=12).map(|i| (at(i), law.log_shift_factor(at(i)).expect("within the law"))).collect()
    };
    for (c1, c2) in [(17.44, 51.6), (8.86, 101.6), (5.0, 150.0)] {
        let law = ShiftLaw::Wlf { c1, c2, reference: REFERENCE };
        let fits = ShiftLawFit::all(&factors(&law), REFERENCE);
        let ShiftLaw::Wlf { c1: found, c2: other, .. } = fits[0].law else { panic!("{fits:?}") };
        assert!((found / c1 - 1.0).abs() < 1e-6 && (other / c2 - 1.0).abs() < 1e-6, "{fits:?}");
    }
    let fits = ShiftLawFit::all(&factors(&ARRHENIUS), REFERENCE);
    assert!(
        matches!(fits[0].law, ShiftLaw::Arrhenius { activation_energy, .. }
        if (activation_energy / 1.5e5 - 1.0).abs() < 1e-12),
        "{fits:?}"
    );
    let line: Vec<(f64, f64)> = (0..5).map(|i| (273.15 + 10.0 * f64::from(i), 2.0 - f64::from(i))).collect();
    assert!(ShiftLawFit::all(&line, REFERENCE).iter().all(|fit| fit.law.name() == "arrhenius"));
}

#[test]
fn what_cannot_be_shifted_is_told() {
    let material = rubber();
    let all = isotherms(&material, &WLF, wave);
    assert!(matches!(
        MasterCurve::by_overlap(&all, 400.0, VerticalShift::None),
        Err(MasterCurveError::Outside { temperature: 400.0, .. })
    ));
    let far: Vec<_> = rows(&material, &WLF, wave).into_iter().filter(|row| row.0 < 254.0 || row.0 > 300.0).collect();
    let far = Isotherms::new(far).expect("isotherms");
    assert!(matches!(
        MasterCurve::by_overlap(&far, 310.0, VerticalShift::None),
        Err(MasterCurveError::NoOverlap { .. })
    ));
    let factors = |pairs: &[(f64, f64)]| ShiftFactors::new(pairs.to_vec());
    assert_eq!(factors(&[(300.0, 0.0)]), Err(ShiftFactorsError::TooFew));
    assert_eq!(factors(&[(300.0, 0.0), (300.0, 1.0)]), Err(ShiftFactorsError::Twice { temperature: 300.0 }));
    assert_eq!(factors(&[(300.0, 0.0), (310.0, 1.0)]), Err(ShiftFactorsError::Rises { temperature: 310.0 }));
    let short = factors(&[(290.0, 1.0), (300.0, 0.5)]).expect("factors");
    assert_eq!(MasterCurve::by_factors(&all, &short, None, VerticalShift::None), Err(MasterCurveError::NoReference));
    assert!(matches!(
        MasterCurve::by_factors(&all, &short, Some(295.0), VerticalShift::None),
        Err(MasterCurveError::Outside { .. })
    ));
}

#[test]
fn rows_that_are_no_isotherms_are_told() {
    let row = |temperature: f64, rate: f64| (temperature, shown(&solid(1e6, &[(1e7, 1.0)]), &WLF, 293.15, wave, rate));
    let ramp: Vec<_> = (0..50).map(|i| row(273.15 + 0.5 * f64::from(i), 1.0 + f64::from(i % 3))).collect();
    assert!(matches!(Isotherms::new(ramp), Err(IsothermsError::Drift { .. })));
    assert!(matches!(
        Isotherms::new(vec![row(280.0, 1.0), row(280.0, 2.0), row(290.0, 1.0)]),
        Err(IsothermsError::OneRate { temperature: 290.0 })
    ));
    assert_eq!(Isotherms::new(Vec::new()), Err(IsothermsError::Empty));
    let two = Isotherms::new(vec![row(280.1, 1.0), row(290.0, 2.0), row(279.9, 2.0), row(290.0, 1.0)]).expect("two");
    assert_eq!(two.all().iter().map(|one| one.temperature).collect::<Vec<_>>(), [280.0, 290.0]);
    assert_eq!(two.range(), (280.0, 290.0));
}

/// A glass, which hardly changes with rate and temperature, is no rubber, and factors far apart leave no overlap.
#[test]
fn moduli_that_cannot_be_shifted_are_told() {
    let row = |temperature: f64, rate: f64| {
        let (storage, loss) = (8e9 * rate.powf(0.002), 1e8);
        (temperature, Measurement::Oscillation { omega: rate, storage, loss })
    };
    let rates = (0..=18).map(|i| 10_f64.powf(f64::from(i) / 6.0));
    let rows = [230.0, 240.0].into_iter().flat_map(|temperature| rates.clone().map(move |rate| row(temperature, rate)));
    let glass = Isotherms::new(rows.collect()).expect("isotherms");
    let said = |found: Result<_, MasterCurveError>| found.expect_err("nothing overlaps").to_string();
    let rubber = said(MasterCurve::by_overlap(&glass, 240.0, VerticalShift::Density { expansion: 0.0 }));
    assert!(rubber.contains("those of a glass do not follow that. Leave out --vertical-shift density"), "{rubber}");
    let factors = ShiftFactors::new(vec![(230.0, 9.0), (240.0, 0.0)]).expect("factors");
    let far = said(MasterCurve::by_factors(&glass, &factors, None, VerticalShift::Overlap));
    assert!(far.contains("do not overlap where the shift factors lay them"), "{far}");
    assert!(MasterCurve::by_factors(&glass, &factors, None, VerticalShift::None).is_ok());
}
