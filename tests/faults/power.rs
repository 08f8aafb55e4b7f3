//! What a disk holds after its power fails: a model that knows what was asked for and what was waited for.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A change that a program made.
#[derive(Clone, Debug)]
pub struct Change {
    call: String,
    path: PathBuf,
    other: PathBuf,
    offset: usize,
    bytes: Vec<u8>,
}

impl Change {
    /// The changes of a recorded trace.
    pub fn read(mut trace: &[u8]) -> Vec<Self> {
        let mut changes = Vec::new();
        while !trace.is_empty() {
            let end = trace.iter().position(|byte| *byte == b'\n').expect("a line");
            let line = std::str::from_utf8(&trace[..end]).expect("text");
            let [call, path, other, offset, size] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line}") };
            let size: usize = size.parse().expect("a number");
            let (path, other, call) = (path.into(), other.into(), call.to_owned());
            let bytes = trace[end + 1..end + 1 + size].to_vec();
            changes.push(Self { call, path, other, offset: offset.parse().expect("a number"), bytes });
            trace = &trace[end + 1 + size..];
        }
        changes
    }

    /// True if it is a wait for this kind of file.
    pub fn synchronises(&self, extension: &str) -> bool {
        self.call == "fsync" && self.path.extension().is_some_and(|found| found == extension)
    }
}

/// What is lost at a power failure of all that nobody waited for.
#[derive(Clone, Copy, Debug)]
pub enum Loss {
    /// All of it.
    Everything,
    /// The content of files, but not their names: journals of names are often written sooner.
    Contents,
    /// Any part of it, chosen by a seed.
    Some(u64),
    /// Nothing.
    Nothing,
}

/// A file or a directory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Node {
    Directory,
    File(usize),
}

/// A change of names, which a disk makes at once or not at all.
#[derive(Debug)]
struct Naming {
    entries: Vec<(PathBuf, Option<Node>)>,
    waited_for: bool,
}

/// Bytes written to a file, or a new length of it.
#[derive(Debug)]
struct Writing {
    offset: usize,
    /// `None` cuts the file, or stretches it, to `offset`.
    bytes: Option<Vec<u8>>,
    waited_for: bool,
}

/// A disk as a program sees it, with what it has waited for.
#[derive(Debug, Default)]
pub struct DiskModel {
    names: BTreeMap<PathBuf, Node>,
    namings: Vec<Naming>,
    files: Vec<Vec<Writing>>,
}

impl DiskModel {
    /// The disk with what is in a directory, as if it were in another one. All of it was waited for.
    pub fn of(directory: &Path, named: &Path) -> Self {
        let mut disk = Self::default();
        disk.take(directory, named);
        disk.namings.iter_mut().for_each(|naming| naming.waited_for = true);
        disk.files.iter_mut().flatten().for_each(|writing| writing.waited_for = true);
        disk
    }

    fn take(&mut self, directory: &Path, named: &Path) {
        for entry in fs::read_dir(directory).expect("listed") {
            let path = entry.expect("listed").path();
            let name = named.join(path.file_name().expect("a name"));
            if path.is_dir() {
                self.name(vec![(name.clone(), Some(Node::Directory))]);
                self.take(&path, &name);
            } else {
                self.files.push(Vec::new());
                self.name(vec![(name.clone(), Some(Node::File(self.files.len() - 1)))]);
                self.write(&name, 0, Some(fs::read(&path).expect("read")));
            }
        }
    }

    /// Makes a change.
    pub fn apply(&mut self, change: &Change) {
        let Change { call, path, other, offset, bytes } = change;
        match call.as_str() {
            "create" => {
                self.files.push(Vec::new());
                self.name(vec![(path.clone(), Some(Node::File(self.files.len() - 1)))]);
            }
            "mkdir" => self.name(vec![(path.clone(), Some(Node::Directory))]),
            "rename" => self.name(vec![(other.clone(), Some(self.names[path])), (path.clone(), None)]),
            "link" => self.name(vec![(other.clone(), Some(self.names[path]))]),
            "unlink" => self.name(vec![(path.clone(), None)]),
            "write" => self.write(path, *offset, Some(bytes.clone())),
            "ftruncate" => self.write(path, *offset, None),
            "fsync" => self.wait(path),
            call => panic!("a trace has no {call}"),
        }
    }

    fn name(&mut self, entries: Vec<(PathBuf, Option<Node>)>) {
        set(&mut self.names, &entries);
        self.namings.push(Naming { entries, waited_for: false });
    }

    fn write(&mut self, path: &Path, offset: usize, bytes: Option<Vec<u8>>) {
        let Node::File(file) = self.names[path] else { panic!("{path:?} is no file") };
        self.files[file].push(Writing { offset, bytes, waited_for: false });
    }

    /// Of a file its content is on the disk then, of a directory the names in it.
    fn wait(&mut self, path: &Path) {
        match self.names.get(path) {
            Some(Node::File(file)) => self.files[*file].iter_mut().for_each(|writing| writing.waited_for = true),
            // The directory in which all happens was there before.
            Some(Node::Directory) | None => {
                let inside = |naming: &&mut Naming| naming.entries.iter().any(|(name, _)| name.parent() == Some(path));
                self.namings.iter_mut().filter(inside).for_each(|naming| naming.waited_for = true);
            }
        }
    }

    /// Files and directories after a power failure; directories have no content.
    pub fn after(&self, loss: Loss) -> BTreeMap<PathBuf, Option<Vec<u8>>> {
        let mut coin = Coin::new(loss);
        let mut names = BTreeMap::new();
        for naming in &self.namings {
            if naming.waited_for || matches!(loss, Loss::Contents) || coin.keeps() {
                set(&mut names, &naming.entries);
            }
        }
        let contents: Vec<Vec<u8>> = self.files.iter().map(|writings| content(writings, &mut coin)).collect();
        let node = |node: &Node| match node {
            Node::Directory => None,
            Node::File(file) => Some(contents[*file].clone()),
        };
        names.iter().map(|(path, found)| (path.clone(), node(found))).collect()
    }
}

fn set(names: &mut BTreeMap<PathBuf, Node>, entries: &[(PathBuf, Option<Node>)]) {
    for (path, node) in entries {
        match node {
            Some(node) => drop(names.insert(path.clone(), *node)),
            None => drop(names.remove(path)),
        }
    }
}

fn content(writings: &[Writing], coin: &mut Coin) -> Vec<u8> {
    let mut content = Vec::new();
    for Writing { offset, bytes, waited_for } in writings {
        if !waited_for && !coin.keeps() {
            continue;
        }
        match bytes {
            None => content.resize(*offset, 0),
            Some(bytes) => {
                content.resize(content.len().max(offset + bytes.len()), 0);
                content[*offset..offset + bytes.len()].copy_from_slice(bytes);
            }
        }
    }
    content
}

/// What is kept of all that nobody waited for.
struct Coin {
    loss: Loss,
    state: u64,
}

impl Coin {
    fn new(loss: Loss) -> Self {
        let state = if let Loss::Some(seed) = loss { seed } else { 0 };
        Self { loss, state: state.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1 }
    }

    fn keeps(&mut self) -> bool {
        match self.loss {
            Loss::Nothing => true,
            Loss::Everything | Loss::Contents => false,
            Loss::Some(_) => {
                // xorshift64
                self.state ^= self.state << 13;
                self.state ^= self.state >> 7;
                self.state ^= self.state << 17;
                self.state >> 63 == 1
            }
        }
    }
}

/// Makes the files of one directory as they are in another one, which they were recorded in.
pub fn restore(files: &BTreeMap<PathBuf, Option<Vec<u8>>>, recorded: &Path, here: &Path) {
    for (path, content) in files {
        let path = here.join(path.strip_prefix(recorded).expect("below it"));
        // What is in a directory that was lost is lost with it.
        if !path.parent().is_some_and(Path::is_dir) {
            continue;
        }
        match content {
            None => fs::create_dir(&path).expect("made"),
            Some(content) => fs::write(&path, content).expect("written"),
        }
    }
}
