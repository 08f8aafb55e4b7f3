//! The large-β approximation.

use stribeck_solver::exact::{ChainLimits, DryContact, LargeBeta, approx_elastic_c, approx_elastic_film, limits};
use stribeck_solver::{Limits, Parameters, RetardationMode, Substrate};

fn approximation(alpha: f64, beta: f64, f: f64) -> LargeBeta {
    LargeBeta::new(&Parameters::new(alpha, beta, f)).expect("one retardation time")
}

fn cases() -> impl Iterator<Item = (f64, f64, f64)> {
    let alphas = [0.0, 0.01, 1.0, 30.0, f64::INFINITY];
    let cases = alphas.into_iter().flat_map(|alpha| [0.0, 1.0, 100.0].map(|f| (alpha, f)));
    cases.flat_map(|(alpha, f)| [10.0, 1e3, 1e6].map(|beta| (alpha, beta, f)))
}

/// Film is c where the pressure is largest, thicker ahead (up to 3c/2), thinner behind, and it never grows towards the
/// outlet of a contact with one maximum of the pressure.
#[test]
fn film_is_c_at_the_peak_and_narrows_to_the_outlet() {
    for (alpha, beta, f) in cases() {
        let approximation = approximation(alpha, beta, f);
        let (contact, c) = (approximation.contact(), approximation.approx_c());
        let film = |x| approximation.approx_film(x).expect("inside");
        assert!((film(contact.peak().0) / c - 1.0).abs() < 1e-3, "alpha={alpha}, beta={beta}, f={f}");
        let places = (0..=200).map(|i| contact.centre() + contact.half_width() * 0.999999 * f64::from(i - 100) / 100.0);
        let films: Vec<f64> = places.map(film).collect();
        assert!(films.iter().all(|&u| u > 0.0 && u <= 1.5 * c));
        if f == 0.0 {
            assert!(films.is_sorted());
        }
        assert_eq!(film(contact.leading_edge()), 1.5 * c);
        assert!(film(contact.trailing_edge()) < 1e-3 * c);
        assert_eq!(approximation.approx_film(contact.leading_edge() + 1e-3), None);
        assert_eq!(approximation.approx_film(contact.trailing_edge() - 1e-3), None);
    }
}

/// The film solves (T2) with the dry pressure gradient wherever a film can carry it.
#[test]
fn film_conserves_the_flow() {
    for (alpha, f) in [(1.0, 10.0), (0.1, 1.0), (5.0, 100.0)] {
        let beta = 200.0;
        let approximation = approximation(alpha, beta, f);
        let (contact, c) = (approximation.contact(), approximation.approx_c());
        let mut carried = 0;
        for i in -9..=9 {
            let x = contact.centre() + contact.half_width() * f64::from(i) / 10.0;
            let h = 1e-4 * contact.half_width();
            let p = contact.pressure_on(&[x - 2.0 * h, x - h, x + h, x + 2.0 * h]);
            let gradient = (8.0 * (p[2] - p[1]) - (p[3] - p[0])) / (12.0 * h);
            if beta * c * c * gradient > -4.0 / 27.0 {
                let u = approximation.approx_film(x).expect("inside");
                let residual = beta * gradient * u.powi(3) + u - c;
                assert!(residual.abs() < 1e-8 * c, "alpha={alpha}, f={f}, x={x}: {residual}");
                carried += 1;
            }
        }
        assert!(carried > 10);
    }
}

#[test]
fn every_corner_has_a_number() {
    for alpha in [0.0, 1e-6, 1e-2, 1.0, 1e3, 1e6, f64::INFINITY] {
        for f in [0.0, 1e-6, 1.0, 1e3, 1e6] {
            for beta in [1e-2, 10.0, 1e4, 1e9] {
                let approximation = approximation(alpha, beta, f);
                assert!(approximation.approx_c() > 0.0 && approximation.approx_mu_v() >= 0.0);
                assert!(approximation.approx_mu_h().is_finite(), "alpha={alpha}, beta={beta}, f={f}");
            }
        }
    }
}

/// ∫ (c/u − ⅔)/u dx over the dry contact by the middles of many cells, in ln tan(θ/2) so that layers at the edges are
/// resolved too.
fn shear_by_cells(approximation: &LargeBeta, cells: u32) -> f64 {
    let (contact, c) = (approximation.contact(), approximation.approx_c());
    let (low, high) = (-11.0, 11.0);
    let step = (high - low) / f64::from(cells);
    let terms = (0..cells).map(|i| {
        let eta: f64 = low + (f64::from(i) + 0.5) * step;
        let u = approximation.approx_film(contact.centre() - contact.half_width() * eta.tanh()).expect("inside");
        (c / u - 2.0 / 3.0) / u * contact.half_width() / eta.cosh().powi(2) * step
    });
    terms.sum()
}

/// F_h against the shear (Eq. 20) by another quadrature. The last four have a dip of p′ behind the leading edge that a
/// film can just carry, or just not.
#[test]
fn shear_is_the_integral_over_the_contact() {
    let cases = [(1.0, 100.0, 0.0), (1.0, 100.0, 10.0), (0.1, 1e3, 100.0), (10.0, 1e4, 10.0)];
    let dips = [140.0, 158.489_319_246_111_42, 170.0, 200.0].map(|beta| (1000_f64.sqrt(), beta, 100.0));
    for (alpha, beta, f) in cases.into_iter().chain(dips) {
        let approximation = approximation(alpha, beta, f);
        let shear = shear_by_cells(&approximation, 40_000) / (std::f64::consts::PI * beta);
        let error = approximation.approx_mu_h() / shear - 1.0;
        assert!(error.abs() < 2e-6, "alpha={alpha}, beta={beta}, f={f}: {error:e}");
    }
}

/// Eq. 36 is the cubic with the Hertzian gradient, to second order in x. Its coefficient 0.197² stands for βc², so it
/// is compared where the second term of Eq. 34 is small.
#[test]
fn elastic_film_is_the_cubic_near_the_middle() {
    let beta = 1e12;
    let approximation = approximation(f64::INFINITY, beta, 3.0);
    assert_eq!(approximation.approx_c(), approx_elastic_c(beta));
    for x in [-0.2, -0.05, 0.0, 0.05, 0.2] {
        let cubic = approximation.approx_film(x).expect("inside");
        assert!((approx_elastic_film(beta, x) / cubic - 1.0).abs() < 0.1 * f64::abs(x).powi(3) + 1e-6, "x={x}");
    }
}

/// α → 0 is an elastic problem at β/(1+f), with u in units of 1/(1+f): the first term of Eq. 49 keeps this law, the
/// second does not.
#[test]
fn first_term_of_c_scales_with_the_instantaneous_modulus() {
    let (beta, f) = (1e10, 8.0);
    let rescaled = approx_elastic_c(beta / (1.0 + f)) / (1.0 + f);
    assert!((approximation(0.0, beta, f).approx_c() / rescaled - 1.0).abs() < 1e-3);
    assert!((approximation(0.0, 10.0, f).approx_c() / approx_elastic_c(10.0 / 9.0) * 9.0 - 1.0).abs() > 0.1);
}

/// Close to solutions where it should be: elastic or nearly so, β = 1000; F_v everywhere above the solution and
/// within 5 % of it at β = 10⁴.
#[test]
fn approaches_solutions() {
    let rows = include_str!("../reference/single_mode.csv").lines().skip(1);
    let mut compared = 0;
    for row in rows {
        let row: Vec<f64> = row.split(',').map(|text| text.parse().unwrap()).collect();
        let (f, alpha, beta, viscoelastic, film) = (row[0], row[1], row[2], row[7], row[8]);
        let approximation = approximation(alpha, beta, f);
        if f > 0.0 {
            let excess = approximation.approx_mu_v() / viscoelastic - 1.0;
            assert!(excess > 0.0, "dry friction is the upper limit: f={f}, alpha={alpha}, beta={beta}");
            assert!(beta < 1e4 || excess < 0.05, "f={f}, alpha={alpha}, beta={beta}: {excess}");
        }
        if beta == 1000.0 && (f == 0.0 || alpha == 100.0) {
            let error = approximation.approx_mu_h() / film - 1.0;
            assert!(error.abs() < 0.06, "f={f}, alpha={alpha}: {error}");
        }
        compared += 1;
    }
    assert_eq!(compared, 84);
}

#[test]
fn the_shear_is_published_for_one_retardation_time_only() {
    let single = Parameters::new(1.0, 100.0, 10.0);
    let known = limits(&single);
    assert_eq!(known.dry_mu_v, DryContact::new(1.0, 10.0).friction());
    assert_eq!(known.approx_mu_h, approximation(1.0, 100.0, 10.0).approx_mu_h());
    let mode = |share, time| RetardationMode { share, time };
    let substrate = Substrate::new(vec![mode(0.5, 1.0), mode(0.5, 3.0)]).unwrap();
    let Limits { dry_mu_v, approx_mu_h } = limits(&Parameters { substrate, ..single });
    assert!(dry_mu_v > 0.0 && approx_mu_h.is_nan());
}

/// One after the other or each alone, the limits are the same; what is kept from one case is not taken for another.
#[test]
fn limits_along_a_chain_are_those_of_each_case() {
    let slow = Substrate::new(vec![RetardationMode { share: 1.0, time: 100.0 }]).unwrap();
    let mode = |share, time| RetardationMode { share, time };
    let several = Substrate::new(vec![mode(0.5, 1.0), mode(0.5, 3.0)]).unwrap();
    let case = |alpha, beta, f| Parameters::new(alpha, beta, f);
    let cases = [
        case(1.0, 10.0, 10.0),
        case(1.0, 100.0, 10.0),
        case(2.0, 100.0, 10.0),
        case(2.0, 100.0, 0.0),
        Parameters { substrate: slow, ..case(2.0, 100.0, 10.0) },
        Parameters { substrate: several, ..case(2.0, 100.0, 10.0) },
        case(f64::INFINITY, 100.0, 10.0),
        case(0.0, 1e4, 10.0),
        case(1.0, 10.0, 10.0),
    ];
    let mut chain = ChainLimits::default();
    for case in cases {
        let (along, alone) = (chain.of(&case), limits(&case));
        assert_eq!(along.dry_mu_v.to_bits(), alone.dry_mu_v.to_bits(), "{case:?}");
        assert_eq!(along.approx_mu_h.to_bits(), alone.approx_mu_h.to_bits(), "{case:?}");
        assert!(along.dry_mu_v.is_finite());
        assert_eq!(along.approx_mu_h.is_nan(), case.substrate.modes().len() > 1);
    }
}
