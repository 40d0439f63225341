//! What an execution no longer knows after a cycle that nobody describes, after one that has not come to its end, and
//! after the workpiece was turned: what was made before may be deeper and wider since, but places in the blank are what
//! they were.
use super::watcher::Watcher;

impl Watcher<'_> {
    /// A cycle has not come to its end: what it would have made, and where it would have left the tool, is not known.
    pub(super) fn leave_cycle(&mut self) {
        (self.work, self.faulty) = (None, false);
        (self.remains.open, self.series.open, self.others, self.turned.open) = (true, true, true, true);
        self.known = [false; 3];
        self.holes.clear();
        self.threads.clear();
        self.areas.clear();
    }

    /// What a cycle drills and mills is not known if no description says how to execute it: it may have made the holes
    /// deeper and wider that are there when it is passed over.
    pub(super) fn pass_undescribed(&mut self) {
        self.finish();
        (self.remains.open, self.others, self.turned.open) = (true, true, true);
        self.series.open |= !self.undescribed_mills;
        self.holes.clear();
        self.threads.clear();
    }

    /// Whether the workpiece turns from here on. What is left of it is not known then, but a round one is no wider than
    /// it was, and lies where it was; which way its holes look is not known.
    pub(super) fn note_turning(&mut self, turning: bool) {
        self.turning = turning;
        if turning {
            (self.remains.open, self.others) = (true, true);
            self.lost |= self.body.is_none_or(|body| !body.is_round());
            self.series.open |= self.lost || self.series.has_any();
            self.holes.clear();
            self.threads.clear();
            self.machined.clear();
            self.milled.clear();
            self.areas.clear();
            self.walls.clear();
        }
    }
}
