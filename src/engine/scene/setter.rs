//! The tool setter of a scene, and what is true of the tools that it touches.
//!
//! Invariant: what the control believes is in machine parameters, in the tool table and in its calibration; here is only
//! what is so.
use glam::{DVec2, DVec3};

use crate::engine::geometry::Frame;
use crate::engine::read::Reader;
use crate::spec::Node;

/// The upper end of a tool setter, as seen along the tool axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plate {
    /// A disc of that radius, mm.
    Disc(f64),
    /// A cube of that half length of its sides, mm, along main and minor axis.
    Cube(f64),
}

impl Plate {
    /// How far it reaches from its centre, mm.
    pub fn reach(self) -> f64 {
        match self {
            Self::Disc(radius) => radius,
            Self::Cube(half) => libm::hypot(half, half),
        }
    }

    /// The same with its side so far inwards, mm.
    #[must_use]
    pub fn smaller(self, by: f64) -> Self {
        match self {
            Self::Disc(radius) => Self::Disc(radius - by),
            Self::Cube(half) => Self::Cube(half - by),
        }
    }
}

/// A tool setter.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolSetter {
    /// The centre of its upper face in machine coordinates.
    pub at: DVec3,
    /// How it is mounted: its directions are those of the machine, turned about X, Y and Z by so many degrees.
    pub rotate: DVec3,
    /// The shape of that face.
    pub plate: Plate,
    /// How far a tool pushes it in before it triggers, mm.
    pub pre_travel: f64,
    /// By how much each trigger comes later than it should, mm, in turn.
    pub scatter: Vec<f64>,
}

impl ToolSetter {
    /// The frame from the directions in which it is mounted to the machine.
    pub fn mounted(&self) -> Frame {
        if self.rotate == DVec3::ZERO { Frame::IDENTITY } else { Frame::placed(DVec3::ZERO, self.rotate) }
    }
}

/// A cutting edge as it really is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// From the spindle to its lowest point, mm.
    pub length: f64,
    /// From the spindle axis to its outermost point, mm.
    pub radius: f64,
}

/// A tool as it really is, where that is not what the tool table says at the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrueTool {
    /// Its edges, evenly around the axis, counter-clockwise as seen from the spindle.
    pub edges: Vec<Edge>,
    /// Where the first of them is from the main axis while the spindle is at 0, degrees.
    pub first: f64,
    /// How far its centre is from the spindle axis while the spindle is at 0, main and minor axis, mm.
    pub misaligned: DVec2,
}

/// The keys of a tool that are no columns of the table.
pub(super) const OWN: [&str; 4] = ["neck", "edges", "first_edge", "misaligned"];

pub(super) fn setter(node: &Node, r: &mut Reader<'_>) -> Option<ToolSetter> {
    r.only_keys(node, &["at", "rotate", "diameter", "cube", "pre_travel", "scatter"]);
    let at = r.need(node, "at").and_then(|node| match r.items(node) {
        [x, y, z] => Some(DVec3::new(r.length(x)?, r.length(y)?, r.length(z)?)),
        _ => {
            r.expected(node, "three-numbers");
            None
        }
    });
    let plate = match (node.get("diameter"), node.get("cube")) {
        (None, Some(side)) => r.positive(side).map(|side| Plate::Cube(side / 2.0)),
        (_, None) => r.need(node, "diameter").and_then(|node| r.positive(node)).map(|wide| Plate::Disc(wide / 2.0)),
        // One of them is too many.
        (Some(_), Some(_)) => {
            r.only_keys(node, &["at", "rotate", "diameter", "pre_travel", "scatter"]);
            None
        }
    };
    let rotate = node.get("rotate").map_or(Some(DVec3::ZERO), |node| r.angles(node));
    let pre_travel = node.get("pre_travel").map_or(Some(0.0), |node| r.length(node));
    let list = node.get("scatter").map_or(&[][..], |node| r.items(node));
    let scatter: Option<Vec<f64>> = list.iter().map(|item| r.length(item)).collect();
    Some(ToolSetter { at: at?, rotate: rotate?, plate: plate?, pre_travel: pre_travel?, scatter: scatter? })
}

/// What a row of the tools says of the tool as it is; nothing if it says nothing.
pub(super) fn true_tool(row: &Node, r: &mut Reader<'_>) -> Option<TrueTool> {
    let mut tool = TrueTool::default();
    let mut said = false;
    if let Some(list) = row.get("edges") {
        said = true;
        for edge in r.items(list) {
            r.only_keys(edge, &["length", "radius"]);
            let length = r.need(edge, "length").and_then(|node| r.positive(node));
            let radius = r.need(edge, "radius").and_then(|node| r.positive(node));
            tool.edges.push(Edge { length: length?, radius: radius? });
        }
    }
    if let Some(node) = row.get("first_edge") {
        said = true;
        tool.first = r.number(node)?;
    }
    if let Some(node) = row.get("misaligned") {
        said = true;
        tool.misaligned = match r.items(node) {
            [main, minor] => DVec2::new(r.length(main)?, r.length(minor)?),
            _ => {
                r.expected(node, "two-numbers");
                return None;
            }
        };
    }
    said.then_some(tool)
}
