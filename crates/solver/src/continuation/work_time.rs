//! The time that a thread has worked.

use std::time::Duration;

/// The processor time of this thread since it began. It stands still while the process is stopped.
#[cfg(unix)]
pub(super) fn work_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::try_from(time).expect("a thread has worked for no negative time")
}

/// The time since the first call, on systems that do not tell what a thread has worked.
#[cfg(not(unix))]
pub(super) fn work_time() -> Duration {
    static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    START.get_or_init(std::time::Instant::now).elapsed()
}

#[cfg(all(test, unix))]
mod tests {
    use std::hint::black_box;
    use std::thread::sleep;

    use super::*;

    #[test]
    fn work_counts_and_waiting_does_not() {
        let pause = Duration::from_millis(50);
        let start = work_time();
        sleep(pause);
        let waited = work_time() - start;
        assert!(waited < pause / 2, "{waited:?}");
        while work_time() - start < waited + pause {
            black_box((0..1000_u64).sum::<u64>());
        }
    }
}
