//! Options of sbatch that a user adds to those of the scripts.

/// Options without which the parts would not be what they are said to be.
const OWN_LONG: [&str; 10] =
    ["array", "cpus-per-task", "dependency", "no-requeue", "nodes", "ntasks", "open-mode", "output", "signal", "time"];
const OWN_SHORT: &str = "acdNnot";

/// Short options of sbatch without a value: others may follow in the same word.
const FLAGS: &str = "HhIkOQsVvW";

/// Checks options as they stand in a script, one or several. Those that the script sets itself are refused, also where
/// they are abbreviated or stand behind others, as sbatch takes them.
///
/// # Errors
/// What is wrong, for the user.
pub fn sbatch_option(text: &str) -> Result<String, String> {
    if !text.starts_with('-') || text.chars().any(char::is_control) {
        return Err("give an option of sbatch, as in --constraint=avx2".to_owned());
    }
    match text.split_whitespace().find_map(own_option) {
        Some(own) => {
            Err(format!("{own} is set by `stribeck slurm` itself: its own options choose the value, if there is one"))
        }
        None => Ok(text.to_owned()),
    }
}

/// The option of ours that a word sets.
fn own_option(word: &str) -> Option<String> {
    let word = word.trim_matches(['"', '\'']);
    if let Some(long) = word.strip_prefix("--") {
        let name = long.split('=').next().filter(|name| !name.is_empty())?;
        return OWN_LONG.iter().find(|own| own.starts_with(name)).map(|own| format!("--{own}"));
    }
    let letters = word.strip_prefix('-')?;
    let set = letters.find(|letter| !FLAGS.contains(letter))?;
    letters[set..].chars().next().filter(|letter| OWN_SHORT.contains(*letter)).map(|letter| format!("-{letter}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_of_ours_are_refused_however_they_are_written() {
        let refused = [
            "--array=1-9",
            "--arr=1-9",
            "-a1-9",
            "-Ha 1-9",
            "--export=NONE --array=1-9",
            "-J x -n 8",
            "--outp=/x",
            "--cpus=7",
            "--comment=x \"--time=1\"",
            "constraint",
            "--mem=1\n",
        ];
        for option in refused {
            assert!(sbatch_option(option).is_err(), "{option}");
        }
        for option in ["--constraint=avx2", "-p short", "-Jname", "--time-min=5", "--mem=2G --exclusive", "-Q"] {
            assert_eq!(sbatch_option(option).as_deref(), Ok(option));
        }
    }
}
