//! Plans: every problem once, in chains that depend on the sweep alone, with ids that depend on the problem alone.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::time::{Duration, Instant};

use proptest::prelude::*;
use stribeck_solver::relaxation::{Acceleration, Domain};
use stribeck_solver::{CavityShear, FieldSelection, Output, Parameters, RetardationMode, Substrate};
use stribeck_sweep::{
    Axes, CaseId, Chain, FieldPrecision, Fingerprint, Grid, GridIndex, MAX_CHAIN, Method, Part, Plan, Recipe,
    SolverSettings, Sweep,
};

fn sweep(f: &[f64], alpha: &[f64], beta: &[f64]) -> Sweep {
    Sweep {
        title: "plan".into(),
        grid: Axes { slide_roll: None, f: f.to_vec(), alpha: alpha.to_vec(), beta: beta.to_vec() }.into(),
        substrate: Substrate::default(),
        solver: SolverSettings::default(),
        output: Output::default(),
        field_precision: FieldPrecision::Double,
        text: String::new(),
        name: "plan".into(),
    }
}

/// The settings of a sweep that is solved by a method.
fn by(method: Method) -> SolverSettings {
    SolverSettings { method, ..SolverSettings::default() }
}

const METHODS: [Method; 2] = [Method::Collocation, Method::Relaxation];

fn two_modes() -> Substrate {
    let modes = vec![RetardationMode { share: 0.7, time: 1.0 }, RetardationMode { share: 0.3, time: 100.0 }];
    Substrate::new(modes).expect("valid")
}

fn axes(sweep: &Sweep) -> &Axes {
    sweep.grid.axes().expect("a dimensionless sweep")
}

fn axes_mut(sweep: &mut Sweep) -> &mut Axes {
    match &mut sweep.grid {
        Grid::Dimensionless(axes) => axes,
        Grid::Laboratory(_) => panic!("a dimensionless sweep"),
    }
}

/// Every grid point in the order of publication.
fn places(sweep: &Sweep) -> Vec<GridIndex> {
    let Axes { f: strengths, alpha, beta, .. } = axes(sweep);
    let mut places = Vec::new();
    for f in 0..strengths.len() {
        for row in 0..alpha.len() {
            places.extend((0..beta.len()).map(|along| GridIndex { block: f, row, along }));
        }
    }
    places
}

/// What of a grid point matters to the equations: nothing but β where the substrate is relaxed elastic.
fn problem(sweep: &Sweep, place: GridIndex) -> (u64, u64, u64) {
    let Axes { f, alpha, beta, .. } = axes(sweep);
    let (f, alpha, beta) = (f[place.block], alpha[place.row], beta[place.along]);
    let (f, alpha) = if f == 0.0 || alpha.is_infinite() { (0.0, f64::INFINITY) } else { (f, alpha) };
    (f.to_bits(), alpha.to_bits(), beta.to_bits())
}

fn axis(zero: bool, infinity: bool, longest: usize) -> impl Strategy<Value = Vec<f64>> {
    let value = prop_oneof![
        8 => 1e-3..1e3f64,
        u32::from(zero) => Just(0.0),
        u32::from(infinity) => Just(f64::INFINITY),
    ];
    prop::collection::vec(value, 1..longest).prop_map(|mut values| {
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    })
}

fn sweeps() -> impl Strategy<Value = Sweep> {
    let method = prop_oneof![Just(Method::Collocation), Just(Method::Relaxation)];
    (axis(true, false, 5), axis(true, true, 6), axis(false, false, 160), any::<bool>(), method).prop_map(
        |(f, alpha, beta, several, method)| {
            let mut sweep = sweep(&f, &alpha, &beta);
            sweep.solver.method = method;
            if several {
                sweep.substrate = two_modes();
            }
            sweep
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_problem_is_in_exactly_one_chain(sweep in sweeps()) {
        let plan = Plan::new(&sweep);
        let mut seen = HashSet::new();
        for chain in plan.chains() {
            let (parameters, ids) = (plan.parameters(&chain), plan.ids(&chain));
            prop_assert_eq!(parameters.len(), ids.len());
            for (parameters, id) in parameters.iter().zip(&ids) {
                prop_assert_eq!(plan.id(parameters), *id);
                prop_assert!(seen.insert(*id), "solved twice: {:?}", parameters);
            }
        }
        let grid: HashMap<_, CaseId> =
            places(&sweep).into_iter().map(|place| (problem(&sweep, place), plan.case_at(place))).collect();
        let distinct: HashSet<CaseId> = grid.values().copied().collect();
        prop_assert_eq!(distinct.len(), grid.len(), "two problems share an id");
        prop_assert_eq!(&seen, &distinct);
        prop_assert_eq!((plan.problems(), plan.cases()), (seen.len(), places(&sweep).len()));
    }

    #[test]
    fn chains_are_contiguous_ascending_short_and_balanced(sweep in sweeps()) {
        let plan = Plan::new(&sweep);
        let limit = sweep.solver.method.chain_limit();
        prop_assert!(limit <= MAX_CHAIN);
        let chains: Vec<Chain> = plan.chains().collect();
        prop_assert_eq!(chains.len(), plan.chain_count());
        let mut rows = BTreeSet::new();
        for row in chains.chunk_by(|left, right| left.row == right.row) {
            prop_assert!(rows.insert(row[0].row), "the chains of a row are neighbours");
            prop_assert_eq!(row[0].cases.start, 0);
            prop_assert_eq!(row[row.len() - 1].cases.end, axes(&sweep).beta.len());
            prop_assert!(row.windows(2).all(|pair| pair[0].cases.end == pair[1].cases.start));
            let lengths: Vec<usize> = row.iter().map(|chain| chain.cases.len()).collect();
            let (shortest, longest) = (lengths.iter().min().unwrap(), lengths.iter().max().unwrap());
            prop_assert!(*longest <= limit && longest - shortest <= 1 && *shortest > 0, "{:?}", lengths);
            prop_assert_eq!(lengths.len(), axes(&sweep).beta.len().div_ceil(limit), "no more chains than needed");
        }
        prop_assert!(rows.into_iter().eq(0..plan.rows()));
        for chain in &chains {
            let cases = plan.parameters(chain);
            prop_assert!(cases.is_sorted_by(|left, right| left.beta < right.beta));
            let same = |case: &Parameters| (case.f, case.alpha, case.substrate.clone()) == (cases[0].f, cases[0].alpha, cases[0].substrate.clone());
            prop_assert!(cases.iter().all(same));
        }
        prop_assert_eq!(chains, Plan::new(&sweep).chains().collect::<Vec<_>>(), "the same plan each time");
    }

    #[test]
    fn rows_and_grid_places_belong_together(sweep in sweeps()) {
        let plan = Plan::new(&sweep);
        let by_row: HashMap<(usize, usize), CaseId> = plan
            .chains()
            .flat_map(|chain| chain.cases.clone().map(move |i_beta| (chain.row, i_beta)).zip(plan.ids(&chain)))
            .collect();
        let mut first = HashMap::new();
        for place in places(&sweep) {
            let id = plan.case_at(place);
            prop_assert_eq!(plan.id(&plan.parameters_at(place)), id);
            first.entry(id).or_insert(place);
        }
        prop_assert_eq!(by_row.len(), first.len());
        for ((row, case), id) in by_row {
            prop_assert_eq!(first.get(&id), Some(&plan.place(row, case)));
        }
        for (id, place) in first.into_iter().take(20) {
            prop_assert_eq!(plan.find(id), Some(place));
        }
        prop_assert_eq!(plan.find(CaseId(0)), None);
    }

    #[test]
    fn adding_values_to_an_axis_keeps_the_ids(
        small in sweeps(), f in axis(true, false, 4), alpha in axis(true, true, 4), beta in axis(false, false, 40),
    ) {
        let mut large = small.clone();
        for (axis, more) in
            {
                let Axes { f: own_f, alpha: own_alpha, beta: own_beta, .. } = axes_mut(&mut large);
                [(own_f, f), (own_alpha, alpha), (own_beta, beta)]
            }
        {
            axis.extend(more);
            axis.sort_by(f64::total_cmp);
            axis.dedup();
        }
        let ids = |sweep: &Sweep| -> HashMap<_, _> {
            let plan = Plan::new(sweep);
            places(sweep).into_iter().map(|place| (problem(sweep, place), plan.case_at(place))).collect()
        };
        let grown = ids(&large);
        prop_assert!(ids(&small).iter().all(|(problem, id)| grown.get(problem) == Some(id)));
    }
}

#[test]
fn elastic_cases_are_one_row_solved_once() {
    let mut sweep = sweep(&[0.0, 10.0, 100.0], &[0.0, 1.0, f64::INFINITY], &[10.0, 100.0]);
    sweep.substrate = two_modes();
    let plan = Plan::new(&sweep);
    // (0, any), (any, inf) make one row; (10 and 100) x (0 and 1) make four.
    assert_eq!((plan.cases(), plan.rows(), plan.problems()), (18, 5, 10));
    for place in [[0, 0, 1], [0, 1, 1], [0, 2, 1], [1, 2, 1], [2, 2, 1]] {
        assert_eq!(plan.case_at(place.into()), plan.case_at([0, 0, 1].into()));
        assert_eq!(plan.parameters_at(place.into()), Parameters::elastic(100.0));
    }
    let only_infinite = Plan::new(&self::sweep(&[10.0, 20.0], &[f64::INFINITY], &[10.0]));
    assert_eq!((only_infinite.rows(), only_infinite.problems(), only_infinite.cases()), (1, 1, 2));
    let only_zero = Plan::new(&self::sweep(&[0.0], &[1.0, 2.0, 3.0], &[10.0]));
    assert_eq!((only_zero.rows(), only_zero.problems(), only_zero.cases()), (1, 1, 3));
    assert_eq!(only_zero.case_at([0, 1, 0].into()), only_infinite.case_at([1, 0, 0].into()));
}

#[test]
fn modes_count_where_the_substrate_retards_and_only_there() {
    let one = sweep(&[0.0, 10.0], &[0.0, 1.0, f64::INFINITY], &[10.0]);
    let two = Sweep { substrate: two_modes(), ..one.clone() };
    let (one_plan, two_plan) = (Plan::new(&one), Plan::new(&two));
    for place in places(&one) {
        let retards = place.block == 1 && place.row == 1;
        assert_eq!(one_plan.case_at(place) != two_plan.case_at(place), retards);
    }
}

/// Changes of a sweep.
type Changes<'a> = &'a [&'a dyn Fn(&mut Sweep)];

/// A sweep of one case, and what each of the changes makes of it.
fn changed(method: Method, changes: Changes) -> Vec<Sweep> {
    let mut base = sweep(&[10.0], &[1.0], &[100.0]);
    base.solver.method = method;
    let with = |change: &&dyn Fn(&mut Sweep)| {
        let mut changed = base.clone();
        change(&mut changed);
        changed
    };
    let changed: Vec<Sweep> = changes.iter().map(with).collect();
    [vec![base], changed].concat()
}

fn distinct_ids(sweeps: &[Sweep]) -> usize {
    sweeps.iter().map(|sweep| Plan::new(sweep).case_at([0, 0, 0].into())).collect::<HashSet<_>>().len()
}

/// Changes of what the relaxation method is told.
const OF_RELAXATION: Changes = &[
    &|sweep| sweep.solver.relaxation.domain = Domain::Fixed { x_min: -3.0, x_max: 4.0 },
    &|sweep| sweep.solver.relaxation.domain = Domain::Fixed { x_min: -3.0, x_max: 5.0 },
    &|sweep| sweep.solver.relaxation.points = 803,
    &|sweep| sweep.solver.relaxation.tolerance = 1e-9,
    &|sweep| sweep.solver.relaxation.acceleration = Acceleration::None,
    &|sweep| sweep.solver.relaxation.estimate = true,
];

/// Changes of what the collocation method is told.
const OF_COLLOCATION: Changes =
    &[&|sweep| sweep.solver.tolerance = 1e-5_f64.next_up(), &|sweep| sweep.solver.tolerance = 1e-8];

#[test]
fn an_id_changes_with_all_that_changes_numbers() {
    let common: Changes = &[
        &|sweep| axes_mut(sweep).f = vec![10.0f64.next_up()],
        &|sweep| axes_mut(sweep).alpha = vec![1.0f64.next_up()],
        &|sweep| axes_mut(sweep).beta = vec![100.0f64.next_up()],
        &|sweep| *axes_mut(sweep) = Axes { f: vec![1.0], alpha: vec![10.0], ..axes(sweep).clone() },
        &|sweep| sweep.substrate = two_modes(),
        &|sweep| {
            let modes = vec![RetardationMode { share: 0.3, time: 1.0 }, RetardationMode { share: 0.7, time: 100.0 }];
            sweep.substrate = Substrate::new(modes).expect("valid");
        },
        &|sweep| sweep.output.cavity_shear = CavityShear::Streamers,
        &|sweep| sweep.output.cavity_shear = CavityShear::None,
    ];
    let of_either: Vec<Sweep> = [(Method::Collocation, OF_COLLOCATION), (Method::Relaxation, OF_RELAXATION)]
        .into_iter()
        .flat_map(|(method, own)| changed(method, &[common, own].concat()))
        .collect();
    assert_eq!(distinct_ids(&of_either), of_either.len());
}

#[test]
fn an_id_stays_whatever_the_other_method_is_told() {
    assert_eq!(distinct_ids(&changed(Method::Collocation, OF_RELAXATION)), 1);
    assert_eq!(distinct_ids(&changed(Method::Relaxation, OF_COLLOCATION)), 1);
}

#[test]
fn an_id_stays_whatever_is_kept_of_the_case() {
    for method in METHODS {
        let mut base = sweep(&[0.0, 10.0], &[0.0, 1.0], &[100.0]);
        base.solver.method = method;
        let mut other = base.clone();
        other.title = "another title".into();
        other.name = "another-name".into();
        other.text = "# another text".into();
        other.output.fields = FieldSelection::default();
        other.output.x = vec![0.0].into();
        other.output.limits = false;
        other.output.sensitivities = true;
        let (base_plan, other_plan) = (Plan::new(&base), Plan::new(&other));
        for place in places(&base) {
            assert_eq!(base_plan.case_at(place), other_plan.case_at(place));
        }
    }
}

#[test]
fn minus_zero_is_the_same_case() {
    for method in METHODS {
        let fingerprint = Fingerprint::new(&Recipe::new(&by(method), CavityShear::Full));
        assert_eq!(fingerprint.id(&Parameters::new(-0.0, 10.0, 5.0)), fingerprint.id(&Parameters::new(0.0, 10.0, 5.0)));
        assert_eq!(fingerprint.id(&Parameters::new(1.0, 10.0, -0.0)), fingerprint.id(&Parameters::elastic(10.0)));
    }
}

/// The bytes of the table in the documentation of `Fingerprint`, put together by hand for f = 5, α = 2, β = 10 and one
/// mode, from those of the method on.
fn documented_id(method: &[u8]) -> String {
    let mut bytes = [b"stribeck case 1\n", method, &[0]].concat();
    for value in [5.0f64, 2.0, 10.0] {
        bytes.extend(value.to_le_bytes());
    }
    bytes.extend(1u64.to_le_bytes());
    bytes.extend([1.0f64.to_le_bytes(), 1.0f64.to_le_bytes()].concat());
    blake3::hash(&bytes).to_hex()[..16].to_owned()
}

#[test]
fn an_id_is_the_documented_hash() {
    let mut collocation = b"collocation\n".to_vec();
    collocation.extend(stribeck_solver::collocation::RESULTS_VERSION.to_le_bytes());
    collocation.extend(1e-5f64.to_le_bytes());
    collocation.extend(8u64.to_le_bytes());

    let mut relaxation = b"relaxation\n".to_vec();
    relaxation.extend(stribeck_solver::relaxation::RESULTS_VERSION.to_le_bytes());
    relaxation.push(0);
    relaxation.extend(801u64.to_le_bytes());
    relaxation.extend(1e-8f64.to_le_bytes());
    relaxation.extend([1, 0]);

    for (method, bytes) in [(Method::Collocation, collocation), (Method::Relaxation, relaxation)] {
        let id = Fingerprint::new(&Recipe::new(&by(method), CavityShear::Full)).id(&Parameters::new(2.0, 10.0, 5.0));
        assert_eq!(id.to_string(), documented_id(&bytes), "{method}");
    }
}

/// Ids that were written down, so by another process and another build: what is stored under them is found again. They
/// change with the method's version of results, as they must; nothing else may change them.
#[test]
fn an_id_is_the_same_in_every_process_and_release() {
    let sweep = sweep(&[0.0, 100.0], &[0.0, 1.0, f64::INFINITY], &[10.0]);
    let ids = |method| {
        let plan = Plan::new(&Sweep { solver: by(method), ..sweep.clone() });
        [[0, 0, 0], [1, 0, 0], [1, 1, 0]].map(|place| plan.case_at(place.into()).to_string())
    };
    assert_eq!(ids(Method::Collocation), ["03d46baed2c112f9", "9bf9d996497359ac", "e496c180db4ae53a"]);
    assert_eq!(ids(Method::Relaxation), ["cedc712ddcc4e74f", "b36e44a27cc279bd", "f23bbd2cebafb8b0"]);
}

/// A chain is what an interruption can cost: as many quick cases as chains may have, few of those that take long.
#[test]
fn chains_are_as_long_as_the_method_is_quick() {
    let beta: Vec<f64> = (1..=130).map(f64::from).collect();
    for (method, chains, longest) in [(Method::Collocation, 3, 44), (Method::Relaxation, 9, 15)] {
        let mut sweep = sweep(&[10.0], &[1.0], &beta);
        sweep.solver.method = method;
        let lengths: Vec<usize> = Plan::new(&sweep).chains().map(|chain| chain.cases.len()).collect();
        assert_eq!((lengths.len(), lengths.iter().max()), (chains, Some(&longest)), "{method}");
    }
    assert_eq!(METHODS.map(Method::chain_limit), [MAX_CHAIN, 16]);
}

#[test]
fn a_billion_cases_are_planned_at_once() {
    let thousand: Vec<f64> = (1..=1000).map(f64::from).collect();
    let start = Instant::now();
    let plan = Plan::new(&sweep(&thousand, &thousand, &thousand));
    assert_eq!((plan.cases(), plan.rows(), plan.problems()), (1_000_000_000, 1_000_000, 1_000_000_000));
    assert_eq!(plan.chains().len(), 1_000_000 * 1000usize.div_ceil(Method::default().chain_limit()));
    let last = plan.chains().next_back().expect("there are chains");
    assert_eq!((last.row, last.cases.end), (999_999, 1000));
    assert_eq!(plan.parameters(&last).last(), Some(&Parameters::new(1000.0, 1000.0, 1000.0)));
    let place = GridIndex { block: 0, row: 2, along: 500 };
    assert_eq!(plan.find(plan.case_at(place)), Some(place));
    // Listing the cases, or the chains, would take many times longer.
    assert!(start.elapsed() < Duration::from_secs(1), "{:?}", start.elapsed());
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(64)
    })]

    /// Every chain is in one part, the same wherever it is asked, and no part has much more to do than another.
    #[test]
    fn parts_are_a_fair_split_of_the_chains(sweep in sweeps(), of in 1u32..12) {
        let plan = Plan::new(&sweep);
        let split = plan.split(of);
        prop_assert_eq!(split.len(), plan.chain_count());
        prop_assert_eq!(&split, &Plan::new(&sweep).split(of));
        let mut seen = BTreeSet::new();
        let (mut chains, mut cases) = (Vec::new(), Vec::new());
        for part in Part::all(of) {
            let of_part = plan.chains_of(Some(part));
            prop_assert!(of_part.is_sorted(), "in the order of the plan");
            prop_assert!(of_part.iter().all(|&index| split[index as usize] == part && seen.insert(index)));
            chains.push(of_part.len());
            cases.push(of_part.iter().map(|&index| plan.chain(index as usize).cases.len()).sum::<usize>());
        }
        prop_assert_eq!(seen.len(), plan.chain_count());
        prop_assert!(chains.iter().max().unwrap() - chains.iter().min().unwrap() <= 1, "{:?}", chains);
        let longest = plan.chains().map(|chain| chain.cases.len()).max().unwrap();
        prop_assert!(cases.iter().max().unwrap() - cases.iter().min().unwrap() <= 2 * longest, "{:?}", cases);
        prop_assert_eq!(plan.chains_of(None), (0..plan.chain_count() as u32).collect::<Vec<_>>());
    }

    #[test]
    fn a_part_reads_back_from_its_text_and_its_name(of in 1..=Part::MOST, number in any::<prop::sample::Index>()) {
        let number = number.index(of as usize) as u32 + 1;
        let part = Part::new(number, of).unwrap();
        prop_assert_eq!(part.to_string().parse(), Ok(part));
        prop_assert_eq!(Part::named(&part.name()), Some(part));
        prop_assert_eq!((part.number(), part.of()), (number, of));
    }
}

#[test]
fn what_is_no_part_is_refused() {
    for text in
        ["", "3", "3/", "/8", "0/8", "9/8", "1/0", "-1/8", "1/8/9", "1/1000001", "a/b", "3-of-8", "1/4294967297"]
    {
        assert!(text.parse::<Part>().is_err(), "{text}");
    }
    for name in ["", "3-of", "03-of-8", "3-of-08", "9-of-8", "3-of-8.h5", "3/8", "+3-of-8"] {
        assert_eq!(Part::named(name), None, "{name}");
    }
}
