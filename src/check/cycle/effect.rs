//! What the definitions of a cycle do to the state of the control, read off its specification once for all of them.
//!
//! Invariant: a cycle of which nothing is known may do anything.
use super::aspect::{Aspect, Tri};
use crate::base::expr::{Code, Env, OnlyParameters, QRef, compile};
use crate::spec::{
    Action, Argument, Body, Cycle, Group, Item, Keyword, Known as Of, Quantity, TakesEffect, Transformation, Verb,
};

/// What the definitions of a cycle do.
#[derive(Debug, Default)]
pub(in crate::check) struct Effect {
    /// Anything may happen.
    pub(in crate::check) anything: bool,
    /// A call means it from here on.
    pub(in crate::check) pends: Option<bool>,
    pub(in crate::check) aspects: Vec<(Aspect, Then)>,
    /// The parameters that it writes its results into.
    pub(in crate::check) results: Vec<QRef>,
    /// Whether it keeps the data that other cycles share.
    pub(in crate::check) keeps: bool,
    /// Whether it works with them.
    pub(in crate::check) recalls: bool,
    /// Whether it calls the cycle that was defined last.
    pub(in crate::check) calls_last: bool,
    /// Whether the spindle is stopped after its call.
    pub(in crate::check) stops_spindle: bool,
    /// Whether it aligns the turning system for the tool.
    pub(in crate::check) aligns: bool,
    /// What it does to the basic rotation, in order.
    pub(in crate::check) rotations: Vec<Rotates>,
    /// The values of parameters that the control lacks.
    pub(in crate::check) lacking: Vec<(QRef, f64)>,
}

/// A change of the basic rotation.
#[derive(Debug)]
pub(in crate::check) struct Rotates {
    /// Only if this holds; always where that needs more than parameters.
    when: Option<Code>,
    /// The row of the preset table that it goes to in the place of taking effect, if it is not 0.
    row: Option<Code>,
    /// The angle, if it is not measured.
    angle: Option<Code>,
    /// Whether it ends.
    ends: bool,
}

impl Rotates {
    fn of(strategy: &str, action: &Action) -> Option<Self> {
        let ends = strategy == "reset-basic-rotation";
        if !ends && !matches!(strategy, "write-basic-rotation" | "turn-basic-rotation") {
            return None;
        }
        let of = |name: &str| {
            let formula = action.with.0.iter().find(|(own, _)| own.as_str() == name);
            formula.and_then(|(_, formula)| compile(&formula.expr, &OnlyParameters).ok())
        };
        let when = action.when.as_ref().and_then(|formula| compile(&formula.expr, &OnlyParameters).ok());
        Some(Self { when, row: of("row"), angle: of("angle"), ends })
    }

    /// Whether a basic rotation is active then, from whether one was.
    pub(in crate::check) fn then(&self, before: Tri, values: &impl Env) -> Tri {
        let happens = self.when.as_ref().map_or(Some(true), |code| code.truth(values).ok());
        let stored = self.row.as_ref().map_or(Some(false), |code| code.number(values).ok().map(|row| row != 0.0));
        let turned = match &self.angle {
            _ if self.ends => Tri::No,
            Some(code) => Tri::of(code.number(values).ok().map(|angle| angle != 0.0)),
            None => Tri::Yes,
        };
        match (happens, stored) {
            (Some(false), _) | (_, Some(true)) => before,
            (Some(true), Some(false)) => turned,
            _ => Tri::Unknown,
        }
    }
}

/// What becomes of an aspect.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) enum Then {
    Certain(Tri),
    /// What the lines of the definition state.
    Written,
}

impl From<Tri> for Then {
    fn from(tri: Tri) -> Self {
        Self::Certain(tri)
    }
}

/// The strategy that reads what another cycle keeps.
const RECALL: &str = "recall-contour-data";

/// The name of the cycle that was defined last.
const LAST_CYCLE: &str = "last-cycle";

impl Effect {
    /// Whether the cycle keeps data that others share.
    pub(in crate::check) const fn keeps(&self) -> bool {
        self.keeps
    }

    /// Whether the cycle works with such data.
    pub(in crate::check) const fn recalls(&self) -> bool {
        self.recalls
    }

    /// Whether the cycle aligns the turning system for the tool.
    pub(in crate::check) const fn aligns(&self) -> bool {
        self.aligns
    }

    /// Whether the cycle calls the one that was defined last.
    pub(in crate::check) const fn calls_last(&self) -> bool {
        self.calls_last
    }

    /// What definitions of a described cycle do.
    pub(in crate::check) fn of_cycle(cycle: &Cycle) -> Self {
        Self::of(Of::Described(cycle), cycle.key.keyword, false)
    }

    /// What definitions of a cycle do.
    ///
    /// An unknown cycle with numbered lines, or one whose name says that it machines (`old`), is one of the first
    /// controls: those machine when they are called, and leave coordinates and modes alone.
    pub(in crate::check) fn of(known: Of<'_>, keyword: Keyword, old: bool) -> Self {
        let mut effect = Self::default();
        match known {
            Of::Described(cycle) => effect.described(cycle),
            Of::Named(named) => {
                // Touch probe cycles act at once; of others no one knows when.
                effect.pends = (keyword != Keyword::TchProbe).then_some(false);
                for aspect in
                    [Aspect::Feed, Aspect::Contour, Aspect::ContourData, Aspect::Pattern, Aspect::Compensation]
                {
                    effect.aspects.push((aspect, Tri::Unknown.into()));
                }
                match named.activates {
                    Some(transformation) => effect.aspects.push((aspect(transformation), Then::Written)),
                    None => {
                        for aspect in [Aspect::DatumShift, Aspect::Rotation] {
                            effect.aspects.push((aspect, Tri::Unknown.into()));
                        }
                    }
                }
            }
            Of::Unknown if old && keyword == Keyword::CyclDef => {
                effect.pends = Some(false);
                for aspect in [Aspect::Feed, Aspect::Compensation] {
                    effect.aspects.push((aspect, Tri::Unknown.into()));
                }
            }
            Of::Builders | Of::Unknown => effect.anything = true,
        }
        effect
    }

    fn described(&mut self, cycle: &Cycle) {
        if probes(cycle) {
            self.aspects.push((Aspect::Probed, Tri::Yes.into()));
        }
        match cycle.file.takes_effect {
            TakesEffect::OnCall => self.pends = Some(true),
            // What only changes coordinates or names a contour moves nothing, unless it states a feed.
            TakesEffect::OnDefinition if !moves(cycle) => {}
            TakesEffect::OnDefinition => self.aspects.push((Aspect::Feed, Tri::Unknown.into())),
        }
        self.results.extend(cycle.file.results.iter().filter_map(|results| results.q));
        self.lacking.clone_from(&cycle.lacking);
        let mut verbs = Vec::new();
        cycle.file.run.iter().for_each(|item| actions(item, &mut verbs));
        for action in verbs {
            match (action.verb, &action.argument) {
                (Verb::Transform, Argument::Many(entries)) => {
                    for (name, argument) in &entries.0 {
                        self.transforms(name.as_str(), argument);
                    }
                }
                (Verb::Remember, Argument::Many(entries)) => {
                    if entries.0.iter().any(|(name, _)| name.as_str() == "contour") {
                        self.aspects.push((Aspect::Contour, Tri::Yes.into()));
                    } else {
                        self.keeps = true;
                        self.aspects.push((Aspect::ContourData, Tri::Yes.into()));
                    }
                }
                (Verb::Call, Argument::One(name)) => self.calls_last |= name.as_str() == LAST_CYCLE,
                (Verb::Strategy, Argument::One(name)) => {
                    self.recalls |= name.as_str() == RECALL;
                    if let "align-turning-system" | "reset-turning-system" = name.as_str() {
                        let aligns = name.as_str().starts_with("align");
                        self.aligns |= aligns;
                        self.aspects.push((Aspect::Aligned, if aligns { Tri::Yes } else { Tri::Unknown }.into()));
                    }
                    self.rotations.extend(Rotates::of(name.as_str(), action));
                }
                (Verb::Spindle, Argument::One(name)) if cycle.file.takes_effect == TakesEffect::OnCall => {
                    self.stops_spindle |= name.as_str() == "stop";
                }
                (Verb::Spindle | Verb::Orient, _) if cycle.file.takes_effect == TakesEffect::OnDefinition => {
                    self.aspects.push((Aspect::Spindle, Tri::Unknown.into()));
                }
                _ => {}
            }
        }
    }

    fn transforms(&mut self, what: &str, argument: &Argument) {
        let aspect = match what {
            "datum-shift" => Aspect::DatumShift,
            "datum-row" => {
                self.aspects.push((Aspect::DatumShift, Tri::Unknown.into()));
                return;
            }
            "mirroring" => Aspect::Mirroring,
            "rotation" => Aspect::Rotation,
            "scaling" => Aspect::Scaling,
            "axis-scaling" => Aspect::AxisScaling,
            "tilting" => Aspect::Tilting,
            "cancel" => {
                let Argument::List(words) = argument else { return };
                for word in words {
                    let Argument::One(name) = word else { continue };
                    let aspect = match name.as_str() {
                        "radius-compensation" => Aspect::Compensation,
                        "datum-shift" => Aspect::DatumShift,
                        "mirroring" => Aspect::Mirroring,
                        "rotation" => Aspect::Rotation,
                        "scaling" => Aspect::Scaling,
                        "axis-scaling" => Aspect::AxisScaling,
                        _ => continue,
                    };
                    self.aspects.push((aspect, Tri::No.into()));
                }
                return;
            }
            _ => {
                // A preset has a basic rotation of its own.
                for aspect in [Aspect::DatumShift, Aspect::Rotation, Aspect::BasicRotation] {
                    self.aspects.push((aspect, Tri::Unknown.into()));
                }
                return;
            }
        };
        self.aspects.push((aspect, Then::Written));
    }
}

/// Whether a cycle that acts when it is defined may move the tool, or leave a feed behind.
fn moves(cycle: &Cycle) -> bool {
    !matches!(cycle.file.group, Group::Transforms | Group::Contours)
        || cycle.params.iter().any(|param| param.quantity == Quantity::Feed)
}

/// Whether the spindle is stopped after a call of a cycle.
pub(in crate::check) fn stops_spindle(cycle: &Cycle) -> bool {
    Effect::of_cycle(cycle).stops_spindle
}

/// Whether a cycle mills, drills or cuts threads.
pub(crate) fn removes_material(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours | Group::Surfaces)
        && cycle.file.takes_effect == TakesEffect::OnCall
}

/// Whether a cycle touches the workpiece with a probe in the spindle.
pub(in crate::check) fn probes(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Rotation | Group::Datum | Group::Measuring)
        && cycle.file.keyword == Keyword::TchProbe
}

/// Whether a cycle probes around something: the names of the cycles say so.
pub(in crate::check) fn probes_around(cycle: &Cycle) -> bool {
    ["outside", "stud"].iter().any(|own| cycle.file.name.as_str().contains(own))
}

fn aspect(transformation: Transformation) -> Aspect {
    match transformation {
        Transformation::Mirroring => Aspect::Mirroring,
        Transformation::Scaling => Aspect::Scaling,
        Transformation::AxisScaling => Aspect::AxisScaling,
        Transformation::Tilting => Aspect::Tilting,
        Transformation::Turning => Aspect::Turning,
    }
}

/// All actions of a step.
pub(super) fn actions<'c>(item: &'c Item, found: &mut Vec<&'c Action>) {
    let body: &Body = &item.body;
    let cases = item.choose.iter().flat_map(|case| &case.actions);
    found.extend(body.actions.iter().chain(&item.then).chain(cases));
    body.items.iter().chain(&item.items).chain(&item.between).for_each(|inner| actions(inner, found));
}
