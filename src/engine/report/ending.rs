//! How the execution of something ends that does not come to its end.
use super::fault::Fault;

/// Why execution leaves the straight way.
#[derive(Clone, Debug)]
pub enum Leave {
    /// With a fault.
    Fault(Fault),
    /// The program stopped and no one continued it.
    Stopped,
}

impl<F: Into<Fault>> From<F> for Leave {
    fn from(fault: F) -> Self {
        Self::Fault(fault.into())
    }
}

/// What executing something gives.
pub type Done<T = ()> = Result<T, Leave>;
