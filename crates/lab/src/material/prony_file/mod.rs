//! Files of finite-element programs with a Prony series.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `lines` | a text as lines of cells with commas between them |
//! | `abaqus` | `*VISCOELASTIC, TIME=PRONY`, with `*ELASTIC` beside it |
//! | `ansys` | `TB,PRONY`, with `MP,EX` beside it |

mod abaqus;
mod ansys;
mod lines;

use super::prony::PronyParts;
use super::{ModulusKind, PronySeries};
use crate::Modulus;
use stribeck_input::Fault;

/// A series as a file has it, with what was left out of it.
#[derive(Clone, Debug, PartialEq)]
pub struct PronyFile {
    /// The program that files of this kind belong to.
    pub program: &'static str,
    /// Fractions of the instantaneous modulus, without a modulus.
    pub series: PronySeries,
    /// E₀ or E∞, in the units of the file, which these files do not name.
    pub modulus: Option<Modulus>,
    /// What was left out, in words.
    pub notes: Vec<String>,
}

impl PronyFile {
    /// Takes the text of an input file of Abaqus or Ansys; `None` if it is neither.
    ///
    /// # Errors
    /// [`Fault`] with the place if it holds no series that can be read.
    pub fn interpret(text: &str) -> Result<Option<Self>, Fault> {
        if abaqus::is_one(text) {
            abaqus::interpret(text).map(Some)
        } else if ansys::is_one(text) {
            ansys::interpret(text).map(Some)
        } else {
            Ok(None)
        }
    }

    /// The series with the file's own modulus, whose unit has `unit` pascals.
    pub fn with_modulus_in(&self, unit: f64) -> PronySeries {
        let modulus = self.modulus.map(|modulus| modulus.times(unit));
        PronySeries { modulus, ..self.series.clone() }
    }

    /// Fractions and times without those that are zero.
    fn new(
        program: &'static str,
        pairs: impl Iterator<Item = (f64, f64)>,
        modulus: Option<Modulus>,
        mut notes: Vec<String>,
    ) -> Self {
        let (terms, zeros): (Vec<_>, Vec<_>) = pairs.partition(|(fraction, _)| *fraction != 0.0);
        match zeros.len() {
            0 => {}
            1 => notes.push("1 term of zero is left out".to_owned()),
            count => notes.push(format!("{count} terms of zero are left out")),
        }
        let series = PronySeries { parts: PronyParts::Fractions, terms, modulus: None, kind: ModulusKind::Young };
        Self { program, series, modulus, notes }
    }
}

/// What is said where bulk terms are left out.
const BULK: &str = "bulk terms are left out: Poisson's ratio is taken as constant, so that Young's modulus relaxes as the \
                    shear modulus does";

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> PronyFile {
        PronyFile::interpret(text).expect("a series").expect("one of the two programs")
    }

    const TERMS: [(f64, f64); 3] = [(0.25, 1e-3), (0.125, 0.5), (0.0625, 300.0)];

    #[test]
    fn one_series_in_two_languages_is_one_series() {
        let abaqus = read(
            "** of a made-up rubber\n*Material, name=RUBBER\n*Elastic, moduli=instantaneous\n 8.0, 0.49\n\
             *VISCOELASTIC, TIME = PRONY\n0.25, 0.25, 1.E-3\n0.125,,5.0d-1\n  0., 0., 7.\n0.0625, 0, 3e2\n*END STEP\n",
        );
        let ansys = read(
            "/COM, made up\nMP,EX,1,8.0\ntb,prony,1,1,4,shear  ! four terms\nTBTEMP,20\nTBDATA,1,0.25,1e-3,0.125\n\
             TBDATA,,0.5,0.0,7\nTBDATA,7,0.0625,3e2\nTB,PRONY,1,1,1,BULK\nTBDATA,1,0.3,1\n",
        );
        assert_eq!((abaqus.program, ansys.program), ("Abaqus", "Ansys"));
        for file in [&abaqus, &ansys] {
            assert_eq!(file.series.terms, TERMS);
            assert_eq!(file.modulus, Some(Modulus::Instantaneous(8.0)));
            assert_eq!(file.notes.iter().filter(|note| note.starts_with("1 term of zero")).count(), 1);
            assert_eq!(file.notes.iter().filter(|note| note.starts_with("bulk terms")).count(), 1);
        }
        assert_eq!(abaqus.series, ansys.series);
        assert_eq!(abaqus.with_modulus_in(1e6).modulus, Some(Modulus::Instantaneous(8e6)));
    }

    #[test]
    fn long_term_is_what_abaqus_takes_a_modulus_for() {
        for keyword in ["*Elastic", "*ELASTIC, MODULI=LONG TERM", "*elastic, type=isotropic,\n moduli = long term"] {
            let file = read(&format!("{keyword}\n3., 0.5\n*viscoelastic, time=prony\n0.5, 0., 1.\n"));
            assert_eq!(file.modulus, Some(Modulus::Relaxed(3.0)), "{keyword}");
        }
        assert_eq!(read("*viscoelastic, frequency=prony\n0.5, 0., 1.\n").modulus, None);
    }

    #[test]
    fn what_is_no_series_is_refused_with_its_place() {
        for (text, at, said) in [
            ("*viscoelastic, time=creep test data\n1,2\n", 0, "TIME=PRONY"),
            ("*viscoelastic, time=prony\n*end\n", 0, "has no terms"),
            ("*viscoelastic, time=prony\n0.2, 0, x\n", 34, "a number"),
            ("*viscoelastic, time=prony\n0.2, 0\n", 26, "three numbers"),
            ("*viscoelastic, time=prony\n0.2, 0, 0\n", 34, "above 0"),
            ("*viscoelastic, time=prony\n-0.2, 0, 1\n", 26, "from 0"),
            ("*viscoelastic, time=prony\n.2,,1\n*viscoelastic, time=prony\n", 32, "second"),
            ("tb,prony,1,1,2,shear\ntbdata,1,.1,1,.1\n", 0, "3 of 4"),
            ("tb,prony,1,1,1,shear\ntbdata,1,.1,none\n", 33, "a number"),
            ("tb,prony,1,1,x,shear\n", 13, "number of terms"),
            ("tb,prony,1,1,1,bulk\ntbdata,1,.1,1\n", 0, "no shear terms"),
            ("tb,prony,1,2,1,shear\ntbdata,1,.1,1\n", 11, "one temperature"),
            ("tb,prony,1,1,1,shear\ntbdata,1,.1,1\ntb,prony,2,1,1,shear\n", 35, "second"),
            ("tb,prony,1,1,1,shear\ntbdata,99999999999,.1,1\n", 28, "a place"),
        ] {
            let fault = PronyFile::interpret(text).expect_err(text).located("p", text);
            let InputErrorPlace { offset, message } = place(&fault, text);
            assert!(message.contains(said), "{text}\n{message}");
            assert_eq!(offset, at, "{text}\n{message}");
        }
        assert!(matches!(PronyFile::interpret("omega,storage,loss\n1,2,3\n"), Ok(None)));
    }

    struct InputErrorPlace {
        offset: usize,
        message: String,
    }

    /// Where a fault stands, as a byte of the text.
    fn place(error: &stribeck_input::InputError, text: &str) -> InputErrorPlace {
        let stribeck_input::InputError::Invalid(invalid) = error else { panic!("{error}") };
        let before: usize = text.split_inclusive('\n').take(invalid.line() - 1).map(str::len).sum();
        InputErrorPlace { offset: before + invalid.column() - 1, message: error.to_string() }
    }
}
