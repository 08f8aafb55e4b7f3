//! Two bodies, each rigid, elastic or viscoelastic, at speeds of their own: laws that hold whatever the numbers are.

use std::num::NonZeroUsize;

use stribeck_solver::Interrupt;
use stribeck_sweep::campaign::{InMemory, solve_in_memory};
use stribeck_sweep::{Column, Grid, Plan, Sweep, Values};

const EXPERIMENT: &str = "[laboratory]\nradius = \"10 mm\"\nload = \"400 N/m\"\nviscosity = \"80 mPa s\"\n";
/// A rubber and another one, softer and slower.
const RUBBER: &str = "relaxed_modulus = \"1.5 MPa\"\npoisson_ratio = 0.5\n\
                      relaxation = [{ fraction = 0.3, time = \"2 ms\" }, { fraction = 0.2, time = \"30 ms\" }]\n";
const SOFTER: &str = "instantaneous_modulus = \"2 MPa\"\npoisson_ratio = 0.4\nf = 3.0\nretardation_time = \"20 ms\"\n";
const TOLERANCE: &str = "[solver]\ntolerance = 1e-8\n[output]\nlimits = false\nfields = []\n";

/// A sweep of these speeds and bodies.
fn sweep(speeds: &str, bodies: &str) -> Sweep {
    Sweep::parse("bodies", &format!("{EXPERIMENT}{speeds}{bodies}{TOLERANCE}")).expect(bodies)
}

/// The values in SI units of every place of a sweep.
fn solved(sweep: &Sweep) -> Vec<Values> {
    let plan = Plan::new(sweep);
    let solved = solve_in_memory(sweep, NonZeroUsize::MIN, &Interrupt::new()).expect("a thread");
    let InMemory::Solved(entries) = solved else { panic!("no one stops it") };
    let shape = sweep.grid.shape();
    let of_place = |place| {
        let index = shape.index(place);
        let entry = &entries[&plan.case_at(index)];
        assert!(entry.reason.is_empty(), "{}", entry.reason);
        let mut values = entry.values.at_slide_roll(sweep.grid.slide_roll(index));
        for column in Column::ALL {
            values[column] *= sweep.grid.experiment(index).map_or(1.0, |it| it.scales().factor(column.units()));
        }
        values
    };
    (0..shape.places()).map(of_place).collect()
}

/// Checks that a number is another one to a part of it.
fn check(found: f64, expected: f64, part: f64, what: &str) {
    assert!((found - expected).abs() <= part * expected.abs(), "{what}: {found} is not {expected}");
}

fn rolling(entrainment: &str, ratio: f64) -> String {
    format!("entrainment_speed = {entrainment}\nslide_roll_ratio = {ratio:?}\n")
}

const SPEEDS: &str = "[0.01, 0.1]";
/// What does not depend on names.
const FILM: [Column; 6] =
    [Column::MuV, Column::MuPressure, Column::MuShear, Column::FilmMin, Column::PMax, Column::XOutlet];

/// Whoever is called the roller: with bodies and speeds exchanged the film is the same, and the hysteresis of each is
/// that of the other name.
#[test]
fn exchanged_bodies_exchange_their_names() {
    for (ratio, [one, other]) in [(0.6, [RUBBER, SOFTER]), (-1.2, [RUBBER, "rigid = true\n"]), (2.0, [SOFTER, RUBBER])]
    {
        let here = solved(&sweep(&rolling(SPEEDS, ratio), &format!("[flat]\n{one}[roller]\n{other}")));
        let there = solved(&sweep(&rolling(SPEEDS, -ratio), &format!("[flat]\n{other}[roller]\n{one}")));
        for (here, there) in here.iter().zip(&there) {
            for column in FILM {
                check(here[column], there[column], 2e-7, column.name());
            }
            check(here[Column::MuVFlat], there[Column::MuVRoller], 2e-7, "hysteresis");
            check(here[Column::MuVRoller], there[Column::MuVFlat], 2e-7, "hysteresis");
            // D here is P + C S less F_v of the other, and so is M there with the other sign
            check(here[Column::MuDrag], -there[Column::MuTorque], 2e-7, "drag and torque");
        }
    }
}

/// Two bodies of one material in pure rolling are one body of twice the compliance under a rigid roller, and each does
/// half of the hysteresis.
#[test]
fn equal_bodies_that_roll_are_one_of_twice_the_compliance() {
    let halved = RUBBER.replace("1.5 MPa", "0.75 MPa");
    let two = solved(&sweep(&rolling(SPEEDS, 0.0), &format!("[flat]\n{RUBBER}[roller]\n{RUBBER}")));
    let one = solved(&sweep(&rolling(SPEEDS, 0.0), &format!("[substrate]\n{halved}")));
    for (two, one) in two.iter().zip(&one) {
        for column in FILM {
            check(two[column], one[column], 2e-7, column.name());
        }
        check(two[Column::MuVRoller], 0.5 * one[Column::MuV], 2e-7, "half of the hysteresis");
        check(two[Column::MuVFlat], 0.5 * one[Column::MuV], 2e-7, "half of the hysteresis");
        check(two[Column::MuDrag], one[Column::MuDrag] - 0.5 * one[Column::MuV], 2e-7, "drag");
    }
}

/// A body at rest in the contact has all the time there is: it is its relaxed elastic self, and shows no hysteresis.
#[test]
fn a_body_at_rest_is_relaxed() {
    let elastic = "relaxed_modulus = 0.5e6\npoisson_ratio = 0.4\n";
    let speed = format!("speed = {SPEEDS}\n");
    let at_rest = solved(&sweep(&speed, &format!("[flat]\n{RUBBER}[roller]\n{SOFTER}")));
    let relaxed = solved(&sweep(&speed, &format!("[flat]\n{RUBBER}[roller]\n{elastic}")));
    for (at_rest, relaxed) in at_rest.iter().zip(&relaxed) {
        assert_eq!(at_rest[Column::MuVRoller], 0.0);
        assert!(at_rest[Column::MuVFlat] > 1e-3);
        for column in FILM {
            check(at_rest[column], relaxed[column], 2e-7, column.name());
        }
    }
}

/// Each body alone has both limits of α: a roller that creeps far too slowly is its stiff elastic self, one that creeps at
/// once its relaxed one.
#[test]
fn a_body_alone_has_both_limits() {
    let roller = |rest: &str| format!("[flat]\n{RUBBER}[roller]\npoisson_ratio = 0.4\n{rest}");
    let values = |rest: &str| solved(&sweep(&rolling(SPEEDS, 0.5), &roller(rest)));
    for (time, modulus) in [("1e9", 2e6), ("1e-9", 0.5e6)] {
        let creeping = values(&format!("relaxed_modulus = 0.5e6\nf = 3.0\nretardation_time = {time}\n"));
        let elastic = values(&format!("relaxed_modulus = {modulus:?}\n"));
        for (creeping, elastic) in creeping.iter().zip(&elastic) {
            for column in [Column::MuVFlat, Column::MuDrag, Column::MuPressure, Column::FilmMin, Column::PMax] {
                check(creeping[column], elastic[column], 1e-6, column.name());
            }
            assert!(creeping[Column::MuVRoller] < 1e-6 * creeping[Column::MuVFlat]);
        }
    }
}

/// Two elastic bodies are one whose compliance is the sum: 1/E* = 1/1.5e6 + 1/3e6 is that of 1 MPa.
#[test]
fn compliances_add() {
    let elastic = |modulus: &str| format!("relaxed_modulus = {modulus}\npoisson_ratio = 0.0\n");
    let two = format!("[flat]\n{}[roller]\n{}", elastic("1.5e6"), elastic("3e6"));
    let two = solved(&sweep(&rolling(SPEEDS, 0.4), &two));
    let one = solved(&sweep(&rolling(SPEEDS, 0.4), &format!("[flat]\n{}", elastic("1e6"))));
    for (two, one) in two.iter().zip(&one) {
        for column in [Column::MuDrag, Column::MuH, Column::FilmMin, Column::PMax] {
            check(two[column], one[column], 1e-9, column.name());
        }
        assert_eq!(two[Column::MuV], 0.0);
    }
}

/// The power that the drives put in is what is lost, for two viscoelastic bodies at any ratio (T56).
#[test]
fn power_is_balanced_for_two_bodies_of_a_laboratory() {
    let speeds = format!("entrainment_speed = {SPEEDS}\nslide_roll_ratio = [-2.0, -1.0, 0.0, 1.0, 2.0]\n");
    for values in solved(&sweep(&speeds, &format!("[flat]\n{RUBBER}[roller]\n{SOFTER}"))) {
        assert!(values[Column::EnergyResidual] < 1e-7, "{}", values[Column::EnergyResidual]);
    }
}

/// Over α, β and f the slide-to-roll ratio costs nothing: places that differ in it are one problem, and the drag changes
/// by C for each unit of S.
#[test]
fn ratios_cost_no_solution() {
    let axes = |ratios: &str| format!("[axes]\n{ratios}f = [0.0, 10.0]\nalpha = [1.0, inf]\nbeta = [10.0, 100.0]\n");
    let parsed = |text: String| Sweep::parse("ratios", &(text + TOLERANCE)).expect("valid");
    let (one, several) = (parsed(axes("")), parsed(axes("slide_roll = [-0.5, 0.0, 1.0]\n")));
    assert_eq!(Plan::new(&several).problems(), Plan::new(&one).problems());
    assert_eq!(several.grid.cases(), 3 * one.grid.cases());
    let (one, several) = (solved(&one), solved(&several));
    for (ratio, values) in [-0.5, 0.0, 1.0].into_iter().zip(several.chunks(one.len())) {
        for (at_one, values) in one.iter().zip(values) {
            check(
                values[Column::MuDrag],
                at_one[Column::MuDrag] - (1.0 - ratio) * at_one[Column::MuShear],
                1e-12,
                "drag",
            );
            assert_eq!(values[Column::FilmMin], at_one[Column::FilmMin]);
        }
    }
}

/// Over α, β and f too a roller of several modes is the flat of those modes where both move alike, and relaxed where it
/// does not turn.
#[test]
fn modes_of_the_roller_go_with_its_speed() {
    let axes =
        |ratio: f64| format!("[axes]\nslide_roll = [{ratio:?}]\nf = [10.0]\nalpha = [1.0]\nbeta = [30.0, 100.0]\n");
    let flat = "[flat]\nmodes = [{ share = 0.6, time = 1.0 }, { share = 0.4, time = 10.0 }]\n";
    let both = "[flat]\nmodes = [{ share = 0.6, time = 1.0 }]\n[roller]\nmodes = [{ share = 0.4, time = 10.0 }]\n";
    let parsed = |ratio, bodies: &str| Sweep::parse("modes", &(axes(ratio) + bodies + TOLERANCE)).expect("valid");
    let (one, two) = (solved(&parsed(0.0, flat)), solved(&parsed(0.0, both)));
    for (one, two) in one.iter().zip(&two) {
        check(two[Column::MuV], one[Column::MuV], 1e-7, "hysteresis of both");
        check(two[Column::MuDrag], one[Column::MuDrag] - two[Column::MuVRoller], 1e-7, "drag");
        assert!(two[Column::MuVRoller] > 1e-3 && two[Column::MuVFlat] > 1e-3);
    }
    // w = [e + 10 (0.6 v + 0.4 e)]/11, which is f' = 6/5
    let relaxed = "[axes]\nf = [1.2]\nalpha = [1.0]\nbeta = [30.0, 100.0]\n".to_owned() + TOLERANCE;
    let (one, two) = (solved(&Sweep::parse("relaxed", &relaxed).expect("valid")), solved(&parsed(1.0, both)));
    for (one, two) in one.iter().zip(&two) {
        check(two[Column::MuDrag], one[Column::MuDrag], 1e-7, "drag");
    }
}

/// Runs with swapped bodies are places of their own, at opposite ratios.
#[test]
fn swapped_runs_are_at_opposite_ratios() {
    let speeds = format!("swap = true\nentrainment_speed = {SPEEDS}\nslide_roll_ratio = [0.0, 0.5]\n");
    let sweep = sweep(&speeds, &format!("[flat]\n{RUBBER}"));
    let Grid::Laboratory(axes) = &sweep.grid else { panic!("it has quantities of the laboratory") };
    let shape = axes.shape();
    assert_eq!(shape.places(), 3 * 2);
    for place in 0..shape.places() {
        let index = shape.index(place);
        let swapped = axes.swapped(index).expect("bodies are swapped");
        let [here, there] = [index, swapped].map(|index| axes.experiment(index).motion);
        assert_eq!((here.flat_speed(), here.roller_speed()), (there.roller_speed(), there.flat_speed()));
        assert_eq!(axes.swapped(swapped), Some(index));
    }
}
