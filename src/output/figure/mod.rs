//! Figures: drawings of cycles, made from runs of their examples and measured against the parameters that they name.
//!
//! A figure is run once for a cycle on a control ([`prepare`]); only its words depend on the language ([`Figure::svg`]).
//! Start with `shot` (the run), then `measure`, `frame` (the layout) and `sheet` (the drawing). Invariant: knows events
//! and scenes, specifications and texts, and no command; the same data give the same bytes.
mod axonometric;
mod bar;
mod cutter;
mod cylinder;
mod dimension;
mod frame;
mod half_plane;
mod lanes;
mod measure;
mod pen;
mod plot;
mod profile;
mod relief;
mod rotary;
mod scan;
mod setter;
mod setter_other_mounting;
mod sheet;
mod shot;
mod slabs;
mod slice;
mod stroke;
mod subject;
mod turned;
mod way;
mod window;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::sync::OnceLock;

use crate::base::diag::Diagnostic;
use crate::language::text::CycleText;
use crate::spec::{Catalogue, Cycle, DimensionKind, Figure as Declared, OnControl, Shape, Worked, dimensions};
use crate::tools::conform::World;

use measure::Measured;
use pen::{Rect, escaped, short};
use sheet::Plate;
use shot::Shot;
use subject::{Subject, Words};

pub use plot::{Legend, Plot, View};

/// The width of a figure in pixels.
const WIDTH: f64 = 360.0;
/// The greatest height of what it shows, without dimensions and legend.
const HEIGHT: f64 = 300.0;
/// The same of a figure that stands in a row with others.
const SMALL: [f64; 2] = [170.0, 150.0];

/// The rules of a figure that is a file of its own; the style sheet of the manual has the same classes.
const STYLE: &str = include_str!("../../../templates/assets/figure.css");

/// A figure that was run and measured.
#[derive(Debug)]
pub struct Figure<'c> {
    declared: &'c Declared,
    /// The value of the parameter whose choices it shows.
    chosen: Option<&'c str>,
    shot: Shot,
    measured: Vec<Measured>,
    /// As it was drawn first, for the other languages.
    plate: OnceLock<Plate>,
}

/// A figure in a language.
#[derive(Clone, Debug, PartialEq)]
pub struct Svg {
    /// The element `svg`.
    pub text: String,
    /// Its title.
    pub title: String,
    /// Where its texts are, in pixels: left, upper, right and lower edge.
    pub texts: Vec<[f64; 4]>,
    /// What its dimensions show: the class of each and the id of the row of its parameter.
    pub shown: Vec<(String, String)>,
}

/// Where a figure stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Medium {
    /// On a page that has the style sheet; dimensions are links to the rows of their parameters.
    Page,
    /// In a file of its own.
    File,
}

/// Runs and measures all figures of a cycle; also what is wrong with them.
pub fn prepare<'c>(world: &World<'_>, on: &'c OnControl, cycle: &'c Cycle) -> (Vec<Figure<'c>>, Vec<Diagnostic>) {
    prepare_all(world, on, cycle, &cycle.file.figures)
}

/// Runs and measures the pictures of a worked program; also what is wrong with them.
pub fn prepare_worked<'c>(
    world: &World<'_>,
    on: &'c OnControl,
    worked: &'c Worked,
) -> (Vec<Figure<'c>>, Vec<Diagnostic>) {
    on.cycles.get(&worked.key).map_or_else(Default::default, |cycle| prepare_all(world, on, cycle, &worked.figures))
}

fn prepare_all<'c>(
    world: &World<'_>,
    on: &'c OnControl,
    cycle: &'c Cycle,
    figures: &'c [Declared],
) -> (Vec<Figure<'c>>, Vec<Diagnostic>) {
    let (mut ready, mut found) = (Vec::new(), Vec::new());
    let mut names = BTreeSet::new();
    for declared in figures {
        let dimensions = dimensions(on, cycle, declared);
        for chosen in choices(cycle, declared) {
            let name = stem(cycle, declared, chosen);
            if !names.insert(name.clone()) {
                let taken = Diagnostic::error("figure-name-taken", declared.name.place.clone());
                found.push(taken.arg("name", name).arg("cycle", cycle.key.to_string()));
                continue;
            }
            match shot::take(world, on, cycle, declared, &dimensions, chosen) {
                Ok(shot) => {
                    let (measured, wrong) = measure::measure(cycle, declared, &dimensions, &shot);
                    found.extend(wrong);
                    ready.push(Figure { declared, chosen, shot, measured, plate: OnceLock::new() });
                }
                Err(wrong) => found.extend(wrong),
            }
        }
    }
    (ready, found)
}

/// The name of a file for a figure; no two of a cycle have the same.
fn stem(cycle: &Cycle, declared: &Declared, chosen: Option<&str>) -> String {
    let name = format!("{}-{}", cycle.key.number, declared.name.as_str());
    chosen.map_or_else(|| name.clone(), |chosen| format!("{name}-{chosen}"))
}

/// The values for each of which a figure is drawn; one nothing for a figure that stands alone.
fn choices<'c>(cycle: &'c Cycle, figure: &'c Declared) -> Vec<Option<&'c str>> {
    let Some(q) = figure.each else { return vec![None] };
    if !figure.values.is_empty() {
        return figure.values.iter().map(|value| Some(value.as_str())).collect();
    }
    let choices = cycle.param(q).map_or(&[][..], |param| &param.choices);
    choices.iter().map(|choice| Some(choice.value.as_str())).collect()
}

/// What is wrong with the figures of all cycles; what several controls share shows once.
pub fn check(catalogue: &Catalogue, world: &World<'_>, wanted: &dyn Fn(&Cycle) -> bool) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values().filter(|cycle| wanted(cycle)) {
            found.extend(prepare(world, on, cycle).1);
            found.extend(on.worked_of(cycle.key).flat_map(|worked| prepare_worked(world, on, worked).1));
        }
    }
    crate::base::diag::dedupe(&mut found);
    found
}

impl Figure<'_> {
    /// The name of a file for it, without extension: `205-section`, `251-plunging-1`.
    pub fn stem(&self, cycle: &Cycle) -> String {
        stem(cycle, self.declared, self.chosen)
    }

    /// The name that it is declared with.
    pub fn name(&self) -> &str {
        self.declared.name.as_str()
    }

    /// Whether it stands in a row with others.
    pub const fn is_of_row(&self) -> bool {
        self.chosen.is_some() || self.declared.small
    }

    /// The figure in a language.
    pub fn svg(&self, text: &CycleText<'_>, medium: Medium) -> Svg {
        let params: Vec<_> = self.measured.iter().map(|measured| self.param(text, measured)).collect();
        let labels = params.iter().zip(&self.measured).map(|(param, measured)| match (measured.field, param) {
            (true, Some(param)) => match (&param.coordinates, measured.along) {
                // A position has a number for each axis.
                (Some(before), Some(axis)) => {
                    let turns = measured.kind == DimensionKind::Turn;
                    let letter = if turns { axonometric::letter(&self.shot, axis) } else { self.shot.letter(axis) };
                    format!("{before}{letter}")
                }
                _ => param.word.clone(),
            },
            _ if measured.is_half() => format!("\u{2300} {}", measured.of),
            _ => measured.of.clone(),
        });
        let labels = labels.zip(&self.measured).map(|(label, measured)| {
            // Labels beside the drawing are narrow, those above and below it are low.
            let gap = if frame::direction(measured, self.declared.view) == Some(1) { '\n' } else { ' ' };
            match (&measured.plus, &measured.reduces) {
                (Some(datum), _) => format!("{}{gap}+ {label}", text.datum(datum)),
                (None, Some(whole)) => format!("{whole}{gap}\u{2212} {label}"),
                (None, None) => label,
            }
        });
        let links = params.iter().map(|param| param.as_ref().map(|param| param.row.clone()));
        let links: Vec<Option<String>> = links.map(|link| link.filter(|_| medium == Medium::Page)).collect();
        let words = Words {
            labels: labels.collect(),
            links,
            ways: ["way-rapid", "way-feed", "way-probing"].map(|id| text.word(id).into_owned()),
        };
        let marks: Vec<u32> = self.declared.marks.iter().map(|mark| mark.number).collect();
        let [width, height] = if self.is_of_row() { SMALL } else { [WIDTH, HEIGHT] };
        let subject = Subject {
            view: self.declared.view,
            shot: &self.shot,
            measured: &self.measured,
            marks: &marks,
            round: self.declared.blank.as_ref().is_some_and(|blank| blank.round),
            whole: self.declared.whole,
            height,
            width,
        };
        let plate = self.plate.get_or_init(|| sheet::draw(&subject, &words));
        let drawn = match plate.has(&words) {
            true => plate.finished(&subject, &words),
            false => sheet::draw(&subject, &words).finished(&subject, &words),
        };
        let title = self.title(text);
        let mut shown: Vec<String> = Vec::new();
        for param in params.iter().flatten() {
            // A field of an old-style line may be called by its name, and have a dimension for each axis.
            let said =
                if param.shown == param.name { param.name.clone() } else { format!("{}: {}", param.shown, param.name) };
            if !shown.contains(&said) {
                shown.push(said);
            }
        }
        let [w, h] = [drawn.size.x, drawn.size.y].map(short);
        // Screen readers do not look into an image; links they must find.
        let role = if words.links.iter().any(Option::is_some) { "document" } else { "img" };
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ciklo-figure\" role=\"{role}\" viewBox=\"0 0 {w} {h}\" \
             width=\"{w}\" height=\"{h}\">\n<title>{}</title>\n<desc>{}</desc>\n",
            escaped(&title),
            escaped(&shown.join("; ")),
        );
        if medium == Medium::File {
            let _ = write!(svg, "<style>{STYLE}</style>\n<rect class=\"b\" width=\"{w}\" height=\"{h}\"/>\n");
        }
        svg.push_str(&drawn.body);
        svg.push_str("</svg>\n");
        let pairs = self.measured.iter().zip(&params).filter_map(|(measured, param)| {
            param.as_ref().map(|param| (dimension::class(&measured.of), param.row.clone()))
        });
        let edges = |rect: &Rect| [rect.min.x, rect.min.y, rect.max.x, rect.max.y];
        let mut shown: Vec<(String, String)> = pairs.collect();
        shown.sort();
        shown.dedup();
        Svg { text: svg, title, texts: drawn.texts.iter().map(edges).collect(), shown }
    }

    fn title(&self, text: &CycleText<'_>) -> String {
        let title = text.figure(&self.declared.name);
        match (self.declared.each, self.chosen) {
            (Some(q), Some(chosen)) => format!("{title}, {q} = {}", chosen.replace('-', "\u{2212}")),
            _ => title.into_owned(),
        }
    }

    fn param(&self, text: &CycleText<'_>, measured: &Measured) -> Option<Shown> {
        let is = |param: &&crate::spec::Param| match (&param.q, &param.field) {
            (Some(q), _) => !measured.field && q.to_string() == measured.of,
            (None, Some(field)) => measured.field && field.id.as_str() == measured.of,
            _ => false,
        };
        let param = text.cycle.params.iter().find(is)?;
        let texts = text.param(param);
        let word = texts.label.as_deref().map(|word| word.trim_end_matches(':').to_owned());
        let word = word.filter(|word| !word.is_empty()).unwrap_or_else(|| texts.name.to_string());
        let shown = if measured.field { word.clone() } else { measured.of.clone() };
        let coordinates = match param.field.as_ref().map(|field| field.shape) {
            Some(Shape::Position | Shape::AxisCoordinate) => {
                Some(text.before_axis(param).map(|word| format!("{word} ")).unwrap_or_default())
            }
            Some(Shape::Centre) => Some("CC".to_owned()),
            _ => None,
        };
        Some(Shown { row: row(&texts.q), name: texts.name.into_owned(), word, shown, coordinates })
    }
}

/// The id of the row of a parameter: `Q200`, `field-31-2-height`.
pub fn row(q: &str) -> String {
    if q.starts_with('Q') { q.to_owned() } else { format!("field-{}", q.replace(['.', ' '], "-")) }
}

/// The texts of a parameter that a figure shows.
struct Shown {
    row: String,
    name: String,
    word: String,
    shown: String,
    /// Of a value with a number for each axis, what programs write before the letters of the axes.
    coordinates: Option<String>,
}
