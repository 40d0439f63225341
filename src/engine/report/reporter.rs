//! The one place through which events leave a run.
//!
//! Invariant: events come out in the order in which they happen; what waits for the element of a contour before it, and
//! what only happens in a rehearsal, does not come out here.
use std::sync::Arc;

use glam::DVec3;

use super::event::{At, Event, EventKind, MoveKind, OnDiameter, Status};
use super::threads::Threads;
use crate::engine::solid::Path;

/// Reports events to the caller of a run.
pub(crate) struct Reporter<'r> {
    emit: &'r mut dyn FnMut(&Event),
    /// The event reported last; its place is that of what is executed now.
    event: Event,
    /// The threads that are being cut.
    threads: Threads,
    /// Whether what happens is only rehearsed.
    rehearsing: bool,
    /// Whether events wait.
    holding: bool,
    held: Vec<Event>,
    /// How many events were handed out.
    count: usize,
}

impl<'r> Reporter<'r> {
    pub(crate) fn new(program: Arc<str>, emit: &'r mut dyn FnMut(&Event)) -> Self {
        let event = Event { at: At { program, ..At::default() }, kind: EventKind::End(Status::Done) };
        Self { emit, event, threads: Threads::default(), rehearsing: false, holding: false, held: Vec::new(), count: 0 }
    }

    /// How many events were handed out so far.
    pub(crate) const fn count(&self) -> usize {
        self.count
    }

    /// The place of what is executed now.
    pub(crate) const fn at(&self) -> &At {
        &self.event.at
    }

    /// The same, to be changed.
    pub(crate) const fn at_mut(&mut self) -> &mut At {
        &mut self.event.at
    }

    /// Whether what happens from now on is only rehearsed.
    pub(crate) const fn rehearse(&mut self, rehearsing: bool) {
        self.rehearsing = rehearsing;
    }

    /// Whether what happens is only rehearsed.
    pub(crate) const fn is_rehearsing(&self) -> bool {
        self.rehearsing
    }

    /// Whether events wait from now on, until they are [taken](Self::take_held).
    pub(crate) const fn hold(&mut self, holding: bool) {
        self.holding = holding;
    }

    /// The events that waited.
    pub(crate) fn take_held(&mut self) -> std::vec::Drain<'_, Event> {
        self.held.drain(..)
    }

    /// How many events wait.
    pub(crate) const fn held(&self) -> usize {
        self.held.len()
    }

    /// Reports what happens here.
    #[inline]
    pub(crate) fn report(&mut self, kind: EventKind) {
        self.event.kind = kind;
        self.pass();
    }

    /// Reports a move; where one was reported before, only its numbers change.
    #[expect(clippy::too_many_arguments, reason = "they are the members of the event")]
    pub(crate) fn report_move(
        &mut self,
        kind: MoveKind,
        from: DVec3,
        to: DVec3,
        machine: DVec3,
        feed: f64,
        path: Path,
        turned: Option<OnDiameter>,
    ) {
        match &mut self.event.kind {
            EventKind::Move { kind: a, from: b, to: c, machine: d, feed: e, path: f, turned: g } => {
                (*a, *b, *c, *d, *e, *f, *g) = (kind, from, to, machine, feed, path, turned);
            }
            other => *other = EventKind::Move { kind, from, to, machine, feed, path, turned },
        }
        self.pass();
    }

    /// Reports an event that has waited.
    pub(crate) fn report_waiting(&mut self, event: Event) {
        let at = std::mem::replace(&mut self.event.at, event.at);
        self.report(event.kind);
        self.event.at = at;
    }

    /// Hands out an event that still waited when the run ended.
    pub(crate) fn emit(&mut self, event: &Event) {
        (self.emit)(event);
    }

    /// Hands out the event that is there, unless it waits or only happens in a rehearsal.
    fn pass(&mut self) {
        if self.holding {
            self.held.push(self.event.clone());
        } else if !self.rehearsing {
            if let Some(thread) = self.threads.see(&self.event) {
                self.count += 1;
                (self.emit)(&thread);
            }
            self.count += 1;
            (self.emit)(&self.event);
        }
    }
}
