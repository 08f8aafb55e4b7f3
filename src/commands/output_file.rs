//! The files that a command writes for its user.
//!
//! Through a link its target is written, and into a pipe or a device. Any other file is replaced whole, by a new one
//! that takes its name. Never replaced are an input of the same command, and a file that no such command wrote.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::CliError;

/// Bytes of a file by which it is recognised.
const BEGINNING: u64 = 4096;

/// What a command reads and writes.
#[derive(Clone, Debug)]
pub struct OutputFiles<'a> {
    command: &'static str,
    inputs: Vec<&'a Path>,
}

/// A file that may be written.
#[derive(Debug)]
pub struct OutputFile {
    /// As the user named it.
    path: PathBuf,
    way: Way,
}

/// How a file is written.
#[derive(Debug)]
enum Way {
    /// As a new file that takes this name, with the permissions of the one that has it.
    Replace(PathBuf, Option<Metadata>),
    /// Into what is there.
    Into,
}

impl<'a> OutputFiles<'a> {
    /// The files of a command that reads these.
    pub fn new(command: &'static str, inputs: impl IntoIterator<Item = &'a Path>) -> Self {
        Self { command, inputs: inputs.into_iter().collect() }
    }

    /// Checks that a file may be written. `is_ours` recognises by its first bytes one that such a command wrote; a file
    /// behind a link, which the user chose, may be any.
    ///
    /// # Errors
    /// [`CliError::IsInput`] and [`CliError::Foreign`] if it may not, [`CliError::Unwritten`] if it cannot be.
    pub fn check(&self, path: &Path, is_ours: impl Fn(&[u8]) -> bool) -> Result<OutputFile, CliError> {
        let failed = unwritten(path);
        let file = |way| Ok(OutputFile { path: path.to_owned(), way });
        if is_descriptor(path) && path.metadata().is_ok_and(|metadata| !metadata.is_dir()) {
            return file(Way::Into);
        }
        let target = target(path).map_err(&failed)?;
        let metadata = match target.metadata() {
            Ok(metadata) => metadata,
            Err(error) if error.kind() == ErrorKind::NotFound => return file(Way::Replace(target, None)),
            Err(error) => return Err(failed(error)),
        };
        if metadata.is_dir() {
            return Err(failed(ErrorKind::IsADirectory.into()));
        }
        if !metadata.is_file() {
            return file(Way::Into);
        }
        if let Some(input) = self.inputs.iter().find(|input| is_same(input, &target)) {
            return Err(CliError::IsInput { file: path.to_owned(), input: (*input).to_owned() });
        }
        // A file that the user has protected is not replaced by a new one.
        OpenOptions::new().write(true).open(&target).map_err(&failed)?;
        let mut beginning = Vec::new();
        let read = File::open(&target).and_then(|file| file.take(BEGINNING).read_to_end(&mut beginning));
        read.map_err(&failed)?;
        if !path.is_symlink() && !is_ours(&beginning) {
            return Err(CliError::Foreign { file: path.to_owned(), command: self.command });
        }
        file(Way::Replace(target, Some(metadata)))
    }
}

impl OutputFile {
    /// Writes the whole file. After an error what was there before is there still.
    ///
    /// # Errors
    /// [`CliError::Unwritten`] if the disk does not take it.
    pub fn write(self, content: &[u8]) -> Result<(), CliError> {
        let path = self.path.clone();
        self.fill(|writer| writer.write_all(content).map_err(unwritten(&path)))
    }

    /// Writes the file piece by piece. After an error, of the pieces too, what was there before is there still.
    ///
    /// # Errors
    /// Those of the pieces; [`CliError::Unwritten`] if the disk does not take the file.
    pub fn fill<T>(self, pieces: impl FnOnce(&mut dyn Write) -> Result<T, CliError>) -> Result<T, CliError> {
        let failed = unwritten(&self.path);
        match &self.way {
            Way::Into => {
                let mut writer = BufWriter::new(OpenOptions::new().append(true).open(&self.path).map_err(&failed)?);
                let told = pieces(&mut writer)?;
                writer.flush().map_err(&failed)?;
                Ok(told)
            }
            Way::Replace(target, before) => {
                let mut writer = BufWriter::new(beside(target, before.as_ref()).map_err(&failed)?);
                let told = pieces(&mut writer)?;
                let file = writer.into_inner().map_err(|error| failed(error.into_error()))?;
                file.as_file().sync_all().map_err(&failed)?;
                file.persist(target).map_err(|error| failed(error.error))?;
                Ok(told)
            }
        }
    }
}

/// Recognises an empty file as well, as `mktemp` makes it.
pub fn or_empty(is_ours: impl Fn(&[u8]) -> bool) -> impl Fn(&[u8]) -> bool {
    move |beginning| beginning.is_empty() || is_ours(beginning)
}

/// The error of a file that the disk does not take.
pub fn unwritten(path: &Path) -> impl Fn(io::Error) -> CliError {
    move |source| CliError::Unwritten { action: "write", path: path.to_owned(), source }
}

/// A new file in the directory of another one, with its permissions or else those that new files have.
fn beside(target: &Path, before: Option<&Metadata>) -> io::Result<NamedTempFile> {
    let directory = target.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".stribeck-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(directory)?;
    if let Some(before) = before {
        file.as_file().set_permissions(before.permissions())?;
    }
    Ok(file)
}

/// The file that a path leads to through links, the last of which may lead nowhere yet.
fn target(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40;
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other("its links lead in a circle"))
}

/// True for the names of open files: what they lead to has readers or writers already.
fn is_descriptor(path: &Path) -> bool {
    ["/dev/fd", "/dev/stdin", "/dev/stdout", "/dev/stderr", "/proc"].iter().any(|name| path.starts_with(name))
}

/// True if two paths lead to one file.
fn is_same(first: &Path, second: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let identity = |path: &Path| path.metadata().map(|metadata| (metadata.dev(), metadata.ino()));
        matches!((identity(first), identity(second)), (Ok(first), Ok(second)) if first == second)
    }
    #[cfg(not(unix))]
    matches!((first.canonicalize(), second.canonicalize()), (Ok(first), Ok(second)) if first == second)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A directory with a file, an input, and a link to the former.
    fn home() -> tempfile::TempDir {
        let home = tempfile::tempdir().unwrap();
        fs::write(home.path().join("file"), "old").unwrap();
        fs::write(home.path().join("input"), "input").unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink("file", home.path().join("link")).unwrap();
        home
    }

    fn write(home: &Path, name: &str, is_ours: bool) -> Result<(), CliError> {
        let input = home.join("input");
        let files = OutputFiles::new("curve", [input.as_path()]);
        files.check(&home.join(name), |_| is_ours)?.write(b"new")
    }

    #[test]
    fn new_files_and_ours_are_written_and_no_others() {
        let home = home();
        let text = |name: &str| fs::read_to_string(home.path().join(name)).unwrap();
        assert!(matches!(write(home.path(), "file", false), Err(CliError::Foreign { .. })));
        assert!(matches!(write(home.path(), "input", true), Err(CliError::IsInput { .. })));
        assert!(matches!(write(home.path(), ".", true), Err(CliError::Unwritten { .. })));
        assert_eq!(["file", "input"].map(text), ["old", "input"]);
        write(home.path(), "file", true).unwrap();
        write(home.path(), "another", false).unwrap();
        assert_eq!(["file", "another"].map(text), ["new", "new"]);
    }

    #[test]
    fn an_empty_file_is_ours_only_where_that_is_said() {
        let home = home();
        let empty = home.path().join("empty");
        fs::write(&empty, "").unwrap();
        let files = OutputFiles::new("curve", []);
        assert!(matches!(files.check(&empty, |_| false), Err(CliError::Foreign { .. })));
        assert!(files.check(&empty, or_empty(|_| false)).is_ok());
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_and_pipes_get_what_is_written() {
        let home = home();
        let text = |name: &str| fs::read_to_string(home.path().join(name)).unwrap();
        write(home.path(), "link", false).unwrap();
        assert!(home.path().join("link").is_symlink());
        assert_eq!(text("file"), "new");
        std::os::unix::fs::symlink("input", home.path().join("to-input")).unwrap();
        assert!(matches!(write(home.path(), "to-input", true), Err(CliError::IsInput { .. })));
        std::os::unix::fs::symlink("circle", home.path().join("circle")).unwrap();
        assert!(matches!(write(home.path(), "circle", true), Err(CliError::Unwritten { .. })));

        let pipe = home.path().join("pipe");
        rustix::fs::mkfifoat(rustix::fs::CWD, &pipe, rustix::fs::Mode::from_raw_mode(0o600)).unwrap();
        let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
        write(home.path(), "pipe", false).unwrap();
        assert_eq!(reader.join().unwrap(), "new");
        assert!(!home.path().join("pipe").is_file());
    }

    #[cfg(unix)]
    #[test]
    fn permissions_stay() {
        use std::os::unix::fs::PermissionsExt;
        let home = home();
        let file = home.path().join("file");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        write(home.path(), "file", true).unwrap();
        assert_eq!(file.metadata().unwrap().permissions().mode() & 0o777, 0o640);
    }
}
