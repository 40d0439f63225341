//! Values in a program in inches that look like millimetres: feeds above 10 m/min, feeds of contours with RL or RR, and
//! of cycles that plunge, of more than a millimetre a revolution, feeds with which a tool mills fifty times as fast as
//! it cuts elsewhere, or 25.4 times as fast as its tool call says with RL or RR, a blank of more than 3 m, a depth of
//! several times the height of the blank, a thread with less than two turns an inch, a height above 40 inches.
//!
//! Every block with such a feed is reported, and once there is one also those whose feed is too great for a movement
//! that cuts, of which no one can say whether it does. Feeds that stand for rapid traverse (9998 and more) are passed
//! over.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::program::with_meaning;
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::{Amount, Axis, BlkForm, BlockKind, Compensates, CycleDef, Feed, FeedKind, ValueKind};
use crate::spec::{Cycle, Group, MM_PER_INCH, Quantity};

pub(super) const RULE: Rule = Rule { code: "metric-values-in-inch", severity: Severity::Warning, run };

/// Feeds of programs in inches are in tenths of an inch per minute.
const FASTEST: std::ops::Range<f64> = 4000.0..9998.0;
/// From here on a feed is measured by the spindle speed.
const FAST: f64 = 1000.0;
/// The greatest feed a revolution, tenths of an inch.
const WIDEST: f64 = 0.4;
/// So many times as fast as it cuts elsewhere no tool mills: twice what an inch has of millimetres.
const APART: f64 = 50.0;
/// So much a feed may differ from another one in the other unit, as it is rounded.
const ROUNDED: f64 = 0.03;
/// The meanings of feeds with which cycles plunge.
const CUTTING: [&str; 2] = ["plunging-feed", "contour-plunging-feed"];
/// The meanings of feeds with which cycles mill.
const MILLING: [&str; 2] = ["milling-feed", "contour-milling-feed"];
/// The farthest corner of a blank, inches.
const FARTHEST: f64 = 120.0;
/// The meaning of the depth of a cycle, and so many heights of the blank no depth is.
const DEPTH: &str = "depth";
const DEEPEST: f64 = 4.0;

/// The meaning of the pitch of a thread, and the greatest one that any thread in inches has.
const PITCH: &str = "thread-pitch";
const STEEPEST: f64 = 0.5;

/// So far away no machine takes a tool, inches.
const AWAY: f64 = 40.0;
/// So many blocks are looked at for that.
const MOST: usize = 10_000;

/// The feeds of one tool, as far as the program has been read.
#[derive(Default)]
struct Feeds {
    /// The speed of its spindle, if it is a number.
    speed: Option<f64>,
    /// The feed of its call.
    called: Option<f64>,
    /// The least feed.
    least: Option<f64>,
    /// Those that are certainly too great.
    found: Vec<(Span, f64)>,
    /// Those of movements that may pass through the air.
    doubtful: Vec<(Span, f64)>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.inch {
        return;
    }
    far(rule, facts, found);
    let related = |index: usize| facts.definition_at(index).and_then(Defined::related_cycle);
    let mut feeds = Feeds::default();
    let mut corner: Option<(Span, f64)> = None;
    let (mut lowest, mut height) = (None, None);
    let mut pitches = Vec::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            BlockKind::Motion(motion) if motion.outline().has_feed() => {
                let cuts = || {
                    let modal = facts.run.before(index);
                    motion.outline().compensates() == Compensates::Beside
                        || motion.outline().compensates() == Compensates::Unsaid
                            && modal.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes)
                };
                if let Some((span, number)) = written(motion.words().feed.as_ref()) {
                    feeds.moves(span, number, cuts);
                }
            }
            BlockKind::CycleDef(cycle) => {
                feeds.of_cycle(related(index), cycle);
                pitches.extend(related(index).and_then(|related| too_steep(related, cycle)));
                feeds
                    .found
                    .extend(height.zip(related(index)).and_then(|(height, related)| too_deep(related, cycle, height)));
            }
            BlockKind::ToolCall(call) => {
                feeds.speed = match call.speed.map(|own| own.amount) {
                    Some(Amount::Number(number)) if number > 0.0 => Some(number),
                    _ => None,
                };
                let own = written(call.feed.as_ref());
                feeds.least = own.map(|(_, number)| number);
                feeds.called = feeds.least.filter(|own| *own > 0.0);
                feeds.found.extend(own.filter(|(_, number)| FASTEST.contains(number)));
            }
            BlockKind::BlkForm(form) => {
                let far = form.coords.iter().filter_map(|coord| match coord.value.amount {
                    Amount::Number(number) if number.abs() > FARTHEST => Some((coord.span, number)),
                    _ => None,
                });
                corner = corner.or_else(|| far.into_iter().next());
                height = height.or_else(|| height_of(form, &mut lowest));
            }
            _ => {}
        }
    }
    if !feeds.found.is_empty() {
        feeds.found.append(&mut feeds.doubtful);
    }
    for (span, value) in corner.into_iter().chain(feeds.found).chain(pitches) {
        found.push(rule.at(facts, span).arg("value", Arg::Number(value)));
    }
}

/// The pitch of a thread that has less than two turns an inch.
fn too_steep(cycle: &Cycle, written: &CycleDef) -> Option<(Span, f64)> {
    let q = with_meaning(cycle, PITCH)?.q?;
    let own = written.parameters.iter().find(|own| own.q == q)?;
    match own.value.kind {
        ValueKind::Number(number) if number.abs() > STEEPEST => Some((own.value.span, number)),
        _ => None,
    }
}

impl Feeds {
    /// Takes the feed of a movement.
    fn moves(&mut self, span: Span, number: f64, cuts: impl Fn() -> bool) {
        let doubtful = self.is_wide(number) || self.is_apart(number) || self.is_converted(number);
        if FASTEST.contains(&number) || (doubtful && cuts()) {
            self.found.push((span, number));
        } else if self.is_wide(number) {
            self.doubtful.push((span, number));
        }
        self.cut(number);
    }

    /// Takes the feeds of a cycle.
    fn of_cycle(&mut self, cycle: Option<&Cycle>, written: &CycleDef) {
        // Thread cutters may well advance more than a millimetre a revolution.
        let Some(cycle) = cycle.filter(|own| own.file.group != Group::Threads) else { return };
        let numbers = |meanings: [&'static str; 2]| {
            written.parameters.iter().filter_map(move |own| {
                let param = cycle.params.iter().find(|param| param.q == Some(own.q))?;
                let means = param.quantity == Quantity::Feed && meanings.contains(&param.is.as_str());
                match own.value.kind {
                    ValueKind::Number(number) if means => Some((own.value.span, number)),
                    _ => None,
                }
            })
        };
        for (span, number) in numbers(CUTTING) {
            if FASTEST.contains(&number) && self.speed.is_some() || self.is_wide(number) {
                self.found.push((span, number));
            }
            self.cut(number);
        }
        for (span, number) in numbers(MILLING) {
            if self.is_apart(number) {
                self.found.push((span, number));
            }
        }
    }

    fn cut(&mut self, number: f64) {
        if number > 0.0 {
            self.least = Some(self.least.map_or(number, |least| least.min(number)));
        }
    }

    /// Whether a feed of something that cuts is hardly one in tenths of an inch a minute, by the speed.
    fn is_wide(&self, number: f64) -> bool {
        self.speed.is_some_and(|speed| (FAST..FASTEST.end).contains(&number) && number / speed > WIDEST)
    }

    /// Whether a feed is the same in millimetres as that of the tool call is in inches, rounded.
    fn is_converted(&self, number: f64) -> bool {
        let factor = self.called.map(|called| number / called);
        factor.is_some_and(|factor| (factor - MM_PER_INCH).abs() <= ROUNDED * MM_PER_INCH)
    }

    /// The same by the other feeds of the tool.
    fn is_apart(&self, number: f64) -> bool {
        number < FASTEST.end && self.least.is_some_and(|least| number >= APART * least)
    }
}

/// The number that a feed is.
fn written(feed: Option<&Feed>) -> Option<(Span, f64)> {
    match feed.map(|feed| (feed.span, feed.kind)) {
        Some((span, FeedKind::Value(operand))) => match operand.amount {
            Amount::Number(number) => Some((span, number)),
            _ => None,
        },
        _ => None,
    }
}

/// The height of a blank of which both corners are known.
fn height_of(form: &BlkForm, lowest: &mut Option<(Axis, f64)>) -> Option<f64> {
    let at = |axis: Axis| {
        let coord = form.coords.iter().find(|coord| coord.axis == axis && !coord.incremental)?;
        match coord.value.amount {
            Amount::Number(number) => Some(number),
            _ => None,
        }
    };
    if let Some(axis) = form.axis {
        *lowest = at(axis).map(|number| (axis, number));
        return None;
    }
    let (axis, bottom) = (*lowest)?;
    at(axis).map(|top| top - bottom).filter(|height| *height > 0.0)
}

/// The depth of a cycle, if it is several times the height of the blank.
fn too_deep(cycle: &Cycle, written: &CycleDef, height: f64) -> Option<(Span, f64)> {
    let depth = with_meaning(cycle, DEPTH)?.q?;
    written.parameters.iter().find_map(|own| match own.value.kind {
        ValueKind::Number(number) if number.abs() > DEEPEST * height && own.q == depth => {
            Some((own.value.span, number))
        }
        _ => None,
    })
}

/// The only movement along the tool axis to a height that is one in millimetres, among others that are none.
fn far(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut high, mut usual) = (Vec::new(), false);
    for block in facts.program.blocks().iter().take(MOST) {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let words = motion.words();
        if words.functions.iter().any(|own| matches!(own.number, 91 | 92)) {
            continue;
        }
        let Some(height) = words.coord(Axis::Z).filter(|own| !own.incremental) else { continue };
        let Amount::Number(value) = height.value.amount else { continue };
        usual |= value > 0.0 && value <= AWAY;
        if value > AWAY {
            high.push((value, height.value.span));
        }
    }
    if let ([(value, span)], true) = (high.as_slice(), usual) {
        found.push(rule.at(facts, *span).arg("value", Arg::Number(*value)));
    }
}
