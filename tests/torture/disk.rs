//! A small disk of its own, which can be full or read-only whoever runs the test.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use tempfile::TempDir;

use crate::torture::place::copy;

/// What the smallest file takes.
pub const PAGE: u64 = 4096;

/// Mounts a small file system at `$1`, then changes its mount by each line of options read; says how that went.
const KEEPER: &str = r#"
    answer() { "$@" && echo done || echo refused; }
    answer mount -t tmpfs -o size=16m,nr_inodes=600 tmpfs "$1"
    while read -r options; do answer mount -o "remount,bind,$options" "$1"; done
"#;

/// A small disk, in a mount namespace that a process keeps. Others get at the disk by way of that process, so nothing
/// else has to know of the namespace, and the disk goes with the process.
pub struct Disk {
    keeper: Child,
    orders: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
    path: PathBuf,
    _mount_point: TempDir,
}

/// What a disk has no more of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Room {
    /// So many pages are left.
    Pages(u64),
    /// So many files can be created.
    Files(u64),
}

impl Disk {
    /// A disk with 16 MB and room for some hundred files.
    pub fn new() -> Self {
        let root = Command::new("unshare").args(["--mount", "true"]).output().is_ok_and(|tried| tried.status.success());
        let namespace: &[&str] = if root { &["--mount"] } else { &["--user", "--map-root-user", "--mount"] };
        let mount_point = TempDir::with_prefix("stribeck-disk-").expect("a temporary directory");
        let mut keeper = Command::new("unshare")
            .args(namespace)
            .args(["sh", "-c", KEEPER, "sh"])
            .arg(mount_point.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("unshare runs; it comes with util-linux");
        let orders = keeper.stdin.take();
        let answers = BufReader::new(keeper.stdout.take().expect("piped"));
        let inside = mount_point.path().strip_prefix("/").expect("absolute");
        let path = Path::new("/proc").join(keeper.id().to_string()).join("root").join(inside);
        let mut disk = Self { keeper, orders, answers, path, _mount_point: mount_point };
        assert!(
            disk.is_done(),
            "this test mounts a small file system in a mount namespace of its own, and the system refuses that: run it \
             as root (in a container: with CAP_SYS_ADMIN), or allow user namespaces (sysctl \
             kernel.unprivileged_userns_clone=1, kernel.apparmor_restrict_unprivileged_userns=0)"
        );
        disk
    }

    fn is_done(&mut self) -> bool {
        let mut answer = String::new();
        self.answers.read_line(&mut answer).expect("read");
        answer == "done\n"
    }

    /// Its directory.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// From now on nothing can be written, or everything can again.
    pub fn set_read_only(&mut self, read_only: bool) {
        let options = if read_only { "ro" } else { "rw" };
        writeln!(self.orders.as_mut().expect("open until dropped"), "{options}").expect("the keeper listens");
        assert!(self.is_done(), "mounted anew with {options}");
    }

    fn ballast(&self) -> PathBuf {
        self.path.join("ballast")
    }

    /// Fills the disk until only so much room is left.
    pub fn leave(&self, room: Room) {
        fs::create_dir(self.ballast()).expect("made");
        match room {
            Room::Pages(pages) => {
                let [free, _] = self.free();
                fs::write(self.ballast().join("pages"), vec![1; ((free - pages) * PAGE) as usize]).expect("written");
                assert_eq!(self.free()[0], pages);
            }
            Room::Files(files) => {
                let [_, free] = self.free();
                for number in files..free {
                    fs::write(self.ballast().join(number.to_string()), "").expect("written");
                }
                assert_eq!(self.free()[1], files);
            }
        }
    }

    /// Makes room again.
    pub fn make_room(&self) {
        fs::remove_dir_all(self.ballast()).expect("removed");
    }

    /// Free pages, and files that can be created.
    fn free(&self) -> [u64; 2] {
        let stat = Command::new("stat").args(["-f", "--format=%a %d"]).arg(&self.path).output().expect("stat runs");
        let text = String::from_utf8(stat.stdout).expect("text");
        let mut numbers = text.split_whitespace().map(|number| number.parse().expect("a number"));
        [(); 2].map(|()| numbers.next().expect("two numbers"))
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let kept = TempDir::with_prefix("stribeck-torture-disk-").expect("a temporary directory").keep();
            let out = self.path.join("out");
            if out.is_dir() {
                copy(&out, &kept.join("out"));
            }
            eprintln!("kept: {}", kept.display());
        }
        drop(self.orders.take());
        // The keeper ends with its orders.
        let _ = self.keeper.wait();
    }
}
