//! Solids as a scene writes them.
//!
//! Invariant: a solid that is read has an extent: boxes have volume, diameters are positive.
use crate::engine::geometry::{Axis, Frame, WorkingPlane};
use crate::engine::read::Reader;
use crate::engine::solid::{Shape, SolidError};
use crate::spec::{Kind, Node};
use glam::{DVec2, DVec3};

use super::stl::Models;

/// The kinds of solids.
const SOLIDS: &[&str] = &["box", "cylinder", "cone", "sphere", "half_space", "stl", "union", "difference"];
/// The kinds of stock.
const STOCKS: &[&str] = &["box", "cylinder", "cone", "difference"];

/// `{place: {shift, rotate}, solid: …}`
pub(super) fn part(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Shape> {
    reader.only_keys(node, &["place", "solid"]);
    let frame = node.get("place").map_or(Some(Frame::IDENTITY), |place| self::place(place, reader));
    let shape = reader.need(node, "solid").and_then(|node| solid(node, reader, models));
    Some(Shape::Placed { frame: frame?, shape: Box::new(shape?) })
}

/// `{shift: [x, y, z], rotate: [a, b, c]}`
fn place(node: &Node, reader: &mut Reader<'_>) -> Option<Frame> {
    reader.only_keys(node, &["shift", "rotate"]);
    let shift = node.get("shift").map_or(Some(DVec3::ZERO), |node| reader.vector(node));
    let rotate = node.get("rotate").map_or(Some(DVec3::ZERO), |node| reader.angles(node));
    Some(Frame::placed(shift?, rotate?))
}

/// One solid, or a placed one.
pub(super) fn solid(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Shape> {
    if node.get("solid").is_some() {
        return part(node, reader, models);
    }
    let (kind, body) = one_of(node, reader, SOLIDS)?;
    match kind {
        "box" => cuboid(body, reader),
        "cylinder" => cylinder(body, reader),
        "cone" => cone(body, reader),
        "sphere" => sphere(body, reader),
        "half_space" => half_space(body, reader),
        "stl" => models.shape(body, reader),
        "union" => solids(body, reader, models).map(Shape::Union),
        _ => difference(body, reader, models),
    }
}

/// The raw material: a box, a cylinder or a cone, or one of these without other solids.
pub(super) fn stock(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Shape> {
    let (kind, body) = one_of(node, reader, STOCKS)?;
    match kind {
        "box" => cuboid(body, reader),
        "cylinder" => cylinder(body, reader),
        "cone" => cone(body, reader),
        _ => {
            let items = reader.items(body);
            let first = items.first().and_then(|first| stock(first, reader, models));
            let others: Vec<Shape> = items.iter().skip(1).filter_map(|item| without(item, reader, models)).collect();
            if items.len() < 2 && matches!(body.kind, Kind::List(_)) {
                reader.expected(body, "solids");
                return None;
            }
            let whole = others.len() + 1 == items.len();
            first.filter(|_| whole).map(|first| Shape::Difference([vec![first], others].concat()))
        }
    }
}

/// A solid that the raw material lacks.
fn without(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Shape> {
    let shape = solid(node, reader, models)?;
    if shape.has_mesh() {
        reader.report(SolidError::CutMesh.code(), node, Vec::new());
        return None;
    }
    Some(shape)
}

/// The single key of a mapping and its value.
fn one_of<'n>(node: &'n Node, reader: &mut Reader<'_>, kinds: &[&'static str]) -> Option<(&'static str, &'n Node)> {
    let [(key, body)] = reader.entries(node) else {
        if matches!(node.kind, Kind::Map(_)) {
            reader.report("scene-one-solid", node, vec![("known", kinds.join(", ").into())]);
        }
        return None;
    };
    let kind = kinds.iter().find(|kind| **kind == &*key.text);
    if kind.is_none() {
        reader.unknown_key(key, kinds);
    }
    kind.map(|kind| (*kind, body))
}

/// Solids of which the first is left without the others: no triangulated surface is among them.
fn difference(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Shape> {
    let shapes = solids(node, reader, models)?;
    let cut = reader.items(node).iter().zip(&shapes).find(|(_, shape)| shape.has_mesh());
    if let Some((item, _)) = cut {
        reader.report(SolidError::CutMesh.code(), item, Vec::new());
        return None;
    }
    Some(Shape::Difference(shapes))
}

fn solids(node: &Node, reader: &mut Reader<'_>, models: &mut Models<'_>) -> Option<Vec<Shape>> {
    let items = reader.items(node);
    if items.is_empty() && matches!(node.kind, Kind::List(_)) {
        reader.expected(node, "solids");
        return None;
    }
    let shapes: Vec<Shape> = items.iter().filter_map(|item| solid(item, reader, models)).collect();
    (shapes.len() == items.len()).then_some(shapes)
}

fn cuboid(node: &Node, reader: &mut Reader<'_>) -> Option<Shape> {
    reader.only_keys(node, &["min", "max"]);
    let min = reader.need(node, "min").and_then(|node| reader.vector(node));
    let max = reader.need(node, "max").and_then(|node| reader.vector(node));
    let (min, max) = (min?, max?);
    if !min.cmplt(max).all() {
        reader.report("scene-min-max", node, Vec::new());
        return None;
    }
    Some(Shape::Box { min, max })
}

/// The ends of a round solid about a line along an axis.
fn ends(node: &Node, reader: &mut Reader<'_>) -> Option<(DVec3, DVec3)> {
    let axis = node.get("axis").map_or(Some(Axis::Z), |node| reader.axis(node));
    let centre = node.get("centre").map_or(Some(DVec2::ZERO), |node| flat(node, axis.unwrap_or(Axis::Z), reader));
    let from = reader.need(node, "from").and_then(|node| reader.length(node));
    let to = reader.need(node, "to").and_then(|node| reader.length(node));
    let (axis, centre, from, to) = (axis?, centre?, from?, to?);
    if from == to {
        reader.report("scene-no-length", node, Vec::new());
        return None;
    }
    let plane = WorkingPlane::of_tool_axis(axis);
    Some((plane.lift(centre, from), plane.lift(centre, to)))
}

/// Two lengths across an axis: a list in the order of the working plane, or a mapping by letter.
fn flat(node: &Node, axis: Axis, reader: &mut Reader<'_>) -> Option<DVec2> {
    let plane = WorkingPlane::of_tool_axis(axis);
    let [x, y] = match &node.kind {
        Kind::Map(_) => {
            let letters = [plane.main, plane.secondary].map(|axis| axis.letter().to_string());
            let letters: Vec<&str> = letters.iter().map(String::as_str).collect();
            reader.only_keys(node, &letters);
            [letters.first(), letters.last()].map(|letter| letter.and_then(|letter| node.get(letter)))
        }
        Kind::List(items) if items.len() == 2 => [items.first(), items.last()],
        _ => {
            reader.expected(node, "two-numbers");
            return None;
        }
    }
    .map(|node| node.map_or(Some(0.0), |node| reader.length(node)));
    Some(DVec2::new(x?, y?))
}

/// The radius, given as `diameter` or as `radius`.
fn radius(node: &Node, reader: &mut Reader<'_>) -> Option<f64> {
    if let Some(radius) = node.get("radius") {
        if let Some(diameter) = node.get("diameter") {
            reader.report("scene-repeated", diameter, vec![("found", "diameter".into())]);
        }
        return reader.positive(radius);
    }
    reader.need(node, "diameter").and_then(|node| reader.positive(node)).map(|diameter| diameter / 2.0)
}

fn cylinder(node: &Node, reader: &mut Reader<'_>) -> Option<Shape> {
    reader.only_keys(node, &["axis", "centre", "diameter", "radius", "from", "to"]);
    let radius = radius(node, reader);
    let (from, to) = ends(node, reader)?;
    Some(Shape::Cylinder { from, to, radius: radius? })
}

fn cone(node: &Node, reader: &mut Reader<'_>) -> Option<Shape> {
    reader.only_keys(node, &["axis", "centre", "diameter", "diameter_to", "from", "to"]);
    let start = reader.need(node, "diameter").and_then(|node| reader.length(node));
    let end = node.get("diameter_to").map_or(Some(0.0), |node| reader.length(node));
    let (from, to) = ends(node, reader)?;
    let (start, end) = (start?, end?);
    if start < 0.0 || end < 0.0 || start.max(end) <= 0.0 {
        reader.report("scene-not-positive", node, vec![("found", start.min(end).into())]);
        return None;
    }
    Some(Shape::Cone { from, to, radius_from: start / 2.0, radius_to: end / 2.0 })
}

fn sphere(node: &Node, reader: &mut Reader<'_>) -> Option<Shape> {
    reader.only_keys(node, &["centre", "diameter", "radius"]);
    let radius = radius(node, reader);
    let centre = node.get("centre").map_or(Some(DVec3::ZERO), |node| reader.vector(node));
    Some(Shape::Sphere { centre: centre?, radius: radius? })
}

fn half_space(node: &Node, reader: &mut Reader<'_>) -> Option<Shape> {
    reader.only_keys(node, &["point", "normal"]);
    let point = node.get("point").map_or(Some(DVec3::ZERO), |node| reader.vector(node));
    let field = reader.need(node, "normal")?;
    let normal = reader.vector(field)?;
    if normal == DVec3::ZERO {
        reader.report("scene-no-length", field, Vec::new());
        return None;
    }
    Some(Shape::HalfSpace { point: point?, normal })
}
