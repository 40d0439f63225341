//! The form of figures: what a drawing of a cycle shows, and between which places its parameters are measured.
//!
//! Invariant: plain data, as in [`super::form`]; places are expressions of the run.
use super::decode::{Entries, Formula, Name, record, words};
use super::form::Tree;
use crate::base::expr::QRef;

words! {
    /// From where a figure looks.
    pub enum FigureView {
        /// Cut along the main and the tool axis.
        Section = "section",
        /// Against the tool axis.
        Plan = "plan",
        /// Along the secondary axis, without a cut.
        Side = "side",
        /// Half of a turned part cut open: the rotary axis to the right, upwards the radius. Coordinates of the main
        /// axis are diameters, and what is measured along it is a length on the radius.
        Turned = "turned",
        /// Across the axis of a rotary table, cut open: the main axis to the right, the tool axis upwards.
        Rotary = "rotary",
        /// Against the main axis, about which a table turns with its axis A.
        RotaryA = "rotary-a",
        /// Along the secondary axis, about which a table turns with its axis B.
        RotaryB = "rotary-b",
        /// Against the tool axis, about which a table turns with its axis C.
        RotaryC = "rotary-c",
        /// In three dimensions: the workpiece below the tilted working plane, and the axes before and after.
        ThreeD = "three-d",
    }
}

words! {
    /// An axis of the working plane.
    pub enum Along {
        /// The main axis.
        Main = "main",
        /// The secondary axis.
        Minor = "minor",
        /// The tool axis.
        Tool = "tool",
    }
}

words! {
    /// How a dimension is drawn and measured.
    pub enum DimensionKind {
        /// The distance of two places, or how far a coordinate is from another one.
        Length = "length",
        /// The distance of two opposite places of a circle.
        Diameter = "diameter",
        /// The distance of a place from the centre of its circle.
        Radius = "radius",
        /// An angle from one direction to another about a centre, counter-clockwise positive.
        Angle = "angle",
        /// A turn of the rotary axis along which the view is seen, from one of its angles to another one; in three
        /// dimensions, by which the working plane is turned about the axis `along`.
        Turn = "turn",
    }
}

record! {
    /// A moment of a run: when a step has been executed for the n-th time, or the end of the cycle.
    pub struct FigureMoment {
        /// The step; the end of the cycle if there is none.
        step: Option<Name>,
        /// For which time it is executed, from 1.
        pass: Option<u32>,
    }
}

record! {
    /// A parameter with the two places that it lies between.
    pub struct Dimension {
        /// The parameter.
        q: Option<QRef>,
        /// The field of an old-style line.
        field: Option<Name>,
        /// What is called its value where another cycle runs with it.
        value: Option<Formula>,
        /// A datum of the touch probe that the control adds to the parameter, `set-up`: the two are shown as one.
        plus: Option<Name>,
        /// The parameter that it makes less, of an infeed that decreases: the two are shown as one.
        reduces: Option<QRef>,
        /// How it is measured; a length if nothing is said.
        kind: Option<DimensionKind>,
        /// The first place: a coordinate, a point, or a direction in degrees.
        from: Option<Formula>,
        /// The second place.
        to: Option<Formula>,
        /// The axis of coordinates; of points, the axis along which they are measured.
        along: Option<Along>,
        /// The centre of an angle.
        centre: Option<Formula>,
        /// Another moment than that of the figure.
        at: Option<FigureMoment>,
        /// The dimensions of a fragment instead; those whose parameters the cycle does not have are left out.
        r#use as "use": Option<Name>,
    }
}

record! {
    /// A numbered place.
    pub struct Mark {
        /// The place, a point.
        at: Formula,
        /// Its number.
        number: u32,
    }
}

record! {
    /// The workpiece before it is cut; what is not said follows from what is cut.
    pub struct FigureBlank {
        /// The coordinate of its surface.
        top: Option<Formula>,
        /// The coordinate of its lower face.
        bottom: Option<Formula>,
        /// Its least corner in the working plane, a point.
        least: Option<Formula>,
        /// Its greatest corner in the working plane, a point.
        greatest: Option<Formula>,
        /// Whether it is round from above.
        round: bool,
        /// The radius of one that is round about the datum, in a rotary figure.
        radius: Option<Formula>,
        /// The corners of what a turned one lacks beside that, a convex polygon, points: a step, a cone.
        without: Vec<Formula>,
    }
}

record! {
    /// How the insert of a turning tool stands.
    pub struct FigureInsert {
        /// The direction from the centre of its nose to its tip, a point: its signs along the main and the tool axis.
        tip: Formula,
        /// The axis along which it goes into the part, if it is one for recesses or threads; the main axis if nothing
        /// is said.
        plunges: Option<Along>,
        /// The pitch of the thread that it cuts.
        pitch: Option<Formula>,
    }
}

record! {
    /// A boring bar whose edge is on one side above its tip and cuts upwards, and the bore that it goes through.
    pub struct FigureBar {
        /// A point on the axis of the bore.
        at: Formula,
        /// The diameter of the bore.
        bore: Formula,
        /// The diameter of the bar.
        neck: Formula,
        /// The height of the edge above the tip.
        edge: Formula,
    }
}

record! {
    /// The range of a scan, drawn as an outline.
    pub struct FigureScan {
        /// Its least corner, a point.
        least: Formula,
        /// Its greatest corner, a point.
        greatest: Formula,
    }
}

record! {
    /// A figure of a cycle, drawn from a run of one of its examples.
    pub struct Figure {
        /// Its name, text `figure-<name>`.
        name: Name,
        /// From where it looks.
        view: FigureView,
        /// The example that is run.
        of: Name,
        /// Values of parameters that the figure needs otherwise than the example.
        given: Entries<Name>,
        /// A program in place of that of the example.
        program: Option<Name>,
        /// The cycle, of the same keyword, whose run is shown: what it makes of the values that this one gives it.
        run_of: Option<u32>,
        /// Whether the way of the whole program is drawn and not that of the cycle only.
        whole: bool,
        /// What of the scene it needs otherwise than the example: `parts`, `start`.
        scene: Option<Tree>,
        /// The parameter for each of whose choices a small figure is drawn.
        each: Option<QRef>,
        /// Those of its choices that are drawn; all if there are none.
        values: Vec<Name>,
        /// Whether it is one of a row of small figures that are declared one by one.
        small: bool,
        /// The moment that is drawn; the end of the cycle if nothing is said.
        at: Option<FigureMoment>,
        /// The coordinate along the secondary axis at which a section is cut; where the tool is if nothing is said.
        cut: Option<Formula>,
        /// The blank.
        blank: Option<FigureBlank>,
        /// The insert of a turned figure.
        insert: Option<FigureInsert>,
        /// The boring bar of a tool that cuts upwards.
        bar: Option<FigureBar>,
        /// The range that is scanned.
        scan: Option<FigureScan>,
        /// The parameters that it shows.
        dimensions: Vec<Dimension>,
        /// Numbered places.
        marks: Vec<Mark>,
    }
}

record! {
    /// A parameter that no figure can show.
    pub struct NotShown {
        /// The parameter.
        q: Option<QRef>,
        /// The field of an old-style line.
        field: Option<Name>,
        /// Why.
        why: String,
    }
}
