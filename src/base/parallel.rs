//! Work done by several threads at a time.
//!
//! Invariant: whatever the system refuses, the work is done: a thread that cannot be had is done without, and the
//! calling thread works in any case. Knows nothing of the work.
use std::thread;

/// Does the work on the calling thread and on others, one a processor and `most` in all. Each call of the work takes
/// what there is to do until nothing is left.
pub fn together(most: usize, work: impl Fn() + Sync) {
    let threads = thread::available_parallelism().map_or(1, usize::from).min(most);
    thread::scope(|scope| {
        for _ in 1..threads {
            if thread::Builder::new().spawn_scoped(scope, &work).is_err() {
                break;
            }
        }
        work();
    });
}
