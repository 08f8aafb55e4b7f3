//! Dry sliding with any number of retardation times (β → ∞).

use super::bessel_ratio::{excess, i2_over_i1, k0_over_k1};
use super::root::bracketed_root;
use super::spectrum::{Line, Spectrum};
use crate::linear::{Factorisation, Matrix};
use crate::model::Parameters;

/// Rates that a contact cannot tell from 0 or ∞; with them, no product leaves the range of double precision.
const RATES: (f64, f64) = (1e-100, 1e100);

/// A mode that is weaker adds nothing that a number tells to the compliance, which is 1 at once.
const LEAST_STRENGTH: f64 = 1e-100;

/// The dry contact of a rigid cylinder that slides to +x on a half space with several retardation times (T40–T46).
///
/// In the contact the material relaxes at the rates ρ_m of its relaxation spectrum, and ahead of it it creeps at the
/// rates α_j. An orthogonal matrix U turns one into the other, and with T_m = I₁/I₀(ρ_m ā), Q_j = K₀/K₁(α_j ā), both
/// from 0 to 1, what is left is one symmetric system whose eigenvalues lie between 1 and 2: no digits are lost for any
/// α_j and f_j. With one mode this is [`DryContact`](super::DryContact), which knows the pressure too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrySliding {
    half_width: f64,
    centre: f64,
    friction: f64,
}

impl DrySliding {
    /// The dry contact of a case. Hertzian for f = 0, α = 0 (half width 1/√(1+f)) and α = ∞ (1).
    pub fn of(parameters: &Parameters) -> Self {
        let mut modes = parameters.retardation();
        modes.retain(|mode| mode.strength >= LEAST_STRENGTH);
        if modes.is_empty() {
            let instantaneous = !parameters.is_relaxed_elastic();
            let compliance = if instantaneous { parameters.instantaneous_compliance() } else { 1.0 };
            return Self { half_width: compliance.sqrt(), centre: 0.0, friction: 0.0 };
        }
        let lines = modes.iter().map(|mode| Line { strength: mode.strength, place: mode.rate.clamp(RATES.0, RATES.1) });
        Self::on(&Exchange::new(&Spectrum::new(lines)))
    }

    fn on(material: &Exchange) -> Self {
        // (T45) in ln ā. It is not positive at the instantaneous half width and not negative at the relaxed one.
        let residual = |ln_half_width: f64| {
            let half_width = ln_half_width.exp();
            2.0 * ln_half_width + (2.0 / half_width * material.contact(half_width).indentation()).ln_1p()
        };
        let half_width = bracketed_root(residual, -0.5 * material.f.ln_1p(), 0.0).exp();
        let contact = material.contact(half_width);
        let centre = contact.centre();
        Self { half_width, centre, friction: centre + half_width * half_width * contact.moment() }
    }

    /// ā, half the width of the contact, over a₀; from 1/√(1+f) to 1.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// b, the middle of the contact, over a₀.
    pub fn centre(&self) -> f64 {
        self.centre
    }

    /// x = b + ā, where the contact begins.
    pub fn leading_edge(&self) -> f64 {
        self.centre + self.half_width
    }

    /// x = b − ā, where the contact ends.
    pub fn trailing_edge(&self) -> f64 {
        self.centre - self.half_width
    }

    /// F_v, the friction force over N a₀/R (T46); 0 in the elastic limits.
    pub fn friction(&self) -> f64 {
        self.friction
    }
}

/// What the material is, whatever the contact.
struct Exchange {
    f: f64,
    /// α_j
    retardation: Vec<f64>,
    /// ρ_m
    relaxation: Vec<f64>,
    /// √(f_j/((1+f)α_j))
    creep: Vec<f64>,
    /// √(e_m/ρ_m)
    stress: Vec<f64>,
    /// U, a row for each retardation rate and a column for each relaxation rate (T42).
    exchange: Matrix,
}

impl Exchange {
    fn new(spectrum: &Spectrum) -> Self {
        let f = spectrum.total();
        let conjugate = spectrum.conjugate();
        let (creep, stress) = (spectrum.lines(), conjugate.spectrum.lines());
        let amplitude = |j: usize, m: usize| {
            let (creep, stress): (&Line, &Line) = (&creep[j], &stress[m]);
            let rates = stress.place / creep.place;
            (creep.strength / (1.0 + f) * rates).sqrt() * stress.strength.sqrt() / conjugate.distances[m][j]
        };
        let mut exchange = Matrix::default();
        exchange.reshape(creep.len(), stress.len());
        for m in 0..stress.len() {
            for (j, entry) in exchange.column_mut(m).iter_mut().enumerate() {
                *entry = amplitude(j, m);
            }
        }
        Self {
            f,
            retardation: creep.iter().map(|line| line.place).collect(),
            relaxation: stress.iter().map(|line| line.place).collect(),
            creep: creep.iter().map(|line| (line.strength / (1.0 + f) / line.place).sqrt()).collect(),
            stress: stress.iter().map(|line| (line.strength / line.place).sqrt()).collect(),
            exchange,
        }
    }

    /// The stress in a contact of the given half width, whatever the load: (T43), (T44).
    fn contact(&self, half_width: f64) -> Contact<'_> {
        let n = self.relaxation.len();
        let kappa: Vec<f64> = self.relaxation.iter().map(|rate| rate * half_width).collect();
        // I₁/I₀ from k(I₀/I₁ − 1), which is 2 at k = 0.
        let inner: Vec<f64> = kappa.iter().map(|&k| (k / (k + excess(k))).sqrt()).collect();
        let outer: Vec<f64> = self.retardation.iter().map(|rate| k0_over_k1(rate * half_width)).collect();
        let u = &self.exchange;
        let sums = |m: usize, k: usize| (0..n).map(|j| u.column(m)[j] * outer[j] * u.column(k)[j]).sum::<f64>();
        let identity = |m: usize, k: usize| if m == k { 1.0 } else { 0.0 };
        let mut system = Factorisation::default();
        system.matrix.reshape(n, n);
        for k in 0..n {
            for (m, entry) in system.matrix.column_mut(k).iter_mut().enumerate() {
                *entry = identity(m, k) + inner[m] * inner[k] * sums(m, k);
            }
        }
        system.factorise();
        let drive: Vec<f64> = inner.iter().zip(&self.stress).map(|(inner, stress)| inner * stress).collect();
        let mut response = drive.clone();
        system.solve(&mut response);
        Contact { material: self, kappa, inner, outer, drive, response }
    }
}

/// The solution of (T44) for one half width.
struct Contact<'a> {
    material: &'a Exchange,
    kappa: Vec<f64>,
    /// √T_m
    inner: Vec<f64>,
    /// Q_j
    outer: Vec<f64>,
    /// √T_m √(e_m/ρ_m)
    drive: Vec<f64>,
    /// z_m of (T44).
    response: Vec<f64>,
}

impl Contact<'_> {
    /// ½(a₀/ā − 1)ā with the coefficient a₀ of (T43): what relaxation adds to the load.
    fn indentation(&self) -> f64 {
        self.drive.iter().zip(&self.response).map(|(drive, response)| drive * response).sum()
    }

    /// b (T46).
    fn centre(&self) -> f64 {
        let n = self.response.len();
        let felt = |j: usize| -> f64 {
            (0..n).map(|m| self.material.exchange.column(m)[j] * self.inner[m] * self.response[m]).sum()
        };
        (0..n).map(|j| self.outer[j] * self.material.creep[j] * felt(j)).sum()
    }

    /// The moment of the pressure about the middle of the contact, over ā² (T46).
    fn moment(&self) -> f64 {
        let terms = self.drive.iter().zip(&self.response).zip(&self.kappa);
        terms.map(|((drive, response), &k)| drive * response * i2_over_i1(k)).sum()
    }
}
