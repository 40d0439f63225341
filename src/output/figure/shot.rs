//! A run of an example up to the moment that a figure shows: the ways of the tool, what it touched, what was measured.
//!
//! Invariant: all points are in the coordinates that were active when the cycle began: main, secondary, tool axis.
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::cylinder::{Round, Table};
use super::half_plane::{Blank, HalfPlane, Insert, Stand};
use super::rotary::{self, Rotary};
use super::setter::Setter;
use super::stroke::{Stroke, Turning, Way};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{self, Dialect, Env, EvalError, OnlyParameters, QRef, Value, parse};
use crate::engine::geometry::{Axis, Frame, WorkingPlane};
use crate::engine::machine::Tool;
use crate::engine::plan::{self, Watch};
use crate::engine::run::{Engine, Event, EventKind, MoveKind, NoTexts, Noted, Status};
use crate::engine::scene::Scene;
use crate::engine::solid::{Body, Path, Shape};
use crate::program::syntax;

use crate::spec::{
    Along, Cycle, CycleKey, Dimension, Example, Figure, FigureMoment, FigureView, Formula, Kind, Name, Node, OnControl,
};
use crate::tools::conform::{self, World};

/// Where among the values of a figure itself the coordinate of the cut is.
pub(super) const CUT: usize = 0;
/// The surface of the blank and its lower face.
pub(super) const TOP: usize = 1;
pub(super) const BOTTOM: usize = 2;
/// Its corners.
pub(super) const CORNERS: [usize; 2] = [3, 4];
/// The corners of the range of a scan.
pub(super) const SCAN: [usize; 2] = [5, 6];
/// The tip of an insert and the pitch of the thread that it cuts.
const TIP: usize = 7;
const PITCH: usize = 8;
/// The radius of a part on a rotary axis.
const RADIUS: usize = 9;
/// The axis of the bore that a boring bar goes through, its diameter, that of the bar, and the height of the edge.
pub(super) const BAR: usize = 10;
/// The first of the marks; after them, the corners of what a blank lacks.
pub(super) const MARKS: usize = 14;

/// A run at a moment.
#[derive(Debug)]
pub(super) struct Shot {
    /// The ways until then.
    pub(super) strokes: Vec<Stroke>,
    /// The ways after it, which no figure draws.
    pub(super) later: Vec<Stroke>,
    /// The points that were touched.
    pub(super) contacts: Vec<DVec3>,
    /// The centres of the arcs of the whole run.
    pub(super) centres: Vec<DVec3>,
    /// The tool in the spindle and where its tip is; of a probe, the centre of its ball.
    pub(super) tool: Option<(Tool, DVec3)>,
    /// Where the datum is now, if the cycle has set another one.
    pub(super) datum: Option<DVec3>,
    /// The directions of the main, secondary and tool axis now.
    pub(super) axes: [DVec3; 3],
    /// How the spindle stands or turns.
    pub(super) turning: Turning,
    /// The radius of the ball of the touch probe, if it is one.
    pub(super) ball: Option<f64>,
    /// The tool setter, if a tool is at it that is no touch probe.
    pub(super) setter: Option<Setter>,
    /// The rotary axes, in a view along one of them.
    pub(super) rotary: Option<Rotary>,
    /// The parts of the scene, and from the machine to the coordinates of the shot.
    pub(super) parts: Shape,
    /// The same, ready for questions.
    body: Body,
    /// From the machine to the coordinates of the shot.
    pub(super) back: DAffine3,
    /// The axes of the working plane.
    pub(super) plane: WorkingPlane,
    /// What is left of a part on a rotary axis.
    pub(super) round: Option<Round>,
    /// What is left of a part that is turned.
    pub(super) turned: Option<HalfPlane>,
    /// The values of the places of each dimension: its parameter, from, to, centre.
    pub(super) places: Vec<[Option<Value>; 4]>,
    /// The values of the places of the figure itself.
    pub(super) own: Vec<Option<Value>>,
}

impl Shot {
    /// The letter of an axis.
    pub(super) const fn letter(&self, axis: Along) -> char {
        match axis {
            Along::Main => self.plane.main.letter(),
            Along::Minor => self.plane.secondary.letter(),
            Along::Tool => self.plane.tool.letter(),
        }
    }

    /// Whether the ball of the touch probe touches a part when its centre is there.
    pub(super) fn ball_touches(&self, centre: DVec3) -> bool {
        const NEAR: f64 = 1e-3;
        let own = self.plane.lift(centre.truncate(), centre.z);
        let machine = self.back.inverse().transform_point3(own);
        self.ball.is_some_and(|ball| self.body.touches(ball + NEAR, machine).unwrap_or(false))
    }

    /// Whether a place lies on the surface of a part: there is material near it, and none.
    pub(super) fn is_on_part(&self, place: DVec3) -> bool {
        const NEAR: f64 = 0.02;
        let forth = self.back.inverse();
        let held = |p: DVec3| {
            let own = self.plane.lift(p.truncate(), p.z);
            self.body.contains(forth.transform_point3(own)).unwrap_or(false)
        };
        let around =
            [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [place + axis * NEAR, place - axis * NEAR]);
        let found: Vec<bool> = around.map(held).collect();
        found.contains(&true) && found.contains(&false)
    }
}

/// A coordinate among those of the figure itself: of the cut, top, bottom.
pub(super) fn number(shot: &Shot, place: usize) -> Option<f64> {
    match shot.own.get(place)? {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    }
}

/// A point among those of the figure itself.
pub(super) fn point(shot: &Shot, place: usize) -> Option<DVec3> {
    match shot.own.get(place)? {
        Some(Value::Point(point)) => Some(*point),
        _ => None,
    }
}

/// What a figure asks of a run beside its dimensions, in the order of the constants for their places.
fn own_places(figure: &Figure) -> Vec<Option<&Formula>> {
    let (blank, insert) = (figure.blank.as_ref(), figure.insert.as_ref());
    let mut places = vec![
        figure.cut.as_ref(),
        blank.and_then(|blank| blank.top.as_ref()),
        blank.and_then(|blank| blank.bottom.as_ref()),
        blank.and_then(|blank| blank.least.as_ref()),
        blank.and_then(|blank| blank.greatest.as_ref()),
        figure.scan.as_ref().map(|scan| &scan.least),
        figure.scan.as_ref().map(|scan| &scan.greatest),
        insert.map(|insert| &insert.tip),
        insert.and_then(|insert| insert.pitch.as_ref()),
        blank.and_then(|blank| blank.radius.as_ref()),
    ];
    let bar = figure.bar.as_ref();
    places.extend(bar.map_or([None; 4], |bar| [&bar.at, &bar.bore, &bar.neck, &bar.edge].map(Some)));
    places.extend(figure.marks.iter().map(|mark| Some(&mark.at)));
    places.extend(blank.iter().flat_map(|blank| &blank.without).map(Some));
    places
}

/// The value of an expression that names nothing of a run.
fn constant(formula: &Formula) -> Option<Value> {
    struct Nothing;
    impl Env for Nothing {
        fn slot(&self, _: usize) -> &Value {
            // No name has a slot here, so nothing asks for one.
            const NONE: &Value = &Value::Number(f64::NAN);
            NONE
        }
        fn number(&self, q: QRef) -> Result<f64, EvalError> {
            Err(EvalError::Undefined(q))
        }
        fn text(&self, q: QRef) -> Result<Arc<str>, EvalError> {
            Err(EvalError::Undefined(q))
        }
    }
    expr::compile(&formula.expr, &OnlyParameters).ok()?.eval(&Nothing).ok()
}

/// The expression that is the value of a parameter or field.
fn value_of(dimension: &Dimension) -> Option<Formula> {
    if dimension.value.is_some() {
        return dimension.value.clone();
    }
    let text = match (&dimension.q, &dimension.field) {
        (Some(q), _) => q.to_string(),
        (None, Some(field)) => field.as_str().replace('-', "_"),
        (None, None) => return None,
    };
    let text = match (&dimension.plus, dimension.reduces) {
        (Some(datum), _) => format!("{text} + probe.{}", datum.as_str().replace('-', "_")),
        (None, Some(whole)) => format!("{whole} - {text}"),
        (None, None) => text,
    };
    let expr = parse(&text, Dialect::Spec).ok()?;
    Some(Formula { expr, text: text.into(), place: dimension.place.clone() })
}

/// What is noted at one moment, and which of the places asked for each value is.
struct Asked {
    watch: Watch,
    pass: usize,
    slots: Vec<usize>,
}

fn asked(moment: Option<&FigureMoment>, formulas: &[Option<Formula>]) -> Asked {
    let step = moment.and_then(|moment| moment.step.as_ref()).map(|step| Arc::clone(&step.text));
    let pass = moment.and_then(|moment| moment.pass).unwrap_or(1) as usize;
    let there = formulas.iter().enumerate().filter_map(|(slot, formula)| Some((slot, formula.clone()?)));
    let (slots, values) = there.unzip();
    Asked { watch: Watch { step, values }, pass, slots }
}

fn all_asked(figure: &Figure, dimensions: &[&Dimension]) -> Vec<Asked> {
    let at = figure.at.as_ref();
    let own: Vec<Option<Formula>> = own_places(figure).into_iter().map(|place| place.cloned()).collect();
    let mut all = vec![asked(at, &own)];
    all.extend(dimensions.iter().map(|dimension| {
        let formulas = [value_of(dimension), dimension.from.clone(), dimension.to.clone(), dimension.centre.clone()];
        asked(dimension.at.as_ref().or(at), &formulas)
    }));
    all
}

/// The note of what was asked: that of the pass, or the last one of the cycle.
fn noted<'n>(notes: &'n [Noted], index: usize, asked: &Asked) -> Option<&'n Noted> {
    notes.iter().filter(|note| note.watch == index).nth(asked.pass.saturating_sub(1))
}

/// The example with the values of the figure in place of its own, and `each` as it is chosen, in a program as well.
fn altered(cycle: &Cycle, example: &Example, figure: &Figure, chosen: Option<&str>) -> Example {
    let mut example = example.clone();
    let mut set = |name: &str, value: &Name| match example.given.0.iter_mut().find(|(own, _)| own.as_str() == name) {
        Some((_, own)) => *own = value.clone(),
        None => example.given.0.push((Name { text: name.into(), place: value.place.clone() }, value.clone())),
    };
    for (name, value) in &figure.given.0 {
        set(name.as_str(), value);
    }
    if let (Some(q), Some(value)) = (figure.each, chosen) {
        set(&q.to_string(), &Name { text: value.into(), place: figure.place.clone() });
    }
    if let Some(program) = &figure.program {
        let mut program = program.clone();
        if let (Some(q), Some(value)) = (figure.each, chosen) {
            program.text = with_choice(&program.text, cycle, &q.to_string(), value).into();
        }
        example.program = Some(program);
    }
    if let (Some(own), Some(scene)) = (&figure.scene, &mut example.scene) {
        replace(&mut scene.0, &own.0);
    }
    example
}

/// The program with another value of a parameter wherever it defines the cycle in one line.
fn with_choice(program: &str, cycle: &Cycle, q: &str, value: &str) -> String {
    let head = format!("{} {} ", cycle.key.keyword.as_str(), cycle.key.number);
    let parameter = format!("{q}=");
    let word = |word: &str| match word.starts_with(&parameter) {
        true => format!("{parameter}{value}"),
        false => word.to_owned(),
    };
    let line = |line: &str| match line.contains(&head) {
        true => line.split(' ').map(word).collect::<Vec<_>>().join(" "),
        false => line.to_owned(),
    };
    program.lines().map(|text| line(text) + "\n").collect()
}

/// Puts the entries of a mapping in place of those of another one.
fn replace(scene: &mut Node, own: &Node) {
    let (Kind::Map(entries), Kind::Map(own)) = (&mut scene.kind, &own.kind) else { return };
    entries.retain(|(key, _)| own.iter().all(|(other, _)| other.text != key.text));
    entries.extend(own.iter().cloned());
}

/// Runs the example of a figure up to its moment; `chosen` is the value of the parameter whose choices it shows.
///
/// # Errors
/// An example that does not exist or does not run, expressions that are wrong, a moment that never comes.
pub(super) fn take(
    world: &World<'_>,
    on: &OnControl,
    cycle: &Cycle,
    figure: &Figure,
    dimensions: &[&Dimension],
    chosen: Option<&str>,
) -> Result<Shot, Vec<Diagnostic>> {
    let wrong = |code: &'static str, place: &Place| {
        Diagnostic::error(code, place.clone()).arg("name", figure.name.as_str()).arg("cycle", cycle.key.to_string())
    };
    let Some(example) = on.cases_of(cycle).find(|example| example.name == figure.of) else {
        return Err(vec![wrong("figure-example-missing", &figure.of.place).arg("example", figure.of.as_str())]);
    };
    // What a cycle makes of the data that another one gives it is in the run of the former.
    let runner = figure.run_of.and_then(|number| on.cycles.get(&CycleKey::new(cycle.key.keyword, number)));
    let runner = runner.unwrap_or(cycle);
    let asked = all_asked(figure, dimensions);
    let watches: Vec<Watch> = asked.iter().map(|asked| asked.watch.clone()).collect();
    let watched = plan::Compiled::watched(runner, on, &watches);
    if !watched.mistakes.is_empty() {
        return Err(watched.mistakes);
    }
    let (program, called, scene) = conform::ready(world, on, cycle, &altered(cycle, example, figure, chosen))?;
    let program = syntax::parse(&program);
    let engine = Engine::new(&program, on, &scene, &NoTexts).with_catalogue(world.catalogue);
    let engine = engine.with_programs(&called).watching(runner.key, &watched);
    let mut events = Vec::new();
    let outcome = engine.run(&mut |event| events.push(event));
    let moment = asked.first().and_then(|own| noted(&outcome.noted, 0, own));
    // A whole program that executes the cycle nowhere is shown at its end.
    let without = moment.is_none() && figure.whole && outcome.status == Status::Done;
    let Some(seen) = moment.map(|moment| moment.events).or(without.then_some(events.len())) else {
        let reason = outcome.fault.as_ref().map_or_else(|| outcome.status.as_str().to_owned(), |f| f.code.to_string());
        return Err(vec![wrong("figure-moment-never", &figure.place).arg("reason", reason)]);
    };
    let mut film = Film::new(&scene, Some(runner), figure.whole);
    film.table = (figure.view == FigureView::Rotary).then(|| Table::new(&scene));
    let end = if figure.whole { events.len() } else { seen.min(events.len()) };
    let (before, after) = events.split_at(end);
    before.iter().for_each(|event| film.see(event));
    film.now = Some(film.strokes.len());
    let (tool, here, touched, system) = (film.tool, film.here, film.contacts.len(), film.system);
    let (turning, table) = (film.turning, film.table.clone());
    after.iter().for_each(|event| film.see(event));
    (film.tool, film.here, film.system) = (tool, here, system);
    (film.turning, film.table) = (turning, table);
    film.contacts.truncate(touched);
    let mut shot = film.end(&scene);
    if rotary::axis(figure.view).is_some() {
        shot.strokes = rotary::between_stations(std::mem::take(&mut shot.strokes));
    }
    if let Some(setter) = shot.setter.as_ref().filter(|_| figure.view != FigureView::Plan) {
        // From the side, what goes on before and behind the setter hides it.
        shot.strokes.retain(|stroke| setter.is_in_plane(stroke));
    }
    for (index, asked) in asked.iter().enumerate() {
        let mut values: [Option<Value>; 4] = Default::default();
        let note = noted(&outcome.noted, index, asked);
        if index == 0 {
            let constants = own_places(figure).into_iter().map(|own| own.filter(|_| without).and_then(constant));
            shot.own = constants.collect();
        }
        for (value, slot) in note.iter().flat_map(|note| &note.values).zip(&asked.slots) {
            match index {
                0 => shot.own[*slot] = value.clone(),
                _ => values[*slot] = value.clone(),
            }
        }
        if index > 0 {
            shot.places.push(values);
        }
    }
    if figure.view == FigureView::Turned {
        shot.turn(figure, &scene);
    }
    if let (FigureView::Rotary, Some(radius)) = (figure.view, number(&shot, RADIUS)) {
        shot.round = Some(Round::new(radius, number(&shot, CUT), [&shot.strokes, &shot.later]));
    }
    Ok(shot)
}

/// A point whose main coordinate is a diameter, by its radius.
fn by_radius(value: &mut Option<Value>) {
    if let Some(Value::Point(point)) = value {
        point.x /= 2.0;
    }
}

impl Shot {
    /// Makes radii of the diameters of places, and turns the blank.
    fn turn(&mut self, figure: &Figure, scene: &Scene) {
        self.own.iter_mut().for_each(by_radius);
        self.places.iter_mut().flat_map(|places| &mut places[1..]).for_each(by_radius);
        let half = |place: usize| point(self, place).map(|point| DVec2::new(point.z, point.x));
        let ([Some(least), Some(greatest)], Some((tool, _))) = (CORNERS.map(half), self.tool) else { return };
        let insert = figure.insert.as_ref();
        let stand = Stand {
            tip: half(TIP).unwrap_or(DVec2::NEG_ONE).map(|sign| if sign < 0.0 { -1.0 } else { 1.0 }),
            axial: insert.and_then(|insert| insert.plunges) == Some(Along::Tool),
            pitch: number(self, PITCH).filter(|pitch| *pitch > 0.0),
        };
        let column = |name: &str| scene.tools.number(tool.number, name).ok().flatten().filter(|number| *number > 0.0);
        let tool = Insert {
            radius: column("RS").unwrap_or_default(),
            length: column("LCUTS"),
            width: column("CUTWIDTH"),
            angles: column("T-ANGLE").zip(column("P-ANGLE")).map(<[f64; 2]>::from),
        };
        let corners = figure.blank.as_ref().map_or(0, |blank| blank.without.len());
        let lacks: Vec<DVec2> = (0..corners).filter_map(|n| half(MARKS + figure.marks.len() + n)).collect();
        self.turned = Some(HalfPlane::new(stand, tool, Blank { least, greatest, lacks }, [&self.strokes, &self.later]));
    }
}

/// The part of a run that is seen so far.
pub(super) struct Film<'f> {
    /// Whose run is filmed; without one, all of the program.
    cycle: Option<&'f Cycle>,
    /// From program to machine coordinates now.
    system: DAffine3,
    /// The same when the cycle began.
    first: Option<DAffine3>,
    plane: WorkingPlane,
    tool: Option<Tool>,
    turning: Turning,
    /// Of the rotary axes, in the program.
    angles: DVec3,
    /// What those of the machine are more.
    angle_datum: DVec3,
    /// In the machine, when the cycle began.
    first_angles: Option<DVec3>,
    /// The angles to which the axes turned since, and those at which the probe touched a point of the machine.
    turns: Vec<DVec3>,
    touches: Vec<(DVec3, DVec3)>,
    /// In machine coordinates.
    strokes: Vec<Stroke>,
    contacts: Vec<DVec3>,
    centres: Vec<DVec3>,
    here: Option<DVec3>,
    /// How many strokes there are at the moment.
    now: Option<usize>,
    /// The table, where it turns what the figure shows.
    table: Option<Table<'f>>,
}

fn affine(rows: [[f64; 4]; 3]) -> DAffine3 {
    let column = |n: usize| DVec3::new(rows[0][n], rows[1][n], rows[2][n]);
    DAffine3::from_mat3_translation(DMat3::from_cols(column(0), column(1), column(2)), column(3))
}

impl<'f> Film<'f> {
    fn new(scene: &Scene, cycle: Option<&'f Cycle>, whole: bool) -> Self {
        let system = affine(scene.frame.rows());
        Self {
            cycle,
            system,
            first: whole.then_some(system),
            plane: WorkingPlane::of_tool_axis(Axis::Z),
            tool: None,
            turning: Turning::default(),
            angles: scene.start_angles,
            angle_datum: DVec3::ZERO,
            first_angles: None,
            turns: Vec::new(),
            touches: Vec::new(),
            strokes: Vec::new(),
            contacts: Vec::new(),
            centres: Vec::new(),
            here: Some(scene.start),
            now: None,
            table: None,
        }
    }

    /// The film of a whole program, in the coordinates of a frame with that tool axis.
    pub(super) fn of_program(scene: &Scene, frame: &Frame, axis: Axis) -> Self {
        let first = Some(affine(frame.rows()));
        Self { first, plane: WorkingPlane::of_tool_axis(axis), ..Self::new(scene, None, true) }
    }

    /// The ways of a whole program and the points that it touched, as they lie in the frame.
    pub(super) fn developed(mut self, scene: &Scene, axis: Axis) -> (Vec<Stroke>, Vec<DVec3>) {
        // The working plane of the last tool is not always that of the drawing.
        self.plane = WorkingPlane::of_tool_axis(axis);
        let shot = self.end(scene);
        (shot.strokes, shot.contacts)
    }

    pub(super) fn see(&mut self, event: &Event) {
        let began = |key: &CycleKey| self.cycle.is_some_and(|cycle| cycle.key == *key);
        if self.first.is_none() && event.at.cycle.as_ref().is_some_and(|(key, _)| began(key)) {
            self.first = Some(self.system);
            self.first_angles = Some(self.angles + self.angle_datum);
        }
        match &event.kind {
            EventKind::Transform(system) => self.system = affine(system.matrix),
            EventKind::Spindle { tool, direction, orient, .. } => {
                if let Some((tool, axis)) = tool {
                    (self.tool, self.plane) = (Some(*tool), WorkingPlane::of_tool_axis(*axis));
                }
                (self.turning.direction, self.turning.angle) = (*direction, *orient);
            }
            EventKind::Move { kind, path, .. } => {
                if let MoveKind::Arc { centre, .. } = kind {
                    self.centres.push(self.system.transform_point3(*centre));
                }
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                self.go(if rapid { Way::Rapid } else { Way::Feed }, points(path));
            }
            EventKind::Turn { axes, rapid, .. } => {
                for turned in axes {
                    self.angles = turned.axis.with(self.angles, turned.to);
                    self.angle_datum = turned.axis.with(self.angle_datum, turned.machine - turned.to);
                }
                self.turns.push(self.angles);
                if let (Some(table), Some(here)) = (&mut self.table, self.here) {
                    let way = if *rapid { Way::Rapid } else { Way::Feed };
                    let poses = table.turn(axes, here);
                    self.add(way, poses);
                }
            }
            EventKind::Probe(probing) => {
                let ball = probing.contact.map_or(probing.target, |(_, ball)| ball);
                let ends = [probing.from, ball].map(|p| self.system.transform_point3(p));
                self.contacts.extend(probing.contact.map(|(point, _)| self.system.transform_point3(point)));
                let touched = probing.contact.map(|(point, _)| (self.angles, self.system.transform_point3(point)));
                self.touches.extend(touched);
                self.go(Way::Probe, ends.to_vec());
            }
            _ => {}
        }
    }

    fn go(&mut self, way: Way, points: Vec<DVec3>) {
        if way != Way::Probe {
            self.here = points.last().copied().or(self.here);
        }
        let up = vec![DVec3::Z; if self.table.is_some() { points.len() } else { 0 }];
        let poses = self.table.as_ref().map(|table| table.held(&points, &up));
        self.add(way, poses.unwrap_or((points, up)));
    }

    fn add(&mut self, way: Way, (points, up): (Vec<DVec3>, Vec<DVec3>)) {
        if let (None, Some(last)) = (self.cycle, self.strokes.last_mut())
            && way != Way::Probe
            && last.way == way
            && last.points.last() == points.first()
        {
            // All of a program is one line as long as nothing changes: programs are long.
            last.points.extend(points.into_iter().skip(1));
        } else if self.first.is_some() {
            self.strokes.push(Stroke {
                way,
                points,
                tool: self.tool.unwrap_or_default(),
                turning: self.turning,
                angles: self.angles,
                up,
            });
        }
    }

    fn end(self, scene: &Scene) -> Shot {
        let back = self.first.unwrap_or(self.system).inverse();
        let plane = self.plane;
        let own = |machine: DVec3| {
            let p = back.transform_point3(machine);
            plane.flat(p).extend(plane.tool.of(p))
        };
        let ball = self.tool.and_then(|tool| tool.probe).and(scene.probe.as_ref()).map(|probe| probe.ball_radius);
        // Moves are those of the tip; a probe is drawn by the centre of its ball, as it is when it touches.
        let ball_of = |tool: &Tool| tool.probe.and(scene.probe.as_ref()).map_or(0.0, |probe| probe.ball_radius);
        let first = |tool: &Tool| {
            let known = scene.true_tools.iter().find(|(number, _)| *number == tool.number);
            known.map_or(0.0, |(_, known)| known.first)
        };
        let placed = |mut stroke: Stroke| {
            stroke.turning.first = first(&stroke.tool);
            if let Some(table) = &self.table {
                (stroke.points, stroke.up) = table.lying(&stroke.points, &stroke.up);
                stroke.up = stroke.up.into_iter().map(|up| own(up) - own(DVec3::ZERO)).collect();
            }
            let lift = if stroke.way == Way::Probe { 0.0 } else { ball_of(&stroke.tool) };
            let points = stroke.points.into_iter().map(|p| own(p) + DVec3::Z * lift).collect();
            Stroke { points, ..stroke }
        };
        let rotary = self.first_angles.filter(|_| !self.turns.is_empty()).map(|angles| {
            let mut rotary = Rotary::new(&scene.machine, back, plane, angles, self.angle_datum);
            self.turns.iter().for_each(|angles| rotary.turned(*angles));
            self.touches.iter().for_each(|(angles, point)| rotary.touched(*angles, own(*point)));
            rotary
        });
        let datum = own(self.system.transform_point3(DVec3::ZERO));
        let axes = [(DVec2::X, 0.0), (DVec2::Y, 0.0), (DVec2::ZERO, 1.0)]
            .map(|(flat, height)| own(self.system.transform_point3(plane.lift(flat, height))) - datum)
            .map(DVec3::normalize_or_zero);
        let mut strokes: Vec<Stroke> = self.strokes.into_iter().map(placed).collect();
        let later = strokes.split_off(self.now.unwrap_or(strokes.len()).min(strokes.len()));
        Shot {
            strokes,
            later,
            contacts: self.contacts.into_iter().map(own).collect(),
            centres: self.centres.into_iter().map(own).collect(),
            tool: self.tool.zip(self.here).map(|(tool, here)| (tool, own(here) + DVec3::Z * ball_of(&tool))),
            datum: (datum.length() > 1e-9).then_some(datum),
            axes,
            turning: self.turning,
            rotary,
            setter: if ball.is_none() { Setter::of(scene, plane, &own) } else { None },
            ball,
            parts: scene.parts.clone(),
            body: scene.body.clone(),
            back,
            plane,
            round: None,
            turned: None,
            places: Vec::new(),
            own: Vec::new(),
        }
    }
}

/// The points of a way: arcs by chords that leave them by 0.04 mm at most.
fn points(path: &Path) -> Vec<DVec3> {
    let pieces = match path {
        Path::Line { .. } => 1,
        Path::Arc { centre, from, sweep, .. } => {
            let radius = (*from - *centre).length().max(0.04);
            let angle = 2.0 * libm::acos((1.0 - 0.04 / radius).max(0.5));
            ((sweep.to_radians().abs() / angle).ceil() as usize).clamp(4, 720)
        }
    };
    (0..=pieces).map(|n| path.at(n as f64 / pieces as f64)).collect()
}
