//! `stribeck man`: the manual pages.

use std::io;
use std::path::PathBuf;

use clap::Args;
use clap_mangen::Man;
use clap_mangen::roff::{Roff, roman};

use super::output_file::{OutputFiles, or_empty};
use super::{CliError, Exit, command_line, console};
use crate::format::count;
use stribeck_input::shown;
use stribeck_sweep::store::create_directory;

/// What every page has near its beginning.
const MARK: &[u8] = b"\n.TH stribeck";

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck man man1                                     then man -l man1/stribeck-run.1",
    after_help = "\
Writes stribeck.1 and a page for each command, stribeck-run.1 and so on. `man stribeck-run` finds them in a directory
man1 of $MANPATH, for instance ~/.local/share/man/man1."
)]
pub struct Arguments {
    /// The directory of the pages; it is made if it is not there
    #[arg(value_name = "DIR")]
    directory: PathBuf,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    const IN_MEMORY: &str = "writing to memory does not fail";
    let mut all = command_line().disable_help_subcommand(true);
    all.build();
    let files = OutputFiles::new("man", []);
    let is_page = |beginning: &[u8]| beginning.windows(MARK.len()).any(|bytes| bytes == MARK);
    let commands: Vec<_> = [&all].into_iter().chain(all.get_subcommands()).cloned().collect();
    let mut pages = Vec::with_capacity(commands.len());
    for command in commands {
        let notes = command.get_after_help().map(ToString::to_string);
        let examples = command.get_before_help().map(ToString::to_string);
        let page = Man::new(command);
        let file = files.check(&arguments.directory.join(page.get_filename()), or_empty(is_page))?;
        let mut text = Vec::new();
        render(&page, examples, notes, &mut text).expect(IN_MEMORY);
        pages.push((file, text));
    }
    create_directory(&arguments.directory)?;
    let written = pages.len() as u64;
    for (file, text) in pages {
        file.write(&text)?;
    }
    console::print(&format!("{} in {}\n", count(written, "page"), shown(&arguments.directory)))?;
    Ok(Exit::Success)
}

/// A page with its examples before the options, as help has them.
fn render(page: &Man, examples: Option<String>, notes: Option<String>, text: &mut Vec<u8>) -> io::Result<()> {
    page.render_title(text)?;
    page.render_name_section(text)?;
    page.render_synopsis_section(text)?;
    if let Some(examples) = examples {
        section("EXAMPLES", examples.trim_start_matches("Examples:\n"), text)?;
    }
    page.render_options_section(text)?;
    if let Some(notes) = notes {
        section("NOTES", &notes, text)?;
    }
    Ok(())
}

/// A section whose lines stay as they are.
fn section(heading: &str, lines: &str, text: &mut Vec<u8>) -> io::Result<()> {
    let mut roff = Roff::new();
    roff.control("SH", [heading]).control("nf", []);
    for line in lines.lines() {
        roff.text([roman(line)]);
    }
    roff.control("fi", []);
    roff.to_writer(text)
}
